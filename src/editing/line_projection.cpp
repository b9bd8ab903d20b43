#include "editing/line_projection.h"

#include <limits>
#include <utility>

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

/// Shifts an extension line's ends as those of base line and line were shifted, so that one that was moved aside stays beside them; bends go half with each.
void shiftEnds(ExtensionLine& extension, const Vec2& first, const Vec2& last) {
  if (extension.empty()) return;
  for (std::size_t i = 1; i + 1 < extension.size(); ++i) extension[i] += 0.5 * (first + last);
  extension.front() += first;
  extension.back() += last;
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
  const Segment2 base = std::exchange(line.baseScreen, view.toScreen(line.base));
  const Segment2 before = std::exchange(line.lineScreen, view.toScreen(line.line));
  shiftEnds(line.extensionStart, line.baseScreen.start - base.start, line.lineScreen.start - before.start);
  shiftEnds(line.extensionEnd, line.baseScreen.end - base.end, line.lineScreen.end - before.end);
  for (Handle& handle : line.handles) handle.screen = handle.atEnd ? line.lineScreen.end : line.lineScreen.start;
  line.label.reset();
  if (anchor) {
    const Vec2 center = labelCenter(*anchor, line.lineScreen);
    line.label = Box2{center - anchor->size * 0.5, center + anchor->size * 0.5};
  }
}

}  // namespace dimline
