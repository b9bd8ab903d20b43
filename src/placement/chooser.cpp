#include "placement/chooser.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "placement/labels.h"
#include "placement/on_screen.h"

// A candidate is one line, or a chain with its members; both are expanded to lines before labels are placed, so that a line of its own is
// a chain of one from there on.

namespace dimline {

namespace {

auto orderOf(const Identity& i) { return std::tie(i.chain, i.scopeIndex, i.baseLine, i.plane, i.direction); }

ChosenLine chosen(const Candidate& c) { return {c.scope, c.base, c.baseScreen, c.foot, c.footScreen, c.line, c.lineScreen, std::nullopt}; }

/// px. While all is shown, a line must still have a direction on screen.
constexpr double kShowAllLengthPx = 1.5;

/// By what the thresholds of constants.h are multiplied for what is too short or points at the viewer.
double thresholdFactor(const Measured& measured, const ChoiceContext& context) {
  return context.showAll ? kShowAllLengthPx / leastLengthPx(measured.annotation) : 1.0;
}

enum class Clear { kYes, kNotYet, kNoRoom };

/// How far out (px) a line must be pushed to be clear, by trial: in steps of kLabelPushStepPx as far as there is room, then halving the last one. 0 when it never is. `tryAt(px)` says what
/// is so at a distance.
template <typename TryAt>
double leastClear(TryAt tryAt) {
  double tangledPx = 0;
  double clearPx = 0;
  for (int step = 1; step <= kClearingSteps && clearPx == 0; ++step) {
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

bool Chooser::choose(const Measured& measured, const ChoiceContext& context, const History& history) {
  cramped_ = false;
  // A chain moves as a whole, so of its members' base lines it is enough to know that there is one, unless they have to stand for themselves.
  const bool chained = !measured.clusters.empty();
  const auto enough = chained ? Enough::kOne : Enough::kAll;
  const double factor = thresholdFactor(measured, context);
  if (history.hidden() && !gatherBases(measured, context, kShowAgainFactor * factor, Enough::kOne)) return false;
  if (!gatherBases(measured, context, factor, enough)) return false;
  const CandidateContext candidates{measured.annotation, context.view, context.occupied.padded(), context.occupied.paddedModel(), context.occupied.guides(),
                                    context.objectPlanes, context.viewMoved, history, context.toleranceM, slipPlanes_, context.foresight,
                                    factor * leastLengthPx(measured.annotation), nullptr, context.avoid, false, context.showAll};
  if (context.firm && chooseAgain(measured, candidates, context)) return true;
  chainBases_.clear();
  for (std::size_t i = 0; i < measured.clusters.size(); ++i) {
    gatherChainBaseLines(measured.clusters[i], static_cast<std::int32_t>(i), context.view, chainBases_);
  }
  // A chain that has no room as a whole, or passes behind the viewer, may leave room for one of its base lines; that stays for a while before the chain is
  // looked at again.
  const bool singleStays = chained && history.last().chain < 0 && history.last().plane >= 0 && history.framesHeld() < kReturnFrames;
  const auto chooseSingle = [&] {
    if (chained) gatherBases(measured, context, factor, Enough::kAll);
    return chooseOutside(bases_, measured, candidates, context);
  };
  if (singleStays && chooseSingle()) return true;
  // From near by the chains of a row leave the picture one soon after the other, so one of its base lines comes before a chain that would be gone at once.
  CandidateContext lasting = candidates;
  lasting.lasting = true;
  if (chained && chooseOutside(chainBases_, measured, lasting, context)) return true;
  if (!singleStays && chooseSingle()) return true;
  if (chained && context.foresight.zooms() && chooseOutside(chainBases_, measured, candidates, context)) return true;
  return chooseInside(candidates, context);
}

/// The base lines that can be used, by thresholds that are `factor` times those of constants.h. False when there is none.
bool Chooser::gatherBases(const Measured& measured, const ChoiceContext& context, double factor, Enough enough) {
  bases_.clear();
  tally_ = {};
  for (const std::size_t scope : measured.scopes) {
    if (enough == Enough::kOne && !bases_.empty()) break;
    if (context.usable[scope] != 0) gatherBaseLines(measured.annotation, context.scopes[scope], scope, context.view, factor, bases_, tally_);
  }
  return !bases_.empty();
}

/// The last frame's choice outside, when it still is a place, has not leapt and runs into no line.
bool Chooser::chooseAgain(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context) {
  const Identity& last = candidates.history.last();
  if (last.plane < 0) return false;
  chainBases_.clear();
  if (last.chain >= 0) {
    if (static_cast<std::size_t>(last.chain) >= measured.clusters.size()) return false;
    gatherChainBaseLines(measured.clusters[static_cast<std::size_t>(last.chain)], last.chain, context.view, chainBases_);
  } else if (!measured.clusters.empty()) {
    // It stood for its chain long enough.
    if (candidates.history.framesHeld() >= kReturnFrames) return false;
    gatherBases(measured, context, thresholdFactor(measured, context), Enough::kAll);
  }
  CandidateContext again = candidates;
  again.only = &last;
  const std::span<const UsableBaseLine> bases = last.chain >= 0 ? chainBases_ : bases_;
  if (!chooseOutside(bases, measured, again, context) || !candidates.history.stays(winner_.identity, away(winner_.baseScreen, winner_.lineScreen))) return false;
  return std::ranges::none_of(winnerLines_, [&](const ChosenLine& line) { return context.occupied.landed().runsInto(line.lineScreen); });
}

/// The best candidate on a guide or, when there is none, outside the silhouette.
bool Chooser::chooseOutside(std::span<const UsableBaseLine> bases, const Measured& measured, const CandidateContext& candidates,
                            const ChoiceContext& context) {
  for (const auto gather : {gatherGuideCandidates, gatherOutsideCandidates}) {
    candidates_.clear();
    for (const UsableBaseLine& base : bases) gather(candidates, base, candidates_);
    // Equal scores are ordered by identity, so that the same frame always gives the same layout.
    ranked_.clear();
    for (Candidate& candidate : candidates_) ranked_.push_back(&candidate);
    std::ranges::sort(ranked_, [](const Candidate* a, const Candidate* b) {
      if (a->secondOffset != b->secondOffset) return b->secondOffset;
      return a->score != b->score ? a->score > b->score : orderOf(a->identity) < orderOf(b->identity);
    });
    if (chooseBest(measured, context, candidates.history)) return true;
  }
  return false;
}

/// A candidate's score with what it runs into, of the lines that have landed and of those ahead. Of a score that comes to `enough` or less, no more is worked out.
Chooser::AmongOthers Chooser::amongOthers(const Candidate& candidate, const ChoiceContext& context, double enough) {
  const Segment2& base = candidate.baseScreen;
  const Segment2& foot = candidate.footScreen;
  const Segment2& line = candidate.lineScreen;
  const Landed& others = context.occupied.landed();
  AmongOthers found{candidate.score, others.crossings(base, foot, line)};
  const Landed::Crossings& landed = found.landed;
  found.score += (landed.lines ? kScoreIntersect : 0.0) + (landed.extensions ? kScoreCrossesExtension : 0.0) + (landed.labels ? kScoreCoversLabel : 0.0);
  if (found.score <= enough) return found;
  found.nestsWithin = others.nestsWithin(base, line, candidate.guide);
  if (found.nestsWithin) found.score += kScoreNestsWithin;
  const Landed::Crossings ahead = context.lookAhead.crossings(base, foot, line);
  found.crossesAhead = ahead.extensions;
  found.score += (ahead.lines ? kScoreIntersect : 0.0) + (ahead.extensions ? kScoreCrossesAhead : 0.0);
  if (context.lookAhead.crowds(line)) found.score += kScoreCrowdsAhead;
  if (context.lookAhead.shadows(foot, line)) found.score += kScoreShadowsAhead;
  return found;
}

/// The extension lines of a line, or of all members of a chain, in parts.
std::span<const Segment2> Chooser::extensionsOf(std::span<const ChosenLine> lines) {
  extensions_.clear();
  for (const ChosenLine& line : lines) {
    const auto parts = extensionParts(line.baseScreen, line.footScreen, line.lineScreen);
    extensions_.insert(extensions_.end(), parts.begin(), parts.end());
  }
  return extensions_;
}

/// What the extension lines of a chain's members run across; those at its ends are known to the score already.
void Chooser::addMembers(AmongOthers& among, const ChoiceContext& context) {
  const Landed::Crossings crossings = context.occupied.landed().extensionCrossings(extensionsOf(lines_));
  if (crossings.extensions && !among.landed.extensions) among.score += kScoreCrossesExtension;
  if (crossings.labels && !among.landed.labels) among.score += kScoreCoversLabel;
  among.landed.extensions = among.landed.extensions || crossings.extensions;
  among.landed.labels = among.landed.labels || crossings.labels;
}

/// Moves a candidate that runs across another's extension line, or across whose extension line another runs, further out until none does, where there is such an offset and its
/// label has room there. The last frame's choice goes there by kClearPx a frame. Beyond the paper, whose lines lie at the least offset (4.1).
void Chooser::pushClear(Candidate& candidate, AmongOthers& among, const Measured& measured, const ChoiceContext& context, const History& history) {
  if (!among.tangled()) return;
  const bool last = candidate.identity == history.last();
  const double stepM = context.viewMoved ? metresAt(candidate, kClearPx, context.view) : 0.0;
  const double mostM = last ? history.mostOffsetM(stepM) : std::numeric_limits<double>::infinity();
  if (candidate.offsetM >= mostM) return;
  Candidate pushed;
  AmongOthers amongThere;
  const auto look = [&] {
    if (!expand(pushed, measured, context)) return false;
    amongThere = amongOthers(pushed, context, -std::numeric_limits<double>::infinity());
    if (lines_.size() > 1) addMembers(amongThere, context);
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
  const double clearPx = leastClear([&](double byPx) { return push(byPx) ? clear() ? Clear::kYes : Clear::kNotYet : Clear::kNoRoom; });
  const auto goThere = [&] {
    if (clearPx == 0 || !push(clearPx) || (!last && amongThere.score <= among.score)) return false;
    if (pushed.offsetM > mostM && !(pushTo(pushed, mostM, context.view) && look())) return false;
    return placeLabels(pushed, measured, context);
  };
  if (goThere()) {
    candidate = pushed;
    among = amongThere;
    return;
  }
  expand(candidate, measured, context);
  placeLabels(candidate, measured, context);
}

/// computeWinner. Crossings and labels are dear, so they are looked at only for candidates that could still win: crossings only lower a
/// score, and the candidates come in descending order.
bool Chooser::chooseBest(const Measured& measured, const ChoiceContext& context, const History& history) {
  bool found = false;
  bool firstOffsetFailed = false;
  double bestScore = 0;
  for (Candidate* const ranked : ranked_) {
    Candidate& candidate = *ranked;
    // The second offset comes last, whatever its score.
    if (candidate.secondOffset ? !firstOffsetFailed : found && bestScore >= candidate.score) continue;
    const auto beaten = [&](double score) { return found && bestScore >= score; };
    const auto inPlace = [&] { return amongOthers(candidate, context, found ? bestScore : -std::numeric_limits<double>::infinity()); };
    AmongOthers among = inPlace();
    if (beaten(among.score)) continue;
    const Segment2 triedAt = candidate.lineScreen;
    if (!settle(candidate, measured, context)) {
      firstOffsetFailed = firstOffsetFailed || candidate.hasSecondOffset;
      continue;
    }
    // Its label may have pushed it to where it runs into more.
    if (candidate.lineScreen.start != triedAt.start) among = inPlace();
    if (lines_.size() > 1) addMembers(among, context);
    pushClear(candidate, among, measured, context, history);
    if (beaten(among.score)) continue;
    // The padded fields know nothing of lines inside the model.
    if (among.landed.lines && context.occupied.landed().runsInto(candidate.lineScreen)) continue;
    found = true;
    bestScore = among.score;
    winner_ = candidate;
    winnerAmongOthers_ = among;
    std::swap(lines_, winnerLines_);
  }
  return found;
}

/// The fallback: the base lines themselves (algorithm 1, line 9), the best that runs into no other line, or else the best of those that are in view from end to end: one that leads
/// out of the picture across others says less than it confuses. Its label waits for what else is there.
bool Chooser::chooseInside(const CandidateContext& candidates, const ChoiceContext& context) {
  const Landed& landed = context.occupied.landed();
  const auto isFree = [&](const Segment2& line) { return !landed.runsInto(line) && !landed.coversLabel(line); };
  candidates_.clear();
  for (const UsableBaseLine& base : bases_) {
    if (!isWhole(base.screen, context.view) && !context.showAll && !isFree(base.screen)) continue;
    gatherInsideCandidate(candidates, base, context.scopes[base.scope].box, candidates_);
  }
  if (candidates_.empty()) {
    tally_.outOfView += static_cast<int>(bases_.size());
    cramped_ = true;
    return false;
  }
  for (Candidate& c : candidates_) {
    const Landed::Crossings across = landed.crossings(c.baseScreen, c.baseScreen, c.lineScreen);
    c.score += (across.extensions ? kScoreAmissInside : 0.0) + (across.labels ? kScoreAmissInside : 0.0);
    if (context.lookAhead.runsIntoInside(c.lineScreen)) c.score += kScoreAmissInside;
  }
  const auto rank = [&](const Candidate& c) { return std::pair(!landed.runsInto(c.lineScreen), c.score); };
  const auto best = std::ranges::max_element(candidates_, {}, rank);
  cramped_ = landed.runsInto(best->lineScreen);
  winner_ = *best;
  winnerLines_.clear();
  winnerLines_.push_back(chosen(winner_));
  return true;
}

Chooser::Worth Chooser::worth(const Landed& landed) {
  if (winner_.placement == PlacementKind::kInside) return {kScoreInside, {}, false};
  const Landed::Crossings& crossings = winnerAmongOthers_.landed;
  const bool nests = winnerAmongOthers_.nestsWithin;
  const Landed::Tangle tangle = crossings.extensions ? landed.tangle(winner_.lineScreen, extensionsOf(winnerLines_)) : Landed::Tangle{};
  const double runsInto = (crossings.lines ? kScoreIntersect : 0.0) + (crossings.labels ? kScoreCoversLabel : 0.0) +
                          kScoreTangle * tangle.lines +
                          (nests ? kScoreNestedWrongly : 0.0);
  return {winner_.score - winner_.hysteresis + runsInto, tangle, nests};
}

/// Fills `lines_` with the lines that a candidate stands for. False when there is none that has room.
bool Chooser::expand(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  lines_.clear();
  if (candidate.identity.chain >= 0) return expandChain(candidate, measured, context);
  if (candidate.guide >= 0) {
    const Guide& guide = context.occupied.guides()[static_cast<std::size_t>(candidate.guide)];
    const auto [from, to] = std::minmax({guide.metresAt(candidate.line.start), guide.metresAt(candidate.line.end)});
    if (!guide.taken.free(from, to, context.toleranceM)) return false;
    if (!context.occupied.landed().hasRoom(candidate.lineScreen, candidate.guide)) return false;
  }
  lines_.push_back(chosen(candidate));
  return true;
}

/// Projects the cluster's base lines onto the chain, nearest first; one whose region is taken already is refused (paper 4.3).
bool Chooser::expandChain(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  const View& view = context.view;
  const Cluster& cluster = measured.clusters[static_cast<std::size_t>(candidate.identity.chain)];
  const double toleranceM = context.toleranceM;
  const Guide* guide = candidate.guide >= 0 ? &context.occupied.guides()[static_cast<std::size_t>(candidate.guide)] : nullptr;
  const double leastPx = thresholdFactor(measured, context) * leastLengthPx(measured.annotation);
  chainStretches_.clear();
  for (const std::uint32_t index : cluster.nearestFirst[static_cast<std::size_t>(candidate.identity.baseLine)]) {
    const ChainMember& m = cluster.members[index];
    if (context.usable[m.scope] == 0 || !chainStretches_.free(m.fromM, m.toM, toleranceM)) continue;
    if (!view.inFrontOfNear(m.segment.start) || !view.inFrontOfNear(m.segment.end)) continue;
    const Segment line{candidate.line.start + cluster.along * m.fromM, candidate.line.start + cluster.along * m.toM};
    const Segment2 lineScreen = view.toScreen(line);
    if (lineScreen.length() < leastPx) continue;
    if (guide != nullptr) {
      const auto [from, to] = std::minmax({guide->metresAt(line.start), guide->metresAt(line.end)});
      if (!guide->taken.free(from, to, toleranceM) || !context.occupied.landed().hasRoom(lineScreen, candidate.guide)) continue;
    }
    chainStretches_.add(m.fromM, m.toM);
    const Segment foot{m.segment.start + candidate.plane.onto, m.segment.end + candidate.plane.onto};
    lines_.push_back({m.scope, m.segment, view.toScreen(m.segment), foot, view.toScreen(foot), line, lineScreen, std::nullopt});
  }
  return !lines_.empty();
}

/// Expands a candidate and gives it a label, moving it further out where the label has no room. False when there is none.
bool Chooser::settle(Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  for (int step = 0; step <= kLabelPushSteps; ++step) {
    if (step > 0 && !pushOutward(candidate, kLabelPushStepPx, context.view)) return false;
    if (!expand(candidate, measured, context)) return false;
    if (placeLabels(candidate, measured, context)) return true;
  }
  return false;
}

/// As many lines carry a text as have room; false when none has.
bool Chooser::placeLabels(const Candidate& candidate, const Measured& measured, const ChoiceContext& context) {
  bool any = false;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto box = placeLabel({.line = lines_[i].lineScreen,
                                 .textSize = measured.textSize,
                                 .outward = candidate.lineScreen.middle() - candidate.baseScreen.middle(),
                                 .model = &context.model,
                                 .inChain = lines_.size() > 1},
                                context.occupied.landed(), context.view.viewport());
    if (!box || !fellowsLeaveRoom(*box, i)) continue;
    lines_[i].label = box;
    any = true;
  }
  return any;
}

bool Chooser::fellowsLeaveRoom(const Box2& label, std::size_t own) const {
  const Box2 grown = label.grown(kLabelClearancePx);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (i == own) continue;
    if (meets(lines_[i].lineScreen, grown)) return false;
    if (lines_[i].label && grown.overlaps(*lines_[i].label)) return false;
  }
  return true;
}

}  // namespace dimline
