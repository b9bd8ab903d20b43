#include "placement/placer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/sort_keys.h"
#include "placement/arcs.h"
#include "placement/chooser.h"
#include "placement/foresight.h"
#include "placement/label_memory.h"
#include "placement/labels.h"
#include "placement/mending.h"
#include "placement/on_screen.h"
#include "placement/pills.h"
#include "placement/visibility.h"

// Algorithm 1 of the paper, one parameter after the other: what is there is measured (measured.h), a place is chosen (chooser.h) against all that has
// landed before (occupied.h), and is written into the layout. While only the camera moves, lines keep their places and what can be done better is mended
// little by little (mending.h).

namespace dimline {

namespace {

HiddenReason reasonFor(const BaseLineTally& tally, bool anyScope) {
  if (!anyScope) return HiddenReason::kNoScope;
  if (tally.occluded > 0) return HiddenReason::kOccluded;
  if (tally.foreshortened > 0) return HiddenReason::kForeshortened;
  if (tally.tooShort > 0) return HiddenReason::kTooShort;
  return HiddenReason::kOutOfView;
}

/// From the base line's end to the final line's, bent at the plane where the base line does not lie in it (paper 5, "Extension Lines").
void writeExtension(const Vec2& base, const Vec2& foot, const Vec2& end, std::vector<Vec2>& polyline) {
  polyline.clear();
  polyline.reserve(3);   // of a line that is not bent as well: the next to use this memory may be
  polyline.push_back(base);
  if (foot != base) polyline.push_back(foot);
  polyline.push_back(end);
}

/// Moves an extension line that would lie on a dimension line a little towards the middle of its own line (paper 5, "Extension Lines").
void moveAside(std::vector<Vec2>& extension, const Vec2& towardsMiddle, const Landed& landed) {
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

bool sameScope(const Scope& a, const Scope& b) {
  return a.name == b.name && a.index == b.index && a.box.origin == b.box.origin && a.box.axes == b.box.axes && a.box.size == b.box.size;
}

/// What is to be placed in a frame.
struct FrameToPlace {
  const View& view;
  const DistanceFields& fields;
  const Values& values;
  std::span<const PlacedLine> held;
  bool viewMoved = false;   ///< since the last frame
};

/// Empties the list, keeping what was in it as spare.
template <typename Thing>
void recycle(std::vector<Thing>& list, std::vector<Thing>& spare) {
  for (; !list.empty(); list.pop_back()) spare.push_back(std::move(list.back()));
}

}  // namespace

struct Placer::State {
  std::vector<Parameter> parameters;
  std::vector<Scope> scopes;
  Bounds bounds;                      ///< of the model (m)
  double toleranceM = 0;              ///< kSamePlaneDistance of its size
  std::vector<Measured> order;        ///< those with dimension lines, shortest first
  std::vector<Measured> others;       ///< those with other handles, in the order of their definition
  std::size_t editable = 0;           ///< how many of both can be edited; the other ones are measures
  std::vector<ObjectPlane> objectPlanes;

  /// What is remembered of the frames before.
  struct Past {
    std::vector<History> histories;   ///< one a parameter
    std::vector<Sight> sights;        ///< one a scope
    LookAhead lookAhead;
    LabelMemory labels;
    Mending mending;
    bool held = false;                ///< whether a line was held in the last frame
    std::optional<View> view;         ///< of the last frame
    std::size_t crowded = 0;          ///< how many of the shortest lines are hidden for want of room
    int crowdedFrames = kReturnFrames;   ///< moved frames since that many were found to be too few
    bool sceneChanged = false;        ///< since the last frame
  };
  Past past;
  bool showHidden = false;
  Past beforePlacing;                 ///< in a viewport that may be too small: what to go back to
  Outcome outcome;
  bool firm = false;                  ///< see ChoiceContext
  bool asksForRoom = false;           ///< see ChoiceContext
  struct Avoided {
    std::size_t rank = 0;
    Identity place;
  };
  std::optional<Avoided> avoided;     ///< by the line of that rank, in an attempt to find another place for it

  // The best attempt at this frame so far, while another is made; and what all of them begin with.
  Past bestPast;
  Outcome bestOutcome;
  Layout bestLayout;
  Past beforeAttempts;

