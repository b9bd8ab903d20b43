#include <algorithm>
#include <cmath>
#include <utility>

#include "placement/arcs.h"
#include "placement/jogs.h"
#include "placement/labels.h"
#include "placement/on_screen.h"
#include "placement/pills.h"
#include "placement/placer_state.h"

// Algorithm 1 of the paper, one parameter after the other: what is there is measured (measured.h), a place is chosen (chooser.h) against all that has
// landed before (occupied.h), and is written into the layout.

namespace dimline {

namespace {

HiddenReason reasonFor(const BaseLineTally& tally, bool anyScope) {
  if (!anyScope) return HiddenReason::kNoScope;
  // Of several scopes the one that came nearest to being shown says why.
  if (tally.foreshortened > 0) return HiddenReason::kForeshortened;
  if (tally.tooShort > 0) return HiddenReason::kTooShort;
  if (tally.occluded > 0) return HiddenReason::kOccluded;
  return HiddenReason::kOutOfView;
}

/// From the base line's end to the final line's, bent at the plane where the base line does not lie in it (paper 5, "Extension Lines").
void writeExtension(const Vec2& base, const Vec2& foot, const Vec2& end, ExtensionLine& polyline) {
  polyline.clear();
  polyline.push_back(base);
  if (foot != base) polyline.push_back(foot);
  polyline.push_back(end);
}

/// Moves an extension line that would lie on a dimension line a little towards the middle of its own line (paper 5, "Extension Lines").
void moveAside(ExtensionLine& extension, const Vec2& towardsMiddle, const Landed& landed) {
  bool onLine = false;
  for (std::size_t i = 1; i < extension.size(); ++i) onLine = onLine || landed.liesOnLine({extension[i - 1], extension[i]});
  const double length = glm::length(towardsMiddle);
  if (!onLine || length < 4 * kExtensionAsidePx) return;
  for (Vec2& p : extension) p += towardsMiddle * (kExtensionAsidePx / length);
}

/// Takes one out of the spare ones, with the memory that it holds, or makes one.
template <typename Thing>
Thing& append(std::vector<Thing>& to, std::vector<Thing>& spare) {
  if (spare.empty()) return to.emplace_back();
  to.push_back(std::move(spare.back()));
  spare.pop_back();
  return to.back();
}

/// The same for a parameter's handle: its own of an earlier frame if there is one, which has room for its choices.
PlacedHandle& append(std::vector<PlacedHandle>& to, std::vector<PlacedHandle>& spare, std::size_t parameter) {
  const auto own = std::ranges::find(spare, parameter, &PlacedHandle::parameter);
  if (own != spare.end()) std::swap(*own, spare.back());
  return append(to, spare);
}

/// Empties the list, keeping what was in it as spare: as many as two attempts can need (`most` in one), since whoever has the layout may have added to it.
template <typename Thing>
void recycle(std::vector<Thing>& list, std::vector<Thing>& spare, std::size_t most) {
  for (; !list.empty(); list.pop_back()) {
    if (spare.size() < 2 * most) spare.push_back(std::move(list.back()));
  }
}

}  // namespace

/// Places all lines, and before them the handles of which all others keep clear.
void Placer::State::placeAllLines(const FrameToPlace& frame, Layout& layout) {
  emptyLayout(layout);
  occupied.clear();
  // What is held stays where it is: shorter lines come before it, but must leave it room.
  for (const PlacedLine& line : frame.held) occupied.reserve(line);
  for (const Measured& other : others) {
    if (hasOnePlace(other)) placeOther(other, frame, layout);
  }
  outcome.begin(order.size(), kind);
  placeFrom(0, frame, layout);
}

/// An arc that stays in its scope's frame: all others keep clear of it.
bool Placer::State::hasOnePlace(const Measured& other) { return other.annotation.type == HandleType::kAngular && other.annotation.slip == Slip::kNone; }

/// In a smaller viewport a line that would run into another, or through a number, is not shown, and comes back when there has been room for it for a while.
bool Placer::State::hasRoomForLines(const View& view) const { return view.widthPx() * view.heightPx() >= kCrowdedPx2 * static_cast<double>(editable); }

/// Lines are bound to their planes; a switch finds a place nearly anywhere, so it takes what they leave, if there is any.
bool Placer::State::hasRoomForPills(const View& view) const { return view.widthPx() * view.heightPx() >= kPillsCrowdedPx2 * static_cast<double>(editable); }

void Placer::State::emptyLayout(Layout& layout) {
  recycle(layout.lines, spareLines, mostLines);
  spareHandles.reserve(2 * others.size());   // as recycle() keeps
  recycle(layout.others, spareHandles, others.size());
  layout.others.reserve(others.size());   // however many of them found no place until now
  layout.hidden.clear();
  layout.hidden.reserve(order.size() + others.size());   // however few of them found none
}

/// All that a frame's attempts are copied to and from gets as much room as any of it has.
void Placer::State::makeRoomForTurns() {
  const std::size_t count = (order.size() + turnsBetween() - 1) / turnsBetween();
  bestOccupied.makeRoomLike(occupied);
  occupied.makeRoomLike(bestOccupied);
  for (std::vector<Turn>* kept : {&turns, &bestTurns}) {
    kept->resize(count);
    for (Turn& turn : *kept) {
      turn.occupied.makeRoomLike(occupied.contents());
      turn.outcome.begin(order.size());
    }
  }
}

void Placer::State::keepTurn(std::size_t turn, const Layout& layout) {
  if (turn % turnsBetween() != 0) return;
  Turn& now = turns[turn / turnsBetween()];
  now.occupied = occupied.contents();
  now.outcome = outcome;
  now.lines = layout.lines.size();
  now.hidden = layout.hidden.size();
  now.noted = past.lookAhead.noted();
}

/// All stands as it stood in the best attempt when that turn came, which was kept.
void Placer::State::goOnFromBest(std::size_t turn, Layout& layout) {
  const Turn& then = bestTurns[turn / turnsBetween()];
  emptyLayout(layout);
  for (const PlacedLine& line : std::span(bestLayout.lines).first(then.lines)) append(layout.lines, spareLines) = line;
  for (const PlacedHandle& other : bestLayout.others) append(layout.others, spareHandles, other.parameter) = other;
  layout.hidden.assign(bestLayout.hidden.begin(), bestLayout.hidden.begin() + static_cast<std::ptrdiff_t>(then.hidden));
  occupied.goBackTo(then.occupied);
  outcome = then.outcome;
  past.lookAhead.noteAgain(bestPast.lookAhead, then.noted);
  const auto rememberAgain = [&](const Measured& measured) { past.histories[measured.parameter] = bestPast.histories[measured.parameter]; };
  for (const Measured& other : others) rememberAgain(other);
  for (const std::size_t rank : past.placingOrder.ranks().first(turn)) rememberAgain(order[rank]);
}

/// Places the lines whose turn has not come yet.
void Placer::State::placeFrom(std::size_t firstTurn, const FrameToPlace& frame, Layout& layout) {
  const auto& [view, fields, values, held, viewMoved] = frame;
  const ObjectPlanesInFrame object{objectPlanes, objectPlaneUses, toleranceM};
  const auto ranks = past.placingOrder.ranks();
  for (std::size_t turn = firstTurn; turn < ranks.size(); ++turn) {
    if (keepsTurns) keepTurn(turn, layout);
    const std::size_t rank = ranks[turn];
    Measured& measured = order[rank];
    past.lookAhead.reach(rank);
    const auto inHand = std::ranges::find(held, measured.parameter, &PlacedLine::parameter);
    const bool isHeld = inHand != held.end();
    if (isHeld) occupied.release(*inHand);
    if (isHeld && !(inHand->chain >= 0 && measured.scopes.size() > 1)) {
      landHeld(measured, *inHand, layout);
      continue;
    }
    const AvoidedPlace* avoid = !avoided.empty() && avoided[rank].any() ? &avoided[rank] : nullptr;
    ChoiceContext context = contextOf(frame, object, measured, avoid);
    if (isHeld) {
      hold(*inHand);
      context.inHand = &inHand->line;
    }
    placeLines(rank, context, values.at(measured.parameter), layout);
    if (isHeld) occupied.reserve(*inHand);
  }
}

/// Places what takes the room that the lines leave, once a frame: no attempt is judged by it.
void Placer::State::placeBesideLines(const FrameToPlace& frame, Layout& layout) {
  for (const std::size_t number : past.othersOrder) {
    const Measured& other = others[number];
    if (hasRoomForPills(frame.view) || other.annotation.type == HandleType::kAngular) {
      placeOther(other, frame, layout);
    } else {
      layout.hidden.push_back({other.parameter, other.scopes.empty() ? HiddenReason::kNoScope : HiddenReason::kCrowded});
      past.histories[other.parameter].choseNone(true);
    }
  }
}

/// Places what has no handle yet, whatever it is hidden for, beside all that has one.
void Placer::State::placeAllHidden(const FrameToPlace& frame, Layout& layout) {
  const std::size_t shown = layout.lines.size();
  std::swap(wanting, layout.hidden);
  layout.hidden.clear();
  const auto placeOthers = [&](bool withOnePlace) {
    for (const Measured& other : others) {
      if (hasOnePlace(other) == withOnePlace && isHidden(wanting, other.parameter)) placeOther(other, frame, layout);
    }
  };
  placeOthers(true);
  const ObjectPlanesInFrame object{objectPlanes, objectPlaneUses, toleranceM};
  for (const std::size_t rank : past.placingOrder.ranks()) {
    const Measured& measured = order[rank];
    past.lookAhead.reach(rank);
    if (isHidden(wanting, measured.parameter)) placeLines(rank, contextOf(frame, object, measured, nullptr), frame.values.at(measured.parameter), layout);
  }
  placeOthers(false);
  labelInside(frame, std::span(layout.lines).subspan(shown));
}

ChoiceContext Placer::State::contextOf(const FrameToPlace& frame, const ObjectPlanesInFrame& object, const Measured& measured, const AvoidedPlace* avoid) {
  return {frame.view, frame.fields, occupied, past.lookAhead, past.labels, object, foresight, scopes, usableScopes(measured), past.sights, toleranceM, frame.viewMoved,
          firm, patient(), avoid, nullptr, asksForRoom, kind, outcome.tangles == 0 && past.calmFrames == kCalmFrames, showAll};
}

/// Lines inside the model get their labels last, where there is room for them: such a line says what it is by where it lies, and all else has no other way to say it.
void Placer::State::labelInside(const FrameToPlace& frame, std::span<PlacedLine> lines) {
  for (PlacedLine& line : lines) {
    if (line.placement != PlacementKind::kInside || line.label) continue;
    const auto measured = std::ranges::find(order, line.parameter, &Measured::parameter);
    LabelRequest request{.line = line.lineScreen, .textSize = measured->textSize, .last = past.labels.last(line.identity, 0, frame.viewMoved)};
    auto found = placeLabel(request, occupied.landed(), frame.view.viewport());
    request.overExtensions = true;
    if (!found) found = placeLabel(request, occupied.landed(), frame.view.viewport());
    if (!found) continue;
    line.label = found->box;
    line.labelPlace = found->place;
    occupied.add(found->box);
  }
}

/// The scopes that may carry a line of this parameter in this frame; one a scope.
std::span<const char> Placer::State::usableScopes(const Measured& measured) const {
  if (!measured.annotation.occlusion || showAll) return inView;
  return past.histories[measured.parameter].shownAnew() ? seenEnough : seen;
}

BaseLineTally Placer::State::scopesOutOfSight(const Measured& measured) const {
  BaseLineTally tally;
  for (const std::size_t scope : measured.scopes) {
    if (usableScopes(measured)[scope] == 0) ++(inView[scope] != 0 ? tally.occluded : tally.outOfView);
  }
  return tally;
}

void Placer::State::placeLines(std::size_t rank, const ChoiceContext& context, double value, Layout& layout) {
  Measured& measured = order[rank];
  History& history = past.histories[measured.parameter];
  label(measured, parameters[measured.parameter], value);
  const bool found = chooser.choose(measured, context, history);
  // A line of what is not in plain view comes, inside the model, or comes back after it gave way to others or went lately, when it has had a place for a while: it may have one for a moment only.
  const bool comes = history.hiddenForWantOfRoom() || history.wentLately() || (history.hidden() && chooser.winner().placement == PlacementKind::kInside);
  const bool mayGiveWay = found && !showAll && !hasRoomForLines(context.view);
  const bool givesWay = mayGiveWay && chooser.cramped(), hadNoRoom = mayGiveWay && history.hiddenForWantOfRoom();
  const int patienceFrames = hadNoRoom ? kPatienceSmallViewportFrames : kPatienceFrames;
  const bool waits = found && !givesWay && patient() && comes && (hadNoRoom || !context.inPlainView(chooser.winner().scope)) && !history.betterIsThere(patienceFrames);
  if (!found || givesWay || waits) {
    BaseLineTally tally = scopesOutOfSight(measured);
    tally.add(chooser.tally());
    // Who waits is not in plain view, or had no room.
    const auto waitsFor = [&] { return wholeInView(context.view, scopes[chooser.winner().scope].box) ? HiddenReason::kOccluded : HiddenReason::kOutOfView; };
    layout.hidden.push_back({measured.parameter, givesWay || hadNoRoom ? HiddenReason::kCrowded : waits ? waitsFor() : reasonFor(tally, !measured.scopes.empty())});
    const bool forWantOfRoom = waits || chooser.cramped();
    if (forWantOfRoom) judgeHidden(history);
    history.choseNone(forWantOfRoom);
    return;
  }
  judgeChoice(rank, history);
  const Candidate& winner = chooser.winner();
  history.choose(winner.identity, winner.placement == PlacementKind::kOutside ? winner.offsetM : -1,
                 away(winner.baseScreen, winner.lineScreen));
  if (context.avoid != nullptr) history.prefer();
  landChoice(measured, value, layout);
  noteChoice(measured);
}

/// Says where the choice lies to those who come before it in the next frame. One that gave way to a label asks for the room where it would have lain, and looks there again.
void Placer::State::noteChoice(const Measured& measured) {
  const auto wished = chooser.wished();
  for (const ChosenLine& line : wished.empty() ? chooser.lines() : wished) {
    if (chooser.winner().placement == PlacementKind::kInside) {
      past.lookAhead.noteInside(measured.parameter, line.base);
    } else {
      past.lookAhead.note(measured.parameter, line.base, line.foot, line.line);
    }
  }
  if (!wished.empty()) past.histories[measured.parameter] = History(static_cast<std::int32_t>(measured.parameter));
}

/// Adds what the choice is worth, and what is amiss with it, to the frame's outcome.
void Placer::State::judgeChoice(std::size_t rank, const History& history) {
  const Candidate& winner = chooser.winner();
  const auto [score, tangle, nestsWrongly] = chooser.worth(occupied.landed());
  outcome.worth += score;
  outcome.outside[rank] = winner.placement != PlacementKind::kInside ? 1 : 0;
  outcome.tangles += tangle.lines;
  if (nestsWrongly) {
    outcome.amiss[rank] = 1;
    ++outcome.nestedWrongly;
  }
  if (tangle.lines > 0) {
    outcome.amiss[rank] = 1;
    const auto other = std::ranges::find(order, static_cast<std::size_t>(tangle.parameter), &Measured::parameter);
    if (tangle.parameter >= 0 && other != order.end()) {
      const auto otherRank = static_cast<std::size_t>(other - order.begin());
      outcome.amiss[otherRank] = 1;
      outcome.tangled.emplace_back(otherRank, rank);
    }
  }
  if (history.any() && !history.stays(winner.identity, away(winner.baseScreen, winner.lineScreen))) {
    outcome.changes += history.last() == winner.identity ? kChangesOfLeap : winner.passing ? kChangesOfPassing : 1.0;
    outcome.changed[rank] = 1;
    if (history.leftLately(winner.identity)) {
      ++outcome.returns;
      outcome.returned = rank;
    }
  }
}

/// Adds that a line has no room: it counts as one inside, or an attempt would gain by hiding it.
void Placer::State::judgeHidden(const History& history) {
  outcome.worth += kScoreInside;
  if (history.any()) outcome.changes += 1;
}

/// Writes the chosen lines into the layout.
void Placer::State::landChoice(const Measured& measured, double value, Layout& layout) {
  const Candidate& winner = chooser.winner();
  const bool inside = winner.placement == PlacementKind::kInside;
  // The guide that they lie on: the one they snapped to, or a new one. Lines inside the model make none.
  const int guide = inside ? -1 : winner.guide >= 0 ? winner.guide : occupied.addGuide(winner.plane.plane, winner.line);
  for (const ChosenLine& chosen : chooser.lines()) {
    PlacedLine& line = append(layout.lines, spareLines);
    line.parameter = measured.parameter;
    line.scope = chosen.scope;
    line.identity = winner.identity;
    line.identity.scopeIndex = static_cast<std::int32_t>(scopes[chosen.scope].index);
    line.type = measured.annotation.type;
    line.placement = winner.placement;
    line.planeKind = winner.plane.kind;
    line.facing = winner.plane.facing;
    line.plane = winner.plane.plane;
    line.base = chosen.base;
    line.foot = chosen.foot;
    line.line = chosen.line;
    line.baseScreen = chosen.baseScreen;
    line.lineScreen = chosen.lineScreen;
    line.extensionStart.clear();
    line.extensionEnd.clear();
    if (!inside) {
      writeExtension(chosen.baseScreen.start, chosen.footScreen.start, chosen.lineScreen.start, line.extensionStart);
      writeExtension(chosen.baseScreen.end, chosen.footScreen.end, chosen.lineScreen.end, line.extensionEnd);
      const Vec2 along = chosen.lineScreen.end - chosen.lineScreen.start;
      moveAside(line.extensionStart, along, occupied.landed());
      moveAside(line.extensionEnd, -along, occupied.landed());
    }
    // A parameter has at most one chain in a frame, so its number says which chain it is.
    line.chain = winner.identity.chain >= 0 ? static_cast<std::int32_t>(measured.parameter) : -1;
    line.indirect = measured.annotation.indirect;
    line.look = {measured.annotation.skin, measured.annotation.color};
    line.lengthM = chosen.base.length();
    line.value = value;
    line.text = measured.text;
    line.label = chosen.label;
    line.labelPlace = chosen.labelPlace;
    line.handles.clear();
    const bool measure = parameters[measured.parameter].measure;
    if (!measure) line.handles.push_back({true, chosen.lineScreen.end});
    if (!measure && measured.annotation.ends == HandleEnds::kBoth) line.handles.push_back({false, chosen.lineScreen.start});
    occupied.add(line, guide);
  }
}

/// Remembers where a line lies that is being dragged, for when it is let go of.
void Placer::State::hold(const PlacedLine& held) {
  const Vec3 along = unitOrZero(held.line.end - held.line.start);
  const Vec3 fromFoot = held.line.start - held.foot.start;
  Identity place = held.identity;
  if (place.chain >= 0) place.scopeIndex = -1;   // that of the chain, not of its member
  past.histories[held.parameter].hold(place, glm::length(fromFoot - along * glm::dot(fromFoot, along)));
}

/// A line that is being dragged stays on its carrier, whatever this frame would have chosen for it.
void Placer::State::landHeld(Measured& measured, const PlacedLine& held, Layout& layout) {
  label(measured, parameters[held.parameter], held.value);
  hold(held);
  if (held.placement != PlacementKind::kInside) {
    past.lookAhead.note(held.parameter, held.base, held.foot, held.line);
  } else {
    past.lookAhead.noteInside(held.parameter, held.base);
  }
  PlacedLine& line = append(layout.lines, spareLines);
  line = held;
  straighten(line);
  occupied.add(line, guideThrough(line));
}

/// The guide that a line lies on, a new one if there is none; -1 inside the model.
int Placer::State::guideThrough(const PlacedLine& line) {
  if (line.placement == PlacementKind::kInside) return -1;
  const int guide = occupied.guides().through(line.line, line.plane, toleranceM);
  return guide >= 0 ? guide : occupied.addGuide(line.plane, line.line);
}

void Placer::State::placeOther(const Measured& measured, const FrameToPlace& frame, Layout& layout) {
  const std::span<const char> usable = usableScopes(measured);
  scopesInSight.clear();
  std::ranges::copy_if(measured.scopes, std::back_inserter(scopesInSight), [&](std::size_t scope) { return usable[scope] != 0; });
  History& history = past.histories[measured.parameter];
  const OtherHandle handle{measured.parameter, parameters[measured.parameter], measured.annotation, scopesInSight,
                           frame.values.at(measured.parameter), history, firm && !showAll && !kind.settles, foresight.nears(), showAll, frame.viewMoved, kind.settles && !showAll};
  const OtherHandleContext context{frame.view, occupied.paddedModel(), occupied.padded(), occupied.landed(), scopes};
  PlacedHandle& placed = append(layout.others, spareHandles, measured.parameter);
  placed.parameter = measured.parameter;
  const auto missing =
      measured.annotation.type == HandleType::kAngular ? placeArc(handle, context, placed) : placePill(handle, context, placed);
  if (!missing) {
    const Vec2 awayPx = placed.arc ? Vec2(0.0) : placed.box.center() - placed.anchor;
    history.choose(placed.identity, -1, {awayPx, awayPx});
    occupied.add(placed, frame.view);
    return;
  }
  spareHandles.push_back(std::move(placed));
  layout.others.pop_back();
  const HiddenReason unseen = reasonFor(scopesOutOfSight(measured), !measured.scopes.empty());
  const HiddenReason reason = scopesInSight.empty() ? unseen : *missing;
  layout.hidden.push_back({measured.parameter, reason});
  history.choseNone(reason == HiddenReason::kCrowded);
}

}  // namespace dimline
