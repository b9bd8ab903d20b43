#include "render/edge_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

namespace dimline {

namespace {

/// Cosines: faces in one plane; shading that runs on smoothly over an edge.
constexpr float kFlatCosine = 0.9995F;
constexpr float kSmoothCosine = 0.94F;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// One side of a triangle, under its lower vertex.
struct HalfEdge {
  std::uint32_t other = 0;      ///< the higher vertex
  std::uint32_t triangle = 0;
};

/// The triangles of one mesh, with what its edges need of them.
class MeshEdges {
 public:
  explicit MeshEdges(const Mesh& mesh) : mesh_(mesh) {
    measureTriangles();
    sortHalfEdges();
    joinFacets();
  }

  /// Runs emit(vertexA, vertexB, triangleA, triangleB or kNone) over the edges.
  template <typename Emit>
  void eachEdge(Emit emit) const {
    for (std::uint32_t low = 0; low + 1 < firstOf_.size(); ++low) {
      for (std::uint32_t i = firstOf_[low]; i < firstOf_[low + 1]; ++i) {
        const HalfEdge& half = halves_[i];
        // Sorted by the other vertex: an edge's triangles stand side by side.
        const bool paired = i + 1 < firstOf_[low + 1] && halves_[i + 1].other == half.other;
        emit(low, half.other, half.triangle, paired ? halves_[i + 1].triangle : kNone);
        if (paired) ++i;
      }
    }
  }

  [[nodiscard]] const glm::vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  [[nodiscard]] float facetArea(std::uint32_t triangle) const { return areas_[root(triangle)]; }
  [[nodiscard]] bool flat(std::uint32_t a, std::uint32_t b) const { return glm::dot(normals_[a], normals_[b]) > kFlatCosine; }

  /// Whether the shading normals of two triangles agree at both ends of their edge.
  [[nodiscard]] bool smooth(std::uint32_t a, std::uint32_t b, std::uint32_t vertexA, std::uint32_t vertexB) const {
    for (const std::uint32_t vertex : {vertexA, vertexB}) {
      if (glm::dot(cornerNormal(a, vertex), cornerNormal(b, vertex)) < kSmoothCosine) return false;
    }
    return true;
  }

 private:
  void measureTriangles() {
    normals_.reserve(mesh_.triangles.size());
    areas_.reserve(mesh_.triangles.size());
    for (const auto& t : mesh_.triangles) {
      const glm::vec3 a = mesh_.positions[t[0]];
      const glm::vec3 n = glm::cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a);
      const float length = glm::length(n);
      normals_.push_back(length > 0.0F ? n / length : glm::vec3(0.0F));
      areas_.push_back(length * 0.5F);
    }
  }

