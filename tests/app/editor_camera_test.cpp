#include <functional>

#include <catch2/catch.hpp>

#include "app/editor_stage.h"

// The camera and the viewport as hosts change them, also while a handle is dragged: a drag is measured by those with which it began.

using namespace dimline;
using namespace dimline::test;

namespace {

/// Drags the handle of `name` by `byPx` and holds it; gives where the pointer is.
Vec2 holdDragged(EditorStage& stage, std::string_view name, const Vec2& byPx) {
  const Vec2 at = stage.handle(name);
  REQUIRE(stage.down(at) == PointerTarget::kHandle);
  stage.move(at + byPx);
  stage.frame();
  return at + byPx;
}

/// The width's handle goes with a pointer that moves on by 20 px, within a step of the value, `stepPx` on screen.
void expectFollows(EditorStage& stage, const Vec2& to, double dragged, double stepPx) {
  const Vec2 before = stage.handle("Width");
  stage.move(to);
  stage.frame();
  CHECK(stage.value("Width") > dragged);
  CHECK(stage.handle("Width").x - before.x == Approx(20).margin(stepPx));
}

}  // namespace

TEST_CASE("a viewport that changes its size in a drag changes no value, and the drag goes on from there") {
  EditorStage stage;
  for (const bool untouched : {true, false}) {
    if (!untouched) (void)stage.editor.setCamera(orthoFront());
    stage.settle();
    const Vec2 at = holdDragged(stage, "Width", {-40, 0});
    const Camera camera = stage.editor.camera();
    const double dragged = stage.value("Width");
    stage.editor.resize(700, 640, 1);
    stage.frame();
    CHECK(stage.value("Width") == dragged);
    stage.move(at + Vec2(0.1, 0));   // takes hold anew
    stage.frame();
    CHECK(stage.value("Width") == dragged);
    expectFollows(stage, at + Vec2(20.1, 0), dragged, 3);
    CHECK(stage.editor.camera() == camera);
    stage.up(at + Vec2(20.1, 0));
    stage.editor.undo();
    CHECK(stage.value("Width") == 8);
    stage.editor.resize(1000, 1000, 1);
    stage.settle();
  }
}

TEST_CASE("a viewport that has no size for a moment in a drag changes no value") {
  EditorStage stage;
  const Vec2 at = holdDragged(stage, "Width", {-40, 0});
  const double dragged = stage.value("Width");
  stage.editor.resize(0, 0, 1);
  stage.frame();
  stage.editor.resize(1000, 500, 1);
  for (const double byPx : {0.1, 0.2}) {   // before any line is placed in it, and after
    stage.move(at + Vec2(byPx, 0));
    stage.frame();
    CHECK(stage.value("Width") == dragged);
  }
  expectFollows(stage, at + Vec2(20.2, 0), dragged, 6);
}

TEST_CASE("a viewport that changes its size while a hand turns, pans or zooms moves no camera, and the gesture goes on from there") {
  for (const PointerButton button : {PointerButton::kPrimary, PointerButton::kSecondary, PointerButton::kMiddle}) {
    EditorStage stage;
    stage.down({500, 480}, button);
    stage.move({640, 420});
    stage.frame();
    const Camera turned = stage.editor.camera();
    stage.editor.resize(1000, 500, 1);
    stage.frame();
    CHECK(stage.editor.camera() == turned);
    stage.move({641, 420});
    CHECK(glm::length(stage.editor.camera().eye - turned.eye) < 0.02 * glm::length(turned.eye));
  }
}

