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

TEST_CASE("more may change for a picture in which no line runs across something than for one less that does") {
  const auto with = [](int tangles) {
    Outcome outcome = allOutside();
    outcome.tangles = tangles;
    return outcome;
  };
  Outcome oneLess = with(1);
  oneLess.changes = 2;
  CHECK_FALSE(oneLess.betterThan(with(2)));
  Outcome none = with(0);
  none.changes = 2;
  CHECK(none.betterThan(with(1)));
  CHECK_FALSE(with(1).betterThan(none));
  Outcome nested = with(0);
  nested.nestedWrongly = 1;
  CHECK(with(0).betterThan(nested));
}

TEST_CASE("of two lines in a tangle the later one is to be placed before the earlier one, pair by pair") {
  Outcome outcome = allOutside();
  outcome.tangles = 2;
  outcome.tangled = {{0, 2}, {1, 3}};
  Mending mending = restedFor(1);
  std::vector<std::pair<std::size_t, std::size_t>> put;
  for (int frame = 0; frame < 3; ++frame) {
    const auto order = mending.nextOrder(outcome, true);
    REQUIRE(order);
    CHECK_FALSE(order->shortestFirst);
    put.emplace_back(order->rank, order->before);
  }
  CHECK(put == std::vector<std::pair<std::size_t, std::size_t>>{{2, 0}, {3, 1}, {2, 0}});
}

TEST_CASE("where nothing is amiss the shortest come first again, if not at once") {
  const Outcome fine = allOutside();
  Mending mending = restedFor(1);
  CHECK_FALSE(mending.nextOrder(fine, true));
  int back = 0;
  for (int frame = 0; frame < 2 * kShortestFirstEvery; ++frame) {
    const auto order = mending.nextOrder(fine, false);
    if (order && order->shortestFirst) ++back;
  }
  CHECK(back == 2);
}

TEST_CASE("while lines are in a tangle the shortest come first again only where that order may have nested lines wrongly") {
  Outcome outcome = allOutside();
  outcome.tangles = 1;
  outcome.tangled = {{0, 2}};
  const auto goesBack = [&] {
    Mending mending = restedFor(1);
    bool back = false;
    for (int frame = 0; frame < kShortestFirstEvery; ++frame) back = mending.nextOrder(outcome, false)->shortestFirst || back;
    return back;
  };
  CHECK_FALSE(goesBack());
  outcome.nestedWrongly = 1;
  CHECK(goesBack());
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
