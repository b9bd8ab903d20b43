#include "silhouette/coverage_mask.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "silhouette/scene_shapes.h"

namespace dimline {
namespace {

Camera frontCamera(double heightM) {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = heightM;
  return camera;
}

TEST_CASE("a mask covers the pixels whose centres the model covers") {
  Scene scene;
  test::add(scene, test::boxMesh());  // 2 m wide; at 10 px a metre it covers x and y from 10 to 30
  const View view(frontCamera(4), 40, 40, scene.bounds);
  const CoverageMask mask = coverageMask(scene, view);
  REQUIRE(mask.widthPx == 40);
  REQUIRE(mask.heightPx == 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) REQUIRE(mask.covered(x, y) == (x >= 10 && x < 30 && y >= 10 && y < 30));
  }
  DistanceFields fields;
  fieldsFromMask(mask, fields);
  for (const ViewportEdge edge : kViewportEdges) {
    REQUIRE(fields[edge].at(9) == kNoSilhouette);
    REQUIRE(fields[edge].at(10) == 10);
    REQUIRE(fields[edge].at(29) == 10);
    REQUIRE(fields[edge].at(30) == kNoSilhouette);
    REQUIRE(fields[edge].least(1) == 10);
  }
}

TEST_CASE("left and top are where the picture has them") {
  Scene scene;
  // One triangle in the upper left quarter: its right angle at (5, 5), legs of 10 px.
  Mesh mesh;
  mesh.positions = {{-1.5F, 1.5F, 0}, {-1.5F, 0.5F, 0}, {-0.5F, 1.5F, 0}};
  mesh.triangles = {{0, 1, 2}};
  test::add(scene, mesh);
  const View view(frontCamera(4), 40, 40, scene.bounds);
  const CoverageMask mask = coverageMask(scene, view);
  REQUIRE(mask.covered(5, 5));
  REQUIRE(mask.covered(5, 13));
  REQUIRE(mask.covered(13, 5));
  REQUIRE_FALSE(mask.covered(10, 10));
  REQUIRE_FALSE(mask.covered(4, 5));
  REQUIRE_FALSE(mask.covered(35, 5));
  DistanceFields fields;
  fieldsFromMask(mask, fields);
  REQUIRE(fields[ViewportEdge::kLeft].at(5) == 5);
  REQUIRE(fields[ViewportEdge::kRight].at(5) >= 25);
  REQUIRE(fields[ViewportEdge::kRight].at(5) <= 26);
  REQUIRE(fields[ViewportEdge::kTop].at(13) == 5);
  REQUIRE(fields[ViewportEdge::kBottom].at(5) >= 25);
  REQUIRE(fields[ViewportEdge::kBottom].at(5) <= 26);
}

TEST_CASE("faces are seen from behind, too") {
  Scene scene;
  test::add(scene, test::sheetMesh(1, 0), test::placed(Vec3(0.0), {1, 0, 0}, -1.5707963267948966, Vec3(1.0)));
  const View view(frontCamera(4), 40, 40, scene.bounds);
  REQUIRE(coverageMask(scene, view).covered(20, 20));
}

TEST_CASE("the near plane cuts") {
  Scene scene;
  // A floor that runs from far behind the viewer to far ahead: it covers from the horizon down, and nothing above.
  test::add(scene, test::sheetMesh(1, 0), test::placed({0, -1, 0}, {0, 1, 0}, 0, {100, 1, 100}));
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  const View view(camera, 60, 40, scene.bounds);
  const CoverageMask mask = coverageMask(scene, view);
  for (int x = 0; x < 60; ++x) {
    REQUIRE(mask.covered(x, 39));
    REQUIRE(mask.covered(x, 25));
    REQUIRE_FALSE(mask.covered(x, 18));
    REQUIRE_FALSE(mask.covered(x, 0));
  }
}

TEST_CASE("a viewport of fractional size is rounded up") {
  Scene scene;
  test::add(scene, test::boxMesh());
  const View view(frontCamera(4), 39.4, 20.1, scene.bounds);
  const CoverageMask mask = coverageMask(scene, view);
  REQUIRE(mask.widthPx == 40);
  REQUIRE(mask.heightPx == 21);
  REQUIRE(mask.pixels.size() == 40 * 21);
}

}  // namespace
}  // namespace dimline
