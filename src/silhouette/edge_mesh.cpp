// What costs time here is looking for vertices at the same place, so that is done only where it is needed. First the
// triangles are taken as their vertex numbers say: what hangs together is a part, and a part all of whose edges have
// two triangles that agree is closed as it stands. Its silhouette is right whatever else may touch it. Only what is not
// closed is welded and taken once more.

#include "silhouette/edge_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "silhouette/mesh_edges.h"

namespace dimline {

namespace {

using Triangle = MeshEdges::Triangle;

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// How far a facet's vertices may lie off its plane: a share of the part's size, of which a pixel shows nothing when
/// the part fills the viewport, and one of its distance from the mesh's origin, because positions are floats and have
/// gone through a few operations.
constexpr double kFlatShareOfPart = 1e-6;
constexpr double kFlatShareOfPlace = 3e-7;

bool threeDifferent(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

/// The positions, and those triangles that have three different, finite vertices.
void take(const Mesh& mesh, EdgeMesh& prepared) {
  std::vector<bool> finite(mesh.positions.size());
  prepared.positions.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    finite[i] = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    prepared.positions.push_back(p + 0.0F);  // minus zero is zero
  }
  prepared.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    if (threeDifferent(t) && finite[t[0]] && finite[t[1]] && finite[t[2]]) prepared.triangles.push_back(t);
  }
}

// --- Parts --------------------------------------------------------------------------------------------------------------

/// What hangs together by shared vertices, as a forest over these: the lowest vertex of a part is its root.
class PartForest {
public:
  explicit PartForest(const EdgeMesh& mesh) : parent_(mesh.positions.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& [a, b, c] : mesh.triangles) {
      join(a, b);
      join(a, c);
    }
  }

  std::uint32_t root(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

private:
  void join(std::uint32_t a, std::uint32_t b) {
    if (parent_[a] == parent_[b]) return;
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::uint32_t> parent_;
};

/// Sorts the triangles by part, in their order within each. Parts are numbered in the order in which the triangles
/// first meet them; where each begins, and after the last.
std::vector<std::uint32_t> sortTriangles(EdgeMesh& mesh) {
  PartForest forest(mesh);
  std::vector<std::uint32_t> numberOf(mesh.positions.size(), kNone);  // by root
  std::vector<std::uint32_t> partOf(mesh.triangles.size());
  std::vector<std::uint32_t> begin{0};
  bool sorted = true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::uint32_t& number = numberOf[forest.root(mesh.triangles[i][0])];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(begin.size() - 1);
      begin.push_back(0);
    }
    sorted = sorted && number + 2 == begin.size();
    partOf[i] = number;
    ++begin[number + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  if (sorted) return begin;
  std::vector<std::uint32_t> next = begin;
  std::vector<Triangle> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[next[partOf[i]]++] = mesh.triangles[i];
  mesh.triangles = std::move(triangles);
  return begin;
}

/// Finds the parts, and sorts triangles and vertices by them. Vertices that no triangle uses are left out.
void sortIntoParts(EdgeMesh& mesh) {
  const std::vector<std::uint32_t> begin = sortTriangles(mesh);
  // Numbered as the triangles first use them, vertices are in the order of their parts.
  std::vector<std::uint32_t> newNumber(mesh.positions.size(), kNone);
  std::vector<glm::vec3> positions;
  positions.reserve(mesh.positions.size());
  mesh.parts.assign(begin.size() - 1, {});
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    EdgeMesh::Part& part = mesh.parts[i];
    part.triangles = {begin[i], begin[i + 1]};
    part.vertices.first = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      for (std::uint32_t& vertex : mesh.triangles[t]) {
        std::uint32_t& number = newNumber[vertex];
        if (number == kNone) {
          number = static_cast<std::uint32_t>(positions.size());
          positions.push_back(mesh.positions[vertex]);
        }
        vertex = number;
      }
    }
    part.vertices.end = static_cast<std::uint32_t>(positions.size());
  }
  mesh.positions = std::move(positions);
}

// --- Welding ------------------------------------------------------------------------------------------------------------

/// Finds vertices at exactly the same place.
class Welder {
public:
  Welder(const std::vector<glm::vec3>& positions, std::size_t count)
      : positions_(positions), slots_(std::bit_ceil(count * 2 + 1), kNone) {}

  /// The first vertex that was given of those at the same place.
  std::uint32_t firstLike(std::uint32_t vertex) {
    const glm::vec3& p = positions_[vertex];
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(p) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kNone) slots_[slot] = vertex;
      if (positions_[slots_[slot]] == p) return slots_[slot];
    }
  }

