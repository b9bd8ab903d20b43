#include <catch2/catch.hpp>

#include <cmath>
#include <utility>
#include <vector>

#include "placement/base_lines.h"
#include "placement/slip_planes.h"

using namespace dimline;

namespace {

// A box 4 wide, 3 high and 2 deep, turned a quarter about y: its x axis is the world's -z, its z axis the world's +x.
Obb turnedBox() {
  return {.origin = {10, 0, 5}, .axes = {Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}, .size = {4, 3, 2}};
}

Annotation annotated(HandleType type, Orient orient, Slip slip = Slip::kScope) {
  Annotation a;
  a.scope = "Box";
  a.type = type;
  a.orient = orient;
  a.slip = slip;
  return a;
}

View frontView(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  Bounds bounds;
  bounds.add({-20, -20, -20});
  bounds.add({20, 20, 20});
  return {camera, 1000, 1000, bounds};
}

std::vector<SlipPlane> slipPlanes(const BaseLine& line, Slip slip, const View& view) {
  std::vector<SlipPlane> planes;
  slipPlanes(line, slip, view, {}, planes);
  return planes;
}

View anyView() { return frontView({30, 20, 40}, {0, 0, 0}); }

}  // namespace

TEST_CASE("linear-contour lies on the four edges along its axis") {
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), turnedBox(), anyView());
  REQUIRE(lines.size() == 4);
  for (const BaseLine& line : lines) {
    CHECK(line.segment.end - line.segment.start == Vec3(0, 3, 0));
    CHECK(line.segment.start.y == 0);
  }
  // The other axes are z (world +x) and x (world -z), in that order; bit 0 is the side along the first.
  CHECK(lines[0].segment.start == Vec3(10, 0, 5));
  CHECK(lines[1].segment.start == Vec3(12, 0, 5));
  CHECK(lines[2].segment.start == Vec3(10, 0, 1));
  CHECK(lines[3].segment.start == Vec3(12, 0, 1));
}

TEST_CASE("an edge is turned away when both its faces are, by more than was asked") {
  const Obb box = turnedBox();   // 10 to 12 in x, 0 to 3 in y, 1 to 5 in z
  const BaseLines edges = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), box, anyView());
  const auto turned = [&](const Vec3& eye, double leastSin) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (turnedAway(edges[i], frontView(eye, box.center()), leastSin)) which.push_back(i);
    }
    return which;
  };
  // From the right in front, the edge at the back on the left.
  CHECK(turned({40, 1.5, 40}, 0) == std::vector<std::size_t>{2});
  // From the front, both at the back: their sides turn away by little.
  CHECK(turned({11, 1.5, 1000}, 0) == std::vector<std::size_t>{2, 3});
  CHECK(turned({11, 1.5, 1000}, 0.1).empty());
  // No faces meet in a line through the middle.
  for (const BaseLine& line : baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box, anyView())) {
    CHECK_FALSE(turnedAway(line, frontView({40, 1.5, 40}, box.center()), 0));
  }
}

TEST_CASE("an orientation against the axis turns the line round: its moving end is the other one") {
  const BaseLines up = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), turnedBox(), anyView());
  const BaseLines down = baseLines(annotated(HandleType::kLinearContour, Orient::kDown), turnedBox(), anyView());
  REQUIRE(down.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(down[i].segment.start == up[i].segment.end);
    CHECK(down[i].segment.end == up[i].segment.start);
  }
}

TEST_CASE("each orientation runs along one of the scope's axes, one way or the other") {
  // x is the world's -z and 4 long, y 3, z the world's +x and 2.
  using enum Orient;
  for (const auto& [orient, way] : std::vector<std::pair<Orient, Vec3>>{{kRight, {0, 0, -4}}, {kLeft, {0, 0, 4}}, {kUp, {0, 3, 0}}, {kDown, {0, -3, 0}}, {kFront, {2, 0, 0}}, {kBack, {-2, 0, 0}}}) {
    INFO(static_cast<int>(orient));
    const BaseLines edges = baseLines(annotated(HandleType::kLinearContour, orient), turnedBox(), anyView());
    REQUIRE(edges.size() == 4);
    for (const BaseLine& edge : edges) CHECK(edge.segment.end - edge.segment.start == way);
    const BaseLines middle = baseLines(annotated(HandleType::kLinearCenter, orient), turnedBox(), anyView());
    REQUIRE(middle.size() == 1);
    CHECK(middle[0].segment.end - middle[0].segment.start == way);
    CHECK(middle[0].segment.middle() == Vec3(11, 1.5, 3));
  }
}

