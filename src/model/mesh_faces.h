#pragma once

#include <array>
#include <cstdint>

#include <glm/geometric.hpp>

#include "model/scene.h"

namespace dimline {

/// A triangle's normal, as long as twice its area; zero for a triangle that is none. In double, so that millimetres do not vanish when squared.
inline Vec3 areaVector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  return glm::cross(b - a, c - a);
}

/// A vector as a unit normal; the fallback when it has no direction.
inline glm::vec3 unitOr(const Vec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  if (length > 1e-12) return glm::vec3(v / length);
  return glm::vec3(glm::normalize(fallback));
}

}  // namespace dimline
