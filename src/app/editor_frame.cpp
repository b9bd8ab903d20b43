#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor_state.h"
#include "app/stopwatch.h"

namespace dimline {

namespace {

/// A handle grows under the pointer by this factor (paper 5, "Hover behavior").
constexpr double kHoverScale = 1.35;

/// ms. While something moves, which scopes are seen is measured this often: it is the dearest part of a frame, and
/// changes slowly. At rest it is always that of the present view.
constexpr double kVisibilityIntervalMs = 60.0;

/// ms. The GPU's answers are dropped when the model changes. While it changes in each frame, none arrives, and the CPU
/// is asked after so long.
constexpr double kVisibilityPatienceMs = 250.0;

/// ms. A movement by wheel, by keys or by a host, or an edit from the panel, has no end that anyone tells of: it is over when nothing has moved for so long. Less: lines settle between two turns of
/// a wheel. More: they do when someone reads them already.
constexpr double kSettleAfterMs = 350.0;

}  // namespace

bool Editor::frame(double nowMs) {
  State& s = *state_;
  if (std::isfinite(nowMs)) s.nowMs = std::max(s.nowMs, nowMs);
  if (!s.loaded) return false;
  s.followPointers();
  if (s.sceneStale) s.rebuild();
  if (!s.hasSize()) {
    s.clearLines();
    return false;
  }
  if (s.compositionDue) s.compose();
  const View view = s.currentView();
  s.measureAndPlace(view);
  s.animate(view);
  s.learnMarks();
  s.draw(view);
  s.restedLastFrame = atRest();
  return !s.restedLastFrame;
}

bool Editor::atRest() const {
  const State& s = *state_;
  if (!s.loaded) return true;
  if (s.sceneStale) return false;
  if (!s.hasSize()) return true;
  if (s.handleGesture && s.handleGesture->moved) return false;
  return !s.viewStale && !s.visibilityStale && s.fieldSource.current() && !s.fieldSource.pending() &&
         !s.unsettled() && s.animator.atRest() && s.handleAnimator.atRest() && !s.hoverAnimating() && !s.marksToLearn && !s.wantsBetterPicture() && !(s.renderer && s.pictureStale);
}

void Editor::State::rebuild() {
  const Stopwatch watch;
  scene = model.definition.build(values);
  if (measuresShown) {
    addMeasureScopes(model, scene);
    valuesWithMeasures = withMeasures(model, values, scene);
  }
  placer.setScene(placedModel(), scene);
  fieldSource.setScene(scene);
  visibilitySource.sceneChanged();
  sceneStale = false;
  placedInScene = false;
  viewStale = true;
  rendererSceneStale = true;
  timings.rebuildMs = watch.ms();
}

/// Fields for the view, from whichever producer, and the lines placed in them when anything has changed.
void Editor::State::measureAndPlace(const View& view) {
  uploadScene();
  const bool moved = std::exchange(viewStale, false);
  if (moved) {
    if (!visibilityStale) visibilityStaleMs = nowMs;
    visibilityStale = true;
    visibilitySource.viewChanged();
  }
  const auto seen = visibilitySource.poll(renderer.get());
  if (seen != VisibilitySource::Arrival::kNone) {
    visibilityStaleMs = nowMs;
    timings.visibilityMs = visibilitySource.measuredMs();
  }
  const bool seenNow = seen == VisibilitySource::Arrival::kPresent;
  if (seenNow) visibilityStale = false;
  const bool arrived = fieldSource.update(view, moved, devicePixelRatio, renderer.get());
  // A document that opens waits for fields of its own.
  if (arrived && (placedOnce || fieldSource.current())) {
    timings.fieldsMs = fieldSource.measuredMs();
    placeOn(fieldSource.view(), moved);
  } else if (!moved && fieldSource.current() && (seenNow || (visibilityStale && !visibilitySource.awaiting()))) {
    placeOn(fieldSource.view(), false);
  } else if (moved && placedOnce && fieldSource.fields().widthPx == static_cast<int>(std::ceil(widthPx)) &&
             fieldSource.fields().heightPx == static_cast<int>(std::ceil(heightPx))) {
    // The fields are still on their way. Base lines of a rebuilt model must not wait for them, so the last ones serve
    // once more.
    placeOn(fieldSource.view(), true);
  }
  settleLines(moved);
}

/// Lets lines find the places in which they rest once a movement or an edit has ended: at once when a hand lets go, and after a leap to another view.
void Editor::State::settleLines(bool moved) {
  const bool atOnce = std::exchange(settlesAtOnce, false);
  if (moved) settleMs = nowMs + (atOnce ? 0.0 : kSettleAfterMs);
  const bool letGo = std::exchange(inHand, handHolds()) && !inHand;
  if (letGo || placer.anew()) settleMs = nowMs;
  if (!unsettled() || nowMs < settleMs || !placedOnce || !fieldSource.current() || visibilityStale) return;
  placer.settle();
  const bool stale = pictureStale;
  placeOn(fieldSource.view(), false);
  if (unsettled()) pictureStale = stale;  // until the last of these frames all is where it was
}

/// Which scopes are seen: at once where the last answer will not do, otherwise when it is due.
void Editor::State::measureVisibility(const View& view, bool moving) {
  const bool fits = visibilitySource.seen().seenShare.size() == scene.scopes.size();
  const bool late = visibilityStale && nowMs - visibilityStaleMs >= kVisibilityPatienceMs;
  const bool atOnce = !fits || recall || !placedOnce || late;
  const bool due = !moving || restedLastFrame || nowMs - visibilityAskedMs >= kVisibilityIntervalMs;
  if (!atOnce && !(due && visibilityStale)) return;
  visibilityAskedMs = nowMs;
  if (!visibilitySource.measure(scene, view, renderer.get(), atOnce, fieldSource.current())) return;
  visibilityStaleMs = nowMs;
  visibilityStale = !fieldSource.current();
  timings.visibilityMs = visibilitySource.measuredMs();
}

void Editor::State::placeOn(const View& view, bool moving) {
  measureVisibility(view, moving);
  const Stopwatch placeWatch;
  if (recall) {
    placer.recall(*recall);
    if (fieldSource.current()) recall.reset();  // fields that are still on their way will place the lines once more
  }
  heldLines.clear();
  const std::span<const HandleHold> holds = handleGesture ? std::span<const HandleHold>(handleGesture->holds) : std::span<const HandleHold>();
  for (const HandleHold& hold : holds) {
    auto line = hold.drag.line() != nullptr ? hold.drag.line()->lineOn(scene, values, view) : std::nullopt;
    if (line) heldLines.push_back(std::move(*line));
  }
  placer.place(view, fieldSource.fields(), placedValues(), placed, &visibilitySource.seen(), heldLines);
  if (!fieldSource.current()) placer.awaitFields();
  else if (!placedOnce && heldLines.empty() && !placer.settled()) {
    placer.placeSettled(view, fieldSource.fields(), placedValues(), placed, &visibilitySource.seen());   // nobody sees anything yet that would move
  }
  for (const PlacedLine& line : heldLines) {
    if (line.chain >= 0) holdMember(line);
  }
  for (const HandleHold& hold : holds) {
    const auto arc = hold.drag.arc() != nullptr ? hold.drag.arc()->handleOn(values, view) : std::nullopt;
    if (arc) holdArc(*arc);
  }
  timings.placeMs = placeWatch.ms();
  placedOnce = true;
  placedInScene = true;
  pictureStale = true;
}

/// A chain is placed as a whole while one of its members is dragged; only the member itself is where the hand has it.
void Editor::State::holdMember(const PlacedLine& held) {
  const auto isHeld = [&](const PlacedLine& line) {
    return line.parameter == held.parameter && line.scope == held.scope;
  };
  // Where the number of members has changed, the held one lies across its fellows; those that it covers give way.
  const Vec3 along = glm::normalize(held.line.end - held.line.start);
  const double tolerance = kSamePlaneDistance * scene.bounds.diagonal();
  std::erase_if(placed.lines, [&](const PlacedLine& line) {
    if (line.parameter != held.parameter || isHeld(line)) return false;
    const double from = glm::dot(line.line.start - held.line.start, along);
    const double to = glm::dot(line.line.end - held.line.start, along);
    return std::min(from, to) < held.line.length() - tolerance && std::max(from, to) > tolerance;
  });
  // So do their labels.
  for (PlacedLine& line : placed.lines) {
    if (line.parameter != held.parameter || isHeld(line) || !line.label) continue;
    const Box2 label = line.label->grown(kLabelClearancePx);
    if (meets(held.lineScreen, label) || (held.label && held.label->overlaps(label))) line.label.reset();
  }
  // Whatever it measures by now, the held line keeps its identity through the drag; who bears that now takes the one that it leaves free.
  for (PlacedLine& line : placed.lines) {
    if (line.identity == held.identity && !isHeld(line)) line.identity.scopeIndex = static_cast<std::int32_t>(scene.scopes[held.scope].index);
  }
  const auto found = std::ranges::find_if(placed.lines, isHeld);
  if (found != placed.lines.end()) {
    *found = held;
    return;
  }
  std::erase_if(placed.hidden, [&](const HiddenParameter& hidden) { return hidden.parameter == held.parameter; });
  placed.lines.push_back(held);
}

/// A dragged arc stays where the hand has it in the world, whatever the model does.
void Editor::State::holdArc(const PlacedHandle& held) {
  const auto found = std::ranges::find(placed.others, held.parameter, &PlacedHandle::parameter);
  if (found != placed.others.end()) {
    *found = held;
    return;
  }
  std::erase_if(placed.hidden, [&](const HiddenParameter& hidden) { return hidden.parameter == held.parameter; });
  placed.others.push_back(held);
}

void Editor::State::animate(const View& view) {
  // A scene that was rebuilt while the viewport changed its size has no lines until its fields arrive; those of the last one may belong to
  // scopes that are no more.
  if (!placedOnce || !placedInScene) return;
  const bool wasAtRest = animator.atRest() && handleAnimator.atRest();
  const bool sameAsDrawn = samePicture(drawn.view, view);
  Layout none;
  none.view = placed.view;
  const Layout& shown = linesShown ? placed : none;
  animator.update(shown, scene.scopes, view, nowMs, drawn, heldLines);
  handleAnimator.update(shown, scene.scopes, view, nowMs, drawn);
  updateHover();
  updateStates();
  if (!wasAtRest || !animator.atRest() || !handleAnimator.atRest() || !sameAsDrawn || hoverAnimating()) pictureStale = true;
}

/// Opacity, hover and drag of everything that is drawn.
void Editor::State::updateStates() {
  const double hoverShare = std::clamp((nowMs - hoverChangedMs) / kHoverMs, 0.0, 1.0);
  const auto scaleOf = [&](bool dragged, bool isHovered, bool wasHovered) {
    const double grown = dragged ? 1.0 : isHovered ? hoverShare : wasHovered ? 1.0 - hoverShare : 0.0;
    return static_cast<float>(1.0 + (kHoverScale - 1.0) * grown);
  };
  lineStates.resize(drawn.lines.size());
  handleScales.resize(drawn.lines.size());
  for (std::size_t i = 0; i < drawn.lines.size(); ++i) {
    const PlacedLine& line = drawn.lines[i];
    const HandleKey key = keyOf(line, true);
    const bool dragged = handleGesture && handleGesture->dragging(line) != nullptr;
    lineStates[i] = {animator.opacities()[i], hovered == key, dragged};
    handleScales[i] = scaleOf(dragged, hovered == key, hoveredBefore == key);
  }
  otherStates.resize(drawn.others.size());
  otherScales.resize(drawn.others.size());
  for (std::size_t i = 0; i < drawn.others.size(); ++i) {
    const HandleKey key = keyOf(drawn.others[i]);
    const bool dragged = handleGesture && handleGesture->dragging(drawn.others[i]) != nullptr;
    otherStates[i] = {handleAnimator.opacities()[i], hovered == key, dragged};
    otherScales[i] = scaleOf(dragged, hovered == key, hoveredBefore == key);
  }
}

bool Editor::State::hoverAnimating() const { return (hovered || hoveredBefore) && nowMs - hoverChangedMs < kHoverMs; }

/// No lines, and none remembered: the next ones appear without animation.
void Editor::State::clearLines() {
  animator.reset();
  handleAnimator.reset();
  recall.reset();
  placed = {};
  drawn = {};
  lineStates.clear();
  handleScales.clear();
  otherStates.clear();
  otherScales.clear();
  placedOnce = false;
  viewStale = true;
}

std::optional<DistanceFields> Editor::measureFields(FieldsFrom from) {
  State& s = *state_;
  if (!s.loaded || !s.hasSize()) return std::nullopt;
  if (s.sceneStale) s.rebuild();
  s.uploadScene();
  return s.fieldSource.measure(s.currentView(), from, s.devicePixelRatio, s.renderer.get());
}

}  // namespace dimline
