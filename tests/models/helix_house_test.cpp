#include <algorithm>

#include <catch2/catch.hpp>

#include "models/models.h"
#include "support/model_settings.h"

namespace dimline {
namespace {

const Model& theHelix() {
  static const Model model = findBuiltInModel("helix-house").value();
  return model;
}

double valueOf(const Values& values, std::string_view name) { return values.at(findParameter(theHelix().parameters(), name).value()); }

Values with(std::initializer_list<std::pair<std::string_view, double>> changes) {
  Values values(theHelix().parameters());
  for (const auto& [name, value] : changes) values.set(findParameter(theHelix().parameters(), name).value(), value);
  return values;
}

std::vector<Obb> scopesNamed(const Scene& scene, std::string_view name) {
  std::vector<Obb> boxes;
  for (const Scope& s : scene.scopes) {
    if (s.name == name) boxes.push_back(s.box);
  }
  return boxes;
}

TEST_CASE("the helix house's handles are of the kinds that its parameters need") {
  const auto annotation = [](std::string_view name) { return *theHelix().annotations[findParameter(theHelix().parameters(), name).value()]; };
  CHECK(annotation("Floors").indirect);
  CHECK(annotation("ColumnSpacing").indirect);
  CHECK(annotation("TwistPerFloor").type == HandleType::kAngular);
  CHECK(annotation("FloorHeight").chained);
  CHECK(annotation("ColumnSpacing").chained);
  CHECK(annotation("Facade").type == HandleType::kRange);
  CHECK(annotation("RoofGarden").type == HandleType::kBoolean);
}

TEST_CASE("floors add up to the tower, and stand on each other") {
  for (const Values& values : test::manySettings(theHelix().parameters(), 100)) {
    INFO(test::text(theHelix().parameters(), values));
    const Scene scene = theHelix().definition.build(values);
    const auto floors = static_cast<std::size_t>(valueOf(values, "Floors"));
    const auto storeys = scopesNamed(scene, "Storey"), slabs = scopesNamed(scene, "Floor");
    const Obb tower = scopesNamed(scene, "Storeys").at(0), ground = scopesNamed(scene, "GroundFloor").at(0);
    REQUIRE(storeys.size() == floors);
    REQUIRE(slabs.size() == floors + 1);
    CHECK(tower.size.y == Approx(valueOf(values, "FloorHeight") * valueOf(values, "Floors")));
    CHECK(tower.origin.y == Approx(ground.origin.y + ground.size.y));
    for (std::size_t i = 0; i < floors; ++i) {
      CHECK(storeys[i].origin.y == Approx(slabs[i].origin.y));
      CHECK(storeys[i].origin.y + storeys[i].size.y == Approx(slabs[i + 1].origin.y));
    }
    const Obb head = scopesNamed(scene, "StairHead").at(0);
    CHECK(head.origin.y == Approx(slabs.back().origin.y + valueOf(values, "SlabThickness")));
    CHECK(scene.bounds.max.y == Approx(head.origin.y + head.size.y).margin(1e-4));
  }
}

TEST_CASE("each floor is turned by the twist against the one below, counter-clockwise seen from above") {
  const double twist = 12 * kRadPerDeg;
  const Scene scene = theHelix().definition.build(with({{"TwistPerFloor", 12}, {"Floors", 5}}));
  const auto slabs = scopesNamed(scene, "Floor");
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const double a = static_cast<double>(k) * twist;
    CHECK(glm::length(slabs[k].axes[0] - Vec3(std::cos(a), 0, -std::sin(a))) < 1e-9);
    CHECK(glm::length(slabs[k].center() * Vec3(1, 0, 1)) < 1e-9);
  }
  // The angle opens from the front of the last floor but one to the roof's, on the roof.
  const auto angles = scopesNamed(scene, "Twist");
  REQUIRE(angles.size() == 2);
  CHECK(angles[0].axes[2] == Vec3(0, 0, 1));  // on the plaza, as the lowest floor stands
  const Obb angle = angles[1];
  CHECK(glm::length(angle.axes[2] - slabs[4].axes[2]) < 1e-9);
  CHECK(glm::length(angle.axes[2] * std::cos(twist) + angle.axes[0] * std::sin(twist) - slabs[5].axes[2]) < 1e-9);
  CHECK(angle.origin.y == Approx(slabs[5].origin.y + slabs[5].size.y));
}

TEST_CASE("a slab fills its scope, turned with it") {
  const Scene scene = theHelix().definition.build(with({{"TwistPerFloor", 17}, {"RoofGarden", 0}}));
  for (const Obb& slab : scopesNamed(scene, "Floor")) {
    Bounds inside;
    for (const Instance& instance : scene.instances) {
      for (const glm::vec3& local : scene.meshes[instance.mesh].positions) {
        const Vec3 p = Vec3(instance.transform * glm::vec4(local, 1.0F)) - slab.origin;
        // On its upper side nothing else reaches so far: the glass stands back.
        const Vec3 q(glm::dot(p, slab.axes[0]), p.y, glm::dot(p, slab.axes[2]));
        if (std::abs(q.y - slab.size.y) < 1e-4) inside.add(q);
      }
    }
    CHECK(glm::length(inside.min - Vec3(0, slab.size.y, 0)) < 1e-3);
    CHECK(glm::length(inside.max - slab.size) < 1e-3);
  }
}

TEST_CASE("columns stand evenly along all four sides, about as far apart as asked for") {
  // 12 m less 0.6 m at each end: 10.8 m, and 8.8 m across.
  const auto bays = [](double spacing) { return scopesNamed(theHelix().definition.build(with({{"ColumnSpacing", spacing}})), "ColumnBay"); };
  CHECK(bays(3.4).size() == 2 * (3 + 3));
  CHECK(bays(2.0).size() == 2 * (5 + 4));
  CHECK(bays(5.0).size() == 2 * (2 + 2));
  const auto widths = bays(3.4);
  CHECK(std::count_if(widths.begin(), widths.end(), [](const Obb& b) { return std::abs(b.size.x - 3.6) < 1e-9; }) == 6);
  CHECK(std::count_if(widths.begin(), widths.end(), [](const Obb& b) { return std::abs(b.size.x - 8.8 / 3) < 1e-9; }) == 6);
  const Scene scene = theHelix().definition.build(with({{"ColumnSpacing", 3.4}}));
  const auto columns = scopesNamed(scene, "Column");
  CHECK(columns.size() == widths.size());
  // Each bay runs from the middle of one column to that of the next.
  for (const Obb& bay : widths) {
    for (const double end : {0.0, 1.0}) {
      const Vec3 at = bay.at({end, 0, 1});
      CHECK(std::any_of(columns.begin(), columns.end(), [&](const Obb& c) { return glm::length(c.at({0.5, 0, 0.5}) - at) < 1e-6; }));
    }
  }
}

TEST_CASE("the core fits behind the glass in every setting") {
  for (const Values& values : test::manySettings(theHelix().parameters(), 100)) {
    INFO(test::text(theHelix().parameters(), values));
    const Scene scene = theHelix().definition.build(values);
    const Obb glass = scopesNamed(scene, "Facade").at(0), core = scopesNamed(scene, "Storeys").at(0);
    // Turned against each other they need the core's diagonal.
    CHECK(std::min(glass.size.x, glass.size.z) > core.size.x * std::sqrt(2.0));
  }
}

TEST_CASE("the roof garden is there when it is asked for, and its switch either way") {
  const Scene with1 = theHelix().definition.build(with({{"RoofGarden", 1}})), without = theHelix().definition.build(with({{"RoofGarden", 0}}));
  CHECK(with1.triangleCount() > without.triangleCount() + 100);
  CHECK(scopesNamed(with1, "RoofGarden").size() == 1);
  CHECK(scopesNamed(without, "RoofGarden").size() == 1);
}

}  // namespace
}  // namespace dimline
