#include "silhouette/coverage_mask.h"

#include <array>
#include <cmath>

namespace dimline {

namespace {

/// Fills a triangle on screen: every pixel whose centre lies in it or on its border, whichever way round it is.
void fill(const std::array<Vec2, 3>& triangle, CoverageMask& mask) {
  Box2 box;
  for (const Vec2& corner : triangle) box.add(corner);
  const int firstX = static_cast<int>(std::clamp(std::floor(box.min.x - 0.5), 0.0, static_cast<double>(mask.widthPx)));
  const int firstY = static_cast<int>(std::clamp(std::floor(box.min.y - 0.5), 0.0, static_cast<double>(mask.heightPx)));
  const int lastX = static_cast<int>(std::clamp(std::ceil(box.max.x - 0.5), -1.0, mask.widthPx - 1.0));
  const int lastY = static_cast<int>(std::clamp(std::ceil(box.max.y - 0.5), -1.0, mask.heightPx - 1.0));
  for (int y = firstY; y <= lastY; ++y) {
    for (int x = firstX; x <= lastX; ++x) {
      const Vec2 center(x + 0.5, y + 0.5);
      bool anyLeft = false;
      bool anyRight = false;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 side = triangle[(i + 1) % 3] - triangle[i];
        const Vec2 to = center - triangle[i];
        const double turn = side.x * to.y - side.y * to.x;
        anyLeft = anyLeft || turn < 0;
        anyRight = anyRight || turn > 0;
      }
      // On a triangle seen edge-on every turn is zero along its whole line; it covers no pixel's centre by more than
      // chance.
      const bool inside = anyLeft != anyRight;
      if (inside)
        mask.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.widthPx) +
                    static_cast<std::size_t>(x)] = 255;
    }
  }
}

/// Cuts a triangle at the near plane and fills what lies before it.
void fillBeforeNear(const std::array<Vec3, 3>& world, const View& view, CoverageMask& mask) {
  std::array<Vec2, 4> screen;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = world[i];
    const Vec3& b = world[(i + 1) % 3];
    const double beyondA = view.depth(a) - view.nearM();
    const double beyondB = view.depth(b) - view.nearM();
    if (beyondA >= 0) screen[count++] = view.toScreen(a);
    if ((beyondA >= 0) != (beyondB >= 0))
      screen[count++] = view.toScreen(a + (b - a) * (beyondA / (beyondA - beyondB)));
  }
  for (std::size_t i = 2; i < count; ++i) fill({screen[0], screen[i - 1], screen[i]}, mask);
}

}  // namespace

CoverageMask coverageMask(const Scene& scene, const View& view) {
  CoverageMask mask;
  mask.widthPx = static_cast<int>(std::ceil(view.widthPx()));
  mask.heightPx = static_cast<int>(std::ceil(view.heightPx()));
  mask.pixels.assign(static_cast<std::size_t>(mask.widthPx) * static_cast<std::size_t>(mask.heightPx), 0);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toWorld(instance.transform);
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
      std::array<Vec3, 3> world;
      for (std::size_t i = 0; i < 3; ++i) world[i] = Vec3(toWorld * Vec4(Vec3(mesh.positions[triangle[i]]), 1.0));
      fillBeforeNear(world, view, mask);
    }
  }
  return mask;
}

void fieldsFromMask(const CoverageMask& mask, DistanceFields& fields) {
  fields.reset(mask.widthPx, mask.heightPx);
  const auto measure = [](DistanceField& field, int extent, auto covered) {
    const std::span<float> values = field.edit();
    for (std::size_t strip = 0; strip < values.size(); ++strip) {
      int away = 0;
      while (away < extent && !covered(static_cast<int>(strip), away)) ++away;
      if (away < extent) values[strip] = static_cast<float>(away);
    }
  };
  const int width = mask.widthPx;
  const int height = mask.heightPx;
  measure(fields[ViewportEdge::kLeft], width, [&](int row, int away) { return mask.covered(away, row); });
  measure(fields[ViewportEdge::kRight], width, [&](int row, int away) { return mask.covered(width - 1 - away, row); });
  measure(fields[ViewportEdge::kTop], height, [&](int column, int away) { return mask.covered(column, away); });
  measure(fields[ViewportEdge::kBottom], height,
          [&](int column, int away) { return mask.covered(column, height - 1 - away); });
  fields.buildTrees();
}

}  // namespace dimline
