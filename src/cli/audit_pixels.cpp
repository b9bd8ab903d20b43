#include "cli/audit_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/geometry.h"

namespace dimline {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Calls visit(x, y) for each pixel of a picture whose square a segment passes through, until it returns true; whether
/// it did. From crossing to crossing of the pixel grid, as one walks a ray through voxels.
template <typename Visit>
bool anyPixelOn(const Segment2& s, int width, int height, Visit visit) {
  const Vec2 d = s.end - s.start;
  int x = static_cast<int>(std::floor(s.start.x));
  int y = static_cast<int>(std::floor(s.start.y));
  const int lastX = static_cast<int>(std::floor(s.end.x));
  const int lastY = static_cast<int>(std::floor(s.end.y));
  const auto setUp = [](double start, double delta, int cell, double& next, double& each) {
    each = delta != 0 ? 1.0 / std::abs(delta) : std::numeric_limits<double>::infinity();
    next = delta > 0   ? (cell + 1 - start) * each
           : delta < 0 ? (start - cell) * each
                       : std::numeric_limits<double>::infinity();
  };
  double nextX = 0, nextY = 0, eachX = 0, eachY = 0;
  setUp(s.start.x, d.x, x, nextX, eachX);
  setUp(s.start.y, d.y, y, nextY, eachY);
  const int steps = std::abs(lastX - x) + std::abs(lastY - y);
  for (int i = 0; i <= steps; ++i) {
    if (x >= 0 && y >= 0 && x < width && y < height && visit(x, y)) return true;
    if (nextX < nextY) {
      x += d.x > 0 ? 1 : -1;
      nextX += eachX;
    } else {
      y += d.y > 0 ? 1 : -1;
      nextY += eachY;
    }
  }
  return false;
}

/// The part of a segment in a picture of that size, or nothing.
std::optional<Segment2> inPicture(const Segment2& s, double width, double height) {
  const Vec2 d = s.end - s.start;
  const Vec2 size(width, height);
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) {
      if (s.start[axis] < 0 || s.start[axis] > size[axis]) return std::nullopt;
      continue;
    }
    const double a = -s.start[axis] / d[axis];
    const double b = (size[axis] - s.start[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Segment2{s.start + d * enter, s.start + d * leave};
}

bool contains(double width, double height, const Vec2& p) {
  return p.x >= 0 && p.y >= 0 && p.x <= width && p.y <= height;
}

double squaredDistance(const glm::vec2& p, const Segment2& s) {
  const Vec2 d = s.end - s.start;
  const Vec2 to = Vec2(p) - s.start;
  const double length2 = glm::dot(d, d);
  const double t = length2 > 0 ? std::clamp(glm::dot(to, d) / length2, 0.0, 1.0) : 0.0;
  const Vec2 off = to - d * t;
  return glm::dot(off, off);
}

}  // namespace

void MaskPicture::read(CoverageMask mask) {
  mask_ = std::move(mask);
  outsideKnown_ = false;
  findBorder();
  distance_.resize(mask_.pixels.size());
  measureColumns();
  for (int y = 0; y < mask_.heightPx; ++y) measureRow(y);
}

void MaskPicture::findBorder() {
  border_.clear();
  const auto bare = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < mask_.widthPx && y < mask_.heightPx && !mask_.covered(x, y);
  };
  for (int y = 0; y < mask_.heightPx; ++y) {
    for (int x = 0; x < mask_.widthPx; ++x) {
      if (!mask_.covered(x, y)) continue;
      if (bare(x - 1, y) || bare(x + 1, y) || bare(x, y - 1) || bare(x, y + 1))
        border_.emplace_back(x + 0.5F, y + 0.5F);
    }
  }
}

/// First pass: the distance to the nearest covered pixel of the same column, by a sweep down and one up.
void MaskPicture::measureColumns() {
  const int width = mask_.widthPx;
  const int height = mask_.heightPx;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      distance_[at(x, y)] = mask_.covered(x, y) ? 0.0F : y > 0 ? distance_[at(x, y - 1)] + 1.0F : kFar;
    }
  }
  for (int y = height - 2; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      distance_[at(x, y)] = std::min(distance_[at(x, y)], distance_[at(x, y + 1)] + 1.0F);
    }
  }
}

