#include "math/geometry.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace dimline {
namespace {

using test::Random;

TEST_CASE("bounds are empty until something is added") {
  Bounds bounds;
  REQUIRE(bounds.empty());
  REQUIRE(bounds.size() == Vec3(0.0));
  REQUIRE(bounds.diagonal() == 0);
  bounds.add({1, 2, 3});
  REQUIRE_FALSE(bounds.empty());
  REQUIRE(bounds.center() == Vec3(1, 2, 3));
  REQUIRE(bounds.diagonal() == 0);
  bounds.add({4, -2, 3});
  REQUIRE(bounds.min == Vec3(1, -2, 3));
  REQUIRE(bounds.max == Vec3(4, 2, 3));
  REQUIRE(bounds.diagonal() == 5);
  REQUIRE(bounds.corner(0) == bounds.min);
  REQUIRE(bounds.corner(7) == bounds.max);
  REQUIRE(bounds.corner(1) == Vec3(4, -2, 3));
}

TEST_CASE("an oriented box counts its corners along its axes") {
  // Turned by a quarter about y: its x runs along -z.
  const Obb box{.origin = {1, 2, 3}, .axes = {Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}, .size = {4, 5, 6}};
  REQUIRE(box.corner(0) == Vec3(1, 2, 3));
  REQUIRE(box.corner(1) == Vec3(1, 2, -1));
  REQUIRE(box.corner(2) == Vec3(1, 7, 3));
  REQUIRE(box.corner(4) == Vec3(7, 2, 3));
  REQUIRE(box.corner(7) == Vec3(7, 7, -1));
  REQUIRE(box.center() == Vec3(4, 4.5, 1));
}

TEST_CASE("boxes on screen overlap only by area") {
  const Box2 box{{0, 0}, {10, 10}};
  REQUIRE(Box2{}.empty());
  REQUIRE_FALSE(box.empty());
  REQUIRE(box.overlaps({{9, 9}, {20, 20}}));
  REQUIRE_FALSE(box.overlaps({{10, 0}, {20, 10}}));
  REQUIRE_FALSE(box.overlaps(Box2{}));
  REQUIRE(box.grown(2).min == Vec2(-2));
  REQUIRE(box.grown(2).max == Vec2(12));
  REQUIRE(box.center() == Vec2(5));
}

TEST_CASE("segments cross at inner points only") {
  const Segment2 a{{0, 0}, {10, 0}};
  REQUIRE(segmentsCross(a, {{5, -1}, {5, 1}}));
  REQUIRE(segmentsCross({{5, 1}, {5, -1}}, a));
  REQUIRE_FALSE(segmentsCross(a, {{5, 0}, {5, 1}}));     // ends on it
  REQUIRE_FALSE(segmentsCross(a, {{10, -1}, {10, 1}}));  // passes its end
  REQUIRE_FALSE(segmentsCross(a, {{2, 0}, {8, 0}}));     // along it
  REQUIRE_FALSE(segmentsCross(a, {{0, 1}, {10, 1}}));
  REQUIRE_FALSE(segmentsCross(a, {{11, -1}, {11, 1}}));
  REQUIRE_FALSE(segmentsCross(a, {{5, 0}, {5, 0}}));
}

TEST_CASE("distances on screen, by hand") {
  const Segment2 a{{0, 0}, {10, 0}};
  REQUIRE(distanceBetween(Vec2(5, 3), a) == 3);
  REQUIRE(distanceBetween(Vec2(13, 4), a) == 5);
  REQUIRE(distanceBetween(Vec2(-3, -4), a) == 5);
  REQUIRE(distanceBetween(Vec2(3, 4), Segment2{{0, 0}, {0, 0}}) == 5);
  REQUIRE(distanceBetween(a, Segment2{{5, -1}, {5, 1}}) == 0);
  REQUIRE(distanceBetween(a, Segment2{{5, 2}, {5, 8}}) == 2);
  REQUIRE(distanceBetween(a, Segment2{{13, 4}, {20, 9}}) == 5);
  REQUIRE(distanceBetween(a, Segment2{{2, 7}, {8, 7}}) == 7);
  REQUIRE(distanceBetween(a, Segment2{{10, 0}, {20, 0}}) == 0);
}

TEST_CASE("the distance between segments is the least between their points") {
  Random random(1);
  for (int round = 0; round < 400; ++round) {
    const auto segment = [&] { return Segment2{random.point(Vec2(0.0), Vec2(10)), random.point(Vec2(0.0), Vec2(10))}; };
    const Segment2 a = segment();
    const Segment2 b = segment();
    double least = 100;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j <= 60; ++j) {
        least = std::min(
            least, glm::length(a.start + (a.end - a.start) * (i / 60.0) - b.start - (b.end - b.start) * (j / 60.0)));
      }
    }
    REQUIRE(distanceBetween(a, b) <= least + 1e-12);
    REQUIRE(distanceBetween(a, b) >= least - 0.25);
    REQUIRE(distanceBetween(a, b) == Approx(distanceBetween(b, a)).margin(1e-12));
  }
}

TEST_CASE("a segment meets a box that it touches, crosses or lies in") {
  const Box2 box{{0, 0}, {10, 10}};
  REQUIRE(meets({{2, 2}, {3, 3}}, box));
  REQUIRE(meets({{-5, 5}, {15, 5}}, box));
  REQUIRE(meets({{-5, 10}, {15, 10}}, box));  // along its border
  REQUIRE(meets({{10, 5}, {20, 5}}, box));    // ends on its border
  REQUIRE(meets({{-1, 1}, {1, -1}}, box));    // through its corner
  REQUIRE_FALSE(meets({{-1, 0.5}, {0.5, -1}}, box));
  REQUIRE_FALSE(meets({{11, 5}, {20, 5}}, box));
  REQUIRE_FALSE(meets({{5, 11}, {5, 20}}, box));
  REQUIRE_FALSE(meets({{-5, 8}, {8, 21}}, box));
  REQUIRE(meets({{5, 5}, {5, 5}}, box));
  REQUIRE_FALSE(meets({{5, 15}, {5, 15}}, box));
}

TEST_CASE("a segment meets a box when some point of it lies in there") {
  Random random(2);
  const Box2 box{{3, 4}, {7, 6}};
  int met = 0;
  for (int round = 0; round < 2000; ++round) {
    const Segment2 segment{random.point(Vec2(0.0), Vec2(10)), random.point(Vec2(0.0), Vec2(10))};
    bool inside = false;
    for (int i = 0; i <= 500 && !inside; ++i) {
      const Vec2 p = segment.start + (segment.end - segment.start) * (i / 500.0);
      inside = p == glm::clamp(p, box.min, box.max);
    }
    if (inside) REQUIRE(meets(segment, box));
    if (!meets(segment, box)) REQUIRE_FALSE(inside);
    if (meets(segment, box)) {
      ++met;
      REQUIRE(meets(segment, box.grown(-0.02)) <= inside);
    }
  }
  REQUIRE(met > 400);
}

}  // namespace
}  // namespace dimline
