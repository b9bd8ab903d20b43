#include <array>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "silhouette/depth_buffer.h"
#include "silhouette/scene_shapes.h"
#include "support/random.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

constexpr int kSide = 64;

/// A view of 64 by 64 samples, 10 m across.
View frontView(bool orthographic) {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.fovRad = 0.5;
  if (orthographic) camera.orthoHeightM = 10;
  return {camera, kSide, kSide, {{-5, -5, -5}, {5, 5, 5}}};
}

/// How far (px) a place lies within a triangle on screen, from the nearest of its sides' carriers; negative outside.
double withinPx(const Vec2& p, const std::array<Vec2, 3>& t) {
  double least = std::numeric_limits<double>::infinity();
  const double turn = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 side = t[(i + 1) % 3] - t[i];
    least = std::min(least, turn * (side.x * (p.y - t[i].y) - side.y * (p.x - t[i].x)) / glm::length(side));
  }
  return least;
}

/// The depth of a triangle's plane at a place on screen, where depths after the division by w are linear.
double depthAt(const Vec2& p, const std::array<Vec2, 3>& t, const std::array<double, 3>& depth) {
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  const double w1 = ((p.x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (p.y - t[0].y)) / area;
  const double w2 = ((t[1].x - t[0].x) * (p.y - t[0].y) - (p.x - t[0].x) * (t[1].y - t[0].y)) / area;
  return depth[0] * (1 - w1 - w2) + depth[1] * w1 + depth[2] * w2;
}

}  // namespace

TEST_CASE("a triangle covers the samples whose centres lie in it, at its plane's depth, and no others") {
  Random random(11);
  std::size_t covered = 0;
  for (int n = 0; n < 400; ++n) {
    const View view = frontView(n % 2 == 0);
    // Large and small ones, slivers, and some that leave the viewport.
    const double size = random.scaled(0.01, 10);
    const Vec3 middle(random.real(-6, 6), random.real(-6, 6), random.real(-4, 4));
    std::array<Vec3, 3> world;
    std::array<Vec2, 3> screen;
    std::array<double, 3> depth{};
    for (std::size_t i = 0; i < 3; ++i) {
      world[i] = middle + Vec3(random.real(-size, size), random.real(-size, size), random.real(-size, size));
      screen[i] = view.toScreen(world[i]);
      depth[i] = 2 * view.windowDepth(world[i]) - 1;
    }
    DepthBuffer buffer;
    buffer.reset(view, kSide);
    buffer.draw(world);
    bool asExpected = true;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Vec2 center(x + 0.5, y + 0.5);
        const double within = withinPx(center, screen);
        if (std::abs(within) < 1e-6) continue;   // on a side it may be either
        const double expected = within > 0 ? std::min(1.0, depthAt(center, screen, depth)) : 1.0;
        asExpected = asExpected && std::abs(static_cast<double>(buffer.at(x, y)) - expected) < 1e-5;
        covered += within > 0 ? 1 : 0;
      }
    }
    CAPTURE(n);
    CHECK(asExpected);
  }
  CHECK(covered > 10000);
}

TEST_CASE("triangles that share sides leave no sample between them") {
  // A sheet square to the viewer, of so many cells that most sides pass between the samples' centres, and some through them.
  for (const int cells : {1, 3, 8, 64, 150}) {
    Scene scene;
    Mesh sheet = sheetMesh(cells, 0.0);
    for (glm::vec3& p : sheet.positions) p = {p.x * 4, p.z * 4, 0};
    scene.meshes.push_back(sheet);
    scene.instances.push_back({});
    finish(scene);
    const View view = frontView(true);
    DepthBuffer buffer;
    buffer.reset(view, kSide);
    buffer.draw(scene);
    // 8 m of 10 m in 64 samples: 51.2 samples, of which the outermost are seen in part.
    int missing = 0;
    for (int y = 7; y < 57; ++y) {
      for (int x = 7; x < 57; ++x) missing += buffer.at(x, y) == 1.0F ? 1 : 0;
    }
    CAPTURE(cells);
    CHECK(missing == 0);
    CHECK(buffer.at(5, 32) == 1.0F);
    CHECK(buffer.at(32, 58) == 1.0F);
  }
}

TEST_CASE("a scene is drawn as its triangles are one by one, those that the near plane cuts too") {
  Scene scene;
  scene.meshes.push_back(sphereMesh(9, 14));
  Instance instance;
  instance.transform = glm::translate(glm::mat4(1.0F), glm::vec3(0.3F, -0.2F, 0.1F)) * glm::scale(glm::mat4(1.0F), glm::vec3(5.0F));
  scene.instances.push_back(instance);
  finish(scene);
  for (const double distanceM : {3.0, 5.2, 12.0}) {   // from within the sphere, through it, and from outside
    Camera camera;
    camera.eye = {0, 0, distanceM};
    const View view(camera, kSide, kSide, scene.bounds);
    DepthBuffer whole, single;
    whole.reset(view, kSide);
    single.reset(view, kSide);
    whole.draw(scene);
    const Mesh& mesh = scene.meshes[0];
    const auto worldOf = [&](std::uint32_t i) { return Vec3(Mat4(instance.transform) * Vec4(Vec3(mesh.positions[i]), 1.0)); };
    for (const auto& t : mesh.triangles) single.draw({worldOf(t[0]), worldOf(t[1]), worldOf(t[2])});
    int drawn = 0, different = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        drawn += whole.at(x, y) < 1.0F ? 1 : 0;
        different += whole.at(x, y) == single.at(x, y) ? 0 : 1;
      }
    }
    CAPTURE(distanceM);
    CHECK(drawn > 500);
    CHECK(different == 0);
  }
}
