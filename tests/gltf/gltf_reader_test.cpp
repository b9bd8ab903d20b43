#include "gltf/gltf_reader.h"

#include <cmath>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include "gltf/gltf_maker.h"

namespace dimline {
namespace {

using nlohmann::json;

const GltfFileResolver kNoFiles = [](std::string_view uri) -> Result<std::vector<std::byte>> {
  return Error{"there is no file \"" + std::string(uri) + "\"."};
};

Model readOrFail(std::span<const std::byte> bytes, const GltfFileResolver& resolve = kNoFiles) {
  auto model = readGltf("folder/test_box.glb", bytes, resolve);
  if (!model.ok()) FAIL(model.error().message);
  return std::move(model).value();
}

std::string errorOf(std::span<const std::byte> bytes, const GltfFileResolver& resolve = kNoFiles) {
  auto model = readGltf("a.glb", bytes, resolve);
  return model.ok() ? "(no error)" : model.error().message;
}

Scene sceneOf(const Model& model) { return model.definition.build(Values(model.parameters())); }

/// Six times the volume is the sum of det(a, b, c) over triangles that are counter-clockwise seen from outside: it is negative when the
/// surface is inside out.
double volumeOf(const Scene& scene) {
  double sum = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const auto& t : mesh.triangles) {
      Vec3 p[3];
      for (int c = 0; c < 3; ++c)
        p[c] = Vec3(instance.transform * glm::vec4(mesh.positions[t[static_cast<std::size_t>(c)]], 1.0F));
      sum += glm::dot(p[0], glm::cross(p[1], p[2]));
    }
  }
  return sum / 6;
}

/// Whether each corner's normal, carried into the world, is of unit length and on its face's outer side.
bool normalsFaceOut(const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.normals.size() != mesh.triangles.size() || mesh.materials.size() != mesh.triangles.size()) return false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      const glm::vec3 face =
          glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
      for (const glm::vec3& n : mesh.normals[i]) {
        if (std::abs(glm::length(n) - 1) > 1e-5F || glm::dot(n, face) <= 0) return false;
      }
    }
  }
  return true;
}

bool near(const Vec3& a, const Vec3& b, double tolerance = 1e-5) { return glm::length(a - b) <= tolerance; }

TEST_CASE("a box comes in with shared corners, its size as parameters") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({2, 3, 0.8371F})}, {"name", "Crate"}, {"translation", {10, 0, -5}}});
  const Model model = readOrFail(maker.glb());
  CHECK(model.diagnostics.empty());
  CHECK(model.definition.name == "test_box");
  CHECK(model.definition.title == "test box");

  const Scene scene = sceneOf(model);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].positions.size() == 8);
  CHECK(scene.triangleCount() == 12);
  CHECK(near(scene.bounds.min, {10, 0, -5}));
  CHECK(near(scene.bounds.max, {12, 3, -4.1629}));
  CHECK(normalsFaceOut(scene));
  CHECK(volumeOf(scene) == Approx(2 * 3 * 0.8371));

  REQUIRE(model.parameters().size() == 3);
  const char* names[] = {"Width", "Height", "Depth"};
  const Orient orients[] = {Orient::kRight, Orient::kUp, Orient::kFront};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(model.parameters()[i].name == names[i]);
    REQUIRE(model.annotations[i].has_value());
    CHECK(model.annotations[i]->scope == "Model");
    CHECK(model.annotations[i]->orient == orients[i]);
    CHECK(model.annotations[i]->type == HandleType::kLinearContour);
    CHECK(model.annotations[i]->slip == Slip::kScope);
  }
  const Parameter& width = model.parameters()[0];
  CHECK(width.defaultValue == 2);
  CHECK(width.min == 0.5);
  CHECK(width.max == 8);
  CHECK(width.step == 0.01);
  CHECK(model.parameters()[1].step == 0.02);  // 3 / 200 = 0.015: nearer to 0.02 than to 0.01 by ratio
  const Parameter& depth = model.parameters()[2];
  CHECK(depth.defaultValue == 0.8371);
  CHECK(depth.step == 0.005);
  CHECK(depth.min == 0.21);
  CHECK(depth.max == 3.35);
  CHECK(snapValue(depth, 1.0011) == 1.0);  // whole steps

  REQUIRE(scene.scopes.size() == 2);
  CHECK(scene.scopes[0].name == "Model");
  CHECK(scene.scopes[0].box.size == scene.bounds.size());
  CHECK(scene.scopes[1].name == "Crate");
  CHECK(near(scene.scopes[1].box.origin, {10, 0, -5}));
  CHECK(near(scene.scopes[1].box.size, {2, 3, 0.8371}));
}

