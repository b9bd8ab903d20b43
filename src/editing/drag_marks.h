#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "editing/snap.h"
#include "math/camera.h"
#include "model/parameter.h"

namespace dimline {

/// A stroke that a drag shows beside its line (px).
///
///              ghost     tick   limit
///      <---------:---->  '  '  '  |        the old extent, the values that come next, the end of the range
struct DragMark {
  enum class Kind : std::uint8_t {
    kTick,           ///< a value that the drag can stop at
    kLongTick,       ///< every fifth of them
    kLimit,          ///< the least or the greatest value
    kLimitReached,   ///< the same, while the value is there
    kGhost           ///< the extent at the drag's beginning: a line along it, or a bar at its end
  } kind = Kind::kTick;
  Segment2 line;
  double strength = 1;   ///< 0 to 1: ticks fade with their distance from the handle
};

/// Ticks are at least so far apart (px), and shown up to so far from the handle.
inline constexpr double kTickGapPx = 6.0;
inline constexpr double kTickReachPx = 150.0;

/// The bar across a line at `at` (px), whose direction on screen is `along` (unit length).
Segment2 barAcross(const Vec2& at, const Vec2& along, double halfLengthPx);

/// How many steps there are from one tick to the next: 1, 2, 5, 10, 20 … so that ticks are kTickGapPx apart when steps are `stepPx`. 0 when no number does.
double tickStride(double stepPx);

/// Half the length of each sort of bar (px).
double halfLengthPx(DragMark::Kind kind);

/// How strong a tick is at a distance (px) from the handle; not above 0 where there is none.
inline double tickStrength(double distancePx) { return 1.0 - distancePx / kTickReachPx; }

/// No more ticks than this on either side of the handle.
inline constexpr int kMostTicks = 40;

/// The values at which ticks may stand, by a whole number: multiples of a stride of steps, round ones where the range begins on a step from zero.
struct TickGrid {
  double origin = 0;
  double step = 0;
  [[nodiscard]] double at(double n) const { return origin + n * step; }
  [[nodiscard]] double nearest(double value) const { return std::round((value - origin) / step); }
};

/// The grid of a parameter as snappedBy() has it, whose steps are so far apart on screen. Nothing for one without steps, or when no stride will do.
std::optional<TickGrid> tickGrid(const Parameter& snapped, double stepPx);

/// Adds ticks on both sides of the handle, at the values that a drag of `snapped` (snappedBy()) can stop at; only round ones where all would be too close.
/// `placeOf(value)`: where the dragged end is then on screen, or nothing; called some hundred times.
template <typename PlaceOf>
void addTicks(const Parameter& snapped, double value, PlaceOf placeOf, std::vector<DragMark>& marks) {
  const std::optional<Vec2> handle = placeOf(value);
  if (!handle) return;
  // Which way and how far one step goes here, by a step towards the side that has room.
  const double sense = value + snapped.step <= snapped.max ? 1.0 : -1.0;
  const std::optional<Vec2> next = placeOf(value + sense * snapped.step);
  if (!next) return;
  const auto grid = tickGrid(snapped, glm::length(*next - *handle));
  if (!grid) return;
  const double nearest = grid->nearest(value);
  for (double n = nearest - kMostTicks; n <= nearest + kMostTicks; ++n) {
    const double at = grid->at(n);
    if (at < snapped.min - 1e-9 * grid->step || at > snapped.max + 1e-9 * grid->step) continue;
    const std::optional<Vec2> place = placeOf(at);
    const std::optional<Vec2> beside = placeOf(at + sense * 0.01 * grid->step);
    if (!place || !beside || !(glm::length(*beside - *place) > 0)) continue;
    const double strength = tickStrength(glm::length(*place - *handle));
    if (!(strength > 0)) continue;
    const auto kind = std::fmod(std::abs(n), 5.0) == 0.0 ? DragMark::Kind::kLongTick : DragMark::Kind::kTick;
    marks.push_back({kind, barAcross(*place, glm::normalize(*beside - *place), halfLengthPx(kind)), strength});
  }
}

}  // namespace dimline