TEST_CASE("linear-center is one line through the middle") {
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kRight), turnedBox(), anyView());
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].segment.start == Vec3(11, 1.5, 5));
  CHECK(lines[0].segment.end == Vec3(11, 1.5, 1));
}

TEST_CASE("translate moves base lines in sizes of the scope") {
  Annotation a = annotated(HandleType::kLinearCenter, Orient::kUp);
  a.translate = {0.5, 1.0, 0.0};
  const BaseLines lines = baseLines(a, turnedBox(), anyView());
  CHECK(lines[0].segment.start == Vec3(11, 3, 1));
}

TEST_CASE("parameters are ordered by the mean world length of their base lines") {
  CHECK(meanBaseLengthM(annotated(HandleType::kLinearContour, Orient::kFront), turnedBox()) == Approx(2.0));
  CHECK(meanBaseLengthM(annotated(HandleType::kLinearCenter, Orient::kLeft), turnedBox()) == Approx(4.0));
  CHECK(meanBaseLengthM(annotated(HandleType::kDiametric, Orient::kUp), turnedBox()) == Approx(3.0));
  CHECK(meanBaseLengthM(annotated(HandleType::kRadial, Orient::kUp), turnedBox()) == Approx(1.5));
  CHECK(meanBaseLengthM(annotated(HandleType::kSphericalDiametric, Orient::kHorizontal), turnedBox()) == Approx(2.0));
  CHECK(meanBaseLengthM(annotated(HandleType::kSphericalRadial, Orient::kHorizontal), turnedBox()) == Approx(1.0));
}

TEST_CASE("diametric: a diameter on each face across the axis, at right angles to the view") {
  const Obb box{.origin = {-1, 0, -2}, .size = {2, 3, 4}};
  const View view = frontView({0, 1.5, 50}, {0, 1.5, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kDiametric, Orient::kUp), box, view);
  REQUIRE(lines.size() == 2);
  // The viewer looks along -z, so the diameters lie along x, where the ellipse's half axis is 1.
  for (std::size_t i = 0; i < 2; ++i) {
    const Segment& s = lines[i].segment;
    CHECK(std::abs(s.end.x - s.start.x) == Approx(2.0));
    CHECK(s.start.y == Approx(i == 0 ? 0.0 : 3.0));
    CHECK(s.middle().x == Approx(0.0).margin(1e-12));
    CHECK(s.middle().z == Approx(0.0).margin(1e-12));
    REQUIRE(lines[i].scopePlanes.size() == 2);
    CHECK(lines[i].scopePlanes[0].normal == Vec3(0, i == 0 ? -1 : 1, 0));
    CHECK(lines[i].scopePlanes[1].across == Vec3(0, 1, 0));
  }
}

TEST_CASE("the diameter ends on the ellipse whatever the view") {
  const Obb box{.origin = {-1, 0, -2}, .size = {2, 3, 4}};
  for (double angle = 0; angle < 6.28; angle += 0.37) {
    const View view = frontView({40 * std::sin(angle), 10, 40 * std::cos(angle)}, {0, 1.5, 0});
    for (const BaseLine& line : baseLines(annotated(HandleType::kDiametric, Orient::kUp), box, view)) {
      const Vec3 end = line.segment.end;
      CHECK(end.x * end.x / 1.0 + end.z * end.z / 4.0 == Approx(1.0));
      const Vec3 sight = view.directionTo(line.segment.middle());
      CHECK(glm::dot(line.segment.end - line.segment.start, Vec3(sight.x, 0, sight.z)) == Approx(0.0).margin(1e-9));
    }
  }
}

