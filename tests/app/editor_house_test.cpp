#include <catch2/catch.hpp>

#include "app/editor_stage.h"
#include "models/models.h"

using namespace dimline;
using namespace dimline::test;

TEST_CASE("every line of the house can be dragged: there, to the limits, back, and cancelled") {
  EditorStage stage(defineHouse());
  std::vector<std::string> names;
  for (const PlacedLine& line : stage.editor.layout().lines) {
    const std::string& name = stage.editor.model().parameters()[line.parameter].name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  REQUIRE(names.size() > 6);
  for (const std::string& name : names) {
    INFO(name);
    const PlacedLine line = *stage.line(name);
    const double before = stage.value(name);
    const Vec2 along = glm::normalize(line.lineScreen.end - line.lineScreen.start);
    const Vec2 at = line.handles.front().screen;
    REQUIRE(stage.down(at) == PointerTarget::kHandle);
    std::vector<double> values;
    for (const double travel : {-300.0, -40.0, 40.0, 300.0, 1e5}) {
      stage.move(at + along * travel);
      stage.frame();
      values.push_back(stage.value(name));
    }
    REQUIRE(values.back() == stage.editor.model().parameters()[stage.indexOf(name)].max);
    stage.move(at);
    stage.up(at);
    REQUIRE(stage.value(name) == before);
    stage.settle();

    const Layout placed = stage.editor.layout();
    const PlacedLine again = *stage.line(name);
    stage.down(again.handles.front().screen);
    for (const double travel : {-300.0, 300.0, 30.0}) {
      stage.move(again.handles.front().screen + along * travel);
      stage.frame();
    }
    stage.editor.cancelGesture();
    REQUIRE(stage.value(name) == before);
    stage.settle();
    REQUIRE(sameLayout(placed, stage.editor.layout()));
  }
  REQUIRE_FALSE(stage.editor.canUndo());
}

TEST_CASE("showing measures, and putting them away, leaves every other line where the way there had brought it") {
  EditorStage stage(defineHouse());
  const Camera start = stage.editor.camera();
  const double distanceM = glm::length(start.eye - start.target);
  int moved = 0;
  for (const double to : {-40.0, 120.0, 215.0}) {
    for (double azimuthDeg = to - 60; azimuthDeg <= to; azimuthDeg += 4) {
      REQUIRE(stage.editor.setCamera(orbitCamera(start.target, distanceM, azimuthDeg, 20)));
      stage.settle();
    }
    const std::vector<PlacedLine> before = stage.editor.layout().lines;
    for (const bool shown : {true, false}) {
      stage.editor.setMeasuresShown(shown);
      stage.settle();
      for (const PlacedLine& line : before) moved += std::ranges::none_of(stage.editor.layout().lines, [&](const PlacedLine& now) {
        return now.identity == line.identity && now.lineScreen.start == line.lineScreen.start && now.lineScreen.end == line.lineScreen.end;
      });
    }
  }
  CHECK(moved == 0);
}

TEST_CASE("the house's width and depth are measured along edges in view: when it is wide, and while the visitor comes nearer") {
  const auto expectEdgesInView = [](const EditorStage& stage) {
    const Vec3 eye = stage.editor.camera().eye;
    for (const std::string_view name : {"Width", "Depth"}) {
      const PlacedLine* line = stage.line(name);
      INFO(name);
      REQUIRE(line != nullptr);
      // The visitor stands before the house and to the right of it, so of the walls' lower edges the front one and the right one are in view.
      const Vec3 middle = line->base.middle();
      CHECK((name == "Width" ? middle.z * eye.z : middle.x * eye.x) > 0);
    }
  };
  EditorStage wide(defineHouse(), 1016, 800);
  const std::pair<std::size_t, double> change{wide.indexOf("Width"), 18.0};
  wide.editor.beginWith(std::span(&change, 1));
  wide.settle();
  REQUIRE(wide.value("Width") == 18);
  expectEdgesInView(wide);

  EditorStage stage(defineHouse(), 1016, 800);
  std::size_t inside = 0;
  for (int notch = 0; notch < 14; ++notch) {
    stage.editor.wheel({500, 374}, -100, {});
    stage.settle();
    INFO("after " << notch + 1 << " notches");
    expectEdgesInView(stage);
    inside += stage.line("Width")->placement == PlacementKind::kInside ? 1 : 0;
  }
  CHECK(inside > 0);
}
