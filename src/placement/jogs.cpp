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

std::optional<Vec2> jogPast(const Segment2& line, const Segment2& lastPart, const Landed& landed) {
  const auto jog = jogPastEnd(line, lastPart);
  if (!jog) return std::nullopt;
  const auto isClear = [&](const Segment2& part) { return !landed.crossesLine(part) && (!landed.coversLabel(part) || landed.coversLabel(lastPart)); };
  if (!isClear({lastPart.start, *jog}) || !isClear({*jog, lastPart.end})) return std::nullopt;
  // Where another line begins at this one's end, as in a row, the jog lies on that, and crosses neither.
  const Vec2 onward = glm::normalize(line.end - line.start) * (glm::length(line.start - *jog) < glm::length(line.end - *jog) ? -1.0 : 1.0);
  const Vec2 beyond = *jog + onward * kSameLinePx;
  return landed.comesWithin(kSameLinePx, {beyond, beyond}) ? std::nullopt : jog;
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