/// Second pass: along a row, the least of (x - i)^2 + column distance(i)^2 over all i is the lower envelope of
/// parabolas that differ only by where their vertex is; the envelope is built from left to right.
void MaskPicture::measureRow(int y) {
  const int width = mask_.widthPx;
  site_.clear();
  from_.clear();
  squared_.resize(static_cast<std::size_t>(width));
  float* const row = distance_.data() + at(0, y);
  for (int i = 0; i < width; ++i)
    squared_[static_cast<std::size_t>(i)] = static_cast<double>(row[i]) * static_cast<double>(row[i]);
  for (int i = 0; i < width; ++i) {
    if (!std::isfinite(row[i])) continue;
    double start = -std::numeric_limits<double>::infinity();
    while (!site_.empty()) {
      const int j = site_.back();
      // From there on parabola i is below parabola j.
      start = (squared_[static_cast<std::size_t>(i)] - squared_[static_cast<std::size_t>(j)] +
               static_cast<double>(i) * i - static_cast<double>(j) * j) /
              (2.0 * (i - j));
      if (start > from_.back()) break;
      site_.pop_back();
      from_.pop_back();
      start = -std::numeric_limits<double>::infinity();
    }
    site_.push_back(i);
    from_.push_back(start);
  }
  std::size_t k = 0;
  for (int x = 0; x < width; ++x) {
    if (site_.empty()) break;
    while (k + 1 < site_.size() && from_[k + 1] <= x) ++k;
    const double dx = x - site_[k];
    row[x] = static_cast<float>(std::sqrt(dx * dx + squared_[static_cast<std::size_t>(site_[k])]));
  }
}

double MaskPicture::distancePx(const Segment2& segment) const {
  // A segment that lies in the model as a whole meets no border.
  if (const auto part = inPicture(segment, mask_.widthPx, mask_.heightPx)) {
    const int x = std::min(static_cast<int>(part->start.x), mask_.widthPx - 1);
    const int y = std::min(static_cast<int>(part->start.y), mask_.heightPx - 1);
    if (mask_.covered(x, y)) return 0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const glm::vec2& p : border_) least = std::min(least, squaredDistance(p, segment));
  return std::max(0.0, std::sqrt(least) - 0.5);
}

double MaskPicture::interpolatedPx(const Vec2& p) const {
  const double u = std::clamp(p.x - 0.5, 0.0, mask_.widthPx - 1.0);
  const double v = std::clamp(p.y - 0.5, 0.0, mask_.heightPx - 1.0);
  const int x = std::min(static_cast<int>(u), std::max(0, mask_.widthPx - 2));
  const int y = std::min(static_cast<int>(v), std::max(0, mask_.heightPx - 2));
  const int x1 = std::min(x + 1, mask_.widthPx - 1);
  const int y1 = std::min(y + 1, mask_.heightPx - 1);
  const auto d = [&](int i, int j) { return static_cast<double>(distance_[at(i, j)]); };
  if (!std::isfinite(d(x, y))) return std::numeric_limits<double>::infinity();
  const double a = u - x;
  const double b = v - y;
  return (d(x, y) * (1 - a) + d(x1, y) * a) * (1 - b) + (d(x, y1) * (1 - a) + d(x1, y1) * a) * b;
}

bool MaskPicture::keepsDistance(const Segment2& segment, double leastPx) const {
  if (!contains(mask_.widthPx, mask_.heightPx, segment.start) || !contains(mask_.widthPx, mask_.heightPx, segment.end))
    return false;
  const double length = segment.length();
  const Vec2 direction = unitOrZero(segment.end - segment.start);
  double along = 0;
  for (;;) {
    const double spare = interpolatedPx(segment.start + direction * along) - 0.5 - leastPx;
    if (spare < 0) return false;
    if (along >= length) return true;
    // The distance changes by no more than the way that is gone.
    along = std::min(along + std::max(1.0, spare - 1.0), length);
  }
}

