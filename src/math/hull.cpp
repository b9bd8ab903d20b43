#include "math/hull.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace dimline {

namespace {

/// Distance of `p` to the left of the line from a to b.
double leftOf(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const double length = glm::length(d);
  return length > 0 ? (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / length : 0.0;
}

}  // namespace

std::vector<Vec2> convexHull(std::span<const Vec2> points, double tolerance) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 2) return sorted;

  // Andrew's monotone chain: the lower side from left to right, then the upper side back.
  std::vector<Vec2> hull;
  const auto addSide = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= start + 2 && leftOf(hull[hull.size() - 2], *it, hull.back()) >= -tolerance) hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();   // the other side begins with it
  };
  addSide(sorted.begin(), sorted.end());
  addSide(sorted.rbegin(), sorted.rend());
  return hull;
}

}  // namespace dimline
