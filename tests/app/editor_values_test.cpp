#include <catch2/catch.hpp>

#include "app/editor_stage.h"
#include "app/json.h"
#include "models/models.h"

using namespace dimline;
using namespace dimline::test;
using Limit = Editor::Gesture::Limit;

namespace {

/// The box with the height of its door above the ground as a measure, and one without a line.
ModelDefinition boxWithMeasures() {
  ModelDefinition definition = boxWithDoor();
  definition.measures.push_back({{.name = "OverallHeight",
                                  .title = "Overall height",
                                  .unit = Unit::kMetre,
                                  .annotation = "@Handle(scope=Box, type=linear-contour, orient=up, slip=scope)"},
                                 {}});
  definition.measures.push_back({{.name = "FloorArea", .title = "Floor area", .unit = Unit::kSquareMetre},
                                 [](const Values& v, const Scene&) { return v.at(0) * v.at(2); }});
  return definition;
}

struct FrontStage : EditorStage {
  explicit FrontStage(ModelDefinition definition = boxWithDoor()) : EditorStage(std::move(definition)) {
    (void)editor.setCamera(orthoFront());
    settle();
    (void)editor.takeEvents();
  }
};

}  // namespace

TEST_CASE("what is being dragged can be asked for, and nothing else") {
  FrontStage stage;
  REQUIRE_FALSE(stage.gesture());
  const Vec2 at = stage.handle("Width");
  stage.down(at);
  const auto begun = stage.gesture();
  REQUIRE(begun);
  REQUIRE(begun->parameter == stage.indexOf("Width"));
  REQUIRE(begun->difference.empty());
  REQUIRE(begun->limit == Limit::kNone);
  stage.move(at + Vec2(30, 0));
  stage.frame();
  const auto moved = stage.gesture();
  REQUIRE(moved->value == 9.2);
  REQUIRE(moved->text == "9.20 m");
  REQUIRE(moved->difference == "+1.20 m");
  REQUIRE(glm::length(moved->handle - stage.handle("Width")) < 1e-9);
  REQUIRE(std::abs(moved->direction.x) == Approx(1));
  stage.move(at + Vec2(4000, 0));
  stage.frame();
  REQUIRE(stage.gesture()->limit == Limit::kMax);
  stage.move(at - Vec2(4000, 0));
  stage.frame();
  REQUIRE(stage.gesture()->limit == Limit::kMin);
  stage.up(at - Vec2(4000, 0));
  REQUIRE_FALSE(stage.gesture());
}

TEST_CASE("shift makes the steps of a drag finer, alt takes them away, and letting go of both brings them back") {
  FrontStage stage;
  const Vec2 at = stage.handle("Height");
  stage.down(at);
  const Vec2 to = at - Vec2(0, 28.3);  // 50 px a metre
  const auto valueWith = [&](Modifiers modifiers) {
    stage.editor.pointerMove({.modifiers = modifiers, .screen = to});
    stage.frame();
    return stage.value("Height");
  };
  REQUIRE(valueWith({}) == 5.6);
  REQUIRE(valueWith({.shift = true}) == 5.57);
  REQUIRE(stage.gesture()->snap == DragSnap::kFine);
  REQUIRE(valueWith({.alt = true}) == Approx(5.566).margin(1e-9));
  REQUIRE(stage.gesture()->snap == DragSnap::kNone);
  REQUIRE(valueWith({}) == 5.6);
  for (const Modifiers modifiers : {Modifiers{.shift = true}, Modifiers{.alt = true}, Modifiers{}}) {
    stage.editor.pointerMove({.modifiers = modifiers, .screen = at});
    stage.frame();
    REQUIRE(stage.value("Height") == 5);
  }
}

TEST_CASE("a decimal comma is in the labels at once, and in what is typed into") {
  FrontStage stage;
  stage.editor.setDecimalMark(',');
  stage.settle();
  REQUIRE(stage.line("Width")->text == "8,00 m");
  REQUIRE(stage.editor.inputText(stage.indexOf("Width")) == "8,00 m");
  REQUIRE(stage.editor.parseValue(stage.indexOf("Width"), "7,5").value() == 7.5);
  stage.set("Width", 7.5);
  stage.settle();
  REQUIRE(stage.line("Width")->text == "7,50 m");
  REQUIRE(stage.editor.setModel(makeModel(boxWithDoor()).value()));
  stage.settle();
  REQUIRE(stage.line("Width")->text == "8,00 m");
  stage.editor.setDecimalMark('.');
  stage.settle();
  REQUIRE(stage.line("Width")->text == "8.00 m");
}

TEST_CASE("a parameter is reset in one undo step, and in none when it has its default") {
  FrontStage stage;
  stage.editor.resetParameter(stage.indexOf("Width"));
  REQUIRE_FALSE(stage.editor.canUndo());
  stage.set("Width", 9);
  (void)stage.editor.takeEvents();
  stage.editor.resetParameter(stage.indexOf("Width"));
  REQUIRE(stage.value("Width") == 8);
  REQUIRE(stage.editor.takeEvents() == std::vector{EditorEvent::kInput, EditorEvent::kChange});
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 9);
}

