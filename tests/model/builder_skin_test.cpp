#include <numbers>

#include <catch2/catch.hpp>

#include "model/builder.h"
#include "support/mesh_checks.h"

namespace dimline {
namespace {

constexpr double kPi = std::numbers::pi;

using Rows = std::vector<std::vector<Vec3>>;

/// What `draw` puts into the scope, checked to be closed solids; in a frame that is turned and moved, since that must not
/// matter.
template <typename Draw>
Mesh drawn(Draw&& draw) {
  Builder b;
  b.translate({3, -1, 2});
  b.rotate(Axis::kX, 0.4);
  b.rotate(Axis::kY, 1.1);
  draw(b);
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  return scene.meshes.empty() ? Mesh() : scene.meshes[0];
}

/// The same in the world's frame.
template <typename Draw>
Mesh drawnAtOrigin(Draw&& draw) {
  Builder b;
  draw(b);
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  REQUIRE(scene.meshes.size() == 1);
  return scene.meshes[0];
}

std::vector<Vec3> squareRib(double x, double half) {
  return {{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}};
}

std::vector<Vec3> roundRib(double x, double radius, int sides) {
  std::vector<Vec3> rib;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    rib.emplace_back(x, radius * std::cos(angle), radius * std::sin(angle));
  }
  return rib;
}

TEST_CASE("a skin over two square ribs is the frustum between them, whichever way they run") {
  // Squares of 2 and 4 a side, 3 apart: 3 / 3 * (4 + 16 + 8).
  Rows ribs{squareRib(0, 1), squareRib(3, 2)};
  for (int turn = 0; turn < 2; ++turn) {
    const Mesh mesh = drawn([&](Builder& b) { b.loft(ribs); });
    CHECK(mesh.positions.size() == 8);
    CHECK(mesh.triangles.size() == 12);
    CHECK(test::volumeOf(mesh) == Approx(28).epsilon(1e-5));
    for (auto& rib : ribs) std::reverse(rib.begin(), rib.end());
  }
  std::reverse(ribs.begin(), ribs.end());
  CHECK(test::volumeOf(drawn([&](Builder& b) { b.loft(ribs); })) == Approx(28).epsilon(1e-5));
}

TEST_CASE("ribs may end in a point or in a line") {
  const Mesh pyramid = drawn([&](Builder& b) { b.loft(Rows{squareRib(0, 1), squareRib(3, 0)}); });
  CHECK(pyramid.positions.size() == 5);
  CHECK(pyramid.triangles.size() == 6);
  CHECK(test::volumeOf(pyramid) == Approx(4).epsilon(1e-5));
  // A wedge: the far rib is an upright line, run up and down again.
  const Rows wedge{squareRib(0, 1), {{3, -1, 0}, {3, 1, 0}, {3, 1, 0}, {3, -1, 0}}};
  const Mesh mesh = drawn([&](Builder& b) { b.loft(wedge); });
  CHECK(mesh.positions.size() == 6);
  CHECK(test::volumeOf(mesh) == Approx(6).epsilon(1e-5));
}

TEST_CASE("a rib that is folded together over a stretch is closed where it is open") {
  // A triangle that stands on a post without thickness, and the same 2 further on with a foot of 1: a fin that opens.
  const Rows ribs{{{0, 0, 0}, {0, 1, 0}, {0, 2, 1}, {0, 2, -1}, {0, 1, 0}},
                  {{2, 0, 0}, {2, 1, 0.5}, {2, 2, 1}, {2, 2, -1}, {2, 1, -0.5}}};
  const Mesh mesh = drawn([&](Builder& b) { b.loft(ribs); });
  CHECK(mesh.positions.size() == 9);
  CHECK(test::volumeOf(mesh) > 2.0);
  CHECK(test::volumeOf(mesh) < 4.0);
}

TEST_CASE("a skin is shaded as a curve along and around, and hard at its caps") {
  const int sides = 32;
  Rows ribs;
  for (int i = 0; i <= 20; ++i) {
    const double angle = kPi * (0.25 + 0.5 * i / 20);  // a barrel: the middle zone of a sphere of radius 2
    ribs.push_back(roundRib(-2 * std::cos(angle), 2 * std::sin(angle), sides));
  }
  const Mesh mesh = drawnAtOrigin([&](Builder& b) { b.loft(ribs); });
  double worstCos = 1;
  int flat = 0;
  const double end = 2 * std::cos(kPi * 0.25);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = test::corners(mesh, i);
    const Vec3 face = glm::normalize(glm::cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p(mesh.positions[mesh.triangles[i][k]]), n(mesh.normals[i][k]);
      if (std::abs(face.x) > 0.999) {
        CHECK(glm::dot(n, face) > 0.99999);
        ++flat;
      } else if (std::abs(p.x) < end - 0.01) {  // at the rims one side is missing from the mean
        worstCos = std::min(worstCos, glm::dot(n, glm::normalize(p)));
      }
    }
  }
  CHECK(flat == 2 * 3 * (sides - 2));
  CHECK(std::acos(worstCos) < 0.004);
}

