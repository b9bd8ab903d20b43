#include "placement/placer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "core/sort_keys.h"
#include "placement/on_screen.h"
#include "placement/placer_state.h"

// What is known from frame to frame, and how often a frame is placed: while only the camera moves, lines keep their places and what can be done better is mended little by little (mending.h);
// a first picture is placed in rounds, and so is one in which lines settle, a round a frame. placer_attempt.cpp places a frame once.

namespace dimline {

namespace {

/// Frames in which lines settle: the first round takes two, of which the better one goes on.
constexpr int kSettlingSteps = kRoundsSettling + 1;

bool sameScope(const Scope& a, const Scope& b) {
  return a.name == b.name && a.index == b.index && a.box.origin == b.box.origin && a.box.axes == b.box.axes && a.box.size == b.box.size;
}

bool sameHandle(const Parameter& a, const Parameter& b) { return a.name == b.name && a.annotation == b.annotation; }

/// An edit that changes the model's bounds gives another picture, but moves no camera.
bool sameCamera(const View& a, const View& b) { return a.camera() == b.camera() && a.widthPx() == b.widthPx() && a.heightPx() == b.heightPx(); }

}  // namespace

Placer::Placer() : state_(std::make_unique<State>()) {}
Placer::~Placer() = default;
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;

void Placer::forget() {
  state_->settling.step = 0;
  State::Past& past = state_->past;
  past.forget();
  state_->onDemand.forget();
  past.placingOrder.forget();
  state_->forgetOthersOrder();
  past.mending = {};
  past.tangled = false;
  past.calmFrames = 0;
  past.sights.clear();
  past.view.reset();
  past.rest = Rest::kSettled;
  past.settles = past.anew = false;
}

/// They are placed in the order of their definition again.
void Placer::State::forgetOthersOrder() {
  past.othersOrder.clear();
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (!hasOnePlace(others[i])) past.othersOrder.push_back(i);
  }
}

void Placer::State::Choices::forget() {
  setParameters(0, histories.size());
  labels.forget();
}

void Placer::State::Choices::setParameters(std::size_t common, std::size_t count) {
  histories.resize(common, History(-1));
  while (histories.size() < count) histories.push_back(History(static_cast<std::int32_t>(histories.size())));
  lookAhead.forget();
}

struct Placer::Memory::Content {
  State::Past past;
  State::Choices onDemand;
  Foresight foresight;   ///< of the same model, whose object planes it has looked at
};

Placer::Memory Placer::memory() const {
  Memory memory;
  const State& s = *state_;
  const bool settling = s.settling.step > 0;
  memory.content_ = std::make_shared<const Memory::Content>(
      Memory::Content{settling ? s.settling.before : s.past, s.onDemand, settling ? s.settling.foresightBefore : s.foresight});
  return memory;
}

void Placer::recall(const Memory& memory) {
  if (memory.content_ == nullptr || memory.content_->past.histories.size() != state_->past.histories.size()) return;
  state_->settling.step = 0;
  state_->past = memory.content_->past;
  state_->onDemand = memory.content_->onDemand;
  state_->foresight = memory.content_->foresight;
}

void Placer::awaitFields() {
  state_->breakOffSettling();
  state_->past.sceneChanged = state_->past.sceneChanged || !state_->firm;
}

void Placer::settle() { state_->past.settles = true; }

bool Placer::settled() const { return state_->past.rest == Rest::kSettled; }

bool Placer::anew() const { return state_->past.anew; }

void Placer::showHidden(bool shown) {
  if (shown && !state_->showHidden) state_->onDemand.forget();
  state_->showHidden = shown;
}

void Placer::placeAttemptsWhole(bool whole) { state_->attemptsAreWhole = whole; }

