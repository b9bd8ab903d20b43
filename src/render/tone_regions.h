#pragma once

#include <cstdint>
#include <vector>

#include "math/types.h"

namespace dimline {

/// An area of one colour, as closed rings in grid coordinates (a sample is a unit square). Rings are to be filled by the even-odd rule.
struct ToneRegion {
  std::uint32_t label = 0;
  std::vector<std::vector<Vec2>> rings;
};

/// A border between two regions, from one place where three meet to the next, or closed.
struct ToneBorder {
  std::uint32_t leftLabel = 0, rightLabel = 0;  ///< of the regions on either side, seen along the points
  std::vector<Vec2> points;
};

struct ToneMap {
  std::vector<ToneRegion> regions;  ///< by label; label 0 (nothing) has none
  std::vector<ToneBorder> borders;
};

/// Outlines the regions of equal labels in a grid of `width` x `height` samples. Stairs become straight lines as far as they stay within
/// `tolerance` of the samples' border; a border is smoothed once for both its sides, so that neighbours fit without a gap.
ToneMap traceRegions(const std::vector<std::uint32_t>& labels, int width, int height, double tolerance);

}  // namespace dimline
