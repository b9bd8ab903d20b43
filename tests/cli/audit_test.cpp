#include <catch2/catch.hpp>

#include <cmath>

#include "cli/audit_stage.h"

// A case for each AuditRow of one frame: a layout that breaks it, and one that just does not.

namespace dimline::test {
namespace {

TEST_CASE("audit: an outside line that crosses the model") {
  Stage stage;
  stage.add(kA, level(200, 20, 380));
  CHECK(stage.figure(AuditRow::kCrossesModel).offences == 1);
  CHECK_FALSE(stage.figure(AuditRow::kCrossesModel).met);
  SECTION("along its outermost pixels is no crossing") {
    stage.layout.lines.clear();
    stage.add(kA, level(100.5, 20, 380));
    CHECK(stage.figure(AuditRow::kCrossesModel).judged == 1);
    CHECK(stage.figure(AuditRow::kCrossesModel).offences == 0);
  }
  SECTION("nor is a line inside") {
    stage.layout.lines[0].placement = PlacementKind::kInside;
    CHECK(stage.figure(AuditRow::kCrossesModel).judged == 0);
  }
  SECTION("nor one through a gap") {
    stage.cover(0, 190, kStagePx, 210, false);
    CHECK(stage.figure(AuditRow::kCrossesModel).offences == 0);
  }
}

TEST_CASE("audit: a label that touches the model") {
  Stage stage;
  stage.add(kA, vertical(60)).label = Box2{{40, 190}, {102, 210}};
  CHECK(stage.figure(AuditRow::kTouchesModel).offences == 1);
  stage.layout.lines[0].label = Box2{{40, 190}, {100, 210}};
  CHECK(stage.figure(AuditRow::kTouchesModel).offences == 0);
  CHECK(stage.figure(AuditRow::kTouchesModel).judged == 1);
}

TEST_CASE("audit: another handle that touches the model or leaves the viewport, when outside") {
  Stage stage;
  PlacedHandle handle;
  handle.parameter = kA;
  handle.placement = PlacementKind::kOutside;
  handle.box = {{280, 190}, {340, 210}};
  stage.layout.others = {handle};
  CHECK(stage.figure(AuditRow::kTouchesModel).offences == 1);
  CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 0);
  stage.layout.others[0].box = {{350, 190}, {401, 210}};
  CHECK(stage.figure(AuditRow::kTouchesModel).offences == 0);
  CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 1);
  stage.layout.others[0].placement = PlacementKind::kInside;
  CHECK(stage.figure(AuditRow::kLeavesViewport).judged == 0);
}

TEST_CASE("audit: an arc is judged as its curve and its arms, not as its number alone") {
  // A quarter circle of 80 px about (300, 60), from its right end upwards; the block covers x and y from 100 to 300.
  Stage stage;
  PlacedHandle angle;
  angle.parameter = kD;
  angle.placement = PlacementKind::kOutside;
  angle.box = {{340, 70}, {370, 90}};
  angle.arc = Arc{.center = worldAt(Vec2(300, 60)), .radiusM = 0.8, .angleRad = std::acos(0.0)};
  stage.layout.others = {angle};
  const auto moveTo = [&](const Vec2& px) { stage.layout.others[0].arc->center = worldAt(px); };

  SECTION("against the model and the viewport") {
    CHECK(stage.figure(AuditRow::kTouchesModel).offences == 0);
    CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 1);   // the curve ends 20 px above the picture
    moveTo({300, 90});
    CHECK(stage.figure(AuditRow::kTouchesModel).offences == 0);
    CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 0);
    moveTo({290, 110});
    CHECK(stage.figure(AuditRow::kTouchesModel).offences == 1);
    moveTo({60, 330});   // the curve alone, with its arms beside the block and below it
    CHECK(stage.figure(AuditRow::kTouchesModel).offences == 1);
    moveTo({60, 375});
    CHECK(stage.figure(AuditRow::kTouchesModel).offences == 0);
    moveTo({-10, 200});
    stage.layout.others[0].arc->angleRad = 0.5;   // the curve stays in the picture, its centre does not
    CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 1);
    moveTo({10, 200});
    CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 0);
    stage.layout.others[0].placement = PlacementKind::kInside;
    CHECK(stage.figure(AuditRow::kTouchesModel).judged == 0);
  }
  SECTION("against lines, where 45 degrees along the curve is at (356.6, 33.4)") {
    moveTo({300, 90});
    PlacedLine& line = stage.add(kA, vertical(356, 80, 20));   // crosses the curve
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
    CHECK(stage.figure(AuditRow::kExtensionCrossings).offences == 0);
    line.lineScreen = vertical(345, 98, 72);   // crosses an arm, and not the curve
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);   // but its number
    stage.layout.others[0].box = {{380, 5}, {395, 20}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
    CHECK(stage.figure(AuditRow::kExtensionCrossings).offences == 1);
    CHECK(stage.figure(AuditRow::kExtensionCrossings).judged == 1);
    line.lineScreen = vertical(390, 98, 72);
    CHECK(stage.figure(AuditRow::kExtensionCrossings).offences == 0);
    line.label = Box2{{350, 50}, {380, 70}};   // the curve runs through it
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
  }
  SECTION("against other handles") {
    moveTo({300, 90});
    stage.layout.others[0].box = {{380, 5}, {395, 20}};
    PlacedHandle pill;
    pill.parameter = kC;
    pill.box = {{320, 40}, {340, 60}};   // between the arms
    stage.layout.others.push_back(pill);
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
    stage.layout.others[1].box = {{350, 50}, {380, 70}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
    std::swap(stage.layout.others[0], stage.layout.others[1]);
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
  }
}

