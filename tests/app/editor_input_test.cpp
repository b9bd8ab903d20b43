#include <catch2/catch.hpp>

#include <limits>

#include "app/editor_stage.h"
#include "support/random.h"

using namespace dimline;
using namespace dimline::test;
using Events = std::vector<EditorEvent>;

namespace {

struct FrontStage : EditorStage {
  FrontStage() {
    (void)editor.setCamera(orthoFront());
    settle();
    (void)editor.takeEvents();
  }
};

}  // namespace

TEST_CASE(
    "dragging the end of the width by 30 px of 50 a metre makes the house 1.2 m wider, since it grows on both sides") {
  FrontStage stage;
  const Vec2 grabbed = stage.handle("Width") + Vec2(-4, 2);
  REQUIRE(stage.down(grabbed) == PointerTarget::kHandle);
  REQUIRE(stage.move(grabbed + Vec2(30, 0)) == PointerTarget::kHandle);
  stage.frame();
  REQUIRE(stage.value("Width") == 9.2);
  REQUIRE(stage.editor.scene().scopes[0].box.size.x == 9.2);
  REQUIRE(glm::length(stage.handle("Width") + Vec2(-4, 2) - grabbed - Vec2(30, 0)) < 1e-6);  // still under the pointer
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput});
  stage.up(grabbed + Vec2(30, 0));
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kChange});
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
}

TEST_CASE("taking hold of a handle moves nothing") {
  EditorStage stage;
  for (const char* name : {"Width", "Height", "Depth", "DoorWidth", "DoorHeight"}) {
    if (stage.line(name) == nullptr) continue;
    const Layout before = stage.editor.layout();
    const Camera camera = stage.editor.camera();
    const Vec2 at = stage.handle(name);
    REQUIRE(stage.down(at) == PointerTarget::kHandle);
    stage.settle();
    INFO(name);
    REQUIRE(sameLayout(before, stage.editor.layout()));
    stage.up(at);
    stage.settle();
    REQUIRE(sameLayout(before, stage.editor.layout()));
    REQUIRE(stage.editor.camera().eye == camera.eye);
  }
  REQUIRE_FALSE(stage.editor.canUndo());
  REQUIRE(stage.editor.takeEvents().empty());
}

TEST_CASE("there and back is the very value of the start, and no undo step") {
  FrontStage stage;
  stage.set("Width", 8.03);  // off its steps
  stage.editor.setStandardView(StandardView::kThreeQuarter);
  stage.settle();
  const Vec2 at = stage.handle("Width");
  stage.down(at);
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    stage.move(at + random.point(Vec2(-150), Vec2(150)));
    if (random.chance(0.3)) stage.frame();
  }
  REQUIRE(stage.value("Width") != 8.03);
  stage.up(at);
  REQUIRE(stage.value("Width") == 8.03);
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
}

TEST_CASE("cancelling a drag restores the values exactly") {
  FrontStage stage;
  const Vec2 at = stage.handle("Height");
  stage.down(at);
  stage.move(at + Vec2(0, -60));
  stage.frame();
  REQUIRE(stage.value("Height") == 6.2);
  (void)stage.editor.takeEvents();
  stage.editor.cancelGesture();
  REQUIRE(stage.value("Height") == 5);
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput});
  REQUIRE_FALSE(stage.editor.canUndo());
  REQUIRE(stage.move(at + Vec2(0, -90)) == PointerTarget::kNothing);
  REQUIRE(stage.value("Height") == 5);
}

TEST_CASE("a drag neither moves the camera nor refits the view, and stops at the limits") {
  EditorStage stage;
  const Camera before = stage.editor.camera();
  const PlacedLine line = *stage.line("Width");
  const Vec2 along = glm::normalize(line.lineScreen.end - line.lineScreen.start);
  stage.down(line.lineScreen.end);
  stage.move(line.lineScreen.end + along * 5000.0);
  stage.settle();
  REQUIRE(stage.value("Width") == 20);
  stage.move(line.lineScreen.end - along * 5000.0);
  stage.settle();
  REQUIRE(stage.value("Width") == 0.5);
  stage.up(line.lineScreen.end - along * 5000.0);
  stage.settle();
  REQUIRE(stage.editor.camera().eye == before.eye);
  REQUIRE(stage.editor.camera().target == before.target);
}

