#include <numbers>

#include <catch2/catch.hpp>

#include "model/builder.h"
#include "support/mesh_checks.h"

namespace dimline {
namespace {

constexpr double kPi = std::numbers::pi;

bool near(const Vec3& a, const Vec3& b) { return glm::length(a - b) < 1e-12; }

TEST_CASE("fixed, relative and floating pieces share a length") {
  const auto pieces = splitIntervals(10, std::vector{fixed(1), floating(1), relative(0.2), floating(3)});
  REQUIRE(pieces.size() == 4);  // 1 + 2 are taken; 7 are left, in the proportion 1 : 3
  CHECK(pieces[0].start == 0);
  CHECK(pieces[0].length == 1);
  CHECK(pieces[1].start == 1);
  CHECK(pieces[1].length == 1.75);
  CHECK(pieces[2].start == 2.75);
  CHECK(pieces[2].length == 2);
  CHECK(pieces[3].end() == 10);
}

TEST_CASE("pieces that need too much shrink alike, and floating ones vanish") {
  const auto pieces =
      splitIntervals(6, std::vector{fixed(6), floating(1), relative(0.5), fixed(3)});  // 12 wanted, 6 there
  CHECK(pieces[0].length == 3);
  CHECK(pieces[1].length == 0);
  CHECK(pieces[2].length == 1.5);
  CHECK(pieces[3].length == 1.5);
  CHECK(pieces[3].end() == 6);
}

TEST_CASE("without a floating piece the rest stays empty") {
  const auto pieces = splitIntervals(6, std::vector{fixed(1), fixed(2)});
  CHECK(pieces[1].end() == 3);
  CHECK(splitIntervals(6, std::vector{fixed(-1), floating(0)})[1].end() == 0);
}

TEST_CASE("a repeat rounds") {
  CHECK(repeatCount(10, 3) == 3);
  CHECK(repeatCount(10.5, 3) == 4);
  CHECK(repeatCount(1, 3) == 1);
  CHECK(repeatCount(0, 3) == 1);
}

TEST_CASE("split and repeat run their body in each piece's scope and put the scope back") {
  Builder b;
  b.translate({1, 0, 0});
  b.scale({10, 2, 3});
  const Obb before = b.scope();
  std::vector<std::pair<int, double>> seen;
  b.split(Axis::kX, {fixed(4), fixed(0), floating(1)}, [&](int i) {
    seen.emplace_back(i, b.scope().origin.x);
    CHECK(b.size().y == 2);
    b.translate({100, 100, 100});
  });
  CHECK(seen == std::vector<std::pair<int, double>>{{0, 1.0}, {2, 5.0}});  // the empty piece is left out
  CHECK(b.scope().origin == before.origin);
  CHECK(b.size() == before.size);

  int count = 0;
  b.repeat(Axis::kZ, 1.4, [&](int i, int n) {
    CHECK(n == 2);
    CHECK(b.scope().origin.z == 1.5 * i);
    CHECK(b.size() == Vec3(10, 2, 1.5));
    ++count;
  });
  CHECK(count == 2);
}

TEST_CASE("the scope moves along its own axes and turns about its pivot") {
  Builder b;
  b.scale({4, 2, 6});
  b.rotate(Axis::kY, kPi / 2);  // x to -z, z to x
  CHECK(near(b.scope().axes[0], {0, 0, -1}));
  CHECK(near(b.scope().axes[2], {1, 0, 0}));
  b.translate({1, 0, 0});
  CHECK(near(b.scope().origin, {0, 0, -1}));

  Builder c;
  c.scale({4, 2, 6});
  c.rotate(Axis::kY, kPi / 2, {0.5, 0, 0.5});
  CHECK(near(c.scope().at({0.5, 0, 0.5}), {2, 0, 3}));
  CHECK(near(c.scope().origin, {-1, 0, 5}));  // the corner (-2, -3) from the middle turns to (-3, 2)
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    CHECK(near(glm::cross(c.scope().axes[k], c.scope().axes[(k + 1) % 3]), c.scope().axes[(k + 2) % 3]));
  }
}

TEST_CASE("scale sets the size, alone or about the middle of the floor") {
  Builder b;
  b.scale({4, 2, 6});
  b.push([&] {
    b.scaleCentered({1, 5, 2});
    CHECK(b.size() == Vec3(1, 5, 2));
    CHECK(b.scope().origin == Vec3(1.5, 0, 2));
  });
  b.scale(Axis::kY, -1);
  CHECK(b.size() == Vec3(4, 0, 6));
}

TEST_CASE("each face of a box is a scope that sees it from outside") {
  Builder b;
  b.translate({1, 2, 3});
  b.scale({4, 5, 6});
  const Vec3 middle = b.scope().center();
  const std::array<Vec3, 6> outward{Vec3{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const std::array<Vec3, 6> sizes{Vec3{4, 5, 0}, {6, 5, 0}, {4, 5, 0}, {6, 5, 0}, {4, 6, 0}, {4, 6, 0}};
  std::size_t i = 0;
  b.faces(kAllFaces, [&](Face) {
    const Obb& s = b.scope();
    CHECK(s.axes[2] == outward[i]);
    CHECK(near(glm::cross(s.axes[0], s.axes[1]), s.axes[2]));
    CHECK(s.size == sizes[i]);
    CHECK(glm::dot(s.center() - middle, s.axes[2]) > 0);
    // The face's middle lies straight outwards of the box's middle: the face is in the right place, not just the
    // right plane.
    CHECK(glm::length(glm::cross(s.center() - middle, s.axes[2])) < 1e-12);
    if (i < 4) CHECK(s.axes[1] == Vec3(0, 1, 0));
    ++i;
  });
  CHECK(i == 6);
  CHECK(b.size() == Vec3(4, 5, 6));
}

TEST_CASE("a face's scope is extruded outwards or inwards, and offset") {
  Builder b;
  b.scale({4, 5, 6});
  b.face(Face::kFront, [&] {
    b.offset(-1);
    CHECK(b.scope().origin == Vec3(1, 1, 6));
    CHECK(b.size() == Vec3(2, 3, 0));
    b.push([&] {
      b.extrude(0.5);
      CHECK(b.scope().origin == Vec3(1, 1, 6));
      CHECK(b.size().z == 0.5);
    });
    b.extrude(-0.5);
    CHECK(b.scope().origin == Vec3(1, 1, 5.5));
    CHECK(b.scope().axes[2] == Vec3(0, 0, 1));
    b.offset(-7);
    CHECK(b.size() == Vec3(0, 0, 0.5));
    CHECK(b.scope().origin == Vec3(2, 2.5, 5.5));  // the middle stays
  });
}

TEST_CASE("a named scope is recorded with its box, in order and counted by name") {
  Builder b;
  b.scale({6, 2, 1});
  b.repeat(Axis::kX, 2, [&](int, int) { b.name("Bay"); });
  b.name("Wall");
  const Scene scene = b.finish();
  REQUIRE(scene.scopes.size() == 4);
  CHECK(scene.scopes[2].name == "Bay");
  CHECK(scene.scopes[2].index == 2);
  CHECK(scene.scopes[2].box.origin == Vec3(4, 0, 0));
  CHECK(scene.scopes[2].box.size == Vec3(2, 2, 1));
  CHECK(scene.scopes[3].index == 0);
}

TEST_CASE("equal materials are one, and a lambda's material ends with it") {
  Builder b;
  b.scale({1, 1, 1});
  Material red;
  red.color = {1, 0, 0};
  b.material(red);
  b.push([&] {
    b.color({0, 1, 0});
    b.box();
  });
  b.box();
  b.push([&] {
    b.color({0, 1, 0});
    b.box();
  });
  const Scene scene = b.finish();
  REQUIRE(scene.materials.size() == 3);  // the default one, red, green
  const Mesh& mesh = scene.meshes[0];
  CHECK(scene.materials[mesh.materials[0]].color == glm::vec3(0, 1, 0));
  CHECK(scene.materials[mesh.materials[12]].color == glm::vec3(1, 0, 0));
  CHECK(mesh.materials[24] == mesh.materials[0]);
}

TEST_CASE("an sRGB colour becomes linear light") {
  CHECK(linearFromSrgb(0xFFFFFF).x == Approx(1.0));
  CHECK(linearFromSrgb(0x000000).y == 0.0F);
  const glm::vec3 c = linearFromSrgb(0xBC0A00);
  CHECK(c.x == Approx(0.5029).margin(1e-4));  // 188/255, the usual "half"
  CHECK(c.y == Approx(10.0 / 255 / 12.92));   // in the linear toe
}

TEST_CASE("a part is made once and placed many times, with its scopes") {
  Builder b;
  const PartId knob = b.part({1, 1, 1}, [&] { b.sphere({8, 0.7}); });
  const PartId post = b.part({1, 2, 1}, [&] {
    b.box();
    b.name("Post");
    b.translate({0, 2, 0});
    b.place(knob);
  });
  b.translate({10, 0, 0});
  b.rotate(Axis::kY, kPi / 2);
  b.place(post);
  b.translate({5, 0, 0});
  b.place(post);
  const Scene scene = b.finish();

  CHECK(scene.meshes.size() == 2);
  REQUIRE(scene.instances.size() == 4);
  CHECK(scene.triangleCount() == 2 * (12 + scene.meshes[0].triangles.size()));
  REQUIRE(scene.scopes.size() == 2);
  CHECK(near(scene.scopes[1].box.origin, {10, 0, -5}));  // 5 along the turned x, which is -z
  CHECK(near(scene.scopes[1].box.axes[0], {0, 0, -1}));
  CHECK(scene.scopes[1].index == 1);
  // The turned unit box reaches from its origin to +x and -z.
  CHECK(glm::length(scene.bounds.min - Vec3(10, 0, -6)) < 1e-5);
  CHECK(glm::length(scene.bounds.max - Vec3(11, 3, 0)) < 1e-5);
  CHECK(test::defectOf(scene) == "");
}

TEST_CASE("a part that is never placed shows nothing") {
  Builder b;
  (void)b.part({1, 1, 1}, [&] {
    b.name("Hidden");
    b.box();
  });
  const Scene scene = b.finish();
  CHECK(scene.instances.empty());
  CHECK(scene.scopes.empty());
  CHECK(scene.bounds.empty());
}

}  // namespace
}  // namespace dimline
