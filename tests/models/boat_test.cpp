#include <algorithm>
#include <string_view>

#include <catch2/catch.hpp>

#include "models/boat_plan.h"
#include "models/models.h"
#include "support/model_settings.h"

namespace dimline {
namespace {

using boat::HullForm;
using boat::Plan;

const Model& theBoat() {
  static const Model model = findBuiltInModel("boat").value();
  return model;
}

/// The defaults with some parameters set by name.
Values with(std::initializer_list<std::pair<std::string_view, double>> changes) {
  Values values(theBoat().parameters());
  for (const auto& [name, value] : changes) values.set(findParameter(theBoat().parameters(), name).value(), value);
  return values;
}

std::size_t scopesNamed(const Scene& scene, std::string_view name) {
  return static_cast<std::size_t>(
      std::count_if(scene.scopes.begin(), scene.scopes.end(), [&](const Scope& s) { return s.name == name; }));
}

Scene built(std::initializer_list<std::pair<std::string_view, double>> changes) {
  return theBoat().definition.build(with(changes));
}

TEST_CASE("the boat's parameters stand in the order that the plan reads") {
  const std::vector<std::string> names{"Length",
                                       "Beam",
                                       "Depth",
                                       "Draught",
                                       "Sheer",
                                       "BeakLength",
                                       "GunPortSpacing",
                                       "GunsRunOut",
                                       "ForecastleLength",
                                       "ForecastleHeight",
                                       "SternDecks",
                                       "SternDeckHeight",
                                       "GalleryDepth",
                                       "ForeMastHeight",
                                       "MainMastHeight",
                                       "MizzenMastHeight",
                                       "BonaventureMastHeight",
                                       "BowspritLength",
                                       "BowspritSteeve",
                                       "ForeSailWidth",
                                       "MainSailWidth",
                                       "TopsailWidth",
                                       "SailBelly"};
  REQUIRE(theBoat().parameters().size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(theBoat().parameters()[i].name == names[i]);
}

TEST_CASE("a longer boat has more masts") {
  const auto masts = [](double length) {
    const Scene scene = built({{"Length", length}});
    return std::vector<std::size_t>{scopesNamed(scene, "ForeMast"), scopesNamed(scene, "MainMast"),
                                    scopesNamed(scene, "MizzenMast"), scopesNamed(scene, "BonaventureMast")};
  };
  CHECK(masts(26) == std::vector<std::size_t>{1, 1, 0, 0});
  CHECK(masts(29.9) == std::vector<std::size_t>{1, 1, 0, 0});
  CHECK(masts(30) == std::vector<std::size_t>{1, 1, 1, 0});
  CHECK(masts(43.9) == std::vector<std::size_t>{1, 1, 1, 0});
  CHECK(masts(44) == std::vector<std::size_t>{1, 1, 1, 1});
}

TEST_CASE("the hull is as long, broad and deep as it is said to be, and leans inwards above the wale") {
  const Plan plan = boat::planBoat(with({{"Length", 40}, {"Beam", 9}, {"Depth", 6}, {"Sheer", 1.5}}));
  const HullForm& hull = plan.hull;
  CHECK(glm::length(hull.side(0, 6) - Vec3(0, 7.5, hull.side(0, 6).z)) < 1e-9);
  CHECK(glm::length(hull.side(1, 6) - Vec3(40, hull.side(1, 6).y, 0)) < 1e-9);
  double broadest = 0;
  for (int i = 0; i <= 50; ++i) {
    for (int j = 0; j <= 60; ++j) broadest = std::max(broadest, hull.side(i / 50.0, j * 0.2).z);
  }
  CHECK(broadest == Approx(4.5).margin(0.01));
  CHECK(hull.side(0.5, 6).y == Approx(6));
  CHECK(hull.midship(hull.wale()) == Approx(4.5));
  for (double h = hull.wale(); h < 14; h += 0.5) CHECK(hull.midship(h + 0.5) < hull.midship(h));
  for (double h = 0; h + 0.1 < hull.wale(); h += 0.1) CHECK(hull.midship(h + 0.1) > hull.midship(h));
  // Strakes rise to both ends, and one finds its place on them.
  for (const double u : {0.0, 0.2, 0.8, 1.0}) CHECK(hull.side(u, 6).y > hull.side(0.5, 6).y);
  for (const double u : {0.1, 0.37, 0.9}) CHECK(hull.uAt(hull.side(u, 4).x, 4) == Approx(u));
}

TEST_CASE("sails taper upwards at the defaults, and no sail hangs into the one below it in any setting") {
  for (const Values& values : test::manySettings(theBoat().parameters(), 300)) {
    INFO(test::text(theBoat().parameters(), values));
    const Plan plan = boat::planBoat(values);
    for (const boat::Mast* mast : {&plan.fore, &plan.main}) {
      REQUIRE(mast->sails.size() == 3);
      CHECK(mast->sails[0].footY > mast->deckY + boat::kBulwark);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(mast->sails[i].yardY > mast->sails[i].footY + 1);
        CHECK(mast->sails[i].yardY < mast->truckY());
        CHECK(std::min(mast->sails[i].headWidth, mast->sails[i].footWidth) > 1);
        if (i > 0) CHECK(mast->sails[i].footY > mast->sails[i - 1].yardY);
      }
    }
  }
  const Plan plan = boat::planBoat(Values(theBoat().parameters()));
  for (const boat::Mast* mast : {&plan.fore, &plan.main}) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(mast->sails[i].headWidth < mast->sails[i].footWidth);
    for (std::size_t i = 1; i < 3; ++i) CHECK(mast->sails[i].headWidth < mast->sails[i - 1].headWidth);
  }
}

TEST_CASE("a stay passes before the sail behind it, at its old place where that is clear") {
  for (const Values& values : test::manySettings(theBoat().parameters(), 200)) {
    INFO(test::text(theBoat().parameters(), values));
    const Plan plan = boat::planBoat(values);
    const boat::SailSurface sail = plan.main.sailSurface(0);
    const Vec3 head(plan.main.x, plan.main.topY() + 0.5, 0), foot(plan.fore.x - 0.9, plan.fore.deckY + 0.5, 0);
    const Segment stay = boat::stayBefore(sail, head, foot);
    CHECK((stay.end.x == foot.x && stay.end.y >= foot.y && stay.end.y < head.y));
    for (int i = 2; i <= 40; ++i) {
      const Vec3 cloth = sail.at(0, i / 40.0);
      const double along = (head.y - cloth.y) / (head.y - stay.end.y);
      if (along < 1) CHECK(glm::mix(stay.start, stay.end, along).x > cloth.x + 0.9 * boat::kStayClearM);
    }
  }
  const Plan plan = boat::planBoat(with({{"SailBelly", 0.4}}));
  const Vec3 foot(plan.fore.x, plan.fore.deckY, 0);
  CHECK(boat::stayBefore(plan.main.sailSurface(0), {plan.main.x, plan.main.topY() + 0.5, 0}, foot).end == foot);
}

TEST_CASE("masts and castles leave each other room") {
  for (const Values& values : test::manySettings(theBoat().parameters(), 300)) {
    INFO(test::text(theBoat().parameters(), values));
    const Plan plan = boat::planBoat(values);
    const double break_ = plan.stern.front().toX;
    CHECK(plan.main.x > break_ + 1);
    CHECK(plan.main.x < plan.forecastle.fromX - 1);
    CHECK(plan.fore.x > plan.forecastle.fromX + 1);
    CHECK(plan.fore.x < plan.forecastle.toX - 1);
    for (const auto* mast : {&plan.mizzen, &plan.bonaventure}) {
      if (!*mast) continue;
      for (const boat::Deck& deck : plan.stern) CHECK(std::abs((*mast)->x - deck.toX) > 0.8);
    }
  }
}

TEST_CASE("gun ports fill both sides evenly, as near to the spacing asked for as that allows") {
  for (const double spacing : {2.2, 2.8, 3.7, 4.5}) {
    const Plan plan = boat::planBoat(with({{"GunPortSpacing", spacing}}));
    CHECK(plan.battery.spacing == Approx(spacing).epsilon(0.5 / plan.battery.bays));
    CHECK(scopesNamed(built({{"GunPortSpacing", spacing}}), "GunBay") ==
          2 * static_cast<std::size_t>(plan.battery.bays));
    CHECK(plan.battery.spacing > boat::kPortSize + 0.5);
  }
}

TEST_CASE("guns that are not run out are not seen") {
  const auto instances = [](double out) { return built({{"GunsRunOut", out}}).instances.size(); };
  const Plan plan = boat::planBoat(Values(theBoat().parameters()));
  CHECK(instances(1) >= instances(0) + 2 * static_cast<std::size_t>(plan.battery.bays));
}

TEST_CASE("at its defaults the boat is as large as the galleon of the paper") {
  const std::size_t triangles = built({}).triangleCount();
  CHECK(triangles > 58214 * 9 / 10);
  CHECK(triangles < 58214 * 11 / 10);
}

}  // namespace
}  // namespace dimline
