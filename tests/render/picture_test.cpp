#include "render/picture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "render/overlay_line.h"
#include "silhouette/coverage_mask.h"
#include "support/scenes.h"
#include "support/village.h"

using namespace dimline;
using test::Picture;
using test::PictureFixture;

namespace {

/// A box 8 wide, 5 high and 6 deep on the ground, its middle above the origin.
Scene boxOnGround() {
  Scene scene;
  test::addBox(scene, test::boxAt({-4, 0, -3}, {8, 5, 6}));
  finish(scene);
  return scene;
}

View viewOf(const Scene& scene, double azimuthDeg, double elevationDeg, double sizePx = 240) {
  const Camera camera = test::orbitCamera(scene.bounds.center(), 10, azimuthDeg, elevationDeg);
  return {fitToView(camera, scene.bounds, sizePx, sizePx), sizePx, sizePx, scene.bounds};
}

double spread(const Picture& picture) {
  const auto [low, high] = std::minmax_element(picture.rgba.begin(), picture.rgba.end());
  return static_cast<double>(*high) - *low;
}

/// Standard deviation of the brightness around a pixel.
double roughness(const Picture& picture, const Vec2& middle, int half) {
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (int y = static_cast<int>(middle.y) - half; y <= static_cast<int>(middle.y) + half; ++y) {
    for (int x = static_cast<int>(middle.x) - half; x <= static_cast<int>(middle.x) + half; ++x) {
      const auto b = static_cast<double>(picture.brightness(x, y));
      sum += b;
      squares += b * b;
      ++count;
    }
  }
  const double mean = sum / count;
  return std::sqrt(std::max(0.0, squares / count - mean * mean));
}

}  // namespace

TEST_CASE("the model is where its mask is, and nowhere else") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  fixture.setScene(scene);
  fixture.options.ground = false;
  for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kReduced}) {
    fixture.options.quality = quality;
    for (const double azimuthDeg : {20.0, 140.0, 260.0}) {
      const View view = viewOf(scene, azimuthDeg, 15);
      const Picture picture = fixture.draw(view);
      fixture.setScene(Scene{});
      const Picture empty = fixture.draw(view);
      fixture.setScene(scene);
      const CoverageMask mask = coverageMask(scene, view);
      int covered = 0;
      int wrong = 0;
      for (int y = 2; y < picture.height - 2; ++y) {
        for (int x = 2; x < picture.width - 2; ++x) {
          // Edges are inked and smoothed: only pixels whose neighbours are as they are count.
          bool uniform = true;
          for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) uniform = uniform && mask.covered(x + dx, y + dy) == mask.covered(x, y);
          }
          if (!uniform) continue;
          const bool different = glm::length(picture.at(x, y) - empty.at(x, y)) > 6.0F;
          covered += mask.covered(x, y) ? 1 : 0;
          wrong += different == mask.covered(x, y) ? 0 : 1;
        }
      }
      CHECK(covered > 2000);
      CHECK(wrong <= covered / 200);
    }
  }
}

TEST_CASE("every pixel is opaque, whatever is drawn") {
  PictureFixture fixture;
  fixture.setScene(boxOnGround());
  const Picture picture = fixture.draw(viewOf(boxOnGround(), 30, 20, 100));
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) REQUIRE(picture.rgba[i] == 255);
  CHECK(spread(picture) > 60);
}

TEST_CASE("the side that faces the sun is brighter than the one that does not") {
  PictureFixture fixture;
  const Scene scene = boxOnGround();
  fixture.setScene(scene);
  const View view = viewOf(scene, 45, 20);
  const Picture picture = fixture.draw(view);
  const float front = picture.brightnessAround(view.toScreen(Vec3(0, 2.5, 3)), 6);
  const float right = picture.brightnessAround(view.toScreen(Vec3(4, 2.5, 0)), 6);
  const float top = picture.brightnessAround(view.toScreen(Vec3(0, 5, 0)), 4);
  CHECK(front > right + 15);
  CHECK(top > right + 15);
  CHECK(right > 60);   // the sky's light reaches it
}

