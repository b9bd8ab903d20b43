#include <catch2/catch.hpp>

#include "cli/audit_depth.h"
#include "cli/audit_pixels.h"
#include "cli/audit_search.h"
#include "placement/base_lines.h"
#include "support/random.h"
#include "support/scenes.h"

// The audit's own eyes, against slower ones.

namespace dimline::test {
namespace {

CoverageMask emptyMask(int width, int height) {
  CoverageMask mask;
  mask.widthPx = width;
  mask.heightPx = height;
  mask.pixels.assign(static_cast<std::size_t>(width * height), 0);
  return mask;
}

void cover(CoverageMask& mask, int x, int y) { mask.pixels[static_cast<std::size_t>(y * mask.widthPx + x)] = 255; }

double slowDistance(const CoverageMask& mask, const Segment2& s) {
  double least = std::numeric_limits<double>::infinity();
  for (int y = 0; y < mask.heightPx; ++y) {
    for (int x = 0; x < mask.widthPx; ++x) {
      if (!mask.covered(x, y)) continue;
      for (int i = 0; i <= 2000; ++i) {
        const Vec2 p = s.start + (s.end - s.start) * (i / 2000.0);
        least = std::min(least, glm::length(p - Vec2(x + 0.5, y + 0.5)));
      }
    }
  }
  return std::max(0.0, least - 0.5);
}

TEST_CASE("mask picture: distances of segments are those to the nearest covered pixel") {
  Random random(7);
  for (int round = 0; round < 25; ++round) {
    CoverageMask mask = emptyMask(40, 30);
    const int count = random.whole(1, 12);
    for (int i = 0; i < count; ++i) cover(mask, random.whole(0, 39), random.whole(0, 29));
    MaskPicture picture;
    picture.read(mask);
    for (int i = 0; i < 10; ++i) {
      const Segment2 s{{random.real(0, 40), random.real(0, 30)}, {random.real(0, 40), random.real(0, 30)}};
      const double slow = slowDistance(mask, s);
      CHECK(picture.distancePx(s) == Approx(slow).margin(0.02));
      if (slow < 2) continue;  // so near to a lone pixel there is little to interpolate
      CHECK(picture.keepsDistance(s, slow - 0.55));
      CHECK_FALSE(picture.keepsDistance(s, slow + 0.3));
    }
  }
}

TEST_CASE("mask picture: an empty mask is infinitely far, a full one everywhere") {
  MaskPicture picture;
  picture.read(emptyMask(20, 20));
  const Segment2 s{{3, 3}, {15, 9}};
  CHECK(std::isinf(picture.distancePx(s)));
  CHECK(picture.keepsDistance(s, 1000));
  CHECK_FALSE(picture.crosses(s));
  CHECK(picture.outside({5, 5}));
  CoverageMask full = emptyMask(20, 20);
  full.pixels.assign(full.pixels.size(), 255);
  picture.read(full);
  CHECK(picture.distancePx(s) == 0);
  CHECK(picture.crosses(s));
  CHECK_FALSE(picture.outside({5, 5}));
  CHECK_FALSE(picture.seesAnEdge(s));
}

TEST_CASE("mask picture: a hole is not outside, a bay is, though no edge sees it") {
  // A ring with a hole, and right of it a cup that opens upwards and has a lid above.
  CoverageMask mask = emptyMask(60, 30);
  for (int x = 5; x < 25; ++x) {
    for (int y = 5; y < 25; ++y) {
      if (x < 8 || x >= 22 || y < 8 || y >= 22) cover(mask, x, y);
    }
  }
  for (int x = 32; x < 52; ++x) {
    for (int y = 5; y < 25; ++y) {
      if (x < 35 || x >= 49 || y >= 22) cover(mask, x, y);
    }
  }
  for (int x = 34; x < 50; ++x) cover(mask, x, 1);
  MaskPicture picture;
  picture.read(mask);
  CHECK_FALSE(picture.outside({15, 15}));
  CHECK(picture.outside({28, 15}));
  CHECK(picture.outside({42, 15}));
  CHECK_FALSE(picture.outside({33, 15}));
  CHECK_FALSE(picture.outside({-1, 15}));
  CHECK_FALSE(picture.seesAnEdge({{40, 15}, {44, 15}}));
  CHECK(picture.seesAnEdge({{26, 15}, {30, 15}}));
}

TEST_CASE("mask picture: every pixel on a segment's way counts") {
  CoverageMask mask = emptyMask(50, 50);
  for (int y = 20; y < 23; ++y) {
    for (int x = 30; x < 33; ++x) cover(mask, x, y);
  }
  MaskPicture picture;
  picture.read(mask);
  // Of the nine pixels only the middle one, [31, 32) x [21, 22), stays when the mask is eroded.
  CHECK(picture.crosses({{0, 21.5}, {50, 21.5}}));
  CHECK(picture.crosses({{31.9, 0}, {31.9, 50}}));
  CHECK_FALSE(picture.crosses({{0, 20.9}, {50, 20.9}}));
  CHECK_FALSE(picture.crosses({{0, 21.5}, {30.9, 21.5}}));
  CHECK(picture.crosses({{20, 10.6}, {42, 32.6}}));
  CHECK_FALSE(picture.crosses({{-20, 21.5}, {-2, 21.5}}));
  CHECK(picture.touches({{32.4, 22.4}, {40, 40}}));
  CHECK_FALSE(picture.touches({{32.6, 22.6}, {40, 40}}));
}

TEST_CASE("depth picture: its mask is the command line's, but for borders") {
  const auto model = makeModel(boxWithDoor());
  const Scene scene = model->definition.build(Values(model->parameters()));
  for (const double azimuthDeg : {0.0, 33.0, 120.0}) {
    for (const double distanceM : {7.0, 14.0, 40.0}) {  // from within arm's reach, where triangles are cut, to far away
      const View view(orbitCamera({0, 2.5, 0}, distanceM, azimuthDeg, 25), 500, 300, scene.bounds);
      DepthPicture depth;
      depth.draw(scene, view);
      const CoverageMask own = depth.mask();
      const CoverageMask slow = coverageMask(scene, view);
      REQUIRE(own.pixels.size() == slow.pixels.size());
      int different = 0;
      for (std::size_t i = 0; i < own.pixels.size(); ++i) different += own.pixels[i] != slow.pixels[i] ? 1 : 0;
      CHECK(different <= 3);
    }
  }
}

TEST_CASE("depth picture: what is before and behind") {
  Scene scene;
  addBox(scene, boxAt({-1, 0, -1}, {2, 2, 1}));
  finish(scene);
  for (const bool ortho : {false, true}) {
    Camera camera;
    camera.eye = {0, 1, 10};
    camera.target = {0, 1, 0};
    if (ortho) camera.orthoHeightM = 4;
    Bounds bounds = scene.bounds;
    bounds.add({0, 0, -6});
    bounds.add({0, 0, 4});
    const View view(camera, 600, 600, bounds);
    DepthPicture depth;
    depth.draw(scene, view);
    const auto share = [&](const Obb& box, double skinM) {
      const DepthPicture::Seen seen = depth.test(box, skinM);
      REQUIRE(seen.pixels > 100);
      return static_cast<double>(seen.seen) / seen.pixels;
    };
    CHECK(share(boxAt({-0.5, 0.5, 1}, {1, 1, 1}), 0) == 1);
    CHECK(share(boxAt({-0.5, 0.5, -5}, {1, 1, 1}), 0) == 0);
    CHECK(share(boxAt({-0.5, 0.5, -0.5}, {1, 1, 0.4}), 0.05) == 0);
    CHECK(share(boxAt({-0.5, 0.5, -0.5}, {1, 1, 0.45}), 0.1) == 1);  // its face within the skin
    // Looks out behind the block's edge: by 0.6 m of its 0.8 m, and in perspective by 0.11 m.
    CHECK(share(boxAt({0.8, 0.5, -5}, {0.8, 1, 0.1}), 0) == Approx(ortho ? 0.75 : 0.12).margin(0.03));
    CHECK(depth.seenShare({{-3, 1, 0}, {3, 1, 0}}, 0.01) == Approx(ortho ? 0.67 : 1.0).margin(0.05));
    CHECK(depth.seenShare({{-0.9, 1, -3}, {0.9, 1, -3}}, 0.01) == 0);
  }
}

}  // namespace
}  // namespace dimline::test
