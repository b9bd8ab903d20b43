#include "silhouette/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <tuple>

// Depth after division by w is linear on screen for perspective and orthographic cameras alike, so a triangle is a plane in (x, y, depth) and a sample's
// depth is a sum of two products. Triangles are walked row by row between their left and right sides.

namespace dimline {

namespace {

/// A corner in samples (x right, y down) and normalised device depth.
struct Corner {
  double x, y, depth;
};

/// Calls perSample(x, y, depth) for each sample centre inside a triangle.
template <typename PerSample>
void walk(const Corner& a, const Corner& b, const Corner& c, int width, int height, PerSample perSample) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (!(std::abs(area) > 1e-12)) return;
  const double slopeX = ((b.depth - a.depth) * (c.y - a.y) - (c.depth - a.depth) * (b.y - a.y)) / area;
  const double slopeY = ((c.depth - a.depth) * (b.x - a.x) - (b.depth - a.depth) * (c.x - a.x)) / area;
  const std::array<const Corner*, 3> corners{&a, &b, &c};
  const double top = std::min({a.y, b.y, c.y});
  const double bottom = std::max({a.y, b.y, c.y});
  const int firstY = static_cast<int>(std::clamp(std::ceil(top - 0.5), 0.0, static_cast<double>(height)));
  const int lastY = static_cast<int>(std::clamp(std::floor(bottom - 0.5), -1.0, height - 1.0));
  for (int y = firstY; y <= lastY; ++y) {
    const double centerY = y + 0.5;
    double left = width;
    double right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& p = *corners[i];
      const Corner& q = *corners[(i + 1) % 3];
      if ((p.y <= centerY) == (q.y <= centerY)) continue;
      const double x = p.x + (q.x - p.x) * (centerY - p.y) / (q.y - p.y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int firstX = static_cast<int>(std::max(std::ceil(left - 0.5), 0.0));
    const int lastX = static_cast<int>(std::min(std::floor(right - 0.5), width - 1.0));
    for (int x = firstX; x <= lastX; ++x) {
      perSample(x, y, a.depth + slopeX * (x + 0.5 - a.x) + slopeY * (centerY - a.y));
    }
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

template <typename PerSample>
void DepthBuffer::rasterise(const std::array<Vec3, 3>& world, PerSample perSample) const {
  std::array<Corner, 4> corners;
  std::size_t count = 0;
  const auto add = [&](const Vec3& p) {
    const Vec4 clip = view_.viewProjection() * Vec4(p, 1.0);
    corners[count++] = {(clip.x / clip.w * 0.5 + 0.5) * width_, (0.5 - clip.y / clip.w * 0.5) * height_, clip.z / clip.w};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = world[i];
    const Vec3& b = world[(i + 1) % 3];
    const double beyondA = view_.depth(a) - view_.nearM();
    const double beyondB = view_.depth(b) - view_.nearM();
    if (beyondA >= 0) add(a);
    if ((beyondA >= 0) != (beyondB >= 0)) add(a + (b - a) * (beyondA / (beyondA - beyondB)));
  }
  for (std::size_t i = 2; i < count; ++i) walk(corners[0], corners[i - 1], corners[i], width_, height_, perSample);
}

void DepthBuffer::draw(const std::array<Vec3, 3>& triangleWorld) {
  rasterise(triangleWorld, [&](int x, int y, double depth) {
    float& nearest = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    nearest = std::min(nearest, static_cast<float>(depth));
  });
}

void DepthBuffer::draw(const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toWorld(instance.transform);
    corners_.clear();
    for (const glm::vec3& p : mesh.positions) corners_.emplace_back(toWorld * Vec4(Vec3(p), 1.0));
    for (const auto& t : mesh.triangles) draw({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
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
