#include "model/polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/sort_keys.h"

// Triangulation: holes are joined to the outer ring by bridges (the shortest segment to a vertex that sees the hole),
// then ears are cut, the best-shaped one first. Polygons here have tens of points, seldom hundreds, so the square of
// that is fine.

namespace dimline {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Twice the area of the triangle, positive when counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

double lengthSquared(const Vec2& v) { return glm::dot(v, v); }

/// Triangles flatter than this share of their longest side squared count as flat.
constexpr double kFlatShare = 1e-10;

class Triangulator {
public:
  explicit Triangulator(const Polygon& polygon) {
    points_ = polygon.outer;
    ring_.resize(polygon.outer.size());
    std::iota(ring_.begin(), ring_.end(), 0U);
    for (const Ring& hole : polygon.holes) {
      std::vector<std::uint32_t>& indices = holes_.emplace_back(hole.size());
      std::iota(indices.begin(), indices.end(), static_cast<std::uint32_t>(points_.size()));
      points_.insert(points_.end(), hole.begin(), hole.end());
    }
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    joinHoles();
    cutEars();
    return std::move(triangles_);
  }

private:
  struct Node {
    std::uint32_t point;
    int previous, next;
    double quality;  ///< of the ear at this node, negative when it is none
  };

  std::vector<Vec2> points_;
  std::vector<std::uint32_t> ring_;
  std::vector<std::vector<std::uint32_t>> holes_;
  std::vector<Node> nodes_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;

  // From right to left: the rightmost point of the rightmost hole always sees a vertex of what is joined already.
  void joinHoles() {
    auto rightmost = [&](const std::vector<std::uint32_t>& hole) {
      return *std::max_element(hole.begin(), hole.end(), [&](auto a, auto b) { return points_[a].x < points_[b].x; });
    };
    std::vector<SortKey> order;
    for (std::uint32_t i = 0; i < holes_.size(); ++i) {
      if (holes_[i].size() >= 3) order.push_back({-points_[rightmost(holes_[i])].x, i});
    }
    sortKeys(order);
    for (std::size_t k = 0; k < order.size(); ++k) {
      std::vector<std::uint32_t>& indices = holes_[order[k].index];
      const std::uint32_t start = rightmost(indices);
      const std::size_t at = bridgeTo(start, std::span(order).subspan(k));
      std::rotate(indices.begin(), std::find(indices.begin(), indices.end(), start), indices.end());
      // ring … P | hole from start … start P | rest of the ring
      std::vector<std::uint32_t> loop(indices);
      loop.push_back(start);
      loop.push_back(ring_[at]);
      ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(at) + 1, loop.begin(), loop.end());
    }
  }

  /// Position in ring_ of the nearest vertex that sees `from`; the holes still to be joined stand in the way too.
  std::size_t bridgeTo(std::uint32_t from, std::span<const SortKey> remaining) const {
    const Vec2 m = points_[from];
    std::vector<SortKey> candidates(ring_.size());
    for (std::uint32_t i = 0; i < ring_.size(); ++i) candidates[i] = {lengthSquared(points_[ring_[i]] - m), i};
    sortKeys(candidates);
    for (const auto& [distanceSquared, i] : candidates) {
      const Vec2 v = points_[ring_[i]];
      if (!opensTowards(i, m) || blocked(ring_, m, v)) continue;
      const bool clear = std::none_of(remaining.begin(), remaining.end(),
                                      [&](const SortKey& h) { return blocked(holes_[h.index], m, v); });
      if (clear) return i;
    }
    assert(false && "a hole lies outside its polygon");
    return candidates.front().index;
  }

  /// Whether a step from ring vertex i towards p goes into the region. A vertex that is in the ring twice is so by
  /// one copy only.
  [[nodiscard]] bool opensTowards(std::size_t i, const Vec2& p) const {
    const std::size_t n = ring_.size();
    const Vec2 a = points_[ring_[(i + n - 1) % n]], v = points_[ring_[i]], b = points_[ring_[(i + 1) % n]];
    const bool leftOfIn = turn(a, v, p) > 0, leftOfOut = turn(v, b, p) > 0;
    return turn(a, v, b) >= 0 ? leftOfIn && leftOfOut : leftOfIn || leftOfOut;
  }

