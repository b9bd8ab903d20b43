#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "placement/measured.h"

namespace dimline {

/// In which order a frame's lines are placed: the shortest first (paper 4.5), but for those that were put before a shorter one, since it goes better so (mending.h). What was put before
/// another stays so in the frames to come and over edits. A rank is a line's number when the shortest come first.
class PlacingOrder {
 public:
  /// The lines of a model, shortest first; those that are known already, by their parameters, stay before whom they were put.
  void arrange(std::span<const Measured> shortestFirst);
  /// The ranks in the order in which they are placed.
  [[nodiscard]] std::span<const std::uint32_t> ranks() const { return ranks_; }
  /// Whether nobody was put before a shorter one.
  [[nodiscard]] bool isShortestFirst() const;
  /// The line of a rank is placed just before another, unless it comes before it anyhow, and no longer before whom it was put until now.
  void put(std::size_t rank, std::size_t before);
  /// The shortest first again.
  void forget();

 private:
  void sort();
  [[nodiscard]] std::uint32_t rankOf(std::int32_t parameter) const;

  /// The line of one parameter was put before that of another; neither is any for room that is not used yet, so that a warmed-up frame allocates nothing.
  struct Put {
    std::int32_t parameter = -1;
    std::int32_t before = -1;
  };
  std::vector<std::int32_t> parameters_;   ///< one a rank
  std::vector<Put> puts_;                  ///< the last one at the end; as many as there are lines, one a parameter at most
  std::vector<std::uint32_t> ranks_;
};

}  // namespace dimline
