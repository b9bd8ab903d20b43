#include <algorithm>

#include <catch2/catch.hpp>

#include "models/house_plan.h"
#include "models/models.h"
#include "support/model_settings.h"

namespace dimline {
namespace {

using house::Facade;
using house::Opening;
using house::Plan;

const Model& theHouse() {
  static const Model model = findBuiltInModel("house").value();
  return model;
}

Values defaults() { return Values(theHouse().parameters()); }

/// The defaults with some parameters set by name.
Values with(std::initializer_list<std::pair<std::string_view, double>> changes) {
  Values values = defaults();
  for (const auto& [name, value] : changes) {
    const auto index = findParameter(theHouse().parameters(), name);
    REQUIRE(index.has_value());
    values.set(*index, clampValue(theHouse().parameters()[*index], value));
  }
  return values;
}

/// Defaults, each parameter's limits and choices, and 500 random settings.
std::vector<Values> manySettings() { return test::manySettings(theHouse().parameters(), 500); }

std::string text(const Values& values) { return test::text(theHouse().parameters(), values); }

std::vector<Obb> scopesNamed(const Scene& scene, std::string_view name) {
  std::vector<Obb> boxes;
  for (const Scope& s : scene.scopes) {
    if (s.name == name) boxes.push_back(s.box);
  }
  return boxes;
}

Bounds boundsOf(const Obb& box) {
  Bounds b;
  for (int i = 0; i < 8; ++i) b.add(box.corner(i));
  return b;
}

bool inside(const Bounds& inner, const Bounds& outer, double slackM) {
  const Vec3 low = inner.min - outer.min + slackM, high = outer.max - inner.max + slackM;
  return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) >= 0;
}

TEST_CASE("the house's handles are of the kinds that its parameters need") {
  const auto& annotations = theHouse().annotations;
  REQUIRE(annotations.size() == house::kParameterCount);
  CHECK(annotations[house::kFloors]->indirect);
  CHECK(annotations[house::kWindowSpacing]->indirect);
  CHECK(annotations[house::kRoofType]->type == HandleType::kRange);
  CHECK(annotations[house::kRoofPitch]->type == HandleType::kAngular);
  CHECK(annotations[house::kBalcony]->type == HandleType::kBoolean);
}

TEST_CASE("the parameters' order is the one that the plan reads") {
  const std::vector<std::string> names{"Width",      "Depth",         "Floors",        "FloorHeight", "RoofType",
                                       "RoofPitch",  "RoofOverhang",  "ChimneyHeight", "WindowWidth", "WindowHeight",
                                       "SillHeight", "WindowSpacing", "DoorWidth",     "Balcony"};
  REQUIRE(theHouse().parameters().size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(theHouse().parameters()[i].name == names[i]);
}

TEST_CASE("the house keeps within sane bounds in every setting") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    const Plan plan = house::planHouse(values);
    CHECK(scene.bounds.min.y == Approx(0).margin(1e-6));
    // A ridge at most; a chimney and its pots above it.
    CHECK(scene.bounds.max.y <
          house::kPlinth + plan.wallHeight + (plan.depth * 0.58 + plan.overhang) * std::tan(plan.pitchRad) + 4);
    CHECK(std::abs(scene.bounds.center().x) < 0.1);
    CHECK(scene.bounds.size().x < plan.width + 2 * plan.overhang + 0.5);
    CHECK(scene.bounds.size().z < plan.depth + 2 * std::max(plan.overhang, 3.5) + 0.5);
    CHECK(scene.triangleCount() < 80000);
  }
}

TEST_CASE("the house is a few thousand triangles at its defaults") {
  const std::size_t count = theHouse().definition.build(defaults()).triangleCount();
  CHECK(count > 3000);
  CHECK(count <= 15000);
}

TEST_CASE("every annotation finds its scopes, but for a flat roof's pitch and the balcony of a house of one floor") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      INFO(theHouse().parameters()[i].name);
      const bool absent = (i == house::kRoofPitch && values.at(house::kRoofType) == 3) ||
                          (i == house::kBalcony && values.at(house::kFloors) == 1);
      CHECK(scopesNamed(scene, theHouse().annotations[i]->scope).empty() == absent);
    }
  }
}

