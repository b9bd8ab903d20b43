#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <initializer_list>
#include <span>

#include "support/same_layout.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// The frames after a movement: Placer::settle().

namespace {

Camera turned(double azimuthDeg) { return orbitCamera({0, 2.5, 0}, 30, azimuthDeg, 22); }

double distancePx(const Layout& layout) {
  double sum = 0;
  for (const PlacedLine& line : layout.lines) sum += glm::length(line.lineScreen.middle() - line.baseScreen.middle());
  return sum;
}

std::ptrdiff_t changes(std::span<const PlacedLine> from, std::span<const PlacedLine> to) {
  return std::ranges::count_if(to, [&](const PlacedLine& line) { return std::ranges::find(from, line.identity, &PlacedLine::identity) == from.end(); });
}

/// A box after a turn by so many degrees.
struct TurnedStage : Stage {
  explicit TurnedStage(double toDeg) : Stage(boxWithDoor()) {
    for (double azimuth = 0; azimuth <= toDeg; azimuth += 1) look(turned(azimuth));
  }
  /// One of the frames in which lines settle.
  const Layout& step(double azimuthDeg) {
    placer.settle();
    return look(turned(azimuthDeg));
  }
  /// All of them.
  const Layout& settle(double azimuthDeg) {
    int steps = 0;
    do step(azimuthDeg);
    while (!placer.settled() && ++steps < 20);
    return layout;
  }
  void edit() {
    values.set(0, 1.1 * values.at(0));
    rebuild();
  }
  /// A frame of the same view in which a line is held. A copy: the layout is placed anew.
  void hold(PlacedLine line) { placer.place(layout.view, fields, values, layout, nullptr, std::span(&line, 1)); }
};

}  // namespace

TEST_CASE("where a movement ends the lines come nearer, and what is not the better for it stays") {
  double beforePx = 0, afterPx = 0;
  std::ptrdiff_t changed = 0, lines = 0, otherwise = 0;
  for (double to = 10; to < 360; to += 10) {
    TurnedStage stage(to);
    const std::vector<PlacedLine> before = stage.layout.lines;
    beforePx += distancePx(stage.layout);
    afterPx += distancePx(stage.settle(to));
    changed += changes(before, stage.layout.lines);
    lines += static_cast<std::ptrdiff_t>(stage.layout.lines.size());
    REQUIRE(stage.layout.lines.size() >= before.size());
    TurnedStage fresh(0);
    fresh.placer.forget();
    fresh.look(turned(to));
    otherwise += changes(before, fresh.settle(to).lines);
  }
  CHECK(afterPx < 0.9 * beforePx);
  CHECK(changed > lines / 20);
  CHECK(changed < otherwise);   // where nothing is known of the movement more lines are elsewhere
}

TEST_CASE("lines have settled until the view moves") {
  TurnedStage stage(0);
  CHECK(stage.placer.anew());
  CHECK_FALSE(stage.placer.settled());   // a first picture is placed at once
  stage.settle(0);
  CHECK_FALSE(stage.placer.anew());
  CHECK(stage.placer.settled());
  stage.look(turned(0));
  CHECK(stage.placer.settled());
  stage.look(turned(1));
  CHECK_FALSE(stage.placer.settled());
  stage.look(turned(1));
  CHECK_FALSE(stage.placer.settled());
  stage.settle(1);
  CHECK(stage.placer.settled());
  stage.look(turned(2));
  CHECK_FALSE(stage.placer.settled());
  CHECK_FALSE(stage.placer.anew());
  stage.look(turned(150));   // so far that it is a first picture again
  CHECK(stage.placer.anew());
  CHECK_FALSE(stage.placer.settled());
}

TEST_CASE("what has settled stays before a still camera, and moves with it afterwards") {
  for (double to = 15; to < 360; to += 30) {
    TurnedStage stage(to);
    const Layout rests = stage.settle(to);
    for (int frame = 0; frame < 3; ++frame) {
      stage.look(turned(to));
      CHECK(sameLayout(rests, stage.layout));
    }
    // Where it is best already nothing is better by the price of a change.
    stage.settle(to);
    CHECK(changes(rests.lines, stage.layout.lines) <= 1);
    stage.look(turned(to + 1));
    CHECK(changes(rests.lines, stage.layout.lines) <= 1);
  }
}

TEST_CASE("until the lines have settled the layout stays as it is, and after kRoundsSettling + 1 frames they have") {
  TurnedStage stage(75);
  const Layout before = stage.layout;
  for (int step = 0; step < kRoundsSettling; ++step) {
    CHECK(sameLayout(before, stage.step(75)));
    CHECK_FALSE(stage.placer.settled());
  }
  CHECK_FALSE(sameLayout(before, stage.step(75)));
  CHECK(stage.placer.settled());
}

