#include <cmath>

#include "app/editor_state.h"
#include "app/stopwatch.h"
#include "editing/arc_projection.h"

namespace dimline {

Status Editor::attachRenderer() {
  State& s = *state_;
  auto made = Renderer::make();
  if (!made) return made.error();
  s.renderer = std::move(made).value();
  s.rendererSceneStale = true;
  s.pictureStale = true;
  s.viewStale = true;
  s.quality.start(s.renderer->context().software());
  s.problem.clear();
  return okStatus();
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
  const Status status = renderer->setScene(scene);
  problem = status ? std::string() : status.error().message;
  rendererSceneStale = false;
  pictureStale = true;
}

void Editor::State::buildOverlayLines() {
  overlayLines.clear();
  const auto add = [&](const PlacedLine& line, double opacity, const LineState& state, float handleScale) {
    OverlayLine drawnLine;
    drawnLine.line = line.lineScreen;
    drawnLine.extensionStart = line.extensionStart;
    drawnLine.extensionEnd = line.extensionEnd;
    drawnLine.label = line.label;
    drawnLine.startDraggable = drawnLine.endDraggable = false;
    for (const Handle& handle : line.handles) (handle.atEnd ? drawnLine.endDraggable : drawnLine.startDraggable) = true;
    drawnLine.indirect = line.indirect;
    drawnLine.sphereEnds = line.look.skin == HandleSkin::kSphere;
    drawnLine.color = overlayColor(line.look);
    drawnLine.hovered = state.hovered;
    drawnLine.active = state.dragged;
    drawnLine.opacity = static_cast<float>(opacity);
    drawnLine.handleScale = handleScale;
    overlayLines.push_back(drawnLine);
  };
  for (const LineAnimator::FadingLine& fading : animator.fading()) add(fading.line, fading.opacity, {}, 1.0F);
  for (std::size_t i = 0; i < drawn.lines.size(); ++i)
    add(drawn.lines[i], lineStates[i].opacity, lineStates[i], handleScales[i]);
}

/// Arcs, and the leaders of switches and choices, which are themselves the host's to show.
void Editor::State::buildOverlayHandles() {
  overlayArcs.clear();
  overlayLeaders.clear();
  std::size_t arcs = 0;
  const auto add = [&](const PlacedHandle& handle, double opacity, const LineState& state, float handleScale) {
    if (!handle.arc) {
      if (handle.placement != PlacementKind::kInside) {
        overlayLeaders.push_back({handle.anchor, handle.box, static_cast<float>(opacity)});
      }
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
  for (const HandleAnimator::FadingHandle& fading : handleAnimator.fading()) add(fading.handle, fading.opacity, {}, 1.0F);
  for (std::size_t i = 0; i < drawn.others.size(); ++i)
    add(drawn.others[i], otherStates[i].opacity, otherStates[i], otherScales[i]);
}

void Editor::State::draw(const View& view) {
  if (!renderer) return;
  quality.noteFrame(nowMs, pictureStale);
  const RenderQuality wanted = quality.reduced() ? RenderQuality::kReduced : RenderQuality::kFull;
  if (!pictureStale && wanted == drawnQuality) return;
  const Stopwatch watch;
  buildOverlayLines();
  buildOverlayHandles();

  RenderOptions options;
  options.widthPx = static_cast<int>(std::lround(widthPx * devicePixelRatio));
  options.heightPx = static_cast<int>(std::lround(heightPx * devicePixelRatio));
  options.devicePixelRatio = devicePixelRatio;
  options.quality = wanted;
  const Overlay overlay{overlayLines, overlayArcs, overlayLeaders};
  // A picture that cannot be drawn now will not be drawable in the next frame either: no reason to ask for one.
  if (Status status = renderer->draw(view, overlay, options); !status) problem = status.error().message;
  drawnQuality = wanted;
  pictureStale = false;
  timings.drawMs = watch.ms();
}

}  // namespace dimline
