#include "placement/mending.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

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

/// Two lines in each of so many tangles, of which the first are those of ranks 0 and 2, and 1 and 3.
Outcome tangled(int tangles) {
  Outcome outcome = allOutside();
  outcome.tangles = tangles;
  outcome.tangled = {{0, 2}, {1, 3}};
  return outcome;
}

/// Before the frames of a movement, some of which have been already.
Mending restedFor(int frames) {
  Mending mending;
  for (int i = 0; i < frames; ++i) mending.begin();
  return mending;
}

/// All attempts at one more moved frame, none of which is any better.
std::vector<Attempt> attemptsAt(Mending& mending, const Outcome& outcome, bool shortestFirst = true) {
  std::vector<Attempt> attempts;
  mending.begin();
  while (const auto attempt = mending.next(outcome, shortestFirst)) attempts.push_back(*attempt);
  return attempts;
}

/// Those that come in turn, before what is drawn at random where lines are in a tangle or go back.
std::vector<Attempt> attemptsInTurn(Mending& mending, const Outcome& outcome, bool shortestFirst = true) {
  std::vector<Attempt> attempts = attemptsAt(mending, outcome, shortestFirst);
  if (!outcome.tangled.empty() || outcome.returns > 0) {
    REQUIRE(attempts.size() >= kShuffles);
    attempts.resize(attempts.size() - kShuffles);
  }
  return attempts;
}

/// The ranks of those who look for another place.
std::vector<std::size_t> looksOf(const std::vector<Attempt>& attempts) {
  std::vector<std::size_t> looks;
  for (const Attempt& attempt : attempts) {
    if (attempt.looks) looks.push_back(*attempt.looks);
  }
  return looks;
}

/// Those of them in which nobody looks: they are about the order.
std::vector<Attempt> ordersOf(const std::vector<Attempt>& attempts) {
  std::vector<Attempt> orders;
  for (const Attempt& attempt : attempts) {
    if (!attempt.looks) orders.push_back(attempt);
  }
  return orders;
}

