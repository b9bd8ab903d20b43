// Growing the silhouette: pad() by a disc on all sides, pullIn() by the shapes that a placed line and its label
// leave. Both shapes are convex, so over one strip their extreme lies at the strip's nearest place to where the whole
// shape has it.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "silhouette/distance_fields.h"
#include "silhouette/float4.h"

namespace dimline {

namespace {

/// How far a disc reaches across beside its middle.
struct Reaches {
  std::size_t first = 1;              ///< strips from the middle to the first of these
  std::size_t count = 0;
  std::array<float, 32> px;
  [[nodiscard]] std::size_t last() const { return first + count - 1; }
};

/// As many steps from `first` on as there is room for. Two strips `step` apart have step - 1 px between them; that much of the radius is used up along the edge.
Reaches reaches(double radiusPx, std::size_t first) {
  Reaches reaches{.first = first, .px = {}};
  for (; reaches.count < reaches.px.size(); ++reaches.count) {
    const double gap = static_cast<double>(first + reaches.count) - 1;
    if (gap >= radiusPx) break;
    reaches.px[reaches.count] = static_cast<float>(std::sqrt(radiusPx * radiusPx - gap * gap));
  }
  return reaches;
}

/// grown[i] = min(grown[i], values[i + step] - reach, values[i - step] - reach) for those steps and the strips [begin, end).
void spread(std::span<const float> values, const Reaches& by, std::size_t begin, std::size_t end, float* grown) {
  const auto one = [&](std::size_t i) {
    float least = grown[i];
    for (std::size_t k = 0; k < by.count; ++k) {
      const std::size_t step = by.first + k;
      if (i >= step) least = std::min(least, values[i - step] - by.px[k]);
      if (i + step < values.size()) least = std::min(least, values[i + step] - by.px[k]);
    }
    grown[i] = least;
  };
  std::size_t i = begin;
  for (; i < std::min(by.last(), end); ++i) one(i);
  for (; i + 4 <= end && i + by.last() + 4 <= values.size(); i += 4) {
    Float4 least = load4(grown + i);
    for (std::size_t k = 0; k < by.count; ++k) {
      const Float4 reach = splat4(by.px[k]);
      const float* middle = values.data() + i;
      least = min4(load4(middle - by.first - k) - reach, min4(load4(middle + by.first + k) - reach, least));
    }
    store4(grown + i, least);
  }
  for (; i < end; ++i) one(i);
}

/// A closed interval of distances from a viewport edge.
struct Interval {
  double low;
  double high;
};

/// A piece of a shape's boundary over a stretch of the places along an edge: across = start + slope (along - from).
struct Line {
  double from, to;
  double start;
  double slope;

  [[nodiscard]] double at(double along) const { return start + slope * (along - from); }
};

/// One of the two boundaries, the low or the high one, of a convex shape that is a disc rolled along a segment or
/// around a box: an arc around `first`, a straight piece, an arc around `last`. `sign` is -1 for the low one, +1 for
/// the high one. `peak`: where the boundary is outermost.
struct Boundary {
  double sign;
  double radius;
  double firstAlong, firstAcross;
  double lastAlong, lastAcross;
  Line straight;
  Interval peak;

  /// The outermost place over each of four strips [strip, strip + 1], of which `first` is the first.
  [[nodiscard]] Float4 over(double first) const {
    const auto clamp = [](Float4 at, Float4 low, Float4 high) { return min4(max4(at, low), high); };
    const Float4 strip = splat(first) + kLanes;
    const Float4 outermost = clamp(clamp(strip, splat(peak.low), splat(peak.high)), strip, strip + 1.0F);
    const Float4 along = clamp(outermost, splat(firstAlong - radius), splat(lastAlong + radius));
    const auto arc = [&](double middleAlong, double middleAcross) {
      const Float4 off = along - splat(middleAlong);
      return splat(middleAcross) + splat(sign) * sqrt4(max4(splat(radius * radius) - off * off, splat4(0.0F)));
    };
    // From the strips on, not from the piece's own end: that may be so far outside the viewport that a float tells no pixels apart. And between its ends, since one that runs nearly straight across
    // has a slope that makes anything of rounding.
    const auto [lowEnd, highEnd] = std::minmax({straight.start, straight.at(straight.to)});
    const Float4 onStraight = clamp(splat(straight.at(first)) + splat(straight.slope) * (along - splat(first)), splat(lowEnd), splat(highEnd));
    const Float4 notLate = choose4(along > splat(straight.to), arc(lastAlong, lastAcross), onStraight);
    return choose4(along < splat(straight.from), arc(firstAlong, firstAcross), notLate);
  }

private:
  [[nodiscard]] static Float4 splat(double v) { return splat4(static_cast<float>(v)); }
};

/// A shape in the frame of the rows or of the columns; `across` runs as x does for rows, and as y does for columns.
struct Shape {
  Boundary low;
  Boundary high;

