#include "silhouette/edge_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace dimline {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// How far a facet's vertices may lie off its plane: a share of the part's size, of which a pixel shows nothing when
/// the part fills the viewport, and one of its distance from the mesh's origin, because positions are floats and have
/// gone through a few operations.
constexpr double kFlatShareOfPart = 1e-6;
constexpr double kFlatShareOfPlace = 3e-7;

/// Gives vertices at exactly the same place one number. Models that split vertices for their normals stay closed that
/// way.
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
  std::uint32_t triangleA, triangleB;  ///< kNone twice when it is not shared by just two that agree
};

/// One use of an edge by a triangle, kept with the edge's lower vertex.
struct EdgeUse {
  std::uint32_t upper;
  std::uint32_t triangle;
  bool rising;  ///< the triangle runs it from the lower to the upper vertex
};

/// Finds all edges: every use of an edge is put with the edge's lower vertex, and there the few that share the upper
/// one are matched.
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

/// Collects the triangles of each part into facets: from a triangle with area over shared edges to all that lie in its
/// plane.
class FacetFinder {
public:
  FacetFinder(EdgeMesh& mesh, const std::vector<MeshEdge>& edges)
      : mesh_(mesh),
        neighbours_(mesh.triangles.size(), {kNone, kNone, kNone}),
        facetOf_(mesh.triangles.size(), EdgeMesh::kNoFacet) {
    for (const MeshEdge& edge : edges) {
      if (edge.triangleA == kNone) continue;
      addNeighbour(edge.triangleA, edge.triangleB);
      addNeighbour(edge.triangleB, edge.triangleA);
    }
    fillUp();
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

  void fillUp() {
    while (facetCount() % 4 != 0) add(Vec3(0.0), 0);
  }

  void findIn(EdgeMesh::Part& part) {
    const double place = glm::length(mesh_.center + part.center) + glm::length(part.halfSize);
    flatM_ = glm::length(part.halfSize) * kFlatShareOfPart + place * kFlatShareOfPlace;
    part.facets.first = facetCount();
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      if (facetOf_[t] == EdgeMesh::kNoFacet && hasArea(t)) grow(t);
    }
    // What is left has no area and no facet beside it: each one is a facet of its own, that faces nowhere.
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      if (facetOf_[t] == EdgeMesh::kNoFacet) facetOf_[t] = add(Vec3(0.0), 0);
    }
    fillUp();
    part.facets.end = facetCount();
  }

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
    return glm::length(areaVector(triangle)) > longest * flatM_;
  }

  void grow(std::uint32_t seed) {
    const Vec3 normal = glm::normalize(areaVector(seed));
    const double offset = -glm::dot(normal, Vec3(mesh_.positions[mesh_.triangles[seed][0]]));
    const std::uint32_t facet = add(normal, offset);
    facetOf_[seed] = facet;
    stack_.push_back(seed);
    while (!stack_.empty()) {
      const std::uint32_t triangle = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t next : neighbours_[triangle]) {
        if (next == kNone || facetOf_[next] != EdgeMesh::kNoFacet || !liesIn(next, normal, offset)) continue;
        facetOf_[next] = facet;
        stack_.push_back(next);
      }
    }
  }

  [[nodiscard]] bool liesIn(std::uint32_t triangle, const Vec3& normal, double offset) const {
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      if (std::abs(glm::dot(normal, Vec3(mesh_.positions[vertex])) + offset) > flatM_) return false;
    }
    // A fold by half a turn lies in the plane as well, upside down.
    return glm::dot(areaVector(triangle), normal) >= 0;
  }

  EdgeMesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<std::uint32_t> facetOf_;
  std::vector<std::uint32_t> stack_;
  double flatM_ = 0;
};

bool finite(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
    const glm::vec3& p = mesh.positions[vertex];
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

void weld(const Mesh& mesh, EdgeMesh& prepared) {
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
    if (welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0])
      prepared.triangles.push_back(welded);
  }
}

/// Moves the positions so that the middle of their box is the origin.
void recenter(EdgeMesh& mesh) {
  Bounds bounds;
  for (const glm::vec3& position : mesh.positions) bounds.add(Vec3(position));
  if (bounds.empty()) return;
  mesh.center = bounds.center();
  mesh.radiusM = bounds.diagonal() * 0.5;
  for (glm::vec3& position : mesh.positions) position = glm::vec3(Vec3(position) - mesh.center);
}

