// Why scanning some edges is enough. Let S be what the view shows of the model on screen: the union of all projected triangles, cut
// at the near plane, within the viewport. A field's value at a strip is an extreme of S over that strip, and S is closed, so the extreme is
// attained at a point on the border of S. Such a point lies on one of these:
//
//  1. An edge between a facet that faces the viewer and one that does not, or an edge of one that is seen edge-on, or an edge that has not just
//     two facets which agree. For take any other edge: its two facets face the same way, so on screen they lie on either side of it, and all
//     around each of its points is covered; the same holds around a vertex at which there are only such edges.
//  2. The cut of a facet with the near plane: there the facet ends without an edge of its own.
//  3. The viewport's own border, where a facet runs across it. There S ends without an edge, too. A facet's part of a side of the viewport
//     is a segment, and scanning it sets that side's field to 0 over its length.
//
// Everything that is scanned belongs to S: to scan an edge too many costs time, and changes nothing. So whether a face is seen from in
// front is decided generously: within rounding of edge-on counts as edge-on, and its edges are scanned.
//
// Facing is one plane evaluation a facet, at the viewer's position in the mesh's own frame; only the ends of edges that are scanned are projected.
// That is all for an instance whose box lies in the viewport and before the near plane. The others have all their vertices projected, to find
// what crosses the viewport's sides and the near plane.

#include "silhouette/cpu_fields.h"

#include <cmath>

#include "silhouette/edge_mesh.h"
#include "silhouette/float4.h"
#include "silhouette/strip_scan.h"

namespace dimline {

namespace {

/// Relative error that float arithmetic may leave in a facet's plane evaluated at the viewer, with room to spare.
constexpr float kFacingError = 1e-6F;

enum Facing : std::uint8_t { kEdgeOn = 0, kTowards = 1, kAway = 2 };

/// The sides of what is shown that a point lies beyond, as bits.
enum Beyond : std::uint8_t { kBeyondLeft = 1, kBeyondRight = 2, kBeyondTop = 4, kBeyondBottom = 8, kBeyondNear = 16 };

/// From a mesh's frame (relative to its centre) to the screen.
struct Projection {
  glm::dmat4x3 toPixels{1.0};   ///< homogeneous pixels
  Vec4 beforeNear{0.0};         ///< . (p, 1) = how far p lies beyond the near plane, seen from the viewer (m)
  Vec4 viewer{0.0};             ///< the viewer, homogeneous, in the mesh's frame; its sign is arbitrary

  [[nodiscard]] Vec2 toScreen(const glm::vec3& p) const {
    const Vec3 h = toPixels * Vec4(Vec3(p), 1.0);
    return Vec2(h.x, h.y) / h.z;
  }
};

/// The one point that a 3x4 projection sends to (0, 0, 0), by cofactors: also right for parallel projection and for flattened meshes.
Vec4 centerOfProjection(const glm::dmat4x3& m) {
  const auto minor = [&](int a, int b, int c) { return glm::dot(m[a], glm::cross(m[b], m[c])); };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

Projection project(const View& view, const Instance& instance, const EdgeMesh& mesh) {
  Mat4 toWorld(instance.transform);
  toWorld[3] = toWorld * Vec4(mesh.center, 1.0);
  Projection projection;
  projection.toPixels = view.worldToPixels() * toWorld;
  const Vec3& forward = view.forward();
  const Vec4 nearPlane(forward, -glm::dot(forward, view.camera().eye) - view.nearM());
  projection.beforeNear = nearPlane * toWorld;
  projection.viewer = centerOfProjection(projection.toPixels);
  return projection;
}

/// A vertex in front of the cut at the near plane, and after it.
struct Projected {
  Vec3 pixel;          ///< homogeneous
  double beforeNear;   ///< m
  std::uint8_t beyond;
};

}  // namespace

struct CpuFields::Prepared {
  std::vector<EdgeMesh> meshes;
  std::vector<Instance> instances;

  // Scratch, as large as the largest mesh needs.
  std::vector<std::uint8_t> facing;
  std::vector<std::uint32_t> silhouette;
  std::vector<Projected> projected;

