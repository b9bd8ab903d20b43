#include "placement/mending.h"

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

void Outcome::begin(std::size_t ranks) {
  worth = 0;
  changes = 0;
  changed.assign(ranks, 0);
  outside.assign(ranks, 0);
  amiss.assign(ranks, 0);
}

bool Outcome::betterThan(const Outcome& other) const {
  constexpr double kLeastGainPx = 1.0;
  return worth - other.worth + kScoreChange * (changes - other.changes) > kLeastGainPx;
}

void Mending::begin() {
  attempts_ = 0;
  first_.reset();
  ++frames_;
}

std::optional<std::size_t> Mending::next(const Outcome& outcome) {
  if (attempts_ >= kMendingAttempts) return std::nullopt;
  const std::size_t ranks = outcome.outside.size();
  const auto outsideAnd = [&](const std::vector<char>& flags) { return [&](std::size_t rank) { return outcome.outside[rank] != 0 && flags[rank] != 0; }; };
  if (attempts_++ == 0) {
    std::size_t last = ranks - 1;   // the shortest of them comes first
    first_ = nextInTurn(ranks, last, outsideAnd(outcome.changed));
    if (!first_ && frames_ >= kFramesToLookAround) {
      frames_ = 0;
      first_ = nextInTurn(ranks, lastOfAll_, outsideAnd(outcome.outside));
    }
    if (!first_) first_ = nextInTurn(ranks, lastAmiss_, outsideAnd(outcome.amiss));
    return first_;
  }
  // Nobody twice: what was not found in the first attempt is not found in the second.
  return nextInTurn(ranks, lastAmiss_, [&](std::size_t rank) { return rank != first_ && outcome.outside[rank] != 0 && outcome.amiss[rank] != 0; });
}

}  // namespace dimline
