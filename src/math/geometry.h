#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "math/types.h"

namespace dimline {

/// An axis-aligned box in the world. Empty (min > max) until something is added.
struct Bounds {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool empty() const { return min.x > max.x; }
  [[nodiscard]] Vec3 center() const { return (min + max) * 0.5; }
  [[nodiscard]] Vec3 size() const { return empty() ? Vec3(0.0) : max - min; }
  /// Length of the diagonal: "the model's size" where a threshold is a share of it.
  [[nodiscard]] double diagonal() const { return glm::length(size()); }
  void add(const Vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] Vec3 corner(int i) const {
    return {(i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y, (i & 4) != 0 ? max.z : min.z};
  }
};

/// An oriented box: a corner, three orthonormal axes (right-handed), and the size along each (metres, >= 0).
///
///        +----------+
///       /|         /|      axes[1]
///      +----------+ |        ^  axes[2] (towards the viewer)
///      | +--------|-+        | /
///      |/         |/         |/
///    origin ------+          +---> axes[0]
struct Obb {
  Vec3 origin{0.0};
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 size{0.0};

  /// The point at (u, v, w) in units of the box: (0,0,0) is the origin, (1,1,1) the opposite corner.
  [[nodiscard]] Vec3 at(const Vec3& uvw) const {
    return origin + axes[0] * (uvw.x * size.x) + axes[1] * (uvw.y * size.y) + axes[2] * (uvw.z * size.z);
  }
  [[nodiscard]] Vec3 corner(int i) const {
    return at({(i & 1) != 0 ? 1.0 : 0.0, (i & 2) != 0 ? 1.0 : 0.0, (i & 4) != 0 ? 1.0 : 0.0});
  }
  [[nodiscard]] Vec3 center() const { return at({0.5, 0.5, 0.5}); }
};

inline bool isFinite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The direction of a vector, unit length; zero for one without.
template <typename Vector>
Vector unitOrZero(const Vector& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vector(0.0);
}

/// An oriented plane. `normal` has unit length.
struct Plane {
  Vec3 point{0.0};
  Vec3 normal{0, 1, 0};
};

/// A directed segment in the world.
struct Segment {
  Vec3 start{0.0};
  Vec3 end{0.0};
  [[nodiscard]] double length() const { return glm::length(end - start); }
  [[nodiscard]] Vec3 middle() const { return (start + end) * 0.5; }
};

/// A directed segment on screen (px).
struct Segment2 {
  Vec2 start{0.0};
  Vec2 end{0.0};
  [[nodiscard]] double length() const { return glm::length(end - start); }
  [[nodiscard]] Vec2 middle() const { return (start + end) * 0.5; }
  /// At that share of its length from its start.
  [[nodiscard]] Vec2 at(double share) const { return start + (end - start) * share; }
};

/// An axis-aligned box on screen (px). Empty until something is added.
struct Box2 {
  Vec2 min{std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity()};

  bool operator==(const Box2&) const = default;
  [[nodiscard]] static Box2 around(const Vec2& center, const Vec2& size) { return {center - size * 0.5, center + size * 0.5}; }
  [[nodiscard]] bool empty() const { return min.x > max.x || min.y > max.y; }
  [[nodiscard]] Vec2 center() const { return (min + max) * 0.5; }
  void add(const Vec2& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] Box2 grown(double byPx) const { return {min - byPx, max + byPx}; }
  /// Its border included; false for a NaN.
  [[nodiscard]] bool contains(const Vec2& p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  [[nodiscard]] bool contains(const Box2& o) const { return contains(o.min) && contains(o.max); }
  [[nodiscard]] bool overlaps(const Box2& o) const {
    return min.x < o.max.x && o.min.x < max.x && min.y < o.max.y && o.min.y < max.y;
  }
};

namespace detail {
/// Whether all of a segment lies before or beyond a stretch of an axis, as most do.
inline bool liesBeside(const Segment2& s, int axis, double low, double high) {
  return std::max(s.start[axis], s.end[axis]) < low || std::min(s.start[axis], s.end[axis]) > high;
}
inline bool liesBeside(const Segment2& s, const Segment2& other, int axis) {
  return liesBeside(s, axis, std::min(other.start[axis], other.end[axis]), std::max(other.start[axis], other.end[axis]));
}
bool carriersCross(const Segment2& a, const Segment2& b, double byPx);
}  // namespace detail

/// Whether two segments on screen cross at an inner point of both (touching ends do not count, nor do overlaps on one line), and each
/// reaches past the other by more than `byPx` at both ends, at right angles to it.
inline bool segmentsCross(const Segment2& a, const Segment2& b, double byPx = 0) {
  return !detail::liesBeside(a, b, 0) && !detail::liesBeside(a, b, 1) && detail::carriersCross(a, b, byPx);
}

/// A part of a segment, as shares of its length from its start; 0 <= enter <= leave <= 1.
struct Stretch {
  double enter = 0, leave = 1;
};

/// Where a segment runs within a box, its border included; nothing when it misses the box.
std::optional<Stretch> stretchWithin(const Segment2& s, const Box2& box);

/// That part of the segment.
std::optional<Segment2> clipped(const Segment2& s, const Box2& box);

/// Distance between two segments on screen (px): 0 where they meet.
double distanceBetween(const Segment2& a, const Segment2& b);

/// Distance of a point from a segment on screen (px).
double distanceBetween(const Vec2& p, const Segment2& s);

/// Whether a segment on screen meets a box, its border included.
inline bool meets(const Segment2& s, const Box2& box) {
  return !detail::liesBeside(s, 0, box.min.x, box.max.x) && !detail::liesBeside(s, 1, box.min.y, box.max.y) && clipped(s, box).has_value();
}

}  // namespace dimline