TEST_CASE("the dragged line stays on its carrier in the world, and is marked") {
  EditorStage stage;
  const PlacedLine start = *stage.line("Width");
  const Vec3 along = glm::normalize(start.line.end - start.line.start);
  const Vec2 direction = glm::normalize(start.lineScreen.end - start.lineScreen.start);
  stage.down(start.lineScreen.end);
  for (const double travel : {20.0, 60.0, 110.0, -40.0}) {
    stage.move(start.lineScreen.end + direction * travel);
    stage.settle();
    const PlacedLine& now = *stage.line("Width");
    const Vec3 aside = now.line.start - start.line.start;
    REQUIRE(glm::length(aside - along * glm::dot(aside, along)) < 1e-9);
    for (std::size_t i = 0; i < stage.editor.layout().lines.size(); ++i) {
      const bool isIt = stage.editor.layout().lines[i].parameter == stage.indexOf("Width");
      REQUIRE(stage.editor.lineStates()[i].dragged == isIt);
    }
  }
}

TEST_CASE("a script that sets values during a drag ends the drag first") {
  FrontStage stage;
  const Vec2 at = stage.handle("Width");
  stage.down(at);
  stage.move(at + Vec2(25, 0));
  stage.set("Height", 4);
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.move(at + Vec2(100, 0)) == PointerTarget::kNothing);
  REQUIRE(stage.value("Width") == 9);
  stage.editor.undo();
  REQUIRE(stage.value("Height") == 5);
  REQUIRE(stage.value("Width") == 9);
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
}

TEST_CASE("another model during a drag, and the pointer that was down does nothing any more") {
  FrontStage stage;
  const Vec2 at = stage.handle("Width");
  stage.down(at);
  stage.move(at + Vec2(25, 0));
  REQUIRE(stage.editor.setModel(makeModel(boxWithDoor()).value()));
  stage.settle();
  REQUIRE(stage.move(at + Vec2(90, 0)) == PointerTarget::kNothing);
  stage.up(at);
  REQUIRE(stage.value("Width") == 8);
}

TEST_CASE("a pointer that is nowhere is ignored") {
  FrontStage stage;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(stage.down({nan, 10}) == PointerTarget::kNothing);
  const Vec2 at = stage.handle("Width");
  stage.down(at);
  stage.move(at + Vec2(25, 0));
  stage.move({nan, nan});
  stage.frame();
  REQUIRE(stage.value("Width") == 9);
  stage.up({nan, nan});
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.editor.canUndo());
  stage.editor.wheel({nan, 3}, 100, {});
  stage.editor.wheel({500, 500}, nan, {});
  REQUIRE(stage.editor.hover({.screen = {nan, 1}}) == PointerTarget::kNothing);
  REQUIRE(stage.editor.camera().eye == orthoFront().eye);
}

TEST_CASE("a handle under a resting pointer is marked, and grows a little later") {
  FrontStage stage;
  REQUIRE(stage.editor.hover({.screen = stage.handle("Width")}) == PointerTarget::kHandle);
  REQUIRE_FALSE(stage.editor.atRest());
  stage.settle();
  for (std::size_t i = 0; i < stage.editor.layout().lines.size(); ++i) {
    REQUIRE(stage.editor.lineStates()[i].hovered ==
            (stage.editor.layout().lines[i].parameter == stage.indexOf("Width")));
  }
  REQUIRE(stage.editor.hover({.screen = {500, 500}}) == PointerTarget::kNothing);
  stage.settle();
  for (const auto& state : stage.editor.lineStates()) REQUIRE_FALSE(state.hovered);
  stage.editor.hover({.screen = stage.handle("Width")});
  stage.editor.endHover();
  stage.settle();
  for (const auto& state : stage.editor.lineStates()) REQUIRE_FALSE(state.hovered);
}

