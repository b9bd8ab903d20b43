#include "placement/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "placement/on_screen.h"
#include "placement/score.h"
#include "silhouette/gap.h"
#include "silhouette/slide.h"

namespace dimline {

namespace {

/// A guide's offset may miss the least clearing one, and a line at the greatest offset the viewport's margin, by rounding alone.
constexpr double kRoundingShare = 1e-9;

/// Puts the candidate's line at `line`; false when it is no place for a dimension line.
bool moveTo(Candidate& candidate, const Segment& line, const View& view) {
  const auto screen = onScreen(line, view);
  if (!screen || screen->length() < candidate.leastPx) return false;
  candidate.line = line;
  candidate.lineScreen = *screen;
  return true;
}

/// No base line of a scope looks longer than this: of many small things it tells at once that they have none.
double mostLengthPx(const Annotation& annotation, const Obb& scope, const View& view) {
  const AxisSense along = axisOf(annotation.orient);
  const double diagonalM = glm::length(scope.size);
  const double mostM = isLinear(annotation.type) && along.axis >= 0 ? scope.size[along.axis] : diagonalM;
  return mostM * view.mostPixelsPerMetre(scope.at(Vec3(0.5) + annotation.translate), 0.5 * diagonalM);
}

/// `cosLeast`: of the least angle to the view direction.
bool foreshortened(const Segment& s, const View& view, double cosLeast) {
  const double lengthM = s.length();
  const double alongView = std::abs(glm::dot(s.end - s.start, view.directionTo(s.middle())));
  return lengthM > 0 && alongView > cosLeast * lengthM;
}

/// The greatest offset at which the candidate's line lies no further than kMostDepthRatio times as far from the viewer as its base line; only perspective draws what is further away smaller.
double mostInProportionM(const Candidate& candidate, const View& view) {
  const double perM = glm::dot(candidate.outward, view.forward());
  if (view.camera().orthoHeightM || perM <= 0) return std::numeric_limits<double>::infinity();
  return (kMostDepthRatio * view.depth(candidate.base.middle()) - view.depth(candidate.foot.middle())) / perM;
}

/// A candidate of `base` on `plane`, not placed yet.
Candidate unplaced(const UsableBaseLine& base, const SlipPlane& plane, int direction, const CandidateContext& context) {
  Candidate candidate;
  candidate.identity = {.parameter = context.history.last().parameter,
                        .scopeIndex = base.scopeIndex,
                        .chain = base.cluster,
                        .baseLine = static_cast<std::int16_t>(base.line.number),
                        .plane = static_cast<std::int16_t>(plane.number),
                        .direction = static_cast<std::int8_t>(direction)};
  candidate.scope = base.scope;
  candidate.base = base.line.segment;
  candidate.baseScreen = base.screen;
  candidate.foot = {base.line.segment.start + plane.onto, base.line.segment.end + plane.onto};
  candidate.plane = plane;
  candidate.outward = plane.across * static_cast<double>(direction);
  candidate.mostM = std::min(direction > 0 ? plane.highM : -plane.lowM, mostInProportionM(candidate, context.view));
  candidate.leastPx = candidate.identity == context.history.last() ? context.leastPx / kShowAgainFactor : context.leastPx;
  return candidate;
}

/// How far (px) along either side of the viewport a line may lie from its base line: see kMostReachShare.
double mostReachPx(const CandidateContext& context, const Candidate& candidate) {
  const double diagonalPx = std::hypot(context.view.widthPx(), context.view.heightPx());
  return std::max(diagonalPx * (candidate.identity == context.history.last() ? kMostReachShareToStay : kMostReachShare), kLeastReachPx);
}

/// The offsets at which both ends lie in front of the near plane, within the viewport's margin, and within reach of the base line's ends; from 0 on, along the candidate's direction. Each side of a box on screen bounds
/// the offset by a linear inequality, since homogeneous pixels are linear in the world. From below it bounds a line that comes into the picture further out, where its base line is partly out of it; not in a zoom,
/// where such a line would be at the picture's edge and slide along it in leaps.
OffsetRange offsetsInView(const CandidateContext& context, const Candidate& candidate) {
  const View& view = context.view;
  const Box2 inside = view.viewport().grown(-kViewportMarginPx);
  const double reachPx = mostReachPx(context, candidate);
  const Vec3 perMetre = view.worldToPixels() * Vec4(candidate.outward, 0.0);
  OffsetRange range{0, candidate.mostM};
  const auto bound = [&](double atFoot, double perM) {
    if (perM < 0) range.highM = std::min(range.highM, atFoot / -perM);
    if (perM > 0 && !context.foresight.zooms()) range.lowM = std::max(range.lowM, -atFoot / perM);
    if (perM == 0 && atFoot < 0) range.highM = -1;
  };
  const auto boundEnd = [&](const Vec3& foot, const Vec2& base) {
    const Vec3 h = view.worldToPixels() * Vec4(foot, 1.0);
    const Vec2 low = glm::max(inside.min, base - reachPx), high = glm::min(inside.max, base + reachPx);
    if (low.x > high.x || low.y > high.y) range.highM = -1;
    for (int axis = 0; axis < 2; ++axis) {
      bound(h[axis] - low[axis] * h.z, perMetre[axis] - low[axis] * perMetre.z);
      bound(high[axis] * h.z - h[axis], high[axis] * perMetre.z - perMetre[axis]);
    }
    bound(view.depth(foot) - view.nearM(), glm::dot(candidate.outward, view.forward()));
  };
  boundEnd(candidate.foot.start, candidate.baseScreen.start);
  boundEnd(candidate.foot.end, candidate.baseScreen.end);
  return {range.lowM * (1 + kRoundingShare), range.highM * (1 - kRoundingShare)};
}

/// The least offset in the candidate's direction at which its plane has room.
double leastRoomM(const Candidate& candidate) {
  return candidate.identity.direction > 0 ? candidate.plane.lowM : -candidate.plane.highM;
}

/// Puts the candidate at an offset from its foot; false when that is no place.
bool placeAt(Candidate& candidate, const Slide& slide, double offsetM, const View& view) {
  if (!(offsetM <= candidate.mostM) || !moveTo(candidate, slide.at(offsetM), view)) return false;
  candidate.offsetM = offsetM;
  candidate.footScreen = view.toScreen(candidate.foot);
  return true;
}

/// Whether a scope is going out of sight.
bool isFading(const CandidateContext& context, std::size_t scope) {
  return context.annotation.occlusion && !context.showAll && !context.sights[scope].seenEnough();
}

/// Whether a line would be begun on a scope that is going out of sight, or go over to it from another.
bool isBegunOnFading(const CandidateContext& context, const UsableBaseLine& base) {
  return base.cluster < 0 && base.scopeIndex != context.history.last().scopeIndex && isFading(context, base.scope);
}

/// Whether a line that is not shown would be for a few frames only, before what it measures is out of the picture or too short again.
bool isShownAnewInVain(const CandidateContext& context, const Foresight::Prospect& prospect) {
  return prospect.goneSoon && context.history.shownAnew() && !context.showAll;
}

/// How far (px) the candidate's extension lines run over the model, about: from the base line to where the model alone would let it lie.
double overModelPx(const CandidateContext& context, const Candidate& candidate, const Slide& slide) {
  const double clearM = std::min(leastClearingOffset(context.paddedModel, slide, candidate.offsetM), candidate.offsetM);
  const Segment clear = slide.at(clearM);
  if (!context.view.inFrontOfNear(clear)) return 0;
  return std::max(glm::length(context.view.toScreen(clear).middle() - candidate.baseScreen.middle()) - kHandleSpacingPx, 0.0);
}

/// Scores the placed candidate and keeps it.
void keep(const CandidateContext& context, const UsableBaseLine& base, Candidate& candidate, const Slide& slide, std::vector<Candidate>& candidates) {
  // Before a still camera it is the place itself that is looked for: the same identity may have others, on guides.
  if (context.only != nullptr && !context.viewMoved && !context.history.stays(candidate.identity, away(candidate.baseScreen, candidate.lineScreen))) return;
  candidate.hysteresis = context.history.bonus(candidate.identity, away(candidate.baseScreen, candidate.lineScreen));
  candidate.score = score({.base = candidate.baseScreen,
                           .candidate = candidate.lineScreen,
                           .align = context.annotation.align,
                           .sameAsLastFrame = candidate.identity == context.history.last(),
                           .planeKind = candidate.plane.kind,
                           .facing = candidate.plane.facing}) +
                    kScoreAskew * askewPx(candidate.baseScreen, candidate.lineScreen) + candidate.hysteresis;
  if (context.kind.settles) {
    const double bentPx = glm::length(candidate.footScreen.middle() - candidate.baseScreen.middle());
    candidate.score += kScoreOverModel * overModelPx(context, candidate, slide) + kScoreHiddenMembers * base.hiddenShare + kScoreBent * bentPx;
  }
  const Identity& identity = candidate.identity;
  if (context.kind.rests() || identity != context.history.last()) {
    if (isBegunOnFading(context, base)) return;
    const bool chain = base.cluster >= 0;
    const Foresight::Prospect prospect =
        context.foresight.prospect({base.line, context.annotation.slip, candidate.plane, identity.direction, candidate.offsetM, candidate.line,
                                    chain ? 0.0 : context.leastPx, chain ? Vec2(0.0) : context.textSize});
    // No place is begun for its last moments, and a line inside the model does not come out for a moment.
    const bool tooBrief = prospect.lastMoments || (prospect.outInVain && context.history.wasInside()) || (prospect.brief && context.lasting && context.foresight.zooms());
    if (isShownAnewInVain(context, prospect) || tooBrief) return;
    candidate.passing = prospect.passing;
    candidate.score += prospect.price;
    if (!chain && isFading(context, candidate.scope)) candidate.score += kScoreFadingScope;
    if (!chain && isBehindModel(context, base)) candidate.score += kScoreFromBehindModel;
  }
  candidates.push_back(candidate);
}

/// Keeps the candidate outside at the least offset at which it may lie or, when it is the last frame's choice, where it was as well.
void keepOutside(const CandidateContext& context, const UsableBaseLine& base, Candidate& candidate, const Slide& slide, double leastM, std::vector<Candidate>& candidates) {
  candidate.placement = PlacementKind::kOutside;
  candidate.leastM = leastM;
  if (candidate.identity == context.history.last()) {
    const double stepM = context.viewMoved ? metresAt(candidate, kRelaxPx, context.view) : 0.0;
    const double relaxedM = std::min(context.history.relaxedOffsetM(leastM, stepM), candidate.mostM);
    if (relaxedM > leastM && placeAt(candidate, slide, relaxedM, context.view)) {
      candidate.hasSecondOffset = true;
      keep(context, base, candidate, slide, candidates);
      candidate.hasSecondOffset = false;
      candidate.secondOffset = true;
    }
  }
  if (placeAt(candidate, slide, leastM, context.view)) keep(context, base, candidate, slide, candidates);
}

/// The way on screen of what moves in the world; nothing when part of it is not in front of the near plane.
std::optional<Vec2> wayOnScreen(const Vec3& from, const Vec3& move, const View& view) {
  const Segment way{from, from + move};
  if (!view.inFrontOfNear(way)) return std::nullopt;
  const Segment2 screen = view.toScreen(way);
  return screen.end - screen.start;
}

/// Whether a line that looks for another place would still be where it was, or beside that.
bool isAvoided(const AvoidedPlace& avoided, const Candidate& candidate, const View& view) {
  if (candidate.identity == avoided.place) return true;
  if (avoided.side == Vec2(0.0)) return false;
  const auto way = wayOnScreen(candidate.foot.middle(), candidate.outward * metresAt(candidate, 1, view), view);
  return way && glm::dot(*way, avoided.side) > kSameSideCos * glm::length(*way);
}

/// Calls `use(candidate)` for each plane of a base line and each direction on it. A chain slips away from its members only.
template <typename Use>
void forEachSlip(const CandidateContext& context, const UsableBaseLine& base, Use use) {
  if (context.only != nullptr && !sameBaseLine(base, *context.only)) return;
  slipPlanes(base.line, context.annotation.slip, context.view, context.objectPlanes, context.planes);
  for (const SlipPlane& plane : context.planes) {
    for (const int direction : {1, -1}) {
      if (direction < 0 && base.cluster >= 0 && plane.kind == PlaneKind::kScope) continue;
      Candidate candidate = unplaced(base, plane, direction, context);
      if (context.only != nullptr && candidate.identity != *context.only) continue;
      if (context.avoid != nullptr && isAvoided(*context.avoid, candidate, context.view)) continue;
      use(candidate);
    }
  }
}

}  // namespace

void BaseLineTally::add(const BaseLineTally& other) {
  occluded += other.occluded;
  outOfView += other.outOfView;
  foreshortened += other.foreshortened;
  tooShort += other.tooShort;
}

double leastLengthPx(const Annotation& annotation) { return std::max(kMinLineLengthPx, annotation.minLengthPx); }

bool sameBaseLine(const UsableBaseLine& base, const Identity& identity) {
  return base.scopeIndex == identity.scopeIndex && base.cluster == identity.chain && base.line.number == identity.baseLine;
}

bool isBehindModel(const CandidateContext& context, const UsableBaseLine& base) {
  if (turnedAway(base.line, context.view, 0.0)) return true;
  const Annotation& annotation = context.annotation;
  const int axis = axisOf(annotation.orient).axis;
  const bool onEdge = annotation.type == HandleType::kLinearContour && axis >= 0 && annotation.translate == Vec3(0.0);
  return onEdge && !context.sights[base.scope].edges().has(axis, base.line.number);
}

void gatherBaseLines(const Annotation& annotation, const Scope& scope, std::size_t scopeNumber, const View& view, double factor,
                     std::vector<UsableBaseLine>& lines, BaseLineTally& tally) {
  const double leastPx = leastLengthPx(annotation) * factor;
  if (mostLengthPx(annotation, scope.box, view) < leastPx) {
    ++tally.tooShort;
    return;
  }
  const double cosLeast = std::cos(kForeshortenedAngleRad * factor);
  const BaseSegments segments = baseSegments(annotation, scope.box, view);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (!view.inFrontOfNear(s)) {
      ++tally.outOfView;
      continue;
    }
    const Segment2 screen = view.toScreen(s);
    if (!meets(screen, view.viewport())) {
      ++tally.outOfView;
    } else if (foreshortened(s, view, cosLeast)) {
      ++tally.foreshortened;
    } else if (!(screen.length() >= leastPx)) {
      ++tally.tooShort;
    } else {
      lines.push_back({.scope = scopeNumber,
                       .scopeIndex = static_cast<std::int32_t>(scope.index),
                       .cluster = -1,
                       .line = baseLine(annotation, scope.box, static_cast<int>(i), s),
                       .screen = screen});
    }
  }
}

