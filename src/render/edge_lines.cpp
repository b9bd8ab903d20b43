#include "render/edge_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "silhouette/mesh_edges.h"

namespace dimline {

namespace {

/// Cosines: faces in one plane; shading that runs on smoothly over an edge.
constexpr float kFlatCosine = 0.9995F;
constexpr float kSmoothCosine = 0.94F;

/// The triangles of one mesh, with what its edges need of them.
class Faces {
 public:
  Faces(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh) {
    measureTriangles();
    joinFacets(edges);
  }

  [[nodiscard]] const glm::vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  [[nodiscard]] float facetArea(std::uint32_t triangle) const { return areas_[facetOf_[triangle]]; }
  [[nodiscard]] bool flat(const MeshEdges::Edge& edge) const { return glm::dot(normals_[edge.triangleA], normals_[edge.triangleB]) > kFlatCosine; }

  /// Whether the shading normals of an edge's two triangles agree at both its ends.
  [[nodiscard]] bool smooth(const MeshEdges::Edge& edge) const {
    for (const std::uint32_t vertex : {edge.a, edge.b}) {
      if (glm::dot(cornerNormal(edge.triangleA, vertex), cornerNormal(edge.triangleB, vertex)) < kSmoothCosine) return false;
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

  /// Triangles that hang together in one plane are one facet, called after one of them, which carries their area.
  void joinFacets(const MeshEdges& edges) {
    facetOf_.resize(mesh_.triangles.size());
    std::iota(facetOf_.begin(), facetOf_.end(), 0U);
    for (const MeshEdges::Edge& edge : edges.all()) {
      if (edge.border() || !flat(edge)) continue;
      const std::uint32_t a = root(edge.triangleA);
      const std::uint32_t b = root(edge.triangleB);
      if (a == b) continue;
      facetOf_[b] = a;
      areas_[a] += areas_[b];
    }
    for (std::uint32_t& facet : facetOf_) facet = root(facet);
  }

  std::uint32_t root(std::uint32_t triangle) {
    while (facetOf_[triangle] != triangle) triangle = facetOf_[triangle] = facetOf_[facetOf_[triangle]];
    return triangle;
  }

  [[nodiscard]] const glm::vec3& cornerNormal(std::uint32_t triangle, std::uint32_t vertex) const {
    const auto& corners = mesh_.triangles[triangle];
    return mesh_.normals[triangle][corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2];
  }

  const Mesh& mesh_;
  std::vector<glm::vec3> normals_;
  std::vector<float> areas_;   ///< of triangles; for the one that a facet is called after, of the facet
  std::vector<std::uint32_t> facetOf_;
};

/// The inked edges of a mesh in its own frame.
std::vector<EdgeLine> edgeLinesOf(const Mesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.positions.size());
  const Faces faces(mesh, edges);
  std::vector<EdgeLine> lines;
  lines.reserve(edges.all().size());
  for (const MeshEdges::Edge& edge : edges.all()) {
    const bool border = edge.border();
    if (!border && faces.flat(edge)) continue;
    const glm::vec3& a = mesh.positions[edge.a];
    const glm::vec3& b = mesh.positions[edge.b];
    const float length = glm::length(b - a);
    if (!(length > 0.0F)) continue;
    EdgeLine line{a, b, faces.normal(edge.triangleA), border ? -faces.normal(edge.triangleA) : faces.normal(edge.triangleB), -1.0F};
    if (border) {
      line.widthM = faces.facetArea(edge.triangleA) / length;
    } else if (!faces.smooth(edge)) {
      line.widthM = std::min(faces.facetArea(edge.triangleA), faces.facetArea(edge.triangleB)) / length;
    }
    lines.push_back(line);
  }
  return lines;
}

/// Takes edges from a mesh to the world.
class EdgeMap {
 public:
  explicit EdgeMap(const glm::mat4& toWorld) : position_(toWorld), origin_(toWorld[3]), normal_(toWorld) {
    // Normals go by the inverse transpose: columns over their squared lengths. Widths go by the mean scale, which is near enough to fade by.
    for (int c = 0; c < 3; ++c) {
      const float squared = glm::dot(normal_[c], normal_[c]);
      scale_ += std::sqrt(squared) / 3.0F;
      if (squared > 0.0F) normal_[c] /= squared;
    }
  }

  [[nodiscard]] EdgeLine operator()(const EdgeLine& line) const {
    return {position_ * line.a + origin_, position_ * line.b + origin_, turned(line.normalA), turned(line.normalB), line.widthM * scale_};
  }

 private:
  [[nodiscard]] glm::vec3 turned(const glm::vec3& n) const {
    const glm::vec3 mapped = normal_ * n;
    const float length = glm::length(mapped);
    return length > 0.0F ? mapped / length : mapped;
  }

  glm::mat3 position_;
  glm::vec3 origin_;
  glm::mat3 normal_;
  float scale_ = 0.0F;
};

}  // namespace

void findEdgeLines(const Scene& scene, std::vector<EdgeLine>& edges) {
  edges.clear();
  std::vector<std::optional<std::vector<EdgeLine>>> ofMesh(scene.meshes.size());
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) {
    auto& own = ofMesh[instance.mesh];
    if (!own) own = edgeLinesOf(scene.meshes[instance.mesh]);
    count += own->size();
  }
  edges.reserve(count);
  for (const Instance& instance : scene.instances) {
    const std::vector<EdgeLine>& own = *ofMesh[instance.mesh];
    if (instance.transform == glm::mat4(1.0F)) {
      edges.insert(edges.end(), own.begin(), own.end());
      continue;
    }
    const EdgeMap toWorld(instance.transform);
    for (const EdgeLine& line : own) edges.push_back(toWorld(line));
  }
}

}  // namespace dimline
