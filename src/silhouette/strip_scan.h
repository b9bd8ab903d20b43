#pragma once

#include "silhouette/distance_fields.h"

namespace dimline {

/// Writes segments on screen into four fields: each strip that a segment meets is pulled in to the segment's extreme
/// over the part inside the strip. The trees are left stale. Holds pointers into the fields, which must stay as large
/// as they are.
class StripScan {
public:
  explicit StripScan(DistanceFields& fields);

  [[nodiscard]] double widthPx() const { return widthPx_; }
  [[nodiscard]] double heightPx() const { return heightPx_; }

  /// Scans a segment that lies in the viewport.
  void scanInside(const Vec2& a, const Vec2& b);
  /// Scans the part of a segment that lies in the viewport.
  void scan(const Vec2& a, const Vec2& b);

  /// Whether nothing inside this box on screen could pull any field in: the box, as far as it lies in the viewport, is
  /// nowhere nearer to a viewport edge than what was scanned already.
  [[nodiscard]] bool knows(float left, float right, float top, float bottom) const;

private:
  double widthPx_;
  double heightPx_;
  float* left_;
  float* right_;
  float* top_;
  float* bottom_;
};

}  // namespace dimline
