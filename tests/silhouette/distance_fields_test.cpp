#include "silhouette/distance_fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace dimline {
namespace {

using test::Random;

/// Whether a segment clears the silhouette towards some edge.
bool clearsSomewhere(const DistanceFields& fields, const Segment2& segment) {
  return std::ranges::any_of(kViewportEdges, [&](ViewportEdge edge) { return clears(fields, edge, segment); });
}

/// A field with empty strips, stretches that vary slowly, and single outliers.
void fillRandom(DistanceField& field, double extentPx, Random& random) {
  const std::span<float> values = field.edit();
  double value = random.real(0, extentPx);
  bool empty = false;
  for (float& out : values) {
    if (random.chance(0.02)) empty = !empty;
    if (random.chance(0.03)) value = random.real(0, extentPx);
    value = std::clamp(value + random.real(-2, 2), 0.0, extentPx);
    out = empty ? kNoSilhouette : static_cast<float>(value);
  }
}

DistanceFields randomFields(int width, int height, Random& random) {
  DistanceFields fields;
  fields.reset(width, height);
  for (const ViewportEdge edge : kViewportEdges) fillRandom(fields[edge], fields.extentPx(edge), random);
  fields.buildTrees();
  return fields;
}

/// Whether a field blocks a point, as the header's sketch has it. On the border between two strips, either.
bool blocks(const DistanceFields& fields, ViewportEdge edge, const Vec2& p) {
  const bool rows = edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight;
  const double along = rows ? p.y : p.x;
  if (along < 0 || along >= static_cast<double>(fields[edge].size())) return false;
  const double value = fields[edge].at(static_cast<std::size_t>(along));
  switch (edge) {
    case ViewportEdge::kLeft:
      return p.x > value;
    case ViewportEdge::kRight:
      return p.x < fields.widthPx - value;
    case ViewportEdge::kTop:
      return p.y > value;
    case ViewportEdge::kBottom:
      return p.y < fields.heightPx - value;
  }
  return false;
}

TEST_CASE("a field that was reset is empty, tree and all") {
  DistanceField field;
  for (const std::size_t size : {1, 2, 3, 64, 65, 1000, 7}) {
    field.reset(size);
    REQUIRE(field.size() == size);
    REQUIRE(field.leafCount() * DistanceField::kBlockStrips >= size);
    REQUIRE(field.min(0, size - 1) == kNoSilhouette);
    REQUIRE(field.greatestOfBlocks(0, size - 1) == kNoSilhouette);
    field.edit()[size / 2] = 3;
    field.buildTree();
    REQUIRE(field.least(1) == 3);
  }
}

TEST_CASE("the least over any range, by hand") {
  DistanceField field;
  field.reset(5);
  const std::vector<float> values{4, 2, 9, kNoSilhouette, 7};
  std::copy(values.begin(), values.end(), field.edit().begin());
  field.buildTree();
  REQUIRE(field.min(0, 4) == 2);
  REQUIRE(field.greatestOfBlocks(0, 2) == kNoSilhouette);
  REQUIRE(field.min(2, 2) == 9);
  REQUIRE(field.min(2, 4) == 7);
  REQUIRE(field.min(3, 3) == kNoSilhouette);
}

TEST_CASE("the least over any range, and the greatest over its blocks, equal a scan") {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    DistanceField field;
    field.reset(static_cast<std::size_t>(random.whole(1, 300)));
    fillRandom(field, 500, random);
    field.buildTree();
    for (int query = 0; query < 50; ++query) {
      const auto first = static_cast<std::size_t>(random.whole(0, static_cast<int>(field.size()) - 1));
      const auto last =
          static_cast<std::size_t>(random.whole(static_cast<int>(first), static_cast<int>(field.size()) - 1));
      const auto range = field.values().subspan(first, last - first + 1);
      REQUIRE(field.min(first, last) == *std::min_element(range.begin(), range.end()));
      constexpr std::size_t kBlock = DistanceField::kBlockStrips;
      const std::size_t begin = first - first % kBlock, end = last - last % kBlock + kBlock;
      const auto blocks = field.values().subspan(begin, std::min(end, field.size()) - begin);
      const float greatest = end > field.size() ? kNoSilhouette : *std::max_element(blocks.begin(), blocks.end());
      REQUIRE(field.greatestOfBlocks(first, last) == greatest);
    }
  }
}

