#include "placement/chooser.h"

#include <algorithm>
#include <limits>
#include <tuple>


namespace dimline {

namespace {

/// Moved frames for which one line stands for a chain that had no room.
int framesForSingle(const ChoiceContext& context) { return context.foresight.zooms() ? kSingleStaysZooming : kReturnFrames; }

}  // namespace

bool Chooser::choose(const Measured& measured, const ChoiceContext& context, History& history) {
  cramped_ = false;
  wishedLines_.clear();
  wishedScore_ = -std::numeric_limits<double>::infinity();
  // A chain moves as a whole, so of its members' base lines it is enough to know that there is one, unless they have to stand for themselves.
  const bool chained = !measured.clusters.empty();
  const auto enough = chained ? Enough::kOne : Enough::kAll;
  const auto hasBases = [&](double factor, Enough wanted) { return gatherBases(measured, context, context.view, factor, wanted); };
  if (history.hidden() && !hasBases(history.wentLately() ? kShowAgainLatelyFactor : kShowAgainFactor, Enough::kOne)) return false;
  if (!hasBases(1, enough) && !((context.dwells(history) || comesBack(measured, context)) && hasBases(kDwellFactor, enough))) return false;
  const CandidateContext candidates{measured.annotation, context.view, context.occupied.padded(), context.occupied.paddedModel(), context.occupied.guides(),
                                    context.objectPlanes, context.viewMoved, history, context.toleranceM, slipPlanes_, context.foresight,
                                    factor_ * leastLengthPx(measured.annotation), nullptr, context.avoid, false, context.showAll, context.sights, measured.textSize, context.kind};
  if (context.inHand != nullptr && chooseInHand(measured, candidates, context)) return true;
  if (context.firm && chooseAgain(measured, candidates, context)) return true;
  chainBases_.clear();
  for (std::size_t i = 0; i < measured.clusters.size(); ++i) {
    gatherChainBaseLines(measured.clusters[i], static_cast<std::int32_t>(i), context.view, context.usable, chainBases_);
  }
  const Outside outside = chooseOutside(measured, candidates, context, context.patient && history.wasInside() ? &history : nullptr);
  if (outside == Outside::kFound || chooseInside(candidates, context)) return true;
  // What has no room inside any more cannot wait there.
  const bool found = outside == Outside::kWaits && chooseOutside(measured, candidates, context, nullptr) == Outside::kFound;
  if (found) cramped_ = false;
  return found;
}

/// A place outside for a chain or for a single line. `waits`: the history of a line inside that may have to wait there.
Chooser::Outside Chooser::chooseOutside(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context, History* waits) {
  Outside outside = Outside::kNone;
  const auto choose = [&](std::span<const UsableBaseLine> bases, const CandidateContext& among) {
    if (!chooseOutside(bases, measured, among, context)) return false;
    // Object planes are cut off by each other and left out when they are edge-on, so that room on them comes and goes while the camera moves.
    const bool taken = waits == nullptr || winner_.plane.kind != PlaneKind::kObject || waits->betterIsThere();
    outside = taken ? Outside::kFound : Outside::kWaits;
    return taken;
  };
  // A chain that has no room as a whole, or passes behind the viewer, may leave room for one of its base lines; that stays for a while before the chain is
  // looked at again.
  const bool chained = !measured.clusters.empty();
  const History& history = candidates.history;
  const bool singleStays = chained && history.last().chain < 0 && history.last().plane >= 0 && history.framesHeld() < framesForSingle(context);
  const auto chooseSingle = [&] {
    if (chained) gatherBases(measured, context, context.view, Enough::kAll);
    return choose(bases_, candidates);
  };
  if (singleStays && chooseSingle()) return outside;
  // From near by the chains of a row leave the picture one soon after the other, so one of its base lines comes before a chain that would be gone at once.
  CandidateContext lasting = candidates;
  lasting.lasting = true;
  if (chained && choose(chainBases_, lasting)) return outside;
  if (!singleStays && chooseSingle()) return outside;
  if (chained && context.foresight.zooms()) choose(chainBases_, candidates);
  return outside;
}

/// The base lines that can be used in that view, by thresholds that are `factor_` times those of constants.h. False when there is none.
bool Chooser::gatherBases(const Measured& measured, const ChoiceContext& context, const View& view, Enough enough) {
  bases_.clear();
  tally_ = {};
  for (const std::size_t scope : measured.scopes) {
    if (enough == Enough::kOne && !bases_.empty()) break;
    if (context.usable[scope] != 0) gatherBaseLines(measured.annotation, context.scopes[scope], scope, view, factor_, bases_, tally_);
  }
  return !bases_.empty();
}

/// The same by thresholds that are `factor` times the parameter's own, now and from then on.
bool Chooser::gatherBases(const Measured& measured, const ChoiceContext& context, const View& view, double factor, Enough enough) {
  factor_ = factor * thresholdFactor(measured, context);
  return gatherBases(measured, context, view, enough);
}

/// Whether what cannot be used now can be at one of the looks ahead while the view turns, and until then by the lower thresholds: it passes its shortest.
bool Chooser::comesBack(const Measured& measured, const ChoiceContext& context) {
  const Foresight& foresight = context.foresight;
  const BaseLineTally now = tally_;
  const auto usableAt = [&](std::size_t look, double factor) { return gatherBases(measured, context, foresight.viewAhead(look), factor, Enough::kOne); };
  const std::size_t looks = foresight.zooms() ? 0 : foresight.lookCount();
  bool back = false;
  for (std::size_t look = 0; look < looks && !back; ++look) {
    back = usableAt(look, 1);
    if (!back && !usableAt(look, kDwellFactor)) break;
  }
  tally_ = now;
  return back;
}

/// The chain of which one member is dragged: it goes with that member, which stays on its carrier.
bool Chooser::chooseInHand(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context) {
  const Identity& last = candidates.history.last();
  if (last.chain < 0 || static_cast<std::size_t>(last.chain) >= measured.clusters.size()) return false;
  chainBases_.clear();
  gatherChainBaseLines(measured.clusters[static_cast<std::size_t>(last.chain)], last.chain, context.view, context.usable, chainBases_);
  CandidateContext again = candidates;
  again.only = &last;
  candidates_.clear();
  for (const UsableBaseLine& base : chainBases_) gatherInHand(again, base, *context.inHand, candidates_);
  if (candidates_.empty() || !trial_.takeAsItIs(candidates_.front(), measured, context)) return false;
  winner_ = candidates_.front();
  winnerAmongOthers_ = Trial::amongOthers(winner_, measured, context, -std::numeric_limits<double>::infinity());
  trial_.swapLines(winnerLines_);
  return true;
}

/// The last frame's choice outside, when it still is a place, has not leapt and runs into no line.
bool Chooser::chooseAgain(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context) {
  const Identity& last = candidates.history.last();
  if (last.plane < 0) return false;
  chainBases_.clear();
  if (last.chain >= 0) {
    if (static_cast<std::size_t>(last.chain) >= measured.clusters.size()) return false;
    gatherChainBaseLines(measured.clusters[static_cast<std::size_t>(last.chain)], last.chain, context.view, context.usable, chainBases_);
  } else if (!measured.clusters.empty()) {
    // It stood for its chain long enough.
    if (candidates.history.framesHeld() >= framesForSingle(context)) return false;
    gatherBases(measured, context, context.view, Enough::kAll);
  }
  CandidateContext again = candidates;
  again.only = &last;
  const std::span<const UsableBaseLine> bases = last.chain >= 0 ? chainBases_ : bases_;
  if (!chooseOutside(bases, measured, again, context) || !candidates.history.stays(winner_.identity, away(winner_.baseScreen, winner_.lineScreen))) return false;
  return std::ranges::none_of(winnerLines_, [&](const ChosenLine& line) { return context.occupied.landed().runsInto(line.lineScreen); });
}

/// The best candidate on a guide or, when there is none, outside the silhouette, and then between parts of it.
bool Chooser::chooseOutside(std::span<const UsableBaseLine> bases, const Measured& measured, const CandidateContext& candidates,
                            const ChoiceContext& context) {
  const auto chooseAmong = [&](decltype(&gatherOutsideCandidates) gather) {
    candidates_.clear();
    for (const UsableBaseLine& base : bases) gather(candidates, base, candidates_);
    ranked_.clear();
    for (const Candidate& candidate : candidates_) ranked_.push_back({-candidate.score, static_cast<std::uint32_t>(ranked_.size())});
    sortKeys(ranked_);
    return chooseBest(measured, context, candidates.history);
  };
  return chooseAmong(gatherGuideCandidates) || chooseAmong(gatherOutsideCandidates) || (bases.size() <= kMostBaseLinesInGaps && chooseAmong(gatherGapCandidates));
}

/// computeWinner. Crossings and labels are dear, so they are looked at only for candidates that could still win: crossings only lower a
/// score, and the candidates come in descending order.
bool Chooser::chooseBest(const Measured& measured, const ChoiceContext& context, const History& history) {
  bool found = false;
  bool firstOffsetFailed = false;
  double bestScore = 0;
  // A feature that is seen in part gets no new line that confuses the picture, but one in place of its line inside where nothing else does; while the view only turns, it soon is seen better.
  const auto mayCross = [&](const Candidate& candidate) {
    return !context.foresight.zooms() || context.showAll || candidate.identity == history.last() || (context.calm && !history.shownAnew()) || context.inPlainView(candidate.scope);
  };
  // The second offsets come last, whatever their scores.
  for (const bool second : {false, true}) {
    for (const SortKey& key : ranked_) {
      Candidate& candidate = candidates_[key.index];
      if (candidate.secondOffset != second) continue;
      if (second ? !firstOffsetFailed : found && bestScore >= candidate.score) continue;
      const auto beaten = [&](double score) { return found && bestScore >= score; };
      // By how much labels lower its score that may yet give way.
      const auto forLabels = [&](const Trial::AmongOthers& among) { return context.asksForRoom && among.landed.labels ? -kScoreCoversLabel : 0.0; };
      const double enough = found && !context.asksForRoom ? bestScore : -std::numeric_limits<double>::infinity();
      const auto inPlace = [&] { return Trial::amongOthers(candidate, measured, context, enough); };
      Trial::AmongOthers among = inPlace();
      if (beaten(among.score + forLabels(among))) continue;
      const Segment2 triedAt = candidate.lineScreen;
      if (!trial_.settle(candidate, measured, context)) {
        firstOffsetFailed = firstOffsetFailed || candidate.hasSecondOffset;
        continue;
      }
      // Its label may have pushed it to where it runs into more.
      if (candidate.lineScreen.start != triedAt.start) among = inPlace();
      if (candidate.identity.chain >= 0) trial_.addMembers(among, context);
      trial_.pushClear(candidate, among, measured, context, history);
      if (among.landed.extensions && !mayCross(candidate)) continue;
      const double wish = among.score + forLabels(among);
      if (beaten(wish)) continue;
      // The padded fields know nothing of lines inside the model.
      if (among.landed.lines && context.occupied.landed().runsInto(candidate.lineScreen)) continue;
      if (wish > among.score && wish > wishedScore_) {
        wishedScore_ = wish;
        wishedLines_.assign(trial_.lines().begin(), trial_.lines().end());
      }
      if (beaten(among.score)) continue;
      found = true;
      bestScore = among.score;
      winner_ = candidate;
      winnerAmongOthers_ = among;
      trial_.swapLines(winnerLines_);
    }
  }
  if (found && wishedScore_ <= bestScore + kWorthAskingPx) wishedLines_.clear();
  return found;
}

/// The fallback: the base lines themselves (algorithm 1, line 9), the best that runs into no other line, or else the best of those in plain view: one that leads out of the picture, or measures what the model
/// mostly hides, says less than it confuses when it runs across others, or would begin on an edge behind the model. Its label waits for what else is there.
bool Chooser::chooseInside(const CandidateContext& candidates, const ChoiceContext& context) {
  const Landed& landed = context.occupied.landed();
  const History& history = candidates.history;
  const auto isFree = [&](const UsableBaseLine& base, bool stays) {
    if (landed.runsInto(base.screen) || landed.coversLabel(base.screen)) return false;
    if (history.shownAnew() && context.lookAhead.runsIntoInside(base.screen)) return false;   // one that is shown would have to give way, for some frames
    if (context.dwells(history)) return true;
    return !landed.crossesExtension(base.screen) && !landed.runsAlongExtension(base.screen) && (stays || !isBehindModel(candidates, base));
  };
  bool keptOff = false;
  candidates_.clear();
  for (const UsableBaseLine& base : bases_) {
    const Obb& scope = context.scopes[base.scope].box;
    const bool stays = history.wasInside() && sameBaseLine(base, history.last());
    const bool plain = context.inPlainView(base.scope, stays);
    if (plain || context.showAll || isFree(base, stays)) {
      gatherInsideCandidate(candidates, base, scope, plain, candidates_);
    } else {
      ++(wholeInView(context.view, scope) ? tally_.occluded : tally_.outOfView);
      keptOff = true;
    }
  }
  cramped_ = keptOff;
  if (candidates_.empty()) return false;
  for (Candidate& c : candidates_) {
    const Landed::Crossings across = landed.crossings(c.baseScreen, c.baseScreen, c.lineScreen);
    c.score += (across.extensions || landed.runsAlongExtension(c.lineScreen) ? kScoreAmissInside : 0.0) + (across.labels ? kScoreAmissInside : 0.0);
    c.score += kScoreHiddenScope * (1 - context.sights[c.scope].share());
    if (context.lookAhead.runsIntoInside(c.lineScreen)) c.score += kScoreAmissInside;
  }
  // Who comes anew would have to wait with a base line that is not in plain view (Placer): one that is comes first, where there is any.
  const bool anew = history.shownAnew();
  const auto rank = [&](const Candidate& c) { return std::tuple(!landed.runsInto(c.lineScreen), anew && context.inPlainView(c.scope), c.score); };
  const auto best = std::ranges::max_element(candidates_, {}, rank);
  cramped_ = landed.runsInto(best->lineScreen) || landed.coversLabel(best->lineScreen);
  winner_ = *best;
  winnerLines_.clear();
  winnerLines_.push_back(chosenLine(winner_));
  return true;
}

Chooser::Worth Chooser::worth(const Landed& landed) {
  if (winner_.placement == PlacementKind::kInside) return {kScoreInside, landed.tangle(winner_.lineScreen, {}), false};
  const Landed::Crossings& crossings = winnerAmongOthers_.landed;
  const Landed::Tangle tangle = crossings.extensions ? landed.tangle(winner_.lineScreen, trial_.extensionsOf(winnerLines_)) : Landed::Tangle{};
  const double runsInto = (crossings.lines ? kScoreIntersect : 0.0) + (crossings.labels ? kScoreCoversLabel : 0.0);
  return {winner_.score - winner_.hysteresis + runsInto, tangle, winnerAmongOthers_.nestsWrongly};
}

}  // namespace dimline
