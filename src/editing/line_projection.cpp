#include "editing/line_projection.h"

#include <span>

namespace dimline {

namespace {

Vec2 anchorPoint(LabelAnchor::To to, const Segment2& line) {
  switch (to) {
    case LabelAnchor::To::kStart:
      return line.start;
    case LabelAnchor::To::kMiddle:
      return line.middle();
    case LabelAnchor::To::kEnd:
      return line.end;
  }
  return line.middle();
}

/// New ends for a polyline; the points between shift with the end they are nearer to, counted in points.
void moveEnds(std::span<Vec2> polyline, const Vec2& first, const Vec2& last) {
  if (polyline.size() < 2) return;
  const Vec2 shiftFirst = first - polyline.front();
  const Vec2 shiftLast = last - polyline.back();
  for (std::size_t i = 1; i + 1 < polyline.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(polyline.size() - 1);
    polyline[i] += shiftFirst * (1.0 - share) + shiftLast * share;
  }
  polyline.front() = first;
  polyline.back() = last;
}

}  // namespace

std::optional<LabelAnchor> labelAnchor(const PlacedLine& line) {
  if (!line.label) return std::nullopt;
  const Vec2 center = line.label->center();
  LabelAnchor nearest;
  double nearestPx = std::numeric_limits<double>::infinity();
  for (const auto to : {LabelAnchor::To::kMiddle, LabelAnchor::To::kStart, LabelAnchor::To::kEnd}) {
    const Vec2 offset = center - anchorPoint(to, line.lineScreen);
    if (const double distancePx = glm::length(offset); distancePx < nearestPx) {
      nearestPx = distancePx;
      nearest = {to, offset, line.label->max - line.label->min};
    }
  }
  return nearest;
}

Vec2 labelCenter(const LabelAnchor& anchor, const Segment2& lineScreen) {
  return anchorPoint(anchor.to, lineScreen) + anchor.offset;
}

bool canProject(const PlacedLine& line, const View& view) {
  for (const Vec3& p : {line.base.start, line.base.end, line.line.start, line.line.end}) {
    if (!view.inFrontOfNear(p)) return false;
  }
  return true;
}

void projectLine(PlacedLine& line, const View& view, const std::optional<LabelAnchor>& anchor) {
  line.baseScreen = view.toScreen(line.base);
  line.lineScreen = view.toScreen(line.line);
  moveEnds(line.extensionStart, line.baseScreen.start, line.lineScreen.start);
  moveEnds(line.extensionEnd, line.baseScreen.end, line.lineScreen.end);
  for (Handle& handle : line.handles) handle.screen = handle.atEnd ? line.lineScreen.end : line.lineScreen.start;
  line.label.reset();
  if (anchor) {
    const Vec2 center = labelCenter(*anchor, line.lineScreen);
    line.label = Box2{center - anchor->size * 0.5, center + anchor->size * 0.5};
  }
}

}  // namespace dimline