TEST_CASE("pulling strips in mends the tree exactly as building it anew") {
  Random random(2);
  for (int round = 0; round < 300; ++round) {
    DistanceField mended;
    mended.reset(static_cast<std::size_t>(random.whole(1, 200)));
    fillRandom(mended, 100, random);
    mended.buildTree();
    DistanceField built = mended;
    const auto first = static_cast<std::size_t>(random.whole(0, 210));
    const auto last = static_cast<std::size_t>(random.whole(0, 220));
    for (DistanceField* field : {&mended, &built}) {
      for (std::size_t i = first; i <= last && i < built.size(); ++i) field->edit()[i] = std::min(built.at(i), 10.0F + static_cast<float>(i % 7));
    }
    mended.mendTree(first, last);
    built.buildTree();
    for (std::size_t i = 0; i < built.size(); ++i) REQUIRE(mended.at(i) == built.at(i));
    for (std::size_t i = 1; i < 2 * built.leafCount(); ++i) {
      REQUIRE(mended.least(i) == built.least(i));
      REQUIRE(mended.greatest(i) == built.greatest(i));
    }
  }
}

TEST_CASE("padding a single strip gives a disc swept over its height") {
  DistanceFields fields;
  fields.reset(100, 40);
  fields[ViewportEdge::kLeft].edit()[20] = 50;
  fields.buildTrees();
  DistanceFields padded;
  pad(fields, 5, padded);
  const DistanceField& left = padded[ViewportEdge::kLeft];
  REQUIRE(left.at(20) == 45);
  REQUIRE(left.at(19) == 45);  // the next strips touch the blocked one
  REQUIRE(left.at(21) == 45);
  REQUIRE(left.at(24) == Approx(50 - 4));  // 3 px away: 4 remain of the radius
  REQUIRE(left.at(16) == Approx(50 - 4));
  REQUIRE(left.at(25) == Approx(50 - 3));
  REQUIRE(left.at(26) == kNoSilhouette);  // 5 px away at the least: touched in no more than its border
  REQUIRE(left.at(14) == kNoSilhouette);
  REQUIRE(padded[ViewportEdge::kTop].least(1) == kNoSilhouette);
  REQUIRE(left.least(1) == 45);
}

TEST_CASE("padding equals its definition on random fields") {
  Random random(3);
  DistanceFields padded;
  for (const double radius : {0.0, 0.5, 1.0, 4.0, 7.25, 30.0, 300.0}) {
    const DistanceFields fields = randomFields(random.whole(1, 250), random.whole(1, 250), random);
    pad(fields, radius, padded);
    for (const ViewportEdge edge : kViewportEdges) {
      const std::span<const float> values = fields[edge].values();
      float least = kNoSilhouette;
      for (std::size_t i = 0; i < values.size(); ++i) {
        double expected = kNoSilhouette;
        for (std::size_t j = 0; j < values.size(); ++j) {
          const double gap = std::max(0.0, std::abs(static_cast<double>(i) - static_cast<double>(j)) - 1);
          if (i == j || gap < radius) expected = std::min(expected, values[j] - std::sqrt(radius * radius - gap * gap));
        }
        REQUIRE(padded[edge].at(i) == Approx(expected).margin(1e-3));
        least = std::min(least, padded[edge].at(i));
      }
      REQUIRE(padded[edge].least(1) == least);
    }
  }
}

