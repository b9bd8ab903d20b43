#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "models/models.h"
#include "models/tree_parts.h"
#include "support/model_settings.h"

namespace dimline {
namespace {

const Model& theTree() {
  static const Model model = findBuiltInModel("single-tree").value();
  return model;
}

const Model& theOmniTree() {
  static const Model model = findBuiltInModel("omni-tree").value();
  return model;
}

std::vector<Obb> scopesNamed(const Scene& scene, std::string_view name) {
  std::vector<Obb> boxes;
  for (const Scope& s : scene.scopes) {
    if (s.name == name) boxes.push_back(s.box);
  }
  return boxes;
}

/// Runs visit(corner, material) over the corners of all triangles, in the world.
template <typename Visit>
void eachCorner(const Scene& scene, Visit&& visit) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (const std::uint32_t p : mesh.triangles[i])
        visit(Vec3(instance.transform * glm::vec4(mesh.positions[p], 1.0F)), scene.materials[mesh.materials[i]]);
    }
  }
}

Bounds leafBounds(const Scene& scene) {
  Bounds bounds;
  eachCorner(scene, [&](const Vec3& p, const Material& m) {
    if (m.pattern == Material::Pattern::kLeaves) bounds.add(p);
  });
  return bounds;
}

TEST_CASE("a tree's handles: a switch, a choice that depends on it, and four lines") {
  const auto& a = theTree().annotations;
  REQUIRE(a.size() == tree::kTreeParameterCount);
  CHECK(a[tree::kRealistic]->type == HandleType::kBoolean);
  CHECK(a[tree::kKind]->type == HandleType::kRange);
  CHECK(a[tree::kStemHeight]->type == HandleType::kLinearContour);
  CHECK(a[tree::kTrunkDiameter]->type == HandleType::kDiametric);
  CHECK(a[tree::kCrownHeight]->type == HandleType::kLinearCenter);
  CHECK(a[tree::kCrownWidth]->type == HandleType::kDiametric);
}

TEST_CASE("the kind can be chosen where the realistic tree is shown, and only there; the switch is always there") {
  Values values(theTree().parameters());
  for (const double realistic : {0.0, 1.0}) {
    values.set(tree::kRealistic, realistic);
    const Scene scene = theTree().definition.build(values);
    CHECK(scopesNamed(scene, theTree().annotations[tree::kKind]->scope).size() == (realistic != 0 ? 1U : 0U));
    CHECK(scopesNamed(scene, theTree().annotations[tree::kRealistic]->scope).size() == 1);
    CHECK(leafBounds(scene).empty() == (realistic == 0));
  }
}

TEST_CASE("leaves fill the crown's box on all sides, and leave the stem free") {
  for (Values values : test::manySettings(theTree().parameters(), 60)) {
    values.set(tree::kRealistic, 1);
    INFO(test::text(theTree().parameters(), values));
    const Scene scene = theTree().definition.build(values);
    const Bounds leaves = leafBounds(scene);
    const Obb crown = scopesNamed(scene, "Crown").at(0);
    const Vec3 slack = crown.size * 0.03;
    for (int k = 0; k < 3; ++k) {
      CHECK(leaves.min[k] > crown.at(Vec3(0))[k] - 1e-4);
      CHECK(leaves.max[k] < crown.at(Vec3(1))[k] + 1e-4);
      CHECK(leaves.min[k] < crown.at(Vec3(0))[k] + slack[k]);
      CHECK(leaves.max[k] > crown.at(Vec3(1))[k] - slack[k]);
    }
    // But for the roots and branches of a thick stem under a narrow crown, nothing reaches further.
    const double most = std::max(0.5 * values.at(tree::kCrownWidth), 0.9 * values.at(tree::kTrunkDiameter)) + 0.05;
    CHECK(scene.bounds.max.x < most);
    CHECK(scene.bounds.min.z > -most);
    CHECK(scene.bounds.max.y < leaves.max.y + 0.05);
    CHECK(scene.bounds.min.y == 0);
  }
}

