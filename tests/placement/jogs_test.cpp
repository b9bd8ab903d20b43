#include "placement/jogs.h"

#include <catch2/catch.hpp>

#include "core/constants.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// An extension line that runs 200 px up at x = 100.
constexpr Segment2 kUp{{100, 300}, {100, 100}};

/// A line from far on the left to so many px beyond kUp, at that height.
Segment2 lineOver(double px, double y = 200) { return {{0, y}, {100 + px, y}}; }

/// A wall, and a sill whose line lies above it. A rail leans to the right, and so do its extension lines: the left one, which begins at `railM`, runs across the sill's line near its end, and past it further up.
ModelDefinition sillAndRail(double railM) {
  ModelDefinition definition;
  definition.name = "wall";
  definition.title = "Wall";
  for (const char* name : {"Sill", "Rail"}) {
    definition.parameters.push_back({.name = name, .title = name, .unit = Unit::kMetre, .defaultValue = 2, .min = 0.5, .max = 5, .step = 0.1,
                                     .annotation = std::string("@Handle(scope=") + name + ", type=linear-center, orient=right, slip=scope, align=top)"});
  }
  definition.parameters[1].defaultValue = 3;
  constexpr double kLeanRad = 0.35;
  definition.build = [railM](const Values& v) {
    Scene scene = sceneOf({{"Wall", boxAt({-5, 0, -1}, {10, 16, 1})}, {"Sill", boxAt({-1, 15.79, 0}, {v.at(0), 0.02, 0.02})}});
    Obb rail = boxAt({railM, 15.8, 0}, {v.at(1), 0.02, 0.02});
    rail.axes[0] = {std::cos(kLeanRad), -std::sin(kLeanRad), 0};
    rail.axes[1] = {std::sin(kLeanRad), std::cos(kLeanRad), 0};
    scene.scopes.push_back({"Rail", 0, rail});
    return scene;
  };
  return definition;
}

/// The rail comes into sight later: in a first picture the sill would stand clear of it already.
void lookAtRail(Stage& stage) {
  ScopeVisibility visibility;
  visibility.seenShare = {1.0F, 1.0F, 0.0F};
  stage.look(straightAt(8), 1000, 1000, &visibility);
  REQUIRE(stage.find("Sill") != nullptr);
  REQUIRE(stage.find("Rail") == nullptr);
  visibility.seenShare.back() = 1.0F;
  stage.look(straightAt(8 - 1e-4), 1000, 1000, &visibility);
  REQUIRE(stage.find("Rail") != nullptr);
}

double sillPx(const Stage& stage) { return 100 - stage.find("Sill")->lineScreen.start.y; }   // above the wall

bool sillIsAcross(const Stage& stage) {
  const ExtensionLine& extension = stage.find("Rail")->extensionStart;
  bool across = false;
  for (std::size_t i = 1; i < extension.size(); ++i) across = across || segmentsCross(stage.find("Sill")->lineScreen, {extension[i - 1], extension[i]}, kCrossingPx);
  return across;
}

}  // namespace

TEST_CASE("an extension line goes round a line's end that reaches a little over it, just beyond that") {
  for (const double over : {1.0, 4.0, kMostJoggedPx}) {
    for (const Segment2& line : {lineOver(over), Segment2{lineOver(over).end, lineOver(over).start}}) {
      const auto jog = jogPastEnd(line, kUp);
      REQUIRE(jog);
      CHECK(jog->x == Approx(100 + over * (1 + kJogBeyondShare)));
      CHECK(jog->y == Approx(200));
      CHECK_FALSE(segmentsCross(line, {kUp.start, *jog}));
      CHECK_FALSE(segmentsCross(line, {*jog, kUp.end}));
    }
  }
  const auto other = jogPastEnd({{300, 200}, {96, 200}}, kUp);
  REQUIRE(other);
  CHECK(other->x == Approx(100 - 4 * (1 + kJogBeyondShare)));
}

TEST_CASE("it goes round a line at a slant as well, at the height of its end") {
  const Segment2 line{{0, 100}, {105, 210}};
  const auto jog = jogPastEnd(line, kUp);
  REQUIRE(jog);
  CHECK(jog->y == Approx(210));
  CHECK(jog->x > 105);
  CHECK_FALSE(segmentsCross(line, {kUp.start, *jog}));
  CHECK_FALSE(segmentsCross(line, {*jog, kUp.end}));
}