TEST_CASE("a point that clears a padded field keeps the distance from all that the field blocks") {
  Random random(4);
  DistanceFields padded;
  int cleared = 0;
  for (int round = 0; round < 20; ++round) {
    const DistanceFields fields = randomFields(120, 90, random);
    const double radius = random.real(2, 20);
    pad(fields, radius, padded);
    for (int trial = 0; trial < 40; ++trial) {
      const Vec2 p = random.point(Vec2(0.0), Vec2(120, 90));
      for (const ViewportEdge edge : kViewportEdges) {
        if (blocks(padded, edge, p)) continue;
        ++cleared;
        for (int i = 0; i < 64; ++i) {
          const double angle = i * 0.0981747704;
          const Vec2 near = p + Vec2(std::cos(angle), std::sin(angle)) * (radius * random.real(0.1, 0.9999));
          REQUIRE_FALSE((near.x >= 0 && near.x < 120 && near.y >= 0 && near.y < 90 && blocks(fields, edge, near)));
        }
      }
    }
  }
  REQUIRE(cleared > 100);
}

/// Holds fields that were empty before to a shape, given as the distance of a point from it less its radius: no point
/// of the shape that is in the viewport is farther in than the field says, and what the field says is the place of
/// some such point of the strip. Points within `skinPx` of its rim need not count.
template <typename OutsideBy>
void requireExtremes(const DistanceFields& fields, OutsideBy outsideBy, double skinPx = 1e-9) {
  constexpr int kPerPixel = 8;
  constexpr int kAlong = 32;
  const auto pointOf = [&](ViewportEdge edge, double along, double away) {
    switch (edge) {
      case ViewportEdge::kLeft:
        return Vec2(away, along);
      case ViewportEdge::kRight:
        return Vec2(fields.widthPx - away, along);
      case ViewportEdge::kTop:
        return Vec2(along, away);
      case ViewportEdge::kBottom:
        return Vec2(along, fields.heightPx - away);
    }
    return Vec2(0.0);
  };
  for (const ViewportEdge edge : kViewportEdges) {
    for (std::size_t strip = 0; strip < fields[edge].size(); ++strip) {
      const double value = fields[edge].at(strip);
      INFO("edge " << static_cast<int>(edge) << " strip " << strip << " value " << value);
      const bool empty = fields[edge].at(strip) == kNoSilhouette;
      double first = kNoSilhouette;
      double nearest = kNoSilhouette;
      for (int i = 0; i <= kAlong; ++i) {
        const double along = static_cast<double>(strip) + static_cast<double>(i) / kAlong;
        for (int j = 0; j <= fields.extentPx(edge) * kPerPixel && j < first * kPerPixel; ++j) {
          const double away = static_cast<double>(j) / kPerPixel;
          if (outsideBy(pointOf(edge, along, away)) <= -skinPx) first = away;
        }
        if (!empty) nearest = std::min(nearest, outsideBy(pointOf(edge, along, value)));
      }
      REQUIRE(value <= first + 1e-4);
      if (!empty) REQUIRE(nearest <= 1e-3);
    }
  }
}

TEST_CASE("a thick line pulls the fields in to its outline") {
  DistanceFields fields;
  fields.reset(100, 60);
  fields.buildTrees();
  pullIn(fields, Segment2{{30, 20}, {70, 20}}, 5);
  REQUIRE(fields[ViewportEdge::kTop].at(50) == 15);
  REQUIRE(fields[ViewportEdge::kBottom].at(50) == 35);
  REQUIRE(fields[ViewportEdge::kLeft].at(19) == 25);  // strips 19 and 20 meet at the line's own height
  REQUIRE(fields[ViewportEdge::kLeft].at(20) == 25);
  REQUIRE(fields[ViewportEdge::kRight].at(20) == 25);
  REQUIRE(fields[ViewportEdge::kLeft].at(23) == Approx(30 - 4));  // its nearest place is 3 px off
  REQUIRE(fields[ViewportEdge::kLeft].at(14) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kLeft].at(25) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kTop].at(24) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kTop].at(25) == Approx(20 - 3));  // up to 1 px into the cap of radius 5
  REQUIRE(fields[ViewportEdge::kTop].least(1) == 15);
}

