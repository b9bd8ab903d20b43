#include "editing/drag_marks.h"

#include <cmath>

namespace dimline {

Segment2 barAcross(const Vec2& at, const Vec2& along, double halfLengthPx) {
  const Vec2 across(-along.y, along.x);
  return {at - across * halfLengthPx, at + across * halfLengthPx};
}

double tickStride(double stepPx) {
  if (!(stepPx > 0) || !std::isfinite(stepPx)) return 0;
  double decade = 1;
  for (int i = 0; i < 6; ++i, decade *= 10) {
    for (const double of : {1.0, 2.0, 5.0}) {
      if (of * decade * stepPx >= kTickGapPx) return of * decade;
    }
  }
  return 0;
}

std::optional<TickGrid> tickGrid(const Parameter& snapped, double stepPx) {
  if (!(snapped.step > 0)) return std::nullopt;
  const double stride = tickStride(stepPx);
  if (!(stride > 0)) return std::nullopt;
  const double fromZero = snapped.min / snapped.step;
  const bool onZero = std::abs(fromZero - std::round(fromZero)) < 1e-6;
  return TickGrid{onZero ? 0.0 : snapped.min, stride * snapped.step};
}

double halfLengthPx(DragMark::Kind kind) {
  switch (kind) {
    case DragMark::Kind::kTick:
      return 2.5;
    case DragMark::Kind::kLongTick:
      return 4.5;
    case DragMark::Kind::kLimit:
    case DragMark::Kind::kLimitReached:
      return 9.0;
    case DragMark::Kind::kGhost:
      break;
  }
  return 6.0;
}

}  // namespace dimline
