#include <catch2/catch.hpp>

#include <cmath>

#include "cli/audit_run.h"
#include "cli/audit_stage.h"

// A case for each AuditRow: a layout that breaks it, and one that just does not.

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

// --- Rows that compare frames -----------------------------------------------------------------------------------------

/// Frames in which parameter A has lines of the given identities (their base line's number), 0 for none.
AuditTally stepped(const std::vector<int>& identities, const std::vector<int>& legs = {}) {
  std::vector<Layout> layouts;
  std::vector<FrameName> names;
  Stage stage;
  for (std::size_t f = 0; f < identities.size(); ++f) {
    stage.layout.lines.clear();
    if (identities[f] > 0) stage.add(kA, vertical(60)).identity.baseLine = static_cast<std::int16_t>(identities[f]);
    layouts.push_back(stage.layout);
    names.push_back({.frame = static_cast<int>(f), .leg = legs.empty() ? 0 : legs[f]});
  }
  AuditTally tally;
  measureSteps(stage.model, layouts, names, nullptr, tally);
  return tally;
}

TEST_CASE("audit: identity changes from frame to frame") {
  const Figure figure = stepped({1, 1, 2, 2, 2}).figure(AuditRow::kIdentityChanges);
  CHECK(figure.judged == 4);
  CHECK(figure.offences == 1);
  CHECK_FALSE(figure.met);
  // Hidden in one of the two is no change.
  CHECK(stepped({1, 0, 2, 2}).figure(AuditRow::kIdentityChanges).offences == 0);
  CHECK(stepped({1, 0, 2, 2}).figure(AuditRow::kIdentityChanges).judged == 1);
}

TEST_CASE("audit: changes and appearances that are taken back") {
  const auto flickers = [](const std::vector<int>& identities, const std::vector<int>& legs = {}) {
    return stepped(identities, legs).figure(AuditRow::kFlicker).offences;
  };
  CHECK(flickers({1, 2, 1, 1}) == 1);
  CHECK(flickers({1, 2, 1, 2}) == 2);
  CHECK(flickers({0, 1, 1, 0, 0}) == 1);
  CHECK(flickers({1, 0, 1, 1}) == 1);
  CHECK(flickers({1, 1, 2, 2, 3, 3}) == 0);
  std::vector<int> slow(20, 2);
  slow[0] = 1;
  slow[16] = 1;
  CHECK(flickers({slow.begin(), slow.begin() + 17}) == 1);  // from frame 1 on, and back 15 frames later
  slow[16] = 2;
  slow[17] = 1;
  CHECK(flickers({slow.begin(), slow.begin() + 18}) == 0);
  // The camera turned round on the way: what comes back then was to be expected.
  CHECK(flickers({1, 2, 1, 1}, {0, 0, 1, 1}) == 0);
}

TEST_CASE("audit: lines that jump against their base lines") {
  Stage stage;
  std::vector<Layout> layouts;
  const std::vector<FrameName> names(2);
  const auto jumps = [&](const Segment2& base, const Segment2& line, int baseLine) {
    layouts.clear();
    stage.layout.lines.clear();
    stage.add(kA, vertical(100), vertical(60));
    layouts.push_back(stage.layout);
    stage.layout.lines.clear();
    stage.add(kA, base, line).identity.baseLine = static_cast<std::int16_t>(baseLine);
    layouts.push_back(stage.layout);
    AuditTally tally;
    measureSteps(stage.model, layouts, names, nullptr, tally);
    return tally.figure(AuditRow::kJumps);
  };
  CHECK(jumps(vertical(100), vertical(19), 0).offences == 1);
  CHECK(jumps(vertical(100), vertical(21), 0).offences == 0);
  CHECK(jumps(vertical(200), vertical(160), 0).offences == 0);  // the base line took it along
  CHECK(jumps(vertical(100), vertical(19), 1).judged == 0);     // another identity
}

TEST_CASE("audit: chain members that come or go") {
  Stage stage;
  const auto frame = [&](std::initializer_list<int> members, int cluster) {
    stage.layout.lines.clear();
    for (const int member : members) {
      PlacedLine& line = stage.add(kC, vertical(60));
      line.chain = 2;
      line.identity.chain = cluster;
      line.identity.scopeIndex = member;
    }
    return stage.layout;
  };
  const auto figure = [&](const std::vector<Layout>& layouts, AuditRow row) {
    AuditTally tally;
    measureSteps(stage.model, layouts, std::vector<FrameName>(layouts.size()), nullptr, tally);
    return tally.figure(row);
  };
  const std::vector<Layout> oneGoesOneComes{frame({1, 2, 3}, 0), frame({2, 3, 4}, 0)};
  CHECK(figure(oneGoesOneComes, AuditRow::kChainMembers).judged == 4);
  CHECK(figure(oneGoesOneComes, AuditRow::kChainMembers).offences == 2);
  CHECK(figure(oneGoesOneComes, AuditRow::kIdentityChanges).offences == 0);
  const std::vector<Layout> another{frame({1, 2, 3}, 0), frame({1, 2, 3}, 1)};
  CHECK(figure(another, AuditRow::kChainMembers).judged == 0);
  CHECK(figure(another, AuditRow::kIdentityChanges).offences == 1);
}