TEST_CASE("audit: the distance of an outside line to the model") {
  Stage stage;
  stage.add(kA, vertical(70));
  Figure figure = stage.figure(AuditRow::kModelDistance);
  CHECK(figure.value == Approx(30.0));
  CHECK(figure.met);
  stage.add(kB, level(328));
  figure = stage.figure(AuditRow::kModelDistance);
  CHECK(figure.value == Approx(28.0));
  CHECK(figure.offences == 1);
  CHECK_FALSE(figure.met);
}

TEST_CASE("audit: the distance of two parallel lines that are beside each other") {
  Stage stage;
  stage.add(kA, vertical(100), vertical(70));
  stage.add(kC, vertical(100), vertical(50));
  const Figure near = stage.figure(AuditRow::kLineDistance);
  CHECK(near.judged == 1);
  CHECK(near.value == Approx(20.0));
  CHECK_FALSE(near.met);

  const auto replaced = [&](const Segment2& other) {
    stage.layout.lines.pop_back();
    stage.add(kC, other);
    return stage.figure(AuditRow::kLineDistance);
  };
  CHECK(replaced(vertical(40)).value == Approx(30.0));
  CHECK(replaced(vertical(50, 149, 100)).judged == 0);                         // one after the other
  CHECK(replaced(level(200, 20, 60)).judged == 0);                             // at right angles
  CHECK(replaced(vertical(70, 149, 100)).judged == 0);                         // on one guide
  CHECK(replaced({{50, 250}, {54, 150}}).value == Approx(16.0).margin(0.02));  // nearly parallel: as seen
  CHECK(replaced({{50, 250}, {75, 150}}).judged == 0);
}