private:
  static std::size_t hash(const glm::vec3& p) {
    std::uint64_t h = std::bit_cast<std::uint32_t>(p.x) * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29) ^ std::bit_cast<std::uint32_t>(p.y)) * 0xBF58476D1CE4E5B9ULL;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.z)) * 0x94D049BB133111EBULL;
    return static_cast<std::size_t>(h ^ (h >> 31));
  }

  const std::vector<glm::vec3>& positions_;
  std::vector<std::uint32_t> slots_;
};

/// Makes vertices at the same place one in those parts that are not closed: models that split vertices for their
/// normals are closed that way. False when there were none.
bool weldOpenParts(EdgeMesh& mesh, const MeshEdges& edges) {
  // Edges come in the order of the triangles, and with them of the parts.
  std::vector<bool> open(mesh.parts.size(), false);
  std::size_t openVertices = 0;
  std::size_t part = 0;
  for (const MeshEdges::Edge& edge : edges.all()) {
    while (edge.a >= mesh.parts[part].vertices.end) ++part;
    if (!edge.border() || open[part]) continue;
    open[part] = true;
    openVertices += mesh.parts[part].vertices.size();
  }
  if (openVertices == 0) return false;

  Welder welder(mesh.positions, openVertices);
  std::vector<std::uint32_t> newNumber(mesh.positions.size());
  std::iota(newNumber.begin(), newNumber.end(), 0U);
  bool welded = false;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    if (!open[i]) continue;
    for (std::uint32_t v = mesh.parts[i].vertices.first; v < mesh.parts[i].vertices.end; ++v) {
      newNumber[v] = welder.firstLike(v);
      welded = welded || newNumber[v] != v;
    }
  }
  if (!welded) return false;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& vertex : t) vertex = newNumber[vertex];
  }
  std::erase_if(mesh.triangles, [](const Triangle& t) { return !threeDifferent(t); });
  return true;
}

// --- Places and planes --------------------------------------------------------------------------------------------------

/// Moves the positions so that the middle of their box is the origin, and measures the parts.
void recenter(EdgeMesh& mesh) {
  if (mesh.positions.empty()) return;
  const auto boundsOf = [&](const EdgeMesh::Span& vertices) {
    glm::vec3 low = mesh.positions[vertices.first];
    glm::vec3 high = low;
    for (std::uint32_t v = vertices.first + 1; v < vertices.end; ++v) {
      low = glm::min(low, mesh.positions[v]);
      high = glm::max(high, mesh.positions[v]);
    }
    return Bounds{Vec3(low), Vec3(high)};
  };
  const Bounds bounds = boundsOf({0, static_cast<std::uint32_t>(mesh.positions.size())});
  mesh.center = bounds.center();
  mesh.radiusM = bounds.diagonal() * 0.5;
  for (glm::vec3& position : mesh.positions) position = glm::vec3(Vec3(position) - mesh.center);
  for (EdgeMesh::Part& part : mesh.parts) {
    const Bounds box = boundsOf(part.vertices);
    part.center = box.center();
    part.halfSize = box.size() * 0.5;
  }
}

/// Collects the triangles of each part into facets: from a triangle with area over shared edges to all that lie in its
/// plane.
class FacetFinder {
public:
  FacetFinder(EdgeMesh& mesh, const MeshEdges& edges)
      : mesh_(mesh), edges_(edges), facetOf_(mesh.triangles.size(), EdgeMesh::kNoFacet) {
    for (std::vector<float>* component : {&mesh.normalX, &mesh.normalY, &mesh.normalZ, &mesh.offset})
      component->reserve(mesh.triangles.size());
    while (facetCount() < EdgeMesh::kFirstFacet) add(Vec3(0.0), 0);
    for (EdgeMesh::Part& part : mesh.parts) findIn(part);
  }

  [[nodiscard]] std::uint32_t facetOf(std::uint32_t triangle) const { return facetOf_[triangle]; }

private:
  [[nodiscard]] std::uint32_t facetCount() const { return static_cast<std::uint32_t>(mesh_.offset.size()); }

  std::uint32_t add(const Vec3& normal, double offset) {
    mesh_.normalX.push_back(static_cast<float>(normal.x));
    mesh_.normalY.push_back(static_cast<float>(normal.y));
    mesh_.normalZ.push_back(static_cast<float>(normal.z));
    mesh_.offset.push_back(static_cast<float>(offset));
    return facetCount() - 1;
  }