TEST_CASE("settling that is broken off leaves nothing behind") {
  // By a camera that moves on, a frame of which nobody said that it settles, an edit, a line in the hand, and what is remembered of before.
  const auto moveOn = [](TurnedStage& stage) { stage.look(turned(76)); };
  const auto stay = [](TurnedStage& stage) { stage.look(turned(75)); };
  const auto edit = [](TurnedStage& stage) {
    stage.edit();
    stage.look(turned(75));
  };
  const auto hold = [](TurnedStage& stage) { stage.hold(stage.layout.lines.front()); };
  const auto recall = [](TurnedStage& stage) {
    stage.placer.recall(stage.placer.memory());
    stage.look(turned(76));
  };
  for (const auto& breakOff : std::initializer_list<std::function<void(TurnedStage&)>>{moveOn, stay, edit, hold, recall}) {
    for (int steps = 1; steps <= kRoundsSettling; ++steps) {
      TurnedStage stage(75), other(75);
      for (int step = 0; step < steps; ++step) stage.step(75);
      breakOff(stage);
      breakOff(other);
      CHECK(sameLayout(stage.layout, other.layout));
      for (const double azimuth : {77.0, 78.0, 79.0}) CHECK(sameLayout(stage.look(turned(azimuth)), other.look(turned(azimuth))));
    }
  }
}

TEST_CASE("all frames of settling at once give what they give one by one") {
  TurnedStage one(75), two(75);
  one.settle(75);
  two.placer.placeSettled(two.layout.view, two.fields, two.values, two.layout);
  CHECK(two.placer.settled());
  CHECK(sameLayout(one.layout, two.layout));
}

TEST_CASE("the movement's last frame may be the first in which the lines settle") {
  TurnedStage moved(60), still(60);
  moved.settle(61);
  still.look(turned(61));
  still.settle(61);
  CHECK(moved.placer.settled());
  CHECK(distancePx(moved.layout) < 1.2 * distancePx(still.layout));
}

TEST_CASE("nothing settles while a line is held: who holds it takes the picture as it is") {
  TurnedStage stage(60);
  const std::vector<PlacedLine> before = stage.layout.lines;
  stage.placer.settle();
  stage.hold(before.front());
  CHECK(changes(before, stage.layout.lines) == 0);
  CHECK(stage.placer.settled());
}

TEST_CASE("a frame of another scene does not settle; it is for the next one to be told") {
  TurnedStage stage(60);
  stage.edit();
  stage.step(60);
  CHECK_FALSE(stage.placer.settled());
  stage.settle(60);
  CHECK(stage.placer.settled());
}

TEST_CASE("after an edit of what has settled one frame lays out its labels, and its lines stay on their edges") {
  TurnedStage stage(60);
  stage.settle(60);
  stage.edit();
  stage.look(turned(60));
  CHECK_FALSE(stage.placer.settled());
  const std::vector<PlacedLine> edited = stage.layout.lines;
  stage.step(60);
  CHECK(stage.placer.settled());
  CHECK(changes(edited, stage.layout.lines) == 0);
  const Layout rests = stage.layout;
  for (int frame = 0; frame < 3; ++frame) CHECK(sameLayout(rests, stage.look(turned(60))));
}

TEST_CASE("what is edited in the hand is laid out when it is let go of, and not before") {
  TurnedStage stage(60);
  stage.settle(60);
  const auto placeHeld = [&] {
    stage.placer.settle();
    stage.hold(stage.layout.lines.front());
  };
  placeHeld();
  CHECK(stage.placer.settled());   // a hand that changes nothing leaves nothing to be done
  stage.edit();
  for (int frame = 0; frame < 3; ++frame) {
    placeHeld();
    CHECK_FALSE(stage.placer.settled());
  }
  stage.look(turned(60));
  CHECK_FALSE(stage.placer.settled());
  stage.step(60);
  CHECK(stage.placer.settled());
}

TEST_CASE("a hand that changes nothing leaves nothing to be done, though fields come late") {
  TurnedStage stage(60);
  stage.settle(60);
  const PlacedLine held = stage.layout.lines.front();
  for (int frame = 0; frame < 2; ++frame) {
    stage.hold(held);
    stage.placer.awaitFields();
  }
  stage.look(turned(60));
  CHECK(stage.placer.settled());
}

TEST_CASE("a model that is forgotten has nothing to settle") {
  TurnedStage stage(60);
  stage.placer.settle();
  stage.placer.forget();
  CHECK(stage.placer.settled());
  CHECK_FALSE(stage.placer.anew());
  const Layout first = stage.look(turned(60));
  Stage fresh(boxWithDoor());
  CHECK(sameLayout(first, fresh.look(turned(60))));
}

TEST_CASE("lines settle in the same places twice, bit for bit") {
  TurnedStage one(75), two(75);
  one.settle(75);
  two.settle(75);
  CHECK(sameLayout(one.layout, two.layout));
}