bool same(const Attempt& a, const Attempt& b) {
  const auto samePut = [](const Attempt::Put& p, const Attempt::Put& q) { return p.rank == q.rank && p.before == q.before; };
  return a.looks == b.looks && a.otherSide == b.otherSide && a.shortestFirst == b.shortestFirst && a.putCount == b.putCount &&
         std::equal(a.puts.begin(), a.puts.begin() + static_cast<std::ptrdiff_t>(a.putCount), b.puts.begin(), samePut);
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

TEST_CASE("to run across an extension line for good costs more than to change once, and to do so for a moment does not") {
  const auto with = [](int tangles, double ahead, double changes) {
    Outcome outcome = allOutside();
    outcome.tangles = tangles;
    outcome.tanglesAhead = ahead;
    outcome.changes = changes;
    return outcome;
  };
  CHECK(with(1, 0, 1).betterThan(with(2, 1, 0)));
  CHECK_FALSE(with(1, 0, 1).betterThan(with(2, 0, 0)));
  CHECK(kScoreInside < kScoreTangle);
}

TEST_CASE("of attempts that change as much the one with fewer lines across extension lines ahead is better, and for what is only ahead no more lines change") {
  const auto with = [](double ahead, double changes) {
    Outcome outcome = allOutside();
    outcome.tanglesAhead = ahead;
    outcome.changes = changes;
    return outcome;
  };
  CHECK(with(0, 1).betterThan(with(1, 1)));
  CHECK_FALSE(with(1, 1).betterThan(with(0, 1)));
  CHECK_FALSE(with(0, 1).betterThan(with(9, 0)));
  CHECK(with(9, 0).betterThan(with(0, 1)));
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

TEST_CASE("a way back to what was left lately costs more than any other change, for a picture without a line that runs across something too") {
  for (const bool zooms : {false, true}) {
    Outcome amiss = allOutside();
    amiss.begin(kRanks, {.zooms = zooms});
    amiss.tangles = 1;
    Outcome moves = allOutside();
    moves.begin(kRanks, {.zooms = zooms});
    moves.changes = 1;
    CHECK(moves.betterThan(amiss));
    moves.returns = 1;
    CHECK_FALSE(moves.betterThan(amiss));
  }
}

TEST_CASE("while the camera comes nearer or goes away, a change is worth each line less that runs across something, however soon it will be over") {
  const auto with = [](int tangles, double changes, bool zooms) {
    Outcome outcome = allOutside();
    outcome.begin(kRanks, {.zooms = zooms});
    outcome.tangles = tangles;
    outcome.changes = changes;
    return outcome;
  };
  for (const bool zooms : {false, true}) {
    CHECK(with(1, 1, zooms).betterThan(with(2, 0, zooms)) == zooms);
    CHECK(with(1, 2, zooms).betterThan(with(2, 0, zooms)) == zooms);
    CHECK_FALSE(with(1, 3, zooms).betterThan(with(2, 0, zooms)));
  }
}

TEST_CASE("of two lines in a tangle the later one is to be placed before the earlier one, pair by pair") {
  const Outcome outcome = tangled(2);
  Mending mending;
  std::vector<std::pair<std::size_t, std::size_t>> put;
  for (int frame = 0; frame < 3; ++frame) {
    const auto orders = ordersOf(attemptsInTurn(mending, outcome));
    REQUIRE(orders.size() == 1);
    CHECK_FALSE(orders[0].shortestFirst);
    CHECK_FALSE(orders[0].winsTies);
    REQUIRE(orders[0].putCount == 1);
    put.emplace_back(orders[0].puts[0].rank, orders[0].puts[0].before);
  }
  CHECK(put == std::vector<std::pair<std::size_t, std::size_t>>{{2, 0}, {3, 1}, {2, 0}});
}

TEST_CASE("a line that went back to what it had left lately is to be placed before who else has changed its place") {
  Outcome outcome = tangled(2);
  outcome.returns = 1;
  outcome.returned = 3;
  outcome.changed[3] = 1;
  Mending mending;
  const auto puts = [&] {
    const auto orders = ordersOf(attemptsInTurn(mending, outcome));
    REQUIRE(orders.size() == 1);
    REQUIRE(orders[0].putCount == 1);
    return std::pair(orders[0].puts[0].rank, orders[0].puts[0].before);
  };
  CHECK(puts() == std::pair<std::size_t, std::size_t>(2, 0));   // of the first two in a tangle: nobody else has
  outcome.changed[1] = 1;
  CHECK(puts() == std::pair<std::size_t, std::size_t>(3, 1));
}

TEST_CASE("where nothing is amiss the shortest come first again, if not at once, when that is no worse") {
  const Outcome fine = allOutside();
  Mending mending;
  CHECK(ordersOf(attemptsAt(mending, fine)).empty());
  int back = 0;
  for (int frame = 0; frame < 2 * kShortestFirstEvery; ++frame) {
    for (const Attempt& order : ordersOf(attemptsAt(mending, fine, false))) {
      CHECK(order.shortestFirst);
      CHECK(order.winsTies);
      CHECK(order.putCount == 0);
      ++back;
    }
  }
  CHECK(back == 2);
}

TEST_CASE("while lines are in a tangle the shortest come first again only where that order may have nested lines wrongly") {
  Outcome outcome = tangled(2);
  const auto goesBack = [&] {
    Mending mending;
    bool back = false;
    for (int frame = 0; frame < kShortestFirstEvery; ++frame) {
      for (const Attempt& order : ordersOf(attemptsInTurn(mending, outcome, false))) back = back || order.shortestFirst;
    }
    return back;
  };
  CHECK_FALSE(goesBack());
  outcome.nestedWrongly = 1;
  CHECK(goesBack());
}

TEST_CASE("where lines are in a tangle, more is tried at random: other places and other orders") {
  Mending mending;
  std::vector<Attempt> drawn;
  for (int frame = 0; frame < 50; ++frame) {
    std::vector<Attempt> attempts = attemptsAt(mending, tangled(1));
    REQUIRE(attempts.size() >= kShuffles + 1);   // another order in turn, and perhaps someone who looks, come first
    CHECK_FALSE(attempts.front().otherSide);
    drawn.insert(drawn.end(), attempts.end() - kShuffles, attempts.end());
  }
  std::vector<int> looked(kRanks, 0);
  int orders = 0;
  int both = 0;
  for (const Attempt& attempt : drawn) {
    CHECK_FALSE(attempt.winsTies);
    CHECK(attempt.otherSide);
    REQUIRE(attempt.putCount <= kMostPuts);
    if (attempt.looks) {
      REQUIRE(*attempt.looks < kRanks);
      ++looked[*attempt.looks];
    }
    if (attempt.putCount > 0) {
      ++orders;
      both += attempt.looks ? 1 : 0;
      const auto [rank, before] = attempt.puts[0];
      CHECK(((rank == 2 && before == 0) || (rank == 3 && before == 1)));
    }
    for (std::size_t i = 0; i < attempt.putCount; ++i) {
      CHECK(attempt.puts[i].rank < kRanks);
      CHECK(attempt.puts[i].before < kRanks);
      CHECK(attempt.puts[i].rank != attempt.puts[i].before);
    }
  }
  for (const int times : looked) CHECK(times > 0);
  CHECK(orders > 0);
  CHECK(both > 0);
  CHECK(std::ranges::any_of(drawn, &Attempt::shortestFirst));
  CHECK_FALSE(std::ranges::all_of(drawn, &Attempt::shortestFirst));
}

TEST_CASE("where a line goes back to what it had left lately, more is tried at random too") {
  Outcome outcome = allOutside();
  outcome.changed = {1, 1, 0, 0};
  Mending mending;
  CHECK(ordersOf(attemptsAt(mending, outcome)).empty());
  outcome.returns = 1;
  outcome.returned = 1;
  const std::vector<Attempt> attempts = attemptsAt(mending, outcome);
  REQUIRE(attempts.size() == 2 + kShuffles);   // who has changed looks, and another order in turn
  CHECK_FALSE(attempts[1].otherSide);
  CHECK(std::all_of(attempts.begin() + 2, attempts.end(), [](const Attempt& attempt) { return attempt.otherSide; }));
}

TEST_CASE("what is tried at random is the same in every flight, and not the same in every frame") {
  Mending one;
  Mending other;
  const std::vector<Attempt> first = attemptsAt(one, tangled(1));
  const std::vector<Attempt> again = attemptsAt(other, tangled(1));
  CHECK(std::ranges::equal(first, again, same));
  const std::vector<Attempt> next = attemptsAt(one, tangled(1));
  CHECK_FALSE(std::ranges::equal(first, next, same));
  // A copy goes on as the original does.
  Mending copy = one;
  CHECK(std::ranges::equal(attemptsAt(one, tangled(1)), attemptsAt(copy, tangled(1)), same));
}

TEST_CASE("a line that has changed is looked at first, then those with which something is amiss, in turns") {
  Outcome outcome = allOutside();
  outcome.changed[2] = 1;
  outcome.amiss = {1, 0, 0, 1};
  Mending mending;
  CHECK(looksOf(attemptsAt(mending, outcome)) == std::vector<std::size_t>{2, 3, 0});
  outcome.changed[2] = 0;
  CHECK(looksOf(attemptsAt(mending, outcome)) == std::vector<std::size_t>{3, 0});
}

TEST_CASE("a frame has a bounded number of attempts") {
  Outcome outcome = tangled(1);
  outcome.amiss.assign(kRanks, 1);
  Mending mending;
  CHECK(attemptsAt(mending, outcome).size() == kMendingAttempts + 1 + kShuffles);
  outcome.tangled.clear();
  CHECK(attemptsAt(mending, outcome).size() == kMendingAttempts);
}

TEST_CASE("in a first picture every line looks for another place, once, and more is tried where lines are in a tangle") {
  Outcome outcome = allOutside();
  outcome.frame.isFirst = true;
  outcome.outside[3] = 0;   // one inside the model may come out
  Mending mending;
  const std::vector<Attempt> attempts = attemptsAt(mending, outcome);
  CHECK(looksOf(attempts) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(attempts.size() == kRanks);
  outcome.tangled = {{0, 2}};
  CHECK(attemptsAt(mending, outcome).size() == kRanks + 1 + kShufflesAtFirst);
}

TEST_CASE("where lines settle every line looks for another place, and more is tried in any case") {
  Outcome outcome = allOutside();
  outcome.frame.settles = true;
  Mending mending;
  const std::vector<Attempt> attempts = attemptsAt(mending, outcome);
  REQUIRE(attempts.size() == kRanks + kShufflesSettling);
  for (const Attempt& attempt : attempts) {
    for (std::size_t i = 0; i < attempt.putCount; ++i) CHECK(attempt.puts[i].rank != attempt.puts[i].before);
  }
  // Of a single line there is no other order.
  Outcome single;
  single.begin(1, {.settles = true});
  single.outside.assign(1, 1);
  CHECK(attemptsAt(mending, single).size() == 1);
}

TEST_CASE("a first picture of very many lines has a bounded number of attempts") {
  Outcome outcome;
  outcome.begin(10 * kLooksAtRest, {.isFirst = true});
  outcome.outside.assign(10 * kLooksAtRest, 1);
  outcome.tangled = {{0, 2}};
  Mending mending;
  CHECK(attemptsAt(mending, outcome).size() == kLooksAtRest + 1 + kShufflesAtFirst);
}

TEST_CASE("in a first picture changes cost nothing, nor do ways back") {
  Outcome stays = allOutside();
  stays.frame.isFirst = true;
  Outcome moves = stays;
  moves.changes = 3;
  moves.returns = 1;
  moves.worth = 2;
  CHECK(moves.betterThan(stays));
  moves.worth = 0;
  CHECK_FALSE(moves.betterThan(stays));
}

TEST_CASE("where lines settle each looks once too, and a change must bring more than it costs there") {
  Outcome stays = allOutside();
  stays.frame.settles = true;
  Mending mending;
  const std::vector<std::size_t> looks = looksOf(attemptsAt(mending, stays));
  for (std::size_t rank = 0; rank < kRanks; ++rank) CHECK(looks[rank] == rank);
  Outcome moves = stays;
  moves.changes = 2;
  moves.worth = -2 * kScoreChangeSettling - 2;
  CHECK_FALSE(moves.betterThan(stays));
  moves.worth += 4;
  CHECK(moves.betterThan(stays));
  // In a movement it costs far more.
  moves.frame.settles = stays.frame.settles = false;
  CHECK_FALSE(moves.betterThan(stays));
}

TEST_CASE("when all is well, a line looks around now and then, each in its turn") {
  const Outcome outcome = allOutside();
  Mending mending;
  std::vector<std::size_t> looked;
  for (int frame = 0; frame < kFramesToLookAround * static_cast<int>(kRanks); ++frame) {
    const std::vector<Attempt> attempts = attemptsAt(mending, outcome);
    CHECK(attempts.size() <= 1);
    for (const std::size_t rank : looksOf(attempts)) looked.push_back(rank);
  }
  CHECK(looked == std::vector<std::size_t>{1, 2, 3, 0});
}

TEST_CASE("a line without a place outside is not asked to find another") {
  Outcome outcome = allOutside();
  outcome.outside.assign(kRanks, 0);
  outcome.changed.assign(kRanks, 1);
  outcome.amiss.assign(kRanks, 1);
  Mending mending = restedFor(kFramesToLookAround);
  CHECK(attemptsAt(mending, outcome).empty());
}

TEST_CASE("a frame without lines needs no mending") {
  Outcome outcome;
  outcome.begin(0);
  Mending mending = restedFor(kFramesToLookAround);
  CHECK(attemptsAt(mending, outcome).empty());
}