TEST_CASE("a parameter stretches the whole along its axis, away from the lower corner") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({2, 3, 1})}, {"translation", {10, 1, -5}}});
  maker.node({{"mesh", 0}, {"translation", {13, 1, -5}}});
  const Model model = readOrFail(maker.glb());
  Values values(model.parameters());
  CHECK(values.at(0) == 5);
  values.set(0, 7.5);
  values.set(1, 1.5);
  const Scene scene = model.definition.build(values);
  CHECK(near(scene.bounds.min, {10, 1, -5}));
  CHECK(near(scene.bounds.max, {17.5, 2.5, -4}));
  CHECK(volumeOf(scene) == Approx(12 * 1.5 * 0.5));
  CHECK(scene.meshes.size() == 1);  // shared by both
}

TEST_CASE("the same values give the same scene, bit for bit") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({2, 3, 1})}, {"rotation", {0, 0.38268343, 0, 0.92387953}}});
  const Model model = readOrFail(maker.glb());
  Values values(model.parameters());
  values.set(0, 5.5);
  const Scene a = model.definition.build(values), b = model.definition.build(values);
  REQUIRE(a.meshes.size() == b.meshes.size());
  CHECK(a.meshes[0].positions == b.meshes[0].positions);
  CHECK(a.bounds.max == b.bounds.max);
}

