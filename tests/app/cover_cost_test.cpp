#include "app/cover_cost.h"

#include <catch2/catch.hpp>

#include "app/editor_stage.h"
#include "support/fields.h"

using namespace dimline;
using namespace dimline::test;

namespace {

Layout emptyLayout() {
  Layout layout;
  layout.view = View(orthoFront(), 200, 100, Bounds{{-1, -1, -1}, {1, 1, 1}});
  return layout;
}

/// A viewport of 200 x 100 with nothing in it but a block of the model from (100, 40) to (140, 80).
DistanceFields blockFields() {
  return fieldsCovering({{100, 40}, {140, 80}}, 200, 100);
}

}  // namespace

TEST_CASE("a box hides of numbers and pills their area, of strokes their length, and hardly counts the model") {
  Layout layout = emptyLayout();
  PlacedLine line;
  line.lineScreen = {{0, 90}, {200, 90}};
  line.label = Box2{{20, 10}, {60, 26}};
  layout.lines.push_back(line);
  PlacedHandle pill;
  pill.box = {{150, 10}, {190, 30}};
  pill.anchor = pill.box.center();
  layout.others.push_back(pill);
  const DistanceFields fields = blockFields();
  const auto cost = [&](const Vec2& min, const Vec2& max) { return coverCost({min, max}, layout, fields); };

  CHECK(cost({65, 0}, {95, 35}) == 0);
  CHECK(cost({50, 0}, {95, 20}) == 100);   // ten by ten of the number
  CHECK(cost({180, 25}, {200, 35}) == 50);
  const double stroke = cost({10, 85}, {40, 95});
  CHECK(cost({10, 85}, {70, 95}) == Approx(2 * stroke));
  CHECK(stroke < 30 * 10);   // less than a number of that size would
  CHECK(stroke > 0);
  const double model = cost({90, 40}, {120, 50});
  CHECK(model > 0);
  CHECK(model < 0.1 * 20 * 10);
  CHECK(cost({80, 40}, {120, 50}) == Approx(model));   // of what is beside the model nothing
}

TEST_CASE("arrowheads, extension lines and threads count where they are") {
  Layout layout = emptyLayout();
  PlacedLine line;
  line.lineScreen = {{20, 20}, {20, 80}};
  line.extensionEnd = {{90, 80}, {20, 80}};
  line.handles = {{true, {20, 80}}};
  layout.lines.push_back(line);
  PlacedHandle pill;
  pill.box = {{150, 10}, {190, 30}};
  pill.anchor = {170, 90};
  pill.placement = PlacementKind::kOutside;
  layout.others.push_back(pill);
  DistanceFields nothing;
  nothing.reset(200, 100);
  nothing.buildTrees();
  const auto cost = [&](const Vec2& min, const Vec2& max) { return coverCost({min, max}, layout, nothing); };
  CHECK(cost({10, 70}, {19, 90}) > cost({10, 50}, {19, 70}));   // beside the arrow's tip
  CHECK(cost({40, 75}, {60, 85}) > 0);
  CHECK(cost({160, 50}, {180, 60}) > 0);
  CHECK(cost({100, 50}, {140, 60}) == 0);
  layout.others[0].anchor = {170, 20};   // under the pill: then no thread is drawn
  CHECK(cost({160, 50}, {180, 60}) == 0);
}

TEST_CASE("fields of another size than the layout's do not count") {
  DistanceFields fields = blockFields();
  Layout layout = emptyLayout();
  CHECK(coverCost({{100, 40}, {140, 80}}, layout, fields) > 0);
  layout.view = View(orthoFront(), 300, 100, Bounds{{-1, -1, -1}, {1, 1, 1}});
  CHECK(coverCost({{100, 40}, {140, 80}}, layout, fields) == 0);
}

TEST_CASE("an editor tells what a box would hide of its last frame") {
  EditorStage stage;
  const Box2 label = stage.line("Width")->label.value();
  const Vec2 size = label.max - label.min;
  CHECK(stage.editor.coverCost(label) >= size.x * size.y);
  CHECK(stage.editor.coverCost({{1, 1}, {9, 9}}) == 0);
}
