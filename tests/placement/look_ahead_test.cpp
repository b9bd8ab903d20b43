#include <catch2/catch.hpp>

#include "placement/labels.h"
#include "placement/look_ahead.h"
#include "support/fields.h"

using namespace dimline;

namespace {

/// A parallel camera on the xy plane, 1 m a pixel: the world's (x, y) appears at (x, 1000 - y).
View plan() {
  Camera camera;
  camera.eye = {500, 500, 100};
  camera.target = {500, 500, 0};
  camera.orthoHeightM = 1000;
  Bounds bounds;
  bounds.add(Vec3(0, 0, -1));
  bounds.add(Vec3(1000, 1000, 1));
  return View(camera, 1000, 1000, bounds);
}

Segment world(double x0, double y0, double x1, double y1) { return {{x0, 1000 - y0, 0}, {x1, 1000 - y1, 0}}; }
Segment2 screen(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

/// Parameters 0 and 1, placed in that order; the model covers x and y from 400 to 600.
struct TwoLines {
  std::vector<Measured> order = std::vector<Measured>(2);
  DistanceFields model = test::fieldsCovering({{400, 400}, {600, 600}});
  LookAhead lookAhead;

  TwoLines() {
    order[0].parameter = 0;
    order[1].parameter = 1;
  }
  /// As seen from these edges the model reaches on from 400 to 300.
  void widen(std::initializer_list<ViewportEdge> edges) {
    for (const ViewportEdge edge : edges) {
      for (std::size_t i = 300; i < 400; ++i) model[edge].edit()[i] = 400;
    }
    model.buildTrees();
  }
  void begin(bool changed, bool shown = true) {
    lookAhead.begin(changed, shown);
    project({0, 1});
  }
  void project(const std::vector<std::uint32_t>& ranks) { lookAhead.project(order, ranks, plan(), model); }
};

}  // namespace

TEST_CASE("in another order it is the shorter line that comes after the longer one") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.note(0, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  stage.begin(true);
  stage.project({1, 0});
  const Segment2 across = screen(500, 300, 500, 370);
  stage.lookAhead.reach(1);
  CHECK(stage.lookAhead.crossings(across, across, across).lines);
  stage.lookAhead.reach(0);
  CHECK_FALSE(stage.lookAhead.crossings(across, across, across).lines);
}

TEST_CASE("a line sees the places of those after it, not its own and not those before") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));   // 50 px above the model
  stage.begin(true);
  const Segment2 across = screen(500, 300, 500, 370);
  stage.lookAhead.reach(0);
  CHECK(stage.lookAhead.crossings(across, across, across).lines);
  stage.lookAhead.reach(1);
  CHECK_FALSE(stage.lookAhead.crossings(across, across, across).lines);
}

TEST_CASE("before a still camera the same lines are looked at again") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 200, 580, 200));   // it has moved
  const Segment2 across = screen(500, 300, 500, 370);
  for (int frame = 0; frame < 3; ++frame) {
    stage.begin(false);
    stage.lookAhead.reach(0);
    CHECK(stage.lookAhead.crossings(across, across, across).lines);
    stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 200, 580, 200));
  }
  stage.begin(true);
  stage.lookAhead.reach(0);
  CHECK_FALSE(stage.lookAhead.crossings(across, across, across).lines);
}

TEST_CASE("crowding is nearer than handleSpacing") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  stage.begin(true);
  stage.lookAhead.reach(0);
  CHECK(stage.lookAhead.crowds(screen(450, 323, 550, 323)));
  CHECK_FALSE(stage.lookAhead.crowds(screen(450, 319, 550, 319)));
}

TEST_CASE("a line shadows another when it stands between that one and each edge it was seen from") {
  TwoLines stage;
  stage.begin(true);
  // Above the model: seen from the top, and along its rows from left and right, where nothing is.
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  stage.begin(true);
  stage.lookAhead.reach(0);
  const Segment2 above = screen(450, 250, 550, 250);
  CHECK_FALSE(stage.lookAhead.shadows(above, above));   // left and right are still free

  // Within the model's rows and columns, in front of its left side: only the left edge sees it.
  TwoLines other;
  other.begin(true);
  other.lookAhead.note(1, world(400, 450, 400, 550), world(400, 450, 400, 550), world(350, 450, 350, 550));
  other.begin(true);
  other.lookAhead.reach(0);
  const Segment2 left = screen(250, 420, 250, 580);
  CHECK_FALSE(other.lookAhead.shadows(left, left));      // from above and below its columns are free
  // With the model's columns drawn on to the left, above and below are closed.
  other.widen({ViewportEdge::kTop, ViewportEdge::kBottom});
  other.begin(false);
  other.lookAhead.reach(0);
  CHECK(other.lookAhead.shadows(left, left));
  const Segment2 behind = screen(390, 420, 390, 580);
  CHECK_FALSE(other.lookAhead.shadows(behind, behind));  // 40 px nearer to the model it takes nothing away
}

