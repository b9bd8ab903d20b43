#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "editing/arc_drag.h"
#include "editing/arc_projection.h"
#include "editing/handle_hit.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// A wedge whose pitch is 30 degrees, and its arc of 2 m about the origin, from +x towards +y.
struct Desk {
  Model model = makeModel(definition()).value();
  Values values{model.parameters()};
  View view;

  explicit Desk(double azimuthDeg = 0, double elevationDeg = 0, bool orthographic = true) {
    Camera camera = orbitCamera({0, 0, 0}, 12, azimuthDeg, elevationDeg, 50);
    if (orthographic) camera.orthoHeightM = 10;  // 100 px a metre
    view = View(camera, 1000, 1000, Bounds{Vec3(-3), Vec3(3)});
  }

  static ModelDefinition definition() {
    ModelDefinition definition;
    definition.name = definition.title = "wedge";
    definition.parameters = {{.name = "Pitch",
                              .title = "Pitch",
                              .type = ParameterType::kAngle,
                              .unit = Unit::kDegree,
                              .defaultValue = 30,
                              .min = 10,
                              .max = 80,
                              .step = 1,
                              .annotation = "@Handle(scope=Wedge, type=angular, orient=front, slip=none)"}};
    definition.build = [](const Values&) {
      Scene scene;
      addBox(scene, boxAt({0, 0, 0}, {4, 4, 1}));
      scene.scopes.push_back({"Wedge", 0, boxAt({0, 0, 0}, {4, 4, 1})});
      finish(scene);
      return scene;
    };
    return definition;
  }

  [[nodiscard]] PlacedHandle handle() const {
    PlacedHandle handle;
    handle.type = HandleType::kAngular;
    handle.arc = Arc{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2.0, values.at(0) * kRadPerDeg};
    handle.handles = {{true, {}}};
    handle.box = {{0, 0}, {30, 17}};
    projectArcHandle(handle, view, {25, -5});
    return handle;
  }
  [[nodiscard]] Vec2 at(double deg, double radiusM = 2.0) const {
    return view.toScreen(Vec3(radiusM * std::cos(deg * kRadPerDeg), radiusM * std::sin(deg * kRadPerDeg), 0));
  }
  [[nodiscard]] ArcDrag grab(const Vec2& grabOffset = {0, 0}) const {
    return ArcDrag::begin(model, values, handle(), at(30) + grabOffset, view).value();
  }
};

}  // namespace

TEST_CASE("the angle is where the pointer is about the centre, on a step, however far out") {
  for (const bool orthographic : {true, false}) {
    const Desk desk(25, 20, orthographic);
    ArcDrag drag = desk.grab();
    for (const double deg : {12.0, 30.0, 31.0, 45.0, 79.0}) {
      CHECK(drag.valueAt(desk.at(deg), desk.view) == Approx(deg));
      CHECK(drag.valueAt(desk.at(deg, 0.5), desk.view) == Approx(deg));
      CHECK(drag.valueAt(desk.at(deg, 5.0), desk.view) == Approx(deg));
    }
    CHECK(drag.valueAt(desk.at(45.4), desk.view) == Approx(45));
    CHECK(drag.valueAt(desk.at(45.6), desk.view) == Approx(46));
  }
}

TEST_CASE("beyond the range it stays at the limit that is nearer by turning") {
  const Desk desk;
  ArcDrag drag = desk.grab();
  CHECK(drag.valueAt(desk.at(100), desk.view) == 80);
  CHECK(drag.valueAt(desk.at(200), desk.view) == 80);
  CHECK(drag.valueAt(desk.at(-5), desk.view) == 10);
  CHECK(drag.valueAt(desk.at(-100), desk.view) == 10);
}

TEST_CASE("the handle keeps its distance to the pointer, and there and back gives the very same value") {
  Desk desk;
  desk.values.set(0, 30.37);  // typed: off its steps
  PlacedHandle handle = desk.handle();
  const Vec2 grabOffset(5, -4);
  const Vec2 tip = handle.handles[0].screen;
  auto drag = ArcDrag::begin(desk.model, desk.values, handle, tip + grabOffset, desk.view);
  REQUIRE(drag);
  CHECK(drag->valueAt(desk.at(50) + grabOffset, desk.view) == 50);
  CHECK(drag->valueAt(tip + grabOffset, desk.view) == 30.37);
  CHECK(drag->valueAt({std::numeric_limits<double>::quiet_NaN(), 0}, desk.view) == 30.37);
  CHECK(drag->valueAt(desk.at(0, 0) + grabOffset, desk.view) == 30.37);  // on the centre there is no direction
}

TEST_CASE("seen from behind, the angle still turns with the pointer") {
  const Desk desk(180, 15);
  ArcDrag drag = desk.grab();
  CHECK(drag.valueAt(desk.at(60), desk.view) == Approx(60));
}

TEST_CASE("the dragged arc stays in its place in the world, its end and its text follow the value") {
  const Desk desk(20, 10);
  const ArcDrag drag = desk.grab();
  Values values = desk.values;
  values.set(0, 50);
  const auto held = drag.handleOn(values, desk.view);
  REQUIRE(held);
  CHECK(held->arc->center == Vec3(0, 0, 0));
  CHECK(held->arc->radiusM == 2.0);
  CHECK(glm::length(held->handles[0].screen - desk.at(50)) < 1e-9);
  CHECK(held->text == "50°");
  CHECK(glm::length(arcLabelOffset(*held, desk.view) - Vec2(25, -5)) < 1e-9);
}

TEST_CASE("an arc seen edge-on, or none at all, cannot be taken hold of") {
  const Desk edgeOn(90, 0);
  CHECK_FALSE(ArcDrag::begin(edgeOn.model, edgeOn.values, edgeOn.handle(), edgeOn.at(30), edgeOn.view));
  const Desk desk;
  PlacedHandle pill = desk.handle();
  pill.arc.reset();
  CHECK_FALSE(ArcDrag::begin(desk.model, desk.values, pill, desk.at(30), desk.view));
}

TEST_CASE("a pointer takes hold of an arc by its moving arrowhead only") {
  const Desk desk;
  const std::vector<PlacedHandle> handles{desk.handle()};
  const Vec2 middle = arcArrowMiddle(*handles[0].arc, desk.view);
  CHECK(glm::length(middle - desk.at(30)) == Approx(kArrowLengthPx / 2).epsilon(0.01));
  CHECK(glm::length(middle - desk.at(0)) < glm::length(desk.at(30) - desk.at(0)));
  CHECK(hitArc(handles, desk.view, middle + Vec2(0, 13), 14) == 0u);
  CHECK_FALSE(hitArc(handles, desk.view, middle + Vec2(0, 15), 14));
  CHECK_FALSE(hitArc(handles, desk.view, desk.at(0), 14));
}

TEST_CASE("an arc on screen begins and ends on its legs, and one behind the viewer is not drawn") {
  const Desk desk(30, 20, false);
  std::vector<Vec2> points;
  REQUIRE(arcOnScreen(*desk.handle().arc, desk.view, points));
  CHECK(glm::length(points.front() - desk.at(0)) < 1e-9);
  CHECK(glm::length(points.back() - desk.at(30)) < 1e-9);
  for (std::size_t i = 1; i < points.size(); ++i) CHECK(glm::length(points[i] - points[i - 1]) < 8);
  Arc behind = *desk.handle().arc;
  behind.center = desk.view.camera().eye - desk.view.forward() * 3.0;
  CHECK_FALSE(arcOnScreen(behind, desk.view, points));
}
