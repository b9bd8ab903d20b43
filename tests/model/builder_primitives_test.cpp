#include <numbers>

#include <catch2/catch.hpp>

#include "model/builder.h"
#include "support/mesh_checks.h"
#include "support/random.h"

namespace dimline {
namespace {

constexpr double kPi = std::numbers::pi;

/// Area of a regular polygon with that many sides, for the unit circle around it.
double polygonArea(int sides) { return 0.5 * sides * std::sin(2 * kPi / sides); }

/// What `draw` puts into a scope of that size, checked to be closed solids; in a frame that is turned and moved,
/// since that must not matter.
template <typename Draw>
Mesh drawn(const Vec3& size, Draw&& draw) {
  Builder b;
  b.translate({3, -1, 2});
  b.rotate(Axis::kX, 0.4);
  b.rotate(Axis::kY, 1.1);
  b.scale(size);
  draw(b);
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  return scene.meshes.empty() ? Mesh() : scene.meshes[0];
}

/// Greatest angle between a corner's normal and what `expected` says of its position (both in the scope), over a mesh
/// drawn at the origin.
template <typename Expected>
double worstNormalRad(const Mesh& mesh, Expected&& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p(mesh.positions[mesh.triangles[i][k]]);
      worst = std::max(worst, std::acos(std::min(1.0, glm::dot(Vec3(mesh.normals[i][k]), expected(p)))));
    }
  }
  return worst;
}

TEST_CASE("a box fills its scope") {
  const Mesh mesh = drawn({2, 3, 4}, [](Builder& b) { b.box(); });
  CHECK(mesh.positions.size() == 8);
  CHECK(mesh.triangles.size() == 12);
  CHECK(test::volumeOf(mesh) == Approx(24).epsilon(1e-5));
  CHECK(test::areaOf(mesh) == Approx(52).epsilon(1e-5));
}

TEST_CASE("a box with a corner of its own") {
  Builder b;
  b.scale({9, 9, 9});
  b.box({1, 2, 3}, {1, 1, 2});
  CHECK(b.size() == Vec3(9, 9, 9));
  const Scene scene = b.finish();
  CHECK(scene.bounds.min == Vec3(1, 2, 3));
  CHECK(scene.bounds.max == Vec3(2, 3, 5));
}

TEST_CASE("a face's uv are metres: horizontal to the right, then up the slope") {
  Builder b;
  b.scale({2, 3, 4});
  b.box();
  const Scene scene = b.finish();
  const Mesh& mesh = scene.meshes[0];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 p = mesh.positions[mesh.triangles[i][k]], n = mesh.normals[i][k];
      const glm::vec2 uv = mesh.uvs[i][k];
      if (n.z > 0.5F) CHECK(uv == glm::vec2(p.x, p.y));
      if (n.x > 0.5F) CHECK(uv == glm::vec2(-p.z, p.y));
      if (n.y > 0.5F) CHECK(uv == glm::vec2(p.x, -p.z));
    }
  }
  const PlaneAxes slope = planeAxes(glm::normalize(Vec3(0, 1, 1)));
  CHECK(slope.u == Vec3(1, 0, 0));
  CHECK(glm::length(slope.v - glm::normalize(Vec3(0, 1, -1))) < 1e-12);
}

TEST_CASE("cylinder, cone, frustum and sphere have the volume of their facets") {
  const RoundOptions options{16, 0.7};
  const double area = polygonArea(16) * 1.5 * 0.5;  // over an ellipse of 3 by 1
  CHECK(test::volumeOf(drawn({3, 2, 1}, [&](Builder& b) { b.cylinder(options); })) == Approx(area * 2).epsilon(1e-5));
  CHECK(test::volumeOf(drawn({3, 2, 1}, [&](Builder& b) { b.cone(0, options); })) ==
        Approx(area * 2 / 3).epsilon(1e-5));
  // A frustum of half the radius: 1 + 1/2 + 1/4 thirds.
  CHECK(test::volumeOf(drawn({3, 2, 1}, [&](Builder& b) { b.cone(0.5, options); })) ==
        Approx(area * 2 * 1.75 / 3).epsilon(1e-5));

  // A sphere of 16 segments and 8 rings is a stack of frusta.
  double expected = 0;
  for (int i = 0; i < 8; ++i) {
    const double r = std::sin(kPi * i / 8), s = std::sin(kPi * (i + 1) / 8),
                 h = std::cos(kPi * i / 8) - std::cos(kPi * (i + 1) / 8);
    expected += polygonArea(16) * h / 3 * (r * r + r * s + s * s);
  }
  CHECK(test::volumeOf(drawn({2, 2, 2}, [&](Builder& b) { b.sphere(options); })) == Approx(expected).epsilon(1e-5));
  CHECK(test::volumeOf(drawn({6, 2, 4}, [&](Builder& b) { b.sphere(options); })) == Approx(expected * 6).epsilon(1e-5));
}