TEST_CASE("radial: four halves of the diameters, from the centre to the rim") {
  const Obb box{.origin = {-1, 0, -1}, .size = {2, 3, 2}};
  const BaseLines lines = baseLines(annotated(HandleType::kRadial, Orient::kUp), box, frontView({7, 9, 30}, {0, 1.5, 0}));
  REQUIRE(lines.size() == 4);
  for (const BaseLine& line : lines) {
    CHECK(line.segment.start.x == Approx(0.0).margin(1e-12));
    CHECK(line.segment.start.z == Approx(0.0).margin(1e-12));
    CHECK(line.segment.length() == Approx(1.0));
  }
  CHECK(glm::length(lines[0].segment.end + lines[1].segment.end - 2.0 * lines[0].segment.start) < 1e-12);
}

TEST_CASE("diameters and radii of a lying cylinder stand on its two ends") {
  // Along x, seen from above: its ends are discs in y and z of half axes 1.5 and 1, and a diameter at right angles to the view lies along z.
  const Obb box{.origin = {-2, 0, -1}, .size = {4, 3, 2}};
  Camera above;
  above.eye = {0, 50, 0};
  above.target = {0, 1.5, 0};
  above.up = {0, 0, -1};
  const View view(above, 1000, 1000, Bounds{{-2, 0, -1}, {2, 3, 1}});
  const BaseLines diameters = baseLines(annotated(HandleType::kDiametric, Orient::kRight), box, view);
  REQUIRE(diameters.size() == 2);
  const BaseLines radii = baseLines(annotated(HandleType::kRadial, Orient::kRight), box, view);
  REQUIRE(radii.size() == 4);
  for (const double x : {-2.0, 2.0}) {
    const auto onThatEnd = [&](const BaseLines& lines) {
      std::vector<Segment> found;
      for (const BaseLine& line : lines) {
        if (std::abs(line.segment.middle().x - x) < 1e-9) found.push_back(line.segment);
      }
      return found;
    };
    const auto whole = onThatEnd(diameters), halves = onThatEnd(radii);
    REQUIRE(whole.size() == 1);
    CHECK(glm::length(whole[0].middle() - Vec3(x, 1.5, 0)) < 1e-9);
    CHECK(std::abs(whole[0].end.z - whole[0].start.z) > 1.99);
    REQUIRE(halves.size() == 2);
    for (const Segment& half : halves) {
      CHECK(glm::length(half.start - Vec3(x, 1.5, 0)) < 1e-9);
      CHECK(std::abs(std::abs(half.end.z) - 1) < 0.01);
    }
    CHECK(halves[0].end.z * halves[1].end.z < 0);
  }
}

TEST_CASE("the diameters of a sphere upright, and its radii level") {
  const Obb box{.origin = {-1, 0, -2}, .size = {2, 3, 4}};   // inscribed sphere: radius 1 around (0, 1.5, 0)
  const View view = frontView({0, 1.5, 30}, {0, 1.5, 0});
  const BaseLines upright = baseLines(annotated(HandleType::kSphericalDiametric, Orient::kVertical), box, view);
  REQUIRE(upright.size() == 2);
  for (const BaseLine& line : upright) {
    CHECK(glm::length(line.segment.middle() - Vec3(0, 1.5, 0)) < 1e-9);
    CHECK(std::abs(line.segment.end.y - line.segment.start.y) == Approx(2.0));
  }
  const BaseLines level = baseLines(annotated(HandleType::kSphericalRadial, Orient::kHorizontal), box, view);
  REQUIRE(level.size() == 4);
  int toTheRight = 0;
  for (const BaseLine& line : level) {
    CHECK(line.segment.start.y == Approx(line.segment.end.y));
    CHECK(line.segment.length() == Approx(1.0));
    toTheRight += line.segment.middle().x > 0 ? 1 : 0;
  }
  CHECK(toTheRight == 2);
}