TEST_CASE("transforms reach through the tree: matrix, rotation, scale and mirror") {
  GltfMaker maker;
  const int box = maker.box({1, 1, 1});
  const int inner = maker.child({{"mesh", box}, {"name", "Inner"}, {"translation", {1, 0, 0}}});
  // A quarter turn about y takes x to -z and z to x; then all is doubled along z and moved up by 5.
  const int middle = maker.child({{"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}, {"children", {inner}}});
  maker.node({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 5, 0, 1}}, {"children", {middle}}, {"name", "Outer"}});
  const Scene scene = sceneOf(readOrFail(maker.glb()));
  // The box spans x 1..2 in its parent, so z -2..-1 after the turn and -4..-2 after the scale; its z 0..1 becomes x 0..1.
  CHECK(near(scene.bounds.min, {0, 5, -4}));
  CHECK(near(scene.bounds.max, {1, 6, -2}));
  CHECK(volumeOf(scene) == Approx(2));

  REQUIRE(scene.scopes.size() == 3);
  CHECK(scene.scopes[1].name == "Outer");  // parents first
  CHECK(near(scene.scopes[1].box.size, {1, 1, 2}));
  CHECK(scene.scopes[2].name == "Inner");
  CHECK(near(scene.scopes[2].box.axes[0], {0, 0, -1}));
  CHECK(near(scene.scopes[2].box.axes[2], {1, 0, 0}));
  CHECK(near(scene.scopes[2].box.origin, {0, 5, -2}));
  CHECK(near(scene.scopes[2].box.size, {2, 1, 1}));
}

TEST_CASE("a matrix may miss its last row by what single precision leaves, and no more") {
  const auto error = [](double last) {
    GltfMaker maker;
    maker.node({{"mesh", maker.box({1, 1, 1})}, {"matrix", {1, 0, 0, 1e-17, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, last}}});
    const auto model = readGltf("a.glb", maker.glb(), [](std::string_view) -> Result<std::vector<std::byte>> { return Error{"none"}; });
    return model.ok() ? std::string() : model.error().message;
  };
  CHECK(error(0.99999994).empty());
  CHECK(error(0.999) == "a.glb: node 0 has a matrix whose last row is not 0, 0, 0, 1.");
}

TEST_CASE("a mirrored node keeps its outside outside") {
  for (const auto& scale : {json{-1, 1, 1}, json{1, -2, 1}, json{-1, -1, -1}, json{-1, -1, 1}}) {
    INFO(scale.dump());
    GltfMaker maker;
    const int box = maker.box({1, 2, 3});
    maker.node({{"mesh", box}, {"name", "Mirrored"}, {"scale", scale}, {"translation", {4, 4, 4}}});
    const Scene scene = sceneOf(readOrFail(maker.glb()));
    const double factor = std::abs(scale[0].get<double>() * scale[1].get<double>() * scale[2].get<double>());
    CHECK(volumeOf(scene) == Approx(6 * factor));
    CHECK(normalsFaceOut(scene));
    for (const Instance& instance : scene.instances) CHECK(glm::determinant(glm::mat3(instance.transform)) > 0);
    for (const Scope& scope : scene.scopes) {
      const auto& axes = scope.box.axes;
      CHECK(glm::dot(glm::cross(axes[0], axes[1]), axes[2]) == Approx(1));
    }
    CHECK(near(scene.scopes[1].box.size, glm::abs(Vec3(scale[0], scale[1], scale[2])) * Vec3(1, 2, 3)));
  }
}

TEST_CASE("a turned node in a stretched whole is sheared, and still right") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({1, 1, 1})}, {"name", "Turned"}, {"rotation", {0, std::sin(0.4), 0, std::cos(0.4)}}});
  const Model model = readOrFail(maker.glb());
  const double volume = volumeOf(sceneOf(model));
  CHECK(volume == Approx(1));
  Values values(model.parameters());
  values.set(0, values.at(0) * 2);
  const Scene scene = model.definition.build(values);
  CHECK(volumeOf(scene) == Approx(2));
  CHECK(normalsFaceOut(scene));
  // Instances cannot say a shear.
  for (const Instance& instance : scene.instances) CHECK(instance.transform == glm::mat4(1.0F));
  const Obb& box = scene.scopes[1].box;
  CHECK(std::abs(glm::dot(box.axes[0], box.axes[2])) < 1e-12);
  for (const Instance& instance : scene.instances) {
    for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double along = glm::dot(Vec3(p) - box.origin, box.axes[i]);
        CHECK(along >= -1e-5);
        CHECK(along <= box.size[static_cast<int>(i)] + 1e-5);
      }
    }
  }
}

TEST_CASE("all ways to spell triangles give the same square") {
  const std::vector<glm::vec3> list = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<glm::vec3> strip = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<glm::vec3> fan = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::pair<int, std::vector<glm::vec3>> spellings[] = {{4, list}, {5, strip}, {6, fan}};
  for (const auto& [mode, positions] : spellings) {
    INFO(mode);
    GltfMaker maker;
    const json attributes = {{"POSITION", maker.floats(positions)}};
    maker.node({{"mesh", maker.mesh({{"attributes", attributes}, {"mode", mode}})}});
    const Model model = readOrFail(maker.glb());
    CHECK(model.parameters().size() == 2);  // it is flat: no depth
    const Scene scene = sceneOf(model);
    REQUIRE(scene.meshes.size() == 1);
    const Mesh& mesh = scene.meshes[0];
    CHECK(mesh.positions.size() == 4);
    REQUIRE(mesh.triangles.size() == 2);
    for (const auto& normals : mesh.normals) {
      for (const glm::vec3& n : normals) CHECK(n == glm::vec3(0, 0, 1));  // computed, both the same way round
    }
  }
}

