// Why scanning some edges is enough. Let S be what the view shows of the model on screen: the union of all projected
// triangles, cut at the near plane, within the viewport. A field's value at a strip is an extreme of S over that
// strip, and S is closed, so the extreme is attained at a point on the border of S. Such a point lies on one of
// these:
//
//  1. An edge between a facet that faces the viewer and one that does not, or an edge of one that is seen edge-on, or
//     an edge that has not just two facets which agree. For take any other edge: its two facets face the same way, so
//     on screen they lie on either side of it, and all around each of its points is covered; the same holds around a
//     vertex at which there are only such edges.
//  2. The cut of a facet with the near plane: there the facet ends without an edge of its own.
//  3. The viewport's own border, where a facet runs across it. There S ends without an edge, too. A facet's part of a
//     side of the viewport is a segment, and scanning it sets that side's field to 0 over its length.
//
// Everything that is scanned belongs to S: to scan an edge too many costs time, and changes nothing. So whether a
// face is seen from in front is decided generously: within rounding of edge-on counts as edge-on, and its edges are
// scanned.
//
// Facing is one plane evaluation a facet, at the viewer's position in the mesh's own frame; only the ends of edges
// that are scanned are projected. That is all for a part whose box lies in the viewport and before the near plane.
// The others have all their vertices projected, to find what crosses the viewport's sides and the near plane.
//
// Most parts of a model lie in front of, behind or between others, and cannot change a field. So the parts are taken
// from the outside in, and one whose box on screen is nowhere nearer to the viewport's edges than what is known
// already is passed over. That is exact: the fields do not depend on the order. An instance of few parts, as of a baluster
// or a window, is first looked at as a whole, which mostly is enough.

#include "silhouette/cpu_fields.h"

#include <cmath>

#include "silhouette/edge_mesh.h"
#include "silhouette/float4.h"
#include "silhouette/mesh_projection.h"
#include "silhouette/strip_scan.h"

namespace dimline {

namespace {

/// Relative error that float arithmetic may leave in a facet's plane evaluated at the viewer, with room to spare.
constexpr float kFacingError = 1e-6F;

/// Instances of up to so many parts are looked at as a whole. With more, one box around them says too little: a mesh may be all of a building.
constexpr std::size_t kPartsTogether = 16;

/// Steps into which "how far out" is divided to order the parts.
constexpr std::size_t kOrderSteps = 64;

enum Facing : std::uint8_t { kEdgeOn = 0, kTowards = 1, kAway = 2 };

/// An instance of the scene.
struct Placed {
  std::uint32_t mesh;
  Mat4 toWorld;  ///< from the mesh's frame relative to its centre
};

/// A part of an instance, or all of its parts, that may be seen in this frame.
struct Seen {
  std::uint32_t instance;
  EdgeMesh::Span parts;
  BoxOnScreen box;
};

/// All of a mesh as one part.
EdgeMesh::Part wholeOf(const EdgeMesh& mesh) {
  Bounds bounds;
  for (const EdgeMesh::Part& part : mesh.parts) {
    bounds.add(part.center - part.halfSize);
    bounds.add(part.center + part.halfSize);
  }
  EdgeMesh::Part whole;
  whole.center = bounds.center();
  whole.halfSize = bounds.size() * 0.5;
  return whole;
}

bool finite(const Mat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

Vec2 onScreen(const ProjectedVertex& v) { return Vec2(v.pixel.x, v.pixel.y) / v.pixel.z; }

/// Where the segment between two vertices passes the near plane, on screen.
Vec2 cutAtNear(const ProjectedVertex& a, const ProjectedVertex& b) {
  const Vec3 h = a.pixel + (b.pixel - a.pixel) * (a.beforeNear / (a.beforeNear - b.beforeNear));
  return Vec2(h.x, h.y) / h.z;
}

/// Scans an edge, cut at the near plane and at the viewport's sides.
void scanCutEdge(const ProjectedVertex& a, const ProjectedVertex& b, StripScan& scan) {
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

/// Scans what a triangle that is not wholly in view adds besides its edges: its cut with the near plane, its
/// stretches on the viewport's sides.
void scanCutTriangle(const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c, StripScan& scan) {
  const std::array<const ProjectedVertex*, 3> corners{&a, &b, &c};
  ScreenPolygon polygon;
  std::array<Vec2, 2> nearCut;
  std::size_t nearCuts = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ProjectedVertex& from = *corners[i];
    const ProjectedVertex& to = *corners[(i + 1) % 3];
    const bool fromShown = (from.beyond & kBeyondNear) == 0;
    if (fromShown) polygon.corners[polygon.count++] = onScreen(from);
    if (fromShown != ((to.beyond & kBeyondNear) == 0)) {
      polygon.corners[polygon.count++] = nearCut[nearCuts++] = cutAtNear(from, to);
    }
  }
  if (nearCuts == 2) scan.scan(nearCut[0], nearCut[1]);
  const std::uint8_t any = a.beyond | b.beyond | c.beyond;
  if ((any & (kBeyondLeft | kBeyondNear)) != 0) scanStretch(polygon, 0, 0.0, scan);
  if ((any & (kBeyondRight | kBeyondNear)) != 0) scanStretch(polygon, 0, scan.widthPx(), scan);
  if ((any & (kBeyondTop | kBeyondNear)) != 0) scanStretch(polygon, 1, 0.0, scan);
  if ((any & (kBeyondBottom | kBeyondNear)) != 0) scanStretch(polygon, 1, scan.heightPx(), scan);
}

/// Whether what is in the box can change no field.
bool known(const BoxOnScreen& box, const StripScan& scan) {
  return (box.anyBeyond & kBeyondNear) == 0 && scan.knows(box.left, box.right, box.top, box.bottom);
}

}  // namespace

struct CpuFields::Prepared {
  std::vector<EdgeMesh> meshes;
  std::vector<EdgeMesh::Part> wholes;  ///< one a mesh: its box
  std::vector<Placed> instances;

