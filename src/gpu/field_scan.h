#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "silhouette/distance_fields.h"

namespace dimline {

/// The first covered pixel, and the one after the last, of every row and every column of a mask, in device pixels from the left and
/// from the top. Empty rows and columns have kNothing and 0.
struct MaskExtremes {
  static constexpr std::uint16_t kNothing = 0xFFFF;
  struct Range {
    std::uint16_t first = kNothing;
    std::uint16_t end = 0;
    bool operator==(const Range&) const = default;
  };
  std::vector<Range> rows;      ///< one a row: columns
  std::vector<Range> columns;   ///< one a column: rows
};

/// Finds the extremes of a mask of width x height bytes, top row first, 0 where it is not covered. Reuses `extremes`' memory.
void scanMask(std::span<const std::uint8_t> mask, int width, int height, MaskExtremes& extremes);

/// The fields, in CSS pixels, of a viewport (widthPx by heightPx, which may be fractions) whose mask has those extremes. A strip gets the
/// least distance of the device strips that it touches, so what is covered there stays blocked at any pixel ratio. Trees are built.
void fieldsFromExtremes(const MaskExtremes& extremes, double widthPx, double heightPx, DistanceFields& fields);

}  // namespace dimline
