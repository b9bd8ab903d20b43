#include "model/builder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

// Bodies that fill the scope, prisms, bodies of revolution and sweeps. Every one knows its own topology and shares its points by
// index; only Solid has to look for points that fall together.

namespace dimline {

namespace {

constexpr double kNothingM = 1e-9;  ///< a size below this is no size

Vec3 rotated(const Vec3& v, const Vec3& from, const Vec3& to) {
  // The least rotation that takes one unit vector to another (never opposite ones here).
  const Vec3 axis = glm::cross(from, to);
  const double c = glm::dot(from, to);
  return v * c + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1 + c));
}

/// Normals at the two ends of each edge of a closed ring: those of neighbouring edges are averaged where the ring bends by less than the crease.
struct EdgeNormals {
  Vec2 start, end;
};
std::vector<EdgeNormals> edgeNormals(std::span<const Vec2> ring, double creaseRad) {
  const std::size_t n = ring.size();
  std::vector<Vec2> flat(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 e = glm::normalize(ring[(i + 1) % n] - ring[i]);
    flat[i] = {e.y, -e.x};
  }
  const double creaseCos = std::cos(creaseRad);
  auto between = [&](const Vec2& own, const Vec2& other) {
    return glm::dot(own, other) > creaseCos ? glm::normalize(own + other) : own;
  };
  std::vector<EdgeNormals> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    normals[i] = {between(flat[i], flat[(i + n - 1) % n]), between(flat[i], flat[(i + 1) % n])};
  }
  return normals;
}

}  // namespace

void Builder::box() {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= kNothingM) return;
  MeshBuilder& out = mesh();
  out.beginPart();
  std::uint32_t p[8];
  for (int i = 0; i < 8; ++i) p[i] = out.point(scope().corner(i));
  constexpr int kFaces[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
  for (const auto& f : kFaces) {
    const std::uint32_t ring[] = {p[f[0]], p[f[1]], p[f[2]], p[f[3]]};
    out.face(ring, material());
  }
}

void Builder::box(const Vec3& cornerM, const Vec3& sizeM) {
  push();
  translate(cornerM);
  scale(sizeM);
  box();
  pop();
}

void Builder::rectangle() {
  const Vec3 n = size();
  if (std::min(n.x, n.y) <= kNothingM) return;
  MeshBuilder& out = mesh();
  out.beginPart();
  const std::uint32_t ring[] = {out.point(toMesh({0, 0, n.z})), out.point(toMesh({n.x, 0, n.z})),
                                out.point(toMesh({n.x, n.y, n.z})), out.point(toMesh({0, n.y, n.z}))};
  out.face(ring, material());
}

// --- Bodies of revolution ----------------------------------------------------------------------------------------------

void Builder::cylinder(const RoundOptions& options) { cone(1, options); }

void Builder::cone(double topShare, const RoundOptions& options) {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= kNothingM) return;
  const double radius = (n.x + n.z) * 0.25;
  const Vec2 profile[] = {{radius, 0}, {radius * std::max(topShare, 0.0), n.y}};
  revolve(profile, {n.x * 0.5, 0, n.z * 0.5}, Vec2(n.x, n.z) * (0.5 / radius), options);
}

void Builder::sphere(const RoundOptions& options) {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= kNothingM) return;
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