TEST_CASE("the ground takes the shadow on the side away from the sun, soft at its edge") {
  PictureFixture fixture;
  const Scene scene = boxOnGround();
  fixture.setScene(scene);
  const View view = viewOf(scene, 60, 45, 300);
  const Picture picture = fixture.draw(view);
  fixture.options.ground = false;
  const Picture bare = fixture.draw(view);
  const auto shade = [&](const Vec3& world) {
    const Vec2 px = view.toScreen(world);
    return bare.brightnessAround(px, 2) - picture.brightnessAround(px, 2);
  };
  // The sun stands in the front left: the shadow lies to the right and to the back.
  const float inShadow = shade({5.2, 0, -1});
  const float inSun = shade({-1, 0, 8});
  CHECK(inShadow > 30);
  CHECK(inSun < 14);
  // The ground darkens towards the wall where no sun is missing.
  CHECK(shade({-1, 0, 3.3}) > inSun + 5);
}

TEST_CASE("an overhang shades the wall beneath it") {
  PictureFixture fixture;
  Scene scene = boxOnGround();
  test::addBox(scene, test::boxAt({-4.5, 4.6, 2.5}, {9, 0.4, 1.9}));
  finish(scene);
  fixture.setScene(scene);
  const View view = viewOf(scene, 10, 5);
  const Picture picture = fixture.draw(view);
  CHECK(picture.brightnessAround(view.toScreen(Vec3(0, 4.0, 3)), 3) + 20 < picture.brightnessAround(view.toScreen(Vec3(0, 1.0, 3)), 3));
}

TEST_CASE("from below the ground does not hide the model") {
  PictureFixture fixture;
  const Scene scene = boxOnGround();
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, -25);
  const Picture with = fixture.draw(view);
  fixture.options.ground = false;
  const Picture without = fixture.draw(view);
  CHECK(meanDifference(with, without) == 0);
}

TEST_CASE("seen level, the ground is a line under the model") {
  PictureFixture fixture;
  const Scene scene = boxOnGround();
  fixture.setScene(scene);
  Camera camera = test::orbitCamera(scene.bounds.center(), 10, 0, 0);
  camera.orthoHeightM = 10;
  const View view(camera, 200, 200, scene.bounds);
  const Picture with = fixture.draw(view);
  fixture.options.ground = false;
  const Picture without = fixture.draw(view);
  const Vec2 beside = view.toScreen(Vec3(4.5, 0, 0));
  const int x = static_cast<int>(beside.x);
  const int y = static_cast<int>(std::floor(beside.y));
  CHECK(without.brightness(x, y) - with.brightness(x, y) > 80);
  CHECK(std::abs(without.brightness(x, y - 3) - with.brightness(x, y - 3)) < 2);
}

TEST_CASE("pictures at pixel ratios 1, 1.5 and 3 show the same") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, 18, 200);
  const Picture one = fixture.draw(view);
  for (const int ratio : {2, 3}) {
    const Picture fine = fixture.draw(view, ratio);
    REQUIRE(fine.width == 200 * ratio);
    double sum = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        glm::vec4 mean(0.0F);
        for (int i = 0; i < ratio * ratio; ++i) mean += fine.at(x * ratio + i % ratio, y * ratio + i / ratio);
        const glm::vec4 difference = glm::abs(mean / static_cast<float>(ratio * ratio) - one.at(x, y));
        sum += static_cast<double>(difference.r + difference.g + difference.b) / 3;
      }
    }
    CHECK(sum / (200 * 200) < 2.5);
  }
  CHECK(fixture.draw(view, 1.5).width == 300);
}

TEST_CASE("the reduced picture is like the full one") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, 18);
  const Picture full = fixture.draw(view);
  fixture.options.quality = RenderQuality::kReduced;
  fixture.setScene(scene);
  const Picture reduced = fixture.draw(view);
  CHECK(meanDifference(full, reduced) < 2.5);
  CHECK(meanDifference(full, reduced) > 0);
}

