#include <catch2/catch.hpp>
#include <cmath>

#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// Lines that have come or gone lately, and pictures in which nothing has been amiss for long.

namespace {

/// A plate, 1 m wide, of which that is measured.
ModelDefinition plate() {
  return measuring({"@Handle(scope=Plate, type=linear-contour, orient=right, slip=scope)"},
                   [](const Values&) { return sceneOf({{"Plate", boxAt({-0.5, -0.5, 0}, {1, 1, 0.1})}}); });
}

constexpr float kPartly = static_cast<float>(0.9 * kSeenShareInPlainView);

/// The plate, looked at by a camera that is never still.
class MovingLook {
 public:
  /// Whether the line is there when it is so long on screen, as a share of the least length.
  bool at(double share, float seen = 1) {
    const ScopeVisibility visibility{.seenShare = {seen}, .seenEdges = {}};
    heightM_ += 0.001;
    stage_.look(straightAt(heightM_, 1000 / (share * kMinLineLengthPx)), 1000, 1000, &visibility);
    return stage_.find("Width") != nullptr;
  }
  /// In how many frames on end it is there, or is not, looked at like that.
  int framesOf(bool there, double share, float seen = 1) {
    int frames = 0;
    while (frames < 100 && at(share, seen) == there) ++frames;
    return frames;
  }

 private:
  Stage stage_{plate()};
  double heightM_ = 0;
};

/// A wall with a plate at its top and two rails under that, each longer than what is above it. In a picture of its upper part all have room above it only, where a rail's extension lines run across what is nearer.
ModelDefinition wallWithRails() {
  return measuring({"@Handle(scope=Plate, type=linear-center, orient=right, slip=scope)", "@Handle(scope=Rail, type=linear-center, orient=right, slip=scope)",
                    "@Handle(scope=Ledge, type=linear-center, orient=right, slip=scope)"},
                   [](const Values&) {
                     return sceneOf({{"Wall", boxAt({-20, -20, -1}, {40, 20, 1})},
                                     {"Plate", boxAt({-0.5, -0.2, 0}, {1, 0.2, 0.1})},
                                     {"Rail", boxAt({-0.1, -0.7, 0}, {1.2, 0.2, 0.1})},
                                     {"Ledge", boxAt({-0.2, -1.2, 0}, {1.4, 0.2, 0.1})}});
                   });
}

}  // namespace

TEST_CASE("a line that has come stays for some frames when it has become too short, if not by much") {
  MovingLook look;
  REQUIRE_FALSE(look.at(0.9));
  REQUIRE(look.at(1.1 * kShowAgainFactor));
  CHECK(look.framesOf(true, 1.1 * kDwellFactor) == kDwellFrames - 1);

  MovingLook shorter;
  REQUIRE_FALSE(shorter.at(0.9));
  REQUIRE(shorter.at(1.1 * kShowAgainFactor));
  CHECK_FALSE(shorter.at(0.9 * kDwellFactor));
}

TEST_CASE("while the view turns past its direction a line stays, when it does not shrink too far") {
  // By how much of the angle that foreshortened lines are hidden by the camera looks down on the line when it looks along it.
  // In how many frames it is not there.
  const auto goneFor = [&](double share) {
    Stage stage(plate());
    int gone = 0;
    for (int azimuthDeg = 60; azimuthDeg <= 120; ++azimuthDeg) {
      Camera camera = orbitCamera({0, 0, 0}, 4, azimuthDeg, share * kForeshortenedAngleRad * kDegPerRad);
      camera.orthoHeightM = 4;
      stage.look(camera);
      gone += stage.find("Width") == nullptr ? 1 : 0;
    }
    return gone;
  };
  CHECK(goneFor(1.1) == 0);
  CHECK(goneFor(1.1 * kDwellFactor) == 0);
  // One that does shrink too far is gone as long as the ordinary thresholds say, not for a moment.
  CHECK(goneFor(0.1 * kDwellFactor) > 2 * kForeshortenedAngleRad * kDegPerRad - 2);
}

TEST_CASE("a line that has gone lately must be longer to come back than one that has been gone for long") {
  const double between = std::sqrt(kShowAgainFactor * kShowAgainLatelyFactor);
  MovingLook look;
  REQUIRE(look.at(2));
  REQUIRE_FALSE(look.at(0.9 * kDwellFactor));
  SECTION("lately") {
    CHECK_FALSE(look.at(between));
    CHECK(look.at(1.01 * kShowAgainLatelyFactor));
  }
  SECTION("long after") {
    for (int frame = 1; frame < kDwellFrames; ++frame) REQUIRE_FALSE(look.at(0.9 * kDwellFactor));
    CHECK(look.at(between));
  }
}

TEST_CASE("a line that has gone comes back when it has had a place for a while, or its feature is in plain view") {
  MovingLook look;
  for (int frame = 0; frame < kDwellFrames; ++frame) REQUIRE(look.at(2, kPartly));
  REQUIRE_FALSE(look.at(0.9, kPartly));
  SECTION("in part") { CHECK(look.framesOf(false, 2, kPartly) == kPatienceFrames); }
  SECTION("in plain view") { CHECK(look.at(2)); }
  SECTION("long after") {
    for (int frame = 0; frame < kDwellFrames; ++frame) REQUIRE_FALSE(look.at(0.9, kPartly));
    CHECK(look.at(2, kPartly));
  }
}

TEST_CASE("while the camera goes away, one line of what is seen in part comes out across another when nothing has been amiss for long") {
  Stage stage(wallWithRails());
  ScopeVisibility visibility{.seenShare = {1, 1, kPartly, kPartly}, .seenEdges = {}};
  const auto isOutside = [&](const char* name) {
    REQUIRE(stage.find(name) != nullptr);
    return stage.find(name)->placement != PlacementKind::kInside;
  };
  double seenM = 4;
  stage.look(straightAt(-2, seenM), 1000, 1000, &visibility);
  REQUIRE_FALSE(isOutside("Width"));
  for (int frame = 1; frame < 2 * kCalmFrames; ++frame) {
    stage.look(straightAt(-1, seenM *= 1.003), 1000, 1000, &visibility);
    INFO("frame " << frame);
    if (frame > 1) CHECK(isOutside("Width"));   // in the first step the camera rises, and would leave it behind
    CHECK(isOutside("Height") == (frame >= kCalmFrames - 1));   // the first picture counts as one frame more
    CHECK_FALSE(isOutside("Depth"));   // it would run across another too
  }
  visibility.seenShare[2] = 0;
  const auto goOn = [&] { stage.look(straightAt(-1, seenM *= 1.003), 1000, 1000, &visibility); };
  for (int frame = 0; stage.find("Height") != nullptr && frame < kCalmFrames; ++frame) goOn();
  REQUIRE(stage.find("Height") == nullptr);
  // In the last frame before this one it still was there.
  for (int frame = 1; frame <= kCalmFrames; ++frame) {
    INFO("frame " << frame);
    CHECK_FALSE(isOutside("Depth"));
    goOn();
  }
  CHECK(isOutside("Depth"));
}
