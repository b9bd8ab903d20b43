#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/geometry.h"
#include "model/scene.h"

namespace dimline {

/// A mesh prepared for finding its silhouette: its flat facets, and the edges between them.
///
/// Triangles that lie in one plane and hang together are one facet, so that they can only turn towards the viewer
/// together, and the edges inside a facet are left out: they are never part of a silhouette. An edge has the facet on
/// either side of it. Where there are not two (a border), or more, or the two disagree about which side is out, it has
/// kNoFacet twice and counts as silhouette from everywhere.
///
/// All is sorted by parts: what hangs together by shared vertices is one part. A model made of many solids can be
/// looked at solid by solid that way, however they were gathered into meshes. A part that is closed is taken as it is,
/// whatever else may touch it; in the others, vertices at the same place are one.
struct EdgeMesh {
  /// The facets' arrays begin with four that are no facets: zero planes, which face nowhere.
  static constexpr std::uint32_t kNoFacet = 0;
  static constexpr std::uint32_t kFirstFacet = 4;

  struct Edge {
    std::uint32_t a = 0, b = 0;            ///< vertices
    std::uint32_t facetA = 0, facetB = 0;  ///< facets on either side
  };

  /// Indices [first, end).
  struct Span {
    std::uint32_t first = 0, end = 0;
    [[nodiscard]] std::uint32_t size() const { return end - first; }
  };

  struct Part {
    Vec3 center{0.0};    ///< m, middle of its box, relative to the mesh's
    Vec3 halfSize{0.0};  ///< m, half the size of its box
    Span vertices, triangles, edges;
    Span facets;  ///< from a multiple of four to a multiple of four; those past the last are zero planes
  };

  Vec3 center{0.0};                                     ///< m, in the mesh's frame: middle of its box
  double radiusM = 0;                                   ///< half the diagonal of its box
  std::vector<glm::vec3> positions;                     ///< m, relative to `center`; those that a triangle uses
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< those with three different, finite vertices
  std::vector<Edge> edges;
  std::vector<Part> parts;

  // The facets' planes: normal . p + offset = 0 with p relative to `center`; a facet without area has a zero normal.
  // One array a component.
  std::vector<float> normalX, normalY, normalZ, offset;
};

/// Finds parts, facets and edges, and welds where that is needed. Time and memory grow with the number of triangles.
EdgeMesh makeEdgeMesh(const Mesh& mesh);

}  // namespace dimline
