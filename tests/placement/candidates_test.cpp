#include "placement/candidates.h"

#include <catch2/catch.hpp>

#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// A line across the picture, some way out from its base line on a plane that leads away from the viewer: further out it is shorter on screen.
Candidate leadingAway(const View& view) {
  Candidate candidate;
  candidate.base = candidate.foot = {{-1, 0, 0}, {1, 0, 0}};
  candidate.outward = {0, 0, -1};
  candidate.mostM = 1000;
  REQUIRE(pushTo(candidate, 1, view));
  return candidate;
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