TEST_CASE("thick lines pull in to the exact extreme of each strip") {
  Random random(5);
  for (int round = 0; round < 42; ++round) {
    const int width = 40;
    const int height = 30;
    Segment2 segment{random.point(Vec2(-15, -15), Vec2(55, 45)), random.point(Vec2(-15, -15), Vec2(55, 45))};
    if (round % 7 == 0) segment.end = segment.start;
    if (round % 7 == 1) segment.end.x = segment.start.x;
    if (round % 7 == 2) segment.end.y = segment.start.y;
    const double radius = round % 5 == 0 ? 0.75 : random.real(1, 15);
    DistanceFields fields;
    fields.reset(width, height);
    fields.buildTrees();
    pullIn(fields, segment, radius);
    INFO("round " << round);
    requireExtremes(fields, [&](const Vec2& p) { return distanceBetween(p, segment) - radius; });
  }
}

TEST_CASE("lines that lead far out of the viewport, or run nearly straight across it, pull in as exactly") {
  const auto require = [](const Segment2& segment, double radius) {
    DistanceFields fields;
    fields.reset(40, 30);
    fields.buildTrees();
    pullIn(fields, segment, radius);
    INFO(segment.start.x << ", " << segment.start.y << " to " << segment.end.x << ", " << segment.end.y);
    requireExtremes(fields, [&](const Vec2& p) { return distanceBetween(p, segment) - radius; }, 1e-3);
  };
  for (const double far : {1e4, 1e6, 1e8}) {
    require({{20, 15}, {far, 0.7 * far}}, 3);
    require({{-far, 12}, {25, 18}}, 3);
    require({{-far, -2 * far}, {far, 2 * far + 9}}, 4);
  }
  for (const double aside : {1e-3, 1e-5, 1e-7, 1e-9}) {
    for (const double middle : {20.0, 20.0 + 0.5 * aside, 20.0 - 0.3 * aside}) {
      require({{middle, 6}, {middle + aside, 24}}, 5);
      require({{6, middle}, {30, middle - aside}}, 5);
    }
  }
}

TEST_CASE("boxes pull in to the exact extreme of each strip") {
  Random random(6);
  for (int round = 0; round < 42; ++round) {
    Box2 box;
    box.add(random.point(Vec2(-15, -15), Vec2(55, 45)));
    box.add(random.point(Vec2(-15, -15), Vec2(55, 45)));
    const double radius = round % 3 == 0 ? 0.0 : random.real(0.5, 12);
    DistanceFields fields;
    fields.reset(40, 30);
    fields.buildTrees();
    pullIn(fields, box, radius);
    INFO("round " << round);
    requireExtremes(fields, [&](const Vec2& p) { return glm::length(p - glm::clamp(p, box.min, box.max)) - radius; });
  }
}

TEST_CASE("what lies outside the viewport pulls nothing in") {
  DistanceFields fields;
  fields.reset(100, 60);
  fields.buildTrees();
  pullIn(fields, Segment2{{-40, 10}, {-20, 50}}, 15);
  pullIn(fields, Segment2{{10, 90}, {90, 80}}, 15);
  pullIn(fields, Box2{{105, 10}, {150, 50}}, 4);
  pullIn(fields, Box2{}, 4);
  for (const ViewportEdge edge : kViewportEdges) REQUIRE(fields[edge].least(1) == kNoSilhouette);
  pullIn(fields, Box2{{104, 10}, {150, 50}}, 5);
  REQUIRE(fields[ViewportEdge::kRight].at(30) == 0);
  REQUIRE(fields[ViewportEdge::kLeft].at(30) == 99);
}

