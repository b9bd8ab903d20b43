#include "math/camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace dimline {
namespace {

using test::Random;

constexpr double kPi = 3.141592653589793;

Bounds unitBounds() {
  Bounds bounds;
  bounds.add({-1, -1, -1});
  bounds.add({1, 1, 1});
  return bounds;
}

Camera frontCamera() {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.target = {0, 0, 0};
  camera.fovRad = kPi / 2;
  return camera;
}

std::vector<Camera> manyCameras() {
  Random random(3);
  std::vector<Camera> cameras;
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.target = random.point(Vec3(-1.0), Vec3(1.0));
    camera.eye = camera.target + random.direction() * random.real(3, 50);
    camera.fovRad = random.scaled(0.2, 100) * kPi / 180;
    if (i % 3 == 0) camera.orthoHeightM = random.scaled(0.1, 30);
    if (i % 5 == 0) camera.up = random.direction() * random.real(0.1, 4);
    if (i % 17 == 0) camera.eye = camera.target + Vec3(0, 5, 0);  // looks straight down, along its up
    cameras.push_back(camera);
  }
  return cameras;
}

bool close(const Vec3& a, const Vec3& b, double within) { return glm::length(a - b) <= within; }

// --- validate
// -----------------------------------------------------------------------------------------------------------

TEST_CASE("a camera that can be used is accepted") {
  REQUIRE(validate(Camera{}));
  for (const Camera& camera : manyCameras()) REQUIRE(validate(camera));
  Camera down = frontCamera();
  down.eye = {0, 10, 0};  // up along the view
  REQUIRE(validate(down));
}

TEST_CASE("a camera that cannot be used gets a reason") {
  const double nan = std::nan("");
  const auto message = [](auto change) {
    Camera camera = frontCamera();
    change(camera);
    const Status status = validate(camera);
    REQUIRE_FALSE(status);
    return status.error().message;
  };
  REQUIRE(message([&](Camera& c) { c.eye.y = nan; }).find("finite") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.target.x = HUGE_VAL; }).find("finite") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.up.z = nan; }).find("finite") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.target = c.eye; }).find("same point") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.eye = c.target = Vec3(0.0); }).find("same point") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.up = Vec3(0.0); }).find("up") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.fovRad = 0; }).find("field of view") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.fovRad = kPi; }).find("field of view") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.fovRad = nan; }).find("field of view") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.orthoHeightM = 0; }).find("orthoHeight") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.orthoHeightM = nan; }).find("orthoHeight") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.orthoHeightM = HUGE_VAL; }).find("orthoHeight") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.eye.x = 1e17; }).find("1e12 metres") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.target.z = -1e13; }).find("1e12 metres") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.orthoHeightM = 1e-16; }).find("between 1e-9 and 1e12") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.orthoHeightM = 1e13; }).find("between 1e-9 and 1e12") != std::string::npos);
  REQUIRE(message([&](Camera& c) { c.fovRad = 1e-16; }).find("at least 1e-7 degrees") != std::string::npos);
}

// --- View, by hand
// ------------------------------------------------------------------------------------------------------

TEST_CASE("a view through 90 degrees, by hand") {
  const View view(frontCamera(), 200, 100, unitBounds());
  REQUIRE(close(view.right(), {1, 0, 0}, 1e-12));
  REQUIRE(close(view.up(), {0, 1, 0}, 1e-12));
  REQUIRE(close(view.forward(), {0, 0, -1}, 1e-12));
  const Vec2 middle = view.toScreen({0, 0, 0});
  REQUIRE(middle.x == Approx(100));
  REQUIRE(middle.y == Approx(50));
  // At 10 m, 45 degrees up is 10 m: half the viewport's height.
  REQUIRE(view.toScreen({0, 10, 0}).y == Approx(0).margin(1e-9));
  REQUIRE(view.toScreen({10, 0, 0}).x == Approx(150));
  REQUIRE(view.toScreen({10, 0, -10}).x == Approx(125));
  REQUIRE(view.depth({3, 4, 0}) == Approx(10));
  REQUIRE(view.metresPerPixelAt({3, 4, 0}) == Approx(0.2));
  REQUIRE(close(view.directionTo({10, 0, 0}), glm::normalize(Vec3(1, 0, -1)), 1e-12));
  REQUIRE((view.worldToPixels() * Vec4(3, 4, 0, 1)).z == Approx(10));  // w is the depth
  REQUIRE(view.viewport().max == Vec2(200, 100));
}

TEST_CASE("an up of any length rolls the camera as its direction says") {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.up = {1, 1, 0};
  const View view(camera, 100, 100, {});
  for (const double length : {1e300, 1e-200, 1e-310}) {
    camera.up = Vec3(length, length, 0);
    CHECK(glm::length(View(camera, 100, 100, {}).up() - view.up()) < 1e-9);
  }
}

