#include "render/edge_lines.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <catch2/catch.hpp>

#include "math/camera.h"

#include "support/scenes.h"
#include "support/village.h"

using namespace dimline;

namespace {

std::vector<EdgeLine> edgesOf(const Scene& scene) {
  std::vector<EdgeLine> edges;
  findEdgeLines(scene, edges);
  return edges;
}

Scene boxScene(const Vec3& size) {
  Scene scene;
  test::addBox(scene, test::boxAt({0, 0, 0}, size));
  finish(scene);
  return scene;
}

}  // namespace

TEST_CASE("a box has twelve edges to ink, and none across its faces") {
  const std::vector<EdgeLine> edges = edgesOf(boxScene({4, 3, 2}));
  REQUIRE(edges.size() == 12);
  int across = 0;
  for (const EdgeLine& edge : edges) {
    const glm::vec3 d = glm::abs(edge.b - edge.a);
    CHECK((d.x > 0) + (d.y > 0) + (d.z > 0) == 1);
    CHECK(glm::dot(edge.normalA, edge.normalB) == Approx(0).margin(1e-6));
    // The narrower of the two faces beside it: across the edge, whichever side is shorter.
    if (d.x > 0) CHECK(edge.widthM == Approx(2));
    if (d.y > 0) CHECK(edge.widthM == Approx(2));
    if (d.z > 0) CHECK(edge.widthM == Approx(3));
    across += d.x > 0 ? 1 : 0;
  }
  CHECK(across == 4);
}

TEST_CASE("a border of an open surface is an edge between opposite sides") {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.materials = {0};
  mesh.normals = {{glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)}};
  scene.materials.emplace_back();
  scene.meshes.push_back(mesh);
  scene.instances.push_back({});
  finish(scene);
  const std::vector<EdgeLine> edges = edgesOf(scene);
  REQUIRE(edges.size() == 3);
  for (const EdgeLine& edge : edges) CHECK(edge.normalA == -edge.normalB);
}

TEST_CASE("edges across which the shading is smooth are inked as contours only") {
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes.emplace_back();
  test::village::addCylinder(scene.meshes[0], 0, {0, 0, 0}, 1, 3, 24);
  scene.instances.push_back({});
  finish(scene);
  int smooth = 0;
  int creases = 0;
  for (const EdgeLine& edge : edgesOf(scene)) (edge.widthM < 0 ? smooth : creases) += 1;
  CHECK(smooth == 24);    // along the side
  CHECK(creases == 48);   // round both ends
}

TEST_CASE("instances bring their edges along, moved, turned and scaled") {
  Scene scene = boxScene({1, 1, 1});
  const glm::mat4 one(1.0F);
  scene.instances = {{0, glm::scale(glm::translate(one, {10, 0, 0}), {2, 2, 2})}, {0, glm::rotate(one, 1.5707963F, {0, 1, 0})}};
  finish(scene);
  const std::vector<EdgeLine> edges = edgesOf(scene);
  REQUIRE(edges.size() == 24);
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(glm::length(edges[i].b - edges[i].a) == Approx(2));
    CHECK(edges[i].widthM == Approx(2));
    CHECK(edges[i].a.x >= 9.999F);
    CHECK(glm::length(edges[i].normalA) == Approx(1));
  }
  for (std::size_t i = 12; i < 24; ++i) {
    CHECK(edges[i].a.z <= 1e-5F);   // x has become -z
    CHECK(glm::length(edges[i].b - edges[i].a) == Approx(1));
  }
}

TEST_CASE("triangles without area and an empty scene give no edges that are not numbers") {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 1, 2}};
  mesh.materials = {0, 0, 0};
  mesh.normals.resize(3, {glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)});
  scene.materials.emplace_back();
  scene.meshes.push_back(mesh);
  scene.instances.push_back({});
  finish(scene);
  for (const EdgeLine& edge : edgesOf(scene)) {
    CHECK(std::isfinite(edge.widthM));
    CHECK(std::isfinite(edge.normalA.x + edge.normalB.x));
  }
  CHECK(edgesOf(Scene{}).empty());
}
