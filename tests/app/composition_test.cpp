#include <catch2/catch.hpp>

#include "app/composition.h"

#include <algorithm>

#include "app/editor_stage.h"
#include "models/models.h"
#include "support/fields.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// A silhouette that fills that box of a viewport of 200 x 100 px.
DistanceFields fieldsOf(const Box2& box) {
  return fieldsCovering(box, 200, 100);
}

/// From the front; 10 m high, or under 90 degrees from 5 m, which is the same in the plane z = 0.
Camera front(bool orthographic) {
  Camera camera;
  camera.eye = {0, 0, 5};
  camera.target = {0, 0, 0};
  camera.fovRad = 1.5707963267948966;
  if (orthographic) camera.orthoHeightM = 10;
  return camera;
}

/// A box in the middle, a line that reaches 30 px below it, and a switch 20 px to its right.
Layout layoutUnderBox(const Camera& camera) {
  Layout layout;
  layout.view = View(camera, 200, 100, Bounds{});
  PlacedLine line;
  line.lineScreen = {{80, 70}, {120, 70}};
  line.extensionStart = {{80, 60}, {80, 72}};
  line.label = Box2{{90, 70}, {110, 90}};
  layout.lines.push_back(line);
  PlacedHandle other;
  other.box = {{130, 45}, {140, 55}};
  layout.others.push_back(other);
  return layout;
}

const DistanceFields kBoxInTheMiddle = fieldsOf({{80, 40}, {120, 60}});

/// Room on the left, right, top and bottom of all that the last frame shows (px).
struct Room {
  double left, right, top, bottom;
};
Room roomOf(Editor& editor) {
  const Box2 box = coveredBox(editor.layout(), editor.measureFields(Editor::FieldsFrom::kCpu).value());
  const View& view = editor.layout().view;
  return {box.min.x, view.widthPx() - box.max.x, box.min.y, view.heightPx() - box.max.y};
}

}  // namespace

TEST_CASE("what is covered is the silhouette with lines, labels and other handles") {
  const Box2 box = coveredBox(layoutUnderBox(front(true)), kBoxInTheMiddle);
  CHECK(box.min == Vec2(80, 40));
  CHECK(box.max == Vec2(140, 90));
  DistanceFields none;
  none.reset(200, 100);
  none.buildTrees();
  CHECK(coveredBox(Layout{}, none).empty());
}

TEST_CASE("an orthographic camera is moved until what is covered is in the middle") {
  const Camera camera = centred(layoutUnderBox(front(true)), kBoxInTheMiddle);
  // The middle of what is covered is 10 px right of that of the viewport and 15 px below it, of which 12 count; a pixel is 0.1 m.
  CHECK(camera.eye.x == Approx(1.0));
  CHECK(camera.eye.y == Approx(-1.2));
  CHECK(camera.eye.z == Approx(5));
  CHECK(glm::length(camera.target - camera.eye - Vec3(0, 0, -5)) < 1e-12);
  CHECK(camera.orthoHeightM == 10.0);
}

TEST_CASE("a perspective camera stays where it is and turns towards the middle of what is covered") {
  Camera from = front(false);
  from.eye = {3, 0, 4};
  const Layout layout = layoutUnderBox(from);
  const Camera camera = centred(layout, kBoxInTheMiddle);
  CHECK(camera.eye == Vec3(3, 0, 4));
  CHECK(glm::length(camera.target - camera.eye) == Approx(5));
  // 10 px to the right and 12 px down, where a pixel is 0.1 m in the plane of the target.
  const Vec3 ahead = layout.view.right() * 1.0 - layout.view.up() * 1.2;
  const Vec2 middle = View(camera, 200, 100, Bounds{}).toScreen(ahead);
  CHECK(middle.x == Approx(100));
  CHECK(middle.y == Approx(50));

  Bounds bounds;
  bounds.add({-1, -1, -1});
  bounds.add({1, 1, 1});
  CHECK(glm::length(uncentred(View(camera, 200, 100, bounds), bounds).target) < 1e-9);
  Camera elsewhere = from;
  elsewhere.target = {2.5, 0, 0};
  CHECK(uncentred(View(elsewhere, 200, 100, bounds), bounds).target == elsewhere.target);
}

TEST_CASE("a perspective camera that looks along an axis stays as it is") {
  const Camera camera = front(false);
  CHECK(centred(layoutUnderBox(camera), kBoxInTheMiddle).target == camera.target);
  Bounds bounds;
  bounds.add({-1, -1.5, -1});
  bounds.add({1, 1, 1});
  CHECK(uncentred(View(camera, 200, 100, bounds), bounds).target == camera.target);
}

TEST_CASE("a picture of nothing stays as it is") {
  DistanceFields none;
  none.reset(200, 100);
  none.buildTrees();
  Layout layout;
  layout.view = View(front(false), 200, 100, Bounds{});
  CHECK(centred(layout, none).target == Vec3(0.0));
}