  [[nodiscard]] double firstAlong() const { return low.firstAlong - low.radius; }
  [[nodiscard]] double lastAlong() const { return low.lastAlong + low.radius; }
  /// No part of it lies outside this across.
  [[nodiscard]] Interval across() const {
    return {std::min(low.firstAcross, low.lastAcross) - low.radius, std::max(high.firstAcross, high.lastAcross) + high.radius};
  }
};

struct Place {
  double along;
  double across;
};

/// All points within `radius` of a segment.
Shape capsule(Place a, Place b, double radius) {
  if (a.along > b.along) std::swap(a, b);
  const double run = b.along - a.along;
  const double rise = b.across - a.across;
  const double length = std::hypot(run, rise);
  // The straight sides are the segment moved by the radius at right angles to it; where it runs straight across, they
  // have no length.
  const double sideAlong = length > 0 ? -rise / length * radius : 0.0;
  const double sideAcross = length > 0 ? run / length * radius : radius;
  const auto boundary = [&](double sign) {
    const Line straight{a.along + sign * sideAlong, b.along + sign * sideAlong, a.across + sign * sideAcross,
                        run > 0 ? rise / run : 0.0};
    const bool aIsOuter = sign * a.across >= sign * b.across;
    const bool bIsOuter = sign * b.across >= sign * a.across;
    return Boundary{sign,    radius,   a.along,  a.across,
                    b.along, b.across, straight, {aIsOuter ? a.along : b.along, bIsOuter ? b.along : a.along}};
  };
  return {boundary(-1), boundary(+1)};
}

/// All points within `radius` of a box.
Shape roundedBox(const Interval& along, const Interval& across, double radius) {
  const auto boundary = [&](double sign, double side) {
    return Boundary{sign, radius, along.low, side, along.high, side, {along.low, along.high, side + sign * radius, 0.0},
                    along};
  };
  return {boundary(-1, across.low), boundary(+1, across.high)};
}

/// Pulls in the field at the low end of `across` and the one at its high end.
class PairEdit {
public:
  PairEdit(DistanceField& lowField, DistanceField& highField, double extentPx)
      : lowField_(lowField), highField_(highField), extentPx_(extentPx) {}

  void apply(const Shape& shape) {
    const double strips = static_cast<double>(lowField_.size());
    if (!(shape.lastAlong() >= 0 && shape.firstAlong() <= strips)) return;
    const double first = std::clamp(std::floor(shape.firstAlong()), 0.0, strips - 1);
    const double last = std::clamp(std::ceil(shape.lastAlong()) - 1, first, strips - 1);
    std::size_t strip = static_cast<std::size_t>(first);
    const auto end = static_cast<std::size_t>(last) + 1;
    const auto [lowest, highest] = shape.across();
    // What lies nearer to its edge than the shape's nearest is out of its reach. Most of what lands lies behind something that has landed: an extension line behind its own
    // line, a chain's member beside the others.
    leastLow_ = static_cast<float>(std::max(0.0, lowest));
    leastHigh_ = static_cast<float>(std::max(0.0, extentPx_ - highest));
    editsLow_ = lowField_.greatestOfBlocks(strip, end - 1) > leastLow_;
    editsHigh_ = highField_.greatestOfBlocks(strip, end - 1) > leastHigh_;
    if (!editsLow_ && !editsHigh_) return;
    inside_ = lowest >= 0 && highest <= extentPx_;
    // Where both boundaries are straight and inside the viewport over a run of strips, it takes less.
    const Interval plain = plainStrips(shape);
    const auto plainFirst = static_cast<std::size_t>(std::clamp(std::ceil(plain.low), first, last + 1));
    const auto plainEnd =
        static_cast<std::size_t>(std::clamp(std::floor(plain.high), static_cast<double>(plainFirst), last + 1));
    for (; strip < plainFirst; strip += 4) pull(shape, strip, end);
    for (; strip + 4 <= plainEnd; strip += 4) pullStraight(shape, strip);
    for (; strip < end; strip += 4) pull(shape, strip, end);
    if (editsLow_) lowField_.mendTree(static_cast<std::size_t>(first), end - 1);
    if (editsHigh_) highField_.mendTree(static_cast<std::size_t>(first), end - 1);
  }

private:
  /// The places along between which both boundaries are straight and the shape is inside the viewport across.
  [[nodiscard]] Interval plainStrips(const Shape& shape) const {
    Interval plain{std::max(shape.low.straight.from, shape.high.straight.from),
                   std::min(shape.low.straight.to, shape.high.straight.to)};
    const auto keepAbove = [&](const Line& line, double bound, double sign) {  // where sign (line - bound) >= 0
      const double atFrom = sign * (line.start - bound);
      const double slope = sign * line.slope;
      if (slope > 0) {
        plain.low = std::max(plain.low, line.from - atFrom / slope);
      } else if (slope < 0) {
        plain.high = std::min(plain.high, line.from - atFrom / slope);
      } else if (atFrom < 0) {
        plain.high = plain.low;
      }
    };
    keepAbove(shape.low.straight, 0, +1);
    keepAbove(shape.high.straight, extentPx_, -1);
    return plain;
  }

