#include <catch2/catch.hpp>

#include <cmath>

#include "editing/handle_drag.h"
#include "placement/base_lines.h"
#include "support/random.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// Front view of what stands on the ground around the origin: 100 px a metre, x = 0 and y = 2.5 in the middle of 1000 x
/// 1000.
Camera frontCamera() {
  Camera camera;
  camera.eye = {0, 2.5, 40};
  camera.target = {0, 2.5, 0};
  camera.orthoHeightM = 10;
  return camera;
}

/// A model at its present values, and lines put by hand beside its scopes.
struct Desk {
  Model model;
  Values values;
  Scene scene;
  View view;

  Desk(ModelDefinition definition, const Camera& camera)
      : model(makeModel(std::move(definition)).value()),
        values(model.parameters()),
        scene(model.definition.build(values)),
        view(camera, 1000, 1000, scene.bounds) {}

  /// A parameter's base line `number` on its scope of that index, moved by `offset`.
  [[nodiscard]] PlacedLine line(std::string_view name, int number, const Vec3& offset,
                                std::uint32_t scopeIndex = 0) const {
    PlacedLine line;
    line.parameter = findParameter(model.parameters(), name).value();
    const Annotation& annotation = *model.annotations[line.parameter];
    for (std::size_t i = 0; i < scene.scopes.size(); ++i) {
      if (scene.scopes[i].name == annotation.scope && scene.scopes[i].index == scopeIndex) line.scope = i;
    }
    line.base = baseLines(annotation, scene.scopes[line.scope].box, view)[static_cast<std::size_t>(number)].segment;
    line.foot = line.base;
    line.line = {line.base.start + offset, line.base.end + offset};
    line.identity = {static_cast<std::int32_t>(line.parameter),
                     static_cast<std::int32_t>(scopeIndex),
                     -1,
                     static_cast<std::int16_t>(number),
                     0,
                     1};
    line.placement = offset == Vec3(0.0) ? PlacementKind::kInside : PlacementKind::kOutside;
    line.extensionStart.resize(2);
    line.extensionEnd.resize(2);
    line.handles = {{true, {}}, {false, {}}};
    line.value = values.at(line.parameter);
    projectLine(line, view, std::nullopt);
    return line;
  }

  [[nodiscard]] std::optional<HandleDrag> grab(const PlacedLine& line, bool atEnd,
                                               const Vec2& grabOffset = {3, -2}) const {
    const Handle& handle = line.handles[atEnd ? 0 : 1];
    return HandleDrag::begin(model, values, scene, line, handle, handle.screen + grabOffset, view);
  }
  [[nodiscard]] Scene sceneAt(std::size_t parameter, double value) const {
    Values changed = values;
    changed.set(parameter, value);
    return model.definition.build(changed);
  }
};

Parameter parameterNamed(const char* name, double value, double min, double max, double step, const char* annotation) {
  return {.name = name,
          .title = name,
          .unit = Unit::kMetre,
          .defaultValue = value,
          .min = min,
          .max = max,
          .step = step,
          .annotation = annotation};
}

/// Storeys of 3 m on a base of 0.5 m.
ModelDefinition tower() {
  ModelDefinition definition;
  definition.name = "tower";
  Parameter floors =
      parameterNamed("Floors", 2, 1, 6, 1, "@Handle(scope=Tower, type=linear-contour, orient=up, indirect)");
  floors.type = ParameterType::kInt;
  floors.unit = Unit::kNone;
  definition.parameters.push_back(floors);
  definition.build = [](const Values& v) {
    Scene scene;
    const Obb box = boxAt({-2, 0, -2}, {4, 3 * v.at(0) + 0.5, 4});
    addBox(scene, box);
    scene.scopes.push_back({"Tower", 0, box});
    finish(scene);
    return scene;
  };
  return definition;
}

/// A row of tiles on 10 m: as many as come nearest to the spacing wanted.
ModelDefinition row() {
  ModelDefinition definition;
  definition.name = "row";
  definition.parameters.push_back(
      parameterNamed("Spacing", 2.5, 1, 5, 0.1, "@Handle(scope=Tile, type=linear-contour, orient=right, indirect)"));
  definition.build = [](const Values& v) {
    Scene scene;
    const double count = std::round(10.0 / v.at(0));
    for (double i = 0; i < count; ++i) {
      const Obb tile = boxAt({-5 + 10 * i / count, 0, 0}, {10 / count, 1, 1});
      addBox(scene, tile);
      scene.scopes.push_back({"Tile", 0, tile});
    }
    finish(scene);
    return scene;
  };
  return definition;
}

