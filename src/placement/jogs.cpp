#include "placement/jogs.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace dimline {

std::optional<Vec2> jogPastEnd(const Segment2& line, const Segment2& lastPart) {
  const double length = lastPart.length();
  if (!(length > 0)) return std::nullopt;
  const Vec2 along = (lastPart.end - lastPart.start) / length;
  const Vec2 across(-along.y, along.x);
  const double startPx = glm::dot(line.start - lastPart.start, across);
  const double endPx = glm::dot(line.end - lastPart.start, across);
  const bool byItsStart = std::abs(startPx) < std::abs(endPx);
  const double overPx = byItsStart ? startPx : endPx;
  const double alongPx = glm::dot((byItsStart ? line.start : line.end) - lastPart.start, along);
  const double jogPx = overPx * (1 + kJogBeyondShare);
  const bool tooSteep = std::abs(jogPx) > kMostJogSlope * std::min(alongPx, length - alongPx);
  if (std::abs(overPx) > kMostJoggedPx || tooSteep) return std::nullopt;
  return lastPart.start + along * alongPx + across * jogPx;
}

bool bendsAtPlane(const PlacedLine& line) { return line.foot.start != line.base.start || line.foot.end != line.base.end; }

void straighten(PlacedLine& line) {
  const std::size_t straight = bendsAtPlane(line) ? 3 : 2;
  for (ExtensionLine* extension : {&line.extensionStart, &line.extensionEnd}) {
    if (extension->size() <= straight) continue;
    (*extension)[straight - 1] = extension->back();
    extension->resize(straight);
  }
}

}  // namespace dimline
