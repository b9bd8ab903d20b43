#include <catch2/catch.hpp>

#include <limits>

#include "editing/handle_hit.h"

using namespace dimline;

namespace {

PlacedLine lineBetween(const Vec2& start, const Vec2& end, bool bothEnds) {
  PlacedLine line;
  line.lineScreen = {start, end};
  line.handles.push_back({true, end});
  if (bothEnds) line.handles.push_back({false, start});
  return line;
}

}  // namespace

TEST_CASE("an arrowhead's middle lies half its length behind its tip") {
  const Segment2 line{{100, 50}, {200, 50}};
  REQUIRE(arrowMiddle(line, {true, {200, 50}}) == Vec2(200 - kArrowLengthPx / 2, 50));
  REQUIRE(arrowMiddle(line, {false, {100, 50}}) == Vec2(100 + kArrowLengthPx / 2, 50));
}

TEST_CASE("on a line too short for two arrowheads it lies half way to the line's middle") {
  REQUIRE(arrowMiddle({{100, 50}, {108, 50}}, {true, {108, 50}}) == Vec2(106, 50));
}

TEST_CASE("a line of no length has its arrowhead where it is") {
  REQUIRE(arrowMiddle({{7, 9}, {7, 9}}, {true, {7, 9}}) == Vec2(7, 9));
}

TEST_CASE("a pointer takes hold of a handle within the radius and not beyond") {
  const std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, false)};
  const Vec2 middle{194, 50};
  REQUIRE(hitHandle(lines, middle + Vec2(0, 14), 14) == HandleRef{0, 0});
  REQUIRE_FALSE(hitHandle(lines, middle + Vec2(0, 14.01), 14));
}

TEST_CASE("the end that cannot be dragged is not taken hold of") {
  const std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, false)};
  REQUIRE_FALSE(hitHandle(lines, {106, 50}, 14));
}

TEST_CASE("of two handles in reach the nearer one wins") {
  // The middles of the two arrowheads are at x = 194 and x = 216.
  const std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, false),
                                      lineBetween({300, 50}, {210, 50}, false)};
  REQUIRE(hitHandle(lines, {204, 50}, 26) == HandleRef{0, 0});
  REQUIRE(hitHandle(lines, {206, 50}, 26) == HandleRef{1, 0});
  REQUIRE(hitHandle(lines, {205, 50}, 26) == HandleRef{0, 0});  // as far from both: the first
}

TEST_CASE("a line with handles at both ends has both") {
  const std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, true)};
  REQUIRE(hitHandle(lines, {195, 50}, 14) == HandleRef{0, 0});
  REQUIRE(hitHandle(lines, {105, 50}, 14) == HandleRef{0, 1});
}

TEST_CASE("a pointer points at the nearest line within the radius, or at the one whose label it is over") {
  std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, false), lineBetween({100, 60}, {200, 60}, false)};
  REQUIRE(hitLine(lines, {150, 44.01}, 6) == 0u);
  REQUIRE_FALSE(hitLine(lines, {150, 44}, 6));
  REQUIRE(hitLine(lines, {150, 56}, 6) == 1u);
  REQUIRE_FALSE(hitLine(lines, {206, 50}, 6));
  lines[1].label = Box2{{140, 40}, {160, 48}};
  REQUIRE(hitLine(lines, {150, 47}, 6) == 1u);
  REQUIRE_FALSE(hitLine(lines, {std::numeric_limits<double>::quiet_NaN(), 50}, 6));
}

TEST_CASE("a pointer that is nowhere takes hold of nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PlacedLine> lines{lineBetween({100, 50}, {200, 50}, true)};
  REQUIRE_FALSE(hitHandle(lines, {nan, 50}, 14));
  REQUIRE_FALSE(hitHandle({}, {200, 50}, 14));
}