  void findSilhouette(const EdgeMesh& mesh, const Projection& projection);
  void scanInside(const EdgeMesh& mesh, const Projection& projection, StripScan& scan) const;
  void scanCut(const EdgeMesh& mesh, const Projection& projection, StripScan& scan);
};

namespace {

/// Which sides all of the mesh's box lies beyond, and which some of it does.
struct BoxBeyond {
  std::uint8_t all = 0xFF;
  std::uint8_t any = 0;
};

Projected projectVertex(const Projection& projection, const Vec3& p, double widthPx, double heightPx) {
  Projected v{projection.toPixels * Vec4(p, 1.0), glm::dot(projection.beforeNear, Vec4(p, 1.0)), 0};
  // Each side is a plane through the viewer, so these tests hold behind the viewer as well.
  if (v.pixel.x < 0) v.beyond |= kBeyondLeft;
  if (v.pixel.x > widthPx * v.pixel.z) v.beyond |= kBeyondRight;
  if (v.pixel.y < 0) v.beyond |= kBeyondTop;
  if (v.pixel.y > heightPx * v.pixel.z) v.beyond |= kBeyondBottom;
  if (v.beforeNear < 0) v.beyond |= kBeyondNear;
  return v;
}

BoxBeyond boxBeyond(const EdgeMesh& mesh, const Projection& projection, double widthPx, double heightPx) {
  BoxBeyond beyond;
  for (int i = 0; i < 8; ++i) {
    const Vec3 sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    const std::uint8_t corner = projectVertex(projection, mesh.halfSize * sign, widthPx, heightPx).beyond;
    beyond.all &= corner;
    beyond.any |= corner;
  }
  return beyond;
}

/// Where the segment between two vertices passes the near plane, on screen.
Vec2 cutAtNear(const Projected& a, const Projected& b) {
  const Vec3 h = a.pixel + (b.pixel - a.pixel) * (a.beforeNear / (a.beforeNear - b.beforeNear));
  return Vec2(h.x, h.y) / h.z;
}

Vec2 onScreen(const Projected& v) { return Vec2(v.pixel.x, v.pixel.y) / v.pixel.z; }

/// Scans an edge, cut at the near plane and at the viewport's sides.
void scanCutEdge(const Projected& a, const Projected& b, StripScan& scan) {
  if ((a.beyond & b.beyond) != 0) return;
  const bool cutA = (a.beyond & kBeyondNear) != 0;
  const bool cutB = (b.beyond & kBeyondNear) != 0;
  scan.scan(cutA ? cutAtNear(a, b) : onScreen(a), cutB ? cutAtNear(a, b) : onScreen(b));
}

/// A convex polygon on screen: a triangle, perhaps with a corner cut off by the near plane.
struct ScreenPolygon {
  std::array<Vec2, 4> corners;
  std::size_t count = 0;
};

/// Scans the polygon's stretch on the line where coordinate `axis` is `at`.
void scanStretch(const ScreenPolygon& polygon, int axis, double at, StripScan& scan) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec2& a = polygon.corners[i];
    const Vec2& b = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
    double crossing = a[1 - axis];
    if (a[axis] != at) {
      if ((a[axis] < at) == (b[axis] < at)) continue;
      crossing += (b[1 - axis] - a[1 - axis]) * ((at - a[axis]) / (b[axis] - a[axis]));
    }
    low = std::min(low, crossing);
    high = std::max(high, crossing);
  }
  if (low > high) return;
  if (axis == 0) {
    scan.scan({at, low}, {at, high});
  } else {
    scan.scan({low, at}, {high, at});
  }
}

/// Scans what a triangle that is not wholly in view adds besides its edges: its cut with the near plane, its stretches on the viewport's sides.
void scanCutTriangle(const Projected& a, const Projected& b, const Projected& c, StripScan& scan) {
  const std::array<const Projected*, 3> corners{&a, &b, &c};
  ScreenPolygon polygon;
  std::array<Vec2, 2> nearCut;
  std::size_t nearCuts = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Projected& from = *corners[i];
    const Projected& to = *corners[(i + 1) % 3];
    const bool fromShown = (from.beyond & kBeyondNear) == 0;
    if (fromShown) polygon.corners[polygon.count++] = onScreen(from);
    if (fromShown != ((to.beyond & kBeyondNear) == 0)) {
      polygon.corners[polygon.count++] = nearCut[nearCuts++] = cutAtNear(from, to);
    }
  }
  if (nearCuts == 2) scan.scan(nearCut[0], nearCut[1]);
  scanStretch(polygon, 0, 0.0, scan);
  scanStretch(polygon, 0, scan.widthPx(), scan);
  scanStretch(polygon, 1, 0.0, scan);
  scanStretch(polygon, 1, scan.heightPx(), scan);
}

}  // namespace

