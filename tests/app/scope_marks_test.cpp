#include "app/scope_marks.h"

#include <catch2/catch.hpp>

#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

double lengthOf(const std::vector<OverlayEdge>& edges, bool behind) {
  double length = 0;
  for (const OverlayEdge& edge : edges) length += edge.behind == behind ? edge.line.length() : 0.0;
  return length;
}

/// A wall of 4 by 4 m, 1 m thick, and a camera straight before it: 100 px a metre.
struct Wall {
  Scene scene;
  View view;
  Wall() {
    addBox(scene, boxAt({-2, 0, -1}, {4, 4, 1}));
    finish(scene);
    Camera camera;
    camera.eye = {0, 2, 20};
    camera.target = {0, 2, 0};
    camera.orthoHeightM = 8;
    view = View(camera, 800, 800, scene.bounds);
  }
};

}  // namespace

TEST_CASE("edges on a wall are seen, and those behind it hidden") {
  const Wall wall;
  ScopeMarks marks;
  marks.begin(wall.scene, wall.view, 0);
  std::vector<OverlayEdge> edges;
  marks.add(boxAt({-1, 1, 0}, {2, 1, 0}), 1, true, edges);  // a flat box in the wall's face: each edge once
  REQUIRE(edges.size() == 4);
  REQUIRE(lengthOf(edges, false) == Approx(600));
  REQUIRE(lengthOf(edges, true) == 0);

  edges.clear();
  marks.add(boxAt({-1, 1, -3}, {2, 1, 1}), 1, true, edges);
  REQUIRE(lengthOf(edges, false) == 0);
  REQUIRE(lengthOf(edges, true) == Approx(1200));
  edges.clear();
  marks.add(boxAt({-1, 1, -3}, {2, 1, 1}), 1, false, edges);
  REQUIRE(edges.empty());
}

TEST_CASE("an edge that comes out from behind the model changes there") {
  const Wall wall;
  ScopeMarks marks;
  marks.begin(wall.scene, wall.view, 0);
  std::vector<OverlayEdge> edges;
  marks.add(boxAt({0, 1, -5}, {3.5, 0, 0}), 0.5F, true, edges);
  REQUIRE(edges.size() == 2);
  REQUIRE(edges[0].behind);
  REQUIRE(edges[0].line.end.x == Approx(600).margin(6));
  REQUIRE_FALSE(edges[1].behind);
  REQUIRE(edges[1].line.end.x == Approx(750));
  REQUIRE(edges[1].opacity == 0.5F);
}

TEST_CASE("when the model has changed, so has what it hides, a little later") {
  Wall wall;
  ScopeMarks marks;
  marks.begin(wall.scene, wall.view, 0);
  addBox(wall.scene, boxAt({-3, 0, 1}, {6, 6, 1}));
  finish(wall.scene);
  marks.sceneChanged();
  std::vector<OverlayEdge> edges;
  marks.begin(wall.scene, wall.view, 20);  // too soon to look again
  marks.add(boxAt({-1, 1, 0}, {2, 1, 0}), 1, true, edges);
  REQUIRE(lengthOf(edges, true) == 0);
  edges.clear();
  marks.begin(wall.scene, wall.view, 400);
  marks.add(boxAt({-1, 1, 0}, {2, 1, 0}), 1, true, edges);
  REQUIRE(lengthOf(edges, false) == 0);
}
