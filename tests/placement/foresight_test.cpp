#include <catch2/catch.hpp>

#include <cmath>

#include "placement/foresight.h"

using namespace dimline;

namespace {

constexpr double kRadPerDeg = 0.017453292519943295;

/// A box 4 wide (x), 3 high and 2 deep (z) around the origin on the ground.
Bounds boxBounds() {
  Bounds bounds;
  bounds.add({-2, 0, -1});
  bounds.add({2, 3, 1});
  return bounds;
}

/// Its upright edge at the front right, with the planes of the two faces that meet there: number 0 is the front's, 1 the right side's.
BaseLine edge() {
  BaseLine line;
  line.segment = {{2, 0, 1}, {2, 3, 1}};
  line.scopePlanes.push_back({.across = {1, 0, 0}, .normal = {0, 0, 1}});
  line.scopePlanes.push_back({.across = {0, 0, 1}, .normal = {1, 0, 0}});
  return line;
}

/// From the front, turned to the right by an angle, level and orthographic.
View turnedBy(double deg) {
  Camera camera;
  camera.eye = {30 * std::sin(deg * kRadPerDeg), 1.5, 30 * std::cos(deg * kRadPerDeg)};
  camera.target = {0, 1.5, 0};
  camera.orthoHeightM = 10;
  return {camera, 1000, 1000, boxBounds()};
}

/// Whether a plane of the edge lasts for a line 1 m to the right of it, or in front of it, while the view turns from one angle to the other.
bool lasts(Slip slip, const std::vector<ObjectPlane>& objectPlanes, const Vec3& normal, const Vec3& towards, double fromDeg, double toDeg) {
  constexpr double kToleranceM = 1e-3;
  const View now = turnedBy(toDeg);
  Foresight foresight;
  foresight.begin(turnedBy(fromDeg), now, boxBounds(), objectPlanes, kToleranceM);
  std::vector<ObjectPlaneUse> uses;
  facePlanes(objectPlanes, now, uses);
  std::vector<SlipPlane> planes;
  slipPlanes(edge(), slip, now, {objectPlanes, uses, kToleranceM}, planes);
  for (const SlipPlane& plane : planes) {
    if (glm::dot(plane.plane.normal, normal) < 0.99) continue;
    return foresight.lasts(edge(), slip, plane, glm::dot(plane.across, towards) > 0 ? 1 : -1, 1.0);
  }
  FAIL("no such plane in this frame");
  return false;
}

const Vec3 kFront{0, 0, 1};
const Vec3 kRight{1, 0, 0};

}  // namespace

TEST_CASE("a plane that turns edge-on does not last; one that turns towards the viewer does") {
  // The front's plane is left out from 84 to 96 degrees: 20 degrees after 71 it is seen edge-on. Turning back, it is at 51.
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 70, 71));
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 72, 71));
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 60, 61));
  // A quick movement is followed as far as a slow one, and at least for one frame.
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 66, 71));
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 35, 60));
}

TEST_CASE("while the view does not turn, everything lasts") {
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 80, 80));
  Foresight foresight;
  foresight.begin(std::nullopt, turnedBy(80), boxBounds(), {}, 1e-3);
  SlipPlane none;
  none.number = 7;   // not one of the edge's
  CHECK(foresight.lasts(edge(), Slip::kScope, none, 1, 1.0));
}

TEST_CASE("the part of an object plane that a neighbour is about to cut off does not last") {
  std::vector<Segment> uprights;
  for (const double x : {-2.0, 2.0}) {
    for (const double z : {-1.0, 1.0}) uprights.push_back({{x, 0, z}, {x, 3, z}});
  }
  const auto planes = objectPlanes(uprights, boxBounds());
  // Seen straight from the front the right side is edge-on, and the front goes on past the corner; 20 degrees further right both are front planes, which clip each other.
  CHECK_FALSE(lasts(Slip::kObject, planes, kFront, kRight, -3, -2));
  // Turning left, the right side becomes a back plane, which does not.
  CHECK(lasts(Slip::kObject, planes, kFront, kRight, -1, -2));
  // To the left the front reaches 4 m, as far as its other corner, whatever the right side does.
  CHECK(lasts(Slip::kObject, planes, kFront, -kRight, -3, -2));
}