void Placer::setScene(const Model& model, const Scene& scene) {
  State& s = *state_;
  s.breakOffSettling();
  // With measures a model has more parameters, and without them fewer; those that it has in both cases keep their places.
  const std::span<const Parameter> parameters(model.parameters().begin(), model.parameters().end());
  const std::size_t common = std::min(s.parameters.size(), parameters.size());
  const bool sameModel = common > 0 && std::ranges::equal(std::span(s.parameters).first(common), parameters.first(common), sameHandle) &&
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
  if (!sameModel || s.past.histories.size() != s.parameters.size()) {
    for (State::Choices* choices : s.allChoices()) choices->setParameters(sameModel ? common : 0, s.parameters.size());
    s.past.mending = {};
  }
  if (!sameModel) forget();
  if (edited) {
    s.forgetOffsets();
    s.past.sceneChanged = true;
    if (s.past.view && s.past.rest == Rest::kSettled) s.past.rest = Rest::kEdited;
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
  if (!sameModel) s.forgetOthersOrder();
  s.editable = byLength[0].size() + s.others.size();
  appendSorted(byLength[0]);
  s.objectPlanes = objectPlanes(fixedBaseLines(s.order, s.scopes), scene.bounds);
  appendSorted(byLength[1]);
  s.past.placingOrder.arrange(s.order);
  s.mostLines = 0;
  for (const Measured& measured : s.order) s.mostLines += measured.scopes.size();
}

/// In a model that an edit has rebuilt, chains are known by the clusters that theirs have become. As many clusters as before are the same ones.
void Placer::State::keepChains(std::span<const Measured> before, const Measured& now) {
  const auto was = std::ranges::find(before, now.parameter, &Measured::parameter);
  if (was == before.end() || was->clusters.size() == now.clusters.size()) return;
  const auto numberNow = [&](std::int32_t number) {
    const auto old = static_cast<std::size_t>(number);
    return old < was->clusters.size() ? successor(was->clusters[old], now.clusters) : -1;
  };
  for (Choices* choices : allChoices()) {
    choices->histories[now.parameter].renumberChains(numberNow);
    choices->labels.renumberChains(static_cast<std::int32_t>(now.parameter), numberNow);
  }
}

void Placer::place(const View& view, const DistanceFields& fields, const Values& values, Layout& layout,
                   const ScopeVisibility* visibility, std::span<const PlacedLine> held) {
  State& s = *state_;
  const bool asked = std::exchange(s.past.settles, false);
  const bool goesOn = asked && s.settling.step > 0 && samePicture(view, *s.past.view) && held.empty();
  if (!goesOn) s.breakOffSettling();
  if (s.settling.step == 1) {   // the second step sets out from where the first did
    std::swap(s.past, s.settling.fromThere);
    s.past = s.settling.before;
  }
  const double turnRad = s.past.view ? turnBetween(*s.past.view, view) : 0.0;
  if (turnRad > kForgetTurnRad) forget();
  const bool first = !s.past.view;
  const bool sceneChanged = std::exchange(s.past.sceneChanged, false);
  const bool rests = asked && !first && !sceneChanged && held.empty();
  const bool cameraMoved = first || !sameCamera(view, *s.past.view);
  const bool tidies = rests && !cameraMoved && s.past.rest == Rest::kEdited;
  const bool settles = rests && !tidies;
  if (settles && !goesOn) {
    s.settling.before = s.past;
    s.settling.foresightBefore = s.foresight;
  }
  // An edit is not part of the movement before it, and where that ends nothing more is to come.
  s.foresight.begin(sceneChanged || settles ? std::nullopt : s.past.view, view, s.bounds, s.objectPlanes, s.toleranceM);
  const bool viewMoved = s.beginFrame(view);
  if (settles && !viewMoved && s.settling.step <= 1) std::ranges::for_each(s.past.histories, &History::age);   // lines may go wherever they may in a movement
  if (settles || cameraMoved) s.past.rest = Rest::kMoved;
  // Who has taken hold of a line has taken the picture as it is.
  if (s.past.rest == Rest::kMoved && !held.empty()) s.past.rest = sceneChanged ? Rest::kEdited : Rest::kSettled;
  s.past.anew = first;
  // In another scene a scope has no past: what an edit covers is hidden at once, and what it lays open is shown.
  s.findVisible(view, visibility, sceneChanged ? kReturnFrames : viewMoved ? std::max(static_cast<int>(turnRad / kFrameTurnRad), 1) : 0);
  facePlanes(s.objectPlanes, view, s.objectPlaneUses);

  const FrameToPlace frame{view, fields, values, held, viewMoved || settles};
  s.kind = {.isFirst = first && held.empty(), .settles = settles, .zooms = s.foresight.zooms()};
  // What was edited may find another place at once.
  const bool firm = !sceneChanged && held.empty();
  // In a first picture there is nothing to keep, but what is amiss can be mended.
  s.firm = firm || s.kind.isFirst;
  s.occupied.begin(fields);
  if (!settles) s.placeInRounds(frame, sceneChanged, layout);
  else if (!s.settleOn(frame, layout)) return;
  if (tidies) s.tidy(frame, layout);
  s.firm = firm;
  s.past.tangled = s.outcome.tangles > 0;
  s.past.labels.note(layout.lines, frame.viewMoved);
  s.jogExtensions(layout.lines);
  if (s.showHidden) s.placeOnDemand(frame, sceneChanged, layout);

  layout.view = view;
  layout.visibleScopes.clear();
  for (std::size_t i = 0; i < s.scopes.size(); ++i) {
    if (s.seen[i] != 0) layout.visibleScopes.push_back(i);
  }
}

void Placer::placeSettled(const View& view, const DistanceFields& fields, const Values& values, Layout& layout, const ScopeVisibility* visibility) {
  constexpr int kMost = kSettlingSteps + 1;   // one more where nothing is known yet, or the scene has changed
  for (int frame = 0; frame < kMost && (frame == 0 || !settled()); ++frame) {
    settle();
    place(view, fields, values, layout, visibility);
  }
}

/// A frame that is placed at once. Of a first picture nothing is known of what is ahead: another round of the same view makes up for that.
void Placer::State::placeInRounds(const FrameToPlace& frame, bool sceneChanged, Layout& layout) {
  const int rounds = kind.isFirst ? kRoundsAtFirst : 1;
  asksForRoom = rounds > 1;
  placeOnce(frame, sceneChanged, true, layout);
  for (int round = 1; round < rounds; ++round) placeRound(frame, round + 1 == rounds, layout);
}

/// Another round of the same view.
void Placer::State::placeRound(const FrameToPlace& frame, bool isLast, Layout& layout) {
  firm = true;
  asksForRoom = !isLast;
  std::ranges::for_each(past.histories, &History::age);
  placeOnce(frame, false, false, layout);
}

/// The next step of settling. Returns whether that was the last; then the picture is in `layout`, which is left as it is until then.
bool Placer::State::settleOn(const FrameToPlace& frame, Layout& layout) {
  const int step = ++settling.step;
  if (step <= 2) placeSettling(frame);
  else placeRound(frame, step == kSettlingSteps, settling.layout);
  if (step < kSettlingSteps) return false;
  tidy(frame, settling.layout);
  settling.step = 0;
  std::swap(layout, settling.layout);
  return true;
}

/// The first round of settling, in two steps: once from where lines are, and once as if nothing were remembered of them. The next round goes on from the better one.
void Placer::State::placeSettling(const FrameToPlace& frame) {
  const bool anew = settling.step == 2;
  if (anew) past.forget();
  asksForRoom = true;
  placeOnce(frame, false, true, settling.layout);
  outcome.changes = 0;
  for (std::size_t i = 0; i < past.histories.size(); ++i) outcome.changes += past.histories[i].last() == settling.before.histories[i].last() ? 0 : 1;
  if (!anew) settling.outcome = outcome;
  else if (!outcome.betterThan(settling.outcome)) past = settling.fromThere;
}

/// What was remembered before lines began to settle is remembered again.
void Placer::State::breakOffSettling() {
  if (std::exchange(settling.step, 0) == 0) return;
  past = settling.before;
  foresight = settling.foresightBefore;
}

/// A round of placing everything. `shown`: what was placed before.
void Placer::State::placeOnce(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout) {
  placeMended(frame, sceneChanged, shown, layout);
  placeBesideLines(frame, layout);
  labelInside(frame, layout.lines);
}

/// Places the lines, and mends that where they keep their places and the view moves.
void Placer::State::placeMended(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout) {
  past.lookAhead.begin(frame.viewMoved || sceneChanged, shown);
  past.lookAhead.project(order, past.placingOrder.ranks(), frame.view, frame.fields);
  const bool mends = firm && frame.viewMoved;
  if (mends) beforeAttempts = past;
  keepsTurns = mends && !attemptsAreWhole;
  if (keepsTurns) makeRoomForTurns();
  placeAllLines(frame, layout);
  if (mends) mend(frame, layout);
  keepsTurns = false;
}

/// Other attempts at the frame that has been placed, each of which goes on from the best one before it; the best one stays.
void Placer::State::mend(const FrameToPlace& frame, Layout& layout) {
  Mending mending = past.mending;
  mending.begin();
  auto attempt = mending.next(outcome, past.placingOrder.isShortestFirst());
  if (attempt) outcome.tanglesAhead = tanglesAhead(layout.lines);
  avoided.assign(order.size(), {});
  for (; attempt; attempt = mending.next(outcome, past.placingOrder.isShortestFirst())) {
    beginAttempt(*attempt, layout);
    const std::size_t same = turnsInCommon();
    if (same == order.size()) {   // nothing is otherwise
      swapWithBest(layout);
      continue;
    }
    past.lookAhead.project(order, past.placingOrder.ranks(), frame.view, frame.fields);
    if (keepsTurns) {
      const std::size_t from = same - same % turnsBetween();
      goOnFromBest(from, layout);
      placeFrom(from, frame, layout);
    } else {
      placeAllLines(frame, layout);
    }
    outcome.tanglesAhead = tanglesAhead(layout.lines);
    const bool wins = !looksInVain() && (attempt->winsTies ? !bestOutcome.betterThan(outcome) : outcome.betterThan(bestOutcome));
    if (!wins) swapWithBest(layout);
    else if (keepsTurns) std::swap_ranges(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(same / turnsBetween()), bestTurns.begin());
  }
  avoided.clear();
  past.mending = mending;
}

/// How many lines will run across another's extension line, had each kept its place in the world: see Outcome. Those that leave the picture are in nobody's way.
double Placer::State::tanglesAhead(std::span<const PlacedLine> lines) {
  double tangles = 0;
  for (std::size_t look = 0; look < foresight.lookCount(); ++look) {
    const View& view = foresight.viewAhead(look);
    landedElsewhere.clear();
    for (const PlacedLine& placed : lines) {
      const auto line = placed.placement == PlacementKind::kInside ? std::nullopt : onScreen(placed.line, view);
      if (!line || !view.inFrontOfNear(placed.base) || !view.inFrontOfNear(placed.foot)) continue;
      const Segment2 base = view.toScreen(placed.base), foot = view.toScreen(placed.foot);
      tangles += foresight.shareLeft(look) * landedElsewhere.tangle(*line, extensionParts(base, foot, *line)).lines;
      landedElsewhere.add(base, foot, *line);
    }
  }
  return tangles;
}

/// What was placed is the best so far, and all is again as it was before, but for the order, who looks for another place, and what the attempt does otherwise.
void Placer::State::beginAttempt(const Attempt& attempt, Layout& layout) {
  swapWithBest(layout);
  past = beforeAttempts;
  past.placingOrder = bestPast.placingOrder;
  if (attempt.shortestFirst) past.placingOrder.forget();
  for (const auto& [rank, before] : std::span(attempt.puts).first(attempt.putCount)) past.placingOrder.put(rank, before);
  avoided = bestAvoided;
  if (attempt.looks) avoided[*attempt.looks] = bestPlaceOf(*attempt.looks, attempt.otherSide);
}

/// Where the line of a rank lies in the best attempt; `withSide`: and all else on that side; inside the model there is none.
AvoidedPlace Placer::State::bestPlaceOf(std::size_t rank, bool withSide) const {
  const std::size_t parameter = order[rank].parameter;
  AvoidedPlace best{.place = bestPast.histories[parameter].last()};
  if (!withSide) return best;
  const auto line = std::ranges::find(bestLayout.lines, parameter, &PlacedLine::parameter);
  if (line != bestLayout.lines.end()) best.side = unitOrZero(line->lineScreen.middle() - line->baseScreen.middle());
  return best;
}

/// How many lines have their turn before anything is done otherwise than in the best attempt.
std::size_t Placer::State::turnsInCommon() const {
  const auto now = past.placingOrder.ranks(), best = bestPast.placingOrder.ranks();
  std::size_t turn = 0;
  while (turn < now.size() && now[turn] == best[turn] && avoided[now[turn]] == bestAvoided[now[turn]]) ++turn;
  return turn;
}

/// Whether a line that looks for another place has found none outside: it would be back in its own in the next frame.
bool Placer::State::looksInVain() const {
  for (std::size_t rank = 0; rank < avoided.size(); ++rank) {
    if (avoided[rank].any() && outcome.outside[rank] == 0) return true;
  }
  return false;
}

void Placer::State::swapWithBest(Layout& layout) {
  std::swap(bestTurns, turns);
  std::swap(bestAvoided, avoided);
  std::swap(bestPast, past);
  std::swap(bestOutcome, outcome);
  std::swap(bestLayout, layout);
  occupied.swapLanded(bestOccupied);
}

/// Places beside what has been placed what is shown on demand. All that was there stays where it is.
void Placer::State::placeOnDemand(const FrameToPlace& frame, bool sceneChanged, Layout& layout) {
  const std::size_t shown = layout.lines.size();
  // What the frame itself no longer shows is shown on where it was.
  for (std::size_t i = 0; i < past.histories.size(); ++i) {
    if (!isHidden(layout.hidden, i)) onDemand.histories[i] = past.histories[i];
    else if (frame.viewMoved) onDemand.histories[i].age();
  }
  std::swap<Choices>(past, onDemand);
  showAll = true;
  past.lookAhead.begin(frame.viewMoved || sceneChanged);
  past.lookAhead.project(order, past.placingOrder.ranks(), frame.view, frame.fields);
  placeAllHidden(frame, layout);
  const std::span<PlacedLine> added = std::span(layout.lines).subspan(shown);
  past.labels.note(added, frame.viewMoved);
  jogExtensions(added);
  showAll = false;
  std::swap<Choices>(past, onDemand);
}

/// Bends extension lines round the ends of lines, once all of them are there.
void Placer::State::jogExtensions(std::span<PlacedLine> lines) const {
  for (PlacedLine& line : lines) {
    for (ExtensionLine* extension : {&line.extensionStart, &line.extensionEnd}) {
      if (extension->empty()) continue;
      const Segment2 last{(*extension)[extension->size() - 2], extension->back()};
      const auto jog = occupied.landed().jogOf(last);
      if (!jog) continue;
      extension->back() = *jog;
      extension->push_back(last.end);
    }
  }
}

void Placer::State::forgetOffsets() {
  for (Choices* choices : allChoices()) std::ranges::for_each(choices->histories, &History::forgetOffset);
}

/// Ages what is remembered. Returns whether the view has changed since the last frame.
bool Placer::State::beginFrame(const View& view) {
  const bool moved = !past.view || !samePicture(view, *past.view);
  // An offset of so many metres is another on screen in a viewport of another size.
  const bool resized = past.view && (view.widthPx() != past.view->widthPx() || view.heightPx() != past.view->heightPx());
  past.view = view;
  if (moved) {
    std::ranges::for_each(past.histories, &History::age);
    past.calmFrames = past.tangled ? 0 : std::min(past.calmFrames + 1, kCalmFrames);
  }
  if (resized) forgetOffsets();
  return moved;
}

void Placer::State::findVisible(const View& view, const ScopeVisibility* visibility, int framesOn) {
  assert(visibility == nullptr || visibility->seenShare.size() == scopes.size());
  inView.resize(scopes.size());
  seen.resize(scopes.size());
  seenEnough.resize(scopes.size());
  past.sights.resize(scopes.size());
  for (std::size_t i = 0; i < scopes.size(); ++i) {
    Sight& sight = past.sights[i];
    inView[i] = dimline::inView(view, scopes[i].box) ? 1 : 0;
    if (inView[i] == 0) sight = {};
    sight.age(framesOn);
    const double share = visibility != nullptr ? static_cast<double>(visibility->seenShare[i]) : 1.0;
    const SeenEdges edges = visibility != nullptr && !visibility->seenEdges.empty() ? visibility->seenEdges[i] : SeenEdges::all();
    seen[i] = inView[i] != 0 && sight.see(share, edges) ? 1 : 0;
    seenEnough[i] = seen[i] != 0 && sight.seenEnough() ? 1 : 0;
  }
}

}  // namespace dimline
