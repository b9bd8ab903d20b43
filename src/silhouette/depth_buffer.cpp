#include "silhouette/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

// Depth after division by w is linear on screen for perspective and orthographic cameras alike, so a triangle is a plane in (x, y, depth) and a sample's
// depth is a sum of two products. Triangles are walked row by row between their left and right sides.

namespace dimline {

namespace {

using Corner = DepthBuffer::Corner;

/// The first sample of a row or a column of so many whose centre does not come before a place; so those between two places are the ones from the first's to before the
/// second's. 0 for what is no number. Without calls to the C library's functions, which small triangles would mostly wait for.
int firstSample(double at, int count) {
  const double sample = std::min(static_cast<double>(count), std::max(0.0, at - 0.5));
  const int below = static_cast<int>(sample);
  return below < sample ? below + 1 : below;
}

/// A side of a triangle, which runs down.
struct Side {
  Corner top;
  double slope;   ///< samples to the right for one down; meaningless when it is level
  Side(const Corner& from, const Corner& to) : top(from), slope((to.x - from.x) / (to.y - from.y)) {}
  [[nodiscard]] double xAt(double y) const { return top.x + slope * (y - top.y); }
};

/// Calls perSample(x, y, depth) for each sample centre inside a triangle.
template <typename PerSample>
void walk(const Corner& a, const Corner& b, const Corner& c, int width, PerSample perSample) {
  // A detailed model's triangles mostly lie between the centres.
  const auto [firstX, endX] = std::minmax({a.column, b.column, c.column});
  const auto [firstY, endY] = std::minmax({a.row, b.row, c.row});
  if (firstX == endX || firstY == endY) return;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (!(std::abs(area) > 1e-12)) return;
  const Corner* top = &a;
  const Corner* middle = &b;
  const Corner* bottom = &c;
  if (middle->y < top->y) std::swap(top, middle);
  if (bottom->y < middle->y) std::swap(middle, bottom);
  if (middle->y < top->y) std::swap(top, middle);
  const double slopeX = ((b.depth - a.depth) * (c.y - a.y) - (c.depth - a.depth) * (b.y - a.y)) / area;
  const double slopeY = ((c.depth - a.depth) * (b.x - a.x) - (b.depth - a.depth) * (c.x - a.x)) / area;
  const Side whole(*top, *bottom);
  const Side upper(*top, *middle);
  const Side lower(*middle, *bottom);
  for (int y = firstY; y < endY; ++y) {
    const double centerY = y + 0.5;
    const double one = whole.xAt(centerY);
    const double other = (centerY < middle->y ? upper : lower).xAt(centerY);
    const int end = firstSample(std::max(one, other), width);
    const double depth = a.depth + slopeX * (0.5 - a.x) + slopeY * (centerY - a.y);
    for (int x = firstSample(std::min(one, other), width); x < end; ++x) perSample(x, y, depth + slopeX * x);
  }
}

}  // namespace

std::pair<int, int> DepthBuffer::sizeFor(const View& view, int maxSide) {
  const double scale = std::min(1.0, maxSide / std::max(view.widthPx(), view.heightPx()));
  return {std::max(1, static_cast<int>(std::lround(view.widthPx() * scale))), std::max(1, static_cast<int>(std::lround(view.heightPx() * scale)))};
}

void DepthBuffer::reset(const View& view, int maxSide) {
  view_ = view;
  std::tie(width_, height_) = sizeFor(view, maxSide);
  depth_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 1.0F);
}

DepthBuffer::Corner DepthBuffer::cornerAt(const Vec3& world) const {
  const Vec4 clip = view_.viewProjection() * Vec4(world, 1.0);
  const double x = (clip.x / clip.w * 0.5 + 0.5) * width_;
  const double y = (0.5 - clip.y / clip.w * 0.5) * height_;
  return {x, y, clip.z / clip.w, firstSample(x, width_), firstSample(y, height_)};
}

template <typename PerSample>
void DepthBuffer::rasterise(const std::array<Vec3, 3>& world, PerSample perSample) const {
  std::array<Corner, 4> corners;
  std::size_t count = 0;
  const auto add = [&](const Vec3& p) { corners[count++] = cornerAt(p); };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = world[i];
    const Vec3& b = world[(i + 1) % 3];
    const double beyondA = view_.depth(a) - view_.nearM();
    const double beyondB = view_.depth(b) - view_.nearM();
    if (beyondA >= 0) add(a);
    if ((beyondA >= 0) != (beyondB >= 0)) add(a + (b - a) * (beyondA / (beyondA - beyondB)));
  }
  for (std::size_t i = 2; i < count; ++i) walk(corners[0], corners[i - 1], corners[i], width_, perSample);
}

void DepthBuffer::keepNearest(int x, int y, double depth) {
  float& nearest = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  nearest = std::min(nearest, static_cast<float>(depth));
}

void DepthBuffer::draw(const std::array<Vec3, 3>& triangleWorld) {
  rasterise(triangleWorld, [this](int x, int y, double depth) { keepNearest(x, y, depth); });
}

void DepthBuffer::draw(const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toWorld(instance.transform);
    const auto worldOf = [&](std::uint32_t vertex) { return Vec3(toWorld * Vec4(Vec3(mesh.positions[vertex]), 1.0)); };
    vertices_.clear();
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3 world = worldOf(i);
      const bool inFront = view_.depth(world) >= view_.nearM();
      vertices_.push_back({inFront ? cornerAt(world) : Corner{}, inFront});
    }
    for (const auto& t : mesh.triangles) {
      const Vertex& a = vertices_[t[0]];
      const Vertex& b = vertices_[t[1]];
      const Vertex& c = vertices_[t[2]];
      if (a.inFront && b.inFront && c.inFront) {
        walk(a.corner, b.corner, c.corner, width_, [this](int x, int y, double depth) { keepNearest(x, y, depth); });
      } else if (a.inFront || b.inFront || c.inFront) {
        draw({worldOf(t[0]), worldOf(t[1]), worldOf(t[2])});
      }
    }
  }
}

DepthBuffer::Seen DepthBuffer::test(const std::array<Vec3, 3>& triangleWorld, double towardsViewerM) const {
  std::array<Vec3, 3> moved = triangleWorld;
  for (Vec3& p : moved) p -= view_.directionTo(p) * towardsViewerM;
  Seen result;
  rasterise(moved, [&](int x, int y, double depth) {
    ++result.covered;
    if (depth <= static_cast<double>(at(x, y))) ++result.seen;
  });
  return result;
}

}  // namespace dimline
