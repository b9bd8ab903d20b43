#include "cli/audit_planes.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "placement/base_lines.h"
#include "support/scenes.h"

namespace dimline::test {
namespace {

/// The ways of the first annotation's base lines on a box of 8 x 5 x 6 m around the origin, seen from the right in
/// front and from above.
struct Ways {
  Model model;
  Scene scene = sceneOf({{"Box", boxAt({-4, 0, -3}, {8, 5, 6})}});
  View view{orbitCamera({0, 2.5, 0}, 40, 30, 20), 1000, 1000, scene.bounds};
  double sizeM = scene.bounds.diagonal();
  std::vector<ObjectFace> object;

  explicit Ways(const std::string& annotation)
      : model(*makeModel(measuring({"@Handle(scope=Box, " + annotation + ")"}, [](const Values&) { return Scene{}; }))),
        object(objectFaces(model, scene)) {}
  [[nodiscard]] std::vector<SlipWay> of(const Segment& base) const {
    return slipWays(*model.annotations[0], scene.scopes[0].box, base, view, object, sizeM);
  }
  [[nodiscard]] bool lead(const std::vector<SlipWay>& ways, const Vec3& direction) const {
    return std::ranges::any_of(ways, [&](const SlipWay& way) { return glm::length(way.direction - direction) < 1e-9; });
  }
};

const Segment kFrontLeftEdge{{-4, 0, 3}, {-4, 5, 3}};

TEST_CASE("audit planes: the prism around a box's base lines is the box") {
  const Ways ways("type=linear-contour, orient=up, slip=object");
  REQUIRE(ways.object.size() == 6);
  for (const Vec3& normal :
       {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    const auto face = std::ranges::find_if(
        ways.object, [&](const ObjectFace& f) { return glm::length(f.plane.normal - normal) < 1e-9; });
    REQUIRE(face != ways.object.end());
    CHECK(glm::dot(face->middle - Vec3(0, 2.5, 0), normal) == Approx(normal.x != 0 ? 4 : normal.y != 0 ? 2.5 : 3));
    if (normal.y == 0) CHECK(face->widthM == Approx(normal.x != 0 ? 6 : 8));
  }
  CHECK(Ways("type=linear-center, orient=up, slip=object").object.empty());  // one line, which stands on a point
}

TEST_CASE(
    "audit planes: an upright line slips on the four sides of the object, as far as those turned the same way let it") {
  const Ways ways("type=linear-contour, orient=up, slip=object");
  const std::vector<SlipWay> all = ways.of(kFrontLeftEdge);
  REQUIRE(all.size() == 8);
  const auto onFront = std::ranges::find_if(
      all, [](const SlipWay& way) { return way.from.start.z > 2.9 && std::abs(way.direction.x) > 0.5; });
  REQUIRE(onFront != all.end());
  const auto room = [&](double x) { return staysWithin(*onFront, {{x, 0, 3}, {x, 5, 3}}, ways.sizeM); };
  CHECK(room(3.9));
  CHECK_FALSE(room(4.5));  // before the right side, which looks to the viewer too
  CHECK(room(-4.5));       // past the left one, which does not
  // On the back the right side is not in the way, and the left one is.
  const auto onBack = std::ranges::find_if(
      all, [](const SlipWay& way) { return way.from.start.z < -2.9 && std::abs(way.direction.x) > 0.5; });
  REQUIRE(onBack != all.end());
  CHECK(staysWithin(*onBack, {{4.5, 0, -3}, {4.5, 5, -3}}, ways.sizeM));
  CHECK_FALSE(staysWithin(*onBack, {{-4.5, 0, -3}, {-4.5, 5, -3}}, ways.sizeM));
}

TEST_CASE("audit planes: scope and billboard, and none") {
  const Ways scope("type=linear-contour, orient=up, slip=scope");
  const std::vector<SlipWay> onScope = scope.of(kFrontLeftEdge);
  CHECK(onScope.size() == 4);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
    CHECK(scope.lead(onScope, direction));

  const Ways billboard("type=linear-contour, orient=up, slip=billboard");
  const std::vector<SlipWay> onBillboard = billboard.of(kFrontLeftEdge);
  REQUIRE(onBillboard.size() == 2);
  const Vec3 sight = billboard.view.directionTo({-4, 2.5, 3});
  for (const SlipWay& way : onBillboard) {
    CHECK(glm::dot(way.direction, Vec3(0, 1, 0)) == Approx(0).margin(1e-9));
    CHECK(glm::dot(way.direction, sight) == Approx(0).margin(1e-9));
  }
  CHECK(Ways("type=linear-contour, orient=up, slip=none").of(kFrontLeftEdge).empty());
}

TEST_CASE("audit planes: round types slip in the planes that the placer has for them") {
  for (const std::string type : {"diametric", "radial", "spherical-diametric", "spherical-radial"}) {
    const bool spherical = type.starts_with("spherical");
    const Ways ways("type=" + type + ", orient=" + (spherical ? "vertical" : "up") + ", slip=scope");
    for (const BaseLine& line : baseLines(*ways.model.annotations[0], ways.scene.scopes[0].box, ways.view)) {
      INFO(type << " " << line.number);
      const std::vector<SlipWay> own = ways.of(line.segment);
      CHECK(own.size() == (spherical ? 2 : 4));
      for (const ScopePlane& plane : line.scopePlanes) CHECK(ways.lead(own, plane.across));
    }
  }
}

TEST_CASE("audit planes: the audit's own base lines are the placer's, found twice") {
  const auto model = makeModel(boxWithDoor());
  const Scene scene = model->definition.build(Values(model->parameters()));
  const View view(orbitCamera({0, 2.5, 0}, 40, 30, 20), 1000, 1000, scene.bounds);
  for (const auto& annotation : model->annotations) {
    const Obb& box = scene.scopes[annotation->scope == "Box" ? 0 : 1].box;
    const std::vector<Segment> own = linearBaseLines(*annotation, box);
    const BaseLines theirs = baseLines(*annotation, box, view);
    REQUIRE(own.size() == theirs.size());
    for (const BaseLine& line : theirs) {
      CHECK(std::ranges::any_of(own, [&](const Segment& s) {
        return glm::length(s.start - line.segment.start) < 1e-12 && glm::length(s.end - line.segment.end) < 1e-12;
      }));
    }
  }
}

}  // namespace
}  // namespace dimline::test
