#pragma once

#include <catch2/catch.hpp>

#include "app/editor.h"
#include "support/allocation_count.h"
#include "support/same_layout.h"
#include "support/scenes.h"

/// An editor with a model and a viewport, as its tests drive it.
namespace dimline::test {

struct EditorStage {
  Editor editor;
  double nowMs = 0;

  explicit EditorStage(ModelDefinition definition = boxWithDoor(), double widthPx = 1000, double heightPx = 1000) {
    editor.resize(widthPx, heightPx, 1);
    (void)editor.setModel(makeModel(std::move(definition)).value());
    settle();
    (void)editor.takeEvents();
  }

  /// Frames at 60 Hz until nothing moves; how many it took.
  int settle() {
    int frames = 0;
    do {
      nowMs += 16;
      ++frames;
    } while ((editor.frame(nowMs) || !editor.atRest()) && frames < 1000);
    return frames;
  }
  void frame() { editor.frame(nowMs += 16); }

  [[nodiscard]] std::size_t indexOf(std::string_view name) const {
    return findParameter(editor.model().parameters(), name).value();
  }
  [[nodiscard]] double value(std::string_view name) const { return editor.values().at(indexOf(name)); }
  void set(std::string_view name, double value) {
    const std::pair<std::size_t, double> change{indexOf(name), value};
    editor.setValues(std::span(&change, 1));
  }
  [[nodiscard]] const PlacedLine* line(std::string_view name) const {
    const std::size_t index = indexOf(name);
    for (const PlacedLine& line : editor.layout().lines) {
      if (line.parameter == index) return &line;
    }
    return nullptr;
  }
  /// The screen position of a line's draggable end.
  [[nodiscard]] Vec2 handle(std::string_view name) const { return line(name)->handles.front().screen; }

  /// Of the only handle that is being dragged.
  [[nodiscard]] std::optional<Editor::Gesture> gesture() const {
    const auto all = editor.gestures();
    return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
  }

  PointerTarget down(const Vec2& at, PointerButton button = PointerButton::kPrimary, Modifiers modifiers = {}) {
    return editor.pointerDown({.button = button, .modifiers = modifiers, .screen = at});
  }
  PointerTarget move(const Vec2& to) { return editor.pointerMove({.screen = to}); }
  void up(const Vec2& at) { editor.pointerUp({.screen = at}); }
  void drag(const Vec2& from, const Vec2& to, PointerButton button = PointerButton::kPrimary,
            Modifiers modifiers = {}) {
    down(from, button, modifiers);
    move(0.5 * (from + to));
    move(to);
    up(to);
  }
};

/// What frames allocate, so many from each camera, setting the camera and what events say aside.
template <typename CameraOf>
std::size_t allocatedInFlight(EditorStage& stage, int cameras, int framesAtEach, const CameraOf& cameraOf) {
  std::size_t allocated = 0;
  for (int i = 0; i < cameras; ++i) {
    REQUIRE(stage.editor.setCamera(cameraOf(i)));
    (void)stage.editor.takeEvents();
    const std::size_t before = allocationCount();
    for (int frame = 0; frame < framesAtEach; ++frame) stage.frame();
    allocated += allocationCount() - before;
  }
  return allocated;
}

/// 50 px a metre on 1000 x 1000, the middle of the box with the door in the middle of the picture.
inline Camera orthoFront() {
  Camera camera;
  camera.eye = {0, 2.5, 40};
  camera.target = {0, 2.5, 0};
  camera.orthoHeightM = 20;
  return camera;
}

}  // namespace dimline::test
