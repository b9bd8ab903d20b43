#include <catch2/catch.hpp>

#include <limits>

#include "app/editor_stage.h"
#include "models/models.h"

using namespace dimline;
using namespace dimline::test;
using Events = std::vector<EditorEvent>;

TEST_CASE("an editor without a model does nothing, and does it well") {
  Editor editor;
  editor.resize(800, 600, 2);
  REQUIRE_FALSE(editor.frame(16));
  REQUIRE(editor.atRest());
  editor.undo();
  editor.redo();
  editor.fitToView();
  editor.setStandardView(StandardView::kTop);
  editor.wheel({10, 10}, 100, {});
  editor.cancelGesture();
  REQUIRE(editor.pointerDown({.screen = {10, 10}}) == PointerTarget::kNothing);
  REQUIRE(editor.layout().lines.empty());
  REQUIRE(editor.takeEvents().empty());
  REQUIRE_FALSE(editor.measureFields(Editor::FieldsFrom::kCpu));
}

TEST_CASE("a model opens in a view in which its lines have room, at rest within a frame") {
  Editor editor;
  editor.resize(1000, 1000, 1);
  REQUIRE(editor.setModel(makeModel(boxWithDoor()).value()));
  REQUIRE(editor.takeEvents() == Events{EditorEvent::kCameraChange, EditorEvent::kLoad});
  REQUIRE_FALSE(editor.frame(16));
  REQUIRE(editor.layout().lines.size() + editor.layout().hidden.size() == 5);
  REQUIRE(editor.lineStates().size() == editor.layout().lines.size());
  for (const auto& state : editor.lineStates()) REQUIRE(state.opacity == 1);
}

TEST_CASE("a model that cannot be built leaves the document as it was") {
  EditorStage stage;
  stage.set("Width", 9);
  REQUIRE_FALSE(stage.editor.setModel(Model{}));
  REQUIRE(stage.editor.model().definition.name == "box");
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.editor.canUndo());
}

TEST_CASE("another model starts with its own values, camera and history") {
  EditorStage stage;
  stage.set("Width", 9);
  REQUIRE(stage.editor.setCamera(orthoFront()));
  REQUIRE(stage.editor.setModel(makeModel(boxWithDoor()).value()));
  REQUIRE(stage.value("Width") == 8);
  REQUIRE_FALSE(stage.editor.canUndo());
  REQUIRE(stage.editor.camera().eye != orthoFront().eye);
  stage.frame();
  REQUIRE(stage.editor.atRest());
  REQUIRE(stage.editor.fadingLines().empty());
}

TEST_CASE("a document can begin with other values than its defaults, and its view is that of those") {
  EditorStage stage;
  const std::pair<std::size_t, double> saved[] = {{stage.indexOf("Width"), 9}, {stage.indexOf("Height"), 1e9}};
  const Camera ofDefaults = stage.editor.camera();

  REQUIRE(stage.editor.setModel(makeModel(boxWithDoor()).value()));
  stage.editor.beginWith(saved);
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kCameraChange, EditorEvent::kLoad});
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.value("Height") == stage.editor.model().parameters()[stage.indexOf("Height")].max);
  REQUIRE_FALSE(stage.editor.canUndo());
  stage.frame();
  REQUIRE(stage.editor.atRest());
  REQUIRE(stage.line("Width")->text == "9.00 m");
  for (const auto& state : stage.editor.lineStates()) REQUIRE(state.opacity == 1);
  REQUIRE(glm::length(stage.editor.camera().eye - ofDefaults.eye) > 1);

  // Later it is a change like any other, but with nothing before it.
  stage.set("Width", 7);
  stage.settle();
  stage.editor.takeEvents();
  stage.editor.beginWith(std::span(saved).first(1));
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kCameraChange, EditorEvent::kInput, EditorEvent::kChange});
  REQUIRE(stage.value("Width") == 9);
  REQUIRE(stage.value("Height") == 5);
  REQUIRE_FALSE(stage.editor.canUndo());

  Editor empty;
  empty.beginWith({});
  REQUIRE(empty.takeEvents().empty());
}

TEST_CASE("values are set together, as one undo step, and the model follows") {
  EditorStage stage;
  const std::pair<std::size_t, double> changes[] = {{stage.indexOf("Width"), 9}, {stage.indexOf("Height"), 4}};
  stage.editor.setValues(changes);
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput, EditorEvent::kChange});
  stage.settle();
  REQUIRE(stage.editor.scene().scopes[0].box.size == Vec3(9, 4, 6));
  REQUIRE(stage.line("Width")->text == "9.00 m");

  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
  REQUIRE(stage.value("Height") == 5);
  REQUIRE_FALSE(stage.editor.canUndo());
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput, EditorEvent::kChange});
  stage.editor.redo();
  REQUIRE(stage.value("Width") == 9);
  stage.settle();
  REQUIRE(stage.editor.scene().scopes[0].box.size == Vec3(9, 4, 6));
}

