#include <catch2/catch.hpp>

#include <cmath>

#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// Where a line lies for each slip, worked out by hand: 100 px a metre, in a picture of 1000x1000 px.

namespace {

constexpr double kSpacingM = kHandleSpacingPx / 100;

/// Onto the origin from a direction.
Camera cameraFrom(double azimuthDeg, double elevationDeg) {
  Camera camera = orbitCamera({0, 0, 0}, 30, azimuthDeg, elevationDeg);
  camera.orthoHeightM = 10;
  return camera;
}

/// What each of the annotations measures on a box of 2x2x2 m round the origin, and on a scope of 1x1x1 m in the middle of that.
ModelDefinition boxInBox(std::initializer_list<std::string> annotations) {
  return measuring(annotations, [](const Values&) {
    Scene scene = sceneOf({{"Outer", boxAt({-1, -1, -1}, {2, 2, 2})}});
    scene.scopes.push_back({"Inner", 0, boxAt({-0.5, -0.5, -0.5}, {1, 1, 1})});
    return scene;
  });
}

/// The only parameter that the tests look at is the first.
const PlacedLine& lineSeenFrom(Stage& stage, const Camera& camera) {
  stage.look(camera);
  const PlacedLine* line = stage.find("Width");
  REQUIRE(line != nullptr);
  return *line;
}

void checkSame(const Vec3& found, const Vec3& expected) {
  INFO(found.x << " " << found.y << " " << found.z << " for " << expected.x << " " << expected.y << " " << expected.z);
  CHECK(glm::length(found - expected) < 0.01);
}

}  // namespace

TEST_CASE("slip scope: the line lies in the plane of a face, handleSpacing out from the model") {
  Stage stage(boxInBox({"@Handle(scope=Outer, type=linear-contour, orient=right, slip=scope, align=bottom)"}));
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 20));
  CHECK(line.planeKind == PlaneKind::kScope);
  CHECK(line.facing == Facing::kFront);
  checkSame(line.base.start, {-1, -1, 1});
  // A metre down the front face is cos 20 degrees of 100 px.
  const double outM = kSpacingM / std::cos(20 * kRadPerDeg);
  checkSame(line.line.start, {-1, -1 - outM, 1});
  checkSame(line.line.end, {1, -1 - outM, 1});
  checkSame(line.foot.start, line.base.start);
}

TEST_CASE("slip object: the line lies in a face of the hull, and its extension lines bend there") {
  // Seen from 20 degrees above the hull's faces to the viewer are the front and the top; the sides are edge-on.
  Stage stage(boxInBox({"@Handle(scope=Inner, type=linear-contour, orient=right, slip=object, align=bottom)", "@Handle(scope=Outer, type=linear-contour, orient=up, slip=object)",
                        "@Handle(scope=Outer, type=linear-contour, orient=front, slip=object)"}));
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 20));
  CHECK(line.planeKind == PlaneKind::kObject);
  CHECK(line.facing == Facing::kFront);
  CHECK(std::abs(line.base.start.x + 0.5) < 1e-9);
  CHECK(std::abs(std::abs(line.base.start.z) - 0.5) < 1e-9);
  checkSame(line.foot.start, {-0.5, line.base.start.y, 1});
  const double outM = kSpacingM / std::cos(20 * kRadPerDeg);
  checkSame(line.line.start, {-0.5, -1 - outM, 1});
  checkSame(line.line.end, {0.5, -1 - outM, 1});
  REQUIRE(line.extensionStart.size() == 3);
  const auto at = [&](std::size_t i, const Vec3& p) { CHECK(glm::length(line.extensionStart[i] - stage.layout.view.toScreen(p)) < 0.5); };
  at(0, line.base.start);
  at(1, line.foot.start);
  at(2, line.line.start);
}

TEST_CASE("slip billboard: the line lies in the plane through its base line that faces the viewer") {
  Stage stage(boxInBox({"@Handle(scope=Outer, type=linear-center, orient=up, slip=billboard, align=left)"}));
  // The box's outline is sqrt 2 m to the left of its middle, seen at its edge.
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(45, 0));
  CHECK(line.planeKind == PlaneKind::kBillboard);
  checkSame(line.base.start, {0, -1, 0});
  const Vec3 left{-std::sqrt(0.5), 0, std::sqrt(0.5)};
  checkSame(line.line.start, Vec3(0, -1, 0) + left * (std::sqrt(2.0) + kSpacingM));
  checkSame(line.line.end, Vec3(0, 1, 0) + left * (std::sqrt(2.0) + kSpacingM));
  // And turns with the viewer.
  checkSame(lineSeenFrom(stage, cameraFrom(0, 0)).line.start, {-1 - kSpacingM, -1, 0});
}

TEST_CASE("slip billboard: a diameter and a radius slip straight up or down the picture") {
  // On the lower end of a column, a box here, 1 m across and 2 m high. They are at right angles to the view, so the plane is the picture's own; the box's lower front edge, 0.5 m nearer, is sin 30
  // degrees of that further down.
  const Camera camera = cameraFrom(0, 30);
  const Vec3 down{0, -std::cos(30 * kRadPerDeg), std::sin(30 * kRadPerDeg)};
  const double outM = 0.5 * std::sin(30 * kRadPerDeg) + kSpacingM;
  for (const std::string type : {"diametric", "radial"}) {
    INFO(type);
    Stage stage(measuring({"@Handle(scope=Column, type=" + type + ", orient=up, slip=billboard, align=bottom)"},
                          [](const Values&) { return sceneOf({{"Column", boxAt({-0.5, -1, -0.5}, {1, 2, 1})}}); }));
    const PlacedLine& line = lineSeenFrom(stage, camera);
    CHECK(line.planeKind == PlaneKind::kBillboard);
    const double fixedEndM = type == "radial" ? 0 : line.base.end.x > 0 ? -0.5 : 0.5;
    checkSame(line.base.start, {fixedEndM, -1, 0});
    CHECK(std::abs(line.base.end.x) == Approx(0.5));
    checkSame(line.line.start, line.base.start + down * outM);
    checkSame(line.line.end, line.base.end + down * outM);
  }
}