// The profile is made to start and end on the axis and to run so that outside is to its right; the discs at its ends are then
// rings like all others.
void Builder::revolve(std::span<const Vec2> input, const Vec3& base, const Vec2& stretch, const RoundOptions& options) {
  std::vector<Vec2> profile;
  for (const Vec2& p : input) {
    if (profile.empty() || glm::length(p - profile.back()) > kNothingM) profile.push_back(p);
  }
  if (profile.size() < 2) return;
  if (profile.front().x > kNothingM) profile.insert(profile.begin(), {0, profile.front().y});
  if (profile.back().x > kNothingM) profile.emplace_back(0, profile.back().y);
  const double area = signedArea(profile);
  if (std::abs(area) <= kNothingM * kNothingM) return;
  if (area < 0) std::reverse(profile.begin(), profile.end());

  const std::size_t n = profile.size();
  const int segments = std::max(options.segments, 3);
  MeshBuilder& out = mesh();
  out.beginPart();

  std::vector<Vec2> around(static_cast<std::size_t>(segments) + 1);  // (cos, -sin): counter-clockwise seen from above
  for (int j = 0; j < segments; ++j) {
    const double angle = 2 * std::numbers::pi * j / segments;
    around[static_cast<std::size_t>(j)] = {std::cos(angle), -std::sin(angle)};
  }
  around.back() = around.front();
  std::vector<std::uint32_t> first(n);
  double widest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = profile[i].x, y = profile[i].y;
    widest = std::max(widest, r);
    const bool pole = r <= kNothingM;
    for (int j = 0; j < (pole ? 1 : segments); ++j) {
      const Vec2 a = around[static_cast<std::size_t>(j)] * stretch * (pole ? 0.0 : r);
      const std::uint32_t p = out.point(toMesh(base + Vec3(a.x, y, a.y)));
      if (j == 0) first[i] = p;
    }
  }

  std::vector<Vec2> flat(n - 1);  // normals of the profile's edges: (outwards, up)
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vec2 e = glm::normalize(profile[i + 1] - profile[i]);
    flat[i] = {e.y, -e.x};
  }
  const double creaseCos = std::cos(options.creaseRad);
  auto normalAt = [&](std::size_t edge, std::size_t vertex) -> Vec2 {
    const std::size_t other = vertex == edge ? edge - 1 : edge + 1;
    if (vertex == 0 || vertex + 1 == n)
      return std::abs(flat[edge].y) > creaseCos ? Vec2(0, flat[edge].y > 0 ? 1 : -1) : flat[edge];
    return glm::dot(flat[edge], flat[other]) > creaseCos ? glm::normalize(flat[edge] + flat[other]) : flat[edge];
  };
  double along = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double nextAlong = along + glm::length(profile[i + 1] - profile[i]);
    const Vec2 normalLow = normalAt(i, i), normalHigh = normalAt(i, i + 1);
    // On the axis all columns share a point; its normal is that of the column's middle.
    auto corner = [&](std::size_t vertex, int column, int j, const Vec2& normal) {
      const bool pole = profile[vertex].x <= kNothingM;
      const auto c = static_cast<std::size_t>(column);
      const Vec2 a = pole ? glm::normalize(around[c] + around[c + 1]) : around[static_cast<std::size_t>(j)];
      const Vec3 local(normal.x * a.x / stretch.x, normal.y, normal.x * a.y / stretch.y);
      const std::uint32_t p = pole ? first[vertex] : first[vertex] + static_cast<std::uint32_t>(j % segments);
      const double u = 2 * std::numbers::pi * j / segments * widest;
      return MeshBuilder::Corner{p, glm::normalize(directionToMesh(local)),
                                 glm::vec2(u, vertex == i ? along : nextAlong)};
    };
    for (int j = 0; j < segments; ++j) {
      out.quad(corner(i, j, j, normalLow), corner(i, j, j + 1, normalLow), corner(i + 1, j, j + 1, normalHigh),
               corner(i + 1, j, j, normalHigh), material());
    }
    along = nextAlong;
  }
}

// --- Prisms ------------------------------------------------------------------------------------------------------------

// For axes x and y the polygon's two coordinates are a left-handed pair with the axis, so the prism is drawn from the far side back.
void Builder::extrudePolygon(const Polygon& input, Axis axis, double creaseRad) {
  const double depth = size()[static_cast<int>(axis)];
  if (depth <= kNothingM || input.outer.size() < 3) return;
  Polygon polygon = input;
  orient(polygon);
  auto place = [&](const Vec2& p, double h) {
    switch (axis) {
      case Axis::kX:
        return toMesh({depth - h, p.y, p.x});
      case Axis::kY:
        return toMesh({p.x, depth - h, p.y});
      case Axis::kZ:
        break;
    }
    return toMesh({p.x, p.y, h});
  };
  auto direction = [&](const Vec2& d) { return glm::normalize(place(d, 0) - place(Vec2(0.0), 0)); };

  MeshBuilder& out = mesh();
  out.beginPart();
  const Vec3 forward = glm::normalize(place(Vec2(0.0), depth) - place(Vec2(0.0), 0));
  std::vector<std::uint32_t> low, high;
  auto addRing = [&](const Ring& ring) {
    for (const Vec2& p : ring) low.push_back(out.point(place(p, 0)));
    for (const Vec2& p : ring) high.push_back(out.point(place(p, depth)));
  };
  addRing(polygon.outer);
  for (const Ring& hole : polygon.holes) addRing(hole);

  const PlaneAxes nearAxes = planeAxes(-forward), farAxes = planeAxes(forward);
  for (const auto& [a, b, c] : triangulate(polygon)) {
    auto corner = [&](std::uint32_t p, const Vec3& normal, const PlaneAxes& axes) {
      return MeshBuilder::Corner{p, normal, planeUv(axes, out.at(p))};
    };
    out.triangle(corner(low[c], -forward, nearAxes), corner(low[b], -forward, nearAxes),
                 corner(low[a], -forward, nearAxes), material());
    out.triangle(corner(high[a], forward, farAxes), corner(high[b], forward, farAxes),
                 corner(high[c], forward, farAxes), material());
  }

  std::size_t start = 0;
  auto addSides = [&](const Ring& ring) {
    const std::vector<EdgeNormals> normals = edgeNormals(ring, creaseRad);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      const Vec3 ni = direction(normals[i].start), nj = direction(normals[i].end);
      const PlaneAxes axes = planeAxes(glm::normalize(ni + nj));
      auto corner = [&](std::uint32_t p, const Vec3& normal) {
        return MeshBuilder::Corner{p, normal, planeUv(axes, out.at(p))};
      };
      out.quad(corner(low[start + i], ni), corner(low[start + j], nj), corner(high[start + j], nj),
               corner(high[start + i], ni), material());
    }
    start += ring.size();
  };
  addSides(polygon.outer);
  for (const Ring& hole : polygon.holes) addSides(hole);
}

