#include "placement/placing_order.h"

#include <algorithm>
#include <cassert>

namespace dimline {

void PlacingOrder::arrange(std::span<const Measured> shortestFirst) {
  parameters_.clear();
  for (const Measured& measured : shortestFirst) parameters_.push_back(static_cast<std::int32_t>(measured.parameter));
  if (puts_.size() < parameters_.size()) puts_.insert(puts_.begin(), parameters_.size() - puts_.size(), Put{});
  sort();
}

bool PlacingOrder::isShortestFirst() const { return std::ranges::is_sorted(ranks_); }

void PlacingOrder::put(std::size_t rank, std::size_t before) {
  assert(rank != before);
  const auto known = std::ranges::find(puts_, parameters_[rank], &Put::parameter);
  const auto place = known != puts_.end() ? known : puts_.begin();   // room that is not used, or the oldest
  std::rotate(place, place + 1, puts_.end());
  puts_.back() = {parameters_[rank], parameters_[before]};
  sort();
}

void PlacingOrder::forget() {
  std::ranges::fill(puts_, Put{});
  sort();
}

/// Shortest first, and then one after the other before whom it was put.
void PlacingOrder::sort() {
  ranks_.resize(parameters_.size());
  for (std::uint32_t rank = 0; rank < ranks_.size(); ++rank) ranks_[rank] = rank;
  for (const Put& put : puts_) {
    const auto from = std::ranges::find(ranks_, rankOf(put.parameter));
    const auto to = std::find(ranks_.begin(), from, rankOf(put.before));
    if (from != ranks_.end() && to != from) std::rotate(to, from, from + 1);
  }
}

/// Of one that the model does not have, a rank that there is not.
std::uint32_t PlacingOrder::rankOf(std::int32_t parameter) const {
  return static_cast<std::uint32_t>(std::ranges::find(parameters_, parameter) - parameters_.begin());
}

}  // namespace dimline
