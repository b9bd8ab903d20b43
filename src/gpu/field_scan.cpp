#include "gpu/field_scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dimline {

namespace {

/// One past the last byte that is not zero, given that there is one. Eight at a time, since most of a row is empty.
std::size_t endOfCovered(const std::uint8_t* row, std::size_t width) {
  std::size_t end = width;
  while (end >= 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, row + end - 8, 8);
    if (word != 0) break;
    end -= 8;
  }
  while (end > 0 && row[end - 1] == 0) --end;
  return end;
}

std::size_t firstCovered(const std::uint8_t* row, std::size_t width) {
  std::size_t first = 0;
  while (first + 8 <= width) {
    std::uint64_t word = 0;
    std::memcpy(&word, row + first, 8);
    if (word != 0) break;
    first += 8;
  }
  while (first < width && row[first] == 0) ++first;
  return first;
}

/// Strips of CSS pixels along one viewport edge, each from the device strips that it touches; `perPx` device pixels a CSS pixel.
template <typename Set>
void eachStrip(std::span<const MaskExtremes::Range> device, double perPx, std::size_t strips, Set set) {
  // Rounding of the ratio must not make a strip touch a neighbour that it only borders on.
  constexpr double kSlack = 1e-6;
  for (std::size_t i = 0; i < strips; ++i) {
    const auto first = static_cast<std::size_t>(std::floor(static_cast<double>(i) * perPx + kSlack));
    const auto end = std::min(device.size(), static_cast<std::size_t>(std::ceil(static_cast<double>(i + 1) * perPx - kSlack)));
    MaskExtremes::Range range;
    for (std::size_t d = std::min(first, device.size()); d < end; ++d) {
      range.first = std::min(range.first, device[d].first);
      range.end = std::max(range.end, device[d].end);
    }
    set(i, range);
  }
}

}  // namespace

void scanMask(std::span<const std::uint8_t> mask, int width, int height, MaskExtremes& extremes) {
  const auto w = static_cast<std::size_t>(width);
  const auto h = static_cast<std::size_t>(height);
  extremes.rows.assign(h, {});
  extremes.columns.assign(w, {});
  for (std::size_t y = 0; y < h; ++y) {
    const std::uint8_t* const row = mask.data() + y * w;
    const std::size_t first = firstCovered(row, w);
    if (first == w) continue;
    const std::size_t end = endOfCovered(row, w);
    extremes.rows[y] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end)};
    for (std::size_t x = first; x < end; ++x) {
      MaskExtremes::Range& column = extremes.columns[x];
      const bool covered = row[x] != 0;
      column.first = covered ? std::min(column.first, static_cast<std::uint16_t>(y)) : column.first;
      column.end = covered ? static_cast<std::uint16_t>(y + 1) : column.end;
    }
  }
}

void fieldsFromExtremes(const MaskExtremes& extremes, double widthPx, double heightPx, DistanceFields& fields) {
  fields.reset(static_cast<int>(std::ceil(widthPx)), static_cast<int>(std::ceil(heightPx)));
  const double perPxX = static_cast<double>(extremes.columns.size()) / widthPx;
  const double perPxY = static_cast<double>(extremes.rows.size()) / heightPx;
  const auto fill = [&](ViewportEdge near, ViewportEdge far, std::span<const MaskExtremes::Range> device, double perPxAlong,
                        double perPxAcross) {
    const std::span<float> nearValues = fields[near].edit();
    const std::span<float> farValues = fields[far].edit();
    const double extent = fields.extentPx(near);
    eachStrip(device, perPxAlong, nearValues.size(), [&](std::size_t i, const MaskExtremes::Range& range) {
      if (range.end == 0) return;
      nearValues[i] = static_cast<float>(range.first / perPxAcross);
      farValues[i] = static_cast<float>(std::max(0.0, extent - range.end / perPxAcross));
    });
  };
  fill(ViewportEdge::kLeft, ViewportEdge::kRight, extremes.rows, perPxY, perPxX);
  fill(ViewportEdge::kTop, ViewportEdge::kBottom, extremes.columns, perPxX, perPxY);
  fields.buildTrees();
}

}  // namespace dimline
