#include "placement/candidates.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "placement/occupied.h"
#include "placement/score.h"
#include "support/fields.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// What candidates are made in: a model's fields, and nothing that has landed.
struct Surroundings {
  Occupied occupied;
  std::vector<SlipPlane> planes;
  Foresight foresight;

  CandidateContext context(const Annotation& annotation, const View& view, const History& history, std::span<const Sight> sights, bool showAll = false) {
    return {.annotation = annotation,
            .view = view,
            .padded = occupied.padded(),
            .paddedModel = occupied.paddedModel(),
            .guides = occupied.guides(),
            .objectPlanes = {},
            .history = history,
            .planes = planes,
            .foresight = foresight,
            .showAll = showAll,
            .sights = sights};
  }
};

constexpr Bounds kBounds{{-6, -6, -1}, {6, 6, 1}};

/// A line across the picture, some way out from its base line on a plane that leads away from the viewer: further out it is shorter on screen.
Candidate leadingAway(const View& view) {
  Candidate candidate;
  candidate.base = candidate.foot = {{-1, 0, 0}, {1, 0, 0}};
  candidate.outward = {0, 0, -1};
  candidate.mostM = 1000;
  REQUIRE(pushTo(candidate, 1, view));
  return candidate;
}

/// The candidate of a base line on a plane, when the model covers the picture from a row downwards, and no line may be shorter than `leastPx`; nothing when there is none. `before`: the last frame's view.
std::optional<Candidate> outsideAbove(int coveredFromPx, const View& view, const Segment& segment, const ScopePlane& plane, const History& history = History(0), double leastPx = 0,
                                      const std::optional<View>& before = std::nullopt) {
  const DistanceFields model = fieldsCovering({{0, coveredFromPx}, {view.widthPx(), view.heightPx()}}, static_cast<int>(view.widthPx()), static_cast<int>(view.heightPx()));
  Surroundings around;
  around.occupied.begin(model);
  around.occupied.clear();
  around.foresight.begin(before, view, kBounds, {}, 1e-9);
  UsableBaseLine base;
  base.line.segment = segment;
  base.line.scopePlanes.push_back(plane);
  base.screen = view.toScreen(segment);
  Annotation annotation;
  annotation.slip = Slip::kScope;
  const Sight sight;
  std::vector<Candidate> candidates;
  CandidateContext context = around.context(annotation, view, history, {&sight, 1});
  context.leastPx = leastPx;
  gatherOutsideCandidates(context, base, candidates);
  REQUIRE(candidates.size() <= 1);
  return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

/// How far from the viewer the line lies on the plane that leads away from a base line 10 m off, when the model covers the picture from a row downwards; nothing when it lies nowhere.
std::optional<double> depthAbove(int coveredFromPx, const Camera& camera) {
  const View view(camera, 1000, 1000, Bounds{{-1, 0, -100}, {1, 0, 1}});
  const auto candidate = outsideAbove(coveredFromPx, view, {{-1, 0, 0}, {1, 0, 0}}, {.across = {0, 0, -1}, .normal = {0, 1, 0}});
  return candidate ? std::optional(view.depth(candidate->line.middle())) : std::nullopt;
}

/// 5 m above the ground, level: the base line of depthAbove() lies 250 px below the middle, and what is twice as far away 125 px.
Camera overTheGround() {
  Camera camera;
  camera.eye = {0, 5, 10};
  camera.target = {0, 5, 0};
  camera.fovRad = 90 * kRadPerDeg;
  return camera;
}

}  // namespace

TEST_CASE("a line is pushed out as far as its plane has room, and no further") {
  const View view(orbitCamera({0, 0, 0}, 20, 0, 20), 1000, 1000, Bounds{{-1, 0, -1}, {1, 0, 1}});
  Candidate candidate = leadingAway(view);
  candidate.mostM = 3;
  CHECK(pushTo(candidate, 3, view));
  CHECK(candidate.line.start == Vec3(-1, 0, -3));
  CHECK(candidate.lineScreen.start == view.toScreen(candidate.line.start));
  CHECK_FALSE(pushTo(candidate, 3.01, view));
  CHECK(candidate.offsetM == 3);
}

TEST_CASE("a line is not pushed to where it would be too short on screen") {
  const View view(orbitCamera({0, 0, 0}, 20, 0, 20), 1000, 1000, Bounds{{-1, 0, -1}, {1, 0, 1}});
  Candidate candidate = leadingAway(view);
  candidate.leastPx = view.toScreen(Segment{{-1, 0, -5}, {1, 0, -5}}).length();
  CHECK(pushTo(candidate, 4.9, view));
  CHECK_FALSE(pushTo(candidate, 5.1, view));
  CHECK(candidate.offsetM == 4.9);
  CHECK_FALSE(pushOutward(candidate, 10, view));
  CHECK(candidate.offsetM == 4.9);
}

