#pragma once

#include "model/annotation.h"
#include "placement/layout.h"

namespace dimline {

/// What the scoring function looks at (paper 4.2).
struct ScoreInput {
  Segment2 base;                          ///< px
  Segment2 candidate;                     ///< px
  Align align = Align::kNone;
  bool sameAsLastFrame = false;
  PlaneKind planeKind = PlaneKind::kNone;
  Facing facing = Facing::kNone;
};

/// The paper's S = sum of lambda_i times its terms, in px; the greater, the better. Each term is what the paper says:
/// Dist, middle to middle; LenCandidate, on screen; SSAlign, the cosine between the extension lines' direction and the preferred one, 0 without a
/// preference; Damp, 1 for the last frame's choice; Plane, 0 for none and billboard, 0.5 facing away, 1 facing the viewer. The sixth, Intersect, is dear to
/// find out: Trial::amongOthers() adds it where the others leave a candidate in question.
double score(const ScoreInput& input);

/// The score of a base line that stands in for a candidate (algorithm 1, line 9): only length and alignment count, and the direction is that
/// from the scope's middle on screen to the base line's.
double scoreInside(const Segment2& base, const Vec2& scopeMiddle, Align align);

/// How far (px) a line has slid along itself from beside its base line: middle to middle, along its direction on screen. 0 where the extension lines are at right angles to it. Beyond the paper, see kScoreAskew.
double askewPx(const Segment2& base, const Segment2& line);

/// The preferred direction on screen, unit length; zero for none.
Vec2 direction(Align align);

}  // namespace dimline
