#include <algorithm>
#include <catch2/catch.hpp>
#include <span>

#include "support/same_layout.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// The frame with which a movement ends: Placer::settle().

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
  const Layout& settle(double azimuthDeg) {
    placer.settle();
    return look(turned(azimuthDeg));
  }
};

}  // namespace

TEST_CASE("where a movement ends the lines come nearer, and what is not the better for it stays") {
  double beforePx = 0, afterPx = 0;
  std::ptrdiff_t changed = 0, lines = 0;
  for (double to = 10; to < 360; to += 10) {
    TurnedStage stage(to);
    const std::vector<PlacedLine> before = stage.layout.lines;
    beforePx += distancePx(stage.layout);
    afterPx += distancePx(stage.settle(to));
    changed += changes(before, stage.layout.lines);
    lines += static_cast<std::ptrdiff_t>(stage.layout.lines.size());
    REQUIRE(stage.layout.lines.size() >= before.size());
  }
  CHECK(afterPx < 0.9 * beforePx);
  CHECK(changed > lines / 20);
  CHECK(changed < lines / 2);
}

TEST_CASE("lines have settled until the view moves") {
  Stage stage(boxWithDoor());
  stage.look(turned(0));
  CHECK(stage.placer.settled());   // a first picture
  stage.look(turned(0));
  CHECK(stage.placer.settled());
  stage.look(turned(1));
  CHECK_FALSE(stage.placer.settled());
  stage.look(turned(1));
  CHECK_FALSE(stage.placer.settled());
  stage.placer.settle();
  stage.look(turned(1));
  CHECK(stage.placer.settled());
  stage.look(turned(2));
  CHECK_FALSE(stage.placer.settled());
  stage.placer.settleAsIs();
  CHECK(stage.placer.settled());
  stage.look(turned(3));
  CHECK_FALSE(stage.placer.settled());
  stage.look(turned(150));   // so far that it is a first picture again
  CHECK(stage.placer.settled());
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

TEST_CASE("the movement's last frame may be the one in which the lines settle") {
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
  const PlacedLine held = before.front();
  stage.placer.settle();
  stage.placer.place(stage.layout.view, stage.fields, stage.values, stage.layout, nullptr, std::span(&held, 1));
  CHECK(changes(before, stage.layout.lines) == 0);
  CHECK(stage.placer.settled());
}

TEST_CASE("a frame of another scene does not settle; it is for the next one to be told") {
  TurnedStage stage(60);
  stage.values.set(0, 1.1 * stage.values.at(0));
  stage.rebuild();
  stage.settle(60);
  CHECK_FALSE(stage.placer.settled());
  stage.settle(60);
  CHECK(stage.placer.settled());
}

TEST_CASE("a model that is forgotten has nothing to settle") {
  TurnedStage stage(60);
  stage.placer.settle();
  stage.placer.forget();
  CHECK(stage.placer.settled());
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