TEST_CASE("a base line inside keeps off those of later lines that were inside, and of no others") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.noteInside(1, world(420, 500, 580, 500));
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  stage.begin(true);
  stage.lookAhead.reach(0);
  CHECK(stage.lookAhead.runsIntoInside(screen(500, 450, 500, 550)));
  CHECK(stage.lookAhead.runsIntoInside(screen(440, 500, 480, 500)));         // lies on it
  CHECK_FALSE(stage.lookAhead.runsIntoInside(screen(500, 300, 500, 370)));   // crosses the one outside
  stage.lookAhead.reach(1);
  CHECK_FALSE(stage.lookAhead.runsIntoInside(screen(500, 450, 500, 550)));
  stage.begin(false);
  stage.lookAhead.reach(0);
  CHECK(stage.lookAhead.runsIntoInside(screen(500, 450, 500, 550)));         // before a still camera
  stage.begin(true);
  stage.lookAhead.reach(0);
  CHECK_FALSE(stage.lookAhead.runsIntoInside(screen(500, 450, 500, 550)));   // it was not inside in the last frame
}

TEST_CASE("a label leaves room for what is ahead: lines, their extension lines, lines inside, and the way to the edge that a line is seen from") {
  TwoLines stage;
  stage.widen({ViewportEdge::kLeft, ViewportEdge::kRight});
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));   // seen from above alone
  stage.lookAhead.noteInside(1, world(420, 500, 580, 500));
  stage.begin(true);
  stage.lookAhead.reach(0);
  const auto leavesRoom = [&](double x, double y) { return stage.lookAhead.leavesRoom({{x - 10, y - 5}, {x + 10, y + 5}}); };
  CHECK_FALSE(leavesRoom(500, 350));   // on the line
  CHECK_FALSE(leavesRoom(420, 375));   // on an extension line
  CHECK_FALSE(leavesRoom(500, 500));   // on the line inside
  CHECK_FALSE(leavesRoom(500, 200));   // between the line and the edge
  CHECK(leavesRoom(500, 375));
  CHECK(leavesRoom(300, 350));
  stage.lookAhead.reach(1);
  CHECK(leavesRoom(500, 350));
}

TEST_CASE("where nobody sees it a line ahead may give way to a label, but not leap; and so it is before the still camera after it") {
  TwoLines stage;
  stage.widen({ViewportEdge::kLeft, ViewportEdge::kRight});
  stage.begin(true);
  stage.lookAhead.note(1, world(420, 400, 580, 400), world(420, 400, 580, 400), world(420, 350, 580, 350));
  for (const bool changed : {true, false, false}) {
    stage.begin(changed, !changed);
    stage.lookAhead.reach(0);
    const auto leavesRoom = [&](double x, double y) { return stage.lookAhead.leavesRoom({{x - 10, y - 5}, {x + 10, y + 5}}); };
    CHECK(leavesRoom(500, 350));         // on the line
    CHECK(leavesRoom(500, 325));         // 34 px before it
    CHECK_FALSE(leavesRoom(500, 315));   // 44 px
    CHECK_FALSE(leavesRoom(420, 375));   // on an extension line
  }
}

TEST_CASE("a label keeps off what is ahead where it can, but for where it was") {
  TwoLines stage;
  stage.begin(true);
  stage.lookAhead.note(1, world(100, 400, 300, 400), world(100, 400, 300, 400), world(100, 100, 300, 100));   // its extension lines at x = 100 and 300
  stage.begin(true);
  stage.lookAhead.reach(0);
  LabelRequest request{.line = screen(150, 300, 450, 300), .textSize = {48, 16}, .ahead = &stage.lookAhead};
  const Box2 viewport{{0, 0}, {1000, 1000}};
  const auto found = placeLabel(request, Landed{}, viewport);
  REQUIRE(found);
  CHECK(found->place.side == LabelPlace::Side::kOnLine);
  CHECK(found->place.eighth == -4);
  request.last = LastLabelPlace{.place = LabelPlace{}};
  CHECK(placeLabel(request, Landed{}, viewport)->place == LabelPlace{});
  // It may leave, for a place that is better for what is ahead as well.
  request.last->mayLeave = true;
  CHECK(placeLabel(request, Landed{}, viewport)->place == found->place);
  // Where nothing else is free it stays on the line.
  request.last.reset();
  Landed landed;
  for (const double y : {284.0, 316.0}) landed.addLabel({{0, y - 2}, {600, y + 2}});
  for (const double x : {200.0, 400.0}) landed.addLabel({{x - 40, 299}, {x + 40, 301}});
  landed.addLabel({{100, 299}, {140, 301}});
  landed.addLabel({{460, 299}, {520, 301}});
  CHECK(placeLabel(request, landed, viewport)->place == LabelPlace{});
  // Unless others say the same: then it is left out, and for a while, wherever there is room again.
  request.orNone = true;
  CHECK_FALSE(placeLabel(request, landed, viewport));
  request.last = LastLabelPlace{.place = std::nullopt};
  CHECK_FALSE(placeLabel(request, Landed{}, viewport));
  request.last->mayLeave = true;
  CHECK(placeLabel(request, Landed{}, viewport)->place == found->place);
  request.last = LastLabelPlace{.place = LabelPlace{}};
  CHECK(placeLabel(request, landed, viewport)->place == LabelPlace{});   // where it was shown it stays
  request.last->mayLeave = true;
  CHECK_FALSE(placeLabel(request, landed, viewport));
  // One that must be shown is shown at once.
  request.orNone = false;
  request.last = LastLabelPlace{.place = std::nullopt};
  CHECK(placeLabel(request, Landed{}, viewport)->place == found->place);
}
