#include "placement/candidates.h"

#include <algorithm>
#include <cmath>

#include "placement/score.h"
#include "silhouette/slide.h"

namespace dimline {

namespace {

bool insideViewport(const Segment2& s, const View& view) {
  const Box2 box = view.viewport().grown(-kViewportMarginPx);
  for (const Vec2& p : {s.start, s.end}) {
    // Written so that a NaN is outside.
    if (!(p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y)) return false;
  }
  return true;
}

double leastLengthPx(const Annotation& annotation) { return std::max(kMinLineLengthPx, annotation.minLengthPx); }

/// Puts the candidate's line at `line`; false when it is no place for a dimension line.
bool moveTo(Candidate& candidate, const Segment& line, const View& view) {
  if (!view.inFrontOfNear(line.start) || !view.inFrontOfNear(line.end)) return false;
  const Segment2 screen = view.toScreen(line);
  if (!insideViewport(screen, view)) return false;
  candidate.line = line;
  candidate.lineScreen = screen;
  return true;
}

}  // namespace

void gatherBaseLines(const Annotation& annotation, const Scope& scope, std::size_t scopeNumber, const View& view,
                     std::vector<UsableBaseLine>& lines, BaseLineTally& tally) {
  for (const BaseLine& line : baseLines(annotation, scope.box, view)) {
    const Segment& s = line.segment;
    if (!view.inFrontOfNear(s.start) || !view.inFrontOfNear(s.end)) {
      ++tally.outOfView;
      continue;
    }
    const Segment2 screen = view.toScreen(s);
    if (!meets(screen, view.viewport())) {
      ++tally.outOfView;
      continue;
    }
    const double lengthM = s.length();
    const double alongView = std::abs(glm::dot(s.end - s.start, view.directionTo(s.middle())));
    if (lengthM > 0 && alongView > std::cos(kForeshortenedAngleRad) * lengthM) {
      ++tally.foreshortened;
      continue;
    }
    if (!(screen.length() >= leastLengthPx(annotation))) {
      ++tally.tooShort;
      continue;
    }
    lines.push_back({scopeNumber, static_cast<std::int32_t>(scope.index), line, screen});
  }
}

void gatherOutsideCandidates(const Annotation& annotation, const UsableBaseLine& base, const View& view,
                             const DistanceFields& padded, const Identity& lastFrame, std::vector<Candidate>& candidates) {
  for (const SlipPlane& plane : slipPlanes(base.line, annotation.slip, view)) {
    for (const int direction : {1, -1}) {
      const Vec3 outward = plane.across * static_cast<double>(direction);
      const auto slide = Slide::make(view, base.line.segment, outward);
      if (!slide) continue;
      const double offsetM = leastClearingOffset(padded, *slide);
      if (!std::isfinite(offsetM)) continue;

      Candidate candidate;
      candidate.identity = {.parameter = lastFrame.parameter,
                            .scopeIndex = base.scopeIndex,
                            .baseLine = static_cast<std::int16_t>(base.line.number),
                            .plane = static_cast<std::int8_t>(plane.number),
                            .direction = static_cast<std::int8_t>(direction)};
      candidate.scope = base.scope;
      candidate.base = base.line.segment;
      candidate.baseScreen = base.screen;
      candidate.plane = plane;
      candidate.outward = outward;
      if (!moveTo(candidate, slide->at(offsetM), view)) continue;
      if (candidate.lineScreen.length() < leastLengthPx(annotation)) continue;
      candidate.score = score({.base = candidate.baseScreen,
                               .candidate = candidate.lineScreen,
                               .align = annotation.align,
                               .sameAsLastFrame = candidate.identity == lastFrame,
                               .intersects = false,
                               .planeKind = plane.kind,
                               .facing = plane.facing});
      candidates.push_back(candidate);
    }
  }
}

void gatherInsideCandidate(const Annotation& annotation, const UsableBaseLine& base, const Obb& scope, const View& view,
                           std::int32_t parameter, std::vector<Candidate>& candidates) {
  Candidate candidate;
  candidate.identity = {.parameter = parameter,
                        .scopeIndex = base.scopeIndex,
                        .baseLine = static_cast<std::int16_t>(base.line.number),
                        .plane = -1,
                        .direction = 0};
  candidate.scope = base.scope;
  candidate.base = candidate.line = base.line.segment;
  candidate.baseScreen = candidate.lineScreen = base.screen;
  const Vec3 middle = scope.center();
  // A scope whose middle is behind the viewer has no direction on screen; then length alone decides.
  const Vec2 middleScreen = view.inFrontOfNear(middle) ? view.toScreen(middle) : base.screen.middle();
  candidate.score = scoreInside(base.screen, middleScreen, annotation.align);
  candidates.push_back(candidate);
}

bool pushOutward(Candidate& candidate, double byPx, const View& view) {
  const Vec3 middle = candidate.line.middle();
  // One pixel's worth of world at that depth, tried along the plane: its length on screen turns pixels into metres.
  const double probeM = view.metresPerPixelAt(middle);
  const Vec3 probe = middle + candidate.outward * probeM;
  if (!view.inFrontOfNear(probe)) return false;
  const double probePx = glm::length(view.toScreen(probe) - view.toScreen(middle));
  if (!(probePx > 1e-3)) return false;
  const Vec3 move = candidate.outward * (probeM * byPx / probePx);
  return moveTo(candidate, {candidate.line.start + move, candidate.line.end + move}, view);
}

}  // namespace dimline
