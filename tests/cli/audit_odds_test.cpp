#include "cli/audit_odds.h"

#include <catch2/catch.hpp>

#include "cli/audit_stage.h"

// Which offences are at odds with another row.

namespace dimline::test {
namespace {

/// What one frame of a steady movement shows of parameter A.
enum class Seen { kInsideFull, kInside, kInsideFenced, kInsideHalfFenced, kOutside, kHiddenAway, kHidden, kCrowdedAway };

/// A flight over the stage: in a frame of kInsideFull the block fills the picture and A lies on it, in one of
/// kHiddenAway the block is beside the picture and A is hidden for that; in all others there is room round the block,
/// when it is fenced only where the extension lines of A would run across another line, or on the one side only.
struct OddsStage {
  Stage stage;
  std::vector<Layout> layouts;
  std::vector<FrameName> names;

  explicit OddsStage(const std::vector<Seen>& seen, const std::vector<int>& legs = {}) {
    for (std::size_t f = 0; f < seen.size(); ++f) {
      Layout layout;
      const bool away = seen[f] == Seen::kHiddenAway || seen[f] == Seen::kCrowdedAway;
      Camera camera;
      camera.target = {away ? 10.0 : 0.0, 0, 0};
      camera.eye = camera.target + Vec3{0, 0, 10};
      camera.orthoHeightM = seen[f] == Seen::kInsideFull ? 1.5 : 4;
      layout.view = View(camera, kStagePx, kStagePx, stage.scene.bounds);
      layout.visibleScopes = {0};
      if (away || seen[f] == Seen::kHidden) {
        layout.hidden.push_back(
            {kA, seen[f] == Seen::kHiddenAway ? HiddenReason::kOutOfView : HiddenReason::kCrowded});
      } else {
        stage.layout.lines.clear();
        PlacedLine& line = stage.add(kA, vertical(100, 300, 100));
        if (seen[f] != Seen::kOutside) {
          line.placement = PlacementKind::kInside;
          line.planeKind = PlaneKind::kNone;
        }
        if (seen[f] == Seen::kInsideFenced || seen[f] == Seen::kInsideHalfFenced) stage.add(kC, vertical(85, 110, 90));
        if (seen[f] == Seen::kInsideFenced) stage.add(kC, vertical(315, 110, 90));
        layout.lines = stage.layout.lines;
      }
      layouts.push_back(layout);
      names.push_back({.frame = static_cast<int>(f), .leg = legs.empty() ? 0 : legs[f]});
    }
  }
  Odds odds() { return {stage.model, stage.scene, layouts, names}; }
};

/// `count` frames of the one between two of the other.
std::vector<Seen> between(Seen ends, Seen middle, std::size_t count) {
  std::vector<Seen> seen(count + 2, middle);
  seen.front() = seen.back() = ends;
  return seen;
}

TEST_CASE("audit: room that is gone at once is at odds with changes that are taken back") {
  const auto brief = [](const std::vector<Seen>& seen, const std::vector<int>& legs = {}) {
    return OddsStage(seen, legs).odds().lacksLastingRoom(kA, 2);
  };
  CHECK(brief(between(Seen::kInsideFull, Seen::kInside, kTakenBackFrames)));
  CHECK_FALSE(brief(between(Seen::kInsideFull, Seen::kInside, kTakenBackFrames + 1)));
  // It does not count as gone that the line has come out in the end.
  auto comesOut = between(Seen::kInsideFull, Seen::kInside, kTakenBackFrames + 1);
  comesOut[4] = Seen::kOutside;
  CHECK_FALSE(brief(comesOut));
  // What was there before is hidden, or the movement was another, or there is nothing before.
  using enum Seen;
  CHECK(brief({kInsideFull, kInside, kInside, kInsideFull}));
  CHECK_FALSE(brief({kHiddenAway, kInside, kInside, kInsideFull}));
  CHECK_FALSE(brief({kInsideFull, kInside, kInside, kInsideFull}, {0, 0, 0, 1}));
  CHECK_FALSE(brief({kInside, kInside, kInside, kInsideFull}));
}

TEST_CASE("audit: room behind other lines only is at odds with lines that run across extension lines") {
  using enum Seen;
  const auto lacks = [](const std::vector<Seen>& seen) { return OddsStage(seen).odds().lacksLastingRoom(kA, 2); };
  CHECK(lacks({kInside, kInside, kInsideFenced, kInside}));
  CHECK_FALSE(lacks({kInside, kInside, kInsideHalfFenced, kInside}));
  // It is none in the frames before and after either.
  CHECK(lacks(between(kInsideFenced, kInside, kTakenBackFrames)));
  CHECK_FALSE(lacks(between(kInsideFenced, kInside, kTakenBackFrames + 1)));
  // For what had to go back it is room as any other.
  CHECK(OddsStage({kInsideFull, kOutside, kOutside, kInsideFull}).odds().hadToGoBack(kA, 1, 3));
  CHECK_FALSE(OddsStage({kInsideFenced, kOutside, kOutside, kInsideFenced}).odds().hadToGoBack(kA, 1, 3));
}

TEST_CASE("audit: a feature that is gone at once is at odds with appearances that are taken back") {
  const auto brief = [](const std::vector<Seen>& seen) { return OddsStage(seen).odds().isBrieflyInView(kA, 2); };
  CHECK(brief(between(Seen::kHiddenAway, Seen::kHidden, kTakenBackFrames)));
  CHECK_FALSE(brief(between(Seen::kHiddenAway, Seen::kHidden, kTakenBackFrames + 1)));
  CHECK_FALSE(brief(between(Seen::kOutside, Seen::kHidden, 3)));
}

TEST_CASE("audit: a change that is taken back had to be, or had not") {
  using enum Seen;
  const auto had = [](const std::vector<Seen>& seen) {
    return OddsStage(seen).odds().hadToGoBack(kA, 1, seen.size() - 1);
  };
  // Comes out where there is room, and goes in where there is none.
  CHECK(had({kInsideFull, kOutside, kOutside, kInsideFull}));
  CHECK_FALSE(had({kInsideFull, kOutside, kOutside, kInside}));
  // Goes in where there is no room, and comes out again.
  CHECK(had({kOutside, kInsideFull, kInsideFull, kOutside}));
  CHECK_FALSE(had({kOutside, kInside, kInside, kOutside}));
  // From one place outside to another nothing had to go.
  CHECK_FALSE(had({kOutside, kOutside, kOutside}));
  // Is shown while its feature is in view, and hidden while it is not.
  CHECK(had({kHiddenAway, kOutside, kOutside, kHiddenAway}));
  CHECK_FALSE(had({kHiddenAway, kOutside, kOutside, kHidden}));
  CHECK_FALSE(had({kHiddenAway, kOutside, kOutside, kCrowdedAway}));
  CHECK(had({kOutside, kHiddenAway, kHiddenAway, kOutside}));
  CHECK_FALSE(had({kOutside, kHidden, kHidden, kOutside}));
  // In the last frame in which it would be taken back it is in view, or only after that.
  const auto hiddenFor = [&](std::size_t frames) { return had(between(kOutside, kHiddenAway, frames)); };
  CHECK(hiddenFor(kTakenBackFrames));
  CHECK_FALSE(hiddenFor(kTakenBackFrames + 1));
}

}  // namespace
}  // namespace dimline::test
