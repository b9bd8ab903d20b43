#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dimline {

/// The edges between triangles that share vertices, found in one pass.
class MeshEdges {
public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  struct Edge {
    std::uint32_t a = 0, b = 0;  ///< vertices, as triangleA runs it
    std::uint32_t triangleA = 0;
    std::uint32_t triangleB = kNone;  ///< read it by border() and across()
    std::uint32_t next = kNone;       ///< for the search: another edge with the same lower vertex

    /// Whether it has not just two triangles that agree about which side is out.
    [[nodiscard]] bool border() const { return triangleB >= kMany; }
    /// The triangle on the other side; not for a border.
    [[nodiscard]] std::uint32_t across(std::uint32_t triangle) const { return triangle == triangleA ? triangleB : triangleA; }
  };

  /// A triangle's side that runs from a vertex to itself is no edge.
  MeshEdges(std::span<const Triangle> triangles, std::size_t vertices);

  /// In the order in which the triangles first use them.
  [[nodiscard]] const std::vector<Edge>& all() const { return edges_; }
  [[nodiscard]] const Edge& operator[](std::uint32_t edge) const { return edges_[edge]; }
  /// The edges of a triangle: from its first vertex to its second, and on; kNone where there is none.
  [[nodiscard]] const std::array<std::uint32_t, 3>& of(std::uint32_t triangle) const { return ofTriangle_[triangle]; }

private:
  static constexpr std::uint32_t kMany = kNone - 1;  ///< in triangleB: more than one other triangle, or one that disagrees

  std::uint32_t use(std::uint32_t a, std::uint32_t b, std::uint32_t triangle);

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> firstAt_;  ///< by lower vertex
  std::vector<std::array<std::uint32_t, 3>> ofTriangle_;
};

}  // namespace dimline
