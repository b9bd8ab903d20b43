#include <catch2/catch.hpp>

#include <utility>
#include <vector>

#include "placement/score.h"

using namespace dimline;

namespace {

// A base line 100 px long and its candidate 40 px to the right of it, 90 px long.
ScoreInput plain() {
  ScoreInput in;
  in.base = {{100, 100}, {100, 200}};
  in.candidate = {{140, 105}, {140, 195}};
  return in;
}

}  // namespace

// Each expected number is worked out from section 4.2: lambdas -1, 0.02, 90, 15, -30, 90.
TEST_CASE("Dist and LenCandidate: middle to middle, and the length on screen") {
  CHECK(score(plain()) == Approx(-40.0 + 0.02 * 90.0));
}

TEST_CASE("SSAlign is the cosine to the preferred direction") {
  constexpr double kDiagonal = 0.70710678;
  using enum Align;
  const auto check = [](ScoreInput in, double without, const std::vector<std::pair<Align, double>>& cosines) {
    for (const auto& [align, cosine] : cosines) {
      in.align = align;
      INFO(static_cast<int>(align));
      CHECK(score(in) == Approx(without + 90.0 * cosine));
    }
  };
  // The candidate lies straight to the right.
  check(plain(), -38.2,
        {{kNone, 0}, {kRight, 1}, {kLeft, -1}, {kTop, 0}, {kBottom, 0}, {kTopRight, kDiagonal}, {kBottomRight, kDiagonal}, {kTopLeft, -kDiagonal}, {kBottomLeft, -kDiagonal}});
  // One straight below its base line tells top from bottom: rows grow downwards.
  ScoreInput below;
  below.base = {{100, 100}, {200, 100}};
  below.candidate = {{100, 140}, {200, 140}};
  check(below, -38.0, {{kBottom, 1}, {kTop, -1}, {kBottomLeft, kDiagonal}, {kBottomRight, kDiagonal}, {kTopLeft, -kDiagonal}, {kTopRight, -kDiagonal}});
}

TEST_CASE("Damp rewards the last frame's choice") {
  ScoreInput in = plain();
  in.sameAsLastFrame = true;
  CHECK(score(in) == Approx(-38.2 + 15.0));
}

TEST_CASE("Plane prefers front to back, and leaves billboards alone") {
  ScoreInput in = plain();
  in.planeKind = PlaneKind::kScope;
  in.facing = Facing::kFront;
  CHECK(score(in) == Approx(-38.2 + 90.0));
  in.facing = Facing::kBack;
  CHECK(score(in) == Approx(-38.2 + 45.0));
  in.planeKind = PlaneKind::kObject;
  CHECK(score(in) == Approx(-38.2 + 45.0));
  in.facing = Facing::kFront;
  CHECK(score(in) == Approx(-38.2 + 90.0));
  in.planeKind = PlaneKind::kBillboard;
  CHECK(score(in) == Approx(-38.2));
}

TEST_CASE("a candidate on its base line has no direction, so alignment says nothing") {
  ScoreInput in = plain();
  in.candidate = in.base;
  in.align = Align::kTop;
  CHECK(score(in) == Approx(0.02 * 100.0));
}

TEST_CASE("a line is askew by how far it has slid along itself, not by how far it lies away") {
  const Segment2 base{{100, 100}, {100, 200}};
  CHECK(askewPx(base, {{140, 100}, {140, 200}}) == 0);
  CHECK(askewPx(base, {{140, 130}, {140, 210}}) == Approx(20.0));   // of another length: middle to middle
  CHECK(askewPx(base, {{140, 70}, {140, 170}}) == Approx(30.0));    // the other way
  CHECK(askewPx(base, {{140, 170}, {140, 70}}) == Approx(30.0));    // the other way round
  // Along (3, 4) / 5, by (50, 0): 30 along it, 40 away from it.
  CHECK(askewPx({{0, 0}, {30, 40}}, {{50, 0}, {80, 40}}) == Approx(30.0));
  CHECK(askewPx(base, {{140, 120}, {140, 120}}) == 0);              // no direction
}

TEST_CASE("inside, only length and the direction from the scope's middle count") {
  const Segment2 base{{100, 100}, {100, 200}};
  CHECK(scoreInside(base, {50, 150}, Align::kNone) == Approx(2.0));
  CHECK(scoreInside(base, {50, 150}, Align::kRight) == Approx(2.0 + 90.0));
  CHECK(scoreInside(base, {150, 150}, Align::kRight) == Approx(2.0 - 90.0));
  CHECK(scoreInside(base, {100, 150}, Align::kRight) == Approx(2.0));
}