TEST_CASE("indices of every size, interleaved and normalized data, and sparse accessors are read") {
  GltfMaker maker;
  // Two positions and what stands between them: 12 bytes of position, 4 of something else.
  struct Vertex {
    glm::vec3 position;
    std::uint32_t other;
  };
  const std::vector<Vertex> vertices = {{{0, 0, 0}, 7}, {{2, 0, 0}, 7}, {{0, 2, 0}, 7}};
  const int interleaved = maker.accessor(maker.view(std::as_bytes(std::span(vertices)), 16), 5126, 3, "VEC3");
  const std::vector<std::uint8_t> bytes = {0, 1, 2};
  const int small = maker.accessor(maker.view(std::as_bytes(std::span(bytes))), 5121, 3, "SCALAR");
  maker.node({{"mesh", maker.mesh({{"attributes", {{"POSITION", interleaved}}}, {"indices", small}})}});

  // 127 and -127 of a normalized byte are 1 and -1.
  const std::vector<std::int8_t> packed = {0, 0, 127, 0, 127, 0, 127, 0, 0, 127, 127, 0};
  const int quantized = maker.accessor(maker.view(std::as_bytes(std::span(packed)), 4), 5120, 3, "VEC3");
  maker.root["accessors"][static_cast<std::size_t>(quantized)]["normalized"] = true;
  const std::vector<std::uint32_t> words = {0, 1, 2};
  const int large = maker.accessor(maker.view(std::as_bytes(std::span(words))), 5125, 3, "SCALAR");
  maker.node({{"mesh", maker.mesh({{"attributes", {{"POSITION", quantized}}}, {"indices", large}})}});

  // All zero, save for what the sparse part says: vertices 1 and 2.
  const std::vector<std::uint16_t> where = {1, 2};
  const std::vector<glm::vec3> what = {{0, 0, -4}, {0, 3, 0}};
  maker.root["accessors"].push_back({{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  json& sparse = maker.root["accessors"].back();
  const int sparseIndex = static_cast<int>(maker.root["accessors"].size()) - 1;
  sparse["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", maker.view(std::as_bytes(std::span(where)))}, {"componentType", 5123}}},
      {"values", {{"bufferView", maker.view(std::as_bytes(std::span(what)))}}}};
  maker.node({{"mesh", maker.mesh({{"attributes", {{"POSITION", sparseIndex}}}})}});

  const Scene scene = sceneOf(readOrFail(maker.glb()));
  CHECK(scene.triangleCount() == 3);
  CHECK(near(scene.bounds.min, {0, 0, -4}));
  CHECK(near(scene.bounds.max, {2, 3, 1}));
}

TEST_CASE("parts share corners across primitives, and each keeps its material") {
  GltfMaker maker;
  maker.root["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}, {"roughnessFactor", 0.4}}},
       {"doubleSided", true}}};
  const int left = maker.floats(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int right = maker.floats(std::vector<glm::vec3>{{1, 0, 0}, {1, 1, 0}, {-0.0F, 1, 0}});
  maker.root["meshes"].push_back(
      {{"primitives",
        {{{"attributes", {{"POSITION", left}}}, {"material", 0}}, {{"attributes", {{"POSITION", right}}}}}}});
  maker.node({{"mesh", 0}});
  const Scene scene = sceneOf(readOrFail(maker.glb()));
  const Mesh& mesh = scene.meshes.at(0);
  CHECK(mesh.positions.size() == 4);
  REQUIRE(mesh.materials.size() == 2);
  const Material& painted = scene.materials.at(mesh.materials[0]);
  CHECK(painted.color == glm::vec3(0.5F, 0.25F, 0.125F));
  CHECK(painted.roughness == 0.4F);
  CHECK(painted.twoSided);
  CHECK(scene.materials.at(mesh.materials[1]) == Material());
}

TEST_CASE("triangles without area and normals without length do no harm") {
  GltfMaker maker;
  const int positions = maker.floats(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}});
  const int normals = maker.floats(std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 9}, {0, 0, 0}, {0, 0, 1}});
  const int triangles = maker.indices({0, 1, 2, 0, 1, 3, 2, 2, 1});
  maker.node(
      {{"mesh", maker.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", triangles}})}});
  const Scene scene = sceneOf(readOrFail(maker.glb()));
  CHECK(scene.triangleCount() == 1);
  CHECK(normalsFaceOut(scene));
}

TEST_CASE("a place that no triangle uses does not count towards the model's size") {
  // Two meshes in one list, of which the scene shows one; and a triangle without area far away.
  GltfMaker maker;
  const int positions = maker.floats(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {50, 0, 0}, {51, 0, 0}, {50, 1, 0}, {0, 0, 70}});
  maker.node({{"mesh", maker.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices({0, 1, 2, 6, 6, 6})}})}});
  maker.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices({3, 4, 5})}});
  const Scene scene = sceneOf(readOrFail(maker.glb()));
  CHECK(scene.meshes[0].positions.size() == 3);
  CHECK(near(scene.bounds.min, {0, 0, 0}));
  CHECK(near(scene.bounds.max, {1, 1, 0}));
}

