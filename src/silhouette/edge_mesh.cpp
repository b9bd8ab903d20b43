#include "silhouette/edge_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace dimline {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Share of the mesh's radius by which a facet's vertices may lie off its plane. Positions are floats and went through
/// a few operations: some ten units in the last place. Seen with the mesh filling the viewport it is a thousandth of a pixel.
constexpr double kFlatShare = 1e-6;

/// Gives vertices at exactly the same place one number. Models that split vertices for their normals stay closed that way.
class Welder {
 public:
  explicit Welder(std::size_t count) : slots_(std::bit_ceil(count * 2 + 1), kNone) {}

  std::uint32_t add(const glm::vec3& position, std::vector<glm::vec3>& positions) {
    const glm::vec3 p = position + 0.0F;  // minus zero is zero
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(p) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kNone) {
        slots_[slot] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(p);
        return slots_[slot];
      }
      if (positions[slots_[slot]] == p) return slots_[slot];
    }
  }

 private:
  static std::size_t hash(const glm::vec3& p) {
    std::uint64_t h = std::bit_cast<std::uint32_t>(p.x) * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29) ^ std::bit_cast<std::uint32_t>(p.y)) * 0xBF58476D1CE4E5B9ULL;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.z)) * 0x94D049BB133111EBULL;
    return static_cast<std::size_t>(h ^ (h >> 31));
  }

  std::vector<std::uint32_t> slots_;
};

/// An edge as its triangles give it.
struct MeshEdge {
  std::uint32_t a, b;
  std::uint32_t triangleA, triangleB;   ///< kNone twice when it is not shared by just two that agree
};

/// One use of an edge by a triangle, kept with the edge's lower vertex.
struct EdgeUse {
  std::uint32_t upper;
  std::uint32_t triangle;
  bool rising;   ///< the triangle runs it from the lower to the upper vertex
};

/// Finds all edges: every use of an edge is put with the edge's lower vertex, and there the few that share the upper one are matched.
std::vector<MeshEdge> findEdges(const EdgeMesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.positions.size() + 2, 0);
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++begin[std::min(t[i], t[(i + 1) % 3]) + 2];
  }
  for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<EdgeUse> uses(mesh.triangles.size() * 3);
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto& t = mesh.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      uses[begin[std::min(a, b) + 1]++] = {std::max(a, b), triangle, a < b};
    }
  }

  std::vector<MeshEdge> edges;
  edges.reserve(mesh.triangles.size() * 3 / 2);
  for (std::uint32_t lower = 0; lower < mesh.positions.size(); ++lower) {
    const std::span<EdgeUse> here(uses.data() + begin[lower], begin[lower + 1] - begin[lower]);
    std::sort(here.begin(), here.end(), [](const EdgeUse& l, const EdgeUse& r) {
      return l.upper != r.upper ? l.upper < r.upper : l.triangle < r.triangle;
    });
    for (std::size_t i = 0; i < here.size();) {
      std::size_t end = i + 1;
      while (end < here.size() && here[end].upper == here[i].upper) ++end;
      const bool agreed = end - i == 2 && here[i].rising != here[i + 1].rising;
      edges.push_back({lower, here[i].upper, agreed ? here[i].triangle : kNone, agreed ? here[i + 1].triangle : kNone});
      i = end;
    }
  }
  return edges;
}

struct FacetPlane {
  Vec3 normal{0.0};
  double offset = 0;
};

/// Collects triangles into facets: from a triangle with area over shared edges to all that lie in its plane.
class FacetFinder {
 public:
  FacetFinder(const EdgeMesh& mesh, const std::vector<MeshEdge>& edges)
      : mesh_(mesh), neighbours_(mesh.triangles.size(), {kNone, kNone, kNone}), facetOf_(mesh.triangles.size(), kNone) {
    for (const MeshEdge& edge : edges) {
      if (edge.triangleA == kNone) continue;
      addNeighbour(edge.triangleA, edge.triangleB);
      addNeighbour(edge.triangleB, edge.triangleA);
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (facetOf_[t] == kNone && hasArea(t)) grow(t);
    }
    // What is left has no area and no facet beside it: each one is a facet of its own, that faces nowhere.
    for (std::uint32_t& facet : facetOf_) {
      if (facet != kNone) continue;
      facet = static_cast<std::uint32_t>(planes_.size());
      planes_.emplace_back();
    }
  }

  [[nodiscard]] std::uint32_t facetOf(std::uint32_t triangle) const { return facetOf_[triangle]; }
  [[nodiscard]] const std::vector<FacetPlane>& planes() const { return planes_; }

 private:
  void addNeighbour(std::uint32_t triangle, std::uint32_t neighbour) {
    for (std::uint32_t& slot : neighbours_[triangle]) {
      if (slot == kNone) {
        slot = neighbour;
        return;
      }
    }
  }

