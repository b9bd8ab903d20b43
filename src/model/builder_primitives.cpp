#include <algorithm>
#include <cassert>

#include "model/builder.h"

// Boxes, prisms and parts made by hand. All but Solid know their own topology and share their points by index; Solid
// has to look for points that fall together.

namespace dimline {

void Builder::box() {
  const Vec3 n = size();
  if (std::min({n.x, n.y, n.z}) <= MeshBuilder::kNothingM) return;
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
  if (std::min(n.x, n.y) <= MeshBuilder::kNothingM) return;
  MeshBuilder& out = mesh();
  out.beginPart();
  const std::uint32_t ring[] = {out.point(toMesh({0, 0, n.z})), out.point(toMesh({n.x, 0, n.z})),
                                out.point(toMesh({n.x, n.y, n.z})), out.point(toMesh({0, n.y, n.z}))};
  out.face(ring, material());
}

// --- Prisms ------------------------------------------------------------------------------------------------------------

// For axes x and y the polygon's two coordinates are a left-handed pair with the axis, so the prism is drawn from the
// far side back.
void Builder::extrudePolygon(const Polygon& input, Axis axis, double creaseRad) {
  const double depth = size()[static_cast<int>(axis)];
  if (depth <= MeshBuilder::kNothingM || input.outer.size() < 3) return;
  Polygon polygon = input;
  orient(polygon);
  const Vec3 u = directionToMesh(axis == Axis::kX ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
  const Vec3 v = directionToMesh(axis == Axis::kY ? Vec3(0, 0, 1) : Vec3(0, 1, 0));
  const Vec3 forward = glm::cross(u, v);
  const Vec3 base = axis == Axis::kZ ? scope().origin : scope().origin - forward * depth;

  MeshBuilder& out = mesh();
  out.beginPart();
  std::vector<std::uint32_t> low, high;
  const auto addPoints = [&](const Ring& ring) {
    for (const Vec2& p : ring) low.push_back(out.point(base + u * p.x + v * p.y));
    for (const Vec2& p : ring) high.push_back(out.point(base + u * p.x + v * p.y + forward * depth));
  };
  addPoints(polygon.outer);
  for (const Ring& hole : polygon.holes) addPoints(hole);

  const auto cap = [&](const std::vector<std::uint32_t>& points, std::size_t i, const Vec3& normal) {
    return MeshBuilder::Corner{points[i], normal, planeUv(planeAxes(normal), out.at(points[i]))};
  };
  for (const auto& [a, b, c] : triangulate(polygon)) {
    out.triangle(cap(low, c, -forward), cap(low, b, -forward), cap(low, a, -forward), material());
    out.triangle(cap(high, a, forward), cap(high, b, forward), cap(high, c, forward), material());
  }

  std::size_t start = 0;
  const auto addSides = [&](const Ring& ring) {
    const std::vector<EdgeNormals> normals = edgeNormals(ring, creaseRad);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t here = start + i, next = start + (i + 1) % ring.size();
      const Vec3 first = u * normals[i].start.x + v * normals[i].start.y,
                 second = u * normals[i].end.x + v * normals[i].end.y;
      const PlaneAxes axes = planeAxes(glm::normalize(first + second));
      const auto corner = [&](std::uint32_t p, const Vec3& normal) {
        return MeshBuilder::Corner{p, normal, planeUv(axes, out.at(p))};
      };
      out.quad(corner(low[here], first), corner(low[next], second), corner(high[next], second),
               corner(high[here], first), material());
    }
    start += ring.size();
  };
  addSides(polygon.outer);
  for (const Ring& hole : polygon.holes) addSides(hole);
}

// --- Parts made by hand -------------------------------------------------------------------------------------------------

void Builder::Solid::face(std::span<const Vec3> ring) { face(ring, builder_.material()); }

void Builder::Solid::face(std::span<const Vec3> ring, MaterialId material) {
  MeshBuilder& out = builder_.mesh();
  ring_.clear();
  for (const Vec3& p : ring) ring_.push_back(out.weld(builder_.toMesh(p)));
  out.face(ring_, material);
}

// --- Surfaces that are known already -------------------------------------------------------------------------------------

void Builder::surface(const Surface& surface) {
  assert(surface.normals.size() == surface.points.size());
  assert(surface.uvs.empty() || surface.uvs.size() == surface.points.size());
  if (surface.triangles.empty()) return;
  MeshBuilder& out = mesh();
  out.beginPart();
  std::vector<std::uint32_t> points;
  points.reserve(surface.points.size());
  for (const Vec3& p : surface.points) points.push_back(out.point(toMesh(p)));
  const auto corner = [&](std::uint32_t i) {
    return MeshBuilder::Corner{points[i], directionToMesh(surface.normals[i]), surface.uvs.empty() ? glm::vec2(0.0F) : surface.uvs[i]};
  };
  for (const auto& [a, b, c] : surface.triangles) out.triangle(corner(a), corner(b), corner(c), material());
}

}  // namespace dimline