TEST_CASE("a model that lies hundreds of kilometres away is shown at the origin, in full detail") {
  GltfMaker maker;
  const int box = maker.box({1, 2, 0.01});
  const int part = maker.child({{"mesh", box}, {"name", "Pane"}, {"translation", {10, 0.5, 0}}});
  const int other = maker.child({{"mesh", box}});
  maker.node({{"children", {part, other}}, {"translation", {512345.3, 120, 4201234.7}}});
  const Model model = readOrFail(maker.glb());
  const Scene scene = sceneOf(model);
  CHECK(near(scene.bounds.min, {-5.5, 0, -0.005}, 1e-4));
  CHECK(near(scene.bounds.max, {5.5, 2.5, 0.005}, 1e-4));
  CHECK(near(scene.scopes.back().box.size, {1, 2, 0.01}, 1e-4));
  REQUIRE(model.diagnostics.size() == 1);
  CHECK(model.diagnostics[0] == "The model lies far from its origin, 4201 km; it is shown at the origin.");

  GltfMaker nearby;
  nearby.node({{"mesh", nearby.box({1, 1, 1})}, {"translation", {900, 0, 0}}});
  const Model stays = readOrFail(nearby.glb());
  CHECK(near(sceneOf(stays).bounds.min, {900, 0, 0}));
  CHECK(stays.diagnostics.empty());
}

TEST_CASE("what a node hides is not shown, nor what is below it") {
  GltfMaker maker;
  const int box = maker.box({1, 1, 1});
  const int below = maker.child({{"mesh", box}, {"translation", {5, 0, 0}}});
  const auto visible = [](bool is) { return json{{"KHR_node_visibility", {{"visible", is}}}}; };
  maker.node({{"mesh", box}, {"translation", {9, 0, 0}}, {"children", {below}}, {"extensions", visible(false)}});
  maker.node({{"mesh", box}, {"extensions", visible(true)}});
  const Scene scene = sceneOf(readOrFail(maker.glb()));
  CHECK(near(scene.bounds.min, {0, 0, 0}));
  CHECK(near(scene.bounds.max, {1, 1, 1}));
}

TEST_CASE("instances of a node that are left out are told") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({1, 1, 1})}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", json::object()}}}}}});
  const Model model = readOrFail(maker.glb());
  REQUIRE(model.diagnostics.size() == 1);
  CHECK(model.diagnostics[0] == "Node 0 is shown once, without its instances.");
}

// --- Textures ---------------------------------------------------------------------------------------------------------

/// 2x2: red, green, blue, white.
constexpr const char* kPng =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR42mP4z8DAAMIM/4EAAB/"
    "uBfvxq7p3AAAAAElFTkSuQmCC";
/// 3000x2, all #4080c0.
constexpr const char* kWidePng =
    "data:image/"
    "png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAC7gAAAACCAIAAABHIQbHAAAAMUlEQVR42u3QAQ0AAAgDoEczmtGMZg9lIwGpHgAAAAAAAAAAOC8KAAAAAAAAAAD4"
    "YAFnXCoOvxCIGgAAAABJRU5ErkJggg==";
/// 8x8, all near #c86432.
constexpr const char* kJpeg =
    "data:image/jpeg;base64,/9j/4AAQSkZJRgABAQAAAQABAAD/"
    "2wBDAAYEBQYFBAYGBQYHBwYIChAKCgkJChQODwwQFxQYGBcUFhYaHSUfGhsjHBYWICwgIyYnKSopGR8tMC0o"
    "MCUoKSj/2wBDAQcHBwoIChMKChMoGhYaKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCj/"
    "wAARCAAIAAgDASIAAhEBAxEB/8QAFQABAQAA"
    "AAAAAAAAAAAAAAAAAAP/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFAEBAAAAAAAAAAAAAAAAAAAABv/EABQRAQAAAAAAAAAAAAAAAAAAAAD/"
    "2gAMAwEAAhEDEQA/AJAB58//2Q==";