  void sortHalfEdges() {
    firstOf_.assign(mesh_.positions.size() + 1, 0);
    const auto each = [&](auto visit) {
      for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t p = mesh_.triangles[t][k];
          const std::uint32_t q = mesh_.triangles[t][(k + 1) % 3];
          if (p != q) visit(std::min(p, q), HalfEdge{std::max(p, q), t});
        }
      }
    };
    each([&](std::uint32_t low, const HalfEdge&) { ++firstOf_[low + 1]; });
    std::partial_sum(firstOf_.begin(), firstOf_.end(), firstOf_.begin());
    halves_.resize(firstOf_.back());
    std::vector<std::uint32_t> next(firstOf_.begin(), firstOf_.end() - 1);
    each([&](std::uint32_t low, const HalfEdge& half) { halves_[next[low]++] = half; });
    for (std::size_t v = 0; v + 1 < firstOf_.size(); ++v) {
      std::sort(halves_.begin() + firstOf_[v], halves_.begin() + firstOf_[v + 1],
                [](const HalfEdge& a, const HalfEdge& b) { return a.other != b.other ? a.other < b.other : a.triangle < b.triangle; });
    }
  }

  /// Triangles that hang together in one plane share a root, which carries their area.
  void joinFacets() {
    parents_.resize(mesh_.triangles.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
    eachEdge([&](std::uint32_t, std::uint32_t, std::uint32_t a, std::uint32_t b) {
      if (b == kNone || !flat(a, b)) return;
      const std::uint32_t rootA = root(a);
      const std::uint32_t rootB = root(b);
      if (rootA == rootB) return;
      parents_[rootB] = rootA;
      areas_[rootA] += areas_[rootB];
    });
  }

  [[nodiscard]] std::uint32_t root(std::uint32_t triangle) const {
    while (parents_[triangle] != triangle) {
      parents_[triangle] = parents_[parents_[triangle]];
      triangle = parents_[triangle];
    }
    return triangle;
  }

  [[nodiscard]] glm::vec3 cornerNormal(std::uint32_t triangle, std::uint32_t vertex) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh_.triangles[triangle][k] == vertex) return mesh_.normals[triangle][k];
    }
    return normals_[triangle];
  }

  const Mesh& mesh_;
  std::vector<glm::vec3> normals_;
  std::vector<float> areas_;                     ///< of triangles; at a root, of its facet
  std::vector<std::uint32_t> firstOf_;           ///< by lower vertex: where its half edges begin
  std::vector<HalfEdge> halves_;
  mutable std::vector<std::uint32_t> parents_;   ///< shortened while they are followed
};

/// The inked edges of a mesh in its own frame.
void appendMeshEdges(const Mesh& mesh, std::vector<EdgeLine>& edges) {
  const MeshEdges topology(mesh);
  topology.eachEdge([&](std::uint32_t va, std::uint32_t vb, std::uint32_t a, std::uint32_t b) {
    if (b != kNone && topology.flat(a, b)) return;
    const glm::vec3 pa = mesh.positions[va];
    const glm::vec3 pb = mesh.positions[vb];
    const float length = glm::length(pb - pa);
    if (!(length > 0.0F)) return;
    EdgeLine edge{pa, pb, topology.normal(a), b == kNone ? -topology.normal(a) : topology.normal(b), -1.0F};
    if (b == kNone) {
      edge.widthM = topology.facetArea(a) / length;
    } else if (!topology.smooth(a, b, va, vb)) {
      edge.widthM = std::min(topology.facetArea(a), topology.facetArea(b)) / length;
    }
    edges.push_back(edge);
  });
}

}  // namespace

void findEdgeLines(const Scene& scene, std::vector<EdgeLine>& edges) {
  edges.clear();
  std::vector<std::vector<EdgeLine>> ofMesh(scene.meshes.size());
  std::vector<bool> found(scene.meshes.size(), false);
  for (const Instance& instance : scene.instances) {
    std::vector<EdgeLine>& own = ofMesh[instance.mesh];
    if (!found[instance.mesh]) appendMeshEdges(scene.meshes[instance.mesh], own);
    found[instance.mesh] = true;
    const glm::mat4& m = instance.transform;
    // Normals go by the inverse transpose: columns over their squared lengths. Widths go by the mean scale, which is near enough to fade by.
    glm::mat3 normalMap(m);
    float scale = 0.0F;
    for (int c = 0; c < 3; ++c) {
      const float squared = glm::dot(normalMap[c], normalMap[c]);
      scale += std::sqrt(squared) / 3.0F;
      if (squared > 0.0F) normalMap[c] /= squared;
    }
    const auto mapNormal = [&](const glm::vec3& n) {
      const glm::vec3 mapped = normalMap * n;
      const float length = glm::length(mapped);
      return length > 0.0F ? mapped / length : mapped;
    };
    for (const EdgeLine& e : own) {
      edges.push_back({glm::vec3(m * glm::vec4(e.a, 1.0F)), glm::vec3(m * glm::vec4(e.b, 1.0F)), mapNormal(e.normalA),
                       mapNormal(e.normalB), e.widthM * scale});
    }
  }
}

}  // namespace dimline