TEST_CASE("a line under a resting pointer, or its number, is marked like its handle, and is not taken hold of") {
  FrontStage stage;
  const PlacedLine width = *stage.line("Width");
  const auto hovered = [&] { return std::ranges::count_if(stage.editor.lineStates(), &Editor::LineState::hovered); };
  REQUIRE(width.label);
  const Vec2 number = width.label->center();
  const Vec2 shaft = width.lineScreen.start + (width.lineScreen.end - width.lineScreen.start) * 0.2;
  for (const Vec2& at : {number, shaft, shaft + Vec2(0, 4)}) {
    CHECK(stage.editor.hover({.screen = at}) == PointerTarget::kNothing);
    stage.settle();
    CHECK(hovered() == 1);
    stage.editor.endHover();
    stage.settle();
    CHECK(hovered() == 0);
  }
  stage.editor.hover({.screen = shaft + Vec2(0, 9)});
  stage.settle();
  CHECK(hovered() == 0);
  // From the line to its handle nothing changes but what a press would do.
  stage.editor.hover({.screen = shaft});
  stage.settle();
  CHECK(stage.editor.hover({.screen = stage.handle("Width")}) == PointerTarget::kHandle);
  CHECK(stage.editor.atRest());
  stage.down(shaft);
  stage.move(shaft + Vec2(25, 0));
  stage.up(shaft + Vec2(25, 0));
  CHECK(stage.value("Width") == 8);
}

TEST_CASE("a finger reaches farther than a mouse") {
  FrontStage stage;
  const Vec2 beside = stage.handle("Height") + Vec2(20, 6);
  REQUIRE(stage.editor.pointerDown({.kind = PointerKind::kMouse, .screen = beside}) == PointerTarget::kCamera);
  stage.editor.cancelGesture();
  REQUIRE(stage.editor.pointerDown({.kind = PointerKind::kTouch, .screen = beside}) == PointerTarget::kHandle);
}

TEST_CASE("the primary button orbits about the target, by a turn for the viewport's height") {
  EditorStage stage;
  REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 25, 30, 20)));
  stage.settle();
  (void)stage.editor.takeEvents();
  stage.drag({500, 480}, {500 - 250, 480});
  const Camera expected = orbitCamera({0, 2, 0}, 25, 120, 20);
  REQUIRE(glm::length(stage.editor.camera().eye - expected.eye) < 1e-9);
  REQUIRE(stage.editor.camera().target == Vec3(0, 2, 0));
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kCameraChange});
}

TEST_CASE("at the pole an orbit turns back as soon as the pointer does") {
  EditorStage stage;
  REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 25, 30, 20)));
  stage.settle();
  stage.down({500, 100});
  stage.move({500, 900});  // far beyond the pole
  const double atPole = stage.editor.camera().eye.y;
  REQUIRE(atPole == Approx(27).margin(1e-3));
  stage.move({500, 800});  // 36 degrees back
  const Vec3 d = stage.editor.camera().eye - stage.editor.camera().target;
  REQUIRE(std::asin(d.y / 25) * 180 / 3.14159265358979 == Approx(54).margin(0.05));
}

TEST_CASE("the secondary button, and the primary one with a modifier, pan") {
  for (const auto& [button, modifiers] : {std::pair{PointerButton::kSecondary, Modifiers{}},
                                          {PointerButton::kPrimary, Modifiers{.shift = true}},
                                          {PointerButton::kPrimary, Modifiers{.ctrl = true}},
                                          {PointerButton::kPrimary, Modifiers{.meta = true}}}) {
    FrontStage stage;
    stage.drag({500, 480}, {600, 430}, button, modifiers);  // 2 m to the right, 1 m up: the camera goes the other way
    REQUIRE(glm::length(stage.editor.camera().target - Vec3(-2, 1.5, 0)) < 1e-9);
    REQUIRE(glm::length(stage.editor.camera().eye - Vec3(-2, 1.5, 40)) < 1e-9);
  }
}

TEST_CASE("the middle button zooms") {
  FrontStage stage;
  stage.drag({500, 400}, {500, 600}, PointerButton::kMiddle);
  REQUIRE(*stage.editor.camera().orthoHeightM == Approx(40));
}

