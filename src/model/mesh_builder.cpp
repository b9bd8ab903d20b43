#include "model/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace dimline {

namespace {

std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
  auto mix = [](std::uint64_t h, std::int64_t v) {
    return (h ^ static_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15ULL;
  };
  std::uint64_t h = mix(mix(mix(0, x), y), z);
  return h ^ (h >> 29);
}

/// Edge of a weld cell, in weld distances. Wide, so that a search hardly ever needs more than the point's own cell.
constexpr double kCellWelds = 16;

}  // namespace

void MeshBuilder::beginPart() {
  firstPoint_ = static_cast<std::uint32_t>(mesh_.positions.size());
  firstTriangle_ = mesh_.triangles.size();
  points_.clear();
  cells_.clear();
  welded_ = 0;
}

std::uint32_t MeshBuilder::point(const Vec3& p) {
  points_.push_back(p);
  mesh_.positions.emplace_back(p);
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

std::uint32_t MeshBuilder::weld(const Vec3& p) {
  auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v / (kWeldM * kCellWelds))); };
  for (; welded_ < points_.size(); ++welded_) {
    const Vec3& q = points_[welded_];
    cells_.emplace(cellKey(cell(q.x), cell(q.y), cell(q.z)), static_cast<std::uint32_t>(welded_));
  }
  for (std::int64_t x = cell(p.x - kWeldM); x <= cell(p.x + kWeldM); ++x) {
    for (std::int64_t y = cell(p.y - kWeldM); y <= cell(p.y + kWeldM); ++y) {
      for (std::int64_t z = cell(p.z - kWeldM); z <= cell(p.z + kWeldM); ++z) {
        const auto [begin, end] = cells_.equal_range(cellKey(x, y, z));
        for (auto i = begin; i != end; ++i) {
          if (glm::length(points_[i->second] - p) <= kWeldM) return firstPoint_ + i->second;
        }
      }
    }
  }
  return point(p);
}

void MeshBuilder::face(std::span<const std::uint32_t> ring, std::uint16_t material) {
  ring_.clear();
  for (const std::uint32_t p : ring) {
    if (ring_.empty() || (p != ring_.back() && p != ring_.front())) ring_.push_back(p);
  }
  if (ring_.size() < 3) return;
  // Newell's normal: right for every convex face, however its first corners lie.
  Vec3 normal(0.0);
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Vec3 &a = at(ring_[i]), &b = at(ring_[(i + 1) % ring_.size()]);
    normal += glm::cross(a - at(ring_[0]), b - at(ring_[0]));
  }
  const double length = glm::length(normal);
  if (!(length > 0)) return;
  normal /= length;
  const PlaneAxes axes = planeAxes(normal);
  auto corner = [&](std::uint32_t p) { return Corner{p, normal, planeUv(axes, at(p))}; };
  for (std::size_t i = 2; i < ring_.size(); ++i)
    triangle(corner(ring_[0]), corner(ring_[i - 1]), corner(ring_[i]), material);
}

void MeshBuilder::triangle(const Corner& a, const Corner& b, const Corner& c, std::uint16_t material) {
  if (a.point == b.point || b.point == c.point || c.point == a.point) return;
  mesh_.triangles.push_back({a.point, b.point, c.point});
  mesh_.materials.push_back(material);
  mesh_.normals.push_back({glm::vec3(a.normal), glm::vec3(b.normal), glm::vec3(c.normal)});
  mesh_.uvs.push_back({a.uv, b.uv, c.uv});
}

void MeshBuilder::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d, std::uint16_t material) {
  triangle(a, b, c, material);
  triangle(a, c, d, material);
}

void MeshBuilder::smooth(double creaseRad) {
  const std::size_t count = mesh_.triangles.size() - firstTriangle_;
  const double least = std::cos(creaseRad);
  // Corner 3 t + k is corner k of the part's triangle t.
  std::vector<Vec3> faces(count);
  std::vector<double> weights(3 * count);
  std::vector<std::uint32_t> firstAt(points_.size() + 1, 0), around(3 * count);
  const auto pointOf = [&](std::size_t corner) {
    return mesh_.triangles[firstTriangle_ + corner / 3][corner % 3] - firstPoint_;
  };
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 p[] = {points_[pointOf(3 * t)], points_[pointOf(3 * t + 1)], points_[pointOf(3 * t + 2)]};
    const Vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(normal);
    faces[t] = area > 0 ? normal / area : Vec3(mesh_.normals[firstTriangle_ + t][0]);
    for (std::size_t k = 0; k < 3; ++k) {
      // Weights after Max (1999): exact on a sphere, however it is cut into triangles.
      const Vec3 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      weights[3 * t + k] = area / std::max(glm::dot(a, a) * glm::dot(b, b), 1e-30);
      ++firstAt[pointOf(3 * t + k) + 1];
    }
  }
  for (std::size_t i = 1; i < firstAt.size(); ++i) firstAt[i] += firstAt[i - 1];
  std::vector<std::uint32_t> next(firstAt.begin(), firstAt.end() - 1);
  for (std::size_t corner = 0; corner < around.size(); ++corner) {
    around[next[pointOf(corner)]++] = static_cast<std::uint32_t>(corner);
  }
  const auto write = [&](std::size_t corner, const Vec3& sum) {
    const double length = glm::length(sum);
    mesh_.normals[firstTriangle_ + corner / 3][corner % 3] = glm::vec3(length > 0 ? sum / length : faces[corner / 3]);
  };
  // Where all faces around a point are within half the crease of one of them, they all meet at less than the crease.
  const double half = std::cos(creaseRad * 0.5);
  for (std::size_t point = 0; point + 1 < firstAt.size(); ++point) {
    const std::span corners(around.begin() + firstAt[point], around.begin() + firstAt[point + 1]);
    if (corners.empty()) continue;
    Vec3 all(0.0);
    bool one = true;
    for (const std::uint32_t corner : corners) {
      all += faces[corner / 3] * weights[corner];
      one = one && glm::dot(faces[corner / 3], faces[corners[0] / 3]) >= half;
    }
    for (const std::uint32_t corner : corners) {
      Vec3 sum = all;
      if (!one) {
        sum = Vec3(0.0);
        for (const std::uint32_t other : corners) {
          if (glm::dot(faces[other / 3], faces[corner / 3]) >= least) sum += faces[other / 3] * weights[other];
        }
      }
      write(corner, sum);
    }
  }
}

PlaneAxes planeAxes(const Vec3& normal) {
  // Within half a degree of level, "up the slope" says nothing.
  const double levelShare = 0.9999;
  if (normal.y > levelShare) return {{1, 0, 0}, {0, 0, -1}};
  if (normal.y < -levelShare) return {{1, 0, 0}, {0, 0, 1}};
  const Vec3 u = glm::normalize(glm::cross(Vec3(0, 1, 0), normal));
  return {u, glm::cross(normal, u)};
}

glm::vec2 planeUv(const PlaneAxes& axes, const Vec3& p) { return {glm::dot(axes.u, p), glm::dot(axes.v, p)}; }

}  // namespace dimline