void gatherChainBaseLines(const Cluster& cluster, std::int32_t number, const View& view, std::span<const char> usable, std::vector<UsableBaseLine>& lines) {
  const auto isUsable = [&](const ChainMember& member) { return usable[member.scope] != 0; };
  const auto hidden = static_cast<std::ptrdiff_t>(cluster.members.size()) - std::ranges::count_if(cluster.members, isUsable);
  const auto first = std::ranges::find_if(cluster.members, isUsable);
  if (first == cluster.members.end()) return;
  for (const int side : {0, 1}) {
    const BaseLine line = chainBaseLine(cluster, side);
    if (!view.inFrontOfNear(line.segment)) continue;
    if (foreshortened(line.segment, view, std::cos(kForeshortenedAngleRad))) continue;
    lines.push_back({.scope = first->scope,
                     .scopeIndex = -1,
                     .cluster = number,
                     .line = line,
                     .screen = view.toScreen(line.segment),
                     .hiddenShare = static_cast<double>(hidden) / static_cast<double>(cluster.members.size())});
  }
}

void gatherGuideCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates) {
  if (context.guides.size() == 0) return;
  const Vec3 along = glm::normalize(base.line.segment.end - base.line.segment.start);
  forEachSlip(context, base, [&](const Candidate& slipping) {
    if (context.history.leftLately(slipping.identity)) return;   // a guide comes before all other places (algorithm 1), so a price would not keep it from being gone back to
    for (std::size_t i = 0; i < context.guides.size(); ++i) {
      const Guide& guide = context.guides[i];
      if (!liesOn(guide, slipping.plane.plane, along, context.toleranceM)) continue;
      Candidate candidate = slipping;
      candidate.mostM = offsetsInView(context, candidate).highM;
      const double offsetM = glm::dot(guide.point - candidate.foot.start, candidate.outward);
      if (!(offsetM > 0) || offsetM < leastRoomM(candidate)) continue;
      const auto slide = Slide::make(context.view, candidate.foot, candidate.outward);
      const double slackM = slipping.identity == context.history.last() ? metresAt(candidate, kGuideSlackPx, context.view) : 0.0;
      if (!slide || leastClearingOffset(context.paddedModel, *slide) > offsetM + slackM) continue;
      candidate.placement = PlacementKind::kGuide;
      candidate.guide = static_cast<int>(i);
      if (placeAt(candidate, *slide, offsetM, context.view)) keep(context, base, candidate, *slide, candidates);
    }
  });
}

void gatherOutsideCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates) {
  forEachSlip(context, base, [&](Candidate& candidate) {
    const auto slide = Slide::make(context.view, candidate.foot, candidate.outward);
    const OffsetRange inView = offsetsInView(context, candidate);
    if (!slide || inView.lowM > inView.highM) return;
    candidate.mostM = inView.highM;
    // What clears at the least offset clears at every greater one, so a plane whose part begins further out, or a line that comes into the picture there, is used from there.
    const double offsetM = std::max({leastClearingOffset(context.padded, *slide, candidate.mostM), leastRoomM(candidate), inView.lowM});
    if (offsetM <= candidate.mostM) keepOutside(context, base, candidate, *slide, offsetM, candidates);
  });
}

void gatherGapCandidates(const CandidateContext& context, const UsableBaseLine& base, std::vector<Candidate>& candidates) {
  if (base.cluster >= 0) return;
  forEachSlip(context, base, [&](Candidate& candidate) {
    const auto slide = Slide::make(context.view, candidate.foot, candidate.outward);
    if (!slide) return;
    const OffsetRange inView = offsetsInView(context, candidate);
    const auto gap = nearestGap(context.padded, *slide, std::max(leastRoomM(candidate), inView.lowM), inView.highM);
    if (!gap) return;
    candidate.mostM = gap->toM;
    keepOutside(context, base, candidate, *slide, gap->fromM, candidates);
  });
}