TEST_CASE("a line on a guide is not pushed off it") {
  const View view(orbitCamera({0, 0, 0}, 20, 0, 20), 1000, 1000, Bounds{{-1, 0, -1}, {1, 0, 1}});
  Candidate candidate = leadingAway(view);
  candidate.guide = 0;
  CHECK_FALSE(pushTo(candidate, 2, view));
  CHECK(candidate.offsetM == 1);
}

TEST_CASE("a line lies no further behind its base line than perspective still shows its length") {
  // 30 px above row 640 the ground is 500 * 5 / 110 = 22.7 m off, above row 620 it is 27.8.
  REQUIRE(depthAbove(640, overTheGround()).has_value());
  CHECK(*depthAbove(640, overTheGround()) == Approx(22.7).epsilon(0.01));
  CHECK(*depthAbove(640, overTheGround()) <= 10 * kMostDepthRatio);
  CHECK_FALSE(depthAbove(620, overTheGround()).has_value());
  // Without perspective what is further away is as large. From 30 degrees above, the ground rises by half a metre of picture a metre; 40 m are seen.
  Camera orthographic = overTheGround();
  orthographic.eye = Vec3(0, 5, 5 * std::sqrt(3.0));
  orthographic.target = {0, 0, 0};
  orthographic.orthoHeightM = 40;
  REQUIRE(depthAbove(200, orthographic).has_value());
  CHECK(*depthAbove(200, orthographic) > 10 * kMostDepthRatio);
}

TEST_CASE("a line lies no further across the picture from its base line than within its reach") {
  // Upright, 25 px a metre; the base line is 100 px above the picture's lower edge.
  const auto above = [](double sidePx, double wayPx, const History& history = History(0)) {
    Camera camera;
    camera.eye = {0, 0, 10};
    camera.orthoHeightM = sidePx / 25;
    const View view(camera, sidePx, sidePx, Bounds{{-1, -20, -1}, {1, 20, 1}});
    const int coveredFromPx = static_cast<int>(std::lround(sidePx - 100 - wayPx + kHandleSpacingPx));
    const double y = -sidePx / 50 + 4;
    return outsideAbove(coveredFromPx, view, {{-1, y, 0}, {1, y, 0}}, {.across = {0, 1, 0}, .normal = {0, 0, 1}}, history);
  };
  const double diagonalPx = 1000 * std::sqrt(2.0);
  const double reachPx = kMostReachShare * diagonalPx, stayPx = kMostReachShareToStay * diagonalPx;
  const auto within = above(1000, reachPx - 2);
  REQUIRE(within.has_value());
  CHECK(within->baseScreen.start.y - within->lineScreen.start.y == Approx(reachPx).margin(4));
  CHECK_FALSE(above(1000, reachPx + 2).has_value());

  SECTION("it is not pushed beyond it either, for its label's sake") {
    Camera camera;
    camera.eye = {0, 0, 10};
    camera.orthoHeightM = 40;
    Candidate pushed = *within;
    CHECK_FALSE(pushOutward(pushed, 10, View(camera, 1000, 1000, Bounds{{-1, -20, -1}, {1, 20, 1}})));
  }
  SECTION("the one that is there may be a little further away") {
    History history(0);
    history.choose(within->identity, within->offsetM);
    CHECK(above(1000, reachPx + 2, history).has_value());
    CHECK(above(1000, stayPx - 2, history).has_value());
    CHECK_FALSE(above(1000, stayPx + 2, history).has_value());
  }
  SECTION("in a small picture it reaches as far as the eye takes in at once") {
    CHECK(above(450, kLeastReachPx - 2).has_value());
    CHECK_FALSE(above(450, kLeastReachPx + 2).has_value());
  }
}

