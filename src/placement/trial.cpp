#include "placement/trial.h"

#include <algorithm>
#include <limits>

#include "placement/labels.h"

// A candidate is one line, or a chain with its members; both are expanded to lines before labels are placed, so that a line of its own is
// a chain of one from there on.

namespace dimline {

namespace {

enum class Clear { kYes, kNotYet, kNoRoom };

/// How far out (px) a line must be pushed to be clear, by trial: in so many steps of kLabelPushStepPx as far as there is room, then halving the last one. 0 when it never is. `tryAt(px)` says what
/// is so at a distance.
template <typename TryAt>
double leastClear(int steps, TryAt tryAt) {
  double tangledPx = 0;
  double clearPx = 0;
  for (int step = 1; step <= steps && clearPx == 0; ++step) {
    const Clear found = tryAt(step * kLabelPushStepPx);
    if (found == Clear::kNoRoom) return 0;
    (found == Clear::kYes ? clearPx : tangledPx) = step * kLabelPushStepPx;
  }
  while (clearPx - tangledPx > kClearingPrecisionPx) {
    const double middlePx = 0.5 * (tangledPx + clearPx);
    (tryAt(middlePx) == Clear::kYes ? clearPx : tangledPx) = middlePx;
  }
  return clearPx;
}

}  // namespace

double thresholdFactor(const Measured& measured, const ChoiceContext& context) {
  return context.showAll ? kShowAllLengthPx / leastLengthPx(measured.annotation) : 1.0;
}

ChosenLine chosenLine(const Candidate& c) { return {c.scope, c.base, c.baseScreen, c.foot, c.footScreen, c.line, c.lineScreen, std::nullopt, {}}; }

Trial::AmongOthers Trial::amongOthers(const Candidate& candidate, const Measured& measured, const ChoiceContext& context, double enough) {
  const Segment2& base = candidate.baseScreen;
  const Segment2& foot = candidate.footScreen;
  const Segment2& line = candidate.lineScreen;
  const Landed& others = context.occupied.landed();
  AmongOthers found{candidate.score, others.crossings(base, foot, line)};
  const Landed::Crossings& landed = found.landed;
  found.score += (landed.lines ? kScoreIntersect : 0.0) + (landed.extensions ? kScoreCrossesExtension : 0.0) + (landed.labels ? kScoreCoversLabel : 0.0);
  if (found.score <= enough) return found;
  const double lengthM = candidate.identity.chain >= 0 ? measured.meanLengthM : candidate.base.length();
  found.nestsWrongly = others.nestsWrongly(base, line, lengthM, candidate.guide);
  if (found.nestsWrongly) found.score += kScoreNestsWrongly;
  const Landed::Crossings ahead = context.lookAhead.crossings(base, foot, line);
  found.crossesAhead = ahead.extensions;
  found.score += (ahead.lines ? kScoreIntersect : 0.0) + (ahead.extensions ? kScoreCrossesAhead : 0.0);
  if (context.lookAhead.crowds(line)) found.score += kScoreCrowdsAhead;
  if (context.lookAhead.shadows(foot, line)) found.score += kScoreShadowsAhead;
  return found;
}

std::span<const Segment2> Trial::extensionsOf(std::span<const ChosenLine> lines) {
  extensions_.clear();
  for (const ChosenLine& line : lines) {
    const auto parts = extensionParts(line.baseScreen, line.footScreen, line.lineScreen);
    extensions_.insert(extensions_.end(), parts.begin(), parts.end());
  }
  return extensions_;
}

void Trial::addMembers(AmongOthers& among, const ChoiceContext& context) {
  const Landed::Crossings crossings = context.occupied.landed().extensionCrossings(extensionsOf(lines_));
  if (crossings.extensions && !among.landed.extensions) among.score += kScoreCrossesExtension;
  if (crossings.labels && !among.landed.labels) among.score += kScoreCoversLabel;
  among.landed.extensions = among.landed.extensions || crossings.extensions;
  among.landed.labels = among.landed.labels || crossings.labels;
}

void Trial::pushClear(Candidate& candidate, AmongOthers& among, const Measured& measured, const ChoiceContext& context, const History& history) {
  if (!among.tangled()) return;
  const bool last = candidate.identity == history.last();
  const double stepM = context.viewMoved ? metresAt(candidate, kClearPx, context.view) : 0.0;
  const double mostM = last ? history.mostOffsetM(stepM) : std::numeric_limits<double>::infinity();
  if (candidate.offsetM >= mostM) return;
  Candidate pushed;
  AmongOthers amongThere;
  const auto look = [&] {
    if (!expand(pushed, measured, context)) return false;
    amongThere = amongOthers(pushed, measured, context, -std::numeric_limits<double>::infinity());
    if (pushed.identity.chain >= 0) addMembers(amongThere, context);
    return true;
  };
  const auto push = [&](double byPx) {
    pushed = candidate;
    return pushOutward(pushed, byPx, context.view) && pushed.offsetM <= pushed.leastM * kMostClearedRatio && look();
  };
  const auto clear = [&] {
    return !(among.landed.extensions && amongThere.landed.extensions) && !(among.crossesAhead && amongThere.crossesAhead) &&
           placeLabels(pushed, measured, context);
  };
  const double clearPx = leastClear(kClearingSteps, [&](double byPx) { return push(byPx) ? clear() ? Clear::kYes : Clear::kNotYet : Clear::kNoRoom; });
  const auto goThere = [&] {
    if (clearPx == 0 || !push(clearPx) || (!last && amongThere.score <= among.score)) return false;
    if (pushed.offsetM > mostM && !(pushTo(pushed, mostM, context.view) && look())) return false;
    return placeLabels(pushed, measured, context);
  };
  // What is ahead goes out of its way in turn, and back: the last frame's line comes no nearer until it is clear, or both would go to and fro.
  const auto stayThere = [&] {
    const double thereM = history.mostOffsetM(0);
    if (!last || among.landed.extensions || thereM <= candidate.offsetM || thereM > candidate.leastM * kMostClearedRatio) return false;
    pushed = candidate;
    return pushTo(pushed, thereM, context.view) && look() && placeLabels(pushed, measured, context);
  };
  if (goThere() || stayThere()) {
    candidate = pushed;
    among = amongThere;
    return;
  }
  expand(candidate, measured, context);
  placeLabels(candidate, measured, context);
}

/// Fills `lines_` with the lines that a candidate stands for. False when there is none that has room.
bool Trial::expand(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  lines_.clear();
  if (candidate.identity.chain >= 0) return expandChain(candidate, measured, context);
  if (candidate.guide >= 0) {
    const Guide& guide = context.occupied.guides()[static_cast<std::size_t>(candidate.guide)];
    const auto [from, to] = std::minmax({guide.metresAt(candidate.line.start), guide.metresAt(candidate.line.end)});
    if (!guide.taken.free(from, to, context.toleranceM)) return false;
    if (!context.occupied.landed().hasRoom(candidate.lineScreen, candidate.guide)) return false;
  }
  lines_.push_back(chosenLine(candidate));
  return true;
}

/// Projects the cluster's base lines onto the chain, nearest first; one whose region is taken already is refused (paper 4.3).
bool Trial::expandChain(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  const View& view = context.view;
  const Cluster& cluster = measured.clusters[static_cast<std::size_t>(candidate.identity.chain)];
  const double toleranceM = context.toleranceM;
  const Guide* guide = candidate.guide >= 0 ? &context.occupied.guides()[static_cast<std::size_t>(candidate.guide)] : nullptr;
  const double leastPx = thresholdFactor(measured, context) * leastLengthPx(measured.annotation);
  chainStretches_.clear();
  for (const std::uint32_t index : cluster.nearestFirst[static_cast<std::size_t>(candidate.identity.baseLine)]) {
    const ChainMember& m = cluster.members[index];
    if (context.usable[m.scope] == 0 || !chainStretches_.free(m.fromM, m.toM, toleranceM)) continue;
    if (!view.inFrontOfNear(m.segment)) continue;
    const Segment line{candidate.line.start + cluster.along * m.fromM, candidate.line.start + cluster.along * m.toM};
    const Segment2 lineScreen = view.toScreen(line);
    if (lineScreen.length() < leastPx) continue;
    if (guide != nullptr) {
      const auto [from, to] = std::minmax({guide->metresAt(line.start), guide->metresAt(line.end)});
      if (!guide->taken.free(from, to, toleranceM) || !context.occupied.landed().hasRoom(lineScreen, candidate.guide)) continue;
    }
    chainStretches_.add(m.fromM, m.toM);
    const Segment foot{m.segment.start + candidate.plane.onto, m.segment.end + candidate.plane.onto};
    lines_.push_back({m.scope, m.segment, view.toScreen(m.segment), foot, view.toScreen(foot), line, lineScreen, std::nullopt, {}});
  }
  return !lines_.empty();
}

bool Trial::settle(Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  if (!expand(candidate, measured, context)) return false;
  if (placeLabels(candidate, measured, context)) return true;
  Candidate pushed;
  const auto tryAt = [&](double byPx) {
    pushed = candidate;
    if (!pushOutward(pushed, byPx, context.view) || !expand(pushed, measured, context)) return Clear::kNoRoom;
    return placeLabels(pushed, measured, context) ? Clear::kYes : Clear::kNotYet;
  };
  // No further than it must: whatever lies further out comes nearer in the next frames, and would be pushed again.
  const double clearPx = leastClear(kLabelPushSteps, tryAt);
  if (clearPx == 0 || tryAt(clearPx) != Clear::kYes) return false;
  candidate = pushed;
  return true;
}

bool Trial::takeAsItIs(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  if (!expand(candidate, measured, context)) return false;
  placeLabels(candidate, measured, context);
  return true;
}

/// As many lines carry a text as have room without being in the way of what is ahead, or else the first that has room; false when none has.
bool Trial::placeLabels(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  labels_.clear();
  fellows_.clear();
  for (const ChosenLine& line : lines_) fellows_.push_back(line.lineScreen);
  Identity identity = candidate.identity;
  const auto place = [&](std::size_t i, bool orNone) {
    ChosenLine& line = lines_[i];
    identity.scopeIndex = static_cast<std::int32_t>(context.scopes[line.scope].index);
    const auto found = placeLabel({.line = line.lineScreen,
                                   .textSize = measured.textSize,
                                   .outward = candidate.lineScreen.middle() - candidate.baseScreen.middle(),
                                   .model = &context.model,
                                   .fellows = fellows_,
                                   .fellowLabels = labels_,
                                   .ahead = &context.lookAhead,
                                   .orNone = orNone,
                                   .last = context.labels.last(identity, i, context.viewMoved)},
                                  context.occupied.landed(), context.view.viewport());
    if (!found) return;
    line.label = found->box;
    line.labelPlace = found->place;
    labels_.push_back(found->box);
  };
  for (std::size_t i = 0; i < lines_.size(); ++i) place(i, lines_.size() > 1);
  for (std::size_t i = 0; lines_.size() > 1 && labels_.empty() && i < lines_.size(); ++i) place(i, false);
  return !labels_.empty();
}

}  // namespace dimline