TEST_CASE("audit: the offset against the least offset") {
  Stage stage;
  stage.add(kA, vertical(100), vertical(70));
  CHECK(stage.figure(AuditRow::kOffset, true).value == Approx(1.0).margin(0.02));
  SECTION("twice as far as need be") {
    stage.layout.lines.clear();
    stage.add(kA, vertical(100), vertical(40));
    const Figure figure = stage.figure(AuditRow::kOffset, true);
    CHECK(figure.value == Approx(2.0).epsilon(0.02));
    CHECK(figure.offences == 1);
    CHECK_FALSE(figure.met);
  }
  SECTION("as far as an earlier line asks for") {
    stage.add(kC, vertical(100), vertical(40));
    const Figure figure = stage.figure(AuditRow::kOffset, true);
    CHECK(figure.judged == 2);
    CHECK(figure.value95 == Approx(1.0).margin(0.02));
  }
  SECTION("a later line asks for nothing") {
    stage.layout.lines.clear();
    stage.add(kA, vertical(100), vertical(40));
    stage.add(kC, vertical(100), vertical(70));
    CHECK(stage.figure(AuditRow::kOffset, true).value95 == Approx(2.0).epsilon(0.02));
  }
  SECTION("a hole of the model is no place") {
    stage.layout.lines.clear();
    stage.cover(20, 100, 100, 300);
    stage.cover(30, 110, 90, 290, false);
    stage.add(kA, vertical(60, 210, 190), vertical(-15, 210, 190));
    CHECK(stage.figure(AuditRow::kOffset, true).value == 1.0);
  }
  SECTION("guides, chains and object planes are left out") {
    PlacedLine& line = stage.layout.lines[0];
    line.placement = PlacementKind::kGuide;
    CHECK(stage.figure(AuditRow::kOffset, true).judged == 0);
    line.placement = PlacementKind::kOutside;
    line.chain = 4;
    CHECK(stage.figure(AuditRow::kOffset, true).judged == 0);
    line.chain = -1;
    line.planeKind = PlaneKind::kObject;
    CHECK(stage.figure(AuditRow::kOffset, true).judged == 0);
  }
}

TEST_CASE("audit: lines that cross") {
  Stage stage;
  stage.add(kA, vertical(50));
  stage.add(kB, level(200, 20, 80));
  CHECK(stage.figure(AuditRow::kLineCrossings).offences == 1);
  stage.layout.lines[1].lineScreen = level(200, 20, 50.3);  // touches
  CHECK(stage.figure(AuditRow::kLineCrossings).offences == 0);
  stage.layout.lines[1].lineScreen = vertical(50.5, 200, 100);  // lies on it
  CHECK(stage.figure(AuditRow::kLineCrossings).offences == 1);
  stage.layout.lines[1].lineScreen = vertical(50, 150, 100);  // goes on where it ends
  CHECK(stage.figure(AuditRow::kLineCrossings).offences == 0);
}

TEST_CASE("audit: two lines inside that cross are at odds with another row when neither has another base line") {
  Stage stage;
  stage.add(kA, vertical(200)).placement = PlacementKind::kInside;
  stage.add(kB, level(200, 100, 300)).placement = PlacementKind::kInside;
  stage.model.annotations[kA]->type = HandleType::kLinearCenter;
  stage.model.annotations[kB]->type = HandleType::kLinearCenter;
  const auto names = [&] {
    const std::vector<OffenceGroup> worst = stage.measured().worst(AuditRow::kLineCrossings, 1);
    REQUIRE(worst.size() == 1);
    return worst[0].names;
  };
  CHECK(names() == "A × B, at odds with another row");
  CHECK(stage.figure(AuditRow::kLineCrossings).atOdds == 1);
  CHECK(stage.figure(AuditRow::kLineCrossings).offences == 1);
  stage.model.annotations[kB]->type = HandleType::kLinearContour;  // along the block's edges as well
  CHECK(names() == "A × B");
  stage.model.annotations[kB]->type = HandleType::kLinearCenter;
  stage.layout.lines[1].placement = PlacementKind::kOutside;
  CHECK(names() == "A × B");
}

TEST_CASE("audit: lines that cross another's extension line") {
  Stage stage;
  stage.add(kA, vertical(100), vertical(40));
  stage.add(kC, vertical(100, 180, 120), vertical(70, 180, 120));
  Figure figure = stage.figure(AuditRow::kExtensionCrossings);  // A's upper extension line runs across C
  CHECK(figure.judged == 2);
  CHECK(figure.offences == 1);
  CHECK(figure.value == Approx(0.5));
  stage.layout.lines[1].lineScreen = vertical(70, 240, 160);
  CHECK(stage.figure(AuditRow::kExtensionCrossings).offences == 0);
}

