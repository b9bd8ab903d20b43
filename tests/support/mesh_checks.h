#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "model/scene.h"

/// What holds for every mesh that the Builder makes: closed parts, outward faces, honest normals.
namespace dimline::test {

/// For each triangle, the number of the part that it belongs to: parts are what hangs together through shared points.
inline std::vector<std::uint32_t> partNumbers(const Mesh& mesh, std::uint32_t& count) {
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
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> numberOfRoot(root.size(), kNone), numbers(mesh.triangles.size());
  count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t& number = numberOfRoot[find(mesh.triangles[i][0])];
    if (number == kNone) number = count++;
    numbers[i] = number;
  }
  return numbers;
}

inline std::array<Vec3, 3> corners(const Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {Vec3(mesh.positions[t[0]]), Vec3(mesh.positions[t[1]]), Vec3(mesh.positions[t[2]])};
}

/// Six times each part's signed volume: positive when its faces are counter-clockwise seen from outside.
inline std::vector<double> sixVolumes(const Mesh& mesh, std::span<const std::uint32_t> partOf, std::size_t parts) {
  std::vector<double> six(parts, 0);
  std::vector<Vec3> near(parts);  // keeps the sum small for parts far from the origin
  std::vector<bool> begun(parts);
  for (std::size_t i = 0; i < partOf.size(); ++i) {
    const auto [a, b, c] = corners(mesh, i);
    const std::uint32_t part = partOf[i];
    if (!begun[part]) near[part] = a;
    begun[part] = true;
    six[part] += glm::dot(a - near[part], glm::cross(b - near[part], c - near[part]));
  }
  return six;
}

inline double volumeOf(const Mesh& mesh) {
  std::uint32_t parts = 0;
  const std::vector<std::uint32_t> partOf = partNumbers(mesh, parts);
  const std::vector<double> six = sixVolumes(mesh, partOf, parts);
  return std::accumulate(six.begin(), six.end(), 0.0) / 6;
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

/// The first edge of a triangle whose other side is not exactly one triangle; two-sided ones are left out. Empty when there is none.
inline std::string openEdgeOf(const Mesh& mesh, std::span<const Material> materials) {
  const auto counts = [&](std::size_t triangle) { return !materials[mesh.materials[triangle]].twoSided; };
  // The edges from each point lie together, found by counting: meshes are large, and this is asked of thousands.
  std::vector<std::uint32_t> first(mesh.positions.size() + 1, 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!counts(i)) continue;
    for (const std::uint32_t from : mesh.triangles[i]) ++first[from + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> to(first.back()), next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!counts(i)) continue;
    for (std::size_t k = 0; k < 3; ++k) to[next[mesh.triangles[i][k]]++] = mesh.triangles[i][(k + 1) % 3];
  }
  const auto edges = [&](std::uint32_t from, std::uint32_t end) {
    return std::count(to.begin() + first[from], to.begin() + first[from + 1], end);
  };
  const auto place = [&](std::uint32_t point) {
    const glm::vec3 p = mesh.positions[point];
    return std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z);
  };
  for (std::uint32_t from = 0; from + 1 < first.size(); ++from) {
    for (std::uint32_t i = first[from]; i < first[from + 1]; ++i) {
      if (edges(from, to[i]) != 1 || edges(to[i], from) != 1)
        return "an edge is not shared by two triangles, from " + place(from) + " to " + place(to[i]);
    }
  }
  return {};
}

/// The first thing that is wrong with a triangle; empty when nothing is.
inline std::string triangleDefectOf(const Mesh& mesh, std::size_t i, std::size_t materials) {
  const auto which = [&] { return "triangle " + std::to_string(i); };
  for (const std::uint32_t p : mesh.triangles[i]) {
    if (p >= mesh.positions.size()) return which() + " has a corner that does not exist";
  }
  if (mesh.materials[i] >= materials) return which() + " has a material that does not exist";
  const auto [a, b, c] = corners(mesh, i);
  const Vec3 across = glm::cross(b - a, c - a);
  const double twiceArea = glm::length(across);
  const double longest = std::sqrt(std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)}));
  if (!(twiceArea > 1e-6 * longest)) {  // its height, m: floats at 20 m are 2e-6 apart
    return which() + " is flat, at " + std::to_string(a.x) + ", " + std::to_string(a.y) + ", " + std::to_string(a.z);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 corner(mesh.normals[i][k]);
    const glm::vec2 uv = mesh.uvs[i][k];
    if (!(std::abs(glm::dot(corner, corner) - 1) < 2e-4)) return which() + " has a normal whose length is not 1";
    if (!(glm::dot(corner, across) > 0.3 * twiceArea)) return which() + " has a normal that points away from its face";
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return which() + " has a uv that is no number";
  }
  return {};
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
    std::string defect = triangleDefectOf(mesh, i, materials.size());
    if (!defect.empty()) return defect;
    for (const std::uint32_t p : mesh.triangles[i]) used[p] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) return "point " + std::to_string(i) + " belongs to no triangle";
  }
  if (std::string open = openEdgeOf(mesh, materials); !open.empty()) return open;
  std::uint32_t parts = 0;
  const std::vector<std::uint32_t> partOf = partNumbers(mesh, parts);
  const std::vector<double> volumes = sixVolumes(mesh, partOf, parts);
  for (std::size_t i = 0; i < n; ++i) {
    if (materials[mesh.materials[i]].twoSided || volumes[partOf[i]] > 0) continue;
    return "the part of triangle " + std::to_string(i) + " is inside out";
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
