#include <catch2/catch.hpp>

#include <cmath>

#include "app/orbit_controls.h"
#include "support/random.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

CameraLimits wide() { return cameraLimits(Bounds{Vec3(-5), Vec3(5)}); }

double azimuthDeg(const Camera& camera) {
  const Vec3 d = camera.eye - camera.target;
  return std::atan2(d.x, d.z) * 180 / kPi;
}
double elevationDeg(const Camera& camera) {
  const Vec3 d = camera.eye - camera.target;
  return std::asin(d.y / glm::length(d)) * 180 / kPi;
}

}  // namespace

TEST_CASE("a travel of the viewport's height is a whole turn") {
  const Camera start = orbitCamera({1, 2, 3}, 10, 20, 30);
  const Camera quarter = orbit(start, {-200, 0}, 800).camera;  // to the left: the camera goes to the right
  REQUIRE(azimuthDeg(quarter) == Approx(110));
  REQUIRE(elevationDeg(quarter) == Approx(30));
  REQUIRE(glm::length(quarter.eye - quarter.target) == Approx(10));
  REQUIRE(quarter.target == start.target);
  const Camera round = orbit(start, {800, 0}, 800).camera;
  REQUIRE(glm::length(round.eye - start.eye) < 1e-9);
}

TEST_CASE("dragging down lifts the camera") {
  const Camera start = orbitCamera({0, 0, 0}, 10, 20, 30);
  REQUIRE(elevationDeg(orbit(start, {0, 50}, 900).camera) == Approx(50));  // 50 of 900 px are 20 degrees
  REQUIRE(elevationDeg(orbit(start, {0, -50}, 900).camera) == Approx(10));
}

TEST_CASE("an orbit stops at the pole and below the horizon, and answers at once on the way back") {
  const Camera start = orbitCamera({0, 0, 0}, 10, 20, 30);
  const OrbitMove up = orbit(start, {0, 500}, 900);  // 200 degrees up
  REQUIRE(elevationDeg(up.camera) == Approx(90).margin(0.02));
  REQUIRE(azimuthDeg(up.camera) == Approx(20));
  REQUIRE(up.overrunPx == Approx(350).margin(0.1));  // 150 px were 60 degrees
  const OrbitMove down = orbit(start, {0, -500}, 900);
  REQUIRE(elevationDeg(down.camera) == Approx(-0.35 * 180 / kPi));
  REQUIRE(down.overrunPx < 0);
}

TEST_CASE("a camera that a script put below the limit turns without a jump, and may only come up") {
  const Camera start = orbitCamera({0, 0, 0}, 10, 20, -60);
  REQUIRE(elevationDeg(orbit(start, {9, 0}, 900).camera) == Approx(-60));
  REQUIRE(elevationDeg(orbit(start, {0, -90}, 900).camera) == Approx(-60));
  REQUIRE(elevationDeg(orbit(start, {0, 25}, 900).camera) == Approx(-50));
}

TEST_CASE("from right above, an orbit comes down on the side that the picture shows below") {
  Camera top = orbitCamera({0, 0, 0}, 10, 0, 0);
  top.eye = {0, 10, 0};
  const View before(top, 1000, 1000, Bounds{});
  const Camera lower = orbit(top, {0, -100}, 900).camera;
  REQUIRE(elevationDeg(lower) == Approx(50).margin(0.02));
  REQUIRE(azimuthDeg(lower) == Approx(0).margin(1e-6));
  REQUIRE(glm::length(View(lower, 1000, 1000, Bounds{}).right() - before.right()) < 1e-9);
}

TEST_CASE("a pan keeps what is at the target's depth under the pointer") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    Camera start = orbitCamera(random.point(Vec3(-2), Vec3(2)), random.scaled(3, 40), random.real(0, 360),
                               random.real(-80, 80), random.real(10, 100));
    if (random.chance(0.5)) start.orthoHeightM = random.scaled(1, 40);
    const Vec2 travel = random.point(Vec2(-60), Vec2(60));
    const View before(start, 900, 700, Bounds{});
    const Vec2 grabbed = random.point(Vec2(0), Vec2(900, 700));
    const Vec3 point = pointAtTargetDepth(before, grabbed);
    const View after(pan(start, travel, 700, wide()), 900, 700, Bounds{});
    REQUIRE(glm::length(after.toScreen(point) - grabbed - travel) < 1e-6);
  }
}