  void findIn(EdgeMesh::Part& part) {
    const double place = glm::length(mesh_.center + part.center) + glm::length(part.halfSize);
    flatM_ = glm::length(part.halfSize) * kFlatShareOfPart + place * kFlatShareOfPlace;
    part.facets.first = facetCount();
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      if (facetOf_[t] == EdgeMesh::kNoFacet) growFrom(t);
    }
    // What is left has no area and no facet beside it: each one is a facet of its own, that faces nowhere.
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      if (facetOf_[t] == EdgeMesh::kNoFacet) facetOf_[t] = add(Vec3(0.0), 0);
    }
    while (facetCount() % 4 != 0) add(Vec3(0.0), 0);
    part.facets.end = facetCount();
  }

  [[nodiscard]] Vec3 at(std::uint32_t vertex) const { return Vec3(mesh_.positions[vertex]); }

  /// Twice the area, along the normal.
  [[nodiscard]] Vec3 areaVector(const Triangle& t) const {
    return glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
  }

  /// Begins a facet at a triangle that is wide enough for its positions' rounding not to turn it.
  void growFrom(std::uint32_t seed) {
    const Triangle& t = mesh_.triangles[seed];
    const Vec3 ab = at(t[1]) - at(t[0]);
    const Vec3 ac = at(t[2]) - at(t[0]);
    const Vec3 bc = ac - ab;
    const Vec3 area = glm::cross(ab, ac);
    const double areaSquared = glm::dot(area, area);
    const double longestSquared = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    if (!(areaSquared > longestSquared * flatM_ * flatM_)) return;
    const Vec3 normal = area / std::sqrt(areaSquared);
    spread(seed, normal, -glm::dot(normal, at(t[0])));
  }

  void spread(std::uint32_t seed, const Vec3& normal, double offset) {
    const std::uint32_t facet = add(normal, offset);
    facetOf_[seed] = facet;
    stack_.push_back(seed);
    while (!stack_.empty()) {
      const std::uint32_t triangle = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t e : edges_.of(triangle)) {
        const MeshEdges::Edge& edge = edges_[e];
        if (edge.border()) continue;
        const std::uint32_t next = edge.across(triangle);
        if (facetOf_[next] != EdgeMesh::kNoFacet || !liesIn(next, edge, normal, offset)) continue;
        facetOf_[next] = facet;
        stack_.push_back(next);
      }
    }
  }

  /// Whether a triangle lies in a plane in which the edge, one of its own, lies.
  [[nodiscard]] bool liesIn(std::uint32_t triangle, const MeshEdges::Edge& edge, const Vec3& normal, double offset) const {
    const Triangle& t = mesh_.triangles[triangle];
    const std::uint32_t opposite = t[0] ^ t[1] ^ t[2] ^ edge.a ^ edge.b;  // the vertex that is not the edge's
    if (std::abs(glm::dot(normal, at(opposite)) + offset) > flatM_) return false;
    // A fold by half a turn lies in the plane as well, upside down.
    return glm::dot(areaVector(t), normal) >= 0;
  }

  EdgeMesh& mesh_;
  const MeshEdges& edges_;
  std::vector<std::uint32_t> facetOf_;
  std::vector<std::uint32_t> stack_;
  double flatM_ = 0;
};

}  // namespace

EdgeMesh makeEdgeMesh(const Mesh& mesh) {
  EdgeMesh prepared;
  take(mesh, prepared);
  sortIntoParts(prepared);
  MeshEdges edges(prepared.triangles, prepared.positions.size());
  if (weldOpenParts(prepared, edges)) {
    sortIntoParts(prepared);
    edges = MeshEdges(prepared.triangles, prepared.positions.size());
  }
  recenter(prepared);
  const FacetFinder facets(prepared, edges);

  prepared.edges.reserve(edges.all().size());
  auto edge = edges.all().begin();
  for (EdgeMesh::Part& part : prepared.parts) {
    part.edges.first = static_cast<std::uint32_t>(prepared.edges.size());
    for (; edge != edges.all().end() && edge->a < part.vertices.end; ++edge) {
      const std::uint32_t facetA = edge->border() ? EdgeMesh::kNoFacet : facets.facetOf(edge->triangleA);
      const std::uint32_t facetB = edge->border() ? EdgeMesh::kNoFacet : facets.facetOf(edge->triangleB);
      if (edge->border() || facetA != facetB) prepared.edges.push_back({edge->a, edge->b, facetA, facetB});
    }
    part.edges.end = static_cast<std::uint32_t>(prepared.edges.size());
  }
  return prepared;
}

}  // namespace dimline
