#include <cmath>
#include <utility>

#include "app/editor_state.h"
#include "app/ray_cast.h"

// A gesture of the camera belongs to the pointer that began it; other pointers do nothing until it ends, but for a second finger, which turns an orbit into a
// pan and zoom. Handles are dragged by as many pointers as take hold of one, each of another parameter; what touches anything else meanwhile does nothing.
// Every movement is computed from the gesture's start.

namespace dimline {

namespace {

/// px. Two fingers nearer than this say nothing about their distance.
constexpr double kLeastFingerSpanPx = 10.0;

/// Browsers report a pinch on a track pad as a wheel with ctrl and deltas of a few pixels (three.js scales them alike);
/// a wheel's notch is about 100.
constexpr double kPinchScale = 10.0;
constexpr double kMostPinchPx = 30.0;
constexpr double kMostWheelPx = 400.0;

Snap snapFor(const Modifiers& modifiers) { return modifiers.alt ? Snap::kNone : modifiers.shift ? Snap::kFine : Snap::kStep; }

CameraGesture::Kind kindFor(const PointerInput& input) {
  const bool modified = input.modifiers.ctrl || input.modifiers.meta || input.modifiers.shift;
  if (input.button == PointerButton::kMiddle) return CameraGesture::Kind::kZoom;
  if (input.button == PointerButton::kSecondary)
    return modified ? CameraGesture::Kind::kOrbit : CameraGesture::Kind::kPan;
  return modified ? CameraGesture::Kind::kPan : CameraGesture::Kind::kOrbit;
}

}  // namespace

PointerTarget Editor::pointerDown(const PointerInput& input) {
  State& s = *state_;
  if (!isFinite(input.screen) || !s.loaded || !s.hasSize()) return PointerTarget::kNothing;
  if (s.handleGesture) return input.button == PointerButton::kPrimary && s.takeHandle(input) ? PointerTarget::kHandle : PointerTarget::kNothing;
  if (s.cameraGesture) {
    const bool secondFinger =
        input.kind == PointerKind::kTouch && s.cameraGesture->pointerKind == PointerKind::kTouch &&
        s.cameraGesture->kind != CameraGesture::Kind::kTwoFingers && input.id != s.cameraGesture->first.id;
    if (!secondFinger) return PointerTarget::kNothing;
    s.addFinger(input);
    return PointerTarget::kCamera;
  }
  if (input.button == PointerButton::kPrimary && s.takeHandle(input)) return PointerTarget::kHandle;
  s.beginCameraGesture(input);
  return PointerTarget::kCamera;
}

PointerTarget Editor::pointerMove(const PointerInput& input) {
  State& s = *state_;
  if (s.handleGesture) {
    const auto hold = s.handleGesture->holdOf(input.id);
    if (hold == s.handleGesture->holds.end()) return PointerTarget::kNothing;
    if (isFinite(input.screen)) s.moveHold(*hold, input);
    return PointerTarget::kHandle;
  }
  if (s.cameraGesture) {
    CameraGesture& gesture = *s.cameraGesture;
    CameraGesture::Pointer* pointer = input.id == gesture.first.id ? &gesture.first : nullptr;
    if (gesture.kind == CameraGesture::Kind::kTwoFingers && input.id == gesture.second.id) pointer = &gesture.second;
    if (pointer == nullptr) return PointerTarget::kNothing;
    if (isFinite(input.screen) && pointer->now != input.screen) {
      pointer->now = input.screen;
      s.moveCameraGesture();
    }
    return PointerTarget::kCamera;
  }
  return PointerTarget::kNothing;
}

void Editor::pointerUp(const PointerInput& input) {
  State& s = *state_;
  pointerMove(input);
  if (s.handleGesture) s.releaseHandle(input.id);
  if (s.cameraGesture) s.endCameraPointer(input.id);
}

void Editor::cancelGesture() {
  State& s = *state_;
  if (s.handleGesture) s.cancelHandleGesture();
  if (s.cameraGesture) s.cancelCameraGesture();
}

void Editor::cancelPointer(int id) {
  State& s = *state_;
  if (s.handleGesture) return s.withdrawHandle(id);
  const auto& camera = s.cameraGesture;
  if (camera && (id == camera->first.id || (camera->kind == CameraGesture::Kind::kTwoFingers && id == camera->second.id))) cancelGesture();
}

void Editor::wheel(const Vec2& screen, double deltaPx, const Modifiers& modifiers) {
  State& s = *state_;
  if (!isFinite(screen) || !std::isfinite(deltaPx) || !s.loaded || !s.hasSize() || s.handHolds()) return;
  double delta = std::clamp(deltaPx, -kMostWheelPx, kMostWheelPx);
  if (modifiers.ctrl && std::abs(delta) <= kMostPinchPx) delta *= kPinchScale;
  const Camera next = zoom(s.camera, wheelZoomFactor(delta), s.pivotUnder(screen), cameraLimits(s.scene.bounds));
  if (next != s.camera) s.moveCamera(next);
}

PointerTarget Editor::hover(const PointerInput& input) {
  State& s = *state_;
  if (!isFinite(input.screen)) return PointerTarget::kNothing;
  s.hoverAt = input;
  s.updateHover();
  return s.hovered && s.gripAt(input) ? PointerTarget::kHandle : PointerTarget::kNothing;
}

void Editor::endHover() {
  state_->hoverAt.reset();
  state_->updateHover();
}

// --- Handles
// ----------------------------------------------------------------------------------------------------------

std::optional<GripRef> Editor::State::gripAt(const PointerInput& input) const {
  double radiusPx = input.kind == PointerKind::kTouch ? kGrabRadiusTouchPx : kGrabRadiusMousePx;
  const auto ofLine = hitHandle(drawn.lines, input.screen, radiusPx);
  if (ofLine) {
    const PlacedLine& line = drawn.lines[ofLine->line];
    radiusPx = glm::length(arrowMiddle(line.lineScreen, line.handles[ofLine->handle]) - input.screen);
  }
  if (const auto ofArc = hitArc(drawn.others, drawn.view, input.screen, radiusPx)) return GripRef(*ofArc);
  return ofLine ? std::optional(GripRef(*ofLine)) : std::nullopt;
}

/// What a pointer takes hold of or, where it would not, what it points at: a line, an arc's label. Of a line the same key wherever on it.
std::optional<HandleKey> Editor::State::pointedAt(const PointerInput& input) const {
  if (const auto grip = gripAt(input)) {
    HandleKey key = keyOf(*grip);
    key.atEnd = true;
    return key;
  }
  for (const PlacedHandle& handle : drawn.others) {
    if (handle.arc && handle.box.contains(input.screen)) return keyOf(handle);
  }
  const auto line = hitLine(drawn.lines, input.screen, kPointAtPx);
  return line ? std::optional(keyOf(drawn.lines[*line], true)) : std::nullopt;
}

HandleKey Editor::State::keyOf(const PlacedLine& line, bool atEnd) const {
  return {line.parameter, line.scope < scene.scopes.size() ? scene.scopes[line.scope].index : 0, atEnd};
}

HandleKey Editor::State::keyOf(const PlacedHandle& handle) const {
  return {handle.parameter, handle.scope < scene.scopes.size() ? scene.scopes[handle.scope].index : 0, true};
}

HandleKey Editor::State::keyOf(const GripRef& grip) const {
  if (const auto* other = std::get_if<std::size_t>(&grip)) return keyOf(drawn.others[*other]);
  const auto& [line, handle] = std::get<HandleRef>(grip);
  return keyOf(drawn.lines[line], drawn.lines[line].handles[handle].atEnd);
}

/// The line of a handle as it is placed, wherever it is drawn at the moment.
const PlacedLine* Editor::State::placedLineOf(const HandleKey& key) const {
  for (const PlacedLine& line : placed.lines) {
    if (keyOf(line, key.atEnd) == key) return &line;
  }
  return nullptr;
}

const PlacedHandle* Editor::State::placedHandleOf(const HandleKey& key) const {
  for (const PlacedHandle& handle : placed.others) {
    if (handle.arc && keyOf(handle) == key) return &handle;
  }
  return nullptr;
}

/// Brings scene and lines up to date with values that were set since the last frame: a drag starts from both.
void Editor::State::catchUp() {
  if (!handleGesture) finishEdits();
  followPointers();
  if (!sceneStale) return;
  rebuild();
  const View view = currentView();
  measureAndPlace(view);
  animate(view);
}

/// Takes hold of the handle under the pointer, if there is one that no other pointer has: of each parameter one.
bool Editor::State::takeHandle(const PointerInput& input) {
  // What is hit is what is seen; what is dragged is the same line where it belongs by now. One that still glides is
  // taken where it is going to, so that nobody edits with a line that has no place.
  const auto hit = gripAt(input);
  if (!hit) return false;
  const HandleKey key = keyOf(*hit);
  if (handleGesture && (handleGesture->drags(key.parameter) || handleGesture->holdOf(input.id) != handleGesture->holds.end())) return false;
  const auto* onLine = std::get_if<HandleRef>(&*hit);
  const Handle& seen = onLine != nullptr ? drawn.lines[onLine->line].handles[onLine->handle]
                                         : drawn.others[std::get<std::size_t>(*hit)].handles.front();
  const Vec2 grabOffset = input.screen - seen.screen;
  catchUp();
  auto taken = takeHold(key, grabOffset, currentView());
  if (!taken) return false;
  if (!handleGesture) handleGesture = HandleGesture{values, rememberPlaces(), {}};
  handleGesture->holds.push_back({input.id, input.kind, snapFor(input.modifiers), input.screen, std::move(*taken)});
  hoverAt.reset();
  updateHover();
  compositionDue = false;  // the camera stays where the hand has taken hold
  viewStale = true;
  return true;
}

std::optional<ValueDrag> Editor::State::takeHold(const HandleKey& key, const Vec2& grabOffset, const View& view) const {
  if (const PlacedLine* line = placedLineOf(key)) {
    const Handle handle{key.atEnd, view.toScreen(key.atEnd ? line->line.end : line->line.start)};
    auto begun = HandleDrag::begin(model, values, scene, *line, handle, handle.screen + grabOffset, view);
    return begun ? std::optional(ValueDrag(std::move(*begun))) : std::nullopt;
  }
  if (const PlacedHandle* handle = placedHandleOf(key)) {
    const Vec2 tip = view.toScreen(handle->arc->at(handle->arc->angleRad));
    auto begun = ArcDrag::begin(model, values, *handle, tip + grabOffset, view);
    return begun ? std::optional(ValueDrag(std::move(*begun))) : std::nullopt;
  }
  return std::nullopt;
}

/// Only notes where the pointer is: browsers report each pointer by itself and may do so many times a frame, and a value may cost several rebuilds.
void Editor::State::moveHold(HandleHold& hold, const PointerInput& input) {
  hold.at = input.screen;
  hold.snap = snapFor(input.modifiers);
  handleGesture->moved = true;
}

/// Brings the values under the pointers.
void Editor::State::followPointers() {
  if (!handleGesture || !hasSize() || !handleGesture->moved || !regripHandles()) return;
  handleGesture->moved = false;
  assign(handleGesture->valuesUnder(values, currentView()));
}

/// In another viewport handles are somewhere else under the same pointers: these take hold of them there, once they are placed. False until then.
bool Editor::State::regripHandles() {
  if (!handleGesture->regrips) return true;
  for (HandleHold& hold : handleGesture->holds) {
    if (!hold.drag.regrip(placed, hold.at, currentView())) return false;
  }
  handleGesture->regrips = false;
  return true;
}

/// A pointer was lifted: what it did stays.
void Editor::State::releaseHandle(int pointer) {
  const auto hold = handleGesture->holdOf(pointer);
  if (hold == handleGesture->holds.end()) return;
  followPointers();
  handleGesture->holds.erase(hold);
  viewStale = true;  // the line is free to find its place again
  if (handleGesture->holds.empty()) endHandleGesture();
}

/// A pointer was taken away: what it did is undone, and what others do goes on.
void Editor::State::withdrawHandle(int pointer) {
  HandleGesture& gesture = *handleGesture;
  const auto hold = gesture.holdOf(pointer);
  if (hold == gesture.holds.end()) return;
  Values next = values;
  next.set(hold->drag.parameter(), hold->drag.startValue());
  if (gesture.holds.size() == 1 && next == gesture.before) return cancelHandleGesture();
  gesture.holds.erase(hold);
  gesture.moved = false;
  viewStale = true;
  assign(hasSize() && regripHandles() ? gesture.valuesUnder(next, currentView()) : next);
  if (gesture.holds.empty()) endHandleGesture();
}

void Editor::State::endHandleGesture() {
  followPointers();
  const Values before = std::move(handleGesture->before);
  handleGesture.reset();
  viewStale = true;
  if (before == values) return;
  history.record(before);
  notify(EditorEvent::kChange);
}

void Editor::State::cancelHandleGesture() {
  const Values before = std::move(handleGesture->before);
  Placer::Memory placedBefore = std::move(handleGesture->placedBefore);
  handleGesture.reset();
  viewStale = true;
  assign(before);
  recall = std::move(placedBefore);
}

/// Marks what the pointer rests on, in the lines as they are now.
void Editor::State::updateHover() {
  std::optional<HandleKey> now;
  if (hoverAt && !handHolds()) now = pointedAt(*hoverAt);
  if (now == hovered) return;
  hoveredBefore = hovered;
  hovered = now;
  hoverChangedMs = nowMs;
  pictureStale = true;
}

// --- Camera
// -----------------------------------------------------------------------------------------------------------

void Editor::State::beginCameraGesture(const PointerInput& input) {
  CameraGesture gesture;
  gesture.kind = input.kind == PointerKind::kTouch ? CameraGesture::Kind::kOrbit : kindFor(input);
  gesture.pointerKind = input.kind;
  gesture.restore = gesture.start = camera;
  gesture.untouchedBefore = cameraUntouched;
  gesture.compositionDueBefore = compositionDue;
  gesture.viewportBefore = {widthPx, heightPx};
  gesture.first = {input.id, input.screen, input.screen};
  if (gesture.kind == CameraGesture::Kind::kZoom) gesture.pivot = pivotUnder(input.screen);
  cameraGesture = gesture;
  updateHover();
}

/// A second finger: from here on both together pan and zoom.
void Editor::State::addFinger(const PointerInput& input) {
  CameraGesture& gesture = *cameraGesture;
  gesture.kind = CameraGesture::Kind::kTwoFingers;
  gesture.second = {input.id, input.screen, input.screen};
  resumeCameraGesture();
}

/// What the pointers have done is done; what they do from here on is counted anew, from the camera and in the viewport as they are now.
void Editor::State::resumeCameraGesture() {
  CameraGesture& gesture = *cameraGesture;
  gesture.start = camera;
  if (cameraUntouched) gesture.restore = camera;
  gesture.first.start = gesture.first.now;
  gesture.second.start = gesture.second.now;
  if (gesture.kind == CameraGesture::Kind::kTwoFingers && hasSize()) {
    gesture.pivot = pointAtTargetDepth(currentView(), 0.5 * (gesture.first.start + gesture.second.start));
  }
}

/// The camera is as if nobody had touched it: if nobody had before either, it is fitted to a viewport that has become another one.
void Editor::State::cancelCameraGesture() {
  const CameraGesture gesture = *cameraGesture;
  cameraGesture.reset();
  if (camera != gesture.restore) moveCamera(gesture.restore);
  cameraUntouched = gesture.untouchedBefore;
  compositionDue = gesture.compositionDueBefore;
  if (cameraUntouched && gesture.viewportBefore != Vec2(widthPx, heightPx)) openingCamera();
}

void Editor::State::moveCameraGesture() {
  if (!hasSize()) return;
  CameraGesture& gesture = *cameraGesture;
  const CameraLimits limits = cameraLimits(scene.bounds);
  const Vec2 travel = gesture.first.now - gesture.first.start;
  Camera next = camera;
  switch (gesture.kind) {
    case CameraGesture::Kind::kOrbit: {
      const OrbitMove move = orbit(gesture.start, travel, heightPx);
      gesture.first.start.y += move.overrunPx;
      next = move.camera;
      break;
    }
    case CameraGesture::Kind::kPan:
      next = pan(gesture.start, travel, heightPx, limits);
      break;
    case CameraGesture::Kind::kZoom:
      next = zoom(gesture.start, dragZoomFactor(travel.y), gesture.pivot, limits);
      break;
    case CameraGesture::Kind::kTwoFingers: {
      const double spanBefore = std::max(glm::length(gesture.second.start - gesture.first.start), kLeastFingerSpanPx);
      const double span = std::max(glm::length(gesture.second.now - gesture.first.now), kLeastFingerSpanPx);
      const Vec2 middleTravel = 0.5 * (travel + gesture.second.now - gesture.second.start);
      next = pan(zoom(gesture.start, spanBefore / span, gesture.pivot, limits), middleTravel, heightPx, limits);
      break;
    }
  }
  if (next != camera) moveCamera(next);
}

/// One pointer was lifted. Of two fingers the other one goes on, orbiting.
void Editor::State::endCameraPointer(int id) {
  CameraGesture& gesture = *cameraGesture;
  if (gesture.kind == CameraGesture::Kind::kTwoFingers && (id == gesture.first.id || id == gesture.second.id)) {
    if (id == gesture.first.id) gesture.first = gesture.second;
    gesture.kind = CameraGesture::Kind::kOrbit;
    resumeCameraGesture();
    return;
  }
  if (id == gesture.first.id) cameraGesture.reset();
}

void Editor::State::dropGestures() {
  handleGesture.reset();
  cameraGesture.reset();
}

/// The point about which a zoom at this pixel turns nearer or farther: on the model's surface where there is any.
Vec3 Editor::State::pivotUnder(const Vec2& screen) const {
  const View view = currentView();
  if (const auto hit = castRay(scene, view.rayThrough(screen),
                               view.orthographic() ? -std::numeric_limits<double>::infinity() : view.nearM())) {
    return *hit;
  }
  return pointAtTargetDepth(view, screen);
}

}  // namespace dimline
