#include <catch2/catch.hpp>

#include "placement/base_lines.h"
#include "placement/slip_planes.h"

using namespace dimline;

namespace {

// A box 4 wide, 3 high and 2 deep, turned a quarter about y: its x axis is the world's -z, its z axis the world's +x.
Obb turnedBox() {
  return {.origin = {10, 0, 5}, .axes = {Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}, .size = {4, 3, 2}};
}

Annotation annotated(HandleType type, Orient orient, Slip slip = Slip::kScope) {
  Annotation a;
  a.scope = "Box";
  a.type = type;
  a.orient = orient;
  a.slip = slip;
  return a;
}

View frontView(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  Bounds bounds;
  bounds.add({-20, -20, -20});
  bounds.add({20, 20, 20});
  return {camera, 1000, 1000, bounds};
}

}  // namespace

TEST_CASE("linear-contour lies on the four edges along its axis") {
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), turnedBox());
  REQUIRE(lines.size() == 4);
  for (const BaseLine& line : lines) {
    CHECK(line.segment.end - line.segment.start == Vec3(0, 3, 0));
    CHECK(line.segment.start.y == 0);
  }
  // The other axes are z (world +x) and x (world -z), in that order; bit 0 is the side along the first.
  CHECK(lines[0].segment.start == Vec3(10, 0, 5));
  CHECK(lines[1].segment.start == Vec3(12, 0, 5));
  CHECK(lines[2].segment.start == Vec3(10, 0, 1));
  CHECK(lines[3].segment.start == Vec3(12, 0, 1));
}

TEST_CASE("an orientation against the axis turns the line round: its moving end is the other one") {
  const BaseLines up = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), turnedBox());
  const BaseLines down = baseLines(annotated(HandleType::kLinearContour, Orient::kDown), turnedBox());
  REQUIRE(down.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(down[i].segment.start == up[i].segment.end);
    CHECK(down[i].segment.end == up[i].segment.start);
  }
}

TEST_CASE("left and right run along the scope's x, front and back along its z") {
  const BaseLines right = baseLines(annotated(HandleType::kLinearContour, Orient::kRight), turnedBox());
  CHECK(right[0].segment.end - right[0].segment.start == Vec3(0, 0, -4));
  const BaseLines back = baseLines(annotated(HandleType::kLinearContour, Orient::kBack), turnedBox());
  CHECK(back[0].segment.end - back[0].segment.start == Vec3(-2, 0, 0));
}

TEST_CASE("linear-center is one line through the middle") {
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kRight), turnedBox());
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].segment.start == Vec3(11, 1.5, 5));
  CHECK(lines[0].segment.end == Vec3(11, 1.5, 1));
}

TEST_CASE("translate moves base lines in sizes of the scope") {
  Annotation a = annotated(HandleType::kLinearCenter, Orient::kUp);
  a.translate = {0.5, 1.0, 0.0};
  const BaseLines lines = baseLines(a, turnedBox());
  CHECK(lines[0].segment.start == Vec3(11, 3, 1));
}

TEST_CASE("meanLength is the mean over a scope's base lines") {
  CHECK(meanLength(baseLines(annotated(HandleType::kLinearContour, Orient::kFront), turnedBox())) == Approx(2.0));
  CHECK(meanLength(BaseLines{}) == 0.0);
}

TEST_CASE("scope planes lie in the faces at the line's edge, with those faces' outward normals") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({6, 5, 9}, {0, 0, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), box);
  // Other axes of y: z, then x. Edge 3 is at z = +1, x = +1, the one nearest to this viewer: both its faces look at the viewer.
  const SlipPlanes near = slipPlanes(lines[3], box, Slip::kScope, view);
  REQUIRE(near.size() == 2);
  CHECK(near[0].across == Vec3(0, 0, 1));
  CHECK(near[0].plane.normal == Vec3(1, 0, 0));
  CHECK(near[0].facing == Facing::kFront);
  CHECK(near[1].across == Vec3(1, 0, 0));
  CHECK(near[1].plane.normal == Vec3(0, 0, 1));
  CHECK(near[1].facing == Facing::kFront);
  // Edge 0 is at z = -1, x = -1: both faces look away.
  for (const SlipPlane& plane : slipPlanes(lines[0], box, Slip::kScope, view)) CHECK(plane.facing == Facing::kBack);
}

TEST_CASE("a scope plane through the middle looks towards the viewer") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box);
  for (const double side : {1.0, -1.0}) {
    const View view = frontView({6 * side, 5, 9 * side}, {0, 0, 0});
    for (const SlipPlane& plane : slipPlanes(lines[0], box, Slip::kScope, view)) {
      CHECK(glm::dot(plane.plane.normal, view.camera().eye) > 0);
      CHECK(plane.facing == Facing::kFront);
    }
  }
}

TEST_CASE("planes seen edge-on are left out") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({0, 0, 50}, {0, 0, 0});   // straight at the front: the side faces are edge-on
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), box);
  const SlipPlanes planes = slipPlanes(lines[3], box, Slip::kScope, view);
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].plane.normal == Vec3(0, 0, 1));
}

TEST_CASE("a billboard plane holds the line and is as square to the view as that allows") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({6, 5, 9}, {0, 0, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box);
  const SlipPlanes planes = slipPlanes(lines[0], box, Slip::kBillboard, view);
  REQUIRE(planes.size() == 1);
  CHECK(glm::dot(planes[0].plane.normal, Vec3(0, 1, 0)) == Approx(0.0).margin(1e-12));
  CHECK(glm::dot(planes[0].across, Vec3(0, 1, 0)) == Approx(0.0).margin(1e-12));
  // The view direction at the middle of the line, with its part along the line taken away, is the normal's line.
  const Vec3 expected = glm::normalize(Vec3(6, 0, 9));
  CHECK(glm::length(planes[0].plane.normal - expected) == Approx(0.0).margin(1e-12));
  CHECK(planes[0].facing == Facing::kFront);
}

TEST_CASE("slip none has no plane") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box);
  CHECK(slipPlanes(lines[0], box, Slip::kNone, frontView({6, 5, 9}, {0, 0, 0})).empty());
}
