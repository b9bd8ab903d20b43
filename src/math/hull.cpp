#include "math/hull.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/sort_keys.h"

namespace dimline {

namespace {

/// Distance of `p` to the left of the line from a to b.
double leftOf(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const double length = glm::length(d);
  return length > 0 ? (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / length : 0.0;
}

/// By x and then y, each once; of points that stand above one another the lowest and the highest, because no others can be corners.
std::vector<Vec2> sortedByX(std::span<const Vec2> points) {
  std::vector<SortKey> keys;
  keys.reserve(points.size());
  for (const Vec2& p : points) keys.push_back({p.x, static_cast<std::uint32_t>(keys.size())});
  sortKeys(keys);
  std::vector<Vec2> sorted;
  for (auto key = keys.begin(); key != keys.end();) {
    const double x = key->value;
    double low = points[key->index].y, high = low;
    for (++key; key != keys.end() && key->value == x; ++key) {
      low = std::min(low, points[key->index].y);
      high = std::max(high, points[key->index].y);
    }
    sorted.emplace_back(x, low);
    if (high > low) sorted.emplace_back(x, high);
  }
  return sorted;
}

}  // namespace

std::vector<Vec2> convexHull(std::span<const Vec2> points, double tolerance) {
  const std::vector<Vec2> sorted = sortedByX(points);
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
