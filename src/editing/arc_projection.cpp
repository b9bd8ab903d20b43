#include "editing/arc_projection.h"

#include <algorithm>

namespace dimline {

namespace {

/// Chords an arc is drawn with. On the largest arc (kArcMaxRadiusPx, half a turn) a chord is a tenth of a pixel off the curve.
constexpr int kArcPieces = 48;
/// Enough to measure an arc's length on screen.
constexpr int kMeasuredPieces = 8;

Vec2 onScreen(const Arc& arc, const View& view, double share) { return view.toScreen(arc.at(arc.angleRad * share)); }

Vec2 middleOf(const Arc& arc, const View& view) { return onScreen(arc, view, 0.5); }

}  // namespace

bool canProject(const Arc& arc, const View& view) {
  if (!view.inFrontOfNear(arc.center)) return false;
  for (int i = 0; i <= kArcPieces; ++i) {
    if (!view.inFrontOfNear(arc.at(arc.angleRad * i / kArcPieces))) return false;
  }
  return true;
}

bool arcOnScreen(const Arc& arc, const View& view, std::vector<Vec2>& points) {
  points.clear();
  if (!canProject(arc, view)) return false;
  for (int i = 0; i <= kArcPieces; ++i) points.push_back(onScreen(arc, view, static_cast<double>(i) / kArcPieces));
  return true;
}

Vec2 arcArrowMiddle(const Arc& arc, const View& view) {
  double lengthPx = 0;
  for (int i = 1; i <= kMeasuredPieces; ++i) {
    lengthPx += glm::length(onScreen(arc, view, static_cast<double>(i) / kMeasuredPieces) -
                            onScreen(arc, view, static_cast<double>(i - 1) / kMeasuredPieces));
  }
  const double back = lengthPx > 0 ? std::min(0.5 * kArrowLengthPx / lengthPx, 0.25) : 0.0;
  return onScreen(arc, view, 1.0 - back);
}

Vec2 arcLabelOffset(const PlacedHandle& handle, const View& view) { return handle.box.center() - middleOf(*handle.arc, view); }

void projectArcHandle(PlacedHandle& handle, const View& view, const Vec2& labelOffset) {
  const Vec2 half = (handle.box.max - handle.box.min) * 0.5;
  const Vec2 center = middleOf(*handle.arc, view) + labelOffset;
  handle.box = {center - half, center + half};
  for (Handle& end : handle.handles) end.screen = onScreen(*handle.arc, view, end.atEnd ? 1.0 : 0.0);
}

}  // namespace dimline