bool MaskPicture::deep(int x, int y) const {
  for (int j = std::max(0, y - 1); j <= std::min(mask_.heightPx - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(mask_.widthPx - 1, x + 1); ++i) {
      if (!mask_.covered(i, j)) return false;
    }
  }
  return true;
}

bool MaskPicture::crosses(const Segment2& segment) const {
  const auto part = inPicture(segment, mask_.widthPx, mask_.heightPx);
  return part && anyPixelOn(*part, mask_.widthPx, mask_.heightPx, [&](int x, int y) { return deep(x, y); });
}

bool MaskPicture::touches(const Box2& box) const {
  const int firstX = static_cast<int>(std::ceil(std::max(0.0, box.min.x - 0.5)));
  const int firstY = static_cast<int>(std::ceil(std::max(0.0, box.min.y - 0.5)));
  const int lastX = static_cast<int>(std::floor(std::min(mask_.widthPx - 1.0, box.max.x - 0.5)));
  const int lastY = static_cast<int>(std::floor(std::min(mask_.heightPx - 1.0, box.max.y - 0.5)));
  for (int y = firstY; y <= lastY; ++y) {
    for (int x = firstX; x <= lastX; ++x) {
      if (mask_.covered(x, y)) return true;
    }
  }
  return false;
}

std::uint32_t MaskPicture::rootOf(std::uint32_t run) {
  while (runs_[run].parent != run) run = runs_[run].parent = runs_[runs_[run].parent].parent;
  return run;
}

void MaskPicture::findOutside() {
  runs_.assign(1, {0, 0, 0});
  rowRuns_.clear();
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    runs_[std::max(a, b)].parent = std::min(a, b);
  };
  std::uint32_t above = 1;
  for (int y = 0; y < mask_.heightPx; ++y) {
    const auto first = static_cast<std::uint32_t>(runs_.size());
    rowRuns_.push_back(first);
    for (int x = 0; x < mask_.widthPx; ++x) {
      if (mask_.covered(x, y)) continue;
      const auto number = static_cast<std::uint32_t>(runs_.size());
      int end = x + 1;
      while (end < mask_.widthPx && !mask_.covered(end, y)) ++end;
      runs_.push_back({x, end, number});
      if (x == 0 || end == mask_.widthPx || y == 0 || y == mask_.heightPx - 1) join(0, number);
      // Runs of the row above that end before this one begins are of no use to the next ones either.
      while (above < first && runs_[above].xEnd <= x) ++above;
      for (std::uint32_t i = above; i < first && runs_[i].x < end; ++i) join(i, number);
      x = end;
    }
    above = first;
  }
  rowRuns_.push_back(static_cast<std::uint32_t>(runs_.size()));
  outsideKnown_ = true;
}

bool MaskPicture::outside(const Vec2& p) {
  if (!contains(mask_.widthPx, mask_.heightPx, p)) return false;
  if (!outsideKnown_) findOutside();
  const int x = std::min(static_cast<int>(p.x), mask_.widthPx - 1);
  const auto y = static_cast<std::size_t>(std::min(static_cast<int>(p.y), mask_.heightPx - 1));
  for (std::uint32_t i = rowRuns_[y]; i < rowRuns_[y + 1]; ++i) {
    if (x >= runs_[i].x && x < runs_[i].xEnd) return rootOf(i) == 0;
  }
  return false;
}

bool MaskPicture::seesAnEdge(const Segment2& segment) const {
  const int width = mask_.widthPx;
  const int height = mask_.heightPx;
  // The four ways out of a pixel: left, right, up, down.
  for (const auto& way : {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)}) {
    const bool blocked = anyPixelOn(segment, width, height, [&](int x, int y) {
      for (; x >= 0 && y >= 0 && x < width && y < height; x += way.x, y += way.y) {
        if (mask_.covered(x, y)) return true;
      }
      return false;
    });
    if (!blocked) return true;
  }
  return false;
}

}  // namespace dimline
