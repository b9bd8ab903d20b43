#include "models/mouldings.h"

#include <array>
#include <cmath>
#include <numbers>

namespace dimline {

void drawMoulding(Builder& b, const Vec2& sizeM, const Ring& section) {
  // The way round that has outside to its right.
  const std::array<Vec3, 4> path{Vec3(0, 0, sizeM.y), Vec3(sizeM.x, 0, sizeM.y), Vec3(sizeM.x, 0, 0), Vec3(0)};
  Builder::SweepOptions options;
  options.closed = true;
  options.creaseRad = 0.6;
  b.sweep(section, path, options);
}

void addCyma(Ring& section, const Vec2& from, const Vec2& to) {
  constexpr int kSteps = 6;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double bulge = 0.13 * std::sin(2 * std::numbers::pi * t);
    section.emplace_back(from.x + (to.x - from.x) * (t - bulge), from.y + (to.y - from.y) * t);
  }
}

Ring palmette(double widthM, double heightM) {
  // Right half, from the foot to the tip of the middle leaf.
  constexpr std::array<std::array<double, 2>, 7> kHalf{
      {{0.3, 0}, {0.24, 0.2}, {0.46, 0.3}, {0.48, 0.5}, {0.32, 0.58}, {0.25, 0.84}, {0, 1}}};
  Ring outline;
  for (const auto& [x, y] : kHalf) outline.emplace_back(x * widthM, y * heightM);
  for (std::size_t i = kHalf.size() - 1; i-- > 0;) outline.emplace_back(-kHalf[i][0] * widthM, kHalf[i][1] * heightM);
  return outline;
}

}  // namespace dimline