TEST_CASE("the spherical types lie on the outline of the inscribed sphere, level or upright on screen") {
  const Obb box{.origin = {-1, 0, -2}, .size = {2, 3, 4}};   // inscribed sphere: radius 1 around (0, 1.5, 0)
  const View view = frontView({9, 12, 30}, {0, 1.5, 0});
  const BaseLines level = baseLines(annotated(HandleType::kSphericalDiametric, Orient::kHorizontal), box, view);
  REQUIRE(level.size() == 2);
  CHECK(level[0].segment.length() == Approx(2.0));
  CHECK(level[0].segment.start == level[1].segment.end);
  CHECK(view.toScreen(level[0].segment).start.y == Approx(view.toScreen(level[0].segment).end.y));
  CHECK(level[0].scopePlanes.empty());
  CHECK(slipPlanes(level[0], Slip::kScope, view)[0].kind == PlaneKind::kBillboard);

  const BaseLines upright = baseLines(annotated(HandleType::kSphericalRadial, Orient::kVertical), box, view);
  REQUIRE(upright.size() == 4);
  for (const BaseLine& line : upright) {
    CHECK(line.segment.length() == Approx(1.0));
    CHECK(view.toScreen(line.segment).start.x == Approx(view.toScreen(line.segment).end.x));
  }
}

TEST_CASE("scope planes lie in the faces at the line's edge, with those faces' outward normals") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({6, 5, 9}, {0, 0, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), box, view);
  // Other axes of y: z, then x. Edge 3 is at z = +1, x = +1, the one nearest to this viewer: both its faces look at the viewer.
  const std::vector<SlipPlane> near = slipPlanes(lines[3], Slip::kScope, view);
  REQUIRE(near.size() == 2);
  CHECK(near[0].across == Vec3(0, 0, 1));
  CHECK(near[0].plane.normal == Vec3(1, 0, 0));
  CHECK(near[0].facing == Facing::kFront);
  CHECK(near[1].across == Vec3(1, 0, 0));
  CHECK(near[1].plane.normal == Vec3(0, 0, 1));
  CHECK(near[1].facing == Facing::kFront);
  // Edge 0 is at z = -1, x = -1: both faces look away.
  for (const SlipPlane& plane : slipPlanes(lines[0], Slip::kScope, view)) CHECK(plane.facing == Facing::kBack);
}

TEST_CASE("a scope plane through the middle looks towards the viewer") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  for (const double side : {1.0, -1.0}) {
    const View view = frontView({6 * side, 5, 9 * side}, {0, 0, 0});
    const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box, view);
    for (const SlipPlane& plane : slipPlanes(lines[0], Slip::kScope, view)) {
      CHECK(glm::dot(plane.plane.normal, view.camera().eye) > 0);
      CHECK(plane.facing == Facing::kFront);
    }
  }
}

TEST_CASE("planes seen edge-on are left out") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({0, 0, 50}, {0, 0, 0});   // straight at the front: the side faces are edge-on
  const BaseLines lines = baseLines(annotated(HandleType::kLinearContour, Orient::kUp), box, view);
  const std::vector<SlipPlane> planes = slipPlanes(lines[3], Slip::kScope, view);
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].plane.normal == Vec3(0, 0, 1));
}

TEST_CASE("a billboard plane holds the line and is as square to the view as that allows") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({6, 5, 9}, {0, 0, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box, view);
  const std::vector<SlipPlane> planes = slipPlanes(lines[0], Slip::kBillboard, view);
  REQUIRE(planes.size() == 1);
  CHECK(glm::dot(planes[0].plane.normal, Vec3(0, 1, 0)) == Approx(0.0).margin(1e-12));
  CHECK(glm::dot(planes[0].across, Vec3(0, 1, 0)) == Approx(0.0).margin(1e-12));
  // The view direction at the middle of the line, with its part along the line taken away, is the normal's line.
  const Vec3 expected = glm::normalize(Vec3(6, 0, 9));
  CHECK(glm::length(planes[0].plane.normal - expected) == Approx(0.0).margin(1e-12));
  CHECK(planes[0].facing == Facing::kFront);
}

TEST_CASE("slip none has no plane") {
  const Obb box{.origin = {-1, -1, -1}, .size = {2, 2, 2}};
  const View view = frontView({6, 5, 9}, {0, 0, 0});
  const BaseLines lines = baseLines(annotated(HandleType::kLinearCenter, Orient::kUp), box, view);
  CHECK(slipPlanes(lines[0], Slip::kNone, view).empty());
}