TEST_CASE("audit: nothing moves before a still camera") {
  Stage first;
  first.add(kA, vertical(60)).label = Box2{{45, 190}, {75, 210}};
  Stage second = first;
  const auto offences = [&] {
    AuditTally tally;
    measureStill(first.model, first.layout, second.layout, {}, tally);
    return tally.figure(AuditRow::kStillCamera).offences;
  };
  CHECK(offences() == 0);
  second.layout.lines[0].lineScreen.start.x += 1e-9;
  CHECK(offences() == 1);
  second = first;
  second.layout.lines[0].label.reset();
  CHECK(offences() == 1);
  second = first;
  second.layout.lines.clear();
  CHECK(offences() == 1);
  second = first;
  second.add(kB, level(350));
  CHECK(offences() == 1);
}

// --- The whole audit --------------------------------------------------------------------------------------------------

TEST_CASE("audit: lines that stay fixed in the world break what placed lines keep") {
  const auto model = makeModel(boxWithDoor());
  std::ostringstream progress;
  const auto parts = auditModel(*model, Values(model->parameters()), {.stepDeg = 10, .every = 4}, progress);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].flights.size() == 3);
  CHECK(parts[0].frames == 108);
  CHECK(parts[0].framesMeasured == 27);
  for (const AuditRow row : {AuditRow::kCrossesModel, AuditRow::kTouchesModel, AuditRow::kModelDistance}) {
    INFO(definition(row).title);
    CHECK(parts[0].placed.figure(row).judged > 100);
    CHECK(parts[0].placed.figure(row).met);
    CHECK_FALSE(parts[0].frozen.figure(row).met);
  }
  // They never change, whatever else they do.
  for (const AuditRow row : {AuditRow::kIdentityChanges, AuditRow::kFlicker})
    CHECK(parts[0].frozen.figure(row).offences == 0);
  CHECK(parts[0].placed.figure(AuditRow::kStillCamera).offences == 0);
}

TEST_CASE("audit: frozen lines are the first frame's, projected") {
  const auto model = makeModel(boxWithDoor());
  const Values values(model->parameters());
  const Scene scene = model->definition.build(values);
  AuditTally tally;
  const FlownFlight flown = fly(*model, scene, values, orbit(scene.bounds, 30, 45, 500, 400), tally);
  REQUIRE(flown.layouts.size() == 8);
  const std::vector<Layout> still = frozen(flown, scene);
  REQUIRE(still.size() == 8);
  const std::vector<PlacedLine>& first = flown.layouts[0].lines;
  REQUIRE(first.size() == still[3].lines.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(still[0].lines[i].lineScreen.start == first[i].lineScreen.start);
    REQUIRE(still[0].lines[i].label.has_value() == first[i].label.has_value());
    if (first[i].label) CHECK(glm::length(still[0].lines[i].label->center() - first[i].label->center()) < 1e-6);
    CHECK(still[3].lines[i].line.end == first[i].line.end);
    CHECK(still[3].lines[i].lineScreen.end == flown.layouts[3].view.toScreen(first[i].line.end));
  }
}

TEST_CASE("audit: the orbit goes round the model once") {
  Bounds bounds;
  bounds.add({-4, 0, -3});
  bounds.add({4, 5, 3});
  const Flight flight = orbit(bounds, 30, 1, 1000, 1000);
  REQUIRE(flight.cameras.size() == 360);
  const Vec3 front = flight.cameras[0].eye - bounds.center();
  CHECK(front.x == Approx(0).margin(1e-9));
  CHECK(front.z > 0);
  CHECK((flight.cameras[90].eye - bounds.center()).x > 0);  // then to the right
  for (const Camera& camera : flight.cameras) {
    CHECK(glm::length(camera.eye - bounds.center()) == Approx(glm::length(front)));
    const View view(camera, 1000, 1000, bounds);
    for (int i = 0; i < 8; ++i) {
      const Vec2 corner = view.toScreen(bounds.corner(i));
      CHECK((corner.x > 50 && corner.x < 950 && corner.y > 50 && corner.y < 950));
    }
  }
}

TEST_CASE("audit: random flights use every sort of lens and come back") {
  Bounds bounds;
  bounds.add({-4, 0, -3});
  bounds.add({4, 5, 3});
  bool anyOrtho = false, anyNarrow = false, anyWide = false, anySmall = false, anyLarge = false;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Flight flight = randomFlight(bounds, i);
    REQUIRE(flight.cameras.size() == flight.names.size());
    for (const Camera& camera : flight.cameras) REQUIRE(validate(camera).ok());
    const Camera& camera = flight.cameras.front();
    anyOrtho = anyOrtho || camera.orthographic();
    anyNarrow = anyNarrow || camera.fovRad < 0.01;
    anyWide = anyWide || camera.fovRad > 1.2;
    anySmall = anySmall || flight.widthPx == 300;
    anyLarge = anyLarge || flight.widthPx == 3840;
    CHECK(camera.fovRad >= 0.2 / 57.3);
    CHECK(camera.fovRad <= 100 / 57.2);
    // In the middle the model, which is as large as that, leaves the picture on all sides; in the end it is as large again as it was.
    const auto sizePx = [&](const Camera& at) { return 4 / View(at, flight.widthPx, flight.heightPx, bounds).metresPerPixelAt(bounds.center()); };
    const auto nearest = std::ranges::max_element(flight.cameras, {}, sizePx);
    CHECK(sizePx(*nearest) > std::max(flight.widthPx, flight.heightPx));
    CHECK(nearest != flight.cameras.begin());
    CHECK(sizePx(flight.cameras.back()) < 1.03 * sizePx(camera));
    CHECK(sizePx(flight.cameras.back()) > 0.97 * sizePx(camera));
  }
  CHECK((anyOrtho && anyNarrow && anyWide && anySmall && anyLarge));
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