TEST_CASE("a line whose base line is partly out of the picture lies where it comes into the picture, but not while the camera comes nearer") {
  // 100 px a metre; the base line begins 50 px beyond the picture's left edge, and its line goes to the right as fast as upwards.
  const auto viewOf = [](double heightM) {
    Camera camera;
    camera.eye = {0, 0, 10};
    camera.orthoHeightM = heightM;
    return View(camera, 1000, 1000, kBounds);
  };
  const auto placed = [&](int coveredFromPx, const std::optional<View>& before = std::nullopt) {
    return outsideAbove(coveredFromPx, viewOf(10), {{-5.5, 0, 0}, {-2, 0, 0}}, {.across = {std::sqrt(0.5), std::sqrt(0.5), 0}, .normal = {0, 0, 1}}, History(0), 0, before);
  };
  const auto low = placed(490);
  REQUIRE(low.has_value());
  CHECK(low->lineScreen.start.x == Approx(kViewportMarginPx).margin(0.01));
  // Where it clears the model further out only, it lies there.
  const auto high = placed(400);
  REQUIRE(high.has_value());
  CHECK(high->lineScreen.start.y == Approx(400 - kHandleSpacingPx).margin(1));
  CHECK_FALSE(placed(490, viewOf(10.1)).has_value());
  CHECK(placed(400, viewOf(10.1)).has_value());
}

TEST_CASE("a line that looks for another place takes all but its own, and one that looks on another side none on its own side either") {
  // From above at 45 degrees both planes of the base line lead up and down in the picture.
  Camera camera;
  camera.eye = {0, 10, 10};
  camera.orthoHeightM = 10;
  const View view(camera, 1000, 1000, Bounds{{-1, -1, -1}, {1, 1, 1}});
  const DistanceFields nothing = fieldsCovering({{495, 495}, {505, 505}}, 1000, 1000);
  Surroundings around;
  around.occupied.begin(nothing);
  around.occupied.clear();
  UsableBaseLine base;
  base.line.segment = {{-1, 0, 0}, {1, 0, 0}};
  base.line.scopePlanes.push_back({.across = {0, 1, 0}, .normal = {0, 0, 1}});
  base.line.scopePlanes.push_back({.across = {0, 0, 1}, .normal = {0, 1, 0}});
  base.screen = view.toScreen(base.line.segment);
  Annotation annotation;
  annotation.slip = Slip::kScope;
  const History history(0);
  const Sight sight;
  const auto gathered = [&](const AvoidedPlace* avoid) {
    CandidateContext context = around.context(annotation, view, history, {&sight, 1});
    context.avoid = avoid;
    std::vector<Candidate> candidates;
    gatherOutsideCandidates(context, base, candidates);
    return candidates;
  };
  const auto isAbove = [](const Candidate& candidate) { return candidate.lineScreen.start.y < candidate.baseScreen.start.y; };

  const std::vector<Candidate> all = gathered(nullptr);
  REQUIRE(all.size() == 4);
  const auto up = std::ranges::find_if(all, isAbove);
  REQUIRE(up != all.end());
  AvoidedPlace avoided{.place = up->identity};
  const std::vector<Candidate> others = gathered(&avoided);
  CHECK(others.size() == 3);
  CHECK(std::ranges::count_if(others, isAbove) == 1);
  CHECK(std::ranges::find(others, up->identity, &Candidate::identity) == others.end());
  avoided.side = {0, -1};
  const std::vector<Candidate> across = gathered(&avoided);
  CHECK(across.size() == 2);
  CHECK(std::ranges::none_of(across, isAbove));
}

TEST_CASE("an edge that the model hides comes after others, and less so for the line that is there") {
  const View view(orbitCamera({0, 0, 0}, 20, 30, 20), 1000, 1000, Bounds{{-1, 0, -1}, {1, 2, 1}});
  const Obb box = boxAt({-1, 0, -1}, {2, 2, 2});
  Annotation annotation;
  annotation.type = HandleType::kLinearContour;
  annotation.orient = Orient::kRight;
  annotation.slip = Slip::kNone;
  // Of the box's edges along x the model hides the upper front one, its number is 3.
  Sight sight;
  sight.see(1.0, SeenEdges(~SeenEdges::bit(0, 3)));
  Surroundings around;
  const auto scoresOf = [&](const History& history, const Vec3& translate) {
    annotation.translate = translate;
    std::vector<Candidate> candidates;
    for (const BaseLine& line : baseLines(annotation, box, view)) {
      UsableBaseLine base;
      base.scopeIndex = 0;
      base.line = line;
      base.screen = view.toScreen(line.segment);
      gatherInsideCandidate(around.context(annotation, view, history, {&sight, 1}), base, box, true, candidates);
    }
    std::vector<double> scores;
    for (const Candidate& candidate : candidates) scores.push_back(candidate.score - scoreInside(candidate.baseScreen, view.toScreen(box.center()), annotation.align));
    return scores;
  };
  const History none(0);
  const std::vector<double> scores = scoresOf(none, {0, 0, 0});
  REQUIRE(scores.size() == 4);
  CHECK(scores[0] == Approx(kScoreBehindModel));   // below, at the back: its faces are turned away
  CHECK(scores[1] == 0);
  CHECK(scores[2] == 0);
  CHECK(scores[3] == Approx(kScoreBehindModel));
  // One that is moved off the edges is not judged by them.
  CHECK(scoresOf(none, {0, 0, 0.1})[3] == 0);
  History shown(0);
  shown.choose({.parameter = 0, .scopeIndex = 0, .baseLine = 3}, -1);
  CHECK(scoresOf(shown, {0, 0, 0})[3] == Approx(kScoreStay + kScoreStaysBehindModel));
}

