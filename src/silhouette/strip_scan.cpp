#include "silhouette/strip_scan.h"

#include <utility>

#include "silhouette/float4.h"

namespace dimline {

namespace {

/// A segment in the frame of the rows or of the columns, from the lesser place along to the greater.
struct Run {
  double along0, away0;
  double along1, away1;
};

/// The strip in which a place lies: the nearest one when it lies beyond them all, the first when it is no number, as from cameras at distances where rounding leaves nothing.
int stripAt(double along, int lastStrip) { return static_cast<int>(along > 0 ? std::min(along, static_cast<double>(lastStrip)) : 0.0); }

/// Scans a run into a pair of opposite fields.
void scanPair(const Run& run, int lastStrip, double extent, float* nearField, float* farField) {
  const auto take = [&](int strip, double one, double other) {
    nearField[strip] = std::min(nearField[strip], static_cast<float>(std::min(one, other)));
    farField[strip] = std::min(farField[strip], static_cast<float>(extent - std::max(one, other)));
  };
  const int first = stripAt(run.along0, lastStrip);
  int last = stripAt(run.along1, lastStrip);
  if (last > first && last == run.along1) --last;  // only touches its last strip
  if (first == last) {
    take(first, run.away0, run.away1);
    return;
  }
  // Within a strip the extremes lie where the segment enters it and where it leaves it.
  const double slope = (run.away1 - run.away0) / (run.along1 - run.along0);
  double enter = run.away0 + (first + 1 - run.along0) * slope;
  take(first, run.away0, enter);
  int strip = first + 1;
  if (last - strip >= 4) {
    const auto step = static_cast<float>(slope);
    const auto low = static_cast<float>(std::min(slope, 0.0));
    const auto high = static_cast<float>(extent - std::max(slope, 0.0));
    for (; strip + 4 <= last; strip += 4) {
      const Float4 enters = static_cast<float>(run.away0 + (strip - run.along0) * slope) + kLanes * step;
      store4(nearField + strip, min4(load4(nearField + strip), enters + low));
      store4(farField + strip, min4(load4(farField + strip), high - enters));
    }
    enter = run.away0 + (strip - run.along0) * slope;
  }
  for (; strip < last; ++strip) {
    const double leave = run.away0 + (strip + 1 - run.along0) * slope;
    take(strip, enter, leave);
    enter = leave;
  }
  take(last, enter, run.away1);
}

/// Whether all values are at most `bound`.
bool allAtMost(const float* values, std::size_t count, float bound) {
  const Float4 bound4 = splat4(bound);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    if (lanesOf(load4(values + i) <= bound4) != 0xF) return false;
  }
  for (; i < count; ++i) {
    if (!(values[i] <= bound)) return false;
  }
  return true;
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
  const Run rows = a.y <= b.y ? Run{a.y, a.x, b.y, b.x} : Run{b.y, b.x, a.y, a.x};
  const Run columns = a.x <= b.x ? Run{a.x, a.y, b.x, b.y} : Run{b.x, b.y, a.x, a.y};
  scanPair(rows, static_cast<int>(heightPx_) - 1, widthPx_, left_, right_);
  scanPair(columns, static_cast<int>(widthPx_) - 1, heightPx_, top_, bottom_);
}

void StripScan::scan(const Vec2& a, const Vec2& b) {
  const Segment2 edge{a, b};
  const Vec2 end(widthPx_, heightPx_);
  const auto stretch = stretchWithin(edge, {Vec2(0.0), end});
  if (!stretch) return;
  // Rounding may leave the ends a hair outside.
  const auto onScreenAt = [&](double share) { return glm::clamp(edge.at(share), Vec2(0.0), end); };
  scanInside(stretch->enter > 0 ? onScreenAt(stretch->enter) : a, stretch->leave < 1 ? onScreenAt(stretch->leave) : b);
}

bool StripScan::knows(float left, float right, float top, float bottom) const {
  const auto width = static_cast<float>(widthPx_);
  const auto height = static_cast<float>(heightPx_);
  left = std::max(left, 0.0F);
  top = std::max(top, 0.0F);
  right = std::min(right, width);
  bottom = std::min(bottom, height);
  if (!(left <= right && top <= bottom)) return false;
  const auto firstRow = static_cast<std::size_t>(std::min(top, height - 1));
  const auto rows = static_cast<std::size_t>(std::min(bottom, height - 1)) - firstRow + 1;
  const auto firstColumn = static_cast<std::size_t>(std::min(left, width - 1));
  const auto columns = static_cast<std::size_t>(std::min(right, width - 1)) - firstColumn + 1;
  return allAtMost(left_ + firstRow, rows, left) && allAtMost(right_ + firstRow, rows, width - right) &&
         allAtMost(top_ + firstColumn, columns, top) && allAtMost(bottom_ + firstColumn, columns, height - bottom);
}

}  // namespace dimline