TEST_CASE("round bodies have the normals of what they stand for") {
  Builder b;
  b.scale({4, 6, 2});
  b.sphere({64, 0.7});
  const Scene ellipsoid = b.finish();
  // Gradient of (x/2)^2 + (y/3)^2 + (z/1)^2 about the middle. Poles are flat-topped by their ring.
  CHECK(worstNormalRad(ellipsoid.meshes[0], [](const Vec3& p) {
          const Vec3 q = p - Vec3(2, 3, 1);
          return glm::normalize(Vec3(q.x / 4, q.y / 9, q.z));
        }) < 0.02);

  b.scale({2, 3, 2});
  b.cylinder({32, 0.7});
  const Mesh cylinder = b.finish().meshes[0];
  CHECK(worstNormalRad(cylinder, [&](const Vec3& p) {
          return std::abs(p.x - 1) + std::abs(p.z - 1) < 1e-6 ? Vec3(0, p.y > 1 ? 1 : -1, 0)
                                                              : glm::normalize(Vec3(p.x - 1, 0, p.z - 1));
        }) < kPi / 2 + 0.01);  // discs and mantle meet at a hard edge
  std::size_t level = 0, upright = 0;
  for (const auto& corners : cylinder.normals) {
    for (const glm::vec3& n : corners)
      (std::abs(n.y) > 0.999F ? upright : level) += std::abs(n.y) > 0.999F || std::abs(n.y) < 1e-6F;
  }
  CHECK(upright == 2 * 32 * 3);
  CHECK(level == 2 * 32 * 3);
}

TEST_CASE("a lathe turns any profile, whichever way it runs") {
  // A bowl: outside radius 2, 1 high, hollowed to a cone of radius 1.5 and depth 0.8.
  std::vector<Vec2> bowl{{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {0, 0.2}};
  const double expected = polygonArea(24) * (4 * 1 - 1.5 * 1.5 * 0.8 / 3);
  CHECK(test::volumeOf(drawn({4, 1, 4}, [&](Builder& b) { b.lathe(bowl); })) == Approx(expected).epsilon(1e-5));
  std::reverse(bowl.begin(), bowl.end());
  CHECK(test::volumeOf(drawn({4, 1, 4}, [&](Builder& b) { b.lathe(bowl); })) == Approx(expected).epsilon(1e-5));

  // Ends off the axis are closed, points that repeat are left out; about the middle of the floor.
  Builder b;
  b.scale({10, 0, 6});
  b.lathe(std::vector<Vec2>{{1, 1}, {1, 1}, {2, 3}}, {40, 0.7});
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  CHECK(test::volumeOf(scene.meshes[0]) == Approx(polygonArea(40) * 2.0 / 3 * (1 + 2 + 4)).epsilon(1e-5));
  CHECK(scene.bounds.center() == Vec3(5, 2, 3));
}

TEST_CASE("a polygon is extruded across the scope, the same along every axis") {
  const Polygon wall{rectangleRing({0, 0}, {6, 3}), {rectangleRing({1, 1}, {2, 2}), rectangleRing({3, 0.5}, {5, 2.5})}};
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const Mesh mesh = drawn({0.3, 0.3, 0.3}, [&](Builder& b) { b.extrudePolygon(wall, axis); });
    CHECK(test::volumeOf(mesh) == Approx((18 - 1 - 4) * 0.3).epsilon(1e-5));
    CHECK(test::areaOf(mesh) == Approx(2 * 13 + (18 + 4 + 8) * 0.3).epsilon(1e-5));
  }
}

TEST_CASE("an extruded polygon's coordinates are (x, y), (z, y) and (x, z)") {
  const Ring outline{{1, 2}, {4, 2}, {4, 3}, {1, 3}};
  const auto bounds = [&](Axis axis) {
    Builder b;
    b.scale({7, 7, 7});
    b.extrudePolygon(outline, axis);
    return b.finish().bounds;
  };
  CHECK(bounds(Axis::kZ).min == Vec3(1, 2, 0));
  CHECK(bounds(Axis::kZ).max == Vec3(4, 3, 7));
  CHECK(bounds(Axis::kX).min == Vec3(0, 2, 1));
  CHECK(bounds(Axis::kX).max == Vec3(7, 3, 4));
  CHECK(bounds(Axis::kY).min == Vec3(1, 0, 2));
  CHECK(bounds(Axis::kY).max == Vec3(4, 7, 3));
}

