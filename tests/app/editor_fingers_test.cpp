#include <catch2/catch.hpp>

#include "app/editor_stage.h"

// Several pointers, each with a handle of its own.

using namespace dimline;
using namespace dimline::test;

namespace {

/// A house of two storeys, the upper one on the lower one, each with its height on its left and the width below.
ModelDefinition storeys() {
  ModelDefinition definition;
  definition.name = definition.title = "storeys";
  const auto add = [&](const char* name, const char* annotation) {
    definition.parameters.push_back({.name = name, .title = name, .unit = Unit::kMetre, .defaultValue = 4, .min = 1, .max = 8, .step = 0.1, .annotation = annotation});
  };
  add("Lower", "@Handle(scope=Lower, type=linear-contour, orient=up, slip=scope)");
  add("Upper", "@Handle(scope=Upper, type=linear-contour, orient=up, slip=scope)");
  add("Width", "@Handle(scope=Lower, type=linear-contour, orient=right, slip=scope)");
  definition.build = [](const Values& v) {
    const Obb lower = boxAt({-v.at(2) / 2, 0, -2}, {v.at(2), v.at(0), 4});
    const Obb upper = boxAt({-v.at(2) / 2, v.at(0), -2}, {v.at(2), v.at(1), 4});
    return sceneOf({{"Lower", lower}, {"Upper", upper}});
  };
  return definition;
}

/// Seen from the front, 50 px a metre.
struct FingerStage : EditorStage {
  explicit FingerStage(ModelDefinition definition = storeys()) : EditorStage(std::move(definition)) {
    (void)editor.setCamera(orthoFront());
    settle();
    (void)editor.takeEvents();
  }
  static PointerInput finger(int id, const Vec2& at) { return {.id = id, .kind = PointerKind::kTouch, .screen = at}; }
  PointerTarget down(int id, const Vec2& at) { return editor.pointerDown(finger(id, at)); }
  PointerTarget move(int id, const Vec2& at) { return editor.pointerMove(finger(id, at)); }
  void up(int id, const Vec2& at) { editor.pointerUp(finger(id, at)); }
  struct Places {
    Vec2 width, lower;
  };
  /// Finger 1 takes hold of Width, finger 2 of Lower; where that is.
  Places takeTwo() {
    const Places at{handle("Width"), handle("Lower")};
    REQUIRE(down(1, at.width) == PointerTarget::kHandle);
    REQUIRE(down(2, at.lower) == PointerTarget::kHandle);
    return at;
  }
  [[nodiscard]] int changes() {
    const auto events = editor.takeEvents();
    return static_cast<int>(std::ranges::count(events, EditorEvent::kChange));
  }
};

}  // namespace

TEST_CASE("two fingers drag two handles at once, each stays under its own, and it is one undo step") {
  FingerStage stage;
  const auto [width, lower] = stage.takeTwo();
  REQUIRE(stage.move(1, width + Vec2(25, 0)) == PointerTarget::kHandle);
  REQUIRE(stage.move(2, lower + Vec2(0, -50)) == PointerTarget::kHandle);
  stage.frame();
  CHECK(stage.value("Width") == 5);   // it grows on both sides
  CHECK(stage.value("Lower") == 5);
  CHECK(glm::length(stage.handle("Width") - width - Vec2(25, 0)) < 1e-6);
  CHECK(glm::length(stage.handle("Lower") - lower - Vec2(0, -50)) < 1e-6);
  const auto gestures = stage.editor.gestures();
  REQUIRE(gestures.size() == 2);
  CHECK(gestures[0].id == 1);
  CHECK(gestures[0].parameter == stage.indexOf("Width"));
  CHECK(gestures[1].text == "5.00 m");
  CHECK(std::ranges::count_if(stage.editor.lineStates(), [](const auto& state) { return state.dragged; }) == 2);

  stage.up(1, width + Vec2(25, 0));
  CHECK(stage.changes() == 0);
  CHECK(stage.editor.gestures().size() == 1);
  stage.move(2, lower + Vec2(0, -75));
  stage.up(2, lower + Vec2(0, -75));
  CHECK(stage.changes() == 1);
  CHECK(stage.value("Width") == 5);
  CHECK(stage.value("Lower") == 5.5);
  stage.editor.undo();
  CHECK(stage.value("Width") == 4);
  CHECK(stage.value("Lower") == 4);
  CHECK_FALSE(stage.editor.canUndo());
}

TEST_CASE("handles that move each other's lines both stay under their fingers, in whichever order those have moved") {
  std::vector<double> uppers;
  for (const bool upperFirst : {false, true}) {
    FingerStage stage;
    const Vec2 lower = stage.handle("Lower");
    const Vec2 upper = stage.handle("Upper");
    stage.down(1, upper);
    stage.down(2, lower);
    if (upperFirst) stage.move(1, upper + Vec2(0, -20));
    stage.move(2, lower + Vec2(0, -60));
    if (!upperFirst) stage.move(1, upper + Vec2(0, -20));
    stage.frame();
    CHECK(stage.value("Lower") == Approx(5.2));
    CHECK(stage.value("Upper") == Approx(3.2));   // its top is 0.4 m higher, its foot 1.2 m
    CHECK(glm::length(stage.handle("Lower") - lower - Vec2(0, -60)) < 1e-6);
    CHECK(glm::length(stage.handle("Upper") - upper - Vec2(0, -20)) < 1e-6);
    uppers.push_back(stage.value("Upper"));
    stage.move(2, lower);
    stage.move(1, upper);
    stage.up(2, lower);
    stage.up(1, upper);
    CHECK(stage.value("Lower") == 4);
    CHECK(stage.value("Upper") == 4);
    CHECK_FALSE(stage.editor.canUndo());
  }
  CHECK(uppers[0] == uppers[1]);
}