TEST_CASE("every pattern compiles, with and without an image, in both qualities, and shows") {
  PictureFixture fixture;
  for (int pattern = 0; pattern <= static_cast<int>(Material::Pattern::kFabric); ++pattern) {
    for (const int image : {-1, 0}) {
      Scene scene = boxOnGround();
      scene.materials[0].pattern = static_cast<Material::Pattern>(pattern);
      scene.materials[0].color = {0.4F, 0.3F, 0.25F};
      scene.materials[0].image = image;
      scene.materials[0].roughness = 0.3F;
      scene.images.push_back(share({2, 1, {255, 255, 255, 255, 128, 128, 128, 255}}));
      fixture.setScene(scene);
      for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kReduced}) {
        fixture.options.quality = quality;
        const View view = viewOf(scene, 30, 18, 120);
        const float wall = fixture.draw(view).brightnessAround(view.toScreen(Vec3(0, 2, 3)), 5);
        INFO("pattern " << pattern << ", image " << image);
        CHECK(wall > 25);
        CHECK(wall < 225);
      }
    }
  }
}

TEST_CASE("what is finer than a pixel is even: patterns do not shimmer from afar") {
  PictureFixture fixture;
  fixture.options.ground = false;
  for (int pattern = 0; pattern <= static_cast<int>(Material::Pattern::kFabric); ++pattern) {
    if (pattern == static_cast<int>(Material::Pattern::kGlass)) continue;   // a mirror, not a pattern
    Scene scene;
    test::addBox(scene, test::boxAt({-60, 0, -3}, {120, 120, 6}));
    scene.materials[0].pattern = static_cast<Material::Pattern>(pattern);
    scene.materials[0].color = {0.4F, 0.3F, 0.25F};
    finish(scene);
    fixture.setScene(scene);
    Camera camera = test::orbitCamera(scene.bounds.center(), 10, 0, 0);
    camera.orthoHeightM = 180;   // 1.5 m a pixel
    const View view(camera, 120, 120, scene.bounds);
    const double rough = roughness(fixture.draw(view), view.toScreen(Vec3(0, 50, 3)), 15);
    INFO("pattern " << pattern << ": " << rough);
    CHECK(rough < 3.0);
  }
}

TEST_CASE("patterns show from near") {
  PictureFixture fixture;
  using enum Material::Pattern;
  for (const Material::Pattern pattern : {kBrick, kPlanks, kRoofTiles, kStone}) {
    Scene scene = boxOnGround();
    scene.materials[0].pattern = pattern;
    scene.materials[0].color = {0.4F, 0.3F, 0.25F};
    fixture.setScene(scene);
    Camera camera = test::orbitCamera({0, 2.5, 3}, 10, 0, 0);
    camera.orthoHeightM = 3;
    const View view(camera, 200, 200, scene.bounds);
    INFO("pattern " << static_cast<int>(pattern));
    CHECK(roughness(fixture.draw(view), {100, 100}, 60) > 4.0);
  }
}

TEST_CASE("an image is shown the right way up") {
  PictureFixture fixture;
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {-1, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {0, 0};
  const glm::vec3 front(0, 0, 1);
  mesh.normals = {{front, front, front}, {front, front, front}};
  // As glTF has it: v runs down, from the image's top row.
  mesh.uvs = {{glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)}, {glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(0, 0)}};
  scene.meshes.push_back(mesh);
  scene.instances.push_back({});
  scene.materials.push_back({.color = {1, 1, 1}, .image = 0});
  scene.images.push_back(share({1, 2, {230, 20, 20, 255, 20, 20, 230, 255}}));   // red above blue
  finish(scene);
  fixture.setScene(scene);
  Camera camera = test::orbitCamera({0, 1, 0}, 5, 0, 0);
  camera.orthoHeightM = 4;
  const Picture picture = fixture.draw(View(camera, 80, 80, scene.bounds));
  const glm::vec4 upper = picture.at(40, 30);
  const glm::vec4 lower = picture.at(40, 50);
  CHECK(upper.r > upper.b + 60);
  CHECK(lower.b > lower.r + 60);
}

