#pragma once

#include <vector>

#include "placement/layout.h"

namespace dimline {

/// What has been placed so far in this frame, as it lies on screen: the exact side of what the fields know by strips. Answers the score's Intersect term
/// and whether a label has room.
class Landed {
 public:
  void clear();
  void add(const PlacedLine& line);

  /// Whether a line or one of its extension lines (straight, from base to final line) crosses a line, an extension line or a label that has landed
  /// (paper 4.2, Intersect).
  [[nodiscard]] bool crosses(const Segment2& base, const Segment2& line) const;

  /// Whether a label's box keeps kLabelClearancePx from every line, extension line and label that has landed.
  [[nodiscard]] bool hasRoom(const Box2& label) const;

 private:
  std::vector<Segment2> segments_;   ///< lines and extension lines
  std::vector<Box2> labels_;
};

}  // namespace dimline
