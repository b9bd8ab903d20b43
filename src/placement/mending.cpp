#include "placement/mending.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/constants.h"

namespace dimline {

namespace {

/// The first rank after `last`, going round, that fits; `last` becomes that one.
template <typename Fits>
std::optional<std::size_t> nextInTurn(std::size_t ranks, std::size_t& last, Fits fits) {
  for (std::size_t i = 1; i <= ranks; ++i) {
    const std::size_t rank = (last + i) % ranks;
    if (!fits(rank)) continue;
    last = rank;
    return rank;
  }
  return std::nullopt;
}

}  // namespace

void Outcome::begin(std::size_t ranks, const FrameKind& kind) {
  frame = kind;
  worth = 0;
  changes = 0;
  returns = 0;
  changed.assign(ranks, 0);
  outside.assign(ranks, 0);
  amiss.assign(ranks, 0);
  tangles = nestedWrongly = 0;
  tanglesAhead = 0;
  tangled.clear();
  tangled.reserve(ranks);
}

bool Outcome::betterThan(const Outcome& other) const {
  constexpr double kLeastGainPx = 1.0;
  const double factor = frame.zooms || frame.rests() ? kAmissFactor : 1.0;
  const auto amissPx = [&](const Outcome& outcome) { return factor * (kScoreTangle * outcome.tangles + kScoreNestedWrongly * outcome.nestedWrongly); };
  // What leaves the picture without any may change more; what would bring the first one in for fewer changes must save as many.
  const bool untangles = (tangles == 0) != (other.tangles == 0);
  const double onePx = frame.isFirst ? 0.0 : frame.settles ? kScoreChangeSettling : kScoreChange;
  const double changePx = onePx * (untangles ? kChangeShareToUntangle : 1.0);
  const double returnPx = onePx * kChangesOfReturn;
  // For what is only ahead no more lines change: it may never come.
  double aheadPx = factor * kScoreTangle * (tanglesAhead - other.tanglesAhead);
  const bool changesForIt = aheadPx > 0 ? changes > other.changes && tangles >= other.tangles : changes < other.changes && tangles <= other.tangles;
  if (changesForIt) aheadPx = 0;
  return worth - other.worth + amissPx(*this) - amissPx(other) + aheadPx + changePx * (changes - other.changes) + returnPx * (returns - other.returns) > kLeastGainPx;
}

void Mending::begin() {
  looks_ = 0;
  ordered_ = false;
  shuffles_ = 0;
  ++frames_;
}

std::optional<Attempt> Mending::next(const Outcome& outcome, bool shortestFirst) {
  if (outcome.frame.rests()) {
    if (looks_ < std::min(outcome.outside.size(), kLooksAtRest)) return Attempt{.looks = looks_++};
  } else if (looks_ < kMendingAttempts) {
    if (const auto rank = nextToLook(outcome)) return Attempt{.looks = rank};
    looks_ = kMendingAttempts;
  }
  if (!std::exchange(ordered_, true)) {
    if (const auto order = nextOrder(outcome, shortestFirst)) return order;
  }
  const FrameKind& frame = outcome.frame;
  const int most = frame.settles ? kShufflesSettling : frame.isFirst ? kShufflesAtFirst : kShuffles;
  const bool wanted = frame.settles || !outcome.tangled.empty() || outcome.returns > 0;
  if (!wanted || shuffles_ == most || outcome.outside.size() < 2) return std::nullopt;
  ++shuffles_;
  return shuffle(outcome);
}

std::optional<std::size_t> Mending::nextToLook(const Outcome& outcome) {
  const std::size_t ranks = outcome.outside.size();
  // Nobody twice: what was not found in the first attempt is not found in the second.
  const std::span looked(looked_.begin(), looks_);
  const auto outsideAnd = [&](const std::vector<char>& flags) {
    return [&](std::size_t rank) { return outcome.outside[rank] != 0 && flags[rank] != 0 && std::ranges::find(looked, rank) == looked.end(); };
  };
  std::optional<std::size_t> found;
  if (looks_ == 0) {
    std::size_t last = ranks - 1;   // the shortest of them comes first
    found = nextInTurn(ranks, last, outsideAnd(outcome.changed));
    if (!found && frames_ >= kFramesToLookAround) {
      frames_ = 0;
      found = nextInTurn(ranks, lastOfAll_, outsideAnd(outcome.outside));
    }
  }
  if (!found) found = nextInTurn(ranks, lastAmiss_, outsideAnd(outcome.amiss));
  if (found) looked_[looks_++] = *found;
  return found;
}

std::optional<Attempt> Mending::nextOrder(const Outcome& outcome, bool shortestFirst) {
  if (outcome.returns > 0) {
    std::size_t last = outcome.returned;
    const auto pushed = nextInTurn(outcome.changed.size(), last, [&](std::size_t rank) { return rank != outcome.returned && outcome.changed[rank] != 0; });
    if (pushed) return Attempt{.puts = {{{.rank = outcome.returned, .before = *pushed}}}, .putCount = 1};
  }
  const bool back = !shortestFirst && (outcome.tangled.empty() || outcome.nestedWrongly > 0);
  if (outcome.tangled.empty() && !back) return std::nullopt;
  const std::size_t turn = orders_++;
  if (back && turn % kShortestFirstEvery == 0) return Attempt{.shortestFirst = true, .winsTies = true};
  if (outcome.tangled.empty()) return std::nullopt;
  const auto [earlier, later] = outcome.tangled[turn % outcome.tangled.size()];
  return Attempt{.puts = {{{.rank = later, .before = earlier}}}, .putCount = 1};
}

/// Mostly another order, and mostly someone who looks for another place, both rather of lines that are in a tangle. The next best place mostly is beside the one that is left, and no better for the
/// others, so it is to be on another side.
Attempt Mending::shuffle(const Outcome& outcome) {
  const std::size_t ranks = outcome.outside.size();
  const auto [earlier, later] = outcome.tangled.empty() ? anyTwo(ranks) : outcome.tangled[anyOf(outcome.tangled.size())];
  Attempt attempt{.otherSide = true, .shortestFirst = anyOf(4) == 0};
  attempt.putCount = anyOf(kMostPuts + 1);
  attempt.puts[0] = {.rank = later, .before = earlier};
  for (std::size_t i = 1; i < attempt.putCount; ++i) {
    const auto [rank, before] = anyTwo(ranks);
    attempt.puts[i] = {.rank = rank, .before = before};
  }
  // One time in three nobody looks.
  const std::array looks{later, earlier, anyOf(ranks), anyOf(ranks)};
  if (const std::size_t i = anyOf(6); i < looks.size()) attempt.looks = looks[i];
  return attempt;
}

}  // namespace dimline