TEST_CASE("a scene may have thousands of materials") {
  PictureFixture fixture;
  Scene scene = boxOnGround();
  scene.materials.resize(3000);
  scene.materials[2999].color = {0.7F, 0.02F, 0.02F};
  for (std::uint16_t& material : scene.meshes[0].materials) material = 2999;
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, 18, 100);
  const Vec2 wall = view.toScreen(Vec3(0, 2, 3));
  const glm::vec4 color = fixture.draw(view).at(static_cast<int>(wall.x), static_cast<int>(wall.y));
  CHECK(color.r > color.g + 60);
}

TEST_CASE("odd views are drawn without complaint") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  fixture.setScene(scene);
  Camera inside = test::orbitCamera({0, 2, 0}, 0.5, 20, 0);
  CHECK(spread(fixture.draw(View(inside, 64, 64, scene.bounds))) > 10);
  CHECK(fixture.draw(View(inside, 1, 1, scene.bounds)).rgba.size() == 4);
  fixture.setScene(Scene{});
  const Picture empty = fixture.draw(View(inside, 64, 64, Bounds{}));
  CHECK(empty.brightness(32, 60) > 230);   // paper, still
  fixture.options.widthPx = 0;
  CHECK(fixture.renderer->draw(View(inside, 64, 64, Bounds{}), {}, fixture.options));
}

TEST_CASE("a picture kept under changing lines is the one that would be drawn anew") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, 18);
  OverlayLine line;
  line.line = {{20, 200}, {220, 210}};
  const Picture first = fixture.draw(view);
  const Picture withLine = fixture.draw(view, 1, {.lines = {&line, 1}});
  const Picture again = fixture.draw(view);
  CHECK(meanDifference(first, withLine) > 0.05);
  CHECK(meanDifference(first, again) == 0);
  // A full picture stays when a reduced one would do.
  fixture.options.quality = RenderQuality::kReduced;
  CHECK(meanDifference(first, fixture.draw(view)) == 0);
  fixture.options.quality = RenderQuality::kFull;
  // Another camera, another scene, other options: each is noticed.
  CHECK(meanDifference(first, fixture.draw(viewOf(scene, 40, 18))) > 0.5);
  fixture.setScene(boxOnGround());
  CHECK(meanDifference(first, fixture.draw(view)) > 0.5);
}

TEST_CASE("a model that changes while the picture is reduced ends as if it had been there from the start") {
  PictureFixture fixture;
  const Scene small = boxOnGround();
  Scene large = boxOnGround();
  large.meshes.clear();
  large.instances.clear();
  test::addBox(large, test::boxAt({-4, 0, -3}, {9, 6, 6}));
  finish(large);
  const View view = viewOf(large, 30, 25);
  for (const LightDetail light : {LightDetail::kFine, LightDetail::kCoarse}) {
    fixture.options.light = light;
    fixture.setScene(large);
    const Picture expected = fixture.draw(view);
    fixture.setScene(small);
    fixture.draw(view);
    fixture.options.quality = RenderQuality::kReduced;
    fixture.setScene(large);
    const Picture moving = fixture.draw(view);
    CHECK(meanDifference(moving, expected) < 4);
    fixture.options.quality = RenderQuality::kFull;
    CHECK(meanDifference(fixture.draw(view), expected) == 0);
  }
}

TEST_CASE("coarse light is hardly told from fine light, and is never kept where fine light is wanted") {
  PictureFixture fixture;
  const Scene scene = test::villageScene();
  const View view = viewOf(scene, 30, 18);
  fixture.setScene(scene);
  const Picture fine = fixture.draw(view);
  fixture.setScene(scene);
  fixture.options.light = LightDetail::kCoarse;
  const Picture coarse = fixture.draw(view);
  CHECK(meanDifference(fine, coarse) > 0);
  CHECK(meanDifference(fine, coarse) < 1.5);
  fixture.options.light = LightDetail::kFine;
  CHECK(meanDifference(fine, fixture.draw(view)) == 0);
}