void CpuFields::Prepared::findSilhouette(const EdgeMesh& mesh, const Projection& projection) {
  // Scaled so that its greatest component is 1: the projection's scale would take the sums out of a float's range.
  const Vec4 viewer = projection.viewer;
  const double greatest = std::max({std::abs(viewer.x), std::abs(viewer.y), std::abs(viewer.z), std::abs(viewer.w)});
  const glm::vec4 v = greatest > 0 ? glm::vec4(viewer / greatest) : glm::vec4(0.0F);
  const float error = kFacingError * (glm::length(glm::vec3(v)) + static_cast<float>(mesh.radiusM) * std::abs(v.w));
  const std::size_t padded = mesh.normalX.size();
  for (std::size_t i = 0; i < padded; i += 4) {
    const Float4 side = load4(&mesh.normalX[i]) * v.x + load4(&mesh.normalY[i]) * v.y + load4(&mesh.normalZ[i]) * v.z + load4(&mesh.offset[i]) * v.w;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      facing[i + lane] = static_cast<std::uint8_t>((side[lane] > error ? kTowards : 0) | (side[lane] < -error ? kAway : 0));
    }
  }
  silhouette.clear();
  for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
    const EdgeMesh::Edge& edge = mesh.edges[i];
    if ((facing[edge.facetA] & facing[edge.facetB]) == 0) silhouette.push_back(i);
  }
}

void CpuFields::Prepared::scanInside(const EdgeMesh& mesh, const Projection& projection, StripScan& scan) const {
  for (const std::uint32_t index : silhouette) {
    const EdgeMesh::Edge& edge = mesh.edges[index];
    scan.scan(projection.toScreen(mesh.positions[edge.a]), projection.toScreen(mesh.positions[edge.b]));
  }
}

void CpuFields::Prepared::scanCut(const EdgeMesh& mesh, const Projection& projection, StripScan& scan) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    projected[i] = projectVertex(projection, Vec3(mesh.positions[i]), scan.widthPx(), scan.heightPx());
  }
  for (const std::uint32_t index : silhouette) {
    const EdgeMesh::Edge& edge = mesh.edges[index];
    scanCutEdge(projected[edge.a], projected[edge.b], scan);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint8_t all = projected[a].beyond & projected[b].beyond & projected[c].beyond;
    const std::uint8_t any = projected[a].beyond | projected[b].beyond | projected[c].beyond;
    if (any != 0 && all == 0) scanCutTriangle(projected[a], projected[b], projected[c], scan);
  }
}

CpuFields::CpuFields() : prepared_(std::make_unique<Prepared>()) {}
CpuFields::~CpuFields() = default;
CpuFields::CpuFields(CpuFields&&) noexcept = default;
CpuFields& CpuFields::operator=(CpuFields&&) noexcept = default;

void CpuFields::setScene(const Scene& scene) {
  prepared_->meshes.clear();
  std::size_t vertices = 0;
  std::size_t facets = 0;
  std::size_t edges = 0;
  for (const Mesh& mesh : scene.meshes) {
    prepared_->meshes.push_back(makeEdgeMesh(mesh));
    const EdgeMesh& made = prepared_->meshes.back();
    vertices = std::max(vertices, made.positions.size());
    facets = std::max(facets, made.normalX.size());
    edges = std::max(edges, made.edges.size());
  }
  prepared_->instances = scene.instances;
  prepared_->facing.resize(facets);
  prepared_->silhouette.reserve(edges);
  prepared_->projected.resize(vertices);
}

void CpuFields::produce(const View& view, DistanceFields& fields) {
  fields.reset(static_cast<int>(std::ceil(view.widthPx())), static_cast<int>(std::ceil(view.heightPx())));
  StripScan scan(fields);
  for (const Instance& instance : prepared_->instances) {
    const EdgeMesh& mesh = prepared_->meshes[instance.mesh];
    if (mesh.triangles.empty()) continue;
    const Projection projection = project(view, instance, mesh);
    const BoxBeyond beyond = boxBeyond(mesh, projection, scan.widthPx(), scan.heightPx());
    if (beyond.all != 0) continue;
    prepared_->findSilhouette(mesh, projection);
    if (beyond.any == 0) {
      prepared_->scanInside(mesh, projection, scan);
    } else {
      prepared_->scanCut(mesh, projection, scan);
    }
  }
  fields.buildTrees();
}

}  // namespace dimline