TEST_CASE("the stem is as thick as its diameter says, all along") {
  int seen = 0;
  for (Values values : test::manySettings(theTree().parameters(), 60)) {
    INFO(test::text(theTree().parameters(), values));
    const Scene scene = theTree().definition.build(values);
    for (const Obb& trunk : scopesNamed(scene, "Trunk")) {
      double widest = 0;
      eachCorner(scene, [&](const Vec3& p, const Material& m) {
        // Right under the crown the lowest limbs come out of it.
        const double end = std::min(trunk.origin.y + trunk.size.y + 1e-6, values.at(tree::kStemHeight) - 0.5 * trunk.size.x);
        const bool within = p.y > trunk.origin.y - 1e-6 && p.y < end;
        if (within && !m.twoSided) widest = std::max(widest, std::hypot(p.x, p.z));
      });
      CHECK(widest <= 0.5 * values.at(tree::kTrunkDiameter) + 1e-5);
      if (widest > 0) ++seen;
      CHECK((widest == 0 || widest > 0.5 * values.at(tree::kTrunkDiameter) * 0.96));
    }
  }
  CHECK(seen > 50);
}

TEST_CASE("a tree that is dragged larger stays the same tree") {
  for (const double kind : {0.0, 1.0, 2.0, 3.0}) {
    std::vector<std::size_t> counts;
    test::Random random(3);
    for (int i = 0; i < 20; ++i) {
      Values values = test::anySetting(theTree().parameters(), random);
      values.set(tree::kRealistic, 1);
      values.set(tree::kKind, kind);
      values.set(tree::kStemHeight, 3);  // a palm's stem has a ring for each of its years
      counts.push_back(theTree().definition.build(values).triangleCount());
    }
    INFO(kind);
    CHECK(std::count(counts.begin(), counts.end(), counts.front()) == 20);
    CHECK(counts.front() > 4000);
    CHECK(counts.front() < 8000);
  }
}

TEST_CASE("three sets make five trees: one of each, and two grafts with the stem of one set and the crown of the next") {
  const Scene scene = theOmniTree().definition.build(Values(theOmniTree().parameters()));
  const auto axes = [&](const char* scope) {
    std::vector<Vec3> middles;
    for (const Obb& box : scopesNamed(scene, scope)) middles.push_back(box.at({0.5, 0, 0.5}) * Vec3(1, 0, 1));
    return middles;
  };
  const auto stemA = axes("StemA"), stemB = axes("StemB"), stemC = axes("StemC");
  const auto crownA = axes("CrownA"), crownB = axes("CrownB"), crownC = axes("CrownC");
  REQUIRE(stemA.size() == 2);
  REQUIRE(stemB.size() == 2);
  REQUIRE(stemC.size() == 1);
  REQUIRE(crownA.size() == 1);
  REQUIRE(crownB.size() == 2);
  REQUIRE(crownC.size() == 2);
  const auto together = [](const Vec3& p, const Vec3& q) { return glm::length(p - q) < 1e-9; };
  CHECK(together(stemA[0], crownA[0]));
  CHECK(together(stemA[1], crownB[0]));
  CHECK(together(stemB[0], crownB[1]));
  CHECK(together(stemB[1], crownC[0]));
  CHECK(together(stemC[0], crownC[1]));
  // A crown stands on its tree's stem, whoever's that is.
  CHECK(scopesNamed(scene, "CrownB")[0].origin.y == Approx(scopesNamed(scene, "StemA")[1].size.y));
}

TEST_CASE("the crowns of the five trees keep apart, and each tree is turned") {
  for (const Values& values : test::manySettings(theOmniTree().parameters(), 20)) {
    INFO(test::text(theOmniTree().parameters(), values));
    const Scene scene = theOmniTree().definition.build(values);
    std::vector<Obb> crowns;
    for (const char* name : {"CrownA", "CrownB", "CrownC"}) {
      for (const Obb& box : scopesNamed(scene, name)) crowns.push_back(box);
    }
    REQUIRE(crowns.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Vec3 apart = (crowns[i].center() - crowns[k].center()) * Vec3(1, 0, 1);
        CHECK(glm::length(apart) > 0.5 * (crowns[i].size.x + crowns[k].size.x) + 0.65);
        CHECK(glm::length(crowns[i].axes[0] - crowns[k].axes[0]) > 0.05);
      }
    }
  }
}

}  // namespace
}  // namespace dimline
