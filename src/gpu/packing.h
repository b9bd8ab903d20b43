#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

namespace dimline {

/// A unit vector as GL_INT_2_10_10_10_REV, normalized: 10 signed bits an axis.
inline std::uint32_t packNormal(const glm::vec3& n) {
  const auto axis = [](float v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(std::clamp(v, -1.0F, 1.0F) * 511.0F))) & 0x3FFU;
  };
  return axis(n.x) | (axis(n.y) << 10U) | (axis(n.z) << 20U);
}

}  // namespace dimline
