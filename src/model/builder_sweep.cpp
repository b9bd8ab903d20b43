#include <cassert>
#include <cmath>

#include "model/builder.h"

// Sections drawn along a path. The frame of the section goes along without turning about the path; where the path
// bends, the section's lines before and after meet in the plane that halves the bend.

namespace dimline {

namespace {

Vec3 rotated(const Vec3& v, const Vec3& from, const Vec3& to) {
  // The least rotation that takes one unit vector to another (never opposite ones here).
  const Vec3 axis = glm::cross(from, to);
  const double c = glm::dot(from, to);
  return v * c + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1 + c));
}

/// A path with the frame of each of its segments.
struct Path {
  std::vector<Vec3> points;
  std::vector<double> widths;
  bool closed;
  double bendCos;
  std::vector<Vec3> way, right, up;

  Path(std::span<const Vec3> input, const Builder::SweepOptions& options)
      : closed(options.closed), bendCos(std::cos(options.bendRad)) {
    assert(options.widths.empty() || options.widths.size() == input.size());
    for (std::size_t i = 0; i < input.size(); ++i) {
      if (!points.empty() && glm::length(input[i] - points.back()) <= MeshBuilder::kNothingM) continue;
      points.push_back(input[i]);
      widths.push_back(options.widths.empty() ? 1 : options.widths[i]);
    }
    if (closed && points.size() > 1 && glm::length(points.front() - points.back()) <= MeshBuilder::kNothingM) {
      points.pop_back();
      widths.pop_back();
    }
    if (points.size() < (closed ? 3U : 2U)) return;
    const std::size_t segments = closed ? points.size() : points.size() - 1;
    for (std::size_t s = 0; s < segments; ++s) {
      way.push_back(glm::normalize(points[(s + 1) % points.size()] - points[s]));
      assert(s > 0 || glm::length(glm::cross(way[0], options.up)) > 1e-6);  // up must not lie along the path
      right.push_back(
          glm::normalize(s == 0 ? glm::cross(way[0], options.up) : rotated(right[s - 1], way[s - 1], way[s])));
      up.push_back(glm::cross(right[s], way[s]));
    }
  }

  [[nodiscard]] std::size_t segments() const { return way.size(); }

  /// Where the section's point q lies at path point i: on the line through it along the segment before (after, at the
  /// start), in the plane there.
  [[nodiscard]] Vec3 at(std::size_t i, const Vec2& unscaled) const {
    const std::size_t s = i == 0 ? 0 : i - 1;
    const Vec2 q = unscaled * widths[i];
    const bool bend = closed || (i > 0 && i < segments());
    const Vec3 plane = bend ? glm::normalize(way[(i + segments() - 1) % segments()] + way[i % segments()]) : way[s];
    const Vec3 o = right[s] * q.x + up[s] * q.y;
    return points[i] + o - way[s] * (glm::dot(o, plane) / glm::dot(way[s], plane));
  }

  /// The outward normal along segment s where the section, at its point q, has the normal n: it leans to the end at which the
  /// section is smaller.
  [[nodiscard]] Vec3 flatNormal(std::size_t s, const Vec2& q, const Vec2& n) const {
    const std::size_t next = (s + 1) % points.size();
    const double lean = (widths[s] - widths[next]) * glm::dot(q, n) / glm::length(points[next] - points[s]);
    return glm::normalize(right[s] * n.x + up[s] * n.y + way[s] * lean);
  }

  /// The segment on the other side of one of the segment's two ends, where the bend there is soft; else the segment itself.
  [[nodiscard]] std::size_t softNeighbour(std::size_t s, bool atEnd) const {
    if (!closed && (atEnd ? s + 1 == segments() : s == 0)) return s;
    const std::size_t other = (s + (atEnd ? 1 : segments() - 1)) % segments();
    return glm::dot(way[s], way[other]) > bendCos ? other : s;
  }
};

}  // namespace

void Builder::sweep(const Ring& input, std::span<const Vec3> pathInput, const SweepOptions& options) {
  Polygon section{input, {}};
  orient(section);
  const Ring& ring = section.outer;
  const Path path(pathInput, options);
  if (ring.size() < 3 || path.segments() == 0) return;

  MeshBuilder& out = mesh();
  out.beginPart();
  const std::size_t n = ring.size(), count = path.points.size();
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec2& q : ring) points.push_back(out.point(toMesh(path.at(i, q))));
  }

  // Normals of each segment where the section's edges start and end, two for each edge.
  const std::vector<EdgeNormals> normals = edgeNormals(ring, options.creaseRad);
  std::vector<Vec3> flat;
  flat.reserve(path.segments() * 2 * n);
  for (std::size_t s = 0; s < path.segments(); ++s) {
    for (std::size_t i = 0; i < n; ++i) {
      flat.push_back(path.flatNormal(s, ring[i], normals[i].start));
      flat.push_back(path.flatNormal(s, ring[(i + 1) % n], normals[i].end));
    }
  }

  double along = 0;
  for (std::size_t s = 0; s < path.segments(); ++s) {
    const std::size_t from = s * n, to = (s + 1) % count * n;
    const double nextAlong = along + glm::length(path.points[(s + 1) % count] - path.points[s]);
    const std::size_t before = path.softNeighbour(s, false), after = path.softNeighbour(s, true);
    // At a soft bend both segments have the mean of their normals.
    const auto normal = [&](std::size_t other, std::size_t which) {
      const Vec3& own = flat[2 * n * s + which];
      return directionToMesh(other == s ? own : glm::normalize(own + flat[2 * n * other + which]));
    };
    double around = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const double nextAround = around + glm::length(ring[j] - ring[i]);
      out.quad({points[from + j], normal(before, 2 * i + 1), glm::vec2(nextAround, along)},
               {points[from + i], normal(before, 2 * i), glm::vec2(around, along)},
               {points[to + i], normal(after, 2 * i), glm::vec2(around, nextAlong)},
               {points[to + j], normal(after, 2 * i + 1), glm::vec2(nextAround, nextAlong)}, material());
      around = nextAround;
    }
    along = nextAlong;
  }
  if (path.closed) return;

  const Vec3 nearNormal = directionToMesh(-path.way.front()), farNormal = directionToMesh(path.way.back());
  const auto cap = [&](std::size_t i, std::uint32_t q, const Vec3& normal) {
    return MeshBuilder::Corner{points[i * n + q], normal, glm::vec2(ring[q])};
  };
  for (const auto& [a, b, c] : triangulate(section)) {
    out.triangle(cap(0, a, nearNormal), cap(0, b, nearNormal), cap(0, c, nearNormal), material());
    out.triangle(cap(count - 1, c, farNormal), cap(count - 1, b, farNormal), cap(count - 1, a, farNormal), material());
  }
}

}  // namespace dimline