TEST_CASE("values are clamped, and no change is no step") {
  EditorStage stage;
  stage.set("Width", 1000);
  REQUIRE(stage.value("Width") == 20);
  stage.set("Width", std::numeric_limits<double>::quiet_NaN());
  REQUIRE(stage.value("Width") == 8);
  (void)stage.editor.takeEvents();
  stage.set("Width", 8);
  REQUIRE(stage.editor.takeEvents().empty());
  stage.editor.undo();
  stage.editor.undo();
  REQUIRE_FALSE(stage.editor.canUndo());
}

TEST_CASE("a slider in motion is one undo step") {
  EditorStage stage;
  const std::size_t width = stage.indexOf("Width");
  for (const double value : {8.1, 8.5, 9.0, 9.7}) {
    stage.editor.setValueContinuous(width, value);
    stage.frame();
    REQUIRE(stage.editor.scene().scopes[0].box.size.x == value);
  }
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput});
  REQUIRE(stage.editor.canUndo());
  stage.editor.endContinuous();
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kChange});
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
  REQUIRE_FALSE(stage.editor.canUndo());
}

TEST_CASE("a slider that comes back to where it was changed nothing") {
  EditorStage stage;
  const std::size_t width = stage.indexOf("Width");
  stage.editor.setValueContinuous(width, 9);
  stage.editor.setValueContinuous(width, 8);
  stage.editor.endContinuous();
  stage.editor.endContinuous();
  REQUIRE_FALSE(stage.editor.canUndo());
  REQUIRE(stage.editor.takeEvents() == Events{EditorEvent::kInput});
}

TEST_CASE("undo in the middle of a slider's motion takes that motion back") {
  EditorStage stage;
  stage.set("Height", 4);
  stage.editor.setValueContinuous(stage.indexOf("Width"), 9);
  stage.editor.undo();
  REQUIRE(stage.value("Width") == 8);
  REQUIRE(stage.value("Height") == 4);
  stage.editor.redo();
  REQUIRE(stage.value("Width") == 9);
}

TEST_CASE("a viewport of no size places nothing and loses nothing") {
  EditorStage stage;
  REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 25, 30, 20)));
  stage.settle();
  const Layout before = stage.editor.layout();
  REQUIRE(before.lines.size() > 3);
  for (const auto& [width, height] : {std::pair{0.0, 0.0}, {0.0, 700.0}, {0.5, 0.5}, {-3.0, 700.0}}) {
    stage.editor.resize(width, height, 1);
    stage.frame();
    REQUIRE(stage.editor.atRest());
    REQUIRE(stage.editor.layout().lines.empty());
    REQUIRE(stage.down({0, 0}) == PointerTarget::kNothing);
  }
  stage.set("Width", 9);
  stage.frame();
  stage.editor.undo();
  stage.editor.resize(1000, 1000, 1);
  stage.settle();
  REQUIRE(sameLayout(before, stage.editor.layout()));
}

TEST_CASE("sizes that are no numbers are ignored") {
  EditorStage stage;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Layout before = stage.editor.layout();
  stage.editor.resize(nan, 700, 1);
  stage.editor.resize(700, std::numeric_limits<double>::infinity(), 1);
  stage.editor.resize(700, 700, nan);
  stage.editor.frame(nan);
  stage.settle();
  REQUIRE(sameLayout(before, stage.editor.layout()));
}

TEST_CASE("an endless viewport and a huge pixel ratio are survived") {
  EditorStage stage;
  stage.editor.resize(1e9, 500, 1e9);
  stage.settle();
  REQUIRE(stage.editor.layout().view.widthPx() <= 16384);
  stage.editor.resize(1, 1, 0);
  stage.settle();
  REQUIRE(stage.editor.layout().view.widthPx() == 1);
}

TEST_CASE("as long as nobody touched the camera, a new viewport size gets the view anew") {
  Editor early;
  REQUIRE(early.setModel(makeModel(boxWithDoor()).value()));  // before the page knows its size
  early.resize(400, 800, 3);
  EditorStage late(boxWithDoor(), 400, 800);
  REQUIRE(early.camera().eye == late.editor.camera().eye);

  const Camera chosen = orbitCamera({0, 2, 0}, 25, 30, 20);
  REQUIRE(early.setCamera(chosen));
  early.resize(900, 300, 1);
  REQUIRE(early.camera().eye == chosen.eye);
}

TEST_CASE("a camera that is none is refused and the old one stays") {
  EditorStage stage;
  const Camera before = stage.editor.camera();
  Camera broken = before;
  broken.eye = broken.target;
  const Status status = stage.editor.setCamera(broken);
  REQUIRE_FALSE(status);
  REQUIRE(status.error().message.find("same point") != std::string::npos);
  REQUIRE(stage.editor.camera().eye == before.eye);
  REQUIRE(stage.editor.takeEvents().empty());
}