/// Which part each vertex belongs to, numbered in the order in which the triangles first meet them.
class PartFinder {
public:
  explicit PartFinder(const EdgeMesh& mesh) : parent_(mesh.positions.size()), numberOf_(mesh.positions.size(), kNone) {
    for (std::uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i;
    for (const auto& [a, b, c] : mesh.triangles) {
      join(a, b);
      join(a, c);
    }
    for (const auto& triangle : mesh.triangles) {
      std::uint32_t& number = numberOf_[root(triangle[0])];
      if (number == kNone) number = count_++;
    }
  }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// The part's number, or count() for a vertex that no triangle uses.
  [[nodiscard]] std::uint32_t of(std::uint32_t vertex) { return std::min(numberOf_[root(vertex)], count_); }

private:
  std::uint32_t root(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> numberOf_;
  std::uint32_t count_ = 0;
};

/// Sorts items by part, in their order within each; where each part's begin, and after the last.
template <typename Item, typename PartOf>
std::vector<std::uint32_t> sortByPart(std::vector<Item>& items, std::uint32_t parts, PartOf partOf) {
  std::vector<std::uint32_t> begin(parts + 2, 0);
  for (std::uint32_t i = 0; i < items.size(); ++i) ++begin[partOf(i) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<std::uint32_t> next = begin;
  std::vector<Item> sorted(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) sorted[next[partOf(i)]++] = items[i];
  items = std::move(sorted);
  return begin;
}

/// Finds the parts, and sorts vertices and triangles by them.
void sortIntoParts(EdgeMesh& mesh) {
  PartFinder finder(mesh);
  const std::uint32_t count = finder.count();
  const std::vector<std::uint32_t> triangles =
      sortByPart(mesh.triangles, count, [&](std::uint32_t i) { return finder.of(mesh.triangles[i][0]); });
  std::vector<std::uint32_t> order(mesh.positions.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const std::vector<std::uint32_t> vertices = sortByPart(order, count, [&](std::uint32_t i) { return finder.of(i); });
  std::vector<glm::vec3> positions(order.size());
  std::vector<std::uint32_t> newNumber(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    positions[i] = mesh.positions[order[i]];
    newNumber[order[i]] = i;
  }
  mesh.positions = std::move(positions);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = newNumber[vertex];
  }
  mesh.parts.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    EdgeMesh::Part& part = mesh.parts[i];
    part.vertices = {vertices[i], vertices[i + 1]};
    part.triangles = {triangles[i], triangles[i + 1]};
    Bounds bounds;
    for (std::uint32_t v = part.vertices.first; v < part.vertices.end; ++v) bounds.add(Vec3(mesh.positions[v]));
    part.center = bounds.center();
    part.halfSize = bounds.size() * 0.5;
  }
}

}  // namespace

EdgeMesh makeEdgeMesh(const Mesh& mesh) {
  EdgeMesh prepared;
  weld(mesh, prepared);
  recenter(prepared);
  sortIntoParts(prepared);
  const std::vector<MeshEdge> edges = findEdges(prepared);
  const FacetFinder facets(prepared, edges);

  prepared.edges.reserve(edges.size());
  auto edge = edges.begin();
  for (EdgeMesh::Part& part : prepared.parts) {
    // Edges come by their lower vertex, and with it by their part.
    part.edges.first = static_cast<std::uint32_t>(prepared.edges.size());
    for (; edge != edges.end() && edge->a < part.vertices.end; ++edge) {
      const bool border = edge->triangleA == kNone;
      const std::uint32_t facetA = border ? EdgeMesh::kNoFacet : facets.facetOf(edge->triangleA);
      const std::uint32_t facetB = border ? EdgeMesh::kNoFacet : facets.facetOf(edge->triangleB);
      if (border || facetA != facetB) prepared.edges.push_back({edge->a, edge->b, facetA, facetB});
    }
    part.edges.end = static_cast<std::uint32_t>(prepared.edges.size());
  }
  return prepared;
}

}  // namespace dimline
