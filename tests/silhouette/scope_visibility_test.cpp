#include <catch2/catch.hpp>

#include "silhouette/scope_visibility.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// A wall 10 wide and 6 high in the plane z = 0, and scopes before it, behind it, and in its face.
Scene wallWithScopes() {
  Scene scene;
  addBox(scene, boxAt({-5, 0, -0.3}, {10, 6, 0.3}));
  scene.scopes.push_back({"Before", 0, boxAt({-1, 1, 1}, {2, 2, 1})});
  scene.scopes.push_back({"Behind", 0, boxAt({-1, 1, -3}, {2, 2, 1})});
  scene.scopes.push_back({"InFace", 0, boxAt({-1, 1, -0.2}, {1, 1, 0.2})});
  scene.scopes.push_back({"HalfBehind", 0, boxAt({4, 1, -3}, {2, 2, 1})});
  scene.scopes.push_back({"Tiny", 0, boxAt({2, 3, 0.1}, {1e-4, 1e-4, 1e-4})});
  scene.scopes.push_back({"BehindTheViewer", 0, boxAt({0, 1, 60}, {2, 2, 2})});
  scene.scopes.push_back({"SmallHalfBehind", 0, boxAt({4.75, 1, -2.5}, {0.5, 0.5, 0.5})});
  finish(scene);
  return scene;
}

}  // namespace

TEST_CASE("scopes before the model and in its faces are seen, scopes behind it are not") {
  const Scene scene = wallWithScopes();
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.eye = {0, 3, 40};
    camera.target = {0, 3, 0};
    if (orthographic) camera.orthoHeightM = 20;
    ScopeVisibility visibility;
    CpuVisibility().measure(scene, View(camera, 1000, 1000, scene.bounds), visibility);
    INFO((orthographic ? "orthographic" : "perspective"));
    REQUIRE(visibility.seenShare.size() == scene.scopes.size());
    CHECK(visibility.seenShare[0] == 1.0F);
    CHECK(visibility.seenShare[1] == 0.0F);
    CHECK(visibility.seenShare[2] == 1.0F);
    // It stands out beside the wall by half (by 3/8 in perspective): far more than needed, and more of plenty than of its own area.
    CHECK(visibility.seenShare[3] > 0.6F);
    // A small one is judged by its own area. The wall ends at x = 5; in perspective it hides what is 2 m further back up to x = 5 * 42 / 40 = 5.25.
    CHECK(visibility.seenShare[6] == Approx(orthographic ? 0.5 : 0.0).margin(0.06));
    CHECK(visibility.seenShare[4] == 1.0F);
    CHECK(visibility.seenShare[5] == 0.0F);
  }
}

namespace {

/// The edges of a scope by axis and number that are seen.
std::vector<std::pair<int, int>> seenEdges(SeenEdges edges) {
  std::vector<std::pair<int, int>> seen;
  for (int axis = 0; axis < 3; ++axis) {
    for (int number = 0; number < 4; ++number) {
      if (edges.has(axis, number)) seen.emplace_back(axis, number);
    }
  }
  return seen;
}

using Edges = std::vector<std::pair<int, int>>;

}  // namespace

TEST_CASE("of a scope's edges those are seen of which half is not behind the model") {
  // A house 10 wide, 6 high and 8 deep. Its plinth is a scope one metre high; the ground before it is one, and a mast behind it.
  Scene scene;
  addBox(scene, boxAt({-5, 0, -4}, {10, 6, 8}));
  scene.scopes.push_back({"Plinth", 0, boxAt({-5, 0, -4}, {10, 1, 8})});
  scene.scopes.push_back({"Yard", 0, boxAt({-5, 0, 6}, {10, 0.5, 2})});
  scene.scopes.push_back({"Mast", 0, boxAt({-0.5, 1, -5}, {1, 8, 0.5})});
  finish(scene);
  for (const bool orthographic : {false, true}) {
    // From the front, above, and the right.
    Camera camera;
    camera.eye = {20, 15, 40};
    camera.target = {0, 3, 0};
    if (orthographic) camera.orthoHeightM = 20;
    ScopeVisibility visibility;
    CpuVisibility().measure(scene, View(camera, 1000, 1000, scene.bounds), visibility);
    INFO((orthographic ? "orthographic" : "perspective"));
    REQUIRE(visibility.seenEdges.size() == scene.scopes.size());
    // Along x: number 1 on the far side along y, 2 along z; along y: 1 along z, 2 along x; along z: 1 along x, 2 along y. The walls stand on the plinth, so of its upper edges the
    // two at the back are hidden, though its upper side looks to the viewer.
    CHECK(seenEdges(visibility.seenEdges[0]) == Edges{{0, 2}, {0, 3}, {1, 1}, {1, 2}, {1, 3}, {2, 1}, {2, 3}});
    // A scope hides nothing of itself.
    CHECK(seenEdges(visibility.seenEdges[1]).size() == SeenEdges::kCount);
    // Of the mast's edges the upper ones stand out above the roof, and of those along y less than half.
    CHECK(seenEdges(visibility.seenEdges[2]) == Edges{{0, 1}, {0, 3}, {2, 2}, {2, 3}});
  }
}

TEST_CASE("from the other side it is the other way round") {
  const Scene scene = wallWithScopes();
  Camera camera;
  camera.eye = {0, 3, -40};
  camera.target = {0, 3, 0};
  ScopeVisibility visibility;
  CpuVisibility().measure(scene, View(camera, 1000, 1000, scene.bounds), visibility);
  CHECK(visibility.seenShare[0] == 0.0F);
  CHECK(visibility.seenShare[1] == 1.0F);
}

TEST_CASE("a depth buffer holds the nearest of what was drawn") {
  Scene scene;
  addBox(scene, boxAt({-2, -2, -1}, {4, 4, 1}));
  finish(scene);
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = 8;
  const View view(camera, 200, 100, scene.bounds);
  DepthBuffer depth;
  depth.reset(view, 100);
  CHECK(depth.width() == 100);
  CHECK(depth.height() == 50);
  depth.reset(view, 1000);   // never finer than the viewport
  CHECK(depth.width() == 200);
  CHECK(depth.height() == 100);
  depth.draw(scene);
  const Vec4 front = view.viewProjection() * Vec4(0, 0, 0, 1);
  CHECK(static_cast<double>(depth.at(100, 50)) == Approx(front.z / front.w));
  CHECK(depth.at(0, 0) == 1.0F);
  int covered = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) covered += depth.at(x, y) < 1.0F ? 1 : 0;
  }
  CHECK(covered == 50 * 50);   // 4 m of 8 m, in 100 rows
}