/// A textured triangle; `image` is the image's object.
GltfMaker textured(const json& image, const json& textureExtensions = {}) {
  GltfMaker maker;
  maker.root["images"] = json::array({image});
  maker.root["textures"] = json::array({{{"source", 0}}});
  json info = {{"index", 0}};
  if (textureExtensions.is_object()) info["extensions"] = textureExtensions;
  maker.root["materials"] = json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", info}}}}});
  const json attributes = {{"POSITION", maker.floats(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                           {"TEXCOORD_0", maker.floats(std::vector<glm::vec2>{{0, 1}, {1, 1}, {0, 0}})}};
  maker.node({{"mesh", maker.mesh({{"attributes", attributes}, {"material", 0}})}});
  return maker;
}

TEST_CASE("a PNG texture keeps its pixels, top row first, and its coordinates") {
  const Scene scene = sceneOf(readOrFail(textured({{"uri", kPng}}).glb()));
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0]->width == 2);
  CHECK(scene.images[0]->height == 2);
  CHECK(scene.images[0]->rgba ==
        std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
  CHECK(scene.materials.at(0).image == 0);
  CHECK(scene.materials.at(0).color == glm::vec3(1.0F));
  REQUIRE(scene.meshes.at(0).uvs.size() == 1);
  CHECK(scene.meshes[0].uvs[0] == std::array<glm::vec2, 3>{glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0)});
}

TEST_CASE("all evaluations of a model have its textures in common") {
  const Model model = readOrFail(textured({{"uri", kPng}}).glb());
  const Scene a = sceneOf(model), b = sceneOf(model);
  REQUIRE(a.images.size() == 1);
  CHECK(a.images[0] == b.images[0]);
}

TEST_CASE("a JPEG is read, and what is too wide is halved until it fits") {
  const Scene jpeg = sceneOf(readOrFail(textured({{"uri", kJpeg}}).glb()));
  REQUIRE(jpeg.images.size() == 1);
  CHECK(jpeg.images[0]->width == 8);
  const std::uint8_t wanted[] = {0xc8, 0x64, 0x32, 0xff};
  for (std::size_t i = 0; i < jpeg.images[0]->rgba.size(); ++i) {
    CHECK(std::abs(int{jpeg.images[0]->rgba[i]} - int{wanted[i % 4]}) <= 3);
  }

  const Scene wide = sceneOf(readOrFail(textured({{"uri", kWidePng}}).glb()));
  REQUIRE(wide.images.size() == 1);
  CHECK(wide.images[0]->width == 750);
  CHECK(wide.images[0]->height == 1);
  const std::uint8_t blue[] = {0x40, 0x80, 0xc0, 0xff};
  for (std::size_t i = 0; i < wide.images[0]->rgba.size(); ++i) CHECK(wide.images[0]->rgba[i] == blue[i % 4]);
}

TEST_CASE("KHR_texture_transform is applied to the coordinates") {
  // A quarter turn takes (u, v) to (v, -u), after the scale (2, 1); then (0.5, 0) is added.
  const json transform = {
      {"KHR_texture_transform", {{"offset", {0.5, 0}}, {"scale", {2, 1}}, {"rotation", 1.5707963267948966}}}};
  const Scene scene = sceneOf(readOrFail(textured({{"uri", kPng}}, transform).glb()));
  const auto& uvs = scene.meshes.at(0).uvs.at(0);
  CHECK(glm::length(uvs[0] - glm::vec2(1.5, 0)) < 1e-5F);
  CHECK(glm::length(uvs[1] - glm::vec2(1.5, -2)) < 1e-5F);
  CHECK(glm::length(uvs[2] - glm::vec2(0.5, 0)) < 1e-5F);
}