TEST_CASE("no extension line goes round what reaches far over it, or ends close to one of its own ends") {
  CHECK_FALSE(jogPastEnd(lineOver(kMostJoggedPx + 0.1), kUp));
  const double leastPx = 4 * (1 + kJogBeyondShare) / kMostJogSlope;
  CHECK(jogPastEnd(lineOver(4, 100 + leastPx + 0.1), kUp));
  CHECK(jogPastEnd(lineOver(4, 300 - leastPx - 0.1), kUp));
  CHECK_FALSE(jogPastEnd(lineOver(4, 100 + leastPx - 0.1), kUp));
  CHECK_FALSE(jogPastEnd(lineOver(4, 300 - leastPx + 0.1), kUp));
  CHECK_FALSE(jogPastEnd(lineOver(4), {{100, 200}, {100, 200}}));
}

TEST_CASE("a line without its jogs still bends at its plane") {
  PlacedLine line;
  line.base = line.foot = {{0, 0, 0}, {1, 0, 0}};
  line.extensionStart = {{0, 0}, {3, 50}, {0, 100}};
  line.extensionEnd = {{50, 0}, {50, 100}};
  PlacedLine bent = line;
  bent.foot = {{0, 0, 1}, {1, 0, 1}};
  bent.extensionStart = {{0, 0}, {10, 10}, {13, 50}, {10, 100}};
  bent.extensionEnd = {{50, 0}, {60, 10}, {60, 100}};

  straighten(line);
  CHECK(line.extensionStart == ExtensionLine{{0, 0}, {0, 100}});
  CHECK(line.extensionEnd == ExtensionLine{{50, 0}, {50, 100}});
  straighten(bent);
  CHECK(bent.extensionStart == ExtensionLine{{0, 0}, {10, 10}, {10, 100}});
  CHECK(bent.extensionEnd == ExtensionLine{{50, 0}, {60, 10}, {60, 100}});
}

TEST_CASE("an extension line across which a line reaches a little goes round its end, and neither line moves for it") {
  Stage stage(sillAndRail(0.65));
  lookAtRail(stage);
  for (int frame = 0; frame < 3; ++frame) {
    const PlacedLine& rail = *stage.find("Rail");
    const Vec2 end = stage.find("Sill")->lineScreen.end;
    REQUIRE(rail.extensionStart.size() == 3);
    CHECK(rail.extensionEnd.size() == 2);
    const double overPx = distanceBetween(end, {rail.extensionStart.front(), rail.extensionStart.back()});
    CHECK(overPx > kCrossingPx);
    CHECK(overPx < kMostJoggedPx);
    CHECK(glm::length(rail.extensionStart[1] - end) == Approx(overPx * kJogBeyondShare));
    CHECK(rail.extensionStart.front() == rail.baseScreen.start);
    CHECK(rail.extensionStart.back() == rail.lineScreen.start);
    CHECK_FALSE(sillIsAcross(stage));
    CHECK(sillPx(stage) == Approx(kHandleSpacingPx).margin(1));
    stage.look(straightAt(8 + 1e-4 * frame));
  }
}

TEST_CASE("a line that is held has the jog that it needs where it is, and no other") {
  Stage stage(sillAndRail(0.65));
  lookAtRail(stage);
  PlacedLine held = *stage.find("Rail");
  REQUIRE(held.extensionStart.size() == 3);
  const Vec2 jog = held.extensionStart[1];
  held.extensionStart[1] += Vec2(5, 0);
  stage.placer.place(stage.layout.view, stage.fields, stage.values, stage.layout, nullptr, {&held, 1});
  REQUIRE(stage.find("Rail")->extensionStart.size() == 3);
  CHECK(glm::length(stage.find("Rail")->extensionStart[1] - jog) < 1e-9);
}

TEST_CASE("a line that reaches too far over an extension line for that to bend moves out of its way little by little, and stays there before a still camera") {
  Stage stage(sillAndRail(0.5));
  lookAtRail(stage);
  REQUIRE(sillIsAcross(stage));
  double lastPx = sillPx(stage);
  CHECK(lastPx == Approx(kHandleSpacingPx).margin(1));
  for (int frame = 1; frame <= 10; ++frame) {
    stage.look(straightAt(8 + 1e-4 * frame));
    CHECK(std::abs(sillPx(stage) - lastPx) < kClearPx + 1);
    lastPx = sillPx(stage);
  }
  CHECK_FALSE(sillIsAcross(stage));
  CHECK(lastPx > kHandleSpacingPx + 2);
  CHECK(lastPx < kHandleSpacingPx * kMostClearedRatio + 10);   // the sill lies 10 px below the top
  stage.look(straightAt(8 + 1e-3));
  CHECK(sillPx(stage) == lastPx);
}
