#include <algorithm>
#include <cmath>

#include "app/editor_state.h"
#include "app/stopwatch.h"
#include "editing/arc_projection.h"
#include "render/overlay_line.h"

namespace dimline {

namespace {

/// Up to so many boxes are marked with hidden edges too and at full strength; and no more pieces of edges than that are drawn at all.
constexpr double kScopesInFull = 8;
constexpr std::size_t kMostEdges = 1500;

/// ms. So long a frame may evaluate the model for what is shown beside a dragged line.
constexpr double kLearningMs = 3.0;

/// ms. So often it is shown while there is more to come.
constexpr double kShowLearnedMs = 80.0;

/// px. Nothing is marked so near to a label.
constexpr double kLabelMarkGapPx = 3.0;

void dropCovered(const Box2& label, std::vector<DragMark>& marks) {
  std::erase_if(marks, [&](const DragMark& mark) {
    const bool quiet = mark.kind != DragMark::Kind::kLimitReached && mark.kind != DragMark::Kind::kGhost;
    return quiet && clipped(mark.line, label.grown(kLabelMarkGapPx));
  });
}

}  // namespace

void Editor::attachRenderer() {
  State& s = *state_;
  detachRenderer();   // requests are numbered by the renderer that they went to
  s.renderer = std::make_unique<Renderer>();
  s.rendererSceneStale = true;
  s.pictureStale = true;
  s.viewStale = true;
  s.quality.start(s.renderer->context().software());
  s.problem.clear();
}

void Editor::detachRenderer() {
  state_->renderer.reset();
  state_->fieldSource.rendererGone();
  state_->visibilitySource.rendererGone();
  state_->viewStale = true;
}

const std::string& Editor::problem() const { return state_->problem; }

void Editor::abandonRenderer() {
  if (state_->renderer) state_->renderer->abandon();
  detachRenderer();
}

/// Gives the renderer the scene when it has another one.
void Editor::State::uploadScene() {
  if (!renderer || !rendererSceneStale) return;
  renderer->setScene(scene);
  rendererSceneStale = false;
  pictureStale = true;
}

void Editor::State::buildOverlayLines() {
  overlayLines.clear();
  const auto add = [&](const PlacedLine& line, double opacity, const LineState& state, float handleScale) {
    OverlayLine drawnLine = overlayLine(line, scene, drawn.view);
    drawnLine.hovered = state.hovered;
    drawnLine.active = state.dragged;
    drawnLine.opacity = static_cast<float>(opacity);
    drawnLine.handleScale = handleScale;
    overlayLines.push_back(drawnLine);
  };
  for (const auto& fading : animator.fading()) add(fading.placed, fading.opacity, {}, 1.0F);
  for (std::size_t i = 0; i < drawn.lines.size(); ++i)
    add(drawn.lines[i], lineStates[i].opacity, lineStates[i], handleScales[i]);
}

/// Arcs, and the threads of switches and choices, which are themselves the host's to show.
void Editor::State::buildOverlayHandles() {
  overlayArcs.clear();
  overlayThreads.clear();
  std::size_t arcs = 0;
  const auto add = [&](const PlacedHandle& handle, double opacity, const LineState& state, float handleScale) {
    if (!handle.arc) {
      overlayThreads.push_back({handle.anchor, handle.box, static_cast<float>(opacity)});
      return;
    }
    if (arcs == arcPoints.size()) arcPoints.emplace_back();
    if (!arcOnScreen(*handle.arc, drawn.view, arcPoints[arcs])) return;
    OverlayArc arc;
    arc.points = arcPoints[arcs++];
    arc.center = drawn.view.toScreen(handle.arc->center);
    arc.draggable = !handle.handles.empty();
    arc.hovered = state.hovered;
    arc.active = state.dragged;
    arc.opacity = static_cast<float>(opacity);
    arc.handleScale = handleScale;
    overlayArcs.push_back(arc);
  };
  for (const auto& fading : handleAnimator.fading()) add(fading.placed, fading.opacity, {}, 1.0F);
  for (std::size_t i = 0; i < drawn.others.size(); ++i)
    add(drawn.others[i], otherStates[i].opacity, otherStates[i], otherScales[i]);
}

/// What a drag shows beside its line, and the scopes that the parameter under the pointer drives.
void Editor::State::buildOverlayMarks() {
  dragMarks.clear();
  overlayEdges.clear();
  if (!linesShown) return;
  const double share = std::clamp((nowMs - hoverChangedMs) / kHoverMs, 0.0, 1.0);
  if (handleGesture) {
    addDragMarks();
    for (const HandleHold& hold : handleGesture->holds) markScopes(hold.drag.parameter(), drawn.view, 1.0);
    return;
  }
  if (hovered) markScopes(hovered->parameter, drawn.view, hoveredBefore && hoveredBefore->parameter == hovered->parameter ? 1.0 : share);
  if (hoveredBefore && share < 1.0 && !(hovered && hovered->parameter == hoveredBefore->parameter)) {
    markScopes(hoveredBefore->parameter, drawn.view, 1.0 - share);
  }
}

/// Finds out more of what a drag will show beside its line where that takes trying: the model is evaluated for it, so a few times a frame.
void Editor::State::learnMarks() {
  marksToLearn = false;
  if (!handleGesture || !renderer || !linesShown) return;
  const Stopwatch watch;
  for (const PlacedLine& line : drawn.lines) {
    HandleHold* hold = handleGesture->dragging(line);
    if (hold == nullptr) continue;
    while (!marksToLearn && hold->drag.line()->learnNearby(values.at(line.parameter), line, drawn.view, hold->snap)) {
      marksLearned = true;
      marksToLearn = watch.ms() > kLearningMs;
    }
  }
  // Each one is not worth a picture of its own.
  if (!marksLearned || (marksToLearn && nowMs - marksShownMs < kShowLearnedMs)) return;
  marksLearned = false;
  marksShownMs = nowMs;
  pictureStale = true;
}

/// The marks of drags, but for those that their own labels cover.
void Editor::State::addDragMarks() {
  for (const PlacedLine& line : drawn.lines) {
    HandleHold* hold = handleGesture->dragging(line);
    if (hold != nullptr) hold->drag.line()->addMarks(values.at(line.parameter), line, drawn.view, hold->snap, dragMarks);
  }
  for (const PlacedHandle& other : drawn.others) {
    const HandleHold* hold = handleGesture->dragging(other);
    if (hold != nullptr) hold->drag.arc()->addMarks(values.at(other.parameter), drawn.view, hold->snap, dragMarks);
  }
  for (const PlacedLine& line : drawn.lines) {
    if (line.label && handleGesture->dragging(line) != nullptr) dropCovered(*line.label, dragMarks);
  }
  for (const PlacedHandle& other : drawn.others) {
    if (handleGesture->dragging(other) != nullptr) dropCovered(other.box, dragMarks);
  }
}

/// Marks the edges of the boxes of those scopes in sight that a parameter's annotation names.
void Editor::State::markScopes(std::size_t parameter, const View& view, double share) {
  // A measure may have gone since the pointer was at it.
  if (parameter >= placedModel().annotations.size()) return;
  const auto& annotation = placedModel().annotations[parameter];
  if (!annotation) return;
  const auto ofIt = [&](std::size_t i) { return i < scene.scopes.size() && scene.scopes[i].name == annotation->scope; };
  const auto count = std::ranges::count_if(placed.visibleScopes, ofIt);
  // Many boxes together would be a thicket; each is the quieter, and what the model hides of it is left out.
  const auto opacity = static_cast<float>(share * std::clamp(kScopesInFull / static_cast<double>(std::max<std::ptrdiff_t>(count, 1)), 0.4, 1.0));
  if (count == 0) return;
  const ScopeMark mark{kEdgeSkinShare * scene.bounds.diagonal(), opacity, static_cast<double>(count) <= kScopesInFull};
  for (const std::size_t i : placed.visibleScopes) {
    if (ofIt(i)) addEdges(scene.scopes[i].box, view, mark, overlayEdges);
    if (overlayEdges.size() >= kMostEdges) return;
  }
}

void Editor::State::draw(const View& view) {
  if (!renderer) return;
  quality.noteFrame(nowMs, pictureStale);
  const RenderQuality wanted = quality.reduced() ? RenderQuality::kReduced : RenderQuality::kFull;
  if (!pictureStale && wanted == drawnQuality) return;
  const Stopwatch watch;
  buildOverlayLines();
  buildOverlayHandles();
  buildOverlayMarks();

  RenderOptions options;
  options.widthPx = static_cast<int>(std::lround(widthPx * devicePixelRatio));
  options.heightPx = static_cast<int>(std::lround(heightPx * devicePixelRatio));
  options.devicePixelRatio = devicePixelRatio;
  options.quality = wanted;
  // A software rasterizer takes longer for fine light than people pause between two changes, and hardly anybody sees the difference.
  if (renderer->context().software()) options.light = LightDetail::kCoarse;
  const Overlay overlay{overlayLines, overlayArcs, overlayThreads, dragMarks, overlayEdges};
  // A picture that cannot be drawn now will not be drawable in the next frame either: no reason to ask for one.
  const Status status = renderer->draw(view, overlay, options);
  problem = status ? std::string() : status.error().message;
  drawnQuality = wanted;
  pictureStale = false;
  timings.drawMs = watch.ms();
}

}  // namespace dimline
