#include "placement/score.h"

#include <cmath>

#include "math/geometry.h"

namespace dimline {

namespace {

/// Cosine between an offset on screen and the preferred direction; 0 when either has none.
double alignTerm(const Vec2& offset, Align align) { return glm::dot(unitOrZero(offset), direction(align)); }

double planeTerm(PlaneKind kind, Facing facing) {
  if (kind == PlaneKind::kNone || kind == PlaneKind::kBillboard) return 0.0;
  return facing == Facing::kFront ? 1.0 : 0.5;
}

}  // namespace

Vec2 direction(Align align) {
  constexpr double kDiagonal = 0.70710678118654752;
  switch (align) {
    case Align::kNone: return {0, 0};
    case Align::kTop: return {0, -1};
    case Align::kBottom: return {0, 1};
    case Align::kLeft: return {-1, 0};
    case Align::kRight: return {1, 0};
    case Align::kTopLeft: return {-kDiagonal, -kDiagonal};
    case Align::kTopRight: return {kDiagonal, -kDiagonal};
    case Align::kBottomLeft: return {-kDiagonal, kDiagonal};
    case Align::kBottomRight: return {kDiagonal, kDiagonal};
  }
  return {0, 0};
}

double score(const ScoreInput& in) {
  const Vec2 offset = in.candidate.middle() - in.base.middle();
  return kScoreDistance * glm::length(offset) + kScoreLength * in.candidate.length() +
         kScoreAlign * alignTerm(offset, in.align) + kScoreDamp * (in.sameAsLastFrame ? 1.0 : 0.0) +
         kScorePlane * planeTerm(in.planeKind, in.facing);
}

double scoreInside(const Segment2& base, const Vec2& scopeMiddle, Align align) {
  return kScoreLength * base.length() + kScoreAlign * alignTerm(base.middle() - scopeMiddle, align);
}

double askewPx(const Segment2& base, const Segment2& line) {
  const double length = line.length();
  return length > 0 ? std::abs(glm::dot(line.middle() - base.middle(), line.end - line.start)) / length : 0.0;
}

}  // namespace dimline
