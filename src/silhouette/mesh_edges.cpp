#include "silhouette/mesh_edges.h"

#include <algorithm>

// Each vertex has a list of the edges of which it is the lower end. A vertex has some six edges, and is the lower end
// of half of them, so these lists are shorter than any search by hashing or sorting.

namespace dimline {

MeshEdges::MeshEdges(std::span<const Triangle> triangles, std::size_t vertices) : firstAt_(vertices, kNone) {
  edges_.reserve(triangles.size() * 3 / 2);
  ofTriangle_.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    ofTriangle_.push_back({use(a, b, t), use(b, c, t), use(c, a, t)});
  }
}

inline std::uint32_t MeshEdges::use(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
  if (a == b) return kNone;
  std::uint32_t& first = firstAt_[std::min(a, b)];
  for (std::uint32_t i = first; i != kNone; i = edges_[i].next) {
    Edge& edge = edges_[i];
    const bool opposite = edge.a == b && edge.b == a;
    if (!opposite && !(edge.a == a && edge.b == b)) continue;
    edge.triangleB = opposite && edge.triangleB == kNone ? triangle : kMany;
    return i;
  }
  edges_.push_back({a, b, triangle, kNone, first});
  return first = static_cast<std::uint32_t>(edges_.size() - 1);
}

}  // namespace dimline
