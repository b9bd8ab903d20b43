#include <catch2/catch.hpp>

#include "app/quality_governor.h"

using dimline::QualityGovernor;

namespace {

struct Clock {
  QualityGovernor governor;
  double nowMs = 1000;

  explicit Clock(bool software) { governor.start(software); }
  /// Frames of something that moves.
  void move(int frames, double intervalMs) {
    for (int i = 0; i < frames; ++i) governor.noteFrame(nowMs += intervalMs, true);
  }
  void rest(double ms) { governor.noteFrame(nowMs += ms, false); }
};

}  // namespace

TEST_CASE("smooth motion is drawn in full") {
  Clock clock(false);
  clock.move(500, 16);
  REQUIRE_FALSE(clock.governor.reduced());
}

TEST_CASE("a hiccup does not reduce the quality, a slow second does") {
  Clock clock(false);
  clock.move(10, 16);
  clock.move(3, 90);
  clock.move(10, 16);
  REQUIRE_FALSE(clock.governor.reduced());
  clock.move(10, 45);
  REQUIRE(clock.governor.reduced());
}

TEST_CASE("a page that slept is not slow") {
  Clock clock(false);
  for (int i = 0; i < 20; ++i) clock.move(1, 2000);
  REQUIRE_FALSE(clock.governor.reduced());
}

TEST_CASE("when the motion ends the picture is drawn in full soon after") {
  Clock clock(true);
  clock.move(2, 50);
  REQUIRE(clock.governor.reduced());
  clock.rest(50);
  REQUIRE(clock.governor.reduced());  // perhaps the hand only pauses
  clock.rest(100);
  REQUIRE(clock.governor.reduced());
  clock.rest(50);
  REQUIRE_FALSE(clock.governor.reduced());
}

TEST_CASE("a picture that took long is shown before a better one is begun") {
  Clock clock(true);
  clock.move(1, 50);
  clock.rest(900);
  REQUIRE(clock.governor.reduced());
  clock.rest(150);
  REQUIRE_FALSE(clock.governor.reduced());
}

TEST_CASE("a software rasterizer never draws motion in full, however fast it is") {
  Clock clock(true);
  clock.move(10000, 10);
  REQUIRE(clock.governor.reduced());
}

TEST_CASE("after a while of fast frames full quality gets another chance, and a longer while after each one lost") {
  Clock clock(false);
  const auto fastFramesUntilFull = [&] {
    clock.move(20, 45);
    REQUIRE(clock.governor.reduced());
    int frames = 0;
    while (clock.governor.reduced() && frames < 100000) {
      clock.move(1, 16);
      ++frames;
    }
    return frames;
  };
  const int first = fastFramesUntilFull();
  const int second = fastFramesUntilFull();
  REQUIRE(first >= 60);
  REQUIRE(second == 2 * first);
}