  /// Whether an edge or a vertex of the loop lies on the inside of the segment m-v.
  [[nodiscard]] bool blocked(const std::vector<std::uint32_t>& loop, const Vec2& m, const Vec2& v) const {
    const double flat = kFlatShare * lengthSquared(v - m);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = points_[loop[i]], b = points_[loop[(i + 1) % loop.size()]];
      if (a != m && a != v && std::abs(turn(m, v, a)) <= flat && glm::dot(a - m, a - v) < 0) return true;
      if (a == m || a == v || b == m || b == v) continue;
      const double s = turn(m, v, a), t = turn(m, v, b), p = turn(a, b, m), q = turn(a, b, v);
      if (s * t < 0 && p * q < 0) return true;
    }
    return false;
  }

  void cutEars() {
    const int n = static_cast<int>(ring_.size());
    nodes_.resize(ring_.size());
    for (int i = 0; i < n; ++i)
      nodes_[static_cast<std::size_t>(i)] = {ring_[static_cast<std::size_t>(i)], (i + n - 1) % n, (i + 1) % n, -1};
    for (int i = 0; i < n; ++i) rate(i);
    int first = 0;
    for (int left = n; left >= 3; --left) {
      int best = first;
      for (int i = node(first).next; i != first; i = node(i).next) {
        if (node(i).quality > node(best).quality) best = i;
      }
      assert(node(best).quality > 0 && "the polygon crosses itself");
      if (node(best).quality <= 0) return;
      const int before = node(best).previous, after = node(best).next;
      triangles_.push_back({node(before).point, node(best).point, node(after).point});
      if (left == 3) return;
      node(before).next = after;
      node(after).previous = before;
      first = before;
      rate(before);
      rate(after);
    }
  }

  Node& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }

  // A vertex on the border of the ear bars it as one inside does: otherwise it would be left over on a flat rest.
  void rate(int i) {
    Node& n = node(i);
    n.quality = -1;
    const Vec2 a = points_[node(n.previous).point], b = points_[n.point], c = points_[node(n.next).point];
    const double longest = std::max({lengthSquared(b - a), lengthSquared(c - b), lengthSquared(a - c)});
    const double area = turn(a, b, c), flat = kFlatShare * longest;
    if (area <= flat) return;
    for (int k = node(n.next).next; k != n.previous; k = node(k).next) {
      const Vec2 p = points_[node(k).point];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= -flat && turn(b, c, p) >= -flat && turn(c, a, p) >= -flat) return;
    }
    n.quality = area / longest;
  }
};

/// Whether two edges that are not neighbours meet. Touching counts: a ring that was offset so far that two of its
/// sides lie in one line has no inside there.
bool meetsItself(const Ring& ring) {
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % n];
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;
      const Vec2 c = ring[k], d = ring[(k + 1) % n];
      if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) continue;
      if (turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0) return true;
    }
  }
  return false;
}

void dropRepeated(Ring& ring, double nearM) {
  Ring kept;
  for (const Vec2& p : ring) {
    if (kept.empty() || glm::length(p - kept.back()) > nearM) kept.push_back(p);
  }
  while (kept.size() > 1 && glm::length(kept.front() - kept.back()) <= nearM) kept.pop_back();
  ring = std::move(kept);
}

/// How a vertex moves when its two edges move outwards by one metre.
Vec2 mitre(const Vec2& a, const Vec2& p, const Vec2& b) {
  const Vec2 in = glm::normalize(p - a), out = glm::normalize(b - p);
  const Vec2 n(in.y, -in.x), m(out.y, -out.x);
  return (n + m) / std::max(1 + glm::dot(n, m), 1e-3);
}

}  // namespace

double signedArea(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return twice * 0.5;
}

Ring rectangleRing(const Vec2& min, const Vec2& max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

Ring ellipseRing(const Vec2& center, const Vec2& radius, int sides, double startRad) {
  assert(sides >= 3);
  Ring ring;
  ring.reserve(static_cast<std::size_t>(sides));
  for (int i = 0; i < sides; ++i) {
    const double angle = startRad + 2 * std::numbers::pi * i / sides;
    ring.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

void orient(Polygon& polygon) {
  if (signedArea(polygon.outer) < 0) std::reverse(polygon.outer.begin(), polygon.outer.end());
  for (Ring& hole : polygon.holes) {
    if (signedArea(hole) > 0) std::reverse(hole.begin(), hole.end());
  }
}

// Moves all edges at once, up to the moment when the first one vanishes, drops it, and goes on with the rest of the
// way.
Ring offset(std::span<const Vec2> input, double distanceM) {
  Ring ring(input.begin(), input.end());
  if (signedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
  const double nearM = 1e-9;
  double left = std::abs(distanceM);
  const double sense = distanceM < 0 ? -1 : 1;
  dropRepeated(ring, nearM);
  while (ring.size() >= 3) {
    const std::size_t n = ring.size();
    std::vector<Vec2> velocity(n);
    for (std::size_t i = 0; i < n; ++i) velocity[i] = sense * mitre(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
    double step = left;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 edge = ring[(i + 1) % n] - ring[i];
      const double lengthM = glm::length(edge);
      const double growth = glm::dot(velocity[(i + 1) % n] - velocity[i], edge) / lengthM;
      if (growth < 0) step = std::min(step, -lengthM / growth);
    }
    for (std::size_t i = 0; i < n; ++i) ring[i] += velocity[i] * step;
    left -= step;
    if (left <= 0) break;
    dropRepeated(ring, nearM);
    if (ring.size() == n) break;
  }
  dropRepeated(ring, nearM);
  if (ring.size() < 3 || signedArea(ring) <= 0 || meetsItself(ring)) return {};
  return ring;
}

std::vector<EdgeNormals> edgeNormals(std::span<const Vec2> ring, double creaseRad) {
  const std::size_t n = ring.size();
  std::vector<Vec2> flat(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 e = glm::normalize(ring[(i + 1) % n] - ring[i]);
    flat[i] = {e.y, -e.x};
  }
  const double creaseCos = std::cos(creaseRad);
  const auto between = [&](const Vec2& own, const Vec2& other) {
    return glm::dot(own, other) > creaseCos ? glm::normalize(own + other) : own;
  };
  std::vector<EdgeNormals> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    normals[i] = {between(flat[i], flat[(i + n - 1) % n]), between(flat[i], flat[(i + 1) % n])};
  }
  return normals;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon) {
  if (polygon.outer.size() < 3) return {};
  return Triangulator(polygon).run();
}

}  // namespace dimline
