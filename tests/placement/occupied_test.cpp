#include "placement/occupied.h"

#include <catch2/catch.hpp>

#include "support/fields.h"

using namespace dimline;

namespace {

/// A line at y = 60 whose extension lines come down to a base line at y = 160, in a viewport of 400 x 300 with a model below y = 160.
struct OneLine {
  DistanceFields model = test::fieldsCovering({{0, 160}, {400, 300}}, 400, 300);
  Occupied occupied;

  OneLine() {
    occupied.begin(model);
    occupied.clear();
    PlacedLine line;
    line.base = {{0, 0, 0}, {1, 0, 0}};
    line.line = {{0, 1, 0}, {1, 1, 0}};
    line.baseScreen = {{150, 160}, {250, 160}};
    line.lineScreen = {{150, 60}, {250, 60}};
    line.extensionStart = {{150, 160}, {150, 60}};
    line.extensionEnd = {{250, 160}, {250, 60}};
    occupied.add(line, occupied.addGuide({{0, 0, 0}, {0, 0, 1}}, line.line));
  }
  /// Whether a line may come down to y = 100 there, from the top.
  [[nodiscard]] bool isFree(double x) const { return clears(occupied.padded(), ViewportEdge::kTop, Segment2{{x, 1}, {x, 100}}); }
};

}  // namespace

TEST_CASE("what comes later keeps handleSpacing from a line and a little from its extension lines") {
  const OneLine one;
  CHECK_FALSE(one.isFree(200));
  CHECK_FALSE(one.isFree(250 + kHandleSpacingPx - 2));   // at the line's own height
  CHECK(one.isFree(250 + kHandleSpacingPx + 2));
  // Below the line's own disc there are the extension lines alone.
  const auto reaches = [&](double x) { return clears(one.occupied.padded(), ViewportEdge::kLeft, Segment2{{1, 115}, {x, 115}}); };
  CHECK_FALSE(reaches(150 - kExtensionClearancePx + 1));
  CHECK(reaches(150 - kExtensionClearancePx - 1));
}

TEST_CASE("what comes later keeps as far from a label as it is told to") {
  const auto reaches = [](double px, double x) {
    Occupied occupied;
    const DistanceFields model = test::fieldsCovering({{0, 160}, {400, 300}}, 400, 300);
    occupied.begin(model);
    occupied.clear();
    occupied.keepFromLabels(px);
    PlacedLine line;
    line.base = {{0, 0, 0}, {1, 0, 0}};
    line.line = {{0, 1, 0}, {1, 1, 0}};
    line.lineScreen = {{250, 60}, {350, 60}};
    line.label = Box2{{150, 52}, {190, 68}};
    occupied.add(line, occupied.addGuide({{0, 0, 0}, {0, 0, 1}}, line.line));
    return clears(occupied.padded(), ViewportEdge::kLeft, Segment2{{1, 60}, {x, 60}});
  };
  for (const double px : {kLabelClearancePx, kLabelClearanceSettledPx}) {
    CHECK(reaches(px, 150 - px - 1));
    CHECK_FALSE(reaches(px, 150 - px + 1));
  }
}
