#include "editing/drag_marks.h"

#include <catch2/catch.hpp>

using namespace dimline;
using Kind = DragMark::Kind;

namespace {

Parameter length(double min, double max, double step) { return {.name = "L", .unit = Unit::kMetre, .defaultValue = min, .min = min, .max = max, .step = step}; }

/// Values along the screen's x axis, from 100 px.
auto alongX(double pxPerM) {
  return [=](double value) { return std::optional(Vec2(100 + pxPerM * value, 50)); };
}

std::vector<double> placesOf(const std::vector<DragMark>& marks, double pxPerM) {
  std::vector<double> values;
  for (const DragMark& mark : marks) values.push_back((mark.line.middle().x - 100) / pxPerM);
  return values;
}

}  // namespace

TEST_CASE("ticks stand at every step where there is room, and at round values elsewhere") {
  REQUIRE(tickStride(10) == 1);
  REQUIRE(tickStride(6) == 1);
  REQUIRE(tickStride(5.9) == 2);
  REQUIRE(tickStride(2) == 5);
  REQUIRE(tickStride(0.7) == 10);
  REQUIRE(tickStride(0.07) == 100);
  REQUIRE(tickStride(0) == 0);
}

TEST_CASE("ticks are at right angles to the line, within the range, and fade with their distance") {
  std::vector<DragMark> marks;
  addTicks(length(0.5, 2.5, 0.5), 1.5, alongX(40), marks);
  REQUIRE(placesOf(marks, 40) == std::vector{0.5, 1.0, 1.5, 2.0, 2.5});
  for (const DragMark& mark : marks) {
    REQUIRE(mark.line.start.x == Approx(mark.line.end.x));
    REQUIRE(mark.line.length() == Approx(2 * halfLengthPx(mark.kind)));
  }
  REQUIRE(marks[2].strength == 1);
  REQUIRE(marks[4].strength == Approx(1 - 40 / kTickReachPx));
  REQUIRE(marks[4].kind == Kind::kLongTick);  // 2.5 is five steps
}

TEST_CASE("no tick is farther than its reach, nor nearer to its neighbour than the gap") {
  std::vector<DragMark> marks;
  addTicks(length(0.5, 90, 0.1), 30.03, alongX(25), marks);
  REQUIRE(marks.size() > 10);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    REQUIRE(std::abs(marks[i].line.middle().x - (100 + 25 * 30.03)) < kTickReachPx);
    if (i > 0) REQUIRE(marks[i].line.middle().x - marks[i - 1].line.middle().x >= kTickGapPx);
    const double steps = (marks[i].line.middle().x - 100) / 25 / 0.5;  // every fifth step of 2.5 px
    REQUIRE(steps == Approx(std::round(steps)));
  }
}

TEST_CASE("without steps there are no ticks") {
  std::vector<DragMark> marks;
  addTicks(length(0, 10, 0), 5, alongX(40), marks);
  REQUIRE(marks.empty());
}
