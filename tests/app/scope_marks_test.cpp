#include "app/scope_marks.h"

#include <catch2/catch.hpp>

#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// Straight before the origin, 20 m away: 100 px a metre there.
View straightView() {
  Camera camera = orbitCamera({0, 2, 0}, 20, 0, 0);
  camera.orthoHeightM = 8;
  Bounds bounds;
  bounds.add({-4, 0, -4});
  bounds.add({4, 4, 4});
  return {camera, 800, 800, bounds};
}

}  // namespace

TEST_CASE("a box is marked by its twelve edges, a flat one by four, a line by itself and a point by none") {
  std::vector<OverlayEdge> edges;
  const auto count = [&](const Vec3& size) {
    edges.clear();
    addEdges(boxAt({-1, 1, 0}, size), straightView(), {}, edges);
    return edges.size();
  };
  CHECK(count({2, 1, 1}) == 12);
  CHECK(count({2, 0, 1}) == 4);
  CHECK(count({0, 0, 1}) == 1);
  CHECK(count({0, 0, 0}) == 0);
  CHECK(count({2, 1, 0}) == 4);
  double length = 0;
  for (const OverlayEdge& edge : edges) length += edge.line.length();
  CHECK(length == Approx(600));
}

TEST_CASE("marked edges know how far away they are, less the skin in which they are seen") {
  const View view = straightView();
  std::vector<OverlayEdge> edges;
  addEdges(boxAt({-1, 1, -3}, {0, 0, 2}), view, {.skinM = 0.5, .opacity = 0.25F, .shownHidden = false}, edges);
  REQUIRE(edges.size() == 1);
  CHECK(edges[0].opacity == 0.25F);
  CHECK_FALSE(edges[0].shownHidden);
  CHECK(edges[0].depths.x == Approx(view.windowDepth({-1, 1, -2.5})));
  CHECK(edges[0].depths.y == Approx(view.windowDepth({-1, 1, -0.5})));
}

TEST_CASE("edges that reach behind the viewer are left out") {
  Camera camera;
  camera.eye = {0, 1, 0};
  camera.target = {0, 1, -1};
  const Obb box = boxAt({-1, 0, -5}, {2, 2, 10});
  Bounds bounds;
  for (int i = 0; i < 8; ++i) bounds.add(box.corner(i));
  std::vector<OverlayEdge> edges;
  addEdges(box, View(camera, 800, 800, bounds), {}, edges);
  CHECK(edges.size() == 4);   // those of the far face
}