TEST_CASE("the wheel zooms towards the surface under the pointer") {
  EditorStage stage;
  REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 25, 30, 20)));
  stage.settle();
  const View before = stage.editor.layout().view;
  const Vec3 corner{4, 5, 3};  // of the box's front, upper right
  const Vec2 pointer = before.toScreen(corner - Vec3(0.2, 0.2, 0));
  stage.editor.wheel(pointer, -500, {});
  stage.editor.wheel(pointer, -500, {});
  stage.settle();
  const View after = stage.editor.layout().view;
  REQUIRE(glm::length(after.toScreen(corner - Vec3(0.2, 0.2, 0)) - pointer) < 1e-3);  // the box's vertices are floats
  REQUIRE(glm::length(after.camera().eye - corner) < 0.8 * glm::length(before.camera().eye - corner));
}

TEST_CASE("a pinch on a track pad counts more than its few pixels") {
  FrontStage stage;
  stage.editor.wheel({500, 500}, -5, {.ctrl = true});
  const double pinched = *stage.editor.camera().orthoHeightM;
  FrontStage other;
  other.editor.wheel({500, 500}, -50, {});
  REQUIRE(pinched == Approx(*other.editor.camera().orthoHeightM));
}

TEST_CASE("cancelling a camera gesture puts the camera back exactly") {
  EditorStage stage;
  const Camera before = stage.editor.camera();
  stage.down({500, 480});
  stage.move({620, 300});
  REQUIRE(stage.editor.camera().eye != before.eye);
  stage.editor.cancelGesture();
  REQUIRE(stage.editor.camera().eye == before.eye);
  REQUIRE(stage.move({700, 300}) == PointerTarget::kNothing);
}

TEST_CASE("two fingers pan and zoom: what is under them stays under them") {
  FrontStage stage;
  const auto touch = [](int id, const Vec2& at) {
    return PointerInput{.id = id, .kind = PointerKind::kTouch, .screen = at};
  };
  REQUIRE(stage.editor.pointerDown(touch(1, {400, 480})) == PointerTarget::kCamera);
  REQUIRE(stage.editor.pointerDown(touch(2, {600, 480})) == PointerTarget::kCamera);
  // 4 m of the plane through the target lie between them: x from -2 to 2, y = 2.9.
  stage.editor.pointerMove(touch(1, {350, 580}));
  stage.editor.pointerMove(touch(2, {750, 580}));
  stage.settle();
  const View& view = stage.editor.layout().view;
  REQUIRE(glm::length(view.toScreen({-2, 2.9, 0}) - Vec2(350, 580)) < 1e-6);
  REQUIRE(glm::length(view.toScreen({2, 2.9, 0}) - Vec2(750, 580)) < 1e-6);

  // One is lifted: the other goes on and orbits.
  stage.editor.pointerUp(touch(1, {350, 580}));
  const Camera before = stage.editor.camera();
  REQUIRE(stage.editor.pointerMove(touch(2, {850, 580})) == PointerTarget::kCamera);
  REQUIRE(stage.editor.camera().target == before.target);
  REQUIRE(glm::length(stage.editor.camera().eye - before.eye) > 1);
  stage.editor.pointerUp(touch(2, {850, 580}));
  REQUIRE(stage.editor.pointerMove(touch(2, {950, 580})) == PointerTarget::kNothing);
}

TEST_CASE("a second finger does not disturb a drag") {
  FrontStage stage;
  const Vec2 at = stage.handle("Width");
  REQUIRE(stage.editor.pointerDown({.id = 1, .kind = PointerKind::kTouch, .screen = at}) == PointerTarget::kHandle);
  REQUIRE(stage.editor.pointerDown({.id = 2, .kind = PointerKind::kTouch, .screen = {500, 500}}) ==
          PointerTarget::kNothing);
  REQUIRE(stage.editor.pointerMove({.id = 2, .kind = PointerKind::kTouch, .screen = {600, 500}}) ==
          PointerTarget::kNothing);
  REQUIRE(stage.editor.camera().eye == orthoFront().eye);
  stage.editor.pointerMove({.id = 1, .kind = PointerKind::kTouch, .screen = at + Vec2(25, 0)});
  stage.frame();
  REQUIRE(stage.value("Width") == 9);
}