TEST_CASE("standard views look along the axes, in the projection at hand, with all of the model in the picture") {
  EditorStage stage;
  const std::pair<StandardView, Vec3> views[] = {{StandardView::kFront, {0, 0, -1}},
                                                 {StandardView::kBack, {0, 0, 1}},
                                                 {StandardView::kLeft, {1, 0, 0}},
                                                 {StandardView::kRight, {-1, 0, 0}},
                                                 {StandardView::kTop, {0, -1, 0}}};
  for (const bool orthographic : {false, true}) {
    stage.editor.setOrthographic(orthographic);
    for (const auto& [view, forward] : views) {
      stage.editor.setStandardView(view);
      REQUIRE(stage.editor.orthographic() == orthographic);
      stage.settle();
      const View& shown = stage.editor.layout().view;
      REQUIRE(glm::length(shown.forward() - forward) < 1e-9);
      for (int i = 0; i < 8; ++i) {
        const Vec2 corner = shown.toScreen(stage.editor.scene().bounds.corner(i));
        REQUIRE(corner.x > 0);
        REQUIRE(corner.x < 1000);
        REQUIRE(corner.y > 0);
        REQUIRE(corner.y < 1000);
      }
    }
  }
}

TEST_CASE("a camera inside the model gives a sensible frame") {
  EditorStage stage;
  Camera inside;
  inside.eye = {0, 1.6, 0};
  inside.target = {1, 1.6, 0.3};
  REQUIRE(stage.editor.setCamera(inside));
  stage.settle();
  REQUIRE(stage.editor.layout().lines.size() + stage.editor.layout().hidden.size() == 5);
  for (const PlacedLine& line : stage.editor.layout().lines) {
    REQUIRE(std::isfinite(line.lineScreen.start.x));
    REQUIRE(std::isfinite(line.lineScreen.end.y));
  }
}

TEST_CASE("fields are measured on demand, by the producer that there is") {
  EditorStage stage;
  const auto fields = stage.editor.measureFields(Editor::FieldsFrom::kCpu);
  REQUIRE(fields);
  REQUIRE(fields->widthPx == 1000);
  REQUIRE((*fields)[ViewportEdge::kLeft].min(0, 999) > 0);
  REQUIRE_FALSE(stage.editor.measureFields(Editor::FieldsFrom::kGpu));  // nothing is attached
  stage.editor.setFieldsFrom(Editor::FieldsFrom::kGpu);
  REQUIRE(stage.editor.fieldsFrom() == Editor::FieldsFrom::kGpu);
  REQUIRE(stage.editor.fieldsMeasuredBy() == Editor::FieldsFrom::kCpu);
  stage.settle();
  REQUIRE(stage.editor.layout().lines.size() > 3);
}

TEST_CASE("undo and redo bring back where all lines lay, unless the model has been turned since") {
  EditorStage stage(defineHouse(), 1280, 800);
  const Layout before = stage.editor.layout();
  const auto placesOf = [](const Layout& layout) {
    std::vector<Identity> places;
    for (const PlacedLine& line : layout.lines) places.push_back(line.identity);
    return places;
  };
  // As many drags as it takes until lines have changed their places.
  std::vector<Layout> steps{before};
  for (const Vec2 by : {Vec2(-60, -18), Vec2(-120, -40), Vec2(160, 50)}) {
    const Vec2 at = stage.handle("Width");
    stage.drag(at, at + by);
    stage.settle();
    steps.push_back(stage.editor.layout());
  }
  REQUIRE(placesOf(steps.back()) != placesOf(before));
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    stage.editor.undo();
    stage.settle();
    CHECK(sameLayout(stage.editor.layout(), steps[i]));
  }
  for (std::size_t i = 1; i < steps.size(); ++i) {
    stage.editor.redo();
    stage.settle();
    CHECK(sameLayout(stage.editor.layout(), steps[i]));
  }
  Camera turned = stage.editor.camera();
  turned.eye.x += 3;
  REQUIRE(stage.editor.setCamera(turned));
  stage.settle();
  stage.editor.undo();
  stage.settle();
  CHECK(stage.editor.values() != Values(stage.editor.model().parameters()));
  CHECK_FALSE(sameLayout(stage.editor.layout(), steps[steps.size() - 2]));
}

TEST_CASE("two edits between frames are taken back to where lines lay before the first") {
  EditorStage stage(defineHouse(), 1280, 800);
  const Layout before = stage.editor.layout();
  stage.set("Floors", 4);
  stage.set("Width", 9);
  stage.settle();
  stage.editor.undo();
  stage.editor.undo();
  stage.settle();
  CHECK(sameLayout(stage.editor.layout(), before));
}
