#include "silhouette/strip_scan.h"

#include <utility>

namespace dimline {

namespace {

/// One strip: the nearer of two fields takes the least `away`, the farther what is left beyond the greatest.
void take(float& nearValue, float& farValue, double extent, double low, double high) {
  nearValue = std::min(nearValue, static_cast<float>(low));
  farValue = std::min(farValue, static_cast<float>(extent - high));
}

/// A segment from (along0, away0) to (along1, away1) into a pair of opposite fields.
void scanPair(double along0, double away0, double along1, double away1, int lastStrip, double extent, float* nearField, float* farField) {
  if (along0 > along1) {
    std::swap(along0, along1);
    std::swap(away0, away1);
  }
  const int first = std::min(static_cast<int>(along0), lastStrip);
  int last = std::min(static_cast<int>(along1), lastStrip);
  if (last > first && last == along1) --last;  // only touches its last strip
  if (first == last) {
    take(nearField[first], farField[first], extent, std::min(away0, away1), std::max(away0, away1));
    return;
  }
  const double slope = (away1 - away0) / (along1 - along0);
  // Within a strip the extremes lie where the segment enters and leaves it; which is which, the slope says.
  double enter = away0;
  for (int strip = first; strip < last; ++strip) {
    const double leave = away0 + (strip + 1 - along0) * slope;
    take(nearField[strip], farField[strip], extent, std::min(enter, leave), std::max(enter, leave));
    enter = leave;
  }
  take(nearField[last], farField[last], extent, std::min(enter, away1), std::max(enter, away1));
}

}  // namespace

StripScan::StripScan(DistanceFields& fields)
    : widthPx_(fields.widthPx),
      heightPx_(fields.heightPx),
      left_(fields[ViewportEdge::kLeft].edit().data()),
      right_(fields[ViewportEdge::kRight].edit().data()),
      top_(fields[ViewportEdge::kTop].edit().data()),
      bottom_(fields[ViewportEdge::kBottom].edit().data()) {}

void StripScan::scanInside(const Vec2& a, const Vec2& b) {
  scanPair(a.y, a.x, b.y, b.x, static_cast<int>(heightPx_) - 1, widthPx_, left_, right_);
  scanPair(a.x, a.y, b.x, b.y, static_cast<int>(widthPx_) - 1, heightPx_, top_, bottom_);
}

void StripScan::scan(const Vec2& a, const Vec2& b) {
  // Liang-Barsky: the part of the segment between the viewport's four sides.
  const Vec2 d = b - a;
  const Vec2 end(widthPx_, heightPx_);
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) {
      if (a[axis] < 0 || a[axis] > end[axis]) return;
      continue;
    }
    const double atLow = -a[axis] / d[axis];
    const double atHigh = (end[axis] - a[axis]) / d[axis];
    enter = std::max(enter, std::min(atLow, atHigh));
    leave = std::min(leave, std::max(atLow, atHigh));
  }
  if (!(enter <= leave)) return;
  // Rounding may leave the ends a hair outside.
  const Vec2 from = enter > 0 ? glm::clamp(a + d * enter, Vec2(0.0), end) : a;
  const Vec2 to = leave < 1 ? glm::clamp(a + d * leave, Vec2(0.0), end) : b;
  scanInside(from, to);
}

}  // namespace dimline