TEST_CASE("random input of all sorts breaks nothing") {
  ModelDefinition definition = boxWithDoor();
  definition.measures.push_back({{.name = "Top", .title = "Top", .unit = Unit::kMetre, .annotation = "@Handle(scope=Model, orient=up)"}, {}});
  EditorStage stage(std::move(definition));
  Random random(9);
  const auto point = [&] {
    return random.chance(0.02) ? Vec2(std::numeric_limits<double>::infinity()) : random.point(Vec2(-200), Vec2(1200));
  };
  for (int i = 0; i < 3000; ++i) {
    PointerInput input{.id = random.whole(1, 3),
                       .kind = static_cast<PointerKind>(random.whole(0, 2)),
                       .button = static_cast<PointerButton>(random.whole(0, 2)),
                       .modifiers = {.shift = random.chance(0.2), .ctrl = random.chance(0.2), .alt = random.chance(0.2)},
                       .screen = point()};
    if (random.chance(0.3) && !stage.editor.layout().lines.empty()) {
      const auto& lines = stage.editor.layout().lines;
      input.screen =
          lines[static_cast<std::size_t>(random.whole(0, static_cast<int>(lines.size()) - 1))].lineScreen.end;
    }
    switch (random.whole(0, 11)) {
      case 0:
      case 1:
        stage.editor.pointerDown(input);
        break;
      case 2:
      case 3:
      case 4:
        stage.editor.pointerMove(input);
        break;
      case 5:
        stage.editor.pointerUp(input);
        break;
      case 6:
        stage.editor.wheel(input.screen, random.real(-300, 300), input.modifiers);
        break;
      case 7:
        stage.editor.hover(input);
        break;
      case 8:
        random.chance(0.5) ? stage.editor.undo() : stage.editor.redo();
        break;
      case 9:
        stage.editor.setValueContinuous(static_cast<std::size_t>(random.whole(0, 4)), random.real(-5, 30));
        break;
      case 10:
        random.chance(0.5) ? stage.editor.cancelGesture() : stage.editor.endContinuous();
        break;
      default:
        stage.editor.setOrthographic(random.chance(0.5));
        break;
    }
    if (random.chance(0.03)) stage.editor.cancelPointer(random.whole(1, 3));
    if (random.chance(0.02)) stage.editor.setHiddenShown(!stage.editor.hiddenShown());
    if (random.chance(0.01)) stage.editor.setMeasuresShown(!stage.editor.measuresShown());
    if (random.chance(0.01)) stage.editor.setDecimalMark(random.chance(0.5) ? ',' : '.');
    for (const Editor::Gesture& gesture : stage.editor.gestures()) {
      if (!(std::abs(glm::length(gesture.direction) - 1) < 1e-9)) FAIL("no direction");
    }
    if (random.chance(0.02)) stage.editor.resize(random.real(0, 1500), random.real(0, 1500), random.real(0.5, 4));
    if (random.chance(0.5)) stage.frame();
    REQUIRE(validate(stage.editor.camera()));
    for (std::size_t p = 0; p < stage.editor.values().size(); ++p) {
      const double value = stage.editor.values().at(p);
      REQUIRE(value == clampValue(stage.editor.model().parameters()[p], value));
    }
  }
  stage.editor.resize(1000, 1000, 1);
  stage.editor.cancelGesture();
  stage.editor.fitToView();
  REQUIRE(stage.settle() < 1000);
}

TEST_CASE("a handle can be taken hold of in the very moment in which a script changed something else") {
  FrontStage stage;
  stage.set("Height", 4);  // no frame since then
  const Vec2 at = stage.handle("Width");
  REQUIRE(stage.down(at) == PointerTarget::kHandle);
  stage.move(at + Vec2(25, 0));
  stage.frame();
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.editor.scene().scopes[0].box.size == Vec3(9, 4, 6));
}
