#include <catch2/catch.hpp>

#include "app/ray_cast.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

Scene twoBoxes() {
  Scene scene;
  addBox(scene, boxAt({-1, -1, -1}, {2, 2, 2}));
  addBox(scene, boxAt({-1, -1, 4}, {2, 2, 2}));
  finish(scene);
  return scene;
}

}  // namespace

TEST_CASE("a ray meets the nearer of two boxes") {
  const auto hit = castRay(twoBoxes(), {{0.2, 0.3, 10}, {0, 0, -1}}, 0);
  REQUIRE(hit);
  REQUIRE(glm::length(*hit - Vec3(0.2, 0.3, 6)) < 1e-6);
}

TEST_CASE("what lies nearer than asked for is passed over") {
  const auto hit = castRay(twoBoxes(), {{0.2, 0.3, 10}, {0, 0, -1}}, 7);
  REQUIRE(hit);
  REQUIRE(hit->z == Approx(1));
}

TEST_CASE("a ray from inside meets the wall in front of it") {
  const auto hit = castRay(twoBoxes(), {{0, 0.1, 0}, {1, 0, 0}}, 0);
  REQUIRE(hit);
  REQUIRE(hit->x == Approx(1));
}

TEST_CASE("a ray beside everything, or away from it, meets nothing") {
  REQUIRE_FALSE(castRay(twoBoxes(), {{3, 0, 10}, {0, 0, -1}}, 0));
  REQUIRE_FALSE(castRay(twoBoxes(), {{0, 0, 10}, {0, 0, 1}}, 0));
  REQUIRE_FALSE(castRay(Scene{}, {{0, 0, 10}, {0, 0, -1}}, 0));
}

TEST_CASE("instances are met where they stand, in lengths of the world") {
  Scene scene = twoBoxes();
  // Twice as large, and moved to x = 20.
  scene.instances = {
      {0, glm::mat4(glm::vec4(2, 0, 0, 0), glm::vec4(0, 2, 0, 0), glm::vec4(0, 0, 2, 0), glm::vec4(20, 0, 0, 1))}};
  const auto hit = castRay(scene, {{20.5, 0.7, 10}, {0, 0, -1}}, 0);
  REQUIRE(hit);
  REQUIRE(glm::length(*hit - Vec3(20.5, 0.7, 2)) < 1e-6);
}
