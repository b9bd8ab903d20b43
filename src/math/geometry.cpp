#include "math/geometry.h"

namespace dimline {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

bool detail::carriersCross(const Segment2& a, const Segment2& b, double byPx) {
  const Vec2 da = a.end - a.start;
  const Vec2 db = b.end - b.start;
  // Each is the distance of an end from the other's carrier, times that one's length.
  const double a0 = cross(db, a.start - b.start);
  const double a1 = cross(db, a.end - b.start);
  const double b0 = cross(da, b.start - a.start);
  const double b1 = cross(da, b.end - a.start);
  if (!(a0 * a1 < 0 && b0 * b1 < 0)) return false;
  return byPx <= 0 || (std::min(std::abs(a0), std::abs(a1)) > byPx * glm::length(db) &&
                       std::min(std::abs(b0), std::abs(b1)) > byPx * glm::length(da));
}

double distanceBetween(const Vec2& p, const Segment2& s) {
  const Vec2 d = s.end - s.start;
  const double lengthSquared = glm::dot(d, d);
  const double u = lengthSquared > 0 ? std::clamp(glm::dot(p - s.start, d) / lengthSquared, 0.0, 1.0) : 0.0;
  return glm::length(p - (s.start + d * u));
}

double distanceBetween(const Segment2& a, const Segment2& b) {
  if (segmentsCross(a, b)) return 0.0;
  return std::min({distanceBetween(a.start, b), distanceBetween(a.end, b), distanceBetween(b.start, a),
                   distanceBetween(b.end, a)});
}

std::optional<Stretch> stretchWithin(const Segment2& s, const Box2& box) {
  // Liang-Barsky: the part of the segment inside the box's four half-planes.
  Stretch stretch;
  const Vec2 d = s.end - s.start;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (s.start[axis] < box.min[axis] || s.start[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[axis] - s.start[axis]) / d[axis];
    const double t1 = (box.max[axis] - s.start[axis]) / d[axis];
    stretch.enter = std::max(stretch.enter, std::min(t0, t1));
    stretch.leave = std::min(stretch.leave, std::max(t0, t1));
  }
  if (!(stretch.enter <= stretch.leave)) return std::nullopt;
  return stretch;
}

std::optional<Segment2> clipped(const Segment2& s, const Box2& box) {
  const auto stretch = stretchWithin(s, box);
  if (!stretch) return std::nullopt;
  return Segment2{s.at(stretch->enter), s.at(stretch->leave)};
}

}  // namespace dimline