TEST_CASE("a texture that cannot be read costs the texture, not the model") {
  const auto diagnosticOf = [](const GltfMaker& maker) {
    const Model model = readOrFail(maker.glb());
    const Scene scene = sceneOf(model);
    CHECK(scene.images.empty());
    CHECK(scene.materials.at(0).image == -1);
    REQUIRE(model.diagnostics.size() == 1);
    return model.diagnostics[0];
  };
  CHECK(diagnosticOf(textured({{"uri", "wood.png"}})) ==
        "Image \"wood.png\" cannot be shown: there is no file \"wood.png\"; its surfaces have a plain colour.");
  CHECK(diagnosticOf(textured({{"uri", "data:image/png;base64,AAAAAAAA"}})) ==
        "Image 0 cannot be shown: it is neither a PNG nor a JPEG; its surfaces have a plain colour.");
  // The same picture, cut off after its header.
  CHECK(diagnosticOf(textured({{"uri", std::string(kPng).substr(0, 70)}})) ==
        "Image 0 cannot be shown: it is damaged; its surfaces have a plain colour.");
  GltfMaker missing = textured({{"uri", kPng}});
  missing.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7;
  CHECK(diagnosticOf(missing) == "Texture 7 is used but does not exist; its surfaces have a plain colour.");
}

// --- Files -------------------------------------------------------------------------------------------------------------

TEST_CASE("buffers come from other files, under the names that the file gives them") {
  GltfMaker maker;
  maker.node({{"mesh", maker.box({1, 1, 1})}});
  std::vector<std::string> asked;
  const GltfFileResolver resolve = [&](std::string_view uri) -> Result<std::vector<std::byte>> {
    asked.emplace_back(uri);
    std::vector<std::byte> padded = maker.bin;
    padded.resize(padded.size() + 3);
    return padded;
  };
  const auto bytes = maker.gltf("a%20box+1.bin");
  CHECK(volumeOf(sceneOf(readOrFail(bytes, resolve))) == Approx(1));
  CHECK(asked == std::vector<std::string>{"a%20box+1.bin"});

  auto files = externalGltfFiles("a.gltf", bytes);
  REQUIRE(files.ok());
  CHECK(*files == asked);

  CHECK(errorOf(bytes) == "a.glb: there is no file \"a%20box+1.bin\".");
  const GltfFileResolver tooShort = [](std::string_view) -> Result<std::vector<std::byte>> {
    return std::vector<std::byte>(7);
  };
  CHECK(errorOf(bytes, tooShort) ==
        "a.glb: the file \"a%20box+1.bin\" should have " + std::to_string(maker.bin.size()) + " bytes, but has 7.");
}

TEST_CASE("furniture from the KayKit pack") {
  auto chair = readGltfFile(DIMLINE_TEST_DATA_DIR "/gltf/chair_A.gltf");
  if (!chair.ok()) FAIL(chair.error().message);
  CHECK(chair->diagnostics.empty());
  const Scene scene = sceneOf(*chair);
  CHECK(scene.triangleCount() == 308);  // 924 indices
  // The extremes that the file's accessor gives.
  CHECK(near(scene.bounds.min, {-0.375, -7.450580596923828e-09, -0.47012859582901}, 1e-7));
  CHECK(near(scene.bounds.max, {0.375, 1.2583259344100952, 0.3749999403953552}, 1e-7));
  CHECK(volumeOf(scene) > 0);
  CHECK(scene.images.size() == 1);
  // 458 vertices stand for fewer places.
  CHECK(scene.meshes.at(0).positions.size() < 250);

  auto files = externalGltfFiles("chair.gltf", std::as_bytes(std::span(R"({"asset":{"version":"2.0"}})", 27)));
  REQUIRE(files.ok());
  CHECK(files->empty());

  auto lamp = readGltfFile(DIMLINE_TEST_DATA_DIR "/gltf/lamp_standing.gltf");
  if (!lamp.ok()) FAIL(lamp.error().message);
  CHECK(volumeOf(sceneOf(*lamp)) > 0);

  auto none = readGltfFile(DIMLINE_TEST_DATA_DIR "/gltf/table.gltf");
  REQUIRE_FALSE(none.ok());
  CHECK(none.error().message == "there is no file \"" DIMLINE_TEST_DATA_DIR
                                "/gltf/table.gltf\", or it may not be read.");
}

}  // namespace
}  // namespace dimline
