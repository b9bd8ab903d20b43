#include <cmath>

#include "app/editor_state.h"
#include "app/stopwatch.h"

// The picture is drawn at full quality when nothing moves. While something moves it is drawn at reduced quality if frames come too slowly, which is
// judged by the time between them: that is what people see, and the only measure that also counts what the GPU does.

namespace dimline {

namespace {

/// ms between frames above which motion is no longer smooth, and below which there is room for full quality again.
constexpr double kSlowIntervalMs = 30.0;
constexpr double kFastIntervalMs = 18.0;

/// ms. Longer pauses are no slow frame: the page slept.
constexpr double kPauseMs = 400.0;

/// ms without motion after which a reduced picture is drawn anew in full. Short enough to seem at once, longer than the pauses of a hand.
constexpr double kSettleMs = 120.0;

/// Weight of a new interval in the smoothed one.
constexpr double kSmoothing = 0.2;

}  // namespace

Status Editor::attachRenderer() {
  State& s = *state_;
  auto made = Renderer::make();
  if (!made) return made.error();
  s.renderer = std::move(made).value();
  s.rendererSceneStale = true;
  s.pictureStale = true;
  s.viewStale = true;
  s.quality = {};
  s.quality.slow = s.renderer->context().software();
  return okStatus();
}

void Editor::detachRenderer() {
  state_->renderer.reset();
  state_->fieldSource.rendererGone();
  state_->viewStale = true;
}

void Editor::abandonRenderer() {
  if (state_->renderer) state_->renderer->abandon();
  detachRenderer();
}

void Editor::State::paceQuality() {
  const double interval = nowMs - quality.lastFrameMs;
  const bool consecutive = quality.hadFrame && interval < kPauseMs && interval > 0;
  quality.hadFrame = pictureStale;
  quality.lastFrameMs = nowMs;
  if (!pictureStale) return;
  quality.lastMotionMs = nowMs;
  if (!consecutive) return;
  quality.intervalMs = quality.intervalMs == 0 ? interval : quality.intervalMs + kSmoothing * (interval - quality.intervalMs);
  // On a software rasterizer full quality is never affordable in motion, however fast the reduced one is.
  if (quality.intervalMs > kSlowIntervalMs) quality.slow = true;
  if (quality.intervalMs < kFastIntervalMs && renderer && !renderer->context().software() && drawnQuality == RenderQuality::kFull) {
    quality.slow = false;
  }
}

RenderQuality Editor::State::wantedQuality() const {
  const bool moving = nowMs - quality.lastMotionMs < kSettleMs;
  return quality.slow && moving ? RenderQuality::kReduced : RenderQuality::kFull;
}

bool Editor::State::wantsBetterPicture() const { return renderer && drawnQuality != RenderQuality::kFull; }

void Editor::State::draw(const View& view) {
  if (!renderer) return;
  const RenderQuality wanted = wantedQuality();
  if (!pictureStale && wanted == drawnQuality) return;
  const Stopwatch watch;
  overlay.clear();
  const auto add = [&](const PlacedLine& line, double opacity, const LineState& state, float handleScale) {
    OverlayLine drawnLine;
    drawnLine.line = line.lineScreen;
    drawnLine.extensionStart = line.extensionStart;
    drawnLine.extensionEnd = line.extensionEnd;
    drawnLine.label = line.label;
    drawnLine.startDraggable = drawnLine.endDraggable = false;
    for (const Handle& handle : line.handles) (handle.atEnd ? drawnLine.endDraggable : drawnLine.startDraggable) = true;
    drawnLine.indirect = line.indirect;
    drawnLine.hovered = state.hovered;
    drawnLine.active = state.dragged;
    drawnLine.opacity = static_cast<float>(opacity);
    drawnLine.handleScale = handleScale;
    overlay.push_back(drawnLine);
  };
  for (const LineAnimator::FadingLine& fading : animator.fading()) add(fading.line, fading.opacity, {}, 1.0F);
  for (std::size_t i = 0; i < drawn.lines.size(); ++i) add(drawn.lines[i], lineStates[i].opacity, lineStates[i], handleScales[i]);

  RenderOptions options;
  options.widthPx = static_cast<int>(std::lround(widthPx * devicePixelRatio));
  options.heightPx = static_cast<int>(std::lround(heightPx * devicePixelRatio));
  options.devicePixelRatio = devicePixelRatio;
  options.quality = wanted;
  const Status status = renderer->draw(view, overlay, options);
  // A picture that cannot be drawn at this size will not be drawable in the next frame either; the lines are there all the same.
  (void)status;
  drawnQuality = wanted;
  pictureStale = false;
  timings.drawMs = watch.ms();
}

}  // namespace dimline
