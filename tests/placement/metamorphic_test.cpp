#include <catch2/catch.hpp>

#include <algorithm>

#include "support/motion.h"
#include "support/same_layout.h"
#include "support/stage.h"

// What must not matter does not: where in the world a model stands, how it is turned, how large it is, which way round it is seen, and in which order its parameters
// are defined. The world is changed together with the camera, so the picture stays, and with it the layout.

using namespace dimline;
using namespace dimline::test;

namespace {

/// An orbit in perspective, then one without; from a little beyond the front, so that no line ends exactly handleSpacing beside another, where rounding decides.
std::vector<Camera> flight() {
  std::vector<Camera> all;
  for (double azimuth = 0; azimuth < 360; azimuth += 3) all.push_back(orbitCamera({0, 2.5, 0}, 30, azimuth + 0.7, 22));
  for (double azimuth = 0; azimuth < 360; azimuth += 5) {
    all.push_back(orbitCamera({0, 2.5, 0}, 30, azimuth + 1.1, 35));
    all.back().orthoHeightM = 18;
  }
  return all;
}

/// Both layouts show the same lines, `margin` px apart at most.
void checkSame(const Layout& a, const Layout& b, double marginPx) {
  REQUIRE(a.lines.size() == b.lines.size());
  CHECK(a.hidden.size() == b.hidden.size());
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    CHECK(a.lines[i].identity == b.lines[i].identity);
    CHECK(glm::length(a.lines[i].lineScreen.start - b.lines[i].lineScreen.start) < marginPx);
    CHECK(glm::length(a.lines[i].lineScreen.end - b.lines[i].lineScreen.end) < marginPx);
    REQUIRE(a.lines[i].label.has_value() == b.lines[i].label.has_value());
    if (a.lines[i].label) CHECK(glm::length(a.lines[i].label->center() - b.lines[i].label->center()) < marginPx);
  }
}

void checkMotion(const Motion& motion, double marginPx) {
  Stage here(boxWithDoor());
  Stage there(moved(boxWithDoor(), motion));
  for (const Camera& camera : flight()) {
    here.look(camera);
    there.look(moved(camera, motion));
    checkSame(here.layout, there.layout, marginPx);
  }
}

}  // namespace

// Points of meshes are floats: what is moved is rounded anew, by a small share of a pixel, and a strip of a field more or less may follow.
constexpr double kRoundingPx = 1.5;

TEST_CASE("a model that stands elsewhere has the same lines") { checkMotion({.move = {64, -16, 128}}, kRoundingPx); }

TEST_CASE("a model that is turned in the world has the same lines") {
  checkMotion({.turnRad = 1.5707963267948966}, kRoundingPx);
  checkMotion({.turnRad = 0.9}, kRoundingPx);
}

TEST_CASE("a model that is larger in the world has the same lines") {
  checkMotion({.scale = 1024}, kRoundingPx);
  checkMotion({.scale = 1.0 / 64}, kRoundingPx);
}

TEST_CASE("a flight in the mirror gives the mirrored lines") {
  const Motion mirror{.mirrored = true};
  Stage here(boxWithDoor());
  Stage there(moved(boxWithDoor(), mirror));
  std::size_t compared = 0;
  for (const Camera& camera : flight()) {
    here.look(camera);
    there.look(moved(camera, mirror));
    REQUIRE(here.layout.lines.size() == there.layout.lines.size());
    for (const PlacedLine& line : here.layout.lines) {
      const PlacedLine* image = there.find(here.nameOf(line));
      REQUIRE(image != nullptr);
      CHECK(image->placement == line.placement);
      const auto mirrored = [](const Vec2& p) { return Vec2(1000 - p.x, p.y); };
      CHECK(glm::length(mirrored(line.lineScreen.start) - image->lineScreen.start) < kRoundingPx);
      CHECK(glm::length(mirrored(line.lineScreen.end) - image->lineScreen.end) < kRoundingPx);
      ++compared;
    }
  }
  CHECK(compared > 500);
}

TEST_CASE("parameters defined in another order have the same lines") {
  Stage stage(boxWithDoor());
  Stage other(reordered(boxWithDoor(), {3, 1, 4, 2, 0}));
  for (const Camera& camera : flight()) {
    stage.look(camera);
    other.look(camera);
    REQUIRE(stage.layout.lines.size() == other.layout.lines.size());
    for (const PlacedLine& line : stage.layout.lines) {
      const PlacedLine* same = other.find(stage.nameOf(line));
      REQUIRE(same != nullptr);
      CHECK(same->lineScreen.start == line.lineScreen.start);
      CHECK(same->lineScreen.end == line.lineScreen.end);
    }
  }
}

TEST_CASE("of parameters of equal length the one defined first is placed first, whichever it is") {
  // A cube: width, height and depth are equal. Width and Depth change places in the definition and in the world alike, and the picture with them.
  const auto cube = [](bool swapped) {
    ModelDefinition definition = boxWithDoor();
    for (std::size_t i = 0; i < 3; ++i) definition.parameters[i].defaultValue = 6;
    definition.parameters.resize(3);
    if (swapped) std::swap(definition.parameters[0].name, definition.parameters[2].name);
    definition.build = [](const Values& v) {
      Scene scene;
      const Obb box = boxAt({-v.at(0) / 2, 0, -v.at(2) / 2}, {v.at(0), v.at(1), v.at(2)});
      addBox(scene, box);
      scene.scopes.push_back({"Box", 0, box});
      finish(scene);
      return scene;
    };
    return definition;
  };
  Stage stage(cube(false));
  Stage other(cube(true));
  for (const Camera& camera : flight()) {
    stage.look(camera);
    other.look(camera);
    REQUIRE(stage.layout.lines.size() == other.layout.lines.size());
    for (std::size_t i = 0; i < stage.layout.lines.size(); ++i) {
      const std::string name = stage.nameOf(stage.layout.lines[i]);
      CHECK(other.nameOf(other.layout.lines[i]) == (name == "Width" ? "Depth" : name == "Depth" ? "Width" : name));
      CHECK(stage.layout.lines[i].lineScreen.start == other.layout.lines[i].lineScreen.start);
    }
  }
}

TEST_CASE("the same flight gives the same bits twice, in two placers and in one that has forgotten") {
  Stage one(boxWithDoor());
  Stage two(boxWithDoor());
  std::vector<Layout> first;
  for (const Camera& camera : flight()) {
    first.push_back(one.look(camera));
    CHECK(sameLayout(first.back(), two.look(camera)));
  }
  one.placer.forget();
  std::size_t frame = 0;
  for (const Camera& camera : flight()) CHECK(sameLayout(one.look(camera), first[frame++]));
}
