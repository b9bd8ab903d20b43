#include <algorithm>

#include <catch2/catch.hpp>

#include "models/models.h"
#include "support/model_settings.h"

namespace dimline {
namespace {

const Model& theLever() {
  static const Model model = findBuiltInModel("lever").value();
  return model;
}

Values with(std::initializer_list<std::pair<std::string_view, double>> changes) {
  Values values(theLever().parameters());
  for (const auto& [name, value] : changes) values.set(findParameter(theLever().parameters(), name).value(), value);
  return values;
}

Obb onlyScope(const Scene& scene, std::string_view name, std::size_t index = 0) {
  for (const Scope& s : scene.scopes) {
    if (s.name == name && s.index == index) return s.box;
  }
  FAIL("no scope " << name);
  return {};
}

/// The corners of a mesh that lie in a box, with its positions.
Bounds boundsWithin(const Scene& scene, const Bounds& where) {
  Bounds found;
  for (const Instance& instance : scene.instances) {
    for (const glm::vec3& local : scene.meshes[instance.mesh].positions) {
      const Vec3 p(instance.transform * glm::vec4(local, 1.0F));
      if (glm::all(glm::greaterThanEqual(p, where.min)) && glm::all(glm::lessThanEqual(p, where.max))) found.add(p);
    }
  }
  return found;
}

TEST_CASE("the lever has a handle of each kind that the paper's has") {
  std::vector<std::pair<HandleType, Slip>> kinds;
  for (const auto& a : theLever().annotations) kinds.emplace_back(a->type, a->slip);
  const auto has = [&](HandleType type, Slip slip) { return std::count(kinds.begin(), kinds.end(), std::pair(type, slip)); };
  CHECK(has(HandleType::kSphericalDiametric, Slip::kBillboard) == 1);
  CHECK(has(HandleType::kAngular, Slip::kNone) == 1);
  CHECK(has(HandleType::kLinearCenter, Slip::kBillboard) == 1);
  CHECK(has(HandleType::kLinearContour, Slip::kScope) == 2);
  CHECK(has(HandleType::kRadial, Slip::kBillboard) == 1);
  CHECK(has(HandleType::kDiametric, Slip::kBillboard) == 1);
}

TEST_CASE("the knob sits at the arm's end, where the angle says") {
  // Level is towards x; 90 degrees is straight up.
  for (const double angle : {30.0, 90.0}) {
    const Scene scene = theLever().definition.build(with({{"LeverAngle", angle}, {"ArmLength", 1.0}, {"KnobDiameter", 0.2}}));
    const Vec3 knob = onlyScope(scene, "Knob").center(), pivot = onlyScope(scene, "Hub").center();
    const double rad = angle * 3.14159265358979 / 180;
    CHECK(glm::length(knob - pivot - Vec3(std::cos(rad), std::sin(rad), 0)) < 1e-9);
    // There is a ball around it, out to its radius and no further on the far side.
    const Bounds ball = boundsWithin(scene, {knob - 0.11, knob + 0.11});
    CHECK(glm::length(ball.max - ball.min) > 0.3);
    CHECK(scene.bounds.max.y == Approx(knob.y + 0.1).margin(0.006));
  }
}

TEST_CASE("the spring follows the lever: the lower the arm, the longer the spring") {
  double shorter = 0;
  for (const double angle : {100.0, 80.0, 55.0, 30.0}) {
    const Obb spring = onlyScope(theLever().definition.build(with({{"LeverAngle", angle}})), "Spring");
    CHECK(spring.size.y > shorter);
    shorter = spring.size.y;
  }
}

TEST_CASE("turns of the spring never touch each other, the coil never the cheeks") {
  for (const Values& values : test::manySettings(theLever().parameters(), 300)) {
    INFO(test::text(theLever().parameters(), values));
    const Scene scene = theLever().definition.build(values);
    const Obb spring = onlyScope(scene, "Spring"), hub = onlyScope(scene, "Hub");
    CHECK(spring.size.y / 5 > 0.027);  // five turns of a wire of 26 mm
    for (int i = 0; i < 8; ++i) CHECK(spring.corner(i).x < hub.origin.x - 0.03);
  }
}

TEST_CASE("bolts stand in two rows, one spacing apart, on the base") {
  const Scene scene = theLever().definition.build(with({{"BoltSpacing", 0.4}}));
  for (std::size_t i = 0; i < 6; ++i) {
    const Obb gap = onlyScope(scene, "BoltGap", i);
    for (const double end : {0.0, 1.0}) {
      // The bolt's head is around the scope's end.
      const Vec3 foot = gap.at({end, 0, 0.5});
      const Bounds head = boundsWithin(scene, {foot - Vec3(0.04, -0.03, 0.04), foot + Vec3(0.04, 0.04, 0.04)});
      REQUIRE(!head.empty());
      CHECK(glm::length(Vec2(head.center().x, head.center().z) - Vec2(foot.x, foot.z)) < 1e-6);
    }
  }
  CHECK(scene.bounds.size().x > 3 * 0.4);
}

TEST_CASE("cheeks and arm are as thick as their plate, with play between them") {
  const Scene scene = theLever().definition.build(with({{"PlateThickness", 0.06}}));
  const Obb back = onlyScope(scene, "Plate", 0), arm = onlyScope(scene, "Plate", 1), front = onlyScope(scene, "Plate", 2);
  CHECK(arm.origin.z - back.at({0, 0, 1}).z == Approx(0.015));
  CHECK(front.origin.z - arm.at({0, 0, 1}).z == Approx(0.015));
  CHECK(onlyScope(scene, "Hub").size.z == Approx(3 * 0.06 + 2 * 0.015));
}

}  // namespace
}  // namespace dimline