TEST_CASE("audit: labels on labels, lines and handles") {
  Stage stage;
  stage.add(kA, vertical(60)).label = Box2{{45, 190}, {75, 210}};
  stage.add(kB, level(350)).label = Box2{{180, 340}, {220, 360}};
  CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
  SECTION("on another label") {
    stage.layout.lines[1].label = Box2{{70, 205}, {100, 225}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
    for (PlacedLine& line : stage.layout.lines) line.placement = PlacementKind::kInside;
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
  }
  SECTION("on another line") {
    stage.layout.lines[1].label = Box2{{55, 160}, {85, 180}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
    stage.layout.lines[1].label = Box2{{60.2, 160}, {85, 180}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
  }
  SECTION("on another handle") {
    PlacedHandle handle;
    handle.parameter = kC;
    handle.box = {{70, 205}, {100, 225}};
    stage.layout.others = {handle};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
    stage.layout.others[0].box = {{80, 220}, {100, 240}};
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 0);
    stage.layout.others[0].placement = PlacementKind::kOutside;
    stage.layout.others.push_back(stage.layout.others[0]);
    CHECK(stage.figure(AuditRow::kLabelOverlaps).offences == 1);
  }
}

TEST_CASE("audit: of two parallel lines on one side the longer is farther out") {
  Stage stage;
  stage.add(kA, vertical(100, 280, 120), vertical(40, 280, 120));
  stage.add(kC, vertical(100, 220, 180), vertical(70, 220, 180));
  CHECK(stage.figure(AuditRow::kNesting).judged == 1);
  CHECK(stage.figure(AuditRow::kNesting).offences == 0);

  const auto swapped = [&](std::size_t parameter, const Segment2& base, const Segment2& line) {
    stage.layout.lines.pop_back();
    stage.add(parameter, base, line);
    return stage.figure(AuditRow::kNesting);
  };
  CHECK(swapped(kC, vertical(100, 220, 180), vertical(10, 220, 180)).offences == 1);
  CHECK(swapped(kC, vertical(300, 220, 180), vertical(330, 220, 180)).judged == 0);  // on the other side
  CHECK(swapped(kC, vertical(100, 281, 121), vertical(10, 281, 121)).judged == 0);   // of one length
  CHECK(swapped(kC, vertical(35, 220, 180), vertical(10, 220, 180)).judged == 0);    // at a part of the model that is farther out than the other line
  CHECK(swapped(kC, vertical(45, 220, 180), vertical(10, 220, 180)).offences == 1);

  SECTION("a chain counts as one line of its members' mean length") {
    swapped(kC, vertical(100, 220, 180), vertical(10, 220, 180)).offences;
    stage.layout.lines[1].chain = 7;
    stage.add(kC, vertical(100, 180, 140), vertical(10, 180, 140)).chain = 7;
    CHECK(stage.figure(AuditRow::kNesting).judged == 1);
    CHECK(stage.figure(AuditRow::kNesting).offences == 1);
  }
}

TEST_CASE("audit: a line inside though an outside place exists") {
  Stage stage;
  PlacedLine& line = stage.add(kA, vertical(100, 300, 100));
  line.placement = PlacementKind::kInside;
  line.planeKind = PlaneKind::kNone;
  line.text = "2.00 m";
  CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 1);
  SECTION("not when the model fills the picture") {
    stage.cover(0, 0, kStagePx, kStagePx);
    const Figure figure = stage.figure(AuditRow::kNeedlesslyInside, true);
    CHECK(figure.judged == 1);
    CHECK(figure.offences == 0);
  }
  SECTION("not when other lines stand everywhere beside it") {
    for (const double x : {20.0, 60.0, 340.0, 380.0}) stage.add(kB, vertical(x, 320, 80));
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 0);
  }
  SECTION("on the object's planes too") {
    stage.model.annotations[kA]->slip = Slip::kObject;
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 1);
    stage.cover(0, 0, kStagePx, kStagePx);
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 0);
  }
  SECTION("not where an arc is in the way") {
    stage.cover(0, 0, kStagePx, kStagePx);
    stage.cover(0, 0, 70, kStagePx, false);   // what is free is a strip at the picture's left edge
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 1);
    PlacedHandle angle;
    angle.parameter = kD;
    angle.box = {{200, 200}, {220, 220}};
    angle.arc = Arc{.center = worldAt(Vec2(0, 320)), .radiusM = 1.2, .angleRad = std::acos(0.0)};
    stage.layout.others = {angle};
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).offences == 0);
  }
  SECTION("not when the author wants it there") {
    line.parameter = kD;
    CHECK(stage.figure(AuditRow::kNeedlesslyInside, true).judged == 0);
  }
  SECTION("not when that is out of reach across the picture") {
    stage.scene.scopes[0].box = boxAt({-1.9, -1, -1}, {0.2, 2, 1});  // its edges are at 10 and 30 px
    const double reachPx = kLeastReachPx;  // the stage is small
    const auto coveredBelow = [&](double wayPx) {
      stage.cover(0, 0, kStagePx, kStagePx, false);
      stage.cover(0, 0, static_cast<int>(std::lround(30 + wayPx - kHandleSpacingPx)), kStagePx);
      return stage.figure(AuditRow::kNeedlesslyInside, true);
    };
    CHECK(coveredBelow(reachPx - 4).offences == 1);
    CHECK(coveredBelow(reachPx + 4).offences == 0);
    CHECK(coveredBelow(reachPx + 4).judged == 1);
  }
}