TEST_CASE("an orthographic view, by hand") {
  Camera camera = frontCamera();
  camera.orthoHeightM = 5;
  const View view(camera, 200, 100, unitBounds());
  REQUIRE(view.orthographic());
  REQUIRE(view.toScreen({1, 1, 0}).x == Approx(120));
  REQUIRE(view.toScreen({1, 1, -7}).y == Approx(30));
  REQUIRE(view.metresPerPixelAt({0, 0, -7}) == Approx(0.05));
  REQUIRE(close(view.directionTo({8, 0, 0}), {0, 0, -1}, 1e-12));
  REQUIRE((view.worldToPixels() * Vec4(3, 4, -7, 1)).z == Approx(1));
}

TEST_CASE("the model lies between the near and the far plane, with room for lines around it") {
  const View view(frontCamera(), 100, 100, unitBounds());
  const double sizeM = std::sqrt(12.0);
  REQUIRE(view.nearM() == Approx(9 - sizeM));
  REQUIRE(view.farM() == Approx(11 + sizeM));
  REQUIRE(view.inFrontOfNear({0, 0, 1}));
  REQUIRE_FALSE(view.inFrontOfNear({0, 0, 9.5}));
}

TEST_CASE("the near plane stays before the eye when the model does not") {
  Camera camera = frontCamera();
  camera.eye = {0, 0, 0.5};
  const View view(camera, 100, 100, unitBounds());
  REQUIRE(view.nearM() > 0);
  REQUIRE(view.nearM() < 0.01);
  REQUIRE(view.farM() > 1.5);
  camera.eye = {0, 0, -20};
  camera.target = {0, 0, -30};  // the model is behind
  const View away(camera, 100, 100, unitBounds());
  REQUIRE(away.nearM() > 0);
  REQUIRE(away.farM() > away.nearM());
  // An orthographic eye is only a direction.
  camera.orthoHeightM = 4;
  const View parallel(camera, 100, 100, unitBounds());
  REQUIRE(parallel.inFrontOfNear({0, 0, 1}));
}

TEST_CASE("a view of nothing still projects") {
  const View view(frontCamera(), 100, 100, Bounds{});
  REQUIRE(view.nearM() > 0);
  REQUIRE(view.farM() > view.nearM());
  REQUIRE(view.toScreen({0, 0, 0}).x == Approx(50));
}

// --- View, in general
// ---------------------------------------------------------------------------------------------------

TEST_CASE("the camera's frame is orthonormal and right-handed, also when up says nothing") {
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 300, 200, unitBounds());
    for (const Vec3& axis : {view.right(), view.up(), view.forward()}) REQUIRE(glm::length(axis) == Approx(1));
    REQUIRE(close(glm::cross(view.right(), view.up()), -view.forward(), 1e-9));
    REQUIRE(close(view.forward(), glm::normalize(camera.target - camera.eye), 1e-9));
  }
}

TEST_CASE("pixels are what OpenGL's matrices give") {
  Random random(4);
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 640, 360, unitBounds());
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = random.point(Vec3(-1.0), Vec3(1.0));
      const Vec4 clip = view.projectionMatrix() * view.viewMatrix() * Vec4(p, 1);
      REQUIRE(clip.w > 0);
      const Vec2 q = view.toScreen(p);
      REQUIRE(q.x == Approx((clip.x / clip.w + 1) * 320).margin(1e-6));
      REQUIRE(q.y == Approx((1 - clip.y / clip.w) * 180).margin(1e-6));
      if (view.inFrontOfNear(p)) {
        REQUIRE(clip.z / clip.w >= -1 - 1e-9);
        REQUIRE(clip.z / clip.w <= 1 + 1e-9);
      }
    }
  }
}

TEST_CASE("the ray through a point's pixel meets the point") {
  Random random(5);
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 640, 360, unitBounds());
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = random.point(Vec3(-1.0), Vec3(1.0));
      const View::Ray ray = view.rayThrough(view.toScreen(p));
      REQUIRE(glm::length(ray.direction) == Approx(1));
      const double along = glm::dot(p - ray.origin, ray.direction);
      REQUIRE(close(ray.origin + ray.direction * along, p, 1e-6));
      REQUIRE(close(ray.direction, view.directionTo(p), 1e-6));
    }
  }
}

TEST_CASE("a pixel's length in the world is what moves a point by one pixel") {
  Random random(6);
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 640, 360, unitBounds());
    const Vec3 p = random.point(Vec3(-1.0), Vec3(1.0));
    const Vec2 moved = view.toScreen(p + view.right() * view.metresPerPixelAt(p)) - view.toScreen(p);
    REQUIRE(moved.x == Approx(1).margin(1e-6));
    REQUIRE(moved.y == Approx(0).margin(1e-6));
  }
}

