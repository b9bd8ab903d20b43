#include "app/cover_cost.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "editing/arc_projection.h"

namespace dimline {

namespace {

// px² of a number that something counts as. A number is some 50 px wide and 17 px high, the boxes that look for a place are 60 to 220 px wide and 25 to 40 px
// high: a line across one of them is what a corner of a number is, for that is no number any more; a model behind all of it, which is what people look at while
// they change it, is as much as some lines.
constexpr double kLinePx = 0.15;            // per px of its length
constexpr double kExtensionPx = 0.05;       // likewise
constexpr double kModelShare = 0.02;        // per px²
constexpr double kArrowReachPx = 8.0;       // an arrowhead counts as a square about it, to so far

double lengthWithin(const Segment2& segment, const Box2& box) {
  const auto part = clipped(segment, box);
  return part ? part->length() : 0.0;
}

double lengthWithin(std::span<const Vec2> points, const Box2& box) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += lengthWithin(Segment2{points[i], points[i + 1]}, box);
  return length;
}

double areaWithin(const Box2& shape, const Box2& box) {
  const Vec2 size = glm::min(shape.max, box.max) - glm::max(shape.min, box.min);
  return std::max(size.x, 0.0) * std::max(size.y, 0.0);
}

double handlesWithin(std::span<const Handle> handles, const Box2& box) {
  double area = 0;
  for (const Handle& handle : handles) area += areaWithin(Box2{handle.screen, handle.screen}.grown(kArrowReachPx), box);
  return area;
}

/// The part of [from, to] that lies between two fields, strip by strip: `near` and `far` measure from opposite edges `extentPx` apart.
double areaBetween(const DistanceField& near, const DistanceField& far, double extentPx, double stripFrom, double stripTo, double from, double to) {
  const auto count = static_cast<double>(near.size());
  const auto first = static_cast<std::size_t>(std::clamp(std::floor(stripFrom), 0.0, count));
  const auto last = static_cast<std::size_t>(std::clamp(std::ceil(stripTo), 0.0, count));
  double area = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double begin = std::max(from, static_cast<double>(near.at(i)));
    const double end = std::min(to, extentPx - static_cast<double>(far.at(i)));
    area += std::max(end - begin, 0.0);
  }
  return area;
}

/// The least that rows and columns leave of the box for the model (px²).
double modelWithin(const Box2& box, const DistanceFields& fields) {
  const double byRows = areaBetween(fields[ViewportEdge::kLeft], fields[ViewportEdge::kRight], fields.widthPx, box.min.y, box.max.y, box.min.x, box.max.x);
  const double byColumns = areaBetween(fields[ViewportEdge::kTop], fields[ViewportEdge::kBottom], fields.heightPx, box.min.x, box.max.x, box.min.y, box.max.y);
  return std::min(byRows, byColumns);
}

}  // namespace

double coverCost(const Box2& box, const Layout& drawn, const DistanceFields& fields) {
  double cost = 0;
  for (const PlacedLine& line : drawn.lines) {
    if (line.label) cost += areaWithin(*line.label, box);
    cost += handlesWithin(line.handles, box);
    cost += kLinePx * lengthWithin(line.lineScreen, box);
    cost += kExtensionPx * (lengthWithin(line.extensionStart, box) + lengthWithin(line.extensionEnd, box));
  }
  std::vector<Vec2> points;
  for (const PlacedHandle& other : drawn.others) {
    cost += areaWithin(other.box, box) + handlesWithin(other.handles, box);
    if (other.arc) {
      if (arcOnScreen(*other.arc, drawn.view, points)) cost += kLinePx * lengthWithin(points, box);
    } else if (!other.box.contains(other.anchor)) {
      cost += kExtensionPx * lengthWithin(Segment2{other.anchor, other.box.center()}, box);
    }
  }
  const bool fits = fields.widthPx == static_cast<int>(std::ceil(drawn.view.widthPx())) && fields.heightPx == static_cast<int>(std::ceil(drawn.view.heightPx()));
  if (fits) cost += kModelShare * modelWithin(box, fields);
  return cost;
}

}  // namespace dimline