TEST_CASE("a curved outline is shaded as a curve below its crease") {
  Builder b;
  b.scale({2, 2, 1});
  b.extrudePolygon(ellipseRing({1, 1}, {1, 1}, 32), Axis::kZ, 0.5);
  const Mesh mesh = b.finish().meshes[0];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p(mesh.positions[mesh.triangles[i][k]]), n(mesh.normals[i][k]);
      if (std::abs(n.z) < 0.5) CHECK(glm::dot(n, glm::normalize(Vec3(p.x - 1, p.y - 1, 0))) > 0.9999);
    }
  }
}

TEST_CASE("a sweep is mitred at its bends") {
  // A square section of 0.2 round the corner: both legs end in the plane that halves the angle, so the volume is
  // section times the length of the path through its middle.
  const Ring square = rectangleRing({-0.1, -0.1}, {0.1, 0.1});
  const Mesh corner =
      drawn({1, 1, 1}, [&](Builder& b) { b.sweep(square, std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {3, 0, -2}}); });
  CHECK(test::volumeOf(corner) == Approx(0.04 * 5).epsilon(1e-5));
  CHECK(corner.positions.size() == 12);

  // Down a wall with a bend at either end, and through the vertical.
  const std::vector<Vec3> way{{0, 4, 0.5}, {0, 3.6, 0.2}, {0, 0.6, 0.2}, {0, 0.2, 0.5}};
  const Mesh pipe = drawn({1, 1, 1}, [&](Builder& b) { b.sweep(ellipseRing({0, 0}, {0.05, 0.05}, 8), way); });
  CHECK(test::volumeOf(pipe) == Approx(polygonArea(8) * 0.0025 * (0.5 + 3 + 0.5)).epsilon(1e-4));
}

TEST_CASE("a closed sweep is a ring without ends") {
  Builder::SweepOptions options;
  options.closed = true;
  const std::vector<Vec3> path{{0, 0, 0}, {4, 0, 0}, {4, 0, -3}, {0, 0, -3}};
  const Mesh mesh = drawn({1, 1, 1}, [&](Builder& b) { b.sweep(rectangleRing({-0.1, 0}, {0.1, 0.3}), path, options); });
  CHECK(mesh.positions.size() == 16);
  CHECK(test::volumeOf(mesh) == Approx(14 * 0.06).epsilon(1e-5));
}

TEST_CASE("a sweep's section has its first axis to the right of the way and its second along up") {
  Builder b;
  b.sweep(rectangleRing({1, 2}, {3, 5}), std::vector<Vec3>{{0, 0, 0}, {0, 0, -7}});  // seen along -z, right is +x
  const Bounds bounds = b.finish().bounds;
  CHECK(glm::length(bounds.min - Vec3(1, 2, -7)) < 1e-6);
  CHECK(glm::length(bounds.max - Vec3(3, 5, 0)) < 1e-6);
}

TEST_CASE("a sweep can taper, and its sides' normals lean with it") {
  Builder::SweepOptions options;
  const double widths[] = {1, 1, 0.5};
  options.widths = widths;
  // A point of the path that repeats is left out together with its width.
  const std::vector<Vec3> path{{0, 0, 0}, {0, 0, 0}, {0, 0, -1}};
  Builder b;
  b.sweep(rectangleRing({-0.5, -0.5}, {0.5, 0.5}), path, options);
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  const Mesh& mesh = scene.meshes.at(0);
  CHECK(test::volumeOf(mesh) == Approx((1 + 0.25 + 0.5) / 3).epsilon(1e-6));  // a frustum: (A + B + sqrt(AB)) h / 3
  std::size_t right = 0;
  for (const auto& corners : mesh.normals) {
    for (const glm::vec3& n : corners) {
      if (n.x < 0.5F) continue;
      ++right;
      // The side comes in by 0.25 m over 1 m.
      CHECK(glm::length(Vec3(n) - glm::normalize(Vec3(1, 0, -0.25))) < 1e-6);
    }
  }
  CHECK(right == 6);
}

TEST_CASE("a sweep is shaded as one curve where it bends by less than asked for") {
  const std::vector<Vec3> path{{0, 0, 0}, {1, 0, 0}, {2, 0.2, 0}, {2, 2, 0}};  // 11 degrees, then 79
  const auto normalsAt = [&](double bendRad, const Vec3& place) {
    Builder::SweepOptions options;
    options.up = {0, 0, 1};
    options.bendRad = bendRad;
    Builder b;
    b.sweep(rectangleRing({-0.1, -0.1}, {0.1, 0.1}), path, options);
    const Mesh mesh = b.finish().meshes.at(0);
    std::vector<Vec3> found;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 n(mesh.normals[i][k]);
        // The side that faces down and to the right, in the plane of the path.
        if (glm::length(Vec3(mesh.positions[mesh.triangles[i][k]]) - place) > 0.2 || std::abs(n.z) > 0.5 || n.y > n.x) continue;
        const bool known = std::any_of(found.begin(), found.end(), [&](const Vec3& f) { return glm::length(f - n) < 1e-5; });
        if (!known) found.push_back(n);
      }
    }
    return found;
  };
  CHECK(normalsAt(0, path[1]).size() == 2);
  CHECK(normalsAt(0.5, path[2]).size() == 2);
  const std::vector<Vec3> shared = normalsAt(0.5, path[1]);
  REQUIRE(shared.size() == 1);
  const Vec3 turned = glm::normalize(Vec3(0.2, -1, 0));  // at right angles to the second segment
  CHECK(glm::length(shared[0] - glm::normalize(Vec3(0, -1, 0) + turned)) < 1e-5);
}

