#pragma once

#include <span>
#include <vector>

#include "model/annotation.h"
#include "placement/foresight.h"
#include "placement/frame_kind.h"
#include "placement/guides.h"
#include "placement/history.h"
#include "placement/layout.h"
#include "placement/slip_planes.h"
#include "placement/visibility.h"

namespace dimline {

/// A base line that can be used in this frame: of one scope, or of a chain.
struct UsableBaseLine {
  std::size_t scope = 0;          ///< index into Scene::scopes; of a chain, that of its first member that may carry a line
  std::int32_t scopeIndex = -1;   ///< among the scopes of that name; -1 for a chain
  std::int32_t cluster = -1;      ///< of a chain
  BaseLine line;
  Segment2 screen;
  double hiddenShare = 0;         ///< of a chain's members, those that may carry no line in this frame
};

/// A base line moved on a plane to outside the silhouette or onto a guide; or, as the fallback, a base line itself.
struct Candidate {
  Identity identity;
  std::size_t scope = 0;
  PlacementKind placement = PlacementKind::kInside;
  Segment base;
  Segment2 baseScreen;
  Segment foot;             ///< the base line on its plane: where it set out from, and where extension lines bend
  Segment2 footScreen;
  Segment line;
  Segment2 lineScreen;
  SlipPlane plane;          ///< kind kNone for the fallback
  Vec3 outward{0.0};        ///< unit direction in the world in which the line was moved; zero for the fallback
  double offsetM = 0;       ///< how far, from the foot
  double leastM = 0;        ///< how far it must be moved, outside the silhouette
  double mostM = 0;         ///< how far the plane has room
  double leastPx = 0;       ///< length on screen below which it is no place
  int guide = -1;           ///< number of the guide it lies on
  double score = 0;         ///< without the Intersect term
  bool passing = false;     ///< lost at the first look ahead (Foresight::Prospect)
  double hysteresis = 0;    ///< how much of it is the History's, which says nothing about the place itself
  /// Only the last frame's choice has two: where it would rather lie, and the least, in case its label has no room at the first.
  bool hasSecondOffset = false;
  bool secondOffset = false;
};

/// What became of a parameter's base lines, for the reason why it is hidden when none is left.
struct BaseLineTally {
  int occluded = 0;         ///< a scope that the model hides
  int outOfView = 0;        ///< an end nearer than the near plane, or nothing of it in the viewport
  int foreshortened = 0;    ///< points at the viewer
  int tooShort = 0;         ///< shorter on screen than the least length

  void add(const BaseLineTally& other);
};

/// Where a line does not go, since it looks for another place.
struct AvoidedPlace {
  Identity place{};    ///< of parameter -1: none
  Vec2 side{0.0};      ///< a unit vector on screen: it goes nowhere else on that side of its base line either; 0: it may

  [[nodiscard]] bool any() const { return place.parameter >= 0; }
  bool operator==(const AvoidedPlace&) const = default;
};

/// What the candidates of one parameter are made from and judged by in one frame.
struct CandidateContext {
  const Annotation& annotation;
  const View& view;
  const DistanceFields& padded;        ///< model and landed lines, with handleSpacing
  const DistanceFields& paddedModel;   ///< the model alone, with handleSpacing
  const Guides& guides;
  const ObjectPlanesInFrame& objectPlanes;
  bool viewMoved = false;              ///< since the last frame
  const History& history;              ///< the parameter's choices before, for the term Damp and hysteresis
  double toleranceM = 0;               ///< kSamePlaneDistance of the model's size
  std::vector<SlipPlane>& planes;      ///< memory for one base line's planes
  Foresight& foresight;
  double leastPx = 0;                  ///< length on screen of the shortest line that is shown
  const Identity* only = nullptr;      ///< the one candidate that is looked for; null: all are
  const AvoidedPlace* avoid = nullptr; ///< candidates that are left out
  bool lasting = false;                ///< while the camera comes nearer or goes away, new places that it takes away soon are left out
  bool showAll = false;                ///< a line that is shown for its last moments, or of a scope that nobody sees, is better than none
  std::span<const Sight> sights = {};  ///< one a scope: how much of it is seen
  Vec2 textSize{0.0};                  ///< px, of a line's label
  FrameKind kind = {};                 ///< where it rests, a place that is there already costs what a new one would; where lines settle, it counts what their extension lines come from and run over
};

/// The least length on screen at which a line of this annotation is shown.
double leastLengthPx(const Annotation& annotation);

/// Whether a choice was made for that base line, of a scope or of a chain.
bool sameBaseLine(const UsableBaseLine& base, const Identity& identity);

/// Whether the model is before a base line of a single scope: before half of an edge, or the scope itself before a line that its faces hide.
bool isBehindModel(const CandidateContext& context, const UsableBaseLine& base);

/// Adds the base lines of one scope that can be used: in front of the near plane, seen in the viewport, and neither foreshortened nor too short, by thresholds that are
/// `factor` times those of constants.h.
void gatherBaseLines(const Annotation& annotation, const Scope& scope, std::size_t scopeNumber, const View& view, double factor,
                     std::vector<UsableBaseLine>& lines, BaseLineTally& tally);

/// Adds the two chain base lines of a cluster, as far as they can be used, and any member can. A chain's own length says nothing about its members', so the least length is
/// left to them. `usable`: one a scope, whether it may carry a line in this frame.
void gatherChainBaseLines(const Cluster& cluster, std::int32_t number, const View& view, std::span<const char> usable, std::vector<UsableBaseLine>& lines);

/// Adds the candidates of a base line on the guides that lie on its planes and leave the model's padded silhouette clear (algorithm 1, lines 6 and 7).
/// Whether the stretch is free is for the caller to see. Beyond the paper: none is gone back to that was left within kReturnFrames.
void gatherGuideCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates);

/// Adds the candidates of a base line outside the silhouette, up to two a plane (paper 4.1): slid to the least offset that clears the padded fields,
/// within the viewport's margin and, beyond the paper, within reach of the base line (kMostReachShare). The last frame's choice may have a second offset besides (Candidate::secondOffset).
void gatherOutsideCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates);

/// Adds the candidates of a base line between two parts of the model (nearestGap), as between two trees: for a line that has no room outside all of it. None of a chain. Beyond the paper.
void gatherGapCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates);

/// Adds the last frame's choice (`only`) on the carrier of a line that is in the hand, whatever is there.
void gatherInHand(const CandidateContext& context, const UsableBaseLine& base, const Segment& inHand, std::vector<Candidate>& candidates);

/// Adds the base line itself (algorithm 1, line 9), unless its feature is in its last moments in the picture and not in plain view, or the line would be shown anew for a moment only.
void gatherInsideCandidate(const CandidateContext& context, const UsableBaseLine& base, const Obb& scope, bool plain, std::vector<Candidate>& candidates);

/// So many pixels as metres, at the depth of where a candidate set out from.
double metresAt(const Candidate& candidate, double px, const View& view);

/// Moves an outside candidate further out by `byPx` on screen, where its label has room or it runs across nothing. False when it would leave the
/// viewport, pass the near plane or leave its part of the plane, and for one on a guide, which it must not leave.
bool pushOutward(Candidate& candidate, double byPx, const View& view);
/// The same, to an offset in metres.
bool pushTo(Candidate& candidate, double offsetM, const View& view);

}  // namespace dimline
