#pragma once

#include <cmath>
#include <utility>

#include "model/scene.h"

/// Shapes for silhouettes to be taken of. Positions are shared, triangles run counter-clockwise seen from outside.
namespace dimline::test {

/// From -1 to 1 along each axis.
inline Mesh boxMesh() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// Radius 1, of so many rings and so many segments around.
inline Mesh sphereMesh(int rings, int segments) {
  Mesh mesh;
  const double pi = 3.141592653589793;
  mesh.positions.emplace_back(0, 1, 0);
  for (int r = 1; r < rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      const double latitude = pi * r / rings;
      const double longitude = 2 * pi * s / segments;
      mesh.positions.emplace_back(std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                                  std::sin(latitude) * std::cos(longitude));
    }
  }
  mesh.positions.emplace_back(0, -1, 0);
  const auto at = [&](int r, int s) {
    if (r == 0) return 0U;
    if (r == rings) return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    return static_cast<std::uint32_t>(1 + (r - 1) * segments + s % segments);
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      if (r > 0) mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r, s + 1)});
      if (r + 1 < rings) mesh.triangles.push_back({at(r, s + 1), at(r + 1, s), at(r + 1, s + 1)});
    }
  }
  return mesh;
}

/// An open sheet, a grid over -1 to 1 along x and z, bent up and down by `bend`.
inline Mesh sheetMesh(int cells, double bend) {
  Mesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double x = -1 + 2.0 * i / cells;
      const double z = -1 + 2.0 * j / cells;
      mesh.positions.emplace_back(x, bend * std::sin(3 * x) * std::cos(2 * z), z);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

/// The same surface with three vertices to each triangle, as files with normals of their own often have it.
inline Mesh split(const Mesh& mesh) {
  Mesh apart;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    for (const std::uint32_t vertex : triangle) apart.positions.push_back(mesh.positions[vertex]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

inline glm::mat4 placed(const Vec3& at, const Vec3& axis, double angleRad, const Vec3& scale) {
  const Mat3 turn = glm::mat3_cast(glm::angleAxis(angleRad, axis));
  Mat4 m(1.0);
  for (int c = 0; c < 3; ++c) m[c] = Vec4(turn[c] * scale[c], 0);
  m[3] = Vec4(at, 1);
  return glm::mat4(m);
}

inline void add(Scene& scene, Mesh mesh, const glm::mat4& transform = glm::mat4(1.0F)) {
  for (const glm::vec3& p : mesh.positions) scene.bounds.add(Vec3(transform * glm::vec4(p, 1)));
  scene.instances.push_back({static_cast<std::uint32_t>(scene.meshes.size()), transform});
  scene.meshes.push_back(std::move(mesh));
}

}  // namespace dimline::test