/// One box on another, 2 and 1 m high.
ModelDefinition stack() {
  ModelDefinition definition;
  definition.name = "stack";
  definition.parameters.push_back(parameterNamed("Lower", 2, 0.5, 4, 0.1, "@Handle(scope=Lower, type=linear-contour, orient=up)"));
  definition.parameters.push_back(parameterNamed("Upper", 1, 0.2, 4, 0.1, "@Handle(scope=Upper, type=linear-contour, orient=up)"));
  definition.build = [](const Values& v) {
    const Obb lower = boxAt({-1, 0, -1}, {2, v.at(0), 2});
    const Obb upper = boxAt({-1, v.at(0), -1}, {2, v.at(1), 2});
    return sceneOf({{"Lower", lower}, {"Upper", upper}});
  };
  return definition;
}

}  // namespace

TEST_CASE("a height that stands on the ground follows the pointer metre by metre") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Height", 0, {-1, 0, 0});
  REQUIRE(line.lineScreen.end.x == Approx(0));
  REQUIRE(line.lineScreen.end.y == Approx(250));  // 5 m up
  auto drag = desk.grab(line, true);
  REQUIRE(drag);
  const Vec2 grabbed = line.lineScreen.end + Vec2(3, -2);
  REQUIRE(drag->valueAt(grabbed + Vec2(0, -47), desk.view) == 5.5);  // 0.47 m up, on steps of 0.1
  REQUIRE(drag->valueAt(grabbed + Vec2(0, 120), desk.view) == 3.8);
  REQUIRE(drag->valueAt(grabbed + Vec2(300, 120), desk.view) == 3.8);  // sideways does not count
}

TEST_CASE("a width that grows on both sides follows at twice the pointer's way, and the end stays under it") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  REQUIRE(line.lineScreen.end.x == Approx(900));
  auto drag = desk.grab(line, true);
  const Vec2 grabbed = line.lineScreen.end + Vec2(3, -2);
  const double value = drag->valueAt(grabbed + Vec2(30, 0), desk.view);
  REQUIRE(value == 8.6);

  Values values = desk.values;
  values.set(line.parameter, value);
  const auto dragged = drag->lineOn(desk.sceneAt(line.parameter, value), values, desk.view);
  REQUIRE(dragged);
  CHECK(glm::length(dragged->foot.start - dragged->base.start) < 1e-9);   // its feet go along with what it measures
  CHECK(glm::length(dragged->foot.end - dragged->base.end) < 1e-9);
  REQUIRE(dragged->handles[0].screen.x == Approx(930));
  REQUIRE(dragged->handles[0].screen.y == Approx(line.lineScreen.end.y));
  REQUIRE(dragged->value == 8.6);
  REQUIRE(dragged->text == "8.60 m");
  REQUIRE(dragged->lengthM == Approx(8.6));
}

TEST_CASE("the other end of a width is pulled the other way") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  auto drag = desk.grab(line, false);
  const Vec2 grabbed = line.lineScreen.start + Vec2(3, -2);
  REQUIRE(drag->valueAt(grabbed + Vec2(-30, 0), desk.view) == 8.6);
  REQUIRE(drag->valueAt(grabbed + Vec2(30, 0), desk.view) == 7.4);
}

TEST_CASE("a drag ends at the limits, however far the pointer goes") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  auto drag = desk.grab(line, true);
  for (const double far : {700.0, 5000.0, 1e9}) {
    REQUIRE(drag->valueAt({900 + far, 600}, desk.view) == 20);
    REQUIRE(drag->valueAt({900 - far, 600}, desk.view) == 0.5);
  }
}

TEST_CASE("floors follow in whole numbers") {
  const Desk desk(tower(), frontCamera());
  const PlacedLine line = desk.line("Floors", 0, {-1, 0, 0});  // 6.5 m
  auto drag = desk.grab(line, true, {0, 0});
  REQUIRE(drag->valueAt(line.lineScreen.end - Vec2(0, 140), desk.view) == 2);
  REQUIRE(drag->valueAt(line.lineScreen.end - Vec2(0, 160), desk.view) == 3);
  REQUIRE(drag->valueAt(line.lineScreen.end + Vec2(0, 290), desk.view) == 1);
  REQUIRE(drag->valueAt(line.lineScreen.end - Vec2(0, 5000), desk.view) == 6);
}

