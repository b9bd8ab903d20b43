#include "model/imported_scene.h"

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// Two triangles of two materials, one of them with a picture, placed twice, once mirrored, under one name: something of everything.
ImportedScene something() {
  ImportedScene scene;
  scene.name = "folder/some_thing.glb";
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {0, 1};
  mesh.normals = {{glm::vec3(0, 0, 1), {0, 0, 1}, {0, 0, 1}}, {glm::vec3(1, 0, 0), {1, 0, 0}, {1, 0, 0}}};
  mesh.uvs = {{glm::vec2(0, 0), {1, 0}, {0, 1}}, {glm::vec2(0, 0), {1, 0}, {0, 0.5F}}};
  scene.meshes = {mesh, Mesh{}};
  scene.materials.resize(2);
  scene.materials[1].color = {0.25F, 0.5F, 1};
  scene.materials[1].roughness = 0.125F;
  scene.materials[1].image = 0;
  scene.materials[1].twoSided = true;
  scene.images = {{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}}};
  Mat4 mirrored(1.0);
  mirrored[0][0] = -1;
  scene.placed = {{0, Mat4(1.0)}, {0, mirrored}};
  scene.parts = {{"Part", mirrored, 1, 2}};
  scene.bounds = {{-2, 0, 0}, {2, 3, 4}};
  scene.diagnostics = {"Mesh 3 has points or lines, which are left out.", ""};
  return scene;
}

std::string errorOf(std::span<const std::byte> bytes) {
  const auto scene = importedSceneFrom(bytes);
  return scene ? "(no error)" : scene.error().message;
}

std::string errorOf(const ImportedScene& scene) { return errorOf(bytesOf(scene)); }

TEST_CASE("an imported scene is the same after its way through bytes") {
  const ImportedScene before = something();
  const auto read = importedSceneFrom(bytesOf(before));
  REQUIRE(read.ok());
  const ImportedScene& after = *read;
  CHECK(after.name == before.name);
  REQUIRE(after.meshes.size() == 2);
  CHECK(after.meshes[0].positions == before.meshes[0].positions);
  CHECK(after.meshes[0].triangles == before.meshes[0].triangles);
  CHECK(after.meshes[0].materials == before.meshes[0].materials);
  CHECK(after.meshes[0].normals == before.meshes[0].normals);
  CHECK(after.meshes[0].uvs == before.meshes[0].uvs);
  CHECK(after.meshes[1].triangles.empty());
  CHECK(after.materials == before.materials);
  REQUIRE(after.images.size() == 1);
  CHECK(after.images[0].width == 2);
  CHECK(after.images[0].height == 1);
  CHECK(after.images[0].rgba == before.images[0].rgba);
  REQUIRE(after.placed.size() == 2);
  CHECK(after.placed[1].mesh == 0);
  CHECK(after.placed[1].world == before.placed[1].world);
  REQUIRE(after.parts.size() == 1);
  CHECK(after.parts[0].name == "Part");
  CHECK(after.parts[0].world == before.parts[0].world);
  CHECK(after.parts[0].firstPlaced == 1);
  CHECK(after.parts[0].endPlaced == 2);
  CHECK(after.bounds.min == before.bounds.min);
  CHECK(after.bounds.max == before.bounds.max);
  CHECK(after.diagnostics == before.diagnostics);
}

TEST_CASE("a scene's bytes that are cut off, or go on, are an error") {
  const std::vector<std::byte> bytes = bytesOf(something());
  REQUIRE(errorOf(bytes) == "(no error)");
  for (std::size_t length = 0; length < bytes.size(); ++length) CHECK(errorOf(std::span(bytes).first(length)) != "(no error)");
  std::vector<std::byte> longer = bytes;
  longer.push_back({});
  CHECK(errorOf(longer) != "(no error)");
}

TEST_CASE("bytes of another version are an error that says what to do") {
  std::vector<std::byte> bytes = bytesOf(something());
  bytes[4] ^= std::byte{1};  // the version's first character, behind its length
  CHECK(errorOf(bytes).find("of one build") != std::string::npos);
}

TEST_CASE("a scene that refers to what it does not hold is an error") {
  const auto with = [](auto change) {
    ImportedScene scene = something();
    change(scene);
    return errorOf(scene);
  };
  REQUIRE(with([](ImportedScene&) {}) == "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].triangles[1][2] = 4; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].materials[0] = 2; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].materials.pop_back(); }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].normals.pop_back(); }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].uvs.pop_back(); }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.meshes[0].uvs.clear(); }) == "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.materials[0].image = 1; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.images[0].height = 2; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.placed[0].mesh = 2; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.parts[0].endPlaced = 3; }) != "(no error)");
  CHECK(with([](ImportedScene& scene) { scene.parts[0].firstPlaced = 3; }) != "(no error)");
}

TEST_CASE("a stretched model is called after its file, and has its three sizes and its parts") {
  auto model = stretchedModel(something());
  REQUIRE(model.ok());
  CHECK(model->definition.name == "some_thing");
  CHECK(model->definition.title == "some thing");
  CHECK(model->diagnostics == something().diagnostics);
  REQUIRE(model->parameters().size() == 3);
  CHECK(model->parameters()[0].defaultValue == 4);
  CHECK(model->parameters()[1].defaultValue == 3);

  Values wide(model->parameters());
  wide.set(0, 8);
  const Scene scene = model->definition.build(wide);
  CHECK(scene.bounds.min == Vec3(-2, 0, 0));
  CHECK(scene.bounds.max == Vec3(6, 3, 4));
  CHECK(scene.triangleCount() == 4);
  REQUIRE(scene.scopes.size() == 2);
  CHECK(scene.scopes[0].name == "Model");
  CHECK(scene.scopes[1].name == "Part");
  CHECK(scene.scopes[1].box.size == Vec3(4, 3, 4));
}

}  // namespace
}  // namespace dimline