  // Memory of one frame, kept so that the next allocates nothing.
  Occupied occupied;
  Chooser chooser;
  Foresight foresight;
  std::vector<ObjectPlaneUse> objectPlaneUses;
  std::vector<char> inView;           ///< one a scope
  std::vector<char> seen;             ///< one a scope: in view, and not hidden by the model
  std::vector<char> plain;            ///< those of them that what is hidden may be shown for
  std::vector<std::size_t> scopesInSight;
  std::vector<PlacedLine> spareLines;
  std::vector<PlacedHandle> spareHandles;

  void keepChains(std::span<const Measured> before, const Measured& now);
  bool beginFrame(const View& view);
  void placeOnce(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout);
  void noteChoice(const Measured& measured);
  void mend(const FrameToPlace& frame, Layout& layout);
  void swapWithBest(Layout& layout);
  void placeWithRoom(const FrameToPlace& frame, Layout& layout);
  bool placeAll(const FrameToPlace& frame, std::size_t crowded, Layout& layout);
  void findVisible(const View& view, const ScopeVisibility* visibility, int framesOn);
  [[nodiscard]] std::span<const char> usableScopes(const Measured& measured) const {
    if (!measured.annotation.occlusion || showHidden) return inView;
    return past.histories[measured.parameter].shownAnew() ? plain : seen;
  }
  [[nodiscard]] BaseLineTally scopesOutOfSight(const Measured& measured) const;
  void labelInside(const FrameToPlace& frame, Layout& layout);
  bool placeLines(std::size_t rank, const ChoiceContext& context, double value, Layout& layout);
  void judgeChoice(std::size_t rank, const History& history);
  void landChoice(const Measured& measured, double value, Layout& layout);
  void landHeld(Measured& measured, const PlacedLine& held, Layout& layout);
  void placeOther(const Measured& measured, const View& view, double value, Layout& layout);
};

Placer::Placer() : state_(std::make_unique<State>()) {}
Placer::~Placer() = default;
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;

void Placer::forget() {
  State::Past& past = state_->past;
  for (std::size_t i = 0; i < past.histories.size(); ++i) past.histories[i] = History(static_cast<std::int32_t>(i));
  past.lookAhead.forget();
  past.labels.forget();
  past.mending = {};
  past.sights.clear();
  past.held = false;
  past.view.reset();
  past.crowded = 0;
  past.crowdedFrames = kReturnFrames;
}

struct Placer::Memory::Content {
  State::Past past;
};

Placer::Memory Placer::memory() const {
  Memory memory;
  memory.content_ = std::make_shared<const Memory::Content>(Memory::Content{state_->past});
  return memory;
}

void Placer::recall(const Memory& memory) {
  if (memory.content_ == nullptr || memory.content_->past.histories.size() != state_->past.histories.size()) return;
  state_->past = memory.content_->past;
}

void Placer::awaitFields() { state_->past.sceneChanged = state_->past.sceneChanged || !state_->firm; }

void Placer::showHidden(bool shown) { state_->showHidden = shown; }

void Placer::setScene(const Model& model, const Scene& scene) {
  State& s = *state_;
  // With measures a model has more parameters, and without them fewer; those that it has in both cases keep their places.
  const std::span<const Parameter> parameters(model.parameters().begin(), model.parameters().end());
  const std::size_t common = std::min(s.parameters.size(), parameters.size());
  const bool sameModel = common > 0 && std::ranges::equal(std::span(s.parameters).first(common), parameters.first(common), {}, &Parameter::name, &Parameter::name) &&
                         std::ranges::all_of(std::span(s.parameters).subspan(common), &Parameter::measure) &&
                         std::ranges::all_of(parameters.subspan(common), &Parameter::measure);
  // A measure's own scope comes after all others.
  const std::size_t scopes = std::min(s.scopes.size(), scene.scopes.size());
  const bool edited = !sameModel || s.parameters.size() == parameters.size() ||
                      !std::ranges::equal(std::span(s.scopes).first(scopes), std::span(scene.scopes).first(scopes), sameScope);
  if (edited && s.scopes.size() != scene.scopes.size()) s.past.sights.clear();
  s.scopes = scene.scopes;
  s.bounds = scene.bounds;
  s.toleranceM = kSamePlaneDistance * scene.bounds.diagonal();
  s.parameters.assign(parameters.begin(), parameters.end());
  if (!sameModel) {
    s.past.histories.assign(s.parameters.size(), History(-1));
    forget();
  } else if (s.past.histories.size() != s.parameters.size()) {
    s.past.histories.resize(common, History(-1));
    while (s.past.histories.size() < s.parameters.size()) s.past.histories.push_back(History(static_cast<std::int32_t>(s.past.histories.size())));
    s.past.lookAhead.forget();
    s.past.mending = {};
  }
  if (edited) {
    for (History& history : s.past.histories) history.forgetOffset();
    s.past.sceneChanged = true;
  }
  const std::vector<Measured> before = std::exchange(s.order, {});
  s.others.clear();
  std::vector<Measured> lines;
  std::array<std::vector<SortKey>, 2> byLength;   // of those that can be edited; of those that are only read, which take no place from the former
  for (Measured& measured : measure(model, s.scopes, s.bounds.diagonal())) {
    if (sameModel) s.keepChains(before, measured);
    if (isLine(measured.annotation.type)) {
      byLength[s.parameters[measured.parameter].measure ? 1 : 0].push_back({measured.meanLengthM, static_cast<std::uint32_t>(lines.size())});
      lines.push_back(std::move(measured));
    } else {
      s.others.push_back(std::move(measured));
    }
  }
  const auto appendSorted = [&](std::vector<SortKey>& keys) {
    sortKeys(keys);
    for (const SortKey& key : keys) s.order.push_back(std::move(lines[key.index]));
  };
  s.editable = byLength[0].size() + s.others.size();
  appendSorted(byLength[0]);
  s.objectPlanes = objectPlanes(fixedBaseLines(s.order, s.scopes), scene.bounds);
  appendSorted(byLength[1]);
}

/// In a model that an edit has rebuilt, chains are known by the clusters that theirs have become. As many clusters as before are the same ones.
void Placer::State::keepChains(std::span<const Measured> before, const Measured& now) {
  const auto was = std::ranges::find(before, now.parameter, &Measured::parameter);
  if (was == before.end() || was->clusters.size() == now.clusters.size()) return;
  const auto numberNow = [&](std::int32_t number) {
    const auto old = static_cast<std::size_t>(number);
    return old < was->clusters.size() ? successor(was->clusters[old], now.clusters) : -1;
  };
  past.histories[now.parameter].renumberChains(numberNow);
  past.labels.renumberChains(static_cast<std::int32_t>(now.parameter), numberNow);
}

void Placer::place(const View& view, const DistanceFields& fields, const Values& values, Layout& layout,
                   const ScopeVisibility* visibility, std::span<const PlacedLine> held) {
  State& s = *state_;
  const double turnRad = s.past.view ? turnBetween(*s.past.view, view) : 0.0;
  if (turnRad > kForgetTurnRad) forget();
  const bool first = !s.past.view;
  const bool sceneChanged = std::exchange(s.past.sceneChanged, false);
  // An edit is not part of the movement before it.
  s.foresight.begin(sceneChanged ? std::nullopt : s.past.view, view, s.bounds, s.objectPlanes, s.toleranceM);
  const bool viewMoved = s.beginFrame(view);
  // In another scene a scope has no past: what an edit covers is hidden at once, and what it lays open is shown.
  s.findVisible(view, visibility, sceneChanged ? kReturnFrames : viewMoved ? std::max(static_cast<int>(turnRad / kFrameTurnRad), 1) : 0);
  facePlanes(s.objectPlanes, view, s.objectPlaneUses);

  const FrameToPlace frame{view, fields, values, held, viewMoved};
  // What was edited, and a line that was let go of, may find another place at once.
  const bool wasHeld = std::exchange(s.past.held, !held.empty());
  s.firm = !sceneChanged && held.empty() && !wasHeld;
  s.occupied.begin(fields);
  // In a first picture nothing is known of what is ahead, and little is mended: more rounds of the same view make up for that.
  const int rounds = first && held.empty() ? kFirstPictureRounds : 1;
  s.asksForRoom = rounds > 1;
  s.placeOnce(frame, sceneChanged, true, layout);
  const bool firm = s.firm;
  for (int round = 1; round < rounds; ++round) {
    s.firm = true;
    s.asksForRoom = round + 1 < rounds;
    for (History& history : s.past.histories) history.age();
    s.placeOnce(frame, false, false, layout);
  }
  s.firm = firm;
  s.past.labels.note(layout.lines, viewMoved);

  layout.view = view;
  layout.visibleScopes.clear();
  for (std::size_t i = 0; i < s.scopes.size(); ++i) {
    if (s.seen[i] != 0) layout.visibleScopes.push_back(i);
  }
}

/// A round of placing everything, and of mending it where lines keep their places. `shown`: what was placed before.
void Placer::State::placeOnce(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout) {
  past.lookAhead.begin(order, frame.view, frame.fields, frame.viewMoved || sceneChanged, shown);
  const bool mends = firm && frame.viewMoved;
  if (mends) beforeAttempts = past;
  placeWithRoom(frame, layout);
  if (mends) mend(frame, layout);
}

/// Other attempts at the frame that has been placed, in each of which one line must find another place; the best one stays.
void Placer::State::mend(const FrameToPlace& frame, Layout& layout) {
  Mending mending = past.mending;
  mending.begin();
  while (const auto rank = mending.next(outcome)) {
    avoided = {*rank, past.histories[order[*rank].parameter].last()};
    swapWithBest(layout);
    past = beforeAttempts;
    placeWithRoom(frame, layout);
    avoided.reset();
    // One that has no other place outside would be back in its own in the next frame.
    if (outcome.outside[*rank] == 0 || !outcome.betterThan(bestOutcome)) swapWithBest(layout);
  }
  past.mending = mending;
}

void Placer::State::swapWithBest(Layout& layout) {
  std::swap(bestPast, past);
  std::swap(bestOutcome, outcome);
  std::swap(bestLayout, layout);
}

/// Places everything, but as many of the shortest lines as have to go in a small viewport.
void Placer::State::placeWithRoom(const FrameToPlace& frame, Layout& layout) {
  const View& view = frame.view;
  const auto roomFor = static_cast<std::size_t>(std::ceil(view.widthPx() * view.heightPx() / kCrowdedPx2));
  const std::size_t mostCrowded = showHidden || roomFor >= editable ? 0 : std::min(editable - roomFor, order.size());
  std::size_t crowded = std::min(past.crowded, mostCrowded);
  // Now and then it is tried whether one that was hidden has room again.
  if (crowded > 0 && frame.viewMoved && past.crowdedFrames >= kReturnFrames) --crowded;
  if (mostCrowded > 0) beforePlacing = past;
  bool tooFew = false;
  while (placeAll(frame, crowded, layout) && crowded < mostCrowded) {
    past = beforePlacing;
    ++crowded;
    tooFew = true;
  }
  past.crowded = crowded;
  past.crowdedFrames = tooFew ? 0 : std::min(past.crowdedFrames + (frame.viewMoved ? 1 : 0), kReturnFrames);
}

/// Ages what is remembered. Returns whether the view has changed since the last frame.
bool Placer::State::beginFrame(const View& view) {
  const bool moved = !past.view || !samePicture(view, *past.view);
  // An offset of so many metres is another on screen in a viewport of another size.
  const bool resized = past.view && (view.widthPx() != past.view->widthPx() || view.heightPx() != past.view->heightPx());
  past.view = view;
  for (History& history : past.histories) {
    if (moved) history.age();
    if (resized) history.forgetOffset();
  }
  return moved;
}

/// Places everything but the `crowded` shortest lines. Returns whether a line runs into another.
bool Placer::State::placeAll(const FrameToPlace& frame, std::size_t crowded, Layout& layout) {
  const auto& [view, fields, values, held, viewMoved] = frame;
  recycle(layout.lines, spareLines);
  spareHandles.reserve(others.size());
  recycle(layout.others, spareHandles);
  layout.others.reserve(others.size());   // however many of them found no place until now
  layout.hidden.clear();
  occupied.clear();
  // What is held stays where it is: shorter lines come before it, but must leave it room.
  for (const PlacedLine& line : held) occupied.reserve(line);
  // An arc that stays in its scope's frame has one place only, so all others keep clear of it.
  const auto stays = [](const Measured& other) { return other.annotation.type == HandleType::kAngular && other.annotation.slip == Slip::kNone; };
  for (const Measured& other : others) {
    if (stays(other)) placeOther(other, view, values.at(other.parameter), layout);
  }
  outcome.begin(order.size());
  bool cramped = false;
  const ObjectPlanesInFrame object{objectPlanes, objectPlaneUses, toleranceM};
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    Measured& measured = order[rank];
    past.lookAhead.reach(rank);
    const auto inHand = std::ranges::find(held, measured.parameter, &PlacedLine::parameter);
    const bool isHeld = inHand != held.end();
    if (isHeld) occupied.release(*inHand);
    if (isHeld && !(inHand->chain >= 0 && measured.scopes.size() > 1)) {
      landHeld(measured, *inHand, layout);
      continue;
    }
    if (rank < crowded) {
      layout.hidden.push_back({measured.parameter, HiddenReason::kCrowded});
      // Or an attempt would gain by crowding a line out.
      outcome.worth += kScoreInside;
      if (past.histories[measured.parameter].any()) outcome.changes += 1;
      past.histories[measured.parameter].choseNone();
    } else {
      const Identity* avoid = avoided && avoided->rank == rank ? &avoided->place : nullptr;
      const bool runsInto = placeLines(rank,
                                       {view, fields, occupied, past.lookAhead, past.labels, object, foresight, scopes, usableScopes(measured), past.sights, object.toleranceM, viewMoved,
                                        firm, avoid, asksForRoom, showHidden},
                                       values.at(measured.parameter), layout);
      // A measure takes no place from what can be edited.
      cramped |= runsInto && !parameters[measured.parameter].measure;
    }
    if (isHeld) occupied.reserve(*inHand);
  }
  // Lines are bound to their planes; a switch finds a place nearly anywhere, so it takes what they leave.
  const bool noPills = !showHidden && view.widthPx() * view.heightPx() < kPillsCrowdedPx2 * static_cast<double>(editable);
  for (const Measured& other : others) {
    if (stays(other)) continue;
    if (noPills && other.annotation.type != HandleType::kAngular) {
      layout.hidden.push_back({other.parameter, HiddenReason::kCrowded});
      past.histories[other.parameter].choseNone(true);
    } else {
      placeOther(other, view, values.at(other.parameter), layout);
    }
  }
  labelInside(frame, layout);
  return cramped;
}

/// Lines inside the model get their labels last, where there is room for them: such a line says what it is by where it lies, and all else has no other way to say it.
void Placer::State::labelInside(const FrameToPlace& frame, Layout& layout) {
  for (PlacedLine& line : layout.lines) {
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

void Placer::State::findVisible(const View& view, const ScopeVisibility* visibility, int framesOn) {
  assert(visibility == nullptr || visibility->seenShare.size() == scopes.size());
  inView.resize(scopes.size());
  seen.resize(scopes.size());
  plain.resize(scopes.size());
  past.sights.resize(scopes.size());
  for (std::size_t i = 0; i < scopes.size(); ++i) {
    Sight& sight = past.sights[i];
    inView[i] = dimline::inView(view, scopes[i].box) ? 1 : 0;
    if (inView[i] == 0) sight = {};
    sight.age(framesOn);
    seen[i] = inView[i] != 0 && sight.see(visibility != nullptr ? static_cast<double>(visibility->seenShare[i]) : 1.0) ? 1 : 0;
    plain[i] = seen[i] != 0 && sight.plain() ? 1 : 0;
  }
}

BaseLineTally Placer::State::scopesOutOfSight(const Measured& measured) const {
  BaseLineTally tally;
  for (const std::size_t scope : measured.scopes) {
    if (usableScopes(measured)[scope] == 0) ++(inView[scope] != 0 ? tally.occluded : tally.outOfView);
  }
  return tally;
}

/// Returns whether the line runs into another.
bool Placer::State::placeLines(std::size_t rank, const ChoiceContext& context, double value, Layout& layout) {
  Measured& measured = order[rank];
  History& history = past.histories[measured.parameter];
  label(measured, parameters[measured.parameter], value);
  const bool found = chooser.choose(measured, context, history);
  // A line inside the model that is cut off comes, or comes back after it gave way to others, when it has had a place for a while: at the picture's rim it may have one for a moment only. What an edit brings is shown at once.
  const bool comes = history.hiddenForWantOfRoom() || (firm && history.hidden() && chooser.winner().placement == PlacementKind::kInside);
  const bool waits = found && !showHidden && comes && !isWhole(chooser.winner().baseScreen, context.view) && !history.betterIsThere();
  if (!found || waits) {
    BaseLineTally tally = scopesOutOfSight(measured);
    tally.add(chooser.tally());
    layout.hidden.push_back({measured.parameter, reasonFor(tally, !measured.scopes.empty())});
    history.choseNone(waits || chooser.cramped());
    return false;
  }
  judgeChoice(rank, history);
  const Candidate& winner = chooser.winner();
  history.choose(winner.identity, winner.placement == PlacementKind::kOutside ? winner.offsetM : -1,
                 away(winner.baseScreen, winner.lineScreen));
  if (context.avoid != nullptr) history.prefer();
  landChoice(measured, value, layout);
  noteChoice(measured);
  return chooser.cramped();
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
  const auto [score, tangle, nestsWithin] = chooser.worth(occupied.landed());
  outcome.worth += score;
  outcome.outside[rank] = winner.placement != PlacementKind::kInside ? 1 : 0;
  if (nestsWithin) outcome.amiss[rank] = 1;
  if (tangle.lines > 0) {
    outcome.amiss[rank] = 1;
    const auto other = std::ranges::find(order, static_cast<std::size_t>(tangle.parameter), &Measured::parameter);
    if (tangle.parameter >= 0 && other != order.end()) outcome.amiss[static_cast<std::size_t>(other - order.begin())] = 1;
  }
  if (history.any() && !history.stays(winner.identity, away(winner.baseScreen, winner.lineScreen))) {
    outcome.changes += 1;
    outcome.changed[rank] = 1;
    if (history.leftLately(winner.identity)) outcome.changes += kChangesOfReturn;
  }
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

/// A line that is being dragged stays on its carrier, whatever this frame would have chosen for it.
void Placer::State::landHeld(Measured& measured, const PlacedLine& held, Layout& layout) {
  label(measured, parameters[held.parameter], held.value);
  past.histories[held.parameter].choose(held.identity, -1, away(held.baseScreen, held.lineScreen));
  int guide = -1;
  if (held.placement != PlacementKind::kInside) {
    guide = occupied.guides().through(held.line, held.plane, toleranceM);
    if (guide < 0) guide = occupied.addGuide(held.plane, held.line);
    past.lookAhead.note(held.parameter, held.base, held.foot, held.line);
  } else {
    past.lookAhead.noteInside(held.parameter, held.base);
  }
  PlacedLine& line = append(layout.lines, spareLines);
  line = held;
  occupied.add(line, guide);
}

void Placer::State::placeOther(const Measured& measured, const View& view, double value, Layout& layout) {
  const std::span<const char> usable = usableScopes(measured);
  scopesInSight.clear();
  std::ranges::copy_if(measured.scopes, std::back_inserter(scopesInSight), [&](std::size_t scope) { return usable[scope] != 0; });
  History& history = past.histories[measured.parameter];
  const OtherHandle handle{measured.parameter, parameters[measured.parameter], measured.annotation, scopesInSight, value, history, firm && !showHidden, foresight.nears()};
  const OtherHandleContext context{view, occupied.padded(), occupied.landed(), scopes};
  PlacedHandle& placed = append(layout.others, spareHandles, measured.parameter);
  placed.parameter = measured.parameter;
  const auto missing =
      measured.annotation.type == HandleType::kAngular ? placeArc(handle, context, placed) : placePill(handle, context, placed);
  if (!missing) {
    history.choose(placed.identity, -1);
    occupied.add(placed, view);
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
