#include <cmath>

#include <catch2/catch.hpp>

#include "model/builder.h"
#include "support/mesh_checks.h"

namespace dimline {
namespace {

const double kSlope45 = std::atan(1.0);

RoofOptions options(double pitchRad, double overhangM, double thicknessM) {
  RoofOptions o;
  o.pitchRad = pitchRad;
  o.overhangM = overhangM;
  o.thicknessM = thicknessM;
  return o;
}

struct Made {
  Roof roof;
  Scene scene;
};
template <typename Make>
Made over(double width, double depth, Make&& make) {
  Builder b;
  b.scale({width, 0, depth});
  Made made;
  made.roof = make(b);
  made.scene = b.finish();
  CHECK(test::defectOf(made.scene) == "");
  return made;
}

TEST_CASE("a gable's slab lies on the walls and hangs down over them") {
  // 45 degrees, 8 by 6, 0.5 over: upright thickness 0.2 sqrt 2, ridge 3 above the wall, eave 0.5 below it.
  const double t = 0.2 * std::sqrt(2.0);
  const auto [roof, scene] = over(8, 6, [](Builder& b) { return b.roofGable(options(kSlope45, 0.5, 0.2)); });
  CHECK(roof.min.y == Approx(-0.5));
  CHECK(roof.max.y == Approx(3 + t));
  CHECK(roof.min.x == Approx(-0.5));
  CHECK(roof.max.z == Approx(6.5));
  CHECK(roof.heightAt(4, 3) == Approx(3 + t));
  CHECK(roof.heightAt(4, 6) == Approx(t));
  CHECK(roof.heightAt(4, 0) == Approx(t));
  CHECK(options(kSlope45, 0.5, 0.2).eaveDropM() == Approx(0.5));
  CHECK(test::volumeOf(scene.meshes[0]) == Approx(9 * 7 * t).epsilon(1e-5));  // upright thickness over the plan
  REQUIRE(roof.eaves.size() == 2);
  CHECK(roof.eaves[0].start.y == Approx(t - 0.5));
  CHECK(roof.eaves[0].start.z == Approx(6.5));
  REQUIRE(roof.ridges.size() == 1);
  CHECK(roof.ridges[0].length() == Approx(9));
}

TEST_CASE("a hip roof rises alike from all sides, whichever is longer") {
  for (const auto& [w, d] : {std::pair(8.0, 6.0), std::pair(6.0, 8.0), std::pair(6.0, 6.0)}) {
    const auto [roof, scene] = over(w, d, [](Builder& b) { return b.roofHip(options(kSlope45, 0.5, 0.2)); });
    const double t = 0.2 * std::sqrt(2.0);
    CHECK(roof.max.y == Approx(3 + t));
    CHECK(roof.min.y == Approx(-0.5));
    CHECK(roof.slopes.size() == 4);
    CHECK(roof.eaves.size() == 4);
    CHECK(roof.ridges.size() == (w == d ? 4U : 5U));
    if (w != d) CHECK(roof.ridges[0].length() == Approx(2));
    CHECK(test::volumeOf(scene.meshes[0]) == Approx((w + 1) * (d + 1) * t).epsilon(1e-5));
    CHECK(roof.heightAt(1, d / 2) == Approx(1 + t));
    CHECK(roof.heightAt(w / 2, d - 1) == Approx(1 + t));
    CHECK(roof.heightAt(w / 2, d / 2) == Approx(3 + t));
    for (const Segment& eave : roof.eaves) {
      CHECK(eave.start.y == Approx(t - 0.5));
      // Counter-clockwise seen from above: the middle of the house is to the left.
      const Vec3 inwards = glm::cross(Vec3(0, 1, 0), eave.end - eave.start);
      CHECK(glm::dot(Vec3(w / 2, 0, d / 2) - eave.start, inwards) > 0);
    }
  }
}

TEST_CASE("hips end where they should over a deep house") {
  const auto [roof, scene] = over(6, 8, [](Builder& b) { return b.roofHip(options(kSlope45, 0, 0.1)); });
  for (std::size_t i = 1; i < roof.ridges.size(); ++i) {
    const Vec3 run = roof.ridges[i].end - roof.ridges[i].start;
    CHECK(std::abs(run.x) == Approx(3));  // along the diagonal, up to the ridge
    CHECK(std::abs(run.z) == Approx(3));
    CHECK(run.y == Approx(3));
  }
}

TEST_CASE("a shed rises from front to back, with an overhang of its own at the top") {
  RoofOptions o = options(std::atan(0.5), 0.4, 0.2);
  o.topOverhangM = 0.1;
  const auto [roof, scene] = over(8, 6, [&](Builder& b) { return b.roofShed(o); });
  const double t = 0.2 * std::sqrt(1.25);
  CHECK(glm::length(roof.min - Vec3(-0.4, -0.2, -0.1)) < 1e-12);
  CHECK(roof.max.y == Approx(3 + 0.05 + t));
  CHECK(roof.max.z == Approx(6.4));
  CHECK(roof.heightAt(0, 6) == Approx(t));
  CHECK(roof.heightAt(0, 0) == Approx(3 + t));
  CHECK(test::volumeOf(scene.meshes[0]) == Approx(8.8 * 6.5 * t).epsilon(1e-5));
}

TEST_CASE("a flat roof is a tray") {
  FlatRoofOptions o;
  o.overhangM = 0.5;
  o.thicknessM = 0.3;
  o.parapetHeightM = 0.4;
  o.parapetWidthM = 0.25;
  const auto [roof, scene] = over(8, 6, [&](Builder& b) { return b.roofFlat(o); });
  CHECK(roof.min == Vec3(-0.5, 0, -0.5));
  CHECK(roof.max.y == Approx(0.7));
  CHECK(roof.heightAt(4, 3) == Approx(0.3));
  CHECK(test::volumeOf(scene.meshes[0]) == Approx(9 * 7 * 0.7 - 8.5 * 6.5 * 0.4).epsilon(1e-5));
  o.parapetHeightM = 0;
  CHECK(test::volumeOf(over(8, 6, [&](Builder& b) { return b.roofFlat(o); }).scene.meshes[0]) ==
        Approx(9 * 7 * 0.3).epsilon(1e-5));
}

TEST_CASE("a roof's edge and underside have materials of their own") {
  Builder b;
  b.scale({8, 0, 6});
  RoofOptions o = options(0.5, 0.5, 0.2);
  Material red, white, wood;
  red.color = {1, 0, 0};
  white.color = {1, 1, 1};
  wood.color = {0.5F, 0.3F, 0.1F};
  b.material(red);
  o.edge = b.addMaterial(white);
  o.underside = b.addMaterial(wood);
  b.roofHip(o);
  const Scene scene = b.finish();
  const Mesh& mesh = scene.meshes[0];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const float up = mesh.normals[i][0].y;
    const glm::vec3 expected = up > 0.1F ? red.color : up < -0.1F ? wood.color : white.color;
    CHECK(scene.materials[mesh.materials[i]].color == expected);
  }
}

TEST_CASE("a slope is a scope that lies in its face: x along the eave, y up, z outwards") {
  Builder b;
  b.translate({5, 1, -2});
  b.scale({8, 0, 6});
  const Roof roof = b.roofHip(options(kSlope45, 0.5, 0.2));
  int count = 0;
  b.slopes(roof, [&](int i) {
    const Obb& s = b.scope();
    const std::vector<Vec3>& ring = roof.slopes[static_cast<std::size_t>(i)];
    CHECK(s.axes[0].y == Approx(0).margin(1e-12));
    CHECK(s.axes[1].y == Approx(std::sqrt(0.5)));
    CHECK(s.axes[2].y == Approx(std::sqrt(0.5)));
    CHECK(s.size.x == Approx(glm::length(ring[1] - ring[0])));
    CHECK(s.size.y == Approx(3.5 * std::sqrt(2.0)));  // half of 7, up a slope of 45 degrees
    CHECK(glm::length(s.origin - (ring[0] + Vec3(5, 1, -2))) < 1e-9);
    ++count;
  });
  CHECK(count == 4);
}

}  // namespace
}  // namespace dimline