TEST_CASE("audit: lines and labels that leave the viewport") {
  Stage stage;
  stage.add(kA, vertical(5, 250, 150)).label = Box2{{0, 190}, {30, 210}};
  CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 0);
  stage.layout.lines[0].label = Box2{{-2, 190}, {30, 210}};
  CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 1);
  stage.layout.lines[0].label.reset();
  stage.layout.lines[0].lineScreen = vertical(5, 250, -1);
  CHECK(stage.figure(AuditRow::kLeavesViewport).offences == 1);
}

TEST_CASE("audit: a feature in plain view has a line") {
  Stage stage;
  stage.add(kA, vertical(60));
  stage.add(kB, level(350));
  stage.add(kC, vertical(20));
  stage.add(kD, vertical(340));
  CHECK(stage.figure(AuditRow::kUnshown).offences == 0);  // E's scope lies in the block, out of sight
  stage.layout.lines.pop_back();
  CHECK(stage.figure(AuditRow::kUnshown).offences == 1);
  SECTION("but not behind something") {
    addBox(stage.scene, boxAt({-2, -2, 1}, {4, 4, 0.1}));
    CHECK(stage.figure(AuditRow::kUnshown).offences == 0);
  }
  SECTION("nor when half of it is out of the picture") {
    for (Scope& scope : stage.scene.scopes) scope.box.origin.x += 2;
    CHECK(stage.figure(AuditRow::kUnshown).offences == 0);
  }
}

TEST_CASE("audit: a tally of parts is the tally of the whole") {
  AuditTally whole, first, second;
  for (int i = 0; i < 100; ++i) {
    AuditTally& part = i < 37 ? first : second;
    for (AuditTally* tally : {&whole, &part}) {
      tally->measure(AuditRow::kOffset, 1 + i * 0.01);
      tally->measure(AuditRow::kModelDistance, 40 - i * 0.1);
      tally->judge(AuditRow::kNesting);
      if (i % 10 == 0) tally->offend(AuditRow::kNesting, i % 20 == 0 ? "A" : "B", i, {.frame = i}, "what", i % 20 == 0);
    }
  }
  first.add(second);
  for (const AuditTally* tally : {&whole, &first}) {
    CHECK(tally->figure(AuditRow::kOffset).value == Approx(1.5).margin(0.011));
    CHECK(tally->figure(AuditRow::kOffset).value95 == Approx(1.94).margin(0.011));
    CHECK(tally->figure(AuditRow::kModelDistance).value == Approx(30.1));
    CHECK(tally->figure(AuditRow::kNesting).value == Approx(0.1));
    const auto worst = tally->worst(AuditRow::kNesting, 5);
    REQUIRE(worst.size() == 2);
    CHECK(worst[0].names == "B");
    CHECK(worst[1].names == "A, at odds with another row");
    CHECK(tally->figure(AuditRow::kNesting).atOdds == 5);
    CHECK(worst[0].count == 5);
    CHECK(worst[0].frame.frame == 90);
    CHECK(tally->worst(AuditRow::kNesting, 1).size() == 1);
  }
  CHECK(whole.figure(AuditRow::kChainMembers).met);  // nothing judged
}

}  // namespace
}  // namespace dimline::test
