#include "app/editor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "app/composition.h"
#include "app/editor_state.h"

namespace dimline {

namespace {

// Beyond these a host's numbers are a mistake, and a framebuffer of that size no good to anybody.
constexpr double kMaxSizePx = 16384.0;
constexpr double kMinPixelRatio = 0.1;
constexpr double kMaxPixelRatio = 8.0;

/// Events that wait to be taken. Hosts take them once a frame, in which there are a few.
constexpr std::size_t kMostEvents = 256;

/// Unit direction from the target to the eye.
Vec3 directionOf(StandardView view) {
  switch (view) {
    case StandardView::kFront:
      return {0, 0, 1};
    case StandardView::kBack:
      return {0, 0, -1};
    case StandardView::kLeft:
      return {-1, 0, 0};
    case StandardView::kRight:
      return {1, 0, 0};
    case StandardView::kTop:
      return {0, 1, 0};
    case StandardView::kThreeQuarter:
      break;
  }
  const Camera camera = threeQuarterView(Bounds{}, 1, 1);
  return glm::normalize(camera.eye - camera.target);
}

}  // namespace

Editor::Editor() : state_(std::make_unique<State>()) {}
Editor::~Editor() = default;

// --- Document
// ---------------------------------------------------------------------------------------------------------

Status Editor::setModel(Model model) {
  State& s = *state_;
  if (!model.definition.build || model.annotations.size() != model.definition.parameters.size()) {
    return Error{"This model has no rule that builds it, or was not made by makeModel()."};
  }
  s.dropGestures();
  s.takeModel(std::move(model));
  s.loaded = true;
  s.fieldSource.forgetTimes();
  s.visibilitySource.forgetTimes();
  s.begin(Values(s.model.parameters()));
  s.notify(EditorEvent::kLoad);
  return okStatus();
}

void Editor::beginWith(std::span<const std::pair<std::size_t, double>> changes) {
  State& s = *state_;
  if (!s.loaded) return;
  const Values first = s.changed(Values(s.model.parameters()), changes);
  const bool loading = std::ranges::find(s.events, EditorEvent::kLoad) != s.events.end();
  if (loading && first == s.values) return;
  s.dropGestures();
  s.begin(first);
  if (loading) return;
  s.notify(EditorEvent::kInput);
  s.notify(EditorEvent::kChange);
}

/// The document has these values, and nothing has been before.
void Editor::State::begin(const Values& first) {
  continuing.reset();
  history.clear();
  places.clear();
  values = first;
  placer.forget();
  clearLines();
  hovered.reset();
  hoveredBefore.reset();
  rebuild();
  openingCamera();
}

const Model& Editor::model() const { return state_->model; }
const Values& Editor::values() const { return state_->values; }
const Scene& Editor::scene() const { return state_->scene; }

/// Makes a model the document's, its numbers written as the visitor writes them.
void Editor::State::takeModel(Model next) {
  model = std::move(next);
  for (Parameter& parameter : model.definition.parameters) parameter.decimalMark = decimalMark;
  for (Measure& measure : model.definition.measures) measure.shown.decimalMark = decimalMark;
  modelWithMeasures = withMeasures(model);
}

/// Values with some of them changed, each within its range.
Values Editor::State::changed(Values from, std::span<const std::pair<std::size_t, double>> changes) const {
  for (const auto& [parameter, value] : changes) {
    assert(parameter < from.size());
    from.set(parameter, clampValue(model.parameters()[parameter], value));
  }
  return from;
}

void Editor::setValues(std::span<const std::pair<std::size_t, double>> changes) {
  State& s = *state_;
  s.finishEdits();
  const Values next = s.changed(s.values, changes);
  if (next == s.values) return;
  s.rememberPlaces();
  s.history.record(s.values);
  s.assign(next);
  s.notify(EditorEvent::kChange);
}

void Editor::setValueContinuous(std::size_t parameter, double value) {
  State& s = *state_;
  assert(parameter < s.values.size());
  if (s.handleGesture) s.finishEdits();
  if (!s.continuing) {
    s.rememberPlaces();
    s.continuing = s.values;
  }
  Values next = s.values;
  next.set(parameter, clampValue(s.model.parameters()[parameter], value));
  s.assign(next);
}

void Editor::endContinuous() {
  if (state_->continuing) state_->finishEdits();
}

void Editor::undo() {
  State& s = *state_;
  s.finishEdits();
  s.step(s.history.undo(s.values));
}

void Editor::redo() {
  State& s = *state_;
  s.finishEdits();
  s.step(s.history.redo(s.values));
}

bool Editor::canUndo() const {
  const State& s = *state_;
  return s.history.canUndo() || s.editsOpenly();
}
bool Editor::canRedo() const { return state_->history.canRedo() && !state_->editsOpenly(); }

void Editor::State::notify(EditorEvent event) {
  // A host that asks once a frame wants to know that something moved, not how often; one that never asks must not let the list grow.
  const bool repeats = event == EditorEvent::kInput || event == EditorEvent::kCameraChange;
  if (events.size() == kMostEvents || (repeats && std::ranges::find(events, event) != events.end())) return;
  events.push_back(event);
}

PlaceMemory::Picture Editor::State::picture() const { return {camera, widthPx, heightPx}; }

/// What the placer remembers now; kept for the values as they are, unless nothing has been placed for them yet.
Placer::Memory Editor::State::rememberPlaces() {
  Placer::Memory memory = placer.memory();
  if (placedInScene && !sceneStale) places.remember(values, picture(), memory);
  return memory;
}

/// Goes a step back or forward: to the values and, if nobody has turned the model since, to where all lines lay.
void Editor::State::step(const std::optional<Values>& to) {
  if (!to) return;
  rememberPlaces();
  if (!assign(*to)) return;
  recall = places.placesOf(*to, picture());
  notify(EditorEvent::kChange);
}

/// Makes `next` the present values. False when they are already.
bool Editor::State::assign(const Values& next) {
  if (next == values) return false;
  values = next;
  recall.reset();  // it was of other values
  sceneStale = true;
  notify(EditorEvent::kInput);
  return true;
}

/// Ends whatever edit is under way, as letting go would, so that another one can begin.
void Editor::State::finishEdits() {
  if (handleGesture) endHandleGesture();
  if (!continuing) return;
  Values before = std::move(*continuing);
  continuing.reset();
  if (before == values) return;
  history.record(std::move(before));
  notify(EditorEvent::kChange);
}

// --- Viewport and camera
// ----------------------------------------------------------------------------------------------

void Editor::resize(double widthPx, double heightPx, double devicePixelRatio) {
  State& s = *state_;
  if (!std::isfinite(widthPx) || !std::isfinite(heightPx) || !std::isfinite(devicePixelRatio)) return;
  widthPx = std::clamp(widthPx, 0.0, kMaxSizePx);
  heightPx = std::clamp(heightPx, 0.0, kMaxSizePx);
  devicePixelRatio = std::clamp(devicePixelRatio, kMinPixelRatio, kMaxPixelRatio);
  if (widthPx == s.widthPx && heightPx == s.heightPx && devicePixelRatio == s.devicePixelRatio) return;
  if (s.handleGesture) {
    s.followPointers();
    s.handleGesture->regrips = true;
  }
  s.widthPx = widthPx;
  s.heightPx = heightPx;
  s.recall.reset();
  s.devicePixelRatio = devicePixelRatio;
  s.settlesAtOnce = false;
  s.viewStale = true;
  s.pictureStale = true;
  if (s.cameraUntouched && s.loaded && !s.handleGesture) s.openingCamera();
  // One that was fitted to a size which was not there, or is not any more, and that no frame has shown.
  if (s.compositionDue && !s.cameraUntouched && s.hasSize()) fitToView();
  if (s.cameraGesture) s.resumeCameraGesture();
}

const Camera& Editor::camera() const { return state_->camera; }

Status Editor::setCamera(const Camera& camera) {
  State& s = *state_;
  if (Status status = validate(camera); !status) return status;
  s.cameraGesture.reset();
  if (camera != s.camera) s.fittedAlong.reset();
  s.moveCamera(camera);
  return okStatus();
}

void Editor::fitToView() {
  State& s = *state_;
  if (!s.loaded) return;
  if (s.sceneStale) s.rebuild();
  s.cameraGesture.reset();
  const double width = std::max(s.widthPx, 1.0), height = std::max(s.heightPx, 1.0);
  const View view(s.camera, width, height, s.scene.bounds);
  const Camera camera = s.fittedAlong ? lookingAlong(*s.fittedAlong, view) : uncentred(view, s.scene.bounds);
  s.moveCamera(dimline::fitToView(camera, s.scene.bounds, width, height));
  s.fitted();
}

void Editor::setStandardView(StandardView view) {
  State& s = *state_;
  if (!s.loaded) return;
  if (s.sceneStale) s.rebuild();
  s.cameraGesture.reset();
  Camera camera = s.camera;
  camera.up = {0, 1, 0};
  camera.eye = camera.target + directionOf(view);
  s.moveCamera(dimline::fitToView(camera, s.scene.bounds, std::max(s.widthPx, 1.0), std::max(s.heightPx, 1.0)));
  s.fitted();
}

void Editor::setOrthographic(bool orthographic) {
  State& s = *state_;
  if (orthographic == s.camera.orthographic()) return;
  s.cameraGesture.reset();
  const bool untouched = s.cameraUntouched, compositionDue = s.compositionDue;
  s.moveCamera(withProjection(s.camera, orthographic));
  s.cameraUntouched = untouched;
  s.compositionDue = compositionDue;
}

/// Somebody chose where the camera stands.
void Editor::State::moveCamera(const Camera& next) {
  if (!validate(next)) return;
  cameraUntouched = false;
  compositionDue = false;
  if (next == camera) return;  // or two hosts that follow each other would do so for ever
  settlesAtOnce = false;
  if (handleGesture) endHandleGesture();  // a drag is measured by the camera with which it began
  camera = next;
  recall.reset();  // it was of another picture
  viewStale = true;
  notify(EditorEvent::kCameraChange);
}

/// The view in which a model opens, in the projection of the present camera.
void Editor::State::openingCamera() {
  const double width = std::max(widthPx, 1.0);
  const double height = std::max(heightPx, 1.0);
  const bool orthographic = camera.orthographic();
  camera = threeQuarterView(scene.bounds, hasSize() ? width : 1.0, hasSize() ? height : 1.0);
  if (orthographic) camera = dimline::fitToView(withProjection(camera, true), scene.bounds, width, height);
  cameraUntouched = true;
  fitted();
  viewStale = true;
  notify(EditorEvent::kCameraChange);
}

/// The camera stands as the model alone would have it, and looks where it was meant to.
void Editor::State::fitted() {
  compositionDue = true;
  fittedAlong = Vec3(0, 0, 1);
}

/// Centres the picture with its lines.
void Editor::State::compose() {
  compositionDue = false;
  if (!linesShown) return;
  uploadScene();  // first: the driver has work to do with it meanwhile
  const View view = currentView();
  const auto fields = fieldSource.measure(view, FieldsFrom::kCpu, devicePixelRatio, nullptr);
  if (!fields) return;
  const Camera next = composed(view, *fields, scene, placedValues(), placer);
  settlesAtOnce = true;
  if (next == camera) return;
  camera = next;
  const View now = currentView();
  fittedAlong = Vec3(glm::dot(view.forward(), now.right()), glm::dot(view.forward(), now.up()), glm::dot(view.forward(), now.forward()));
  if (cameraGesture) resumeCameraGesture();
  viewStale = true;
  notify(EditorEvent::kCameraChange);
}

// --- What the last frame left
// ------------------------------------------------------------------------------------------

const Layout& Editor::layout() const { return state_->drawn; }
std::span<const Editor::LineState> Editor::lineStates() const { return state_->lineStates; }

std::vector<Editor::FadingLine> Editor::fadingLines() const {
  std::vector<FadingLine> lines;
  for (const auto& fading : state_->animator.fading()) lines.push_back({fading.placed, fading.opacity});
  return lines;
}

std::span<const Editor::LineState> Editor::otherStates() const { return state_->otherStates; }

std::vector<Editor::FadingHandle> Editor::fadingHandles() const {
  std::vector<FadingHandle> handles;
  for (const auto& fading : state_->handleAnimator.fading()) handles.push_back({fading.placed, fading.opacity});
  return handles;
}

void Editor::setLinesShown(bool shown) {
  State& s = *state_;
  if (s.linesShown == shown) return;
  s.finishEdits();  // nobody goes on dragging what is not there
  s.linesShown = shown;
  s.pictureStale = true;
}
bool Editor::linesShown() const { return state_->linesShown; }

void Editor::setReducedMotion(bool reduced) {
  state_->animator.setReducedMotion(reduced);
  state_->handleAnimator.setReducedMotion(reduced);
}

std::vector<EditorEvent> Editor::takeEvents() { return std::exchange(state_->events, {}); }

void Editor::setFieldsFrom(FieldsFrom from) {
  state_->fieldSource.setFrom(from);
  state_->visibilitySource.setFrom(from);
  state_->viewStale = true;
}
Editor::FieldsFrom Editor::fieldsFrom() const { return state_->fieldSource.from(); }
Editor::FieldsFrom Editor::fieldsMeasuredBy() const { return state_->fieldSource.active(state_->renderer.get()); }
const Editor::Timings& Editor::timings() const { return state_->timings; }

}  // namespace dimline
