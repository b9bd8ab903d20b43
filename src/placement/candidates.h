#pragma once

#include <vector>

#include "model/annotation.h"
#include "placement/layout.h"
#include "placement/slip_planes.h"

namespace dimline {

/// A base line moved on a plane to outside the silhouette; or, as the fallback, a base line itself.
struct Candidate {
  Identity identity;
  std::size_t scope = 0;    ///< index into Scene::scopes
  Segment base;
  Segment2 baseScreen;
  Segment line;
  Segment2 lineScreen;
  SlipPlane plane;          ///< kind kNone for the fallback
  Vec3 outward{0.0};        ///< unit direction in the world in which the line was moved; zero for the fallback
  double score = 0;         ///< without the Intersect term
};

/// A base line that can be used in this frame.
struct UsableBaseLine {
  std::size_t scope = 0;
  std::int32_t scopeIndex = 0;
  BaseLine line;
  Segment2 screen;
};

/// What became of a parameter's base lines, for the reason why it is hidden when none is left.
struct BaseLineTally {
  int outOfView = 0;        ///< an end nearer than the near plane, or nothing of it in the viewport
  int foreshortened = 0;    ///< points at the viewer
  int tooShort = 0;         ///< shorter on screen than the least length
};

/// Adds the base lines of one scope that can be used: in front of the near plane, seen in the viewport, not foreshortened, long enough.
void gatherBaseLines(const Annotation& annotation, const Scope& scope, std::size_t scopeNumber, const View& view,
                     std::vector<UsableBaseLine>& lines, BaseLineTally& tally);

/// Adds the candidates of a base line outside the silhouette, up to two a plane (paper 4.1): slid to the least offset that clears `padded`, within the
/// viewport's margin. `lastFrame`: the parameter's choice then, for the term Damp.
void gatherOutsideCandidates(const Annotation& annotation, const UsableBaseLine& base, const View& view,
                             const DistanceFields& padded, const Identity& lastFrame, std::vector<Candidate>& candidates);

/// Adds the base line itself (algorithm 1, line 9).
void gatherInsideCandidate(const Annotation& annotation, const UsableBaseLine& base, const Obb& scope, const View& view,
                           std::int32_t parameter, std::vector<Candidate>& candidates);

/// Moves an outside candidate further out by `byPx` on screen, for a label that has no room at the least offset. False when it would leave the
/// viewport or pass the near plane.
bool pushOutward(Candidate& candidate, double byPx, const View& view);

}  // namespace dimline