TEST_CASE("a second finger on another handle of the same parameter, or on none, neither drags nor moves the camera") {
  FingerStage stage;
  const auto& handles = stage.line("Width")->handles;
  const Vec2 grabbed = handles.front().screen;
  stage.down(1, grabbed);
  stage.move(1, grabbed + Vec2(10, 0));
  stage.frame();
  CHECK(stage.down(2, stage.line("Width")->lineScreen.end) == PointerTarget::kNothing);
  CHECK(stage.down(3, {500, 400}) == PointerTarget::kNothing);
  CHECK(stage.move(3, {600, 300}) == PointerTarget::kNothing);
  CHECK(stage.editor.gestures().size() == 1);
  CHECK(stage.editor.camera().eye == orthoFront().eye);
  stage.up(3, {600, 300});
  stage.move(1, grabbed + Vec2(25, 0));
  stage.frame();
  CHECK(stage.value("Width") == 5);
}

TEST_CASE("a finger that is taken away takes back what it did, and the others go on") {
  FingerStage stage;
  const Layout before = stage.editor.layout();
  const auto [width, lower] = stage.takeTwo();
  stage.move(1, width + Vec2(25, 0));
  stage.move(2, lower + Vec2(0, -50));
  stage.editor.cancelPointer(1);
  CHECK(stage.value("Width") == 4);
  CHECK(stage.value("Lower") == 5);
  stage.move(2, lower + Vec2(0, -60));
  stage.frame();
  CHECK(stage.value("Lower") == Approx(5.2));
  stage.editor.cancelPointer(2);
  stage.settle();
  CHECK(stage.editor.gestures().empty());
  CHECK(stage.value("Lower") == 4);
  CHECK(stage.changes() == 0);
  CHECK(sameLayout(before, stage.editor.layout()));

  // What a finger did that was lifted stays, and is a step.
  stage.takeTwo();
  stage.move(1, width + Vec2(25, 0));
  stage.move(2, lower + Vec2(0, -50));
  stage.up(1, width + Vec2(25, 0));
  stage.editor.cancelPointer(2);
  CHECK(stage.value("Width") == 5);
  CHECK(stage.value("Lower") == 4);
  CHECK(stage.changes() == 1);
}

TEST_CASE("a finger that is taken away in another viewport leaves the others' values alone") {
  FingerStage stage;
  const auto [width, lower] = stage.takeTwo();
  stage.move(1, width + Vec2(25, 0));
  stage.move(2, lower + Vec2(0, -50));
  stage.frame();
  REQUIRE(stage.value("Width") == 5);
  stage.editor.resize(1000, 500, 1);
  stage.frame();
  stage.editor.cancelPointer(2);
  CHECK(stage.value("Width") == 5);
  CHECK(stage.value("Lower") == 4);
}

TEST_CASE("cancelling takes back what all fingers have done since the first one went down") {
  FingerStage stage;
  const Layout before = stage.editor.layout();
  const auto [width, lower] = stage.takeTwo();
  stage.move(1, width + Vec2(25, 0));
  stage.frame();
  stage.up(1, width + Vec2(25, 0));
  stage.move(2, lower + Vec2(0, -50));
  stage.frame();
  stage.editor.cancelGesture();
  stage.settle();
  CHECK(stage.value("Width") == 4);
  CHECK(stage.value("Lower") == 4);
  CHECK(stage.move(2, lower) == PointerTarget::kNothing);
  CHECK_FALSE(stage.editor.canUndo());
  CHECK(sameLayout(before, stage.editor.layout()));
}

TEST_CASE("however often fingers move between two frames, the values are worked out once, for where they are then") {
  ModelDefinition definition = storeys();
  int builds = 0;
  definition.build = [build = definition.build, &builds](const Values& v) {
    ++builds;
    return build(v);
  };
  FingerStage stage(std::move(definition));
  const auto [width, lower] = stage.takeTwo();
  stage.settle();
  const auto buildsWith = [&](int moves, double travelPx) {
    builds = 0;
    for (int i = 1; i <= moves; ++i) {
      const double share = static_cast<double>(i) / moves;
      stage.move(1, width + Vec2(share * travelPx, 0));
      stage.move(2, lower + Vec2(0, -share * travelPx));
    }
    CHECK_FALSE(stage.editor.atRest());
    CHECK(builds == 0);
    stage.frame();
    return builds;
  };
  const int once = buildsWith(1, 25);
  CHECK(stage.value("Width") == 5);
  CHECK(stage.value("Lower") == 4.5);
  CHECK(buildsWith(20, 50) <= once);
  CHECK(stage.value("Width") == 6);
  CHECK(stage.value("Lower") == 5);

  // What no frame has seen counts when the fingers are lifted.
  stage.move(1, width + Vec2(60, 0));
  stage.move(2, lower + Vec2(0, -60));
  stage.up(2, lower + Vec2(0, -75));
  CHECK(stage.value("Lower") == 5.5);
  CHECK(stage.value("Width") == Approx(6.4));
  stage.up(1, width + Vec2(75, 0));
  CHECK(stage.value("Width") == 7);
  CHECK(stage.changes() == 1);
}
