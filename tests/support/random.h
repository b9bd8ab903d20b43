#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "math/types.h"

namespace dimline::test {

/// Reproducible random numbers: the same with every standard library, unlike its distributions.
class Random {
public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /// In [low, high).
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0); }
  /// In [low, high], both included.
  int whole(int low, int high) { return low + static_cast<int>(real(0, 1) * (high - low + 1)); }
  bool chance(double probability) { return real(0, 1) < probability; }
  /// In [low, high), even over the logarithm.
  double scaled(double low, double high) { return std::exp(real(std::log(low), std::log(high))); }

  Vec2 point(const Vec2& low, const Vec2& high) { return {real(low.x, high.x), real(low.y, high.y)}; }
  Vec3 point(const Vec3& low, const Vec3& high) {
    return {real(low.x, high.x), real(low.y, high.y), real(low.z, high.z)};
  }
  /// Even over the unit sphere.
  Vec3 direction() {
    const double y = real(-1, 1);
    const double angle = real(0, 6.283185307179586);
    const double r = std::sqrt(1 - y * y);
    return {r * std::cos(angle), y, r * std::sin(angle)};
  }

private:
  std::mt19937 engine_;
};

}  // namespace dimline::test
