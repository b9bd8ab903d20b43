#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/scene.h"

/// What holds for every mesh that the Builder makes: closed parts, outward faces, honest normals.
namespace dimline::test {

/// The triangles of a mesh (indices), grouped by which of them hang together through shared points.
inline std::vector<std::vector<std::size_t>> partsOf(const Mesh& mesh) {
  std::vector<std::uint32_t> root(mesh.positions.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    root[find(t[1])] = find(t[0]);
    root[find(t[2])] = find(t[0]);
  }
  std::map<std::uint32_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) groups[find(mesh.triangles[i][0])].push_back(i);
  std::vector<std::vector<std::size_t>> parts;
  for (auto& [key, triangles] : groups) parts.push_back(std::move(triangles));
  return parts;
}

inline std::array<Vec3, 3> corners(const Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {Vec3(mesh.positions[t[0]]), Vec3(mesh.positions[t[1]]), Vec3(mesh.positions[t[2]])};
}

/// Signed volume of a closed part: positive when its faces are counter-clockwise seen from outside.
inline double volumeOf(const Mesh& mesh, const std::vector<std::size_t>& part) {
  double six = 0;
  const Vec3 near = corners(mesh, part.front())[0];  // keeps the sum small for parts far from the origin
  for (const std::size_t i : part) {
    const auto [a, b, c] = corners(mesh, i);
    six += glm::dot(a - near, glm::cross(b - near, c - near));
  }
  return six / 6;
}

inline double volumeOf(const Mesh& mesh) {
  double sum = 0;
  for (const auto& part : partsOf(mesh)) sum += volumeOf(mesh, part);
  return sum;
}

/// The area of a mesh's faces.
inline double areaOf(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = corners(mesh, i);
    sum += glm::length(glm::cross(b - a, c - a)) * 0.5;
  }
  return sum;
}

/// The first thing that is wrong with a mesh whose parts should all be closed solids, but for those of two-sided materials, which may
/// have borders; empty when nothing is.
inline std::string defectOf(const Mesh& mesh, std::span<const Material> materials) {
  const std::size_t n = mesh.triangles.size();
  if (mesh.materials.size() != n || mesh.normals.size() != n || mesh.uvs.size() != n)
    return "arrays of different lengths";
  for (const glm::vec3& p : mesh.positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return "a position that is no number";
  }
  std::vector<bool> used(mesh.positions.size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::string which = "triangle " + std::to_string(i);
    for (const std::uint32_t p : mesh.triangles[i]) {
      if (p >= mesh.positions.size()) return which + " has a corner that does not exist";
      used[p] = true;
    }
    if (mesh.materials[i] >= materials.size()) return which + " has a material that does not exist";
    const auto [a, b, c] = corners(mesh, i);
    const Vec3 normal = glm::cross(b - a, c - a);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (!(glm::length(normal) > 1e-6 * longest)) {  // its height, m: floats at 20 m are 2e-6 apart
      return which + " is flat, at " + std::to_string(a.x) + ", " + std::to_string(a.y) + ", " + std::to_string(a.z);
    }
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner(mesh.normals[i][static_cast<std::size_t>(k)]);
      const glm::vec2 uv = mesh.uvs[i][static_cast<std::size_t>(k)];
      if (!(std::abs(glm::length(corner) - 1) < 1e-4)) return which + " has a normal whose length is not 1";
      if (!(glm::dot(corner, glm::normalize(normal)) > 0.3))
        return which + " has a normal that points away from its face";
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return which + " has a uv that is no number";
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) return "point " + std::to_string(i) + " belongs to no triangle";
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto twoSided = [&](std::size_t triangle) { return materials[mesh.materials[triangle]].twoSided; };
  for (std::size_t i = 0; i < n; ++i) {
    if (twoSided(i)) continue;
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [from, to] = edges[i];
    const bool twice = i + 1 < edges.size() && edges[i] == edges[i + 1];
    if (twice || !std::binary_search(edges.begin(), edges.end(), std::pair(to, from))) {
      const glm::vec3 p = mesh.positions[from], q = mesh.positions[to];
      return "an edge is not shared by two triangles, from " + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
             std::to_string(p.z) + " to " + std::to_string(q.x) + ", " + std::to_string(q.y) + ", " +
             std::to_string(q.z);
    }
  }
  for (const auto& part : partsOf(mesh)) {
    if (!twoSided(part.front()) && !(volumeOf(mesh, part) > 0)) return "a part of " + std::to_string(part.size()) + " triangles is inside out";
  }
  return {};
}

inline std::string defectOf(const Scene& scene) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const std::string defect = defectOf(scene.meshes[i], scene.materials);
    if (!defect.empty()) return "mesh " + std::to_string(i) + ": " + defect;
  }
  return {};
}

}  // namespace dimline::test