TEST_CASE("a reduced picture of a model that nothing is known of has rough light, and the full one after it has not") {
  const Scene scene = test::villageScene();
  const View view = viewOf(scene, 30, 18);
  PictureFixture fixture;
  fixture.options.light = LightDetail::kCoarse;
  fixture.setScene(scene);
  const Picture expected = fixture.draw(view);
  fixture.options.quality = RenderQuality::kReduced;
  const double reducedAlone = meanDifference(fixture.draw(viewOf(scene, 30.001, 18)), expected);
  fixture.setScene(boxOnGround());   // of another shape: its light cannot be stretched to the village
  fixture.draw(viewOf(boxOnGround(), 30, 18));
  fixture.setScene(scene);
  const double rough = meanDifference(fixture.draw(view), expected);
  CHECK(rough > 2 * reducedAlone);
  CHECK(rough < reducedAlone + 2);
  fixture.options.quality = RenderQuality::kFull;
  CHECK(meanDifference(fixture.draw(view), expected) == 0);
}

TEST_CASE("what the model hides of a line is faint, whatever the picture's quality and pixel ratio; a bar does not hide it") {
  // Seen straight from the front, 20 px a metre: the box, and to its left a bar of 3 px.
  Scene scene = boxOnGround();
  test::addBox(scene, test::boxAt({-7, 0, 2}, {0.15, 5, 0.15}));
  finish(scene);
  Camera camera = test::orbitCamera({0, 2.5, 0}, 40, 0, 0);
  camera.orthoHeightM = 12;
  const View view(camera, 320, 240, scene.bounds);
  const auto lineAt = [&](double z) {
    PlacedLine placed;
    placed.placement = PlacementKind::kInside;
    placed.line = placed.base = {{-8, 1.52, z}, {8, 1.52, z}};
    placed.lineScreen = placed.baseScreen = view.toScreen(placed.line);
    return placed;
  };
  scene.scopes.push_back({"Box", 0, test::boxAt({-4, 0, -3}, {8, 5, 6})});
  PictureFixture fixture;
  fixture.setScene(scene);
  fixture.options.ground = false;
  for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kReduced}) {
    for (const double ratio : {1.0, 2.0}) {
      fixture.options.quality = quality;
      const Picture bare = fixture.draw(view, ratio);
      const auto inkAt = [&](const Picture& picture, double x) {
        const Vec2 px = view.toScreen(Vec3(x, 1.52, 0)) * ratio;
        return bare.brightnessAround(px, 1) - picture.brightnessAround(px, 1);
      };
      const auto drawn = [&](double z) {
        const PlacedLine placed = lineAt(z);
        const OverlayLine line = overlayLine(placed, scene, view);
        return fixture.draw(view, ratio, {.lines = {&line, 1}});
      };
      INFO((quality == RenderQuality::kFull ? "full" : "reduced") << ", ratio " << ratio);
      const Picture before = drawn(3);   // on the box's front face
      const Picture behind = drawn(-3);
      CHECK(inkAt(before, 0) > 30);
      CHECK(inkAt(behind, 0) < 0.6F * inkAt(before, 0));
      CHECK(inkAt(behind, 0) > 5);
      CHECK(inkAt(behind, -5.5) == Approx(inkAt(before, -5.5)).margin(1));   // beside the box
      CHECK(inkAt(behind, -6.925) == Approx(inkAt(before, -6.925)).margin(1));
    }
  }
}

TEST_CASE("after its context is lost a renderer goes without a GL call, and the next one draws the same") {
  PictureFixture fixture;
  const Scene scene = boxOnGround();
  fixture.setScene(scene);
  const View view = viewOf(scene, 30, 20, 100);
  const Picture before = fixture.draw(view);
  fixture.renderer->abandon();
  fixture.native.reset();   // no context is current any more: a GL call would crash or be lost
  fixture.renderer.reset();

  PictureFixture next;
  next.setScene(scene);
  CHECK(meanDifference(before, next.draw(view)) == 0);
}
