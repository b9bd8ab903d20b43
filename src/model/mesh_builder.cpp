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
  if (!cells_.empty()) cells_.clear();   // clears as many buckets as there ever were
  welded_ = 0;
}

void MeshBuilder::reserve(std::size_t triangles) {
  mesh_.positions.reserve(triangles);
  mesh_.triangles.reserve(triangles);
  mesh_.materials.reserve(triangles);
  mesh_.normals.reserve(triangles);
  mesh_.uvs.reserve(triangles);
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
  const std::span triangles(mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(firstTriangle_), mesh_.triangles.end());
  const std::span normals(mesh_.normals.begin() + static_cast<std::ptrdiff_t>(firstTriangle_), mesh_.normals.end());
  Smoothing& s = smoothing_;
  s.faces.resize(triangles.size());
  s.firstAt.assign(points_.size() + 1, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& corners = triangles[t];
    for (const std::uint32_t p : corners) ++s.firstAt[p - firstPoint_ + 1];
    const Vec3 normal = glm::cross(at(corners[1]) - at(corners[0]), at(corners[2]) - at(corners[0]));
    const double area = glm::length(normal);
    s.faces[t] = {area > 0 ? normal / area : Vec3(normals[t][0]), area};
  }
  for (std::size_t i = 1; i < s.firstAt.size(); ++i) s.firstAt[i] += s.firstAt[i - 1];
  s.around.resize(3 * triangles.size());
  s.next.assign(s.firstAt.begin(), s.firstAt.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& corners = triangles[t];
    for (std::uint8_t k = 0; k < 3; ++k) {
      // Weights after Max (1999): exact on a sphere, however it is cut into triangles.
      const Vec3 a = at(corners[(k + 1) % 3]) - at(corners[k]), b = at(corners[(k + 2) % 3]) - at(corners[k]);
      const double weight = s.faces[t].area / std::max(glm::dot(a, a) * glm::dot(b, b), 1e-30);
      s.around[s.next[corners[k] - firstPoint_]++] = {s.faces[t].normal * weight, t, k};
    }
  }
  const double least = std::cos(creaseRad);
  // Where all faces around a point are within half the crease of one of them, they all meet at less than the crease.
  const double half = std::cos(creaseRad * 0.5);
  for (std::size_t point = 0; point + 1 < s.firstAt.size(); ++point) {
    const std::span corners(s.around.begin() + s.firstAt[point], s.around.begin() + s.firstAt[point + 1]);
    if (corners.empty()) continue;
    const auto faceOf = [&](const Smoothing::Corner& corner) -> const Vec3& { return s.faces[corner.triangle].normal; };
    const auto unit = [](const Vec3& sum, const Vec3& otherwise) {
      const double length = glm::length(sum);
      return glm::vec3(length > 0 ? sum / length : otherwise);
    };
    Vec3 all(0.0);
    bool one = true;
    for (const Smoothing::Corner& corner : corners) {
      all += corner.weighted;
      one = one && glm::dot(faceOf(corner), faceOf(corners[0])) >= half;
    }
    const glm::vec3 shared = one ? unit(all, faceOf(corners[0])) : glm::vec3(0.0F);
    for (const Smoothing::Corner& corner : corners) {
      glm::vec3& normal = normals[corner.triangle][corner.corner];
      normal = shared;
      if (one) continue;
      Vec3 sum(0.0);
      for (const Smoothing::Corner& other : corners) {
        if (glm::dot(faceOf(other), faceOf(corner)) >= least) sum += other.weighted;
      }
      normal = unit(sum, faceOf(corner));
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