  /// Four strips, but for those from `end` on.
  void pull(const Shape& shape, std::size_t strip, std::size_t end) {
    float* low = lowField_.edit().data() + strip;
    float* high = highField_.edit().data() + strip;
    const Float4 lowBefore = load4(low);
    const Float4 highBefore = load4(high);
    const bool pullsLow = editsLow_ && lanesOf(lowBefore > splat4(leastLow_)) != 0;
    const bool pullsHigh = editsHigh_ && lanesOf(highBefore > splat4(leastHigh_)) != 0;
    if (!pullsLow && !pullsHigh) return;
    const auto first = static_cast<double>(strip);
    const Float4 zero = splat4(0.0F);
    const Float4 extent = splat4(static_cast<float>(extentPx_));
    const Float4 lowest = pullsLow || !inside_ ? shape.low.over(first) : zero;
    const Float4 highest = pullsHigh || !inside_ ? shape.high.over(first) : extent;
    // The shape is connected over a strip, so it is seen there when its interval meets [0, extent].
    const Int4 seen = (splat4(static_cast<float>(strip)) + kLanes < splat4(static_cast<float>(end))) & (highest >= zero) & (lowest <= extent);
    if (pullsLow) store4(low, choose4(seen, min4(lowBefore, max4(lowest, zero)), lowBefore));
    if (pullsHigh) store4(high, choose4(seen, min4(highBefore, max4(extent - highest, zero)), highBefore));
  }

  /// Four strips over which both boundaries are straight and inside the viewport.
  void pullStraight(const Shape& shape, std::size_t strip) {
    const auto values = [&](const Line& line, double sign) {
      // A straight piece is outermost over a strip at the strip's one end or the other.
      const double at = line.at(static_cast<double>(strip) + (sign * line.slope > 0 ? 1.0 : 0.0));
      return splat4(static_cast<float>(at)) + kLanes * static_cast<float>(line.slope);
    };
    float* low = lowField_.edit().data() + strip;
    float* high = highField_.edit().data() + strip;
    const Float4 zero = splat4(0.0F);
    if (editsLow_) store4(low, min4(load4(low), max4(values(shape.low.straight, -1), zero)));
    if (editsHigh_) store4(high, min4(load4(high), max4(static_cast<float>(extentPx_) - values(shape.high.straight, +1), zero)));
  }

  DistanceField& lowField_;
  DistanceField& highField_;
  double extentPx_;
  // Of the shape at hand:
  float leastLow_ = 0;      ///< its distance from that edge where it is nearest
  float leastHigh_ = 0;
  bool editsLow_ = true;    ///< whether it can pull in that field
  bool editsHigh_ = true;
  bool inside_ = false;     ///< all of it lies between the two edges
};

}  // namespace

void pad(const DistanceFields& fields, double radiusPx, DistanceFields& padded) {
  assert(radiusPx >= 0 && &fields != &padded);
  padded.reset(fields.widthPx, fields.heightPx);
  for (const ViewportEdge edge : kViewportEdges) {
    const std::span<const float> values = fields[edge].values();
    const std::span<float> grown = padded[edge].edit();
    for (std::size_t i = 0; i < values.size(); ++i) grown[i] = values[i] - static_cast<float>(radiusPx);
    // Most of a viewport is empty on both sides of the model.
    const auto isSeen = [](float value) { return value < kNoSilhouette; };
    const auto first = static_cast<std::size_t>(std::ranges::find_if(values, isSeen) - values.begin());
    if (first == values.size()) continue;
    const auto last = values.size() - 1 - static_cast<std::size_t>(std::ranges::find_if(values.rbegin(), values.rend(), isSeen) - values.rbegin());
    const auto far = static_cast<std::size_t>(std::ceil(radiusPx));
    const std::size_t begin = first - std::min(first, far);
    const std::size_t end = std::min(last + far + 1, values.size());
    for (Reaches by = reaches(radiusPx, 1); by.count > 0; by = reaches(radiusPx, by.last() + 1)) spread(values, by, begin, end, grown.data());
  }
  padded.buildTrees();
}

void pullIn(DistanceFields& fields, const Segment2& segment, double radiusPx) {
  const auto& [a, b] = segment;
  PairEdit(fields[ViewportEdge::kLeft], fields[ViewportEdge::kRight], fields.widthPx)
      .apply(capsule({a.y, a.x}, {b.y, b.x}, radiusPx));
  PairEdit(fields[ViewportEdge::kTop], fields[ViewportEdge::kBottom], fields.heightPx)
      .apply(capsule({a.x, a.y}, {b.x, b.y}, radiusPx));
}

void pullIn(DistanceFields& fields, const Box2& box, double radiusPx) {
  if (box.empty()) return;
  const Interval x{box.min.x, box.max.x};
  const Interval y{box.min.y, box.max.y};
  PairEdit(fields[ViewportEdge::kLeft], fields[ViewportEdge::kRight], fields.widthPx).apply(roundedBox(y, x, radiusPx));
  PairEdit(fields[ViewportEdge::kTop], fields[ViewportEdge::kBottom], fields.heightPx)
      .apply(roundedBox(x, y, radiusPx));
}

}  // namespace dimline
