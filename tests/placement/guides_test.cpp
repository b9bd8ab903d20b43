#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// Lines that share a guide (paper 4, algorithm 1, line 6, and figures 8 and 14), worked out by hand: seen straight from the front, 100 px a metre, in a picture of 1000x1000 px whose middle is 1 m above the ground.

namespace {

constexpr double kPxPerM = 100;
double rowOf(double yM) { return 500 - (yM - 1) * kPxPerM; }
double columnOf(double xM) { return 500 + xM * kPxPerM; }

const Layout& lookFromTheFront(Stage& stage) { return stage.look(straightAt(1, 10)); }

/// A wall 8 m wide and 2 m high, which goes down beyond the picture, and before it what is measured: each by its width, and flush with the others' front.
struct Front {
  const char* scope;
  double xM, yM, widthM, heightM;
};
Scene wallWith(const std::vector<Front>& fronts) {
  Scene scene = sceneOf({{"Wall", boxAt({-4, -10, -1}, {8, 12, 0.9})}});
  for (const Front& front : fronts) {
    const Obb box = boxAt({front.xM, front.yM, -0.1}, {front.widthM, front.heightM, 0.1});
    addBox(scene, box);
    const auto before = std::ranges::count(scene.scopes, front.scope, &Scope::name);
    scene.scopes.push_back({front.scope, static_cast<std::uint32_t>(before), box});
  }
  finish(scene);
  return scene;
}

std::string measuredAcross(const char* scope, const char* more = "") {
  return "@Handle(scope=" + std::string(scope) + ", type=linear-contour, orient=right, slip=scope" + more + ")";
}

/// All lines of a parameter, from left to right.
std::vector<const PlacedLine*> linesOf(const Stage& stage, std::string_view name) {
  std::vector<const PlacedLine*> lines;
  for (const PlacedLine& line : stage.layout.lines) {
    if (stage.nameOf(line) == name) lines.push_back(&line);
  }
  std::ranges::sort(lines, {}, [](const PlacedLine* line) { return line->lineScreen.middle().x; });
  return lines;
}

/// Width measures a post of 1 m that stands up from the wall by 1 m, Height a board of 2 m at the wall's top, `boardXM` its left end.
Stage postAndBoard(double boardXM, const std::vector<Front>& more = {}) {
  std::vector<Front> fronts{{"Post", 1, 1.8, 1, 1.2}, {"Board", boardXM, 1.8, 2, 0.2}};
  fronts.insert(fronts.end(), more.begin(), more.end());
  return Stage(measuring({measuredAcross("Post"), measuredAcross("Board")}, [fronts](const Values&) { return wallWith(fronts); }));
}

}  // namespace

TEST_CASE("a line goes to the guide of one that is there, though it has room nearer by") {
  Stage alone(measuring({measuredAcross("Board")}, [](const Values&) { return wallWith({{"Board", -3, 1.8, 2, 0.2}}); }));
  lookFromTheFront(alone);
  REQUIRE(alone.find("Width") != nullptr);
  CHECK(alone.find("Width")->placement == PlacementKind::kOutside);
  CHECK(alone.find("Width")->lineScreen.start.y == Approx(rowOf(2) - kHandleSpacingPx).margin(1));

  Stage stage = postAndBoard(-3);
  lookFromTheFront(stage);
  const PlacedLine* post = stage.find("Width");
  const PlacedLine* board = stage.find("Height");
  REQUIRE(post != nullptr);
  REQUIRE(board != nullptr);
  CHECK(post->placement == PlacementKind::kOutside);
  CHECK(post->lineScreen.start.y == Approx(rowOf(3) - kHandleSpacingPx).margin(1));
  CHECK(board->placement == PlacementKind::kGuide);
  CHECK(board->lineScreen.start.y == Approx(post->lineScreen.start.y).margin(0.01));
  CHECK(std::min(board->lineScreen.start.x, board->lineScreen.end.x) == Approx(columnOf(-3)).margin(0.01));
}

TEST_CASE("a guide is no place where the model is in its way") {
  Stage stage = postAndBoard(-3, {{"Tower", -2.5, 1.8, 0.5, 1.7}});
  lookFromTheFront(stage);
  const PlacedLine* board = stage.find("Height");
  REQUIRE(board != nullptr);
  CHECK(board->placement == PlacementKind::kOutside);
  CHECK(board->lineScreen.start.y == Approx(rowOf(3.5) - kHandleSpacingPx).margin(1));
}

TEST_CASE("a guide is no place where it is taken") {
  Stage stage = postAndBoard(0.5);
  lookFromTheFront(stage);
  const PlacedLine* post = stage.find("Width");
  const PlacedLine* board = stage.find("Height");
  REQUIRE(board != nullptr);
  CHECK(board->placement == PlacementKind::kOutside);
  CHECK(board->lineScreen.start.y == Approx(post->lineScreen.start.y - kHandleSpacingPx).margin(1));
}

TEST_CASE("a chain and a single line share a guide, and the member whose stretch is taken is left out") {
  Stage stage(measuring({measuredAcross("Plate"), measuredAcross("Bay", ", chained")}, [](const Values&) {
    return wallWith({{"Plate", -0.4, 1.8, 0.8, 0.2}, {"Bay", -2, 1.5, 1, 0.5}, {"Bay", -0.5, 1.5, 1, 0.5}, {"Bay", 1, 1.5, 1, 0.5}});
  }));
  lookFromTheFront(stage);
  const PlacedLine* plate = stage.find("Width");
  REQUIRE(plate != nullptr);
  const auto bays = linesOf(stage, "Height");
  REQUIRE(bays.size() == 2);
  for (const PlacedLine* bay : bays) {
    CHECK(bay->placement == PlacementKind::kGuide);
    CHECK(bay->chain >= 0);
    CHECK(bay->lineScreen.start.y == Approx(rowOf(2) - kHandleSpacingPx).margin(1));
  }
  CHECK(bays[0]->lineScreen.middle().x == Approx(columnOf(-1.5)).margin(0.01));
  CHECK(bays[1]->lineScreen.middle().x == Approx(columnOf(1.5)).margin(0.01));
}

TEST_CASE("of the rows of a chain the nearest has the lines, and what no nearer one covers is measured too") {
  // The upper row's are the scopes 1 to 3; below the last of them none is, and in the lower row one stands beyond it.
  Stage stage(measuring({measuredAcross("Bay", ", chained")}, [](const Values&) {
    return wallWith({{"Bay", -3, 1.5, 1, 0.4}, {"Bay", -1.5, 1.5, 1, 0.4}, {"Bay", 0, 1.5, 1, 0.4}, {"Bay", -3, 0.8, 1, 0.4}, {"Bay", -1.5, 0.8, 1, 0.4}, {"Bay", 1.5, 0.8, 1, 0.4}});
  }));
  lookFromTheFront(stage);
  const auto bays = linesOf(stage, "Width");
  REQUIRE(bays.size() == 4);
  const std::vector<std::size_t> nearest{1, 2, 3, 6};
  for (std::size_t i = 0; i < bays.size(); ++i) {
    CHECK(bays[i]->scope == nearest[i]);
    CHECK(bays[i]->lineScreen.start.y == Approx(rowOf(2) - kHandleSpacingPx).margin(1));
  }
}