TEST_CASE("a line that is shown stays in its place where it is a little too short for a new one") {
  const View view(orbitCamera({0, 0, 0}, 10, 0, 0), 1000, 1000, Bounds{{-1, 0, -100}, {1, 0, 1}});
  const auto candidate = outsideAbove(400, view, {{-1, 0, 0}, {1, 0, 0}}, {.across = {0, 1, 0}, .normal = {0, 0, 1}});
  REQUIRE(candidate);
  const double lengthPx = candidate->lineScreen.length();
  History there(0);
  there.choose(candidate->identity, candidate->offsetM);
  const auto isPlace = [&](double leastPx, const History& history) {
    return outsideAbove(400, view, {{-1, 0, 0}, {1, 0, 0}}, {.across = {0, 1, 0}, .normal = {0, 0, 1}}, history, leastPx).has_value();
  };
  CHECK(isPlace(0.99 * lengthPx, History(0)));
  CHECK_FALSE(isPlace(1.01 * lengthPx, History(0)));
  CHECK(isPlace(0.99 * kShowAgainFactor * lengthPx, there));
  CHECK_FALSE(isPlace(1.01 * kShowAgainFactor * lengthPx, there));
}

TEST_CASE("nothing is begun on a scope that is going out of sight, where another base line comes after the one that is shown") {
  const View view(orbitCamera({0, 0, 0}, 20, 0, 20), 1000, 1000, Bounds{{-1, 0, -1}, {1, 0, 1}});
  std::array<Sight, 2> sights;
  for (Sight& sight : sights) {
    sight.see(1.0);
    sight.age(kReturnFrames);
    sight.see(1.0);
  }
  sights[1].age(1);
  REQUIRE(sights[1].see(0.0));   // it still counts as seen
  REQUIRE_FALSE(sights[1].seenEnough());
  Surroundings around;
  Annotation annotation;
  annotation.slip = Slip::kNone;
  UsableBaseLine base;
  base.line.segment = {{-1, 0, 0}, {1, 0, 0}};
  base.screen = view.toScreen(base.line.segment);
  const auto gathered = [&](std::size_t scope, const History& history, bool showAll = false) {
    base.scope = scope;
    base.scopeIndex = static_cast<std::int32_t>(scope);
    std::vector<Candidate> candidates;
    gatherInsideCandidate(around.context(annotation, view, history, sights, showAll), base, boxAt({-1, 0, -1}, {2, 0.1, 2}), true, candidates);
    return candidates;
  };
  const auto scoreOf = [&](std::size_t scope, const History& history, bool showAll = false) {
    const std::vector<Candidate> candidates = gathered(scope, history, showAll);
    REQUIRE(candidates.size() == 1);
    return candidates.front().score;
  };
  const History none(0);
  CHECK(gathered(1, none).empty());
  CHECK(scoreOf(1, none, true) == scoreOf(0, none, true));
  const auto shown = [](std::int32_t scopeIndex, int baseLine) {
    History history(0);
    history.choose({.parameter = 0, .scopeIndex = scopeIndex, .baseLine = static_cast<std::int16_t>(baseLine)}, -1);
    return history;
  };
  CHECK(gathered(1, shown(0, base.line.number)).empty());
  CHECK(scoreOf(1, shown(1, base.line.number)) == Approx(scoreOf(0, none) + kScoreStay));
  CHECK(scoreOf(1, shown(1, base.line.number + 1)) == Approx(scoreOf(0, none) + kScoreFadingScope));
  annotation.occlusion = false;   // lines on what nobody sees are wanted
  CHECK(scoreOf(1, none) == scoreOf(0, none));
}

