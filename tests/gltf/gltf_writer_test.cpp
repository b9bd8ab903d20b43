#include "gltf/gltf_writer.h"

#include <cmath>
#include <cstring>
#include <map>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "gltf/gltf_reader.h"

namespace dimline {
namespace {

using nlohmann::json;

/// A square of two triangles in the plane z = 0, from (0, 0) to (1, 1), seen from +z. Each half has a material of its own when there are two.
Mesh square(std::uint16_t second = 0) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {0, second};
  mesh.normals.assign(2, {glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)});
  mesh.uvs = {{glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)}, {glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(0, 0)}};
  return mesh;
}

Scene sceneOf(std::vector<Mesh> meshes, std::vector<Instance> instances) {
  Scene scene;
  scene.meshes = std::move(meshes);
  scene.instances = std::move(instances);
  scene.materials = {{.color = {0.25F, 0.5F, 0.75F}, .roughness = 0.5F}, {.color = {1, 0, 0}, .roughness = 1, .twoSided = true}};
  finish(scene);
  return scene;
}

std::string written(const Scene& scene) {
  auto glb = writeGlb(scene, "A thing");
  if (!glb) FAIL(glb.error().message);
  return std::move(glb).value();
}

/// A file's JSON, after a look at the lengths around it (glTF 2.0, 4.4: "Binary glTF Layout").
json jsonOf(const std::string& glb) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + at, sizeof value);
    return value;
  };
  REQUIRE(glb.size() > 20);
  CHECK(glb.substr(0, 4) == "glTF");
  CHECK(word(4) == 2);
  CHECK(word(8) == glb.size());
  CHECK(glb.size() % 4 == 0);
  CHECK(glb.substr(16, 4) == "JSON");
  CHECK(word(12) % 4 == 0);
  CHECK(20 + word(12) + 8 + word(20 + word(12)) == glb.size());
  json parsed = json::parse(glb.substr(20, word(12)), nullptr, false);
  REQUIRE(!parsed.is_discarded());
  return parsed;
}

ImportedScene readBack(const std::string& glb) {
  const auto* first = reinterpret_cast<const std::byte*>(glb.data());
  auto scene = importGltf("back.glb", {first, glb.size()}, [](std::string_view) -> Result<std::vector<std::byte>> {
    return Error{"there is no other file."};
  });
  if (!scene) FAIL(scene.error().message);
  return std::move(scene).value();
}

TEST_CASE("a mesh is written once, and stands wherever its instances stand") {
  const glm::mat4 aside = glm::scale(glm::translate(glm::mat4(1.0F), {5, 6, 7}), {2, 3, 4});
  const Scene scene = sceneOf({square()}, {{0, glm::mat4(1.0F)}, {0, aside}});
  const std::string glb = written(scene);
  const json file = jsonOf(glb);
  CHECK(file["asset"]["version"] == "2.0");
  CHECK(file["meshes"].size() == 1);
  REQUIRE(file["nodes"].size() == 3);
  CHECK(file["nodes"][0]["name"] == "A thing");
  CHECK(file["nodes"][0]["children"] == json({1, 2}));
  CHECK_FALSE(file["nodes"][1].contains("matrix"));
  CHECK(file["nodes"][2]["matrix"] == json({2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}));

  const ImportedScene back = readBack(glb);
  CHECK(back.diagnostics.empty());
  CHECK(back.bounds.min == scene.bounds.min);
  CHECK(back.bounds.max == scene.bounds.max);
  REQUIRE(back.placed.size() == 2);
  CHECK(back.placed[1].world == Mat4(aside));
  CHECK(back.meshes[back.placed[0].mesh].triangles.size() == 2);
}

TEST_CASE("corners that agree share a vertex, and a material's triangles are one primitive") {
  // Of the square's six corners two pairs agree: four vertices, or three in each half where the halves differ.
  const json one = jsonOf(written(sceneOf({square()}, {{0}})));
  REQUIRE(one["meshes"][0]["primitives"].size() == 1);
  const auto accessor = [](const json& file, const json& number) { return file["accessors"][number.get<std::size_t>()]; };
  const json& primitive = one["meshes"][0]["primitives"][0];
  const json positions = accessor(one, primitive["attributes"]["POSITION"]);
  CHECK(positions["count"] == 4);
  CHECK(positions["min"] == json({0, 0, 0}));
  CHECK(positions["max"] == json({1, 1, 0}));
  CHECK(accessor(one, primitive["indices"])["count"] == 6);
  // A builder's texture coordinates are for its patterns, which stay behind.
  CHECK_FALSE(primitive["attributes"].contains("TEXCOORD_0"));

  const json two = jsonOf(written(sceneOf({square(1)}, {{0}})));
  REQUIRE(two["meshes"][0]["primitives"].size() == 2);
  for (const json& half : two["meshes"][0]["primitives"]) CHECK(accessor(two, half["attributes"]["POSITION"])["count"] == 3);
}