TEST_CASE("a zoom keeps the point that it is about where it is on screen") {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    Camera start = orbitCamera(random.point(Vec3(-2), Vec3(2)), random.scaled(3, 40), random.real(0, 360),
                               random.real(-80, 80), random.real(10, 100));
    if (random.chance(0.5)) start.orthoHeightM = random.scaled(3, 40);
    const View before(start, 900, 700, Bounds{});
    const Vec2 pointer = random.point(Vec2(0), Vec2(900, 700));
    const View::Ray ray = before.rayThrough(pointer);
    const Vec3 pivot = pointAtTargetDepth(before, pointer) - ray.direction * random.real(-1, 1);
    const double factor = random.scaled(0.7, 1.4);
    const Camera zoomed = zoom(start, factor, pivot, wide());
    REQUIRE(glm::length(View(zoomed, 900, 700, Bounds{}).toScreen(pivot) - pointer) < 1e-6);
    const double share = start.orthoHeightM
                             ? *zoomed.orthoHeightM / *start.orthoHeightM
                             : glm::length(zoomed.target - zoomed.eye) / glm::length(start.target - start.eye);
    REQUIRE(share == Approx(factor));
  }
}

TEST_CASE("zooms end at distances that suit the model's size") {
  const CameraLimits limits = wide();
  Camera camera = orbitCamera({0, 0, 0}, 10, 20, 30);
  for (int i = 0; i < 200; ++i) camera = zoom(camera, 0.7, {0, 0, 0}, limits);
  REQUIRE(glm::length(camera.target - camera.eye) == Approx(limits.minDistanceM));
  for (int i = 0; i < 200; ++i) camera = zoom(camera, 1.4, {0, 0, 0}, limits);
  REQUIRE(glm::length(camera.target - camera.eye) == Approx(limits.maxDistanceM));
}

TEST_CASE("a camera beyond the limits stays there until it comes nearer") {
  const CameraLimits limits = wide();
  const Camera far = orbitCamera({0, 0, 0}, 10 * limits.maxDistanceM, 20, 30);
  REQUIRE(glm::length(zoom(far, 1.2, {0, 0, 0}, limits).eye) == Approx(glm::length(far.eye)));
  REQUIRE(glm::length(zoom(far, 0.5, {0, 0, 0}, limits).eye) == Approx(0.5 * glm::length(far.eye)));
}

TEST_CASE("pans do not lose the model") {
  const CameraLimits limits = wide();
  Camera camera = orbitCamera({0, 0, 0}, 10, 20, 30);
  for (int i = 0; i < 500; ++i) camera = pan(camera, {300, 200}, 700, limits);
  REQUIRE(glm::length(camera.target - limits.center) <= limits.maxTargetDistanceM * (1 + 1e-9));
  REQUIRE(glm::length(camera.eye - camera.target) == Approx(10));
}

TEST_CASE("a wheel's notch is five percent, and back again") {
  REQUIRE(wheelZoomFactor(-100) == Approx(0.95));
  REQUIRE(wheelZoomFactor(100) * wheelZoomFactor(-100) == Approx(1));
  REQUIRE(dragZoomFactor(200) == Approx(2));
}

TEST_CASE("the other projection shows the target's surroundings in the same size, and back is the same camera") {
  const Camera start = orbitCamera({1, 2, 3}, 10, 20, 30);
  const Camera flat = withProjection(start, true);
  REQUIRE(flat.orthographic());
  const View before(start, 1000, 800, Bounds{});
  const View after(flat, 1000, 800, Bounds{});
  const Vec3 beside = start.target + before.right() * 0.7 + before.up() * 1.3;
  REQUIRE(glm::length(before.toScreen(beside) - after.toScreen(beside)) < 1e-9);
  const Camera back = withProjection(flat, false);
  REQUIRE(glm::length(back.eye - start.eye) < 1e-9);
  REQUIRE_FALSE(back.orthographic());
}
