#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/geometry.h"

namespace dimline {

/// The viewport edge from which a field measures (paper 4.1 and figure 11).
enum class ViewportEdge : std::uint8_t { kLeft, kRight, kTop, kBottom };
inline constexpr std::array<ViewportEdge, 4> kViewportEdges{ViewportEdge::kLeft, ViewportEdge::kRight,
                                                            ViewportEdge::kTop, ViewportEdge::kBottom};

/// A strip (row or column) in which no silhouette is seen.
inline constexpr float kNoSilhouette = std::numeric_limits<float>::infinity();

/// One 1-D distance field: for each one-pixel strip at right angles to a viewport edge, the distance (CSS px) from
/// that edge to what is first met. Strip i covers [i, i+1) along the edge, counted from the left or from the top.
/// Over the strips stands a binary tree with the least and greatest value of each subtree (paper 4.1). Its leaves are
/// blocks of strips, which are looked through four strips at a time: sooner done than a descent to each strip, and a
/// field that is edited or copied has a tenth of the tree to mend or to copy.
///
///     kLeft:   strip i is row i      blocked where x >= value
///     kRight:  strip i is row i      blocked where x <= width - value
///     kTop:    strip i is column i   blocked where y >= value
///     kBottom: strip i is column i   blocked where y <= height - value
///
/// Values are in [0, extent] from a producer, kNoSilhouette where the strip is empty; a padded field may be below 0.
class DistanceField {
public:
  static constexpr std::size_t kBlockStrips = 16;

  /// `strips` strips, all empty. Allocates only when growing.
  void reset(std::size_t strips);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] float at(std::size_t strip) const { return values_[strip]; }
  /// Three more floats after the last may be read (kNoSilhouette), so that a loop can take four at a time.
  [[nodiscard]] std::span<const float> values() const { return {values_.data(), size_}; }

  /// Writable values; the tree is stale until buildTree(), or mendTree() when only the strips [first, last] were
  /// written.
  [[nodiscard]] std::span<float> edit() { return {values_.data(), size_}; }
  void buildTree();
  void mendTree(std::size_t first, std::size_t last);

  /// The least value over the strips [first, last], both included and inside the field.
  [[nodiscard]] float min(std::size_t first, std::size_t last) const;
  /// No value over those strips is greater: the greatest over the blocks in which they lie, which is found sooner than theirs.
  [[nodiscard]] float greatestOfBlocks(std::size_t first, std::size_t last) const;

  /// The tree itself, for queries that descend: node 1 is the root, node n has children 2n and 2n+1, and the leaves
  /// are the blocks, the last one filled up with empty strips, and empty ones up to leafCount() (a power of two).
  [[nodiscard]] std::size_t leafCount() const { return leafCount_; }
  [[nodiscard]] float least(std::size_t node) const { return least_[node]; }
  [[nodiscard]] float greatest(std::size_t node) const { return greatest_[node]; }
  /// The least value of each block, as many as there are leaves. Three more floats after the last may be read.
  [[nodiscard]] std::span<const float> leastOfBlocks() const { return std::span(least_).subspan(leafCount_, leafCount_); }

private:
  std::size_t size_ = 0;
  std::size_t leafCount_ = 0;
  std::vector<float> values_;
  std::vector<float> least_;      ///< one a node
  std::vector<float> greatest_;
};

/// The model's silhouette as seen from the four viewport edges.
struct DistanceFields {
  int widthPx = 0;   ///< CSS pixels; number of columns
  int heightPx = 0;  ///< number of rows
  std::array<DistanceField, 4> fields;

  /// A viewport of that size (>= 1 each) with nothing in it. Fractional viewports are rounded up by the caller.
  void reset(int width, int height);
  void buildTrees();

  [[nodiscard]] DistanceField& operator[](ViewportEdge edge) { return fields[static_cast<std::size_t>(edge)]; }
  [[nodiscard]] const DistanceField& operator[](ViewportEdge edge) const {
    return fields[static_cast<std::size_t>(edge)];
  }

  /// The extent (px) that a field of this edge measures across: width for left and right, height for top and bottom.
  [[nodiscard]] double extentPx(ViewportEdge edge) const {
    return edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight ? widthPx : heightPx;
  }
};

/// The fields of the silhouette grown by `radiusPx` on all sides: a point clears a padded field exactly when it keeps
/// that distance from everything the field blocks. `padded` is reset and its trees are built; no allocation once it
/// has had this size.
void pad(const DistanceFields& fields, double radiusPx, DistanceFields& padded);

/// Pulls `fields` in by a segment or box on screen grown by `radiusPx`, and mends the trees. What lies outside the
/// viewport is ignored.
void pullIn(DistanceFields& fields, const Segment2& segment, double radiusPx);
void pullIn(DistanceFields& fields, const Box2& box, double radiusPx);

/// Whether a box on screen clears the silhouette: it lies inside the viewport, and between some viewport edge and
/// that edge's field.
bool clears(const DistanceFields& fields, const Box2& box);

/// Whether what a field sees from its viewport edge lies before a point of the viewport.
bool isBlocked(const DistanceFields& fields, ViewportEdge edge, const Vec2& p);

/// Whether a segment on screen lies in the viewport and between that edge and its field all along.
bool clears(const DistanceFields& fields, ViewportEdge edge, const Segment2& segment);

}  // namespace dimline