TEST_CASE("a spacing that the model rounds takes the count that comes nearest to the pointer") {
  const Desk desk(row(), frontCamera());
  const PlacedLine line = desk.line("Spacing", 0, {0, -0.6, 0}, 0);  // the first of four tiles, -5 to -2.5
  auto drag = desk.grab(line, true, {0, 0});
  const auto tilesAt = [&](double travelPx) {
    return desk.sceneAt(line.parameter, drag->valueAt(line.lineScreen.end + Vec2(travelPx, 0), desk.view))
        .scopes.size();
  };
  REQUIRE(tilesAt(0) == 4);
  REQUIRE(tilesAt(70) == 3);   // 3.2 m: three of 3.33
  REQUIRE(tilesAt(-45) == 5);  // 2.05 m: five of 2
}

TEST_CASE("when the number of scopes changes, the line takes its length from the one nearest to where the drag began, and keeps its other end") {
  const Desk desk(row(), frontCamera());
  const PlacedLine line = desk.line("Spacing", 0, {0, -0.6, 0}, 2);  // 0 to 2.5
  auto drag = desk.grab(line, true, {0, 0});
  Values values = desk.values;
  values.set(0, 2.0);  // five tiles of 2 m; their right ends are at -3, -1, 1, 3 and 5
  const auto dragged = drag->lineOn(desk.sceneAt(0, 2.0), values, desk.view);
  REQUIRE(dragged);
  REQUIRE(desk.sceneAt(0, 2.0).scopes[dragged->scope].index == 3);
  REQUIRE(dragged->base.start.x == Approx(0).margin(1e-12));
  REQUIRE(dragged->base.end.x == Approx(2));
}

TEST_CASE("a repeated thing's line gets longer as the pointer goes out, whichever of them it measures") {
  const Desk desk(row(), frontCamera());
  for (const std::uint32_t index : {0U, 1U, 2U, 3U}) {
    const PlacedLine line = desk.line("Spacing", 0, {0, -0.6, 0}, index);
    auto drag = desk.grab(line, true, {0, 0});
    double last = 0;
    for (double travelPx = -200; travelPx <= 200; travelPx += 10) {
      Values values = desk.values;
      values.set(0, drag->valueAt(line.lineScreen.end + Vec2(travelPx, 0), desk.view));
      const auto dragged = drag->lineOn(desk.sceneAt(0, values.at(0)), values, desk.view);
      INFO("tile " << index << ", " << travelPx << " px");
      REQUIRE(dragged->lengthM >= last);
      last = dragged->lengthM;
    }
  }
}

TEST_CASE("a dragged line keeps its carrier when its scope moves away from it") {
  ModelDefinition definition = boxWithDoor();
  // The box also comes forward as it gets wider.
  definition.build = [](const Values& v) {
    Scene scene;
    const Obb box = boxAt({-v.at(0) / 2, 0, v.at(0)}, {v.at(0), 5, 1});
    addBox(scene, box);
    scene.scopes.push_back({"Box", 0, box});
    finish(scene);
    return scene;
  };
  const Desk desk(std::move(definition), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0.5});
  const auto drag = desk.grab(line, true);
  Values values = desk.values;
  values.set(0, 9);
  const auto dragged = drag->lineOn(desk.sceneAt(0, 9), values, desk.view);
  REQUIRE(dragged);
  REQUIRE(dragged->base.start.z == Approx(9));
  REQUIRE(dragged->line.start.z == Approx(line.line.start.z));
  REQUIRE(dragged->line.start.y == Approx(line.line.start.y));
  REQUIRE(dragged->line.end.x == Approx(4.5));
}

TEST_CASE("a line inside the model stays on its base line") {
  const Desk desk(boxWithDoor(), frontCamera());
  const auto drag = desk.grab(desk.line("Width", 0, Vec3(0.0)), true);
  Values values = desk.values;
  values.set(0, 9);
  const auto dragged = drag->lineOn(desk.sceneAt(0, 9), values, desk.view);
  REQUIRE(dragged->line.start == dragged->base.start);
  REQUIRE(dragged->line.end == dragged->base.end);
}

TEST_CASE("a drag takes hold of the label too, and its box follows the text") {
  const Desk desk(boxWithDoor(), frontCamera());
  PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  line.label = Box2{line.lineScreen.middle() - Vec2(20, 9), line.lineScreen.middle() + Vec2(20, 9)};
  const auto drag = desk.grab(line, true);
  Values values = desk.values;
  values.set(0, 10);
  const auto dragged = drag->lineOn(desk.sceneAt(0, 10), values, desk.view);
  REQUIRE(dragged->text == "10.00 m");
  REQUIRE(dragged->label->center().x == Approx(dragged->lineScreen.middle().x));
  REQUIRE(dragged->label->max.x - dragged->label->min.x > 40);
}