  [[nodiscard]] Vec3 areaVector(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vec3 origin(mesh_.positions[a]);
    return glm::cross(Vec3(mesh_.positions[b]) - origin, Vec3(mesh_.positions[c]) - origin);
  }

  /// Whether the triangle is wide enough for its positions' rounding not to turn it.
  [[nodiscard]] bool hasArea(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vec3 pa(mesh_.positions[a]);
    const Vec3 pb(mesh_.positions[b]);
    const Vec3 pc(mesh_.positions[c]);
    const double longest = std::max({glm::length(pb - pa), glm::length(pc - pb), glm::length(pa - pc)});
    return glm::length(areaVector(triangle)) > longest * mesh_.radiusM * kFlatShare;
  }

  void grow(std::uint32_t seed) {
    FacetPlane plane;
    plane.normal = glm::normalize(areaVector(seed));
    plane.offset = -glm::dot(plane.normal, Vec3(mesh_.positions[mesh_.triangles[seed][0]]));
    const auto facet = static_cast<std::uint32_t>(planes_.size());
    planes_.push_back(plane);
    facetOf_[seed] = facet;
    stack_.push_back(seed);
    while (!stack_.empty()) {
      const std::uint32_t triangle = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t next : neighbours_[triangle]) {
        if (next == kNone || facetOf_[next] != kNone || !liesIn(next, plane)) continue;
        facetOf_[next] = facet;
        stack_.push_back(next);
      }
    }
  }

  [[nodiscard]] bool liesIn(std::uint32_t triangle, const FacetPlane& plane) const {
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      const double off = glm::dot(plane.normal, Vec3(mesh_.positions[vertex])) + plane.offset;
      if (std::abs(off) > mesh_.radiusM * kFlatShare) return false;
    }
    // A fold by half a turn lies in the plane as well, upside down.
    return glm::dot(areaVector(triangle), plane.normal) >= 0;
  }

  const EdgeMesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<std::uint32_t> facetOf_;
  std::vector<FacetPlane> planes_;
  std::vector<std::uint32_t> stack_;
};

bool finite(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
    const glm::vec3& p = mesh.positions[vertex];
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

void weld(const Mesh& mesh, EdgeMesh& prepared) {
  Bounds bounds;
  for (const auto& triangle : mesh.triangles) {
    if (!finite(mesh, triangle)) continue;
    for (const std::uint32_t vertex : triangle) bounds.add(Vec3(mesh.positions[vertex]));
  }
  if (bounds.empty()) return;
  prepared.center = bounds.center();
  prepared.halfSize = bounds.size() * 0.5;
  prepared.radiusM = bounds.diagonal() * 0.5;

  Welder welder(mesh.positions.size());
  std::vector<std::uint32_t> newNumber(mesh.positions.size(), kNone);
  prepared.triangles.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    if (!finite(mesh, triangle)) continue;
    std::array<std::uint32_t, 3> welded{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& number = newNumber[triangle[i]];
      if (number == kNone) number = welder.add(mesh.positions[triangle[i]], prepared.positions);
      welded[i] = number;
    }
    if (welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0]) prepared.triangles.push_back(welded);
  }
  for (glm::vec3& position : prepared.positions) position = glm::vec3(Vec3(position) - prepared.center);
}

}  // namespace

EdgeMesh makeEdgeMesh(const Mesh& mesh) {
  EdgeMesh prepared;
  weld(mesh, prepared);
  const std::vector<MeshEdge> edges = findEdges(prepared);
  const FacetFinder facets(prepared, edges);

  prepared.noFacet = static_cast<std::uint32_t>(facets.planes().size());
  const std::size_t padded = (facets.planes().size() + 1 + 3) / 4 * 4;
  for (std::vector<float>* component : {&prepared.normalX, &prepared.normalY, &prepared.normalZ, &prepared.offset}) {
    component->assign(padded, 0.0F);
  }
  for (std::size_t i = 0; i < facets.planes().size(); ++i) {
    const FacetPlane& plane = facets.planes()[i];
    prepared.normalX[i] = static_cast<float>(plane.normal.x);
    prepared.normalY[i] = static_cast<float>(plane.normal.y);
    prepared.normalZ[i] = static_cast<float>(plane.normal.z);
    prepared.offset[i] = static_cast<float>(plane.offset);
  }
  for (const MeshEdge& edge : edges) {
    const bool border = edge.triangleA == kNone;
    const std::uint32_t facetA = border ? prepared.noFacet : facets.facetOf(edge.triangleA);
    const std::uint32_t facetB = border ? prepared.noFacet : facets.facetOf(edge.triangleB);
    if (border || facetA != facetB) prepared.edges.push_back({edge.a, edge.b, facetA, facetB});
  }
  return prepared;
}

}  // namespace dimline
