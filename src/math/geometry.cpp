#include "math/geometry.h"

namespace dimline {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

bool segmentsCross(const Segment2& a, const Segment2& b) {
  const Vec2 da = a.end - a.start;
  const Vec2 db = b.end - b.start;
  const double a0 = cross(db, a.start - b.start);
  const double a1 = cross(db, a.end - b.start);
  const double b0 = cross(da, b.start - a.start);
  const double b1 = cross(da, b.end - a.start);
  return ((a0 > 0 && a1 < 0) || (a0 < 0 && a1 > 0)) && ((b0 > 0 && b1 < 0) || (b0 < 0 && b1 > 0));
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

bool meets(const Segment2& s, const Box2& box) {
  // Liang-Barsky: the part of the segment inside the box's four half-planes.
  double enter = 0.0;
  double leave = 1.0;
  const Vec2 d = s.end - s.start;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (s.start[axis] < box.min[axis] || s.start[axis] > box.max[axis]) return false;
      continue;
    }
    double t0 = (box.min[axis] - s.start[axis]) / d[axis];
    double t1 = (box.max[axis] - s.start[axis]) / d[axis];
    if (t0 > t1) std::swap(t0, t1);
    enter = std::max(enter, t0);
    leave = std::min(leave, t1);
  }
  return enter <= leave;
}

}  // namespace dimline