TEST_CASE("slip scope: a diameter slips out in the plane of its face, or along its axis") {
  // Straight from above, the lower end's is hidden; at 45 degrees the upper end's face is half edge-on, and a metre across it 70.7 px.
  Stage stage(measuring({"@Handle(scope=Column, type=diametric, orient=up, slip=scope, align=top)"},
                        [](const Values&) { return sceneOf({{"Column", boxAt({-0.5, -1, -0.5}, {1, 2, 1})}}); }));
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 45));
  CHECK(line.planeKind == PlaneKind::kScope);
  checkSame(line.base.start, {line.base.end.x > 0 ? -0.5 : 0.5, 1, 0});
  const double perMetre = std::sqrt(0.5);
  const Vec3 way = line.line.start - line.base.start;
  CHECK(way.x == Approx(0).margin(0.01));
  // The box's upper back edge is half a metre behind the diameter: as far in the face, and as far up the picture along the axis.
  CHECK((-way.z + way.y) == Approx(0.5 + kSpacingM / perMetre).margin(0.01));
  CHECK((way.y == Approx(0).margin(1e-9) || way.z == Approx(0).margin(1e-9)));
}

TEST_CASE("a sphere's diameter and radius slip out beside its outline, level or upright on screen") {
  // A ball of 1 m radius, a box here, of which 2 x 2 m are seen from the front.
  for (const std::string orient : {"horizontal", "vertical"}) {
    const bool level = orient == "horizontal";
    for (const std::string type : {"spherical-diametric", "spherical-radial"}) {
      INFO(type << " " << orient);
      Stage stage(measuring({"@Handle(scope=Ball, type=" + type + ", orient=" + orient + ", slip=billboard, align=" + (level ? "bottom" : "left") + ")"},
                            [](const Values&) { return sceneOf({{"Ball", boxAt({-1, -1, -1}, {2, 2, 2})}}); }));
      const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 0));
      CHECK(line.planeKind == PlaneKind::kBillboard);
      const Vec3 along = level ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
      CHECK(std::abs(glm::dot(line.line.end - line.line.start, along)) == Approx(type == "spherical-radial" ? 1 : 2));
      const Vec3 out = level ? Vec3(0, -1, 0) : Vec3(-1, 0, 0);
      CHECK(glm::dot(line.line.start, out) == Approx(1 + kSpacingM).margin(0.01));
      CHECK(glm::dot(line.line.end, out) == Approx(1 + kSpacingM).margin(0.01));
    }
  }
}

TEST_CASE("a line looks as its annotation says: stippled where it is indirect, with spheres and a colour") {
  Stage stage(boxInBox({"@Handle(scope=Outer, type=linear-contour, orient=right, slip=scope, indirect, skin=sphere, color=#2f6fb7)",
                        "@Handle(scope=Outer, type=linear-contour, orient=up, slip=scope)"}));
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(20, 20));
  CHECK(line.indirect);
  CHECK(line.look.skin == HandleSkin::kSphere);
  CHECK(line.look.color == std::array<std::uint8_t, 3>{0x2f, 0x6f, 0xb7});
  const PlacedLine* plain = stage.find("Height");
  REQUIRE(plain != nullptr);
  CHECK_FALSE(plain->indirect);
  CHECK(plain->look.skin == HandleSkin::kArrow);
  CHECK_FALSE(plain->look.color.has_value());
}

TEST_CASE("of several scopes with one name the line stands at the one where its place is best") {
  // Three posts in a row, none before another: of the others' edges a line would be pushed out beyond the last post all the same, and be further from them.
  const auto besidePost = [](const std::string& align, std::int32_t post) {
    INFO(align);
    Stage stage(measuring({"@Handle(scope=Post, type=linear-contour, orient=up, slip=scope, align=" + align + ")"}, [](const Values&) {
      return sceneOf({{"Post", boxAt({-3.5, -1, -0.5}, {1, 2, 1})}, {"Post", boxAt({-0.5, -1, -0.5}, {1, 2, 1})}, {"Post", boxAt({2.5, -1, -0.5}, {1, 2, 1})}});
    }));
    const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 0));
    CHECK(line.identity.scopeIndex == post);
    return line.line;
  };
  checkSame(besidePost("left", 0).start, {-3.5 - kSpacingM, -1, 0.5});
  checkSame(besidePost("right", 2).start, {3.5 + kSpacingM, -1, 0.5});
}

TEST_CASE("slip none: the line is the base line") {
  Stage stage(boxInBox({"@Handle(scope=Outer, type=linear-contour, orient=right, slip=none)"}));
  const PlacedLine& line = lineSeenFrom(stage, cameraFrom(0, 20));
  CHECK(line.planeKind == PlaneKind::kNone);
  CHECK(line.placement == PlacementKind::kInside);
  checkSame(line.line.start, line.base.start);
  checkSame(line.line.end, line.base.end);
}
