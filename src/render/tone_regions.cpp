#include "render/tone_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

// Between samples of different labels runs a border, along the sides of the samples. Corners where exactly two such sides meet are inside a
// border; all others are nodes. A border is followed from node to node, smoothed, and kept under both of its sides' labels; a region's
// rings are its borders put end to end.

namespace dimline {

namespace {

/// Ways from a corner of the grid: right, down, left, up.
constexpr std::array<int, 4> kStepX{1, 0, -1, 0};
constexpr std::array<int, 4> kStepY{0, 1, 0, -1};

double distanceFromLine(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length = glm::length(d);
  if (length == 0) return glm::length(p - a);
  return std::abs(d.x * (p.y - a.y) - d.y * (p.x - a.x)) / length;
}

/// Douglas and Peucker's: keeps both ends and whatever leaves the straight line by more than the tolerance.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance) {
  std::vector<char> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open;
  const auto split = [&](std::size_t first, std::size_t last, double least) {
    double worst = least;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distanceFromLine(points[i], points[first], points[last]);
      if (d > worst) {
        worst = d;
        at = i;
      }
    }
    if (at == 0) return;
    keep[at] = 1;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  };
  // A closed border has no line between its ends to start from.
  split(0, points.size() - 1, points.front() == points.back() ? 0.0 : tolerance);
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    split(first, last, tolerance);
  }
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i] != 0) result.push_back(points[i]);
  }
  return result;
}

class Tracer {
public:
  Tracer(const std::vector<std::uint32_t>& labels, int width, int height, double tolerance)
      : labels_(labels), width_(width), height_(height), tolerance_(tolerance) {}

  ToneMap trace() {
    // Each side is walked once; bit d of a corner says that the side in direction d has been.
    walked_.assign(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1), 0);
    eachCorner([&](int x, int y) { return degree(x, y) != 2; });
    eachCorner([](int, int) { return true; });  // what is left are rings without a node
    assemble();
    return std::move(map_);
  }

private:
  [[nodiscard]] std::uint32_t label(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
    return labels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }
  /// The labels left and right of the side that leaves a corner in a direction.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> sides(int x, int y, int direction) const {
    switch (direction) {
      case 0:
        return {label(x, y - 1), label(x, y)};
      case 1:
        return {label(x, y), label(x - 1, y)};
      case 2:
        return {label(x - 1, y), label(x - 1, y - 1)};
      default:
        return {label(x - 1, y - 1), label(x, y - 1)};
    }
  }
  [[nodiscard]] bool isBorder(int x, int y, int direction) const {
    const auto [left, right] = sides(x, y, direction);
    return left != right;
  }
  [[nodiscard]] int degree(int x, int y) const {
    int count = 0;
    for (int d = 0; d < 4; ++d) count += isBorder(x, y, d) ? 1 : 0;
    return count;
  }
  [[nodiscard]] std::uint8_t& walked(int x, int y) {
    return walked_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) + static_cast<std::size_t>(x)];
  }

  template <typename Starts>
  void eachCorner(Starts starts) {
    for (int y = 0; y <= height_; ++y) {
      for (int x = 0; x <= width_; ++x) {
        for (int d = 0; d < 4; ++d) {
          if (isBorder(x, y, d) && (walked(x, y) & (1U << static_cast<unsigned>(d))) == 0 && starts(x, y))
            follow(x, y, d);
        }
      }
    }
  }

  /// Walks from a corner to the next node, or round to the start.
  void follow(int startX, int startY, int direction) {
    ToneBorder border;
    std::tie(border.leftLabel, border.rightLabel) = sides(startX, startY, direction);
    // The middles of the sides are within half a sample of the line that the stairs stand for; their corners are not.
    std::vector<Vec2> points = {{startX, startY}};
    int x = startX, y = startY;
    for (;;) {
      walked(x, y) = static_cast<std::uint8_t>(walked(x, y) | 1U << static_cast<unsigned>(direction));
      points.emplace_back(x + 0.5 * kStepX[static_cast<std::size_t>(direction)],
                          y + 0.5 * kStepY[static_cast<std::size_t>(direction)]);
      x += kStepX[static_cast<std::size_t>(direction)];
      y += kStepY[static_cast<std::size_t>(direction)];
      const int back = (direction + 2) % 4;
      walked(x, y) = static_cast<std::uint8_t>(walked(x, y) | 1U << static_cast<unsigned>(back));
      if (degree(x, y) != 2 || (x == startX && y == startY)) break;
      for (int d = 0; d < 4; ++d) {
        if (d != back && isBorder(x, y, d)) {
          direction = d;
          break;
        }
      }
    }
    if (x == startX && y == startY && degree(x, y) == 2) {
      points.front() = points.back();  // no node holds the corner it started from
    } else {
      points.emplace_back(x, y);
    }
    border.points = simplified(points, tolerance_);
    map_.borders.push_back(std::move(border));
  }

  /// Puts each region's borders end to end, with the region on the right.
  void assemble() {
    struct Piece {
      std::size_t border;
      bool reversed;
    };
    std::map<std::uint32_t, std::vector<Piece>> pieces;
    for (std::size_t i = 0; i < map_.borders.size(); ++i) {
      if (map_.borders[i].rightLabel != 0) pieces[map_.borders[i].rightLabel].push_back({i, false});
      if (map_.borders[i].leftLabel != 0) pieces[map_.borders[i].leftLabel].push_back({i, true});
    }
    const auto key = [](const Vec2& p) { return std::pair{p.x, p.y}; };
    for (const auto& [name, list] : pieces) {
      ToneRegion region;
      region.label = name;
      std::multimap<std::pair<double, double>, Piece> byStart;
      for (const Piece& piece : list) {
        const auto& points = map_.borders[piece.border].points;
        byStart.emplace(key(piece.reversed ? points.back() : points.front()), piece);
      }
      while (!byStart.empty()) {
        std::vector<Vec2> ring;
        auto next = byStart.begin();
        const auto start = next->first;
        while (next != byStart.end()) {
          const Piece piece = next->second;
          byStart.erase(next);
          const auto& points = map_.borders[piece.border].points;
          if (piece.reversed) {
            ring.insert(ring.end(), points.rbegin(), points.rend() - 1);
          } else {
            ring.insert(ring.end(), points.begin(), points.end() - 1);
          }
          const auto end = key(piece.reversed ? points.front() : points.back());
          // At a node where a region meets itself any of its borders goes on: even-odd filling does not mind.
          next = end == start ? byStart.end() : byStart.find(end);
        }
        // Smoothing can leave nothing of a ring of a few samples.
        if (ring.size() >= 3) region.rings.push_back(std::move(ring));
      }
      map_.regions.push_back(std::move(region));
    }
  }

  const std::vector<std::uint32_t>& labels_;
  int width_, height_;
  double tolerance_;
  std::vector<std::uint8_t> walked_;
  ToneMap map_;
};

}  // namespace

ToneMap traceRegions(const std::vector<std::uint32_t>& labels, int width, int height, double tolerance) {
  return Tracer(labels, width, height, tolerance).trace();
}

}  // namespace dimline
