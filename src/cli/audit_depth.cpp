#include "cli/audit_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Over a plane, one over the depth (in a perspective view) or the depth itself (in an orthographic one) is linear on
// screen. So a triangle is a linear function of the pixel, and rows between its left and right border are walked with
// two additions.

namespace dimline {

namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();
constexpr int kPointsOnSegment = 33;

}  // namespace

double DepthPicture::nearness(double depthM) const { return view_.orthographic() ? -depthM : 1.0 / depthM; }

/// Calls use(index, nearness) for every pixel whose centre a triangle covers.
template <typename Use>
void DepthPicture::walk(const std::array<Vec3, 3>& triangle, Use use) const {
  std::array<Corner, 4> corners{};
  std::size_t count = 0;
  const auto add = [&](const Vec3& p) {
    const Vec2 screen = view_.toScreen(p);
    corners[count++] = {screen.x, screen.y, nearness(view_.depth(p))};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle[i];
    const Vec3& b = triangle[(i + 1) % 3];
    const double beforeA = view_.depth(a) - view_.nearM();
    const double beforeB = view_.depth(b) - view_.nearM();
    if (beforeA >= 0) add(a);
    if ((beforeA >= 0) != (beforeB >= 0)) add(a + (b - a) * (beforeA / (beforeA - beforeB)));
  }
  if (count < 3) return;

  double top = corners[0].y;
  double bottom = corners[0].y;
  for (std::size_t i = 1; i < count; ++i) {
    top = std::min(top, corners[i].y);
    bottom = std::max(bottom, corners[i].y);
  }
  const Vec2 u(corners[1].x - corners[0].x, corners[1].y - corners[0].y);
  const Vec2 v(corners[2].x - corners[0].x, corners[2].y - corners[0].y);
  const double area = u.x * v.y - u.y * v.x;
  if (area == 0) return;  // seen edge-on
  const double du = corners[1].nearness - corners[0].nearness;
  const double dv = corners[2].nearness - corners[0].nearness;
  const double slopeX = (du * v.y - dv * u.y) / area;
  const double slopeY = (dv * u.x - du * v.x) / area;

  const int firstY = static_cast<int>(std::ceil(std::clamp(top - 0.5, 0.0, static_cast<double>(height_))));
  const int lastY = static_cast<int>(std::floor(std::clamp(bottom - 0.5, -1.0, height_ - 1.0)));
  for (int y = firstY; y <= lastY; ++y) {
    const double level = y + 0.5;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t i = 0; i < count; ++i) {
      const Corner& a = corners[i];
      const Corner& b = corners[(i + 1) % count];
      if ((a.y <= level) == (b.y <= level)) continue;
      const double x = a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int firstX = static_cast<int>(std::ceil(std::clamp(left - 0.5, 0.0, static_cast<double>(width_))));
    const int lastX = static_cast<int>(std::floor(std::clamp(right - 0.5, -1.0, width_ - 1.0)));
    double value = corners[0].nearness + slopeX * (firstX + 0.5 - corners[0].x) + slopeY * (level - corners[0].y);
    for (int x = firstX; x <= lastX; ++x, value += slopeX) {
      use(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x), value);
    }
  }
}

void DepthPicture::draw(const Scene& scene, const View& view) {
  view_ = view;
  width_ = std::max(1, static_cast<int>(std::ceil(view.widthPx())));
  height_ = std::max(1, static_cast<int>(std::ceil(view.heightPx())));
  nearest_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kNothing);
  std::vector<Vec3> world;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toWorld(instance.transform);
    world.clear();
    for (const glm::vec3& p : mesh.positions) world.emplace_back(toWorld * Vec4(Vec3(p), 1.0));
    for (const auto& t : mesh.triangles) {
      walk({world[t[0]], world[t[1]], world[t[2]]},
           [&](std::size_t i, double value) { nearest_[i] = std::max(nearest_[i], static_cast<float>(value)); });
    }
  }
}

CoverageMask DepthPicture::mask() const {
  CoverageMask mask;
  mask.widthPx = width_;
  mask.heightPx = height_;
  mask.pixels.reserve(nearest_.size());
  for (const float nearest : nearest_) mask.pixels.push_back(nearest > kNothing ? 255 : 0);
  return mask;
}

DepthPicture::Seen DepthPicture::test(const Obb& box, double skinM) const {
  // A box's faces by the corner's bits, counter-clockwise seen from outside.
  static constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  Seen total;
  for (const auto& face : kFaces) {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = box.corner(face[i]);
    const Vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (!(glm::dot(normal, view_.directionTo((p[0] + p[2]) * 0.5)) < 0)) continue;
    for (Vec3& corner : p) corner -= view_.directionTo(corner) * skinM;
    for (const auto& triangle : {std::array<Vec3, 3>{p[0], p[1], p[2]}, {p[0], p[2], p[3]}}) {
      walk(triangle, [&](std::size_t i, double value) {
        ++total.pixels;
        if (static_cast<float>(value) >= nearest_[i]) ++total.seen;
      });
    }
  }
  return total;
}

double DepthPicture::seenShare(const Segment& segment, double skinM) const {
  int seen = 0;
  for (int i = 0; i < kPointsOnSegment; ++i) {
    const Vec3 onLine = segment.start + (segment.end - segment.start) * (i / (kPointsOnSegment - 1.0));
    const Vec3 p = onLine - view_.directionTo(onLine) * skinM;
    if (!view_.inFrontOfNear(p)) continue;
    const Vec2 screen = view_.toScreen(p);
    if (screen.x < 0 || screen.y < 0 || screen.x >= width_ || screen.y >= height_) continue;
    const auto index =
        static_cast<std::size_t>(screen.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(screen.x);
    if (static_cast<float>(nearness(view_.depth(p))) >= nearest_[index]) ++seen;
  }
  return static_cast<double>(seen) / kPointsOnSegment;
}

}  // namespace dimline