TEST_CASE("every accessor begins where its numbers may, and ends within its view and the buffer") {
  // An image between them, of a size that is a multiple of nothing.
  Scene scene = sceneOf({square(1)}, {{0}});
  scene.images.push_back(share({3, 1, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}}));
  scene.materials[1].image = 0;
  const json file = jsonOf(written(scene));
  const std::size_t total = file["buffers"][0]["byteLength"].get<std::size_t>();
  for (const json& view : file["bufferViews"]) {
    const std::size_t begin = view.value("byteOffset", std::size_t{0});
    CHECK(begin % 4 == 0);
    CHECK(begin + view["byteLength"].get<std::size_t>() <= total);
  }
  for (const json& accessor : file["accessors"]) {
    const std::map<std::string, std::size_t> numbers = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}};
    const std::size_t bytes = accessor["componentType"] == 5123 ? 2 : 4;
    CHECK(file["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteLength"] ==
          accessor["count"].get<std::size_t>() * bytes * numbers.at(accessor["type"]));
  }
}

TEST_CASE("colours, roughness, both sides and textures come back as they were") {
  Scene scene = sceneOf({square(1)}, {{0}});
  scene.images.push_back(share({2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255}}));
  scene.materials[1].image = 0;
  const ImportedScene back = readBack(written(scene));
  REQUIRE(back.materials.size() >= 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(back.materials[i].color == scene.materials[i].color);
    CHECK(back.materials[i].roughness == scene.materials[i].roughness);
    CHECK(back.materials[i].twoSided == scene.materials[i].twoSided);
    CHECK(back.materials[i].image == scene.materials[i].image);
  }
  REQUIRE(back.images.size() == 1);
  CHECK(back.images[0].width == 2);
  CHECK(back.images[0].rgba == scene.images[0]->rgba);
  const Mesh& mesh = back.meshes[0];
  REQUIRE(mesh.uvs.size() == 2);
  CHECK(mesh.uvs[1] == scene.meshes[0].uvs[1]);
  CHECK(mesh.normals[0] == scene.meshes[0].normals[0]);
}

TEST_CASE("beyond 65,535 vertices indices have four bytes") {
  Mesh strip;
  for (int i = 0; i < 35'000; ++i) {
    const auto x = static_cast<float>(i);
    strip.positions.insert(strip.positions.end(), {{x, 0, 0}, {x, 1, 0}});
  }
  for (std::uint32_t i = 0; i + 2 < strip.positions.size(); i += 2) strip.triangles.push_back({i, i + 2, i + 1}), strip.triangles.push_back({i + 1, i + 2, i + 3});
  strip.materials.assign(strip.triangles.size(), 0);
  strip.normals.assign(strip.triangles.size(), {glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)});
  const Scene scene = sceneOf({strip}, {{0}});
  const std::string glb = written(scene);
  const json file = jsonOf(glb);
  CHECK(file["accessors"][file["meshes"][0]["primitives"][0]["indices"].get<std::size_t>()]["componentType"] == 5125);
  CHECK(readBack(glb).bounds.max == scene.bounds.max);
}

TEST_CASE("a mesh without triangles is left out, and a scene without any is an error") {
  const Scene scene = sceneOf({Mesh{}, square()}, {{0}, {1}});
  const json file = jsonOf(written(scene));
  CHECK(file["meshes"].size() == 1);
  CHECK(file["nodes"].size() == 2);
  CHECK(file["nodes"][1]["mesh"] == 0);

  const auto nothing = writeGlb(sceneOf({Mesh{}}, {{0}}), "Nothing");
  REQUIRE_FALSE(nothing.ok());
  CHECK(nothing.error().message == "the model has no triangles, so there is nothing to write.");
}

TEST_CASE("a mesh that stands nowhere, and a material that no triangle has, are left out") {
  Mesh red = square(1);
  red.materials = {1, 1};
  const json file = jsonOf(written(sceneOf({square(), red}, {{1}})));
  REQUIRE(file["meshes"].size() == 1);
  REQUIRE(file["materials"].size() == 1);
  CHECK(file["meshes"][0]["primitives"].size() == 1);
  CHECK(file["meshes"][0]["primitives"][0]["material"] == 0);
  CHECK(file["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] == json{1.0, 0.0, 0.0, 1.0});
}

TEST_CASE("the same scene gives the same bytes") {
  const Scene scene = sceneOf({square(1)}, {{0}});
  CHECK(written(scene) == written(scene));
}

}  // namespace
}  // namespace dimline