TEST_CASE("no metre within a ball looks longer than the most that is said of it") {
  Random random(8);
  double closest = 0;   // of what was seen to the most that was said
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 640, 360, unitBounds());
    for (int i = 0; i < 200; ++i) {
      const Vec3 center = random.point(Vec3(-1.0), Vec3(1.0));
      const double radius = random.real(0.01, 0.2);
      const double most = view.mostPixelsPerMetre(center, radius);
      const auto within = [&] { return center + random.direction() * random.real(0, radius); };
      const Segment segment{within(), within()};
      if (!view.inFrontOfNear(segment.start) || !view.inFrontOfNear(segment.end)) continue;
      const double seen = view.toScreen(segment).length() / segment.length();
      CHECK(seen <= most * (1 + 1e-9));
      closest = std::max(closest, seen / most);
    }
  }
  CHECK(closest > 0.8);   // not just any large number
}

// --- Cameras that show a model
// ------------------------------------------------------------------------------------------

Box2 screenBox(const View& view, const Bounds& bounds) {
  Box2 box;
  for (int i = 0; i < 8; ++i) box.add(view.toScreen(bounds.corner(i)));
  return box;
}

TEST_CASE("window depth is 0 at the near plane and 1 at the far one, and grows evenly along a straight line on screen") {
  Random random(11);
  for (const Camera& camera : manyCameras()) {
    const View view(camera, 640, 360, unitBounds());
    CHECK(view.windowDepth(camera.eye + view.forward() * view.nearM()) == Approx(0).margin(1e-6));
    CHECK(view.windowDepth(camera.eye + view.forward() * view.farM()) == Approx(1).margin(1e-6));
    const Segment line{random.point(Vec3(-1.0), Vec3(1.0)), random.point(Vec3(-1.0), Vec3(1.0))};
    if (!view.inFrontOfNear(line.start) || !view.inFrontOfNear(line.end)) continue;
    CHECK(view.depthFromWindow(view.windowDepth(line.start)) == Approx(view.depth(line.start)));
    const Vec3 between = glm::mix(line.start, line.end, random.real(0.1, 0.9));
    const Segment2 screen = view.toScreen(line);
    if (!(screen.length() > 1)) continue;
    const double share = glm::length(view.toScreen(between) - screen.start) / screen.length();
    CHECK(view.windowDepth(between) == Approx(glm::mix(view.windowDepth(line.start), view.windowDepth(line.end), share)).margin(1e-6));
  }
}

TEST_CASE("the opening view is from the front right, a little above, with room for lines") {
  Bounds bounds;
  bounds.add({-4, 0, -3});
  bounds.add({4, 7, 3});
  const Camera camera = threeQuarterView(bounds, 1000, 800);
  REQUIRE(validate(camera));
  REQUIRE(camera.eye.x > bounds.max.x);
  REQUIRE(camera.eye.y > bounds.center().y);
  REQUIRE(camera.eye.z > bounds.max.z);
  REQUIRE(camera.target == bounds.center());
  const View view(camera, 1000, 800, bounds);
  const Box2 box = screenBox(view, bounds);
  REQUIRE(box.min.x > 100);
  REQUIRE(box.min.y > 80);
  REQUIRE(box.max.x < 900);
  REQUIRE(box.max.y < 720);
  REQUIRE(std::max((box.max.x - box.min.x) / 1000, (box.max.y - box.min.y) / 800) > 0.5);
}

TEST_CASE("fitting keeps the direction, and the model in the picture") {
  Random random(7);
  for (const Camera& camera : manyCameras()) {
    Bounds bounds;
    bounds.add(random.point(Vec3(-100.0), Vec3(100.0)));
    bounds.add(random.point(Vec3(-100.0), Vec3(100.0)));
    const double width = random.real(300, 2000);
    const double height = random.real(200, 2000);
    const Camera fitted = fitToView(camera, bounds, width, height);
    REQUIRE(validate(fitted));
    const View before(camera, width, height, bounds);
    const View view(fitted, width, height, bounds);
    REQUIRE(close(view.forward(), before.forward(), 1e-9));
    REQUIRE(close(view.up(), before.up(), 1e-9));
    REQUIRE(fitted.fovRad == camera.fovRad);
    REQUIRE(fitted.orthographic() == camera.orthographic());
    const Box2 box = screenBox(view, bounds);
    // Never past the share; and one side of the box reaches it, seen from the middle.
    const Vec2 reach =
        glm::max(glm::abs(box.min - Vec2(width, height) * 0.5), glm::abs(box.max - Vec2(width, height) * 0.5)) /
        (Vec2(width, height) * 0.5);
    REQUIRE(std::max(reach.x, reach.y) == Approx(0.62).epsilon(1e-6));
  }
}

TEST_CASE("fitting a point or nothing gives a camera that can be used") {
  Bounds point;
  point.add({1, 2, 3});
  REQUIRE(validate(fitToView(Camera{}, point, 100, 100)));
  REQUIRE(fitToView(Camera{}, Bounds{}, 100, 100).eye == Camera{}.eye);
  REQUIRE(validate(threeQuarterView(point, 100, 100)));
  REQUIRE(validate(threeQuarterView(Bounds{}, 100, 100)));
  Camera parallel;
  parallel.orthoHeightM = 3;
  REQUIRE(validate(fitToView(parallel, point, 100, 100)));
}

}  // namespace
}  // namespace dimline