TEST_CASE("boxes and segments clear a field up to touching it") {
  DistanceFields fields;
  fields.reset(100, 60);
  for (std::size_t row = 20; row < 40; ++row) {
    fields[ViewportEdge::kLeft].edit()[row] = 30;
    fields[ViewportEdge::kRight].edit()[row] = 30;
  }
  for (std::size_t column = 30; column < 70; ++column) {
    fields[ViewportEdge::kTop].edit()[column] = 20;
    fields[ViewportEdge::kBottom].edit()[column] = 20;
  }
  fields.buildTrees();
  REQUIRE(clears(fields, Box2{{10, 10}, {30, 50}}));
  REQUIRE_FALSE(clears(fields, Box2{{10, 15}, {30.1, 50}}));
  REQUIRE(clears(fields, Box2{{10, 1}, {90, 20}}));
  REQUIRE(clears(fields, Box2{{70, 0}, {100, 60}}));
  REQUIRE_FALSE(clears(fields, Box2{{70, 0}, {100.5, 60}}));  // leaves the viewport
  REQUIRE_FALSE(clears(fields, Box2{{40, 25}, {50, 30}}));    // inside
  REQUIRE(clearsSomewhere(fields, Segment2{{30, 0}, {30, 60}}));
  REQUIRE(clearsSomewhere(fields, Segment2{{0, 20}, {100, 20}}));
  REQUIRE(clearsSomewhere(fields, Segment2{{0, 49}, {49, 0}}));  // past the corner at (30, 20): 50 there
  REQUIRE_FALSE(clearsSomewhere(fields, Segment2{{0, 51}, {51, 0}}));
  REQUIRE_FALSE(clearsSomewhere(fields, Segment2{{10, 10}, {90, 50}}));
  REQUIRE_FALSE(clearsSomewhere(fields, Segment2{{10, 10}, {10, 61}}));
  REQUIRE_FALSE(clearsSomewhere(fields, Segment2{{50, 30}, {50, 30}}));
  REQUIRE(clearsSomewhere(fields, Segment2{{50, 10}, {50, 10}}));
}

TEST_CASE("segments and boxes clear random fields as their points do") {
  Random random(7);
  int clearCount = 0;
  int blockedCount = 0;
  for (int round = 0; round < 3000; ++round) {
    const DistanceFields fields = randomFields(random.whole(20, 90), random.whole(20, 90), random);
    const Vec2 size(fields.widthPx, fields.heightPx);
    const Vec2 from = random.point(Vec2(0.0), size);
    const Vec2 reach = size * random.scaled(0.02, 1);
    Segment2 segment{from, glm::clamp(from + random.point(-reach, reach), Vec2(0.0), size)};
    if (round % 9 == 0) segment.end.x = segment.start.x;
    if (round % 9 == 1) segment.end.y = segment.start.y;
    bool byPoints = false;
    bool boxByPoints = false;
    Box2 box;
    box.add(segment.start);
    box.add(segment.end);
    for (const ViewportEdge edge : kViewportEdges) {
      bool blocked = false;
      bool boxBlocked = false;
      for (int i = 0; i <= 2000 && !blocked; ++i) {
        blocked = blocks(fields, edge, segment.start + (segment.end - segment.start) * (i / 2000.0));
      }
      for (int i = 0; i <= 400 && !boxBlocked; ++i) {
        // Of a box, its diagonals' shadow on the strips at its worst depth will do.
        const Vec2 p = box.min + (box.max - box.min) * (i / 400.0);
        for (const Vec2& q : {Vec2(p.x, box.min.y), Vec2(p.x, box.max.y), Vec2(box.min.x, p.y), Vec2(box.max.x, p.y)}) {
          boxBlocked = boxBlocked || blocks(fields, edge, q);
        }
      }
      byPoints = byPoints || !blocked;
      boxByPoints = boxByPoints || !boxBlocked;
    }
    // Points miss what lies between them, so only one direction is certain; the other may fail by a hair, rarely.
    if (!byPoints) REQUIRE_FALSE(clearsSomewhere(fields, segment));
    if (!boxByPoints) REQUIRE_FALSE(clears(fields, box));
    if (clearsSomewhere(fields, segment)) {
      REQUIRE(byPoints);
      ++clearCount;
    }
    blockedCount += byPoints != clearsSomewhere(fields, segment) ? 1 : 0;
  }
  REQUIRE(clearCount > 200);
  REQUIRE(blockedCount < 30);
}

}  // namespace
}  // namespace dimline