void gatherInHand(const CandidateContext& context, const UsableBaseLine& base, const Segment& inHand, std::vector<Candidate>& candidates) {
  forEachSlip(context, base, [&](Candidate& candidate) {
    const auto slide = Slide::make(context.view, candidate.foot, candidate.outward);
    if (!slide || !placeAt(candidate, *slide, glm::dot(inHand.start - candidate.foot.start, candidate.outward), context.view)) return;
    candidate.guide = context.guides.through(candidate.line, candidate.plane.plane, context.toleranceM);
    candidate.placement = candidate.guide >= 0 ? PlacementKind::kGuide : PlacementKind::kOutside;
    candidates.push_back(candidate);
  });
}

void gatherInsideCandidate(const CandidateContext& context, const UsableBaseLine& base, const Obb& scope, bool plain,
                           std::vector<Candidate>& candidates) {
  if (isBegunOnFading(context, base)) return;
  Candidate candidate;
  candidate.identity = {.parameter = context.history.last().parameter, .scopeIndex = base.scopeIndex, .baseLine = static_cast<std::int16_t>(base.line.number)};
  const bool stays = candidate.identity == context.history.last();
  const Foresight::Prospect prospect = context.foresight.prospectInside(base.line.segment, context.leastPx);
  // The one that is shown stays to the last, and what is in plain view keeps a line.
  if (!stays && ((prospect.lastMoments && !plain && !context.showAll) || isShownAnewInVain(context, prospect))) return;
  candidate.scope = base.scope;
  candidate.base = candidate.foot = candidate.line = base.line.segment;
  candidate.baseScreen = candidate.footScreen = candidate.lineScreen = base.screen;
  const Vec3 middle = scope.center();
  // A scope whose middle is behind the viewer has no direction on screen; then length alone decides.
  const Vec2 middleScreen = context.view.inFrontOfNear(middle) ? context.view.toScreen(middle) : base.screen.middle();
  candidate.score = scoreInside(base.screen, middleScreen, context.annotation.align) + context.history.bonus(candidate.identity);
  candidate.score += prospect.price;
  if (isBehindModel(context, base)) candidate.score += stays ? kScoreStaysBehindModel : kScoreBehindModel;
  if (!stays && isFading(context, candidate.scope)) candidate.score += kScoreFadingScope;
  candidates.push_back(candidate);
}

double metresAt(const Candidate& candidate, double px, const View& view) { return px * view.metresPerPixelAt(candidate.foot.middle()); }

bool pushOutward(Candidate& candidate, double byPx, const View& view) {
  const Vec3 middle = candidate.line.middle();
  // One pixel's worth of world at that depth, tried along the plane: its length on screen turns pixels into metres.
  const double probeM = view.metresPerPixelAt(middle);
  const auto probe = wayOnScreen(middle, candidate.outward * probeM, view);
  if (!probe) return false;
  const double probePx = glm::length(*probe);
  if (!(probePx > 1e-3)) return false;
  return pushTo(candidate, candidate.offsetM + probeM * byPx / probePx, view);
}

bool pushTo(Candidate& candidate, double offsetM, const View& view) {
  if (candidate.guide >= 0 || !(offsetM <= candidate.mostM)) return false;
  const Vec3 move = candidate.outward * offsetM;
  if (!moveTo(candidate, {candidate.foot.start + move, candidate.foot.end + move}, view)) return false;
  candidate.offsetM = offsetM;
  return true;
}

}  // namespace dimline
