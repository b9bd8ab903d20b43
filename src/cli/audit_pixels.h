#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "silhouette/coverage_mask.h"

namespace dimline {

/// What the audit knows of the model in one picture: which pixels it covers, and how far from them a point is. Made
/// from a mask alone; shares nothing with the distance fields.
///
/// Distances are to the nearest covered pixel's centre, less half a pixel. A mask says nothing of where between two
/// centres the model's border runs; so measured, a point that truly keeps 30 px is never given less than 29.5.
class MaskPicture {
public:
  /// Takes a mask and measures the distance of every pixel (exact Euclidean, in two passes). Keeps its memory from mask
  /// to mask.
  void read(CoverageMask mask);

  [[nodiscard]] int widthPx() const { return mask_.widthPx; }
  [[nodiscard]] int heightPx() const { return mask_.heightPx; }

  /// px, exact; 0 on the model, infinite when the mask is empty. Only covered pixels inside the picture count.
  [[nodiscard]] double distancePx(const Segment2& segment) const;

  /// Whether all of a segment lies in the picture and at least so far (px) from the model. Walks along the segment in
  /// steps of a pixel or more, between the pixels' distances interpolated: it finds a segment at most 0.3 px farther
  /// than distancePx(), and at most half a pixel nearer (midway between two parts of the model).
  [[nodiscard]] bool keepsDistance(const Segment2& segment, double leastPx) const;

  /// Whether a segment passes through a pixel of the eroded mask: one that is covered, and all its neighbours in the
  /// picture too. Touching the model's border is no crossing.
  [[nodiscard]] bool crosses(const Segment2& segment) const;

  /// Whether a covered pixel's centre lies in the box.
  [[nodiscard]] bool touches(const Box2& box) const;

  /// Whether a point lies in the picture, off the model, and can leave the picture without meeting the model: not in a
  /// hole of it.
  [[nodiscard]] bool outside(const Vec2& p);

  /// Whether a segment can be seen whole from one edge of the viewport, looking at right angles to it: what a 1-D
  /// distance field can know of.
  [[nodiscard]] bool seesAnEdge(const Segment2& segment) const;

private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask_.widthPx) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool deep(int x, int y) const;
  [[nodiscard]] double interpolatedPx(const Vec2& p) const;
  void findBorder();
  void measureColumns();
  void measureRow(int y);
  void findOutside();
  std::uint32_t rootOf(std::uint32_t run);

  CoverageMask mask_;
  std::vector<glm::vec2> border_;  ///< centres of covered pixels with an uncovered neighbour beside, above or below
  std::vector<float> distance_;    ///< px from a pixel's centre to the nearest covered pixel's centre
  /// Uncovered pixels of a row that lie side by side, from x to before xEnd. Runs that hang together, or reach the
  /// picture's border, point in the end to the same one. Made when first asked for.
  struct Run {
    int x, xEnd;
    std::uint32_t parent;
  };
  std::vector<Run> runs_;               ///< the first one stands for all that is outside
  std::vector<std::uint32_t> rowRuns_;  ///< where in runs_ each row's begin, and the end
  bool outsideKnown_ = false;
  // One row's lower envelope of parabolas.
  std::vector<int> site_;
  std::vector<double> from_;
  std::vector<double> squared_;
};

}  // namespace dimline