TEST_CASE("each strip of a skin may have its own material") {
  Builder b;
  b.color({1, 0, 0});
  const MaterialId red = b.material();
  b.color({0, 1, 0});
  const MaterialId green = b.material();
  b.color({0, 0, 1});
  const MaterialId materials[] = {red, green};
  Builder::SkinOptions options;
  options.materials = materials;
  b.loft(Rows{squareRib(0, 1), squareRib(3, 1)}, options);
  const Scene scene = b.finish();
  REQUIRE(scene.meshes.size() == 1);
  const auto count = [&](MaterialId id) {
    return std::count(scene.meshes[0].materials.begin(), scene.meshes[0].materials.end(), id);
  };
  CHECK(count(red) == 2);
  CHECK(count(green) == 2);
  CHECK(count(b.material()) == 0);
  CHECK(scene.meshes[0].materials.size() == 12);  // the rest in the current one
}

TEST_CASE("a skin's uv follow the ribs' points and are metres where the skin is longest") {
  const Mesh mesh = drawnAtOrigin([&](Builder& b) { b.loft(Rows{squareRib(0, 1), squareRib(3, 2)}); });
  float greatestU = 0, greatestV = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = test::corners(mesh, i);
    if (std::abs(glm::normalize(glm::cross(b - a, c - a)).x) > 0.999) continue;
    for (const glm::vec2& uv : mesh.uvs[i]) {
      greatestU = std::max(greatestU, uv.x);
      greatestV = std::max(greatestV, uv.y);
    }
  }
  CHECK(greatestU == Approx(16));                    // around the larger rib
  CHECK(greatestV == Approx(std::sqrt(9 + 1 + 1)));  // along a slanting edge
}

TEST_CASE("a sheet has its thickness behind the face that its rows show") {
  // Two metres by one in the plane z = 0, rows to the right and upwards: seen from +z.
  const Rows rows{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}}};
  const Mesh mesh = drawnAtOrigin([&](Builder& b) { b.sheet(rows, 0.25); });
  CHECK(mesh.positions.size() == 12);
  CHECK(mesh.triangles.size() == 2 * 4 + 2 * 6);
  CHECK(test::volumeOf(mesh) == Approx(0.5).epsilon(1e-5));
  Bounds bounds;
  for (const glm::vec3& p : mesh.positions) bounds.add(Vec3(p));
  CHECK(glm::length(bounds.min - Vec3(0, 0, -0.25)) < 1e-6);
  CHECK(glm::length(bounds.max - Vec3(2, 1, 0)) < 1e-6);
}

TEST_CASE("a bent sheet is shaded as a curve on both sides") {
  Rows rows;
  for (int i = 0; i <= 24; ++i) {
    const double angle = 0.5 * kPi * i / 24;  // a quarter of a cylinder about x, its front outwards
    std::vector<Vec3>& row = rows.emplace_back();
    for (int j = 0; j <= 4; ++j) row.emplace_back(j, 2 * std::sin(angle), 2 * std::cos(angle));
  }
  const Mesh mesh = drawnAtOrigin([&](Builder& b) { b.sheet(rows, 0.1); });
  CHECK(test::volumeOf(mesh) == Approx(kPi / 4 * (4 - 1.9 * 1.9) * 4).epsilon(0.003));
  double worstCos = 1;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = test::corners(mesh, i);
    const Vec3 face = glm::normalize(glm::cross(b - a, c - a)), middle = (a + b + c) / 3.0;
    const Vec3 out = glm::normalize(Vec3(0, middle.y, middle.z));
    if (std::abs(glm::dot(face, out)) < 0.9) continue;  // the rim
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p(mesh.positions[mesh.triangles[i][k]]), n(mesh.normals[i][k]);
      const Vec3 radial = glm::normalize(Vec3(0, p.y, p.z));
      const double angle = std::atan2(p.y, p.z);
      if (angle < 0.05 || angle > 0.5 * kPi - 0.05) continue;
      worstCos = std::min(worstCos, glm::dot(n, glm::dot(face, out) > 0 ? radial : -radial));
    }
  }
  CHECK(std::acos(std::min(worstCos, 1.0)) < 0.004);
}

TEST_CASE("a sheet may run together in a point") {
  // A triangle with legs of 3 and 4: each row runs from a point of the one to a point of the other, all of them from the corner.
  Rows rows;
  for (int i = 0; i <= 4; ++i) {
    std::vector<Vec3>& row = rows.emplace_back();
    for (int j = 0; j <= 5; ++j) row.push_back(Vec3(3, 0, 0) * (j / 5.0) + Vec3(-3, 4, 0) * (j / 5.0 * i / 4.0));
  }
  const Mesh mesh = drawn([&](Builder& b) { b.sheet(rows, 0.02); });
  CHECK(test::volumeOf(mesh) == Approx(6 * 0.02).epsilon(1e-4));
}

TEST_CASE("skins over nothing are nothing") {
  Builder b;
  b.loft(Rows{squareRib(0, 1)});
  b.loft(Rows{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}});
  b.sheet(Rows{{{0, 0, 0}, {1, 0, 0}}}, 0.1);
  b.sheet(Rows{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}}, 0);
  CHECK(b.finish().triangleCount() == 0);
}

}  // namespace
}  // namespace dimline
