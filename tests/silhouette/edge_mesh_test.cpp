#include "silhouette/edge_mesh.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "silhouette/scene_shapes.h"

namespace dimline {
namespace {

std::size_t borders(const EdgeMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.edges.begin(), mesh.edges.end(), [](const EdgeMesh::Edge& edge) {
    return edge.facetA == EdgeMesh::kNoFacet && edge.facetB == EdgeMesh::kNoFacet;
  }));
}

/// Facets with a plane.
std::size_t facetCount(const EdgeMesh& mesh) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.offset.size(); ++i) {
    count += mesh.normalX[i] != 0 || mesh.normalY[i] != 0 || mesh.normalZ[i] != 0 ? 1U : 0U;
  }
  return count;
}

Vec3 normalOf(const EdgeMesh& mesh, std::size_t facet) {
  return {mesh.normalX[facet], mesh.normalY[facet], mesh.normalZ[facet]};
}

TEST_CASE("a box has six facets and twelve edges, none along a diagonal") {
  const EdgeMesh box = makeEdgeMesh(test::boxMesh());
  REQUIRE(box.positions.size() == 8);
  REQUIRE(box.triangles.size() == 12);
  REQUIRE(facetCount(box) == 6);
  REQUIRE(box.edges.size() == 12);
  REQUIRE(borders(box) == 0);
  for (const EdgeMesh::Edge& edge : box.edges) {
    REQUIRE(glm::length(box.positions[edge.a] - box.positions[edge.b]) == 2);
    REQUIRE(glm::dot(normalOf(box, edge.facetA), normalOf(box, edge.facetB)) == 0);
  }
  for (std::size_t facet = EdgeMesh::kFirstFacet; facet < EdgeMesh::kFirstFacet + 6; ++facet) {
    REQUIRE(glm::length(normalOf(box, facet)) == Approx(1));
    REQUIRE(box.offset[facet] == Approx(-1));  // the middle is behind every face
  }
}

TEST_CASE("facets come in fours, filled up with zeros, after four that are none") {
  const EdgeMesh box = makeEdgeMesh(test::boxMesh());
  REQUIRE(box.parts.size() == 1);
  REQUIRE(box.parts[0].facets.first == 4);
  REQUIRE(box.parts[0].facets.end == 12);
  REQUIRE(box.offset.size() == 12);
  for (const std::size_t i : {0, 1, 2, 3, 10, 11}) {
    REQUIRE(normalOf(box, i) == Vec3(0.0));
    REQUIRE(box.offset[i] == 0);
  }
}

TEST_CASE("what does not hang together is another part, wherever its triangles stand") {
  // Two boxes, their triangles taken in turn; and a vertex that nothing uses.
  const Mesh box = test::boxMesh();
  Mesh both;
  for (const glm::vec3& p : box.positions) both.positions.push_back(p);
  both.positions.emplace_back(100, 100, 100);
  for (const glm::vec3& p : box.positions) both.positions.push_back(p * 0.5F + glm::vec3(3, 0, 0));
  for (const auto& [a, b, c] : box.triangles) {
    both.triangles.push_back({a, b, c});
    both.triangles.push_back({a + 9, b + 9, c + 9});
  }
  const EdgeMesh mesh = makeEdgeMesh(both);
  REQUIRE(mesh.parts.size() == 2);
  REQUIRE(mesh.edges.size() == 24);
  REQUIRE(borders(mesh) == 0);
  for (const EdgeMesh::Part& part : mesh.parts) {
    REQUIRE(part.vertices.size() == 8);
    REQUIRE(part.triangles.size() == 12);
    REQUIRE(part.edges.size() == 12);
    REQUIRE(part.facets.size() == 8);
    for (std::uint32_t e = part.edges.first; e < part.edges.end; ++e) {
      const EdgeMesh::Edge& edge = mesh.edges[e];
      for (const std::uint32_t v : {edge.a, edge.b}) {
        REQUIRE((v >= part.vertices.first && v < part.vertices.end));
        REQUIRE(glm::all(glm::lessThanEqual(glm::abs(Vec3(mesh.positions[v]) - part.center), part.halfSize + 1e-6)));
      }
      for (const std::uint32_t f : {edge.facetA, edge.facetB}) REQUIRE((f >= part.facets.first && f < part.facets.end));
    }
  }
  REQUIRE(mesh.center + mesh.parts[0].center == Vec3(0.0));
  REQUIRE(mesh.parts[0].halfSize == Vec3(1.0));
  REQUIRE(mesh.center + mesh.parts[1].center == Vec3(3, 0, 0));
  REQUIRE(mesh.parts[1].halfSize == Vec3(0.5));
}

TEST_CASE("a sphere is closed, and each of its triangles faces out") {
  const EdgeMesh sphere = makeEdgeMesh(test::sphereMesh(12, 18));
  REQUIRE(borders(sphere) == 0);
  // Quadrilaterals between two parallels are flat: 18 triangles at each pole, 18 facets in each of 10 rings between.
  REQUIRE(facetCount(sphere) == 18 * 12);
  REQUIRE(sphere.edges.size() == 18 * 12 + 18 * 11);
  for (std::size_t facet = 0; facet < sphere.offset.size(); ++facet)
    REQUIRE((sphere.offset[facet] < 0) == (normalOf(sphere, facet) != Vec3(0.0)));
}