TEST_CASE("a solid made by hand welds its points") {
  const Vec3 a(0, 0, 0), c(1, 0, 0), d(0, 1, 0), e(0, 0, 1);
  const Mesh mesh = drawn({1, 1, 1}, [&](Builder& b) {
    b.solid([&](Builder::Solid& s) {
      s.face({a, d, c});
      s.face({a, c, e});
      s.face({a, e, d});
      s.face({c, d, e, e + Vec3(1e-8, 0, 0)});  // the last two corners fall together
    });
  });
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.triangles.size() == 4);
  CHECK(test::volumeOf(mesh) == Approx(1.0 / 6).epsilon(1e-5));
}

TEST_CASE("a surface is drawn as it is given, in the scope's frame") {
  Builder::Surface tetrahedron;
  tetrahedron.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const Vec3& p : tetrahedron.points) tetrahedron.normals.push_back(glm::normalize(p));
  tetrahedron.uvs = {{0, 0}, {1, 2}, {3, 4}, {5, 6}};
  tetrahedron.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  Builder b;
  b.translate({10, 0, 0});
  b.rotate(Axis::kY, kPi / 2);  // the scope's z is the world's x, its x the world's -z
  b.surface(tetrahedron);
  const Scene scene = b.finish();
  CHECK(test::defectOf(scene) == "");
  const Mesh& mesh = scene.meshes.at(0);
  REQUIRE(mesh.positions.size() == 4);
  CHECK(glm::length(Vec3(mesh.positions[3]) - Vec3(11, -1, 1)) < 1e-6);
  CHECK(glm::length(Vec3(mesh.normals[1][2]) - glm::normalize(Vec3(1, -1, 1))) < 1e-6);  // its corner there is point 3
  CHECK(mesh.uvs[0][1] == glm::vec2(1, 2));
  CHECK(test::volumeOf(mesh) == Approx(8.0 / 3).epsilon(1e-5));
}

TEST_CASE("points weld across the borders of the search's cells, and never across parts") {
  Mesh mesh;
  MeshBuilder builder(mesh);
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.point(Vec3(-9), Vec3(9));
    const std::uint32_t first = builder.weld(p);
    CHECK(builder.weld(p + random.direction() * 0.9e-6) == first);
    CHECK(builder.weld(p + random.direction() * 3e-6) != first);
  }
  const std::uint32_t own = builder.weld({20, 0, 0});
  builder.beginPart();
  CHECK(builder.weld({20, 0, 0}) != own);
}

TEST_CASE("what has no extent is nothing") {
  Builder b;
  for (const Vec3 size : {Vec3(0, 1, 1), Vec3(1, 0, 1), Vec3(1, 1, 0)}) {
    b.scale(size);
    b.box();
    b.cylinder();
    b.cone();
    b.sphere();
  }
  b.extrudePolygon(rectangleRing({0, 0}, {1, 1}));  // depth 0
  b.lathe(std::vector<Vec2>{{0, 0}, {0, 1}});
  b.sweep(rectangleRing({0, 0}, {1, 1}), std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}});
  CHECK(b.finish().triangleCount() == 0);
}

TEST_CASE("a rectangle is one face towards z") {
  Builder b;
  b.scale({2, 3, 0});
  b.rectangle();
  const Scene scene = b.finish();
  REQUIRE(scene.triangleCount() == 2);
  CHECK(test::areaOf(scene.meshes[0]) == 6);
  CHECK(scene.meshes[0].normals[0][0] == glm::vec3(0, 0, 1));
}

TEST_CASE("the same calls give the same bytes") {
  const auto make = [] {
    Builder b;
    b.scale({3, 2, 1});
    b.sphere();
    b.extrudePolygon(Polygon{ellipseRing({1, 1}, {1, 1}, 9), {ellipseRing({1, 1}, {0.4, 0.3}, 5)}});
    return b.finish();
  };
  const Scene one = make(), two = make();
  REQUIRE(one.meshes.size() == 1);
  CHECK(one.meshes[0].positions == two.meshes[0].positions);
  CHECK(one.meshes[0].triangles == two.meshes[0].triangles);
  CHECK(one.meshes[0].normals == two.meshes[0].normals);
}

}  // namespace
}  // namespace dimline