TEST_CASE("the parameter at a place is that of the handle there, or of the label") {
  FrontStage stage;
  REQUIRE(stage.editor.parameterAt(stage.handle("Width"), PointerKind::kMouse) == stage.indexOf("Width"));
  REQUIRE(stage.editor.parameterAt(stage.line("Height")->label->center(), PointerKind::kMouse) == stage.indexOf("Height"));
  REQUIRE_FALSE(stage.editor.parameterAt({500, 480}, PointerKind::kMouse));
  const Vec2 beside = stage.handle("Height") + Vec2(20, 6);
  REQUIRE_FALSE(stage.editor.parameterAt(beside, PointerKind::kMouse));
  REQUIRE(stage.editor.parameterAt(beside, PointerKind::kTouch) == stage.indexOf("Height"));
}

TEST_CASE("measures follow from the values, and have lines only when asked to, which nobody can drag") {
  FrontStage stage(boxWithMeasures());
  FrontStage without;
  REQUIRE(sameLayout(stage.editor.layout(), without.editor.layout()));
  REQUIRE(stage.editor.measures().size() == 2);
  REQUIRE(stage.editor.measures()[0].text == "5.00 m");
  REQUIRE(stage.editor.measures()[1].value == 48);
  const Layout before = stage.editor.layout();

  stage.editor.setMeasuresShown(true);
  stage.settle();
  const Layout& shown = stage.editor.layout();
  REQUIRE(shown.lines.size() == before.lines.size() + 1);
  const PlacedLine& measure = shown.lines.back();  // placed after all others
  REQUIRE(stage.editor.placedModel().parameters()[measure.parameter].name == "OverallHeight");
  REQUIRE(measure.text == "5.00 m");
  REQUIRE(measure.handles.empty());
  REQUIRE(stage.editor.hover({.screen = measure.lineScreen.end}) == PointerTarget::kNothing);
  stage.settle();
  REQUIRE(stage.editor.lineStates().back().hovered);   // pointed at, not taken hold of
  stage.editor.setMeasuresShown(false);
  stage.settle();
  REQUIRE(std::ranges::none_of(stage.editor.lineStates(), &Editor::LineState::hovered));
  stage.editor.endHover();
  stage.editor.setMeasuresShown(true);
  stage.settle();
  REQUIRE(stage.editor.model().parameters().size() == 5);

  stage.set("Height", 6.5);
  stage.settle();
  REQUIRE(stage.editor.layout().lines.back().text == "6.50 m");
  stage.set("Height", 5);
  stage.editor.setMeasuresShown(false);
  // Before the next frame the layout still has a line of what the model no longer has.
  JsonWriter json;
  writeFrame(json, stage.editor.placedModel(), stage.editor.scene(), stage.editor.layout());
  REQUIRE(json.take().find("OverallHeight") == std::string::npos);
  stage.settle();
  REQUIRE(sameLayout(stage.editor.layout(), before));
}

TEST_CASE("while hidden lines are shown every parameter in view has one, and afterwards each is back where it was") {
  EditorStage stage(findBuiltInModel("house").value().definition);
  const auto hiddenNow = [&] {
    return std::ranges::count_if(stage.editor.layout().hidden, [](const HiddenParameter& h) {
      return h.reason != HiddenReason::kOutOfView && h.reason != HiddenReason::kNoScope;
    });
  };
  REQUIRE(stage.editor.setCamera(orbitCamera({0, 3, 0}, 30, 180, 12)));
  stage.settle();
  const Layout before = stage.editor.layout();
  REQUIRE(hiddenNow() > 0);
  stage.editor.setHiddenShown(true);
  stage.settle();
  REQUIRE(hiddenNow() == 0);
  stage.editor.setHiddenShown(false);
  stage.settle();
  REQUIRE(sameLayout(stage.editor.layout(), before));
}

TEST_CASE("the built-in models' measures say what their lines measure") {
  int shown = 0;
  for (const char* name : {"house", "boat", "candler", "helix-house", "floor-area-linear", "floor-area-tapered", "floor-area-stepped"}) {
    EditorStage stage(findBuiltInModel(name).value().definition);
    INFO(name);
    REQUIRE_FALSE(stage.editor.measures().empty());
    const std::size_t parameters = stage.editor.model().parameters().size();
    stage.editor.setMeasuresShown(true);
    stage.settle();
    for (const PlacedLine& line : stage.editor.layout().lines) {
      if (line.parameter < parameters) continue;
      ++shown;
      INFO(line.text);
      CHECK(line.value == Approx(line.lengthM));
      CHECK(line.value == stage.editor.measures()[line.parameter - parameters].value);
      CHECK(line.placement != PlacementKind::kInside);
    }
  }
  REQUIRE(shown == 8);
  EditorStage house(defineHouse());
  REQUIRE(house.editor.measures()[1].text == "218.4 m\xC2\xB2");  // 13.0 by 8.4, two storeys
}
