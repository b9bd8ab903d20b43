#include "editing/handle_hit.h"

#include "editing/arc_projection.h"

namespace dimline {

Vec2 arrowMiddle(const Segment2& lineScreen, const Handle& handle) {
  const Vec2 inward = (handle.atEnd ? lineScreen.start : lineScreen.end) - handle.screen;
  const double length = glm::length(inward);
  if (!(length > 0)) return handle.screen;
  return handle.screen + inward * (std::min(0.5 * kArrowLengthPx, 0.25 * length) / length);
}

std::optional<HandleRef> hitHandle(std::span<const PlacedLine> lines, const Vec2& screen, double radiusPx) {
  std::optional<HandleRef> nearest;
  double nearestPx = radiusPx;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < lines[i].handles.size(); ++j) {
      const double distancePx = glm::length(arrowMiddle(lines[i].lineScreen, lines[i].handles[j]) - screen);
      // A distance that is not a number compares false.
      if (distancePx < nearestPx || (!nearest && distancePx <= nearestPx)) {
        nearest = HandleRef{i, j};
        nearestPx = distancePx;
      }
    }
  }
  return nearest;
}

std::optional<std::size_t> hitLine(std::span<const PlacedLine> lines, const Vec2& screen, double radiusPx) {
  std::optional<std::size_t> nearest;
  double nearestPx = radiusPx;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].label && lines[i].label->contains(screen)) return i;
    const double distancePx = distanceBetween(screen, lines[i].lineScreen);
    if (distancePx < nearestPx) {
      nearest = i;
      nearestPx = distancePx;
    }
  }
  return nearest;
}

std::optional<std::size_t> hitArc(std::span<const PlacedHandle> handles, const View& view, const Vec2& screen, double radiusPx) {
  std::optional<std::size_t> nearest;
  double nearestPx = radiusPx;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (!handles[i].arc || handles[i].handles.empty() || !canProject(*handles[i].arc, view)) continue;
    const double distancePx = glm::length(arcArrowMiddle(*handles[i].arc, view) - screen);
    if (distancePx < nearestPx) {
      nearest = i;
      nearestPx = distancePx;
    }
  }
  return nearest;
}

}  // namespace dimline