TEST_CASE("vertices that were split for their normals are welded") {
  const EdgeMesh welded = makeEdgeMesh(test::split(test::sphereMesh(12, 18)));
  const EdgeMesh shared = makeEdgeMesh(test::sphereMesh(12, 18));
  REQUIRE(welded.positions.size() == shared.positions.size());
  REQUIRE(welded.edges.size() == shared.edges.size());
  REQUIRE(borders(welded) == 0);
}

TEST_CASE("closed solids that touch stay two, whose edges know both their faces") {
  Mesh both = test::boxMesh();
  const Mesh box = both;
  for (const glm::vec3& p : box.positions) both.positions.push_back(p + glm::vec3(2, 0, 0));  // four corners at the same places
  for (const auto& [a, b, c] : box.triangles) both.triangles.push_back({a + 8, b + 8, c + 8});
  const EdgeMesh mesh = makeEdgeMesh(both);
  REQUIRE(mesh.parts.size() == 2);
  REQUIRE(mesh.positions.size() == 16);
  REQUIRE(mesh.edges.size() == 24);
  REQUIRE(borders(mesh) == 0);
}

TEST_CASE("an open part is welded with its like, and a closed one that it touches is left alone") {
  // A box whose lid is a part of its own, on a closed box.
  const Mesh closed = test::boxMesh();
  Mesh mesh = closed;
  for (const glm::vec3& p : closed.positions) mesh.positions.push_back(p + glm::vec3(0, 2, 0));
  for (const glm::vec3& p : closed.positions) mesh.positions.push_back(p + glm::vec3(0, 2, 0));
  for (const auto& [a, b, c] : closed.triangles) {
    const float lid = std::min({closed.positions[a].y, closed.positions[b].y, closed.positions[c].y});
    const std::uint32_t first = lid > 0 ? 16 : 8;
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
  const EdgeMesh prepared = makeEdgeMesh(mesh);
  REQUIRE(prepared.parts.size() == 2);
  REQUIRE(prepared.positions.size() == 16);
  REQUIRE(prepared.edges.size() == 24);
  REQUIRE(borders(prepared) == 0);
}

TEST_CASE("minus zero and zero are the same place") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, -0.0F}, {0, 1, 0}, {-1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const EdgeMesh prepared = makeEdgeMesh(mesh);
  REQUIRE(prepared.positions.size() == 4);
  REQUIRE(facetCount(prepared) == 1);  // both lie in z = 0 and share an edge
  REQUIRE(prepared.edges.size() == 4);
}

TEST_CASE("a flat sheet is one facet inside its border") {
  const EdgeMesh sheet = makeEdgeMesh(test::sheetMesh(5, 0));
  REQUIRE(facetCount(sheet) == 1);
  REQUIRE(sheet.edges.size() == 20);
  REQUIRE(borders(sheet) == 20);
}

TEST_CASE("an edge with three faces, or two that disagree, is a border") {
  Mesh fan;
  fan.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, -1}};
  fan.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  REQUIRE(makeEdgeMesh(fan).edges.size() == 7);
  REQUIRE(borders(makeEdgeMesh(fan)) == 7);
  Mesh turned;
  turned.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  turned.triangles = {{0, 1, 2}, {0, 3, 2}};
  REQUIRE(makeEdgeMesh(turned).edges.size() == 5);
  REQUIRE(borders(makeEdgeMesh(turned)) == 5);
  turned.triangles = {{0, 1, 2}, {0, 2, 3}};
  REQUIRE(makeEdgeMesh(turned).edges.size() == 4);
}

TEST_CASE("triangles without area or without a place do no harm") {
  Mesh mesh = test::boxMesh();
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.emplace_back(std::nanf(""), 0, 0);
  mesh.triangles.push_back({0, 1, 8});
  const EdgeMesh box = makeEdgeMesh(mesh);
  REQUIRE(box.triangles.size() == 12);
  REQUIRE(box.edges.size() == 12);
  REQUIRE(makeEdgeMesh(Mesh{}).edges.empty());
  Mesh needle;
  needle.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  needle.triangles = {{0, 1, 2}};
  const EdgeMesh prepared = makeEdgeMesh(needle);
  REQUIRE(prepared.edges.size() == 3);
  REQUIRE(facetCount(prepared) == 0);
}

TEST_CASE("positions are kept relative to the middle, so that far coordinates lose nothing") {
  Mesh far = test::boxMesh();
  for (glm::vec3& p : far.positions) p += glm::vec3(4096, 0, -8192);
  const EdgeMesh prepared = makeEdgeMesh(far);
  REQUIRE(prepared.center == Vec3(4096, 0, -8192));
  REQUIRE(prepared.parts[0].halfSize == Vec3(1.0));
  for (const glm::vec3& p : prepared.positions) REQUIRE(glm::abs(p) == glm::vec3(1.0F));
  REQUIRE(facetCount(prepared) == 6);
}

}  // namespace
}  // namespace dimline