// --- Sweeps ------------------------------------------------------------------------------------------------------------

void Builder::sweep(const Ring& input, std::span<const Vec3> pathInput, const SweepOptions& options) {
  Polygon section{input, {}};
  orient(section);
  const Ring& ring = section.outer;
  std::vector<Vec3> path;
  for (const Vec3& p : pathInput) {
    if (path.empty() || glm::length(p - path.back()) > kNothingM) path.push_back(p);
  }
  if (options.closed && path.size() > 1 && glm::length(path.front() - path.back()) <= kNothingM) path.pop_back();
  if (ring.size() < 3 || path.size() < (options.closed ? 3U : 2U)) return;

  const std::size_t count = path.size(), segments = options.closed ? count : count - 1;
  std::vector<Vec3> way(segments), right(segments), up(segments);
  for (std::size_t s = 0; s < segments; ++s) {
    way[s] = glm::normalize(path[(s + 1) % count] - path[s]);
    if (s == 0) {
      assert(glm::length(glm::cross(way[0], options.up)) > 1e-6 && "a sweep's up lies along its path");
      right[0] = glm::normalize(glm::cross(way[0], options.up));
      up[0] = glm::cross(right[0], way[0]);
    } else {
      right[s] = glm::normalize(rotated(right[s - 1], way[s - 1], way[s]));
      up[s] = glm::cross(right[s], way[s]);
    }
  }

  MeshBuilder& out = mesh();
  out.beginPart();
  const std::size_t n = ring.size();
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < count; ++i) {
    // Section lines of the segment before (or after, at the start) meet the plane that halves the bend.
    const std::size_t s = i == 0 ? 0 : i - 1;
    const bool bend = options.closed || (i > 0 && i < segments);
    const Vec3 in = bend ? way[(i + segments - 1) % segments] : way[s], go = bend ? way[i % segments] : way[s];
    const Vec3 plane = glm::normalize(in + go);
    for (const Vec2& q : ring) {
      const Vec3 o = right[s] * q.x + up[s] * q.y;
      points.push_back(out.point(toMesh(path[i] + o - way[s] * (glm::dot(o, plane) / glm::dot(way[s], plane)))));
    }
  }

  const std::vector<EdgeNormals> normals = edgeNormals(ring, options.creaseRad);
  double along = 0;
  for (std::size_t s = 0; s < segments; ++s) {
    const std::size_t from = s * n, to = (s + 1) % count * n;
    const double nextAlong = along + glm::length(path[(s + 1) % count] - path[s]);
    double around = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const double nextAround = around + glm::length(ring[j] - ring[i]);
      auto normal = [&](const Vec2& v) { return glm::normalize(directionToMesh(right[s] * v.x + up[s] * v.y)); };
      const Vec3 ni = normal(normals[i].start), nj = normal(normals[i].end);
      out.quad({points[from + j], nj, glm::vec2(nextAround, along)}, {points[from + i], ni, glm::vec2(around, along)},
               {points[to + i], ni, glm::vec2(around, nextAlong)},
               {points[to + j], nj, glm::vec2(nextAround, nextAlong)}, material());
      around = nextAround;
    }
    along = nextAlong;
  }
  if (options.closed) return;
  const Vec3 nearNormal = directionToMesh(-way.front()), farNormal = directionToMesh(way.back());
  const std::size_t last = (count - 1) * n;
  for (const auto& [a, b, c] : triangulate(section)) {
    auto corner = [&](std::size_t p, std::uint32_t i, const Vec3& normal) {
      return MeshBuilder::Corner{points[p + i], normal, glm::vec2(ring[i])};
    };
    out.triangle(corner(0, a, nearNormal), corner(0, b, nearNormal), corner(0, c, nearNormal), material());
    out.triangle(corner(last, c, farNormal), corner(last, b, farNormal), corner(last, a, farNormal), material());
  }
}

// --- Parts made by hand -------------------------------------------------------------------------------------------------

void Builder::Solid::face(std::span<const Vec3> ring) { face(ring, builder_.material()); }

void Builder::Solid::face(std::span<const Vec3> ring, MaterialId material) {
  MeshBuilder& out = builder_.mesh();
  ring_.clear();
  for (const Vec3& p : ring) ring_.push_back(out.weld(builder_.toMesh(p)));
  out.face(ring_, material);
}

}  // namespace dimline