TEST_CASE("a line that points at the viewer cannot be taken hold of") {
  const Desk desk(boxWithDoor(), frontCamera());
  REQUIRE_FALSE(desk.grab(desk.line("Depth", 0, {-1, 0, 0}), true));
}

TEST_CASE("a line of another scene cannot be taken hold of") {
  const Desk desk(boxWithDoor(), frontCamera());
  PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  line.scope = 99;
  REQUIRE_FALSE(desk.grab(line, true));
}

TEST_CASE("a pointer that is nowhere changes nothing") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  auto drag = desk.grab(line, true, {0, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(drag->valueAt({nan, 3}, desk.view) == 8);
  REQUIRE(drag->valueAt({930, 700}, desk.view) == 8.6);
  REQUIRE(drag->valueAt({nan, nan}, desk.view) == 8.6);
}

TEST_CASE("beside the dragged line stand the old extent, once there is another, and the limits that are on screen") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Height", 0, {-0.5, 0, 0});
  auto drag = desk.grab(line, true);
  const auto at = [&](double value) {
    Values values = desk.values;
    values.set(line.parameter, value);
    return *drag->lineOn(desk.sceneAt(line.parameter, value), values, desk.view);
  };
  const auto countAt = [&](double value, DragMark::Kind kind) {
    std::vector<DragMark> marks;
    drag->addMarks(value, at(value), desk.view, Snap::kStep, marks);
    return std::ranges::count(marks, kind, &DragMark::kind);
  };
  REQUIRE(countAt(5, DragMark::Kind::kGhost) == 0);
  REQUIRE(countAt(6, DragMark::Kind::kGhost) == 1);  // where the end was
  REQUIRE(countAt(4, DragMark::Kind::kGhost) == 2);  // and from there to where it is
  REQUIRE(countAt(5, DragMark::Kind::kTick) > 5);
  REQUIRE(countAt(5, DragMark::Kind::kLimit) == 1);  // 0.5 m; 20 m is above the picture
  REQUIRE(countAt(0.5, DragMark::Kind::kLimitReached) == 1);
  std::vector<DragMark> marks;
  drag->addMarks(6, at(6), desk.view, Snap::kNone, marks);
  REQUIRE(std::ranges::count(marks, DragMark::Kind::kTick, &DragMark::kind) == 0);
  const auto ghost = std::ranges::find(marks, DragMark::Kind::kGhost, &DragMark::kind);
  REQUIRE(glm::length(ghost->line.middle() - line.lineScreen.end) < 1e-9);
}

TEST_CASE("where ends are not in proportion to values, ticks stand where values end, found out one at a time and each once") {
  // One tick for nine tiles to three; one of ten, and one of two, would be 150 px away and more.
  const Desk desk(row(), frontCamera());
  const PlacedLine line = desk.line("Spacing", 0, {0, -0.6, 0});
  auto drag = desk.grab(line, true);
  const auto ticks = [&](Snap snap) {
    std::vector<DragMark> marks;
    drag->addMarks(2.5, line, desk.view, snap, marks);
    std::vector<double> endsM;
    for (const DragMark& mark : marks) {
      if (mark.kind == DragMark::Kind::kTick || mark.kind == DragMark::Kind::kLongTick) endsM.push_back((mark.line.middle().x - line.lineScreen.start.x) / 100);
    }
    return endsM;
  };
  const std::size_t before = ticks(Snap::kStep).size();
  int learned = 0;
  while (drag->learnNearby(2.5, line, desk.view, Snap::kStep)) ++learned;
  CHECK(learned > 5);
  CHECK(learned <= 2 * kMostTicks);
  const std::vector<double> found = ticks(Snap::kStep);
  CHECK(found.size() > before);
  const std::vector<double> expected{10.0 / 9, 10.0 / 8, 10.0 / 7, 10.0 / 6, 2.0, 2.5, 10.0 / 3};
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]));
  const int evaluations = drag->evaluations();
  CHECK_FALSE(drag->learnNearby(2.5, line, desk.view, Snap::kStep));
  CHECK(drag->evaluations() == evaluations);
  CHECK(ticks(Snap::kNone).empty());
}

TEST_CASE("where ends are in proportion to values, nothing has to be found out") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("Width", 0, {0, -0.6, 0});
  auto drag = desk.grab(line, true);
  CHECK_FALSE(drag->learnNearby(8, line, desk.view, Snap::kStep));
  CHECK(drag->evaluations() <= 3);
}