TEST_CASE("every model opens with room on all sides", "[models]") {
  // Lines follow the silhouette, which a turned camera sees a little otherwise; and a far line does not drive the model away.
  constexpr double kEven = 0.45, kSlackPx = 8;
  const auto [width, height] = GENERATE(std::pair(796.0, 704.0), std::pair(390.0, 430.0));
  for (const BuiltInModel& model : builtInModels()) {
    CAPTURE(model.name, width, height);
    EditorStage stage(model.define(), width, height);
    const Room room = roomOf(stage.editor);
    CHECK(std::min(room.left, room.right) >= kEven * std::max(room.left, room.right) - kSlackPx);
    CHECK(std::min(room.top, room.bottom) >= kEven * std::max(room.top, room.bottom) - kSlackPx);
  }
}

TEST_CASE("lines that came into the picture with its camera settle at once") {
  EditorStage stage(defineHouse(), 796, 704);
  stage.editor.wheel({300, 300}, 400, {});
  stage.settle();
  stage.editor.setStandardView(StandardView::kThreeQuarter);
  CHECK(stage.settle() <= 14 + kRoundsSettling);   // as many frames in which they settle, 180 ms and some more: nothing is waited for
}

TEST_CASE("fitting gives the opening view again, as often as one likes") {
  EditorStage stage(defineHouse(), 796, 704);
  const Camera opening = stage.editor.camera();
  for (int i = 0; i < 3; ++i) {
    stage.editor.fitToView();
    stage.settle();
    CHECK(glm::length(stage.editor.camera().eye - opening.eye) < 1e-6);
    CHECK(glm::length(stage.editor.camera().target - opening.target) < 1e-6);
  }
  stage.editor.wheel({300, 300}, 400, {});
  stage.settle();
  CHECK(glm::length(stage.editor.camera().eye - opening.eye) > 0.1);
  stage.editor.setStandardView(StandardView::kThreeQuarter);
  stage.settle();
  CHECK(glm::length(stage.editor.camera().eye - opening.eye) < 1e-6);
  CHECK(glm::length(stage.editor.camera().target - opening.target) < 1e-6);
}

TEST_CASE("the lines of an opening view are those that any other placer gives to its camera") {
  Stage opened(defineHouse()), given(defineHouse());
  const View view(threeQuarterView(opened.scene.bounds, 1000, 700), 1000, 700, opened.scene.bounds);
  opened.producer.produce(view, opened.fields);
  const Camera camera = composed(view, opened.fields, opened.scene, opened.values, opened.placer);
  opened.look(camera, 1000, 700);
  given.look(camera, 1000, 700);
  REQUIRE(opened.layout.lines.size() == given.layout.lines.size());
  for (std::size_t i = 0; i < given.layout.lines.size(); ++i) CHECK(opened.layout.lines[i].identity == given.layout.lines[i].identity);
}

TEST_CASE("fitting keeps the side that the model is seen from, whatever was zoomed, moved or edited before") {
  EditorStage stage(defineHouse(), 976, 744);
  const auto fit = [&] {
    stage.editor.fitToView();
    stage.settle();
    return stage.editor.camera();
  };
  const Camera opening = fit();
  for (int i = 0; i < 4; ++i) {
    stage.editor.wheel({250, 250}, -300, {});
    stage.settle();
    const Camera again = fit();
    CHECK(glm::length(again.eye - opening.eye) < 1e-6);
    CHECK(glm::length(again.target - opening.target) < 1e-6);
  }
  // A house of another height is centred otherwise, and then as before.
  const double floors = stage.value("Floors");
  for (int i = 0; i < 3; ++i) {
    stage.set("Floors", 4);
    (void)fit();
    stage.set("Floors", 1);
    (void)fit();
  }
  stage.set("Floors", floors);
  const Camera again = fit();
  CHECK(glm::length(again.eye - opening.eye) < 1e-6);
  // And right above it, where a direction beyond the zenith would turn the picture round.
  Camera above = stage.editor.camera();
  above.eye = above.target + glm::length(above.eye - above.target) * glm::normalize(Vec3(0.01, 1, 0.01));
  REQUIRE(stage.editor.setCamera(above));
  for (int i = 0; i < 3; ++i) {
    const Camera fitted = fit();
    const Vec3 back = fitted.eye - fitted.target;
    CHECK(back.x > 0);
    CHECK(back.z > 0);
  }
}

TEST_CASE("a model is fitted as it has just been edited") {
  const auto fit = [](Editor& editor) { editor.fitToView(); };
  const auto viewFrom = [](Editor& editor) { editor.setStandardView(StandardView::kRight); };
  for (const std::function<void(Editor&)>& see : {std::function<void(Editor&)>(fit), std::function<void(Editor&)>(viewFrom)}) {
    EditorStage atOnce, later;
    for (EditorStage* stage : {&atOnce, &later}) {
      stage->set("Width", 19);
      if (stage == &later) stage->settle();
      see(stage->editor);
      stage->settle();
    }
    CHECK(glm::length(atOnce.editor.camera().eye - later.editor.camera().eye) < 1e-6);
  }
}

TEST_CASE("a camera that somebody sets before the first frame is not centred") {
  Editor editor;
  editor.resize(1000, 1000, 1);
  REQUIRE(editor.setModel(makeModel(boxWithDoor()).value()));
  const Camera camera = orthoFront();
  REQUIRE(editor.setCamera(camera));
  editor.frame(16);
  CHECK(editor.camera().eye == camera.eye);
  CHECK(editor.camera().target == camera.target);
}
