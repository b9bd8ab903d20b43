#include "render/tone_regions.h"

#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace dimline {
namespace {

/// Whether a point lies in a region by the even-odd rule.
bool inside(const ToneRegion& region, const Vec2& p) {
  bool in = false;
  for (const auto& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
    }
  }
  return in;
}

double areaOf(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return std::abs(sum / 2);
}

TEST_CASE("an empty grid has no regions") {
  const ToneMap map = traceRegions(std::vector<std::uint32_t>(12, 0), 4, 3, 1.0);
  CHECK(map.regions.empty());
  CHECK(map.borders.empty());
}

TEST_CASE("a grid of one label is its own outline") {
  const ToneMap map = traceRegions(std::vector<std::uint32_t>(30 * 20, 7), 30, 20, 1.0);
  REQUIRE(map.regions.size() == 1);
  CHECK(map.regions[0].label == 7);
  REQUIRE(map.regions[0].rings.size() == 1);
  // Half a sample all round is within the tolerance.
  CHECK(areaOf(map.regions[0].rings[0]) == Approx(600).margin(50));
  CHECK(map.regions[0].rings[0].size() <= 8);
}

TEST_CASE("a hole is a ring of its own, and what fills it is a region") {
  std::vector<std::uint32_t> labels(40 * 40, 1);
  for (int y = 10; y < 30; ++y) {
    for (int x = 10; x < 30; ++x) labels[static_cast<std::size_t>(y * 40 + x)] = 2;
  }
  const ToneMap map = traceRegions(labels, 40, 40, 1.0);
  REQUIRE(map.regions.size() == 2);
  CHECK(map.regions[0].rings.size() == 2);
  CHECK(map.regions[1].rings.size() == 1);
  CHECK(inside(map.regions[0], {5, 5}));
  CHECK_FALSE(inside(map.regions[0], {20, 20}));
  CHECK(inside(map.regions[1], {20, 20}));
}

TEST_CASE("stairs become the straight line that they stand for") {
  // Everything right of the line x = 10 + 0.3 y.
  constexpr int kSize = 60;
  std::vector<std::uint32_t> labels;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) labels.push_back(x + 0.5 > 10 + 0.3 * (y + 0.5) ? 1 : 2);
  }
  const ToneMap map = traceRegions(labels, kSize, kSize, 1.0);
  int found = 0;
  for (const ToneBorder& border : map.borders) {
    if (border.leftLabel == 0 || border.rightLabel == 0) continue;
    ++found;
    CHECK(border.points.size() <= 4);
    for (const Vec2& p : border.points) CHECK(std::abs(p.x - (10 + 0.3 * p.y)) < 1.0);
  }
  CHECK(found == 1);
}

// The oracle: a point deep in a region's samples lies in that region's outline and in no other's.
TEST_CASE("outlines hold the samples that they were made from, and neighbours share their border") {
  test::Random random(37);
  for (int round = 0; round < 20; ++round) {
    constexpr int kWidth = 90, kHeight = 70;
    std::vector<std::uint32_t> labels(kWidth * kHeight, 0);
    for (int blob = 0; blob < 14; ++blob) {
      const Vec2 center(random.real(0, kWidth), random.real(0, kHeight));
      const double radius = random.real(3, 20);
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Vec2 d = Vec2(x + 0.5, y + 0.5) - center;
          if (d.x * d.x + 2 * d.y * d.y < radius * radius) {
            labels[static_cast<std::size_t>(y * kWidth + x)] = static_cast<std::uint32_t>(blob % 5);
          }
        }
      }
    }
    const ToneMap map = traceRegions(labels, kWidth, kHeight, 1.0);
    const auto at = [&](int x, int y) { return labels[static_cast<std::size_t>(y * kWidth + x)]; };
    int wrong = 0, deepOnes = 0;
    for (int y = 2; y < kHeight - 2; ++y) {
      for (int x = 2; x < kWidth - 2; ++x) {
        bool deep = true;
        for (int dy = -2; dy <= 2; ++dy) {
          for (int dx = -2; dx <= 2; ++dx) deep = deep && at(x + dx, y + dy) == at(x, y);
        }
        if (!deep) continue;
        ++deepOnes;
        for (const ToneRegion& region : map.regions) {
          if (inside(region, {x + 0.5, y + 0.5}) != (region.label == at(x, y))) ++wrong;
        }
      }
    }
    CHECK(wrong == 0);
    CHECK(deepOnes > 1000);

    // Each border belongs to two sides, so all outlines together use each of its points twice, save where one side is nothing.
    std::map<std::pair<double, double>, int> uses;
    for (const ToneRegion& region : map.regions) {
      for (const auto& ring : region.rings) {
        for (const Vec2& p : ring) ++uses[{p.x, p.y}];
      }
    }
    for (const ToneBorder& border : map.borders) {
      const int sides = (border.leftLabel != 0 ? 1 : 0) + (border.rightLabel != 0 ? 1 : 0);
      if (border.points.size() < 4) continue;  // too short a ring to be kept
      for (std::size_t i = 1; i + 1 < border.points.size(); ++i) {
        CHECK(uses[{border.points[i].x, border.points[i].y}] == sides);
      }
    }
  }
}

}  // namespace
}  // namespace dimline
