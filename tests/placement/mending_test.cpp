#include "placement/mending.h"

#include <catch2/catch.hpp>

#include "core/constants.h"

using namespace dimline;

namespace {

constexpr std::size_t kRanks = 4;

Outcome allOutside() {
  Outcome outcome;
  outcome.begin(kRanks);
  outcome.outside.assign(kRanks, 1);
  return outcome;
}

/// A moved frame in which nobody needs to look for another place, long after any did.
Mending restedFor(int frames) {
  Mending mending;
  for (int i = 0; i < frames; ++i) mending.begin();
  return mending;
}

}  // namespace

TEST_CASE("an attempt is better when it gains more than its changes cost") {
  const Outcome stays = allOutside();
  Outcome moves = allOutside();
  moves.changes = 1;
  moves.worth = -kScoreChange - 10;
  CHECK_FALSE(moves.betterThan(stays));
  moves.worth = -kScoreChange + 10;
  CHECK(moves.betterThan(stays));
  CHECK_FALSE(stays.betterThan(moves));
  CHECK_FALSE(stays.betterThan(stays));
  Outcome rounded = allOutside();
  rounded.worth = 1e-9;
  CHECK_FALSE(rounded.betterThan(stays));
}

TEST_CASE("to run across an extension line for good costs more than to change once") {
  CHECK(kScoreTangle < kScoreChange);
  CHECK(kScoreInside < kScoreTangle);
}

TEST_CASE("a line that has changed is looked at first, then those with which something is amiss, in turns") {
  Outcome outcome = allOutside();
  outcome.changed[2] = 1;
  outcome.amiss = {1, 0, 0, 1};
  Mending mending = restedFor(1);
  CHECK(mending.next(outcome) == 2);
  CHECK(mending.next(outcome) == 3);
  outcome.changed[2] = 0;
  mending.begin();
  CHECK(mending.next(outcome) == 0);
  CHECK(mending.next(outcome) == 3);
}

TEST_CASE("a frame has a bounded number of attempts") {
  Outcome outcome = allOutside();
  outcome.amiss.assign(kRanks, 1);
  Mending mending = restedFor(1);
  for (int i = 0; i < kMendingAttempts; ++i) CHECK(mending.next(outcome).has_value());
  CHECK_FALSE(mending.next(outcome).has_value());
}

TEST_CASE("when all is well, a line looks around now and then, each in its turn") {
  const Outcome outcome = allOutside();
  Mending mending;
  std::vector<std::size_t> looked;
  for (int frame = 0; frame < kFramesToLookAround * static_cast<int>(kRanks); ++frame) {
    mending.begin();
    int attempts = 0;
    while (const auto rank = mending.next(outcome)) {
      looked.push_back(*rank);
      ++attempts;
    }
    CHECK(attempts <= 1);
  }
  CHECK(looked == std::vector<std::size_t>{1, 2, 3, 0});
}

TEST_CASE("a line without a place outside is not asked to find another") {
  Outcome outcome = allOutside();
  outcome.outside.assign(kRanks, 0);
  outcome.changed.assign(kRanks, 1);
  outcome.amiss.assign(kRanks, 1);
  Mending mending = restedFor(kFramesToLookAround);
  CHECK_FALSE(mending.next(outcome).has_value());
}

TEST_CASE("a frame without lines needs no mending") {
  Outcome outcome;
  outcome.begin(0);
  Mending mending = restedFor(kFramesToLookAround);
  CHECK_FALSE(mending.next(outcome).has_value());
}
