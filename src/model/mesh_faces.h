#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>

#include "model/scene.h"

namespace dimline {

/// A triangle's normal, as long as twice its area; zero for a triangle that is none. In double, so that millimetres do not vanish when squared.
inline Vec3 areaVector(std::span<const glm::vec3> positions, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = positions[t[0]], b = positions[t[1]], c = positions[t[2]];
  return glm::cross(b - a, c - a);
}
inline Vec3 areaVector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) { return areaVector(mesh.positions, t); }

/// A vector as a unit normal; the fallback when it has no direction.
inline glm::vec3 unitOr(const Vec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  if (length > 1e-12) return glm::vec3(v / length);
  return glm::vec3(glm::normalize(fallback));
}

}  // namespace dimline
