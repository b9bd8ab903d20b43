// Growing the silhouette: pad() by a disc on all sides, pullIn() by the shapes that a placed line and its label leave. Both
// shapes are convex, so over one strip their extreme lies at the strip's nearest place to where the whole shape has it.

#include <cassert>
#include <cmath>

#include "silhouette/distance_fields.h"
#include "silhouette/float4.h"

namespace dimline {

namespace {

/// grown[i] = min(grown[i], values[i + step] - reach) and the same with -step.
void spread(std::span<const float> values, std::size_t step, float reach, float* grown) {
  if (step >= values.size()) return;
  const std::size_t count = values.size() - step;
  const float* ahead = values.data() + step;
  float* behind = grown + step;
  const Float4 reach4 = splat4(reach);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) store4(grown + i, min4(load4(ahead + i) - reach4, load4(grown + i)));
  for (; i < count; ++i) grown[i] = std::min(grown[i], ahead[i] - reach);
  for (i = 0; i + 4 <= count; i += 4) store4(behind + i, min4(load4(values.data() + i) - reach4, load4(behind + i)));
  for (; i < count; ++i) behind[i] = std::min(behind[i], values[i] - reach);
}

/// A closed interval of distances from a viewport edge.
struct Interval {
  double low;
  double high;
};

/// A convex shape in the frame of the rows or of the columns: all points within `radius` of a segment. `across` runs as x does for rows, and
/// as y does for columns.
class Capsule {
 public:
  struct Point {
    double along;
    double across;
  };

  Capsule(Point a, Point b, double radius) : a_(a), b_(b), radius_(radius) {
    if (a_.along > b_.along) std::swap(a_, b_);
    const double run = b_.along - a_.along;
    const double rise = b_.across - a_.across;
    const double length = std::hypot(run, rise);
    // The two straight sides are the segment moved by the radius at right angles to it; a_ is never after b_ along.
    sideAlong_ = length > 0 ? -rise / length * radius : 0.0;
    sideAcross_ = length > 0 ? run / length * radius : radius;
    slope_ = run > 0 ? rise / run : 0.0;
  }

  [[nodiscard]] double firstAlong() const { return a_.along - radius_; }
  [[nodiscard]] double lastAlong() const { return b_.along + radius_; }

  /// The least and greatest `across` over the strip [from, from + 1], of which the shape meets a part.
  [[nodiscard]] Interval over(double from) const {
    const Point& lowEnd = a_.across <= b_.across ? a_ : b_;
    const Point& highEnd = a_.across <= b_.across ? b_ : a_;
    const bool level = a_.across == b_.across;
    return {boundary(nearest(from, level ? a_.along : lowEnd.along, level ? b_.along : lowEnd.along), -1.0),
            boundary(nearest(from, level ? a_.along : highEnd.along, level ? b_.along : highEnd.along), +1.0)};
  }

 private:
  /// The place in the strip, and in the shape, nearest to the stretch where the shape has its extreme.
  [[nodiscard]] double nearest(double from, double stretchFirst, double stretchLast) const {
    const double place = std::clamp(std::clamp(from, stretchFirst, stretchLast), from, from + 1);
    return std::clamp(place, firstAlong(), lastAlong());
  }

  /// The shape's lower (sign -1) or upper (+1) boundary at a place along.
  [[nodiscard]] double boundary(double along, double sign) const {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Point& end : {a_, b_}) {
      const double off = along - end.along;
      const double squared = radius_ * radius_ - off * off;
      // A place at the very end of the shape is up to rounding one radius off.
      if (squared >= -1e-9 * radius_ * radius_) reach = std::max(reach, sign * end.across + std::sqrt(std::max(0.0, squared)));
    }
    const double sideFirst = a_.along + sign * sideAlong_;
    if (along >= sideFirst && along <= b_.along + sign * sideAlong_) {
      reach = std::max(reach, sign * (a_.across + sign * sideAcross_ + (along - sideFirst) * slope_));
    }
    return sign * reach;
  }

  Point a_;
  Point b_;
  double radius_;
  double sideAlong_ = 0;
  double sideAcross_ = 0;
  double slope_ = 0;
};

