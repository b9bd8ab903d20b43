#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/builder.h"

// Bodies of revolution. One routine turns a profile; cylinders, cones and spheres are profiles, and ellipses are
// circles that it stretches.

namespace dimline {

namespace {

/// The profile from axis to axis, with outside to its right; empty when it encloses nothing. The discs that close its
/// ends are edges like all others.
std::vector<Vec2> closedProfile(std::span<const Vec2> input) {
  std::vector<Vec2> profile;
  for (const Vec2& p : input) {
    if (profile.empty() || glm::length(p - profile.back()) > MeshBuilder::kNothingM) profile.push_back(p);
  }
  if (profile.size() < 2) return {};
  if (profile.front().x > MeshBuilder::kNothingM) profile.insert(profile.begin(), {0, profile.front().y});
  if (profile.back().x > MeshBuilder::kNothingM) profile.emplace_back(0, profile.back().y);
  const double area = signedArea(profile);
  if (std::abs(area) <= MeshBuilder::kNothingM * MeshBuilder::kNothingM) return {};
  if (area < 0) std::reverse(profile.begin(), profile.end());
  return profile;
}

/// Normals (outwards, up) at both ends of each edge of the profile. At a pole that is flat within the crease, the
/// normal is the axis.
std::vector<EdgeNormals> profileNormals(std::span<const Vec2> profile, double creaseRad) {
  std::vector<EdgeNormals> normals = edgeNormals(profile, creaseRad);
  normals.pop_back();  // that of the way back along the axis
  const auto pole = [&](const Vec2& from, const Vec2& to) {
    const Vec2 e = glm::normalize(to - from), flat(e.y, -e.x);
    return std::abs(flat.y) > std::cos(creaseRad) ? Vec2(0, flat.y > 0 ? 1 : -1) : flat;
  };
  normals.front().start = pole(profile[0], profile[1]);
  normals.back().end = pole(profile[profile.size() - 2], profile.back());
  return normals;
}

/// (cos, -sin) of the columns' edges, the first one again at the end: counter-clockwise seen from above, with z
/// downwards on the paper.
std::vector<Vec2> columnEdges(int segments) {
  std::vector<Vec2> edges;
  for (int j = 0; j < segments; ++j) {
    const double angle = 2 * std::numbers::pi * j / segments;
    edges.emplace_back(std::cos(angle), -std::sin(angle));
  }
  edges.push_back(edges.front());
  return edges;
}

}  // namespace

void Builder::cylinder(const RoundOptions& options) { cone(1, options); }

void Builder::cone(double topShare, const RoundOptions& options) {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= MeshBuilder::kNothingM) return;
  const double radius = (n.x + n.z) * 0.25;
  const Vec2 profile[] = {{radius, 0}, {radius * std::max(topShare, 0.0), n.y}};
  revolve(profile, {n.x * 0.5, 0, n.z * 0.5}, Vec2(n.x, n.z) * (0.5 / radius), options);
}

void Builder::sphere(const RoundOptions& options) {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= MeshBuilder::kNothingM) return;
  const double radius = (n.x + n.z) * 0.25;
  const int rings = std::max(options.segments / 2, 2);
  std::vector<Vec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / rings - 0.5);
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0.0 : radius * std::cos(angle), n.y * 0.5 * (1 + std::sin(angle)));
  }
  revolve(profile, {n.x * 0.5, 0, n.z * 0.5}, Vec2(n.x, n.z) * (0.5 / radius), options);
}

void Builder::lathe(std::span<const Vec2> profile, const RoundOptions& options) {
  revolve(profile, {size().x * 0.5, 0, size().z * 0.5}, Vec2(1.0), options);
}

void Builder::revolve(std::span<const Vec2> input, const Vec3& base, const Vec2& stretch, const RoundOptions& options) {
  const std::vector<Vec2> profile = closedProfile(input);
  if (profile.empty()) return;
  const std::size_t n = profile.size(), columns = static_cast<std::size_t>(std::max(options.segments, 3));
  const std::vector<EdgeNormals> normals = profileNormals(profile, options.creaseRad);
  const std::vector<Vec2> edges = columnEdges(static_cast<int>(columns));
  MeshBuilder& out = mesh();
  out.beginPart();

  const auto isPole = [&](std::size_t i) { return profile[i].x <= MeshBuilder::kNothingM; };
  std::vector<std::uint32_t> first(n);  // a ring of points for each of the profile's, or one on the axis
  double widest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    widest = std::max(widest, profile[i].x);
    for (std::size_t j = 0; j < (isPole(i) ? 1 : columns); ++j) {
      const Vec2 a = isPole(i) ? Vec2(0.0) : edges[j] * stretch * profile[i].x;
      const std::uint32_t p = out.point(toMesh(base + Vec3(a.x, profile[i].y, a.y)));
      if (j == 0) first[i] = p;
    }
  }

  double along = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double nextAlong = along + glm::length(profile[i + 1] - profile[i]);
    for (std::size_t column = 0; column < columns; ++column) {
      // On the axis all columns share a point; its normal is that of the column's middle.
      const Vec2 middle = glm::normalize(edges[column] + edges[column + 1]);
      const auto corner = [&](std::size_t vertex, std::size_t j, const Vec2& normal) {
        const Vec2 a = isPole(vertex) ? middle : edges[j];
        const Vec3 local(normal.x * a.x / stretch.x, normal.y, normal.x * a.y / stretch.y);
        const std::uint32_t p = first[vertex] + (isPole(vertex) ? 0 : static_cast<std::uint32_t>(j % columns));
        const double u = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(columns) * widest;
        return MeshBuilder::Corner{p, glm::normalize(directionToMesh(local)),
                                   glm::vec2(u, vertex == i ? along : nextAlong)};
      };
      out.quad(corner(i, column, normals[i].start), corner(i, column + 1, normals[i].start),
               corner(i + 1, column + 1, normals[i].end), corner(i + 1, column, normals[i].end), material());
    }
    along = nextAlong;
  }
}

}  // namespace dimline