TEST_CASE("scopes are where their names say") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    const Plan plan = house::planHouse(values);
    const Bounds footprint = boundsOf(scopesNamed(scene, "Footprint").at(0)),
                 storeys = boundsOf(scopesNamed(scene, "Storeys").at(0));
    CHECK(glm::length(footprint.min - Vec3(-plan.width / 2, 0, -plan.depth / 2)) < 1e-9);
    CHECK(glm::length(footprint.max - Vec3(plan.width / 2, house::kPlinth, plan.depth / 2)) < 1e-9);
    CHECK(storeys.min.y == Approx(footprint.max.y));
    CHECK(storeys.size().y == Approx(plan.floors * plan.floorHeight));

    const auto each = scopesNamed(scene, "Storey");
    REQUIRE(each.size() == static_cast<std::size_t>(plan.floors));
    for (std::size_t i = 0; i < each.size(); ++i)
      CHECK(each[i].origin.y == Approx(storeys.min.y + static_cast<double>(i) * plan.floorHeight));

    for (const char* name : {"Window", "Sill", "Bay", "Door"}) {
      for (const Obb& box : scopesNamed(scene, name)) {
        const Bounds b = boundsOf(box);
        CHECK(inside(b, storeys, 1e-6));
        // Their z leaves the house, and their front lies in a wall's face.
        const Vec3 front = box.at({0.5, 0.5, 1});
        CHECK(std::min(std::abs(std::abs(front.x) - plan.width / 2), std::abs(std::abs(front.z) - plan.depth / 2)) <
              1e-6);
        CHECK(glm::dot(front - storeys.center(), box.axes[2]) > 0);
        CHECK(box.axes[1] == Vec3(0, 1, 0));
      }
    }
    for (const Obb& sill : scopesNamed(scene, "Sill")) {
      const double floor = (sill.origin.y - house::kPlinth) / plan.floorHeight;
      CHECK(floor == Approx(std::round(floor)).margin(1e-6));
    }
    const Bounds roof = boundsOf(scopesNamed(scene, "Roof").at(0));
    CHECK(roof.min.y == Approx(storeys.max.y));
    CHECK(roof.size().x == Approx(plan.width + 2 * plan.overhang));
    for (const Obb& box : scopesNamed(scene, "Overhang")) CHECK(inside(boundsOf(box), roof, 1e-6));
  }
}

TEST_CASE("the chimney stands in the roof and rises above it") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    const Bounds roof = boundsOf(scopesNamed(scene, "Roof").at(0)),
                 chimney = boundsOf(scopesNamed(scene, "Chimney").at(0));
    CHECK(chimney.min.x > roof.min.x);
    CHECK(chimney.max.x < roof.max.x);
    CHECK(chimney.min.z > roof.min.z);
    CHECK(chimney.max.z < roof.max.z);
    CHECK(chimney.min.y > roof.min.y);
    CHECK(chimney.min.y < roof.max.y);
    CHECK(chimney.max.y > roof.max.y);
  }
}

TEST_CASE("openings keep apart from each other, from the walls' ends and from the roof") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Plan plan = house::planHouse(values);
    for (const Facade* f : {&plan.front, &plan.right, &plan.back, &plan.left}) {
      for (std::size_t i = 0; i < f->openings.size(); ++i) {
        const Opening& o = f->openings[i];
        CHECK(o.x > 0.25);
        CHECK(o.endX() < f->length - 0.25);
        CHECK(o.y >= o.floor * plan.floorHeight);
        if (o.kind != Opening::Kind::kAttic) {
          CHECK(o.y + o.height <= (o.floor + 1) * plan.floorHeight - 0.2 + 1e-9);
        } else {
          const Ring top = house::wallTop(plan, *f, o.x, o.endX());
          CHECK(std::min(top.front().y, top.back().y) > o.y + o.height + 0.3);
        }
        for (std::size_t k = 0; k < i; ++k) {
          const Opening& p = f->openings[k];
          const double across = std::max(o.x - p.endX(), p.x - o.endX()),
                       up = std::max(o.y - p.y - p.height, p.y - o.y - o.height);
          CHECK(std::max(across, up) >= 0.2999);
        }
      }
    }
  }
}

TEST_CASE("the door and a window are there in every setting") {
  for (const Values& values : manySettings()) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    CHECK(scopesNamed(scene, "Door").size() == 1);
    CHECK(!scopesNamed(scene, "Window").empty());
    CHECK(scopesNamed(scene, "Window").size() == scopesNamed(scene, "Sill").size());
  }
}