TEST_CASE("among other values that leave the line where it is, the value is the same; among those that move it, the end comes to the pointer") {
  const Desk desk(boxWithDoor(), frontCamera());
  const PlacedLine line = desk.line("DoorHeight", 0, {0, 0, 0});
  auto drag = desk.grab(line, true);
  const Vec2 pointer = line.lineScreen.end + Vec2(3, -2) + Vec2(0, -40);
  REQUIRE(drag->valueAt(pointer, desk.view) == Approx(2.4));
  Values others = desk.values;
  others.set(findParameter(desk.model.parameters(), "Width").value(), 11);
  CHECK(drag->valueAmong(others, pointer, desk.view) == Approx(2.4));
  CHECK(drag->valueAmong(desk.values, pointer, desk.view) == Approx(2.4));

  const Desk pair(stack(), frontCamera());
  const PlacedLine upper = pair.line("Upper", 0, {-0.6, 0, 0});
  auto dragUpper = pair.grab(upper, true);
  const Vec2 grabbed = upper.lineScreen.end + Vec2(3, -2);
  others = pair.values;
  others.set(0, 2.5);   // the lower one, half a metre higher
  CHECK(dragUpper->valueAmong(others, grabbed, pair.view) == Approx(0.5));
  CHECK(dragUpper->valueAmong(others, grabbed + Vec2(0, -30), pair.view) == Approx(0.8));
  CHECK(dragUpper->valueAmong(pair.values, grabbed, pair.view) == 1);
}

TEST_CASE(
    "under any camera the end comes to the pointer as near as a step allows, and back at the start is the value of the "
    "start") {
  Random random(3);
  int dragged = 0;
  for (int round = 0; round < 300; ++round) {
    Camera camera =
        orbitCamera({0, 2.5, 0}, random.scaled(9, 60), random.real(0, 360), random.real(-20, 85), random.real(10, 90));
    if (random.chance(0.3)) camera.orthoHeightM = random.real(8, 40);
    const Desk desk(boxWithDoor(), camera);
    const char* const names[] = {"Width", "Height", "Depth", "DoorWidth"};
    const char* name = names[random.whole(0, 3)];
    const Vec3 offset = random.point(Vec3(-2), Vec3(2));
    PlacedLine line = desk.line(name, random.whole(0, 3), Vec3(0.0));
    const Vec3 along = glm::normalize(line.base.end - line.base.start);
    line.line.start += offset - along * glm::dot(offset, along);
    line.line.end += offset - along * glm::dot(offset, along);
    line.placement = PlacementKind::kOutside;
    if (!canProject(line, desk.view) || !desk.view.viewport().overlaps(Box2{line.lineScreen.end, line.lineScreen.end}))
      continue;
    projectLine(line, desk.view, std::nullopt);
    const bool atEnd = random.chance(0.5);
    auto drag = desk.grab(line, atEnd);
    if (!drag || line.lineScreen.length() < kMinLineLengthPx) continue;

    const Vec2 start = line.handles[atEnd ? 0 : 1].screen;
    const Vec2 grabbed = start + Vec2(3, -2);
    for (int move = 0; move < 8; ++move) {
      const Vec2 travel = random.point(Vec2(-200), Vec2(200));
      const double value = drag->valueAt(grabbed + travel, desk.view);
      REQUIRE(std::isfinite(value));
      Values values = desk.values;
      values.set(line.parameter, value);
      const auto now = drag->lineOn(desk.sceneAt(line.parameter, value), values, desk.view);
      const Parameter& parameter = desk.model.parameters()[line.parameter];
      if (!now || value == parameter.min || value == parameter.max) continue;

      // What is left between handle and pointer along the line is no more than to the neighbouring steps' ends.
      const Vec2 direction = glm::normalize(line.lineScreen.end - line.lineScreen.start);
      const auto leftAt = [&](double v) {
        Values at = desk.values;
        at.set(line.parameter, v);
        const auto there = drag->lineOn(desk.sceneAt(line.parameter, v), at, desk.view);
        return there ? std::abs(glm::dot(there->handles[atEnd ? 0 : 1].screen - start - travel, direction)) : 1e9;
      };
      ++dragged;
      INFO(name << " round " << round << " value " << value);
      REQUIRE(leftAt(value) <= leftAt(value + parameter.step) + 0.5);
      REQUIRE(leftAt(value) <= leftAt(value - parameter.step) + 0.5);
    }
    REQUIRE(drag->valueAt(grabbed, desk.view) == desk.values.at(line.parameter));
  }
  REQUIRE(dragged > 300);
}