/// The same for all points within `radius` of a box.
class RoundedBox {
 public:
  RoundedBox(Interval along, Interval across, double radius) : along_(along), across_(across), radius_(radius) {}

  [[nodiscard]] double firstAlong() const { return along_.low - radius_; }
  [[nodiscard]] double lastAlong() const { return along_.high + radius_; }

  [[nodiscard]] Interval over(double from) const {
    const double gap = std::max({0.0, along_.low - (from + 1), from - along_.high});
    const double reach = std::sqrt(std::max(0.0, radius_ * radius_ - gap * gap));
    return {across_.low - reach, across_.high + reach};
  }

 private:
  Interval along_;
  Interval across_;
  double radius_;
};

/// Pulls in the field at the low end of `across` and the one at its high end by a shape.
template <typename Shape>
void pullInPair(DistanceField& lowField, DistanceField& highField, double extentPx, const Shape& shape) {
  const double strips = static_cast<double>(lowField.size());
  if (!(shape.lastAlong() >= 0 && shape.firstAlong() <= strips)) return;
  const double first = std::clamp(std::floor(shape.firstAlong()), 0.0, strips - 1);
  const double last = std::clamp(std::ceil(shape.lastAlong()) - 1, first, strips - 1);
  // The shape is connected over a strip, so it is seen there when its interval meets [0, extent].
  const auto seen = [&](const Interval& across) { return across.high >= 0 && across.low <= extentPx; };
  const auto firstStrip = static_cast<std::size_t>(first);
  const auto lastStrip = static_cast<std::size_t>(last);
  lowField.pullIn(firstStrip, lastStrip, [&](std::size_t strip) {
    const Interval across = shape.over(static_cast<double>(strip));
    return seen(across) ? std::max(0.0, across.low) : static_cast<double>(kNoSilhouette);
  });
  highField.pullIn(firstStrip, lastStrip, [&](std::size_t strip) {
    const Interval across = shape.over(static_cast<double>(strip));
    return seen(across) ? std::max(0.0, extentPx - across.high) : static_cast<double>(kNoSilhouette);
  });
}

}  // namespace

void pad(const DistanceFields& fields, double radiusPx, DistanceFields& padded) {
  assert(radiusPx >= 0 && &fields != &padded);
  padded.reset(fields.widthPx, fields.heightPx);
  for (const ViewportEdge edge : kViewportEdges) {
    const std::span<const float> values = fields[edge].values();
    const std::span<float> grown = padded[edge].edit();
    for (std::size_t i = 0; i < values.size(); ++i) grown[i] = values[i] - static_cast<float>(radiusPx);
    // Two strips `step` apart have step - 1 px between them; that much of the disc's radius is used up along the edge.
    for (std::size_t step = 1; static_cast<double>(step) - 1 < radiusPx; ++step) {
      const double gap = static_cast<double>(step) - 1;
      spread(values, step, static_cast<float>(std::sqrt(radiusPx * radiusPx - gap * gap)), grown.data());
    }
  }
  padded.buildTrees();
}

void pullIn(DistanceFields& fields, const Segment2& segment, double radiusPx) {
  const auto& [a, b] = segment;
  pullInPair(fields[ViewportEdge::kLeft], fields[ViewportEdge::kRight], fields.widthPx, Capsule({a.y, a.x}, {b.y, b.x}, radiusPx));
  pullInPair(fields[ViewportEdge::kTop], fields[ViewportEdge::kBottom], fields.heightPx, Capsule({a.x, a.y}, {b.x, b.y}, radiusPx));
}

void pullIn(DistanceFields& fields, const Box2& box, double radiusPx) {
  if (box.empty()) return;
  const Interval x{box.min.x, box.max.x};
  const Interval y{box.min.y, box.max.y};
  pullInPair(fields[ViewportEdge::kLeft], fields[ViewportEdge::kRight], fields.widthPx, RoundedBox(y, x, radiusPx));
  pullInPair(fields[ViewportEdge::kTop], fields[ViewportEdge::kBottom], fields.heightPx, RoundedBox(x, y, radiusPx));
}

}  // namespace dimline