TEST_CASE("the window spacing rounds to what fits, and never lets windows touch") {
  // 13 m of front, less 0.5 m at each end: 12 m for windows.
  CHECK(house::planHouse(with({{"WindowSpacing", 2.4}})).front.bays == 5);
  CHECK(house::planHouse(with({{"WindowSpacing", 2.7}})).front.bays == 4);
  CHECK(house::planHouse(with({{"WindowSpacing", 4}})).front.bays == 3);
  // Windows of 2 m need 2.35 m each, whatever spacing is asked for: 12 / 2.35 is 5.1.
  CHECK(house::planHouse(with({{"WindowSpacing", 1.2}, {"WindowWidth", 2}})).front.bays == 5);
  const Scene scene = theHouse().definition.build(with({{"WindowSpacing", 2.7}}));
  for (const Obb& bay : scopesNamed(scene, "Bay")) {
    const bool front = std::abs(bay.axes[2].z) > 0.5;
    CHECK(bay.size.x == Approx(front ? 3.0 : 7.4 / 3));  // 12 m into four, 7.4 m into three
  }
}

TEST_CASE("floors and floor height add up to the storeys") {
  const Scene scene = theHouse().definition.build(with({{"Floors", 3}, {"FloorHeight", 3.2}}));
  CHECK(scopesNamed(scene, "Storeys").at(0).size.y == Approx(9.6));
  CHECK(scopesNamed(scene, "Storey").size() == 3);
}

TEST_CASE("a balcony has a door of its own, and none is there on a house of one floor") {
  const auto balconyDoors = [](const Values& values) {
    const Plan plan = house::planHouse(values);
    return std::count_if(plan.front.openings.begin(), plan.front.openings.end(),
                         [](const Opening& o) { return o.kind == Opening::Kind::kBalconyDoor; });
  };
  CHECK(balconyDoors(with({{"Balcony", 1}})) == 1);
  CHECK(balconyDoors(with({{"Balcony", 0}})) == 0);
  CHECK(balconyDoors(with({{"Balcony", 1}, {"Floors", 1}})) == 0);
  test::Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Plan plan = house::planHouse(test::anySetting(theHouse().parameters(), random));
    const auto& e = plan.entrance;
    CHECK(e.balconyWidth >= e.doorWidth);
    CHECK(e.center - e.balconyWidth / 2 > 0);
    CHECK(e.center + e.balconyWidth / 2 < plan.width);
    CHECK(e.center - e.landingWidth / 2 > 0);
    CHECK(e.center + e.landingWidth / 2 < plan.width);
  }
}

/// What a ray meets, as materials, between two distances along it.
std::vector<Material> metBy(const Scene& scene, const Vec3& from, const Vec3& way, double nearM, double farM) {
  std::vector<Material> met;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Vec3 p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = Vec3(instance.transform * glm::vec4(mesh.positions[mesh.triangles[i][k]], 1.0F));
      }
      const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], h = glm::cross(way, e2);
      const double det = glm::dot(e1, h);
      if (std::abs(det) < 1e-12) continue;
      const Vec3 s = from - p[0], q = glm::cross(s, e1);
      const double u = glm::dot(s, h) / det, v = glm::dot(way, q) / det, t = glm::dot(e2, q) / det;
      if (u >= 0 && v >= 0 && u + v <= 1 && t > nearM && t < farM) met.push_back(scene.materials[mesh.materials[i]]);
    }
  }
  return met;
}

TEST_CASE("openings are open: a look through a pane meets glass and nothing else of the wall") {
  std::vector<Values> settings{defaults(), with({{"WindowWidth", 2}, {"SillHeight", 0.7}}),
                               with({{"RoofType", 2}, {"WindowWidth", 0.6}}), with({{"Floors", 4}, {"Width", 7}})};
  for (const Values& values : settings) {
    INFO(text(values));
    const Scene scene = theHouse().definition.build(values);
    for (const Obb& window : scopesNamed(scene, "Window")) {
      // A quarter in from the left and from below: in a pane, whatever the number of panes is (bars are at halves and
      // thirds).
      const Vec3 from = window.at({0.25, 0.25, 1}) + window.axes[2] * 0.005;
      const auto met = metBy(scene, from, -window.axes[2], 0, house::kWallThickness);
      CHECK(met.size() == 2);  // in and out again
      for (const Material& m : met) CHECK(m.pattern == Material::Pattern::kGlass);

      // Beside it, beyond the trim, there is wall.
      const Vec3 beside = window.at({0, 0.5, 1}) - window.axes[0] * 0.14 - Vec3(0, window.size.y * 0.5 + 0.12, 0) +
                          window.axes[2] * 0.005;
      const auto wall = metBy(scene, beside, -window.axes[2], 0, house::kWallThickness + 0.1);
      CHECK(std::any_of(wall.begin(), wall.end(),
                        [](const Material& m) { return m.pattern == Material::Pattern::kPlaster; }));
    }
  }
}

}  // namespace
}  // namespace dimline