  // Scratch, as large as the scene can need.
  std::vector<MeshProjection> projections;  ///< one an instance
  std::vector<Seen> seen;
  std::vector<std::uint32_t> order;       ///< indices into `seen`, from the outside in
  std::vector<std::uint8_t> facing;       ///< one a facet of the mesh at hand; those before kFirstFacet stay edge-on
  std::vector<std::uint32_t> silhouette;  ///< edges of the part at hand, in the first silhouetteCount places
  std::size_t silhouetteCount = 0;
  std::vector<ProjectedVertex> projected;  ///< one a vertex of the mesh at hand

  void lookForParts(const View& view, const StripScan& scan);
  void orderParts(const StripScan& scan);
  void findSilhouette(const EdgeMesh& mesh, const EdgeMesh::Part& part, const MeshProjection& projection);
  void scanPart(std::uint32_t instance, const EdgeMesh::Part& part, const BoxOnScreen& box, StripScan& scan);
  void scanInside(const EdgeMesh& mesh, const MeshProjection& projection, StripScan& scan) const;
  void scanCut(const EdgeMesh& mesh, const EdgeMesh::Part& part, const MeshProjection& projection, StripScan& scan);
};

/// Projects the instances, and lists the parts that may be seen.
void CpuFields::Prepared::lookForParts(const View& view, const StripScan& scan) {
  seen.clear();
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    projections[i] = MeshProjection(view, instances[i].toWorld, scan.widthPx(), scan.heightPx());
    const std::vector<EdgeMesh::Part>& parts = meshes[instances[i].mesh].parts;
    const auto add = [&](const EdgeMesh::Part& looked, std::uint32_t first, std::size_t count) {
      const BoxOnScreen box = projections[i].look(looked);
      if (box.allBeyond == 0) seen.push_back({i, {first, first + static_cast<std::uint32_t>(count)}, box});
    };
    if (parts.size() > 1 && parts.size() <= kPartsTogether) {
      add(wholes[instances[i].mesh], 0, parts.size());
    } else {
      for (std::uint32_t p = 0; p < parts.size(); ++p) add(parts[p], p, 1);
    }
  }
}

/// Orders the parts by how far out their boxes reach, roughly: the farthest first, and before them those that reach
/// behind the near plane.
void CpuFields::Prepared::orderParts(const StripScan& scan) {
  const auto width = static_cast<float>(scan.widthPx());
  const auto height = static_cast<float>(scan.heightPx());
  float left = width;
  float right = 0;
  float top = height;
  float bottom = 0;
  for (const Seen& part : seen) {
    if ((part.box.anyBeyond & kBeyondNear) != 0) continue;
    left = std::min(left, part.box.left);
    right = std::max(right, part.box.right);
    top = std::min(top, part.box.top);
    bottom = std::max(bottom, part.box.bottom);
  }
  left = std::max(left, 0.0F);
  right = std::min(right, width);
  top = std::max(top, 0.0F);
  bottom = std::min(bottom, height);
  const auto stepOf = [&](const Seen& part) -> std::size_t {
    if ((part.box.anyBeyond & kBeyondNear) != 0) return 0;
    // 0 where it reaches as far as anything does on some side.
    const float across = std::min(part.box.left - left, right - part.box.right) / std::max(right - left, 1.0F);
    const float down = std::min(part.box.top - top, bottom - part.box.bottom) / std::max(bottom - top, 1.0F);
    const float in = std::clamp(2 * std::min(across, down), 0.0F, 0.999F);
    return static_cast<std::size_t>(in * static_cast<float>(kOrderSteps));
  };
  std::array<std::uint32_t, kOrderSteps + 1> begin{};
  for (const Seen& part : seen) ++begin[stepOf(part) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  order.resize(seen.size());
  for (std::uint32_t i = 0; i < seen.size(); ++i) order[begin[stepOf(seen[i])]++] = i;
}

void CpuFields::Prepared::findSilhouette(const EdgeMesh& mesh, const EdgeMesh::Part& part,
                                         const MeshProjection& projection) {
  const glm::vec4 v = projection.viewer();
  const float error = kFacingError * (glm::length(glm::vec3(v)) + static_cast<float>(mesh.radiusM) * std::abs(v.w));
  for (std::uint32_t i = part.facets.first; i < part.facets.end; i += 4) {
    const Float4 side = load4(&mesh.normalX[i]) * v.x + load4(&mesh.normalY[i]) * v.y + load4(&mesh.normalZ[i]) * v.z +
                        load4(&mesh.offset[i]) * v.w;
    const unsigned towards = lanesOf(side > splat4(error));
    const unsigned away = lanesOf(side < splat4(-error));
    for (unsigned lane = 0; lane < 4; ++lane) {
      facing[i + lane] = static_cast<std::uint8_t>((towards >> lane & 1U) * kTowards | (away >> lane & 1U) * kAway);
    }
  }
  // Written to at every edge, kept only where it is one: no branch to guess wrong.
  std::uint32_t* next = silhouette.data();
  for (std::uint32_t i = part.edges.first; i < part.edges.end; ++i) {
    const EdgeMesh::Edge& edge = mesh.edges[i];
    *next = i;
    next += (facing[edge.facetA] & facing[edge.facetB]) == 0 ? 1 : 0;
  }
  silhouetteCount = static_cast<std::size_t>(next - silhouette.data());
}

void CpuFields::Prepared::scanPart(std::uint32_t instance, const EdgeMesh::Part& part, const BoxOnScreen& box, StripScan& scan) {
  const EdgeMesh& mesh = meshes[instances[instance].mesh];
  const MeshProjection& projection = projections[instance];
  findSilhouette(mesh, part, projection);
  if (box.anyBeyond == 0) {
    scanInside(mesh, projection, scan);
  } else {
    scanCut(mesh, part, projection, scan);
  }
}

void CpuFields::Prepared::scanInside(const EdgeMesh& mesh, const MeshProjection& projection, StripScan& scan) const {
  for (std::size_t i = 0; i < silhouetteCount; ++i) {
    const EdgeMesh::Edge& edge = mesh.edges[silhouette[i]];
    scan.scanInside(projection.toScreen(mesh.positions[edge.a]), projection.toScreen(mesh.positions[edge.b]));
  }
}

void CpuFields::Prepared::scanCut(const EdgeMesh& mesh, const EdgeMesh::Part& part, const MeshProjection& projection,
                                  StripScan& scan) {
  for (std::uint32_t i = part.vertices.first; i < part.vertices.end; ++i)
    projected[i] = projection.project(Vec3(mesh.positions[i]));
  for (std::size_t i = 0; i < silhouetteCount; ++i) {
    const EdgeMesh::Edge& edge = mesh.edges[silhouette[i]];
    scanCutEdge(projected[edge.a], projected[edge.b], scan);
  }
  for (std::uint32_t i = part.triangles.first; i < part.triangles.end; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
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
  Prepared& p = *prepared_;
  p.meshes.clear();
  p.wholes.clear();
  std::size_t vertices = 0;
  std::size_t facets = EdgeMesh::kFirstFacet;
  std::size_t edges = 0;
  for (const Mesh& mesh : scene.meshes) {
    const EdgeMesh& made = p.meshes.emplace_back(makeEdgeMesh(mesh));
    p.wholes.push_back(wholeOf(made));
    vertices = std::max(vertices, made.positions.size());
    facets = std::max(facets, made.offset.size());
    for (const EdgeMesh::Part& part : made.parts) edges = std::max<std::size_t>(edges, part.edges.size());
  }
  p.instances.clear();
  std::size_t parts = 0;
  for (const Instance& instance : scene.instances) {
    const EdgeMesh& mesh = p.meshes[instance.mesh];
    Mat4 toWorld(instance.transform);
    toWorld[3] = toWorld * Vec4(mesh.center, 1.0);
    if (!finite(toWorld)) continue;  // it has no place to be seen at
    p.instances.push_back({instance.mesh, toWorld});
    parts += mesh.parts.size();
  }
  p.projections.resize(p.instances.size());
  p.seen.reserve(parts);
  p.order.reserve(parts);
  p.facing.assign(facets, kEdgeOn);
  p.silhouette.resize(edges + 1);
  p.projected.resize(vertices);
}

void CpuFields::produce(const View& view, DistanceFields& fields) {
  fields.reset(static_cast<int>(std::ceil(view.widthPx())), static_cast<int>(std::ceil(view.heightPx())));
  StripScan scan(fields);
  Prepared& p = *prepared_;
  p.lookForParts(view, scan);
  p.orderParts(scan);
  for (const std::uint32_t index : p.order) {
    const Seen& seen = p.seen[index];
    if (known(seen.box, scan)) continue;
    const std::vector<EdgeMesh::Part>& parts = p.meshes[p.instances[seen.instance].mesh].parts;
    if (seen.parts.size() == 1) {
      p.scanPart(seen.instance, parts[seen.parts.first], seen.box, scan);
      continue;
    }
    for (std::uint32_t i = seen.parts.first; i < seen.parts.end; ++i) {
      const BoxOnScreen box = p.projections[seen.instance].look(parts[i]);
      if (box.allBeyond == 0 && !known(box, scan)) p.scanPart(seen.instance, parts[i], box, scan);
    }
  }
  fields.buildTrees();
}

}  // namespace dimline