TEST_CASE("a camera that nobody has chosen is fitted to a viewport that changes, whatever was begun and not done") {
  const auto fitted = [] {
    EditorStage stage(boxWithDoor(), 1000, 500);
    return stage.editor.camera();
  }();
  const auto expectFitted = [&](const auto& act) {
    EditorStage stage;
    const Camera opening = stage.editor.camera();
    act(stage);
    stage.settle();
    CHECK(opening != fitted);
    CHECK(glm::length(stage.editor.camera().eye - fitted.eye) < 1e-9);
  };
  const auto shrink = [](EditorStage& stage) { stage.editor.resize(1000, 500, 1); };
  expectFitted([&](EditorStage& stage) { shrink(stage); });
  expectFitted([&](EditorStage& stage) {   // pressed, and taken back
    stage.down({500, 480});
    stage.editor.cancelGesture();
    shrink(stage);
  });
  expectFitted([&](EditorStage& stage) {   // turned, and taken back
    stage.down({500, 480});
    stage.move({600, 480});
    stage.editor.cancelGesture();
    shrink(stage);
  });
  expectFitted([&](EditorStage& stage) {   // turned, and taken back in the other viewport
    stage.down({500, 480});
    stage.move({600, 480});
    shrink(stage);
    stage.frame();
    stage.editor.cancelGesture();
  });
  expectFitted([&](EditorStage& stage) {   // a wheel that did not turn
    stage.editor.wheel({500, 480}, 0, {});
    shrink(stage);
  });
  expectFitted([&](EditorStage& stage) {   // a hand that was there already moves by nothing
    stage.down({500, 480});
    shrink(stage);
    stage.settle();
    stage.move({500, 481});
    stage.move({500, 480});
    stage.up({500, 480});
  });
}

TEST_CASE("a camera that is set in a drag ends it as letting go would") {
  const auto viewFrom = [](Editor& editor) { editor.setStandardView(StandardView::kRight); };
  const auto parallel = [](Editor& editor) { editor.setOrthographic(!editor.camera().orthographic()); };
  const auto fit = [](Editor& editor) { editor.fitToView(); };
  const auto set = [](Editor& editor) { (void)editor.setCamera(orthoFront()); };
  const std::vector<std::function<void(Editor&)>> ways{viewFrom, parallel, fit, set};
  for (const auto& change : ways) {
    EditorStage stage;
    Vec2 at = holdDragged(stage, "Width", {-40, 0});
    const double dragged = stage.value("Width");
    CHECK(dragged != 8);
    change(stage.editor);
    stage.frame();
    CHECK(stage.editor.gestures().empty());
    stage.move(at += Vec2(30, 0));
    stage.frame();
    CHECK(stage.value("Width") == dragged);
    stage.editor.undo();
    CHECK(stage.value("Width") == 8);
  }
}

TEST_CASE("a camera that is set to what it is changes nothing and is told to nobody") {
  EditorStage stage;
  const Vec2 at = holdDragged(stage, "Width", {-40, 0});
  stage.editor.takeEvents();
  CHECK(stage.editor.setCamera(stage.editor.camera()));
  CHECK(stage.editor.takeEvents().empty());
  CHECK(stage.editor.gestures().size() == 1);
  stage.up(at);
}

TEST_CASE("a model that is to fill a picture without a size fills it when it has one") {
  EditorStage shown, hidden;
  for (EditorStage* stage : {&shown, &hidden}) (void)stage->editor.setCamera(orthoFront());
  hidden.editor.resize(0, 0, 1);
  for (EditorStage* stage : {&shown, &hidden}) stage->editor.setStandardView(StandardView::kTop);
  hidden.editor.resize(1000, 1000, 1);
  shown.settle();
  hidden.settle();
  CHECK(glm::length(hidden.editor.camera().eye - shown.editor.camera().eye) < 1e-6);
  // Only that once: the camera is somebody's choice by now.
  (void)hidden.editor.setCamera(orthoFront());
  hidden.editor.resize(0, 0, 1);
  hidden.editor.resize(800, 900, 1);
  CHECK(hidden.editor.camera() == orthoFront());
}

TEST_CASE("events that nobody takes do not pile up") {
  EditorStage stage;
  for (int i = 0; i < 1000; ++i) {
    stage.set("Width", 5 + i % 2);
    stage.editor.setOrthographic(i % 2 == 0);
  }
  CHECK(stage.editor.takeEvents().size() < 300);
}
