#include <catch2/catch.hpp>

#include <cmath>

#include "app/editor_stage.h"
#include "editing/arc_projection.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// The box with the door, and on it an angle, a switch and a choice.
ModelDefinition boxWithHandles() {
  ModelDefinition definition = boxWithDoor();
  definition.parameters.push_back({.name = "Pitch",
                                   .title = "Pitch",
                                   .type = ParameterType::kAngle,
                                   .unit = Unit::kDegree,
                                   .defaultValue = 30,
                                   .min = 5,
                                   .max = 60,
                                   .step = 1,
                                   .annotation = "@Handle(scope=Corner, type=angular, orient=front, slip=none)"});
  definition.parameters.push_back({.name = "Attic",
                                   .title = "Attic",
                                   .type = ParameterType::kBool,
                                   .defaultValue = 1,
                                   .annotation = "@Handle(scope=Box, type=boolean, orient=up)"});
  definition.parameters.push_back({.name = "Roof",
                                   .title = "Roof",
                                   .type = ParameterType::kChoice,
                                   .max = 1,
                                   .choices = {"gable", "hip"},
                                   .annotation = "@Handle(scope=Door, type=range, orient=front)"});
  definition.build = [plain = definition.build](const Values& values) {
    Scene scene = plain(values);
    const Obb& box = scene.scopes[0].box;
    scene.scopes.push_back({"Corner", 0, boxAt(box.at({0, 1, 1}), {3, 3, 0.1})});
    finish(scene);
    return scene;
  };
  return definition;
}

struct HandleStage : EditorStage {
  HandleStage() : EditorStage(boxWithHandles()) {
    (void)editor.setCamera(orthoFront());
    settle();
    (void)editor.takeEvents();
  }
  [[nodiscard]] const PlacedHandle& other(std::string_view name) const {
    const auto& others = editor.layout().others;
    const auto found = std::ranges::find(others, indexOf(name), &PlacedHandle::parameter);
    REQUIRE(found != others.end());
    return *found;
  }
  /// On screen: 50 px a metre, the corner's origin, and a point at an angle about it.
  [[nodiscard]] Vec2 about(double deg, double radiusPx) const {
    const Vec2 center = editor.layout().view.toScreen(other("Pitch").arc->center);
    return center + Vec2(std::cos(deg * kRadPerDeg), -std::sin(deg * kRadPerDeg)) * radiusPx;
  }
};

}  // namespace

TEST_CASE("an angle, a switch and a choice are in the layout as drawn, with a state each") {
  const HandleStage stage;
  const auto& others = stage.editor.layout().others;
  REQUIRE(others.size() == 3);
  REQUIRE(stage.editor.otherStates().size() == 3);
  for (const Editor::LineState& state : stage.editor.otherStates()) {
    CHECK(state.opacity == 1);
    CHECK_FALSE(state.hovered);
    CHECK_FALSE(state.dragged);
  }
  CHECK(stage.other("Pitch").arc.has_value());
  CHECK(stage.other("Attic").value == 1);
  CHECK(stage.other("Roof").options.size() == 2);
}

TEST_CASE("an arc's end is dragged about its centre: one undo step, and the arc keeps its place") {
  HandleStage stage;
  const Arc before = *stage.other("Pitch").arc;
  const Vec2 grip = arcArrowMiddle(before, stage.editor.layout().view);
  const Vec2 tip = stage.other("Pitch").handles[0].screen;
  CHECK(stage.editor.hover({.screen = grip}) == PointerTarget::kHandle);
  stage.frame();
  REQUIRE(stage.down(grip) == PointerTarget::kHandle);
  const Vec2 to = stage.about(45, 100) + (grip - tip);
  stage.move(to);
  stage.frame();
  CHECK(stage.value("Pitch") == 45);
  const PlacedHandle& dragged = stage.other("Pitch");
  CHECK(dragged.arc->center == before.center);
  CHECK(dragged.arc->radiusM == before.radiusM);
  CHECK(dragged.text == "45°");
  const auto index = static_cast<std::size_t>(&dragged - stage.editor.layout().others.data());
  CHECK(stage.editor.otherStates()[index].dragged);
  stage.up(to);
  stage.settle();
  CHECK(stage.value("Pitch") == 45);
  CHECK(std::ranges::count(stage.editor.takeEvents(), EditorEvent::kChange) == 1);
  stage.editor.undo();
  stage.settle();
  CHECK(stage.value("Pitch") == 30);
  CHECK_FALSE(stage.editor.canUndo());
}

