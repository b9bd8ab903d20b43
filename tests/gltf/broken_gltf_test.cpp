#include <functional>
#include <random>

#include <catch2/catch.hpp>

#include "gltf/gltf_maker.h"
#include "gltf/gltf_reader.h"

// Files that are not what they should be: each gives a sentence, none a crash.

namespace dimline {
namespace {

using nlohmann::json;

const GltfFileResolver kNoFiles = [](std::string_view) -> Result<std::vector<std::byte>> {
  return Error{"there is no such file."};
};

std::string errorOf(std::span<const std::byte> bytes) {
  auto model = readGltf("a.glb", bytes, kNoFiles);
  return model.ok() ? "(no error)" : model.error().message;
}

/// A box under two nodes, textured: something of everything.
GltfMaker wholeFile() {
  GltfMaker maker;
  maker.root["images"] =
      json::array({{{"uri",
                     "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR42mP4z8DAAMIM/4E"
                     "AAB/uBfvxq7p3AAAAAElFTkSuQmCC"}}});
  maker.root["textures"] = json::array({{{"source", 0}}});
  maker.root["materials"] = json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  const int box = maker.box({1, 2, 3}, {{"material", 0}});
  const int child = maker.child({{"mesh", box}, {"scale", {1, 2, 1}}, {"rotation", {0, 0, 0, 1}}});
  maker.node({{"children", {child}}, {"name", "Crate"}, {"translation", {1, 2, 3}}, {"extras", {{"a", {1, 2, {3}}}}}});
  return maker;
}

std::string errorAfter(const std::function<void(json&)>& damage) {
  GltfMaker maker = wholeFile();
  damage(maker.root);
  return errorOf(maker.glb());
}

TEST_CASE("the file that the others are made from is good") { CHECK(errorOf(wholeFile().glb()) == "(no error)"); }

TEST_CASE("references to what does not exist") {
  CHECK(errorAfter([](json& r) { r["nodes"][0]["mesh"] = 99; }) ==
        "a.glb: node 0 shows mesh 99, which does not exist.");
  CHECK(errorAfter([](json& r) { r["nodes"][1]["children"][0] = 12; }) ==
        "a.glb: node 1 has a child that does not exist.");
  CHECK(errorAfter([](json& r) { r["nodes"][1]["children"][0] = -2; }) ==
        "a.glb: node 1 has a child that does not exist.");
  CHECK(errorAfter([](json& r) { r["scenes"][0]["nodes"][0] = 5; }) ==
        "a.glb: the scene shows node 5, which does not exist.");
  CHECK(errorAfter([](json& r) { r["scene"] = 3; }) == "a.glb: scene 3 is to be shown but does not exist.");
  CHECK(errorAfter([](json& r) { r["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 44; }) ==
        "a.glb: in mesh 0, accessor 44 is used but does not exist.");
  CHECK(errorAfter([](json& r) { r["meshes"][0]["primitives"][0]["material"] = 4; }) ==
        "a.glb: in mesh 0, material 4 is used but does not exist.");
  CHECK(errorAfter([](json& r) {
          r["meshes"][0]["primitives"][0]["indices"] = 44;
        }).find("a.glb: the file is damaged: ") == 0);
  CHECK(errorAfter([](json& r) { r["accessors"][0]["bufferView"] = 17; }) ==
        "a.glb: in mesh 0, accessor 0 reads a buffer view that does not exist.");
  CHECK(errorAfter([](json& r) { r["bufferViews"][0]["buffer"] = 1; }) ==
        "a.glb: buffer view 0 belongs to a buffer that does not exist.");
}

TEST_CASE("ranges that reach past their end") {
  CHECK(errorAfter([](json& r) { r["bufferViews"][2]["byteLength"] = 100000; }) ==
        "a.glb: buffer view 2 reaches past the end of its buffer.");
  CHECK(errorAfter([](json& r) { r["bufferViews"][1]["byteOffset"] = 4294967295; }) ==
        "a.glb: buffer view 1 reaches past the end of its buffer.");
  CHECK(errorAfter([](json& r) { r["bufferViews"][1]["byteOffset"] = -1; }) ==
        "a.glb: buffer view 1 reaches past the end of its buffer.");
  CHECK(errorAfter([](json& r) { r["accessors"][0]["count"] = 25; }) ==
        "a.glb: in mesh 0, accessor 0 reads past the end of buffer view 0.");
  CHECK(errorAfter([](json& r) { r["accessors"][0]["byteOffset"] = 4; }) ==
        "a.glb: in mesh 0, accessor 0 reads past the end of buffer view 0.");
  CHECK(errorAfter([](json& r) { r["accessors"][0]["count"] = 2000000000; }) ==
        "a.glb: in mesh 0, accessor 0 has more elements than could be shown.");
  CHECK(errorAfter([](json& r) { r["accessors"][0]["count"] = 18446744073709551615U; }) ==
        "a.glb: accessor 0 has a count or an offset that makes no sense.");
  CHECK(errorAfter([](json& r) { r["bufferViews"][0]["byteStride"] = 8; }) ==
        "a.glb: in mesh 0, accessor 0 has elements that overlap each other (byteStride).");
  CHECK(errorAfter([](json& r) { r["accessors"][1]["count"] = 23; }) ==
        "a.glb: in mesh 0, there are not as many normals as positions.");
  CHECK(errorAfter([](json& r) { r["accessors"][0]["count"] = r["accessors"][1]["count"] = 20; }) ==
        "a.glb: in mesh 0, vertex 20 is used, but there are only 20.");
  // An image's view is handed to a decoder as it stands.
  CHECK(errorAfter([](json& r) {
          r["images"][0] = {{"bufferView", 3}, {"mimeType", "image/png"}};
          r["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 1U << 30U}, {"byteLength", 100}});
        }) == "a.glb: buffer view 3 reaches past the end of its buffer.");
}

TEST_CASE("things of another kind than they should be") {
  CHECK(errorAfter([](json& r) { r["accessors"][0]["type"] = "VEC2"; }) ==
        "a.glb: in mesh 0, accessor 0 should hold 3 numbers an element, but holds something else.");
  CHECK(errorAfter([](json& r) { r["accessors"][2]["componentType"] = 5126; }) ==
        "a.glb: in mesh 0, accessor 2 should hold vertex indices, but holds something else.");
  CHECK(errorAfter([](json& r) { r["nodes"] = "many"; }) ==
        "a.glb: the file is damaged: its nodes are no list of objects.");
  CHECK(errorAfter([](json& r) { r["meshes"][0] = 3; }) ==
        "a.glb: the file is damaged: its meshes are no list of objects.");
  CHECK(errorAfter([](json& r) {
          r["nodes"][1]["rotation"] = {0, 0, 0, 0};
          r["nodes"][1].erase("matrix");
        }) == "a.glb: node 1 has a rotation that is no quaternion.");
  CHECK(errorAfter([](json& r) { r["nodes"][1]["scale"] = {1, 1}; }) ==
        "a.glb: node 1 has a translation, rotation or scale with too few or too many numbers.");
  CHECK(errorAfter([](json& r) { r["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}; }) ==
        "a.glb: node 1 has a matrix whose last row is not 0, 0, 0, 1.");
  CHECK(errorAfter([](json& r) { r["nodes"][1]["matrix"] = {1, 2, 3}; }) ==
        "a.glb: node 1 has a matrix that has not 16 numbers.");
}

TEST_CASE("trees that are none") {
  CHECK(errorAfter([](json& r) { r["nodes"][0]["children"] = {1}; }).find("is a part of itself.") != std::string::npos);
  CHECK(errorAfter([](json& r) { r["nodes"][0]["children"] = {0}; }) == "a.glb: node 0 has two parents.");
  CHECK(errorAfter([](json& r) { r["nodes"].push_back({{"children", {0}}}); }) == "a.glb: node 0 has two parents.");
}

TEST_CASE("a chain of nodes as long as anyone likes is a tree") {
  GltfMaker maker;
  int below = maker.child({{"mesh", maker.box({1, 1, 1})}});
  for (int i = 0; i < 20000; ++i) below = maker.child({{"children", {below}}});
  maker.root["scenes"][0]["nodes"] = {below};
  CHECK(errorOf(maker.glb()) == "(no error)");
}

TEST_CASE("numbers that no model has") {
  CHECK(errorAfter([](json& r) { r["nodes"][1]["translation"] = {1e12, 0, 0}; }) ==
        "a.glb: the model reaches farther than 100,000 km from its origin; scale it down.");
  CHECK(errorAfter([](json& r) {
          r["nodes"][1]["translation"] = {1e300, 0, 0};
          r["nodes"][0]["scale"] = {1e300, 1, 1};
        }) == "a.glb: the model reaches farther than 100,000 km from its origin; scale it down.");
  CHECK(errorAfter([](json& r) { r["nodes"][0]["scale"] = {1e-7, 1e-7, 1e-7}; }) ==
        "a.glb: the model is less than a hundredth of a millimetre large, too small to be measured; lengths in glTF are in metres, so scale it up.");
  GltfMaker maker = wholeFile();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(maker.bin.data() + 16, &nan, sizeof nan);
  CHECK(errorOf(maker.glb()) == "a.glb: in mesh 0, accessor 0 holds a number that is not finite.");
}

TEST_CASE("a count without data claims no memory") {
  CHECK(errorAfter([](json& r) {
          r["accessors"][0].erase("bufferView");
          r["accessors"][0]["count"] = 99'999'999;
        }) == "a.glb: in mesh 0, accessor 0 has more elements than could be shown.");
}

TEST_CASE("a message quotes no whole buffer") {
  const std::string error = errorAfter([](json& r) {
    r["buffers"].push_back({{"byteLength", 7}, {"uri", "data:application/octet-stream;base64," + std::string(100'000, 'A')}});
  });
  CHECK(error.starts_with("a.glb: "));
  CHECK(error.size() < 400);
}

TEST_CASE("what is left out many times is told once") {
  GltfMaker maker = wholeFile();
  json& primitives = maker.root["meshes"][0]["primitives"];
  json points = primitives[0];
  points["mode"] = 0;
  for (int i = 0; i < 100; ++i) primitives.push_back(points);
  const auto scene = importGltf("a.glb", maker.glb(), {});
  REQUIRE(scene);
  CHECK(scene->diagnostics == std::vector<std::string>{"Mesh 0 has points or lines, which are left out."});
}

TEST_CASE("files that show nothing") {
  const std::string nothing = "a.glb: the file shows no triangles, so there is nothing to dimension.";
  CHECK(errorOf(GltfMaker().glb()) == nothing);
  CHECK(errorAfter([](json& r) { r["scenes"][0]["nodes"] = json::array(); }) == nothing);
  CHECK(errorAfter([](json& r) { r["nodes"][1]["scale"] = {0, 0, 0}; }) == nothing);
  CHECK(errorAfter([](json& r) { r["meshes"][0]["primitives"][0]["mode"] = 1; }) == nothing + " Mesh 0 has points or lines, which are left out.");
  CHECK(errorAfter([](json& r) { r["meshes"][0]["primitives"][0].erase("attributes"); }) == nothing);
}

TEST_CASE("what the file needs is told when it is not there") {
  CHECK(errorAfter([](json& r) { r["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }) ==
        "a.glb: the file needs the extension \"KHR_draco_mesh_compression\", which is not supported; export it without "
        "compression.");
  CHECK(errorAfter([](json& r) { r["extensionsRequired"] = {"ACME_glow"}; }) ==
        "a.glb: the file needs the extension \"ACME_glow\", which is not supported; export it without it.");
  CHECK(errorAfter([](json& r) { r["extensionsRequired"] = {"KHR_texture_transform"}; }) == "(no error)");
  CHECK(errorAfter([](json& r) { r["asset"]["version"] = "1.0"; }) ==
        "a.glb: this is glTF of version \"1.0\"; only version 2 is read.");
  CHECK(errorAfter([](json& r) { r.erase("asset"); }) ==
        "a.glb: this is no glTF: it does not say which version it is (asset.version).");
}

TEST_CASE("containers that are cut off or no containers") {
  const std::vector<std::byte> good = wholeFile().glb();
  const auto cut = [&](std::size_t size) { return errorOf(std::span(good).first(size)); };
  CHECK(cut(0) == "a.glb: the file is empty.");
  CHECK(cut(3) == "a.glb: this is no glTF: it is neither a .glb nor a .gltf's JSON, or it is cut off.");
  CHECK(cut(12) == "a.glb: the file ends within its header.");
  CHECK(cut(100) == "a.glb: the file is cut off: it says that it has " + std::to_string(good.size()) +
                        " bytes, but there are 100.");

  const auto with = [&](std::size_t at, unsigned value) {
    std::vector<std::byte> bytes = good;
    for (unsigned i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>((value >> (8 * i)) & 0xFFU);
    return errorOf(bytes);
  };
  CHECK(with(4, 1) == "a.glb: this is binary glTF of version 1; only version 2 is read.");
  CHECK(with(12, 0xFFFFFFFF) == "a.glb: the file is damaged: its first part is not the JSON that it should be.");
  CHECK(with(16, 0) == "a.glb: the file is damaged: its first part is not the JSON that it should be.");
  const auto jsonLength =
      static_cast<std::size_t>(static_cast<unsigned>(good[12]) | (static_cast<unsigned>(good[13]) << 8U));
  const auto dataLength = static_cast<unsigned>(good.size() - 28 - jsonLength);
  // One word more than there is: a reader that forgets the chunk's own header goes past the end.
  CHECK(with(20 + jsonLength, dataLength + 4) ==
        "a.glb: the file is damaged: its second part is not the binary data that it should be.");
  CHECK(with(20 + jsonLength, 4).find("a.glb: buffer 0 should have ") == 0);
  CHECK(with(24 + jsonLength, 7) ==
        "a.glb: the file is damaged: its second part is not the binary data that it should be.");

  std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
  for (int i = 0; i < 100000; ++i) deep += '[';
  for (int i = 0; i < 100000; ++i) deep += ']';
  deep += '}';
  CHECK(errorOf(std::as_bytes(std::span(deep))) == "a.glb: the JSON is nested more than 64 deep, which no glTF is.");

  CHECK(errorAfter([](json& r) { r["buffers"][0]["byteLength"] = 0; }) ==
        "a.glb: buffer 0 does not say how many bytes it has (byteLength), or says nonsense.");
  CHECK(errorAfter([](json& r) { r["buffers"][0] = {{"byteLength", 8}, {"uri", "data:;base64,AAAA"}}; }) ==
        "a.glb: buffer 0 is spelled out in a way that is not understood; use data:application/octet-stream;base64.");
}

/// Whether reading ends in a model that builds, or in an error that says something.
bool endsWell(std::span<const std::byte> bytes, int& values) {
  auto model = readGltf("a.glb", bytes, kNoFiles);
  if (!model.ok()) {
    const std::string& message = model.error().message;
    return message.starts_with("a.glb: ") && message.ends_with('.') && message.size() > 15;
  }
  ++values;
  Values stretched(model->parameters());
  for (std::size_t i = 0; i < stretched.size(); ++i) stretched.set(i, model->parameters()[i].max);
  const Scene scene = model->definition.build(stretched);
  return !scene.bounds.empty() && std::isfinite(scene.bounds.diagonal());
}

TEST_CASE("random damage to the JSON gives a model or an error") {
  const json flat = wholeFile().root.flatten();
  std::vector<std::string> paths;
  for (const auto& entry : flat.items()) paths.push_back(entry.key());
  const json replacements[] = {
      0,   1,       -1,   3,     99, 2147483647,    4294967296,     -5000000000, 0.5,        1e300,  "",
      "x", nullptr, true, false, {}, json::array(), json::object(), {1, 2, 3},   {{"a", 1}}, "VEC4", 5121};
  std::mt19937 random(325035);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int values = 0;
  constexpr int kRounds = 4000;
  for (int round = 0; round < kRounds; ++round) {
    GltfMaker maker = wholeFile();
    std::string done;
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
      const json::json_pointer path(paths[below(paths.size())]);
      const json& replacement = replacements[below(std::size(replacements))];
      if (!maker.root.contains(path)) continue;  // an earlier edit has replaced what it leads through
      done += path.to_string() + " = " + replacement.dump() + "; ";
      maker.root[path] = replacement;
    }
    INFO(done);
    if (!endsWell(maker.glb(), values)) FAIL("neither a model nor a readable error");
  }
  CHECK(values > kRounds / 20);
  CHECK(values < kRounds);
}

TEST_CASE("random damage to the bytes gives a model or an error") {
  const std::vector<std::byte> good = wholeFile().glb();
  std::mt19937 random(10325035);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int values = 0;
  constexpr int kRounds = 4000;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::byte> bytes = good;
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
      // A quarter of the damage goes to the headers.
      const std::size_t place = below(4) == 0 ? below(40) : below(bytes.size());
      bytes[std::min(place, bytes.size() - 1)] = static_cast<std::byte>(below(256));
    }
    if (below(8) == 0) bytes.resize(1 + below(bytes.size()));
    INFO(round);
    if (!endsWell(bytes, values)) FAIL("neither a model nor a readable error");
  }
  CHECK(values > kRounds / 20);
  CHECK(values < kRounds);
}

}  // namespace
}  // namespace dimline