TEST_CASE("a line inside the model does not come out for a moment") {
  const Bounds bounds{{-2, 0, -15}, {2, 3, 1}};
  const View view(straightAt(1.5, 9), 1000, 1000, bounds);
  Camera fromTheLeft = view.camera();
  fromTheLeft.eye = {-30 * std::sin(0.02), 1.5, 30 * std::cos(0.02)};
  const View nearing(straightAt(1.5, 10), 1000, 1000, bounds), turning(fromTheLeft, 1000, 1000, bounds);
  Annotation annotation;
  annotation.slip = Slip::kScope;
  Sight sight;
  sight.see(1.0);
  const History outside(0);
  History inside(0);
  inside.choose({.parameter = 0, .scopeIndex = 0, .baseLine = 0}, -1);
  REQUIRE(inside.wasInside());
  Surroundings around;
  // How many places a base line so far behind the middle has to the right of a model that covers the columns up to there.
  const auto placesBeside = [&](int coveredToPx, double behindM, const View& before, const History& history) {
    UsableBaseLine base;
    base.scopeIndex = 0;
    base.line.segment = {{0.5, 1, -behindM}, {0.5, 2, -behindM}};
    base.line.scopePlanes.push_back({.across = {1, 0, 0}, .normal = {0, 0, 1}});
    base.screen = view.toScreen(base.line.segment);
    around.foresight.begin(before, view, bounds, {}, 1e-3);
    const DistanceFields model = fieldsCovering({{0, 0}, {coveredToPx, 1000}});
    around.occupied.begin(model);
    around.occupied.clear();
    std::vector<Candidate> candidates;
    gatherOutsideCandidates(around.context(annotation, view, history, {&sight, 1}), base, candidates);
    return candidates.size();
  };
  // 30 px beside column 845 are 3.38 m to the right of the middle, beside column 814 they are 3.1 m; 3.28 m are seen three frames on.
  CHECK(placesBeside(845, 0, nearing, inside) == 0);
  CHECK(placesBeside(845, 0, nearing, outside) == 1);
  CHECK(placesBeside(814, 0, nearing, inside) == 1);
  // What lies 15 m behind the middle is moved by 5 m in a turn of 20 degrees, out of the picture.
  CHECK(placesBeside(740, 15, turning, inside) == 0);
  CHECK(placesBeside(740, 15, turning, outside) == 1);
  CHECK(placesBeside(740, 0, turning, inside) == 1);
}

TEST_CASE("where lines settle it costs what extension lines run over, a bend in them, and hidden members of a chain") {
  // 50 px a metre, from 30 degrees above. The base line lies in the middle of what the model covers; a line above or below keeps 30 px.
  Camera camera;
  camera.eye = {0, 15, 15 * std::sqrt(3.0)};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = 20;
  const View view(camera, 1000, 1000, Bounds{{-4, -2, -1}, {4, 2, 1}});
  const DistanceFields model = fieldsCovering({{300, 400}, {700, 600}});
  Surroundings around;
  around.occupied.begin(model);
  around.occupied.clear();
  Annotation annotation;
  annotation.slip = Slip::kObject;
  const History history(0);
  const Sight sight;
  // What settling adds to the score of the line above on an upright plane so far before the base line, which on screen is half as far below it.
  const auto extra = [&](double beforeM, double hiddenShare) {
    const ObjectPlane plane{.plane = {{0, 0, beforeM}, {0, 0, 1}}};
    const auto use = ObjectPlaneUse::kFront;
    UsableBaseLine base;
    base.line.segment = {{-1, 0, 0}, {1, 0, 0}};
    base.screen = view.toScreen(base.line.segment);
    base.hiddenShare = hiddenShare;
    const auto scoreAbove = [&](bool settles) {
      const ObjectPlanesInFrame object{{&plane, 1}, {&use, 1}, 1e-4};
      std::vector<Candidate> candidates;
      const CandidateContext with{.annotation = annotation,
                                  .view = view,
                                  .padded = around.occupied.padded(),
                                  .paddedModel = around.occupied.paddedModel(),
                                  .guides = around.occupied.guides(),
                                  .objectPlanes = object,
                                  .history = history,
                                  .planes = around.planes,
                                  .foresight = around.foresight,
                                  .sights = {&sight, 1},
                                  .kind = {.settles = settles}};
      gatherOutsideCandidates(with, base, candidates);
      const auto above = std::ranges::find_if(candidates, [](const Candidate& candidate) { return candidate.lineScreen.start.y < 400; });
      REQUIRE(above != candidates.end());
      CHECK(above->lineScreen.start.y == Approx(370).margin(0.5));
      return above->score;
    };
    return scoreAbove(true) - scoreAbove(false);
  };
  // From the base line at 500 the line above is 130 px away, of which 30 are beyond the model.
  CHECK(extra(0, 0) == Approx(kScoreOverModel * 100).margin(2));
  CHECK(extra(0.8, 0) == Approx(kScoreOverModel * 100 + kScoreBent * 20).margin(2));
  CHECK(extra(0, 0.5) == Approx(kScoreOverModel * 100 + kScoreHiddenMembers * 0.5).margin(2));
}