TEST_CASE("a viewport that changes its size while an arc is dragged changes no angle, and the drag goes on from there") {
  HandleStage stage;
  const Vec2 grip = arcArrowMiddle(*stage.other("Pitch").arc, stage.editor.layout().view);
  stage.down(grip);
  const Vec2 at = stage.about(50, 120);
  stage.move(at);
  stage.frame();
  const double dragged = stage.value("Pitch");
  CHECK(dragged != 30);
  stage.editor.resize(700, 700, 1);
  stage.frame();
  stage.move(at + Vec2(0.1, 0));
  stage.frame();
  CHECK(stage.value("Pitch") == dragged);
  stage.move(at + Vec2(0.1, -15));
  stage.frame();
  CHECK(stage.value("Pitch") > dragged);
  stage.up(at + Vec2(0.1, -15));
}

TEST_CASE("cancelling the drag of an arc takes it back exactly") {
  HandleStage stage;
  const PlacedHandle before = stage.other("Pitch");
  const Vec2 grip = arcArrowMiddle(*before.arc, stage.editor.layout().view);
  stage.down(grip);
  stage.move(stage.about(50, 120));
  stage.frame();
  CHECK(stage.value("Pitch") != 30);
  stage.editor.cancelGesture();
  stage.settle();
  CHECK(stage.value("Pitch") == 30);
  CHECK(stage.other("Pitch").box.min == before.box.min);
  CHECK(stage.other("Pitch").handles[0].screen == before.handles[0].screen);
  CHECK_FALSE(stage.editor.canUndo());
}

TEST_CASE("the pointer over an arc's arrowhead marks it, and beside it marks nothing") {
  HandleStage stage;
  const Vec2 grip = arcArrowMiddle(*stage.other("Pitch").arc, stage.editor.layout().view);
  const auto hovered = [&] { return std::ranges::count_if(stage.editor.otherStates(), &Editor::LineState::hovered); };
  CHECK(stage.editor.hover({.screen = grip}) == PointerTarget::kHandle);
  stage.settle();
  CHECK(hovered() == 1);
  CHECK(stage.editor.hover({.screen = stage.other("Attic").box.center()}) == PointerTarget::kNothing);
  stage.settle();
  CHECK(hovered() == 0);
}

TEST_CASE("lines and handles can be put away, and come back where they were") {
  HandleStage stage;
  const Layout before = stage.editor.layout();
  stage.editor.setLinesShown(false);
  stage.settle();
  CHECK(stage.editor.layout().lines.empty());
  CHECK(stage.editor.layout().others.empty());
  CHECK(stage.down(before.lines[0].handles[0].screen) == PointerTarget::kCamera);
  stage.editor.cancelGesture();
  stage.editor.setLinesShown(true);
  stage.settle();
  CHECK(sameLayout(before, stage.editor.layout()));
  CHECK(stage.editor.layout().others.size() == 3);
}

TEST_CASE("lines that are put away in the middle of a drag end it as letting go would") {
  HandleStage stage;
  const Vec2 grip = arcArrowMiddle(*stage.other("Pitch").arc, stage.editor.layout().view);
  stage.down(grip);
  stage.move(stage.about(50, 120));
  stage.frame();
  const double dragged = stage.value("Pitch");
  REQUIRE(dragged != 30);
  stage.editor.setLinesShown(false);
  stage.move(stage.about(10, 120));
  stage.settle();
  CHECK(stage.value("Pitch") == dragged);
  stage.editor.undo();
  CHECK(stage.value("Pitch") == 30);
}

TEST_CASE("frames of an orbit with handles of every kind allocate nothing once it has been flown") {
  HandleStage stage;
  const auto fly = [&] { return allocatedInFlight(stage, 90, 1, [](int i) { return orbitCamera({0, 2, 0}, 30, 4.0 * i, 20); }); };
  fly();
  fly();
  REQUIRE(fly() == 0);
}
