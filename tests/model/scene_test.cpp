#include "model/scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// One triangle with corners at the origin, (1,0,0) and (0,2,0).
Mesh triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.materials = {0};
  mesh.normals = {{glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)}};
  return mesh;
}

TEST_CASE("an empty scene is finished as an empty one") {
  Scene scene;
  finish(scene);
  CHECK(scene.bounds.empty());
  CHECK(scene.triangleCount() == 0);
}

TEST_CASE("bounds and triangles are those of the instances, not of the meshes") {
  Scene scene;
  scene.meshes = {triangle(), triangle()};
  scene.instances.push_back({0, glm::translate(glm::mat4(1.0F), glm::vec3(10, 0, -3))});
  // A quarter turn about z takes (1,0,0) to (0,1,0) and (0,2,0) to (-2,0,0).
  glm::mat4 turned(1.0F);
  turned[0] = glm::vec4(0, 1, 0, 0);
  turned[1] = glm::vec4(-1, 0, 0, 0);
  scene.instances.push_back({0, turned});
  finish(scene);
  CHECK(scene.triangleCount() == 2);
  CHECK(scene.bounds.min == Vec3(-2, 0, -3));
  CHECK(scene.bounds.max == Vec3(11, 2, 0));

  scene.instances.clear();
  finish(scene);
  CHECK(scene.bounds.empty());
}

TEST_CASE("a scope's index counts those of its name, in order") {
  Scene scene;
  for (const char* name : {"Window", "Door", "Window", "Window", "Door", "window"})
    scene.scopes.push_back({name, 77, {}});
  finish(scene);
  std::vector<std::uint32_t> indices;
  for (const Scope& scope : scene.scopes) indices.push_back(scope.index);
  CHECK(indices == std::vector<std::uint32_t>{0, 0, 1, 2, 1, 0});
}

TEST_CASE("a scope with a number that is not finite goes, and is not counted") {
  Scene scene;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scene.scopes = {{"Window", 0, {.size = {1, nan, 1}}}, {"Window", 0, {.origin = {nan, 0, 0}}}, {"Window", 0, {.size = {1, 2, 3}}}};
  finish(scene);
  REQUIRE(scene.scopes.size() == 1);
  CHECK(scene.scopes[0].index == 0);
  CHECK(scene.scopes[0].box.size == Vec3(1, 2, 3));
}

}  // namespace
}  // namespace dimline
