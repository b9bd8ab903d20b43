#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "placement/object_planes.h"

using namespace dimline;

namespace {

/// The four upright edges of a box 4 wide (x), 3 high and 2 deep (z) around the origin on the ground.
std::vector<Segment> uprights() {
  std::vector<Segment> lines;
  for (const double x : {-2.0, 2.0}) {
    for (const double z : {-1.0, 1.0}) lines.push_back({{x, 0, z}, {x, 3, z}});
  }
  return lines;
}

Bounds boxBounds() {
  Bounds bounds;
  bounds.add({-2, 0, -1});
  bounds.add({2, 3, 1});
  return bounds;
}

std::size_t numberOf(const std::vector<ObjectPlane>& planes, const Vec3& normal) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (glm::length(planes[i].plane.normal - normal) < 1e-9) return i;
  }
  FAIL("no plane with that normal");
  return 0;
}

View lookFrom(const Vec3& eye) {
  Camera camera;
  camera.eye = eye;
  camera.target = {0, 1.5, 0};
  return {camera, 1000, 1000, boxBounds()};
}

}  // namespace

TEST_CASE("the hull of a box's base lines, extruded, is the box: four sides and two caps, outward") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  REQUIRE(planes.size() == 6);
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    const ObjectPlane& p = planes[numberOf(planes, normal)];
    const Vec3 half{2, 1.5, 1};
    CHECK(glm::dot(p.plane.point - Vec3(0, 1.5, 0), normal) == Approx(glm::dot(half, glm::abs(normal))));
  }
}

TEST_CASE("the hull of an L on the ground has five sides: it goes straight across the notch") {
  std::vector<Segment> lines;
  for (const Vec2 corner : {Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)}) lines.push_back({{corner.x, 0, corner.y}, {corner.x, 3, corner.y}});
  const auto planes = objectPlanes(lines, Bounds{{0, 0, 0}, {4, 3, 4}});
  REQUIRE(planes.size() == 7);   // and two caps
  const ObjectPlane& across = planes[numberOf(planes, glm::normalize(Vec3(1, 0, 1)))];
  CHECK(glm::dot(across.plane.point, across.plane.normal) == Approx(5 * std::sqrt(0.5)));
}

TEST_CASE("base lines on one line on the ground give no planes") {
  const std::vector<Segment> line{{{0, 0, 0}, {0, 3, 0}}, {{2, 0, 0}, {2, 3, 0}}};
  CHECK(objectPlanes(line, boxBounds()).empty());
}

TEST_CASE("planes towards the viewer are front, those away back, and those edge-on are left out") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  std::vector<ObjectPlaneUse> uses;
  facePlanes(planes, lookFrom({20, 12, 30}), uses);
  CHECK(uses[numberOf(planes, {1, 0, 0})] == ObjectPlaneUse::kFront);
  CHECK(uses[numberOf(planes, {0, 0, 1})] == ObjectPlaneUse::kFront);
  CHECK(uses[numberOf(planes, {0, 1, 0})] == ObjectPlaneUse::kFront);
  CHECK(uses[numberOf(planes, {-1, 0, 0})] == ObjectPlaneUse::kBack);
  facePlanes(planes, lookFrom({0, 1.5, 400}), uses);
  CHECK(uses[numberOf(planes, {0, 0, 1})] == ObjectPlaneUse::kFront);
  CHECK(uses[numberOf(planes, {1, 0, 0})] == ObjectPlaneUse::kLeftOut);
  CHECK(uses[numberOf(planes, {0, 1, 0})] == ObjectPlaneUse::kLeftOut);
}

TEST_CASE("a plane is left out while it is within 0.1 rad of edge-on") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  const auto useAt = [&](double rad) {
    Camera camera;
    camera.target = {0, 1.5, 0};
    camera.eye = camera.target + 30.0 * Vec3(std::sin(rad), 0, std::cos(rad));
    camera.orthoHeightM = 10;
    std::vector<ObjectPlaneUse> uses;
    facePlanes(planes, View(camera, 1000, 1000, boxBounds()), uses);
    return uses[numberOf(planes, {1, 0, 0})];
  };
  CHECK(useAt(0.101) == ObjectPlaneUse::kFront);
  CHECK(useAt(0.099) == ObjectPlaneUse::kLeftOut);
  CHECK(useAt(-0.099) == ObjectPlaneUse::kLeftOut);
  CHECK(useAt(-0.101) == ObjectPlaneUse::kBack);
}

TEST_CASE("a back plane ends at its back neighbour, and its front neighbour leaves it alone") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  std::vector<ObjectPlaneUse> uses;
  facePlanes(planes, lookFrom({20, 1.5, 30}), uses);   // back: -x and -z
  const Segment middle{{0, 0, -1}, {0, 3, -1}};
  const OffsetRange range = offsetsWithin(planes, uses, numberOf(planes, {0, 0, -1}), middle, {1, 0, 0}, 0);
  CHECK(range.lowM == Approx(-2.0));
  CHECK(range.highM == std::numeric_limits<double>::infinity());
}

TEST_CASE("a front plane ends at its front neighbour and goes on past its free side") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  std::vector<ObjectPlaneUse> uses;
  facePlanes(planes, lookFrom({20, 1.5, 30}), uses);   // front: +x and +z; the caps are edge-on
  const std::size_t front = numberOf(planes, {0, 0, 1});
  // An upright line in the middle of the +z face, moved along +x: it may go to x = 2, where the +x face stands, and any way to the left.
  const Segment middle{{0, 0, 1}, {0, 3, 1}};
  const OffsetRange range = offsetsWithin(planes, uses, front, middle, {1, 0, 0}, 0);
  CHECK(range.highM == Approx(2.0));
  CHECK(range.lowM == -std::numeric_limits<double>::infinity());
}

TEST_CASE("a line that no offset brings inside its group's part has an empty range") {
  const auto planes = objectPlanes(uprights(), boxBounds());
  std::vector<ObjectPlaneUse> uses;
  facePlanes(planes, lookFrom({20, 1.5, 30}), uses);
  const std::size_t front = numberOf(planes, {0, 0, 1});
  const Segment tooFarRight{{1, 0, 1}, {3, 0, 1}};   // moved up and down it always sticks out past x = 2
  const OffsetRange range = offsetsWithin(planes, uses, front, tooFarRight, {0, 1, 0}, 0);
  CHECK(range.lowM > range.highM);
}
