#pragma once

#include <optional>

#include "editing/drag_marks.h"
#include "editing/snap.h"
#include "model/model.h"
#include "placement/layout.h"

namespace dimline {

/// One drag of an angular handle's end about its centre: where the pointer is -> which angle. As HandleDrag, everything is computed from the start of the
/// drag, and the handle keeps its distance to the pointer; the arc stays where it was in the world, only its moving end turns.
class ArcDrag {
public:
  /// Takes hold of `handle`, as drawn in `view`, with the pointer at `pointer` (px). `model` must outlive the drag. Nothing when the handle has no arc, or its
  /// plane is seen so nearly edge-on that a movement on screen says nothing about an angle.
  static std::optional<ArcDrag> begin(const Model& model, const Values& values, const PlacedHandle& handle, const Vec2& pointer, const View& view);

  [[nodiscard]] std::size_t parameter() const { return handle_.parameter; }
  [[nodiscard]] const Values& startValues() const { return startValues_; }

  /// The angle (degrees) whose leg points from the centre to the pointer on screen; of those that `snap` allows, in the range. The value of the start when the pointer is
  /// where it was then, and the last value when it is on the centre or not a number. The camera must be the one of begin(); the viewport may have changed.
  double valueAt(const Vec2& pointer, const View& view, Snap snap = Snap::kStep);

  /// As HandleDrag::regrip().
  void regrip(const PlacedHandle& now, const Vec2& pointer, const View& view) { grabOffset_ = pointer - view.toScreen(now.arc->at(now.arc->angleRad)); }

  /// As HandleDrag::addMarks().
  void addMarks(double value, const View& view, Snap snap, std::vector<DragMark>& marks) const;

  /// The dragged handle for other values. Nothing when `view` cannot show it.
  [[nodiscard]] std::optional<PlacedHandle> handleOn(const Values& values, const View& view) const;

private:
  ArcDrag(const Model& model, const Values& values, const PlacedHandle& handle, const Vec2& grabOffset, const Vec2& labelOffset);
  [[nodiscard]] std::optional<double> angleRadAt(const Vec2& screen, const View& view) const;

  const Model* model_;
  Values startValues_;
  PlacedHandle handle_;
  Vec2 grabOffset_;   ///< px, from the handle to the pointer
  Vec2 labelOffset_;  ///< px, as arcLabelOffset() has it
  double lastValue_;
};

}  // namespace dimline
