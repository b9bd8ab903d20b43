#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "models/models.h"
#include "support/model_settings.h"

// What the Parthenon, the Candler Building, the facade and the floor-area towers promise beyond what every model does.

namespace dimline {
namespace {

const Model& theModel(std::string_view name) {
  static std::vector<std::pair<std::string, Model>> loaded;
  for (const auto& [known, model] : loaded) {
    if (known == name) return model;
  }
  loaded.reserve(8);   // models that were handed out stay where they are
  return loaded.emplace_back(name, findBuiltInModel(name).value()).second;
}

Scene sceneOf(const Model& model, std::initializer_list<std::pair<std::string_view, double>> changes = {}) {
  Values values(model.parameters());
  for (const auto& [name, value] : changes) {
    const auto index = findParameter(model.parameters(), name);
    REQUIRE(index.has_value());
    values.set(*index, clampValue(model.parameters()[*index], value));
  }
  return model.definition.build(values);
}

std::vector<Obb> scopesNamed(const Scene& scene, std::string_view name) {
  std::vector<Obb> boxes;
  for (const Scope& s : scene.scopes) {
    if (s.name == name) boxes.push_back(s.box);
  }
  return boxes;
}

std::size_t ownTriangles(const Scene& scene) {
  std::size_t sum = 0;
  for (const Mesh& mesh : scene.meshes) sum += mesh.triangles.size();
  return sum;
}

TEST_CASE("what repeats in the large models is made once") {
  CHECK(ownTriangles(sceneOf(theModel("parthenon"))) < 10'000);
  CHECK(ownTriangles(sceneOf(theModel("candler"))) < 6'000);
}

// --- Parthenon ---------------------------------------------------------------------------------------------------------------

TEST_CASE("the Parthenon has eight columns by seventeen, and others as the spacing asks for") {
  const Model& model = theModel("parthenon");
  const auto bays = [&](double spacing) { return scopesNamed(sceneOf(model, {{"ColumnSpacing", spacing}}), "Intercolumniation"); };
  CHECK(bays(4.2).size() == 2 * (7 + 16));
  // 30.9 m less 1.06 radii of 0.95 m at each end are 28.886 m: six bays of 4.814 m when 5 m are asked for, and 67.486 m thirteen.
  const std::vector<Obb> wider = bays(5);
  CHECK(wider.size() == 2 * (6 + 13));
  CHECK(wider.front().size.x == Approx(28.886 / 6));
  for (const Obb& bay : wider) CHECK(bay.size.y == Approx(10.4));
}

TEST_CASE("the Parthenon's capitals never touch each other") {
  for (const Values& values : test::manySettings(theModel("parthenon").parameters(), 100)) {
    const Scene scene = theModel("parthenon").definition.build(values);
    const double abacus = scopesNamed(scene, "Capital").at(0).size.x;
    for (const Obb& bay : scopesNamed(scene, "Intercolumniation")) CHECK(bay.size.x > abacus + 0.2);
  }
}

TEST_CASE("the Parthenon's parts stand on each other without gaps") {
  for (const Values& values : test::manySettings(theModel("parthenon").parameters(), 50)) {
    const Scene scene = theModel("parthenon").definition.build(values);
    const Obb stylobate = scopesNamed(scene, "Stylobate").at(0), colonnade = scopesNamed(scene, "Colonnade").at(0),
              entablature = scopesNamed(scene, "Entablature").at(0), capital = scopesNamed(scene, "Capital").at(0);
    CHECK(colonnade.origin.y == Approx(stylobate.origin.y + stylobate.size.y));
    CHECK(entablature.origin.y == Approx(colonnade.origin.y + colonnade.size.y));
    CHECK(capital.origin.y + capital.size.y == Approx(entablature.origin.y));
    // The eaves, from which the pitch is measured, are the cornice's upper edge.
    CHECK(scopesNamed(scene, "Pitch").at(0).origin.y == Approx(entablature.origin.y + entablature.size.y));
  }
}

// --- Candler Building --------------------------------------------------------------------------------------------------------

TEST_CASE("the Candler Building has sixteen storeys of windows above its shops") {
  const Scene scene = sceneOf(theModel("candler"));
  CHECK(scopesNamed(scene, "Storey").size() == 16);
  CHECK(scopesNamed(scene, "Window").size() == 16 * 2 * (5 + 6));
  CHECK(scopesNamed(scene, "FirstFloorWindow").size() == 2 * (5 + 6));
  std::set<long> heights;
  for (const Obb& window : scopesNamed(scene, "Window")) heights.insert(std::lround(window.origin.y * 1000));
  CHECK(heights.size() == 16);
}

TEST_CASE("the Candler Building's courses fill its storeys") {
  // 3.7 m hold seven courses of about 0.5 m, and five of about 0.8 m.
  for (const auto& [asked, count] : {std::pair(0.5, 7), std::pair(0.8, 5)}) {
    const Scene scene = sceneOf(theModel("candler"), {{"CourseHeight", asked}});
    const std::vector<Obb> courses = scopesNamed(scene, "Course");
    CHECK(courses.size() == static_cast<std::size_t>(16 * count));
    CHECK(courses.front().size.y == Approx(3.7 / count));
  }
}

TEST_CASE("the Candler Building's cresting can be left out, and can be put back") {
  const Scene with = sceneOf(theModel("candler")), without = sceneOf(theModel("candler"), {{"Cresting", 0}});
  CHECK(with.triangleCount() > without.triangleCount());
  CHECK(scopesNamed(without, "Cresting").size() == 1);
}

// --- Facade ------------------------------------------------------------------------------------------------------------------

TEST_CASE("the facade's windows differ in width alone, and keep apart") {
  for (const Values& values : test::manySettings(theModel("facade").parameters(), 50)) {
    const Scene scene = theModel("facade").definition.build(values);
    std::vector<Obb> windows = scopesNamed(scene, "Window");
    REQUIRE(windows.size() == 20);
    double sum = 0;
    std::set<long> widths;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      sum += windows[i].size.x;
      widths.insert(std::lround(windows[i].size.x * 1000));
      for (std::size_t k = 0; k < i; ++k) {
        if (std::abs(windows[i].origin.y - windows[k].origin.y) > 0.01) continue;
        const double left = std::max(windows[i].origin.x, windows[k].origin.x);
        const double right = std::min(windows[i].origin.x + windows[i].size.x, windows[k].origin.x + windows[k].size.x);
        CHECK(left - right > 0.6);
      }
    }
    CHECK(widths.size() > 15);
    CHECK(sum / 20 == Approx(values.at(*findParameter(theModel("facade").parameters(), "WindowWidth"))));
  }
}

// --- Towers ------------------------------------------------------------------------------------------------------------------

double floorArea(const Scene& scene) {
  double sum = 0;
  for (const Obb& floor : scopesNamed(scene, "FloorPlate")) sum += floor.size.x * floor.size.z;
  return sum;
}

TEST_CASE("the floors of a tower add up to the area that it is named for") {
  for (const std::string_view name : {"floor-area-linear", "floor-area-tapered", "floor-area-stepped"}) {
    for (const Values& values : test::manySettings(theModel(name).parameters(), 60)) {
      INFO(name << " " << values.at(0));
      const Scene scene = theModel(name).definition.build(values);
      CHECK(floorArea(scene) == Approx(values.at(0)));
      // One storey on the other, up to the top of what the line measures.
      double top = scopesNamed(scene, "Tower").at(0).origin.y;
      for (const Obb& floor : scopesNamed(scene, "FloorPlate")) {
        CHECK(floor.origin.y == Approx(top));
        CHECK(floor.size.y > 2.4);
        top += floor.size.y;
      }
      CHECK(top == Approx(scopesNamed(scene, "Tower").at(0).origin.y + scopesNamed(scene, "Tower").at(0).size.y));
    }
  }
}

TEST_CASE("height grows with the area: evenly for the straight tower, faster and faster for the others") {
  for (const std::string_view name : {"floor-area-linear", "floor-area-tapered", "floor-area-stepped"}) {
    INFO(name);
    const Model& model = theModel(name);
    const Parameter& area = model.parameters()[0];
    std::vector<double> growth;
    double before = 0;
    constexpr int kSteps = 20;
    for (int i = 0; i <= kSteps; ++i) {
      const double height = scopesNamed(sceneOf(model, {{"FloorArea", area.min + (area.max - area.min) * i / kSteps}}), "Tower").at(0).size.y;
      if (i > 0) growth.push_back(height - before);
      before = height;
    }
    CHECK(*std::min_element(growth.begin(), growth.end()) > 0);
    if (name == "floor-area-linear") {
      CHECK(growth.back() == Approx(growth.front()));
    } else {
      CHECK(std::is_sorted(growth.begin(), growth.end(), [](double a, double b) { return a < b - 1e-6; }));
      CHECK(growth.back() > 2 * growth.front());
    }
  }
}

}  // namespace
}  // namespace dimline
