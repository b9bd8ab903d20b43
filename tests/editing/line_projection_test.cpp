#include <catch2/catch.hpp>

#include "editing/line_projection.h"

using namespace dimline;

namespace {

/// 100 px a metre, the world's origin in the middle of 1000 x 1000.
View frontView() {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.orthoHeightM = 10;
  return {camera, 1000, 1000, Bounds{Vec3(-5), Vec3(5)}};
}

PlacedLine lineBelow() {
  PlacedLine line;
  line.base = {{-2, 0, 0}, {2, 0, 0}};
  line.line = {{-2, -1, 0}, {2, -1, 0}};
  line.baseScreen = {{300, 500}, {700, 500}};
  line.lineScreen = {{300, 600}, {700, 600}};
  line.extensionStart = {{300, 500}, {300, 600}};
  line.extensionEnd = {{700, 500}, {700, 600}};
  line.handles = {{true, {700, 600}}, {false, {300, 600}}};
  line.label = Box2{{480, 590}, {520, 610}};
  return line;
}

}  // namespace

TEST_CASE("a line that has not moved is projected to where it was") {
  PlacedLine line = lineBelow();
  const PlacedLine before = line;
  projectLine(line, frontView(), labelAnchor(line));
  REQUIRE(glm::length(line.lineScreen.start - before.lineScreen.start) < 1e-9);
  REQUIRE(glm::length(line.baseScreen.end - before.baseScreen.end) < 1e-9);
  REQUIRE(glm::length(line.label->min - before.label->min) < 1e-9);
  REQUIRE(glm::length(line.extensionStart.back() - before.extensionStart.back()) < 1e-9);
}

TEST_CASE("a longer line takes its handles, extension lines and label along") {
  PlacedLine line = lineBelow();
  const auto anchor = labelAnchor(line);
  line.base.end.x = 3;
  line.line.end.x = 3;
  projectLine(line, frontView(), anchor);
  REQUIRE(line.lineScreen.end.x == Approx(800));
  REQUIRE(line.handles[0].screen.x == Approx(800));
  REQUIRE(line.handles[1].screen.x == Approx(300));
  REQUIRE(line.extensionEnd.front().x == Approx(800));
  REQUIRE(line.extensionEnd.back().y == Approx(600));
  REQUIRE(line.label->center().x == Approx(550));  // still the middle
}

TEST_CASE("a label beyond an end stays beyond it") {
  PlacedLine line = lineBelow();
  line.label = Box2{{710, 590}, {750, 610}};
  const auto anchor = labelAnchor(line);
  REQUIRE(anchor->to == LabelAnchor::To::kEnd);
  line.line.end.x = 3;
  projectLine(line, frontView(), anchor);
  REQUIRE(line.label->min.x == Approx(810));
  REQUIRE(line.label->max.x == Approx(850));
}

TEST_CASE("a bend of an extension line goes with its ends") {
  PlacedLine line = lineBelow();
  line.extensionStart = {{300, 500}, {320, 550}, {300, 600}};
  line.base.start.x -= 1;
  line.line.start.x -= 1;
  projectLine(line, frontView(), std::nullopt);
  REQUIRE(line.extensionStart[1].x == Approx(220));
  REQUIRE(line.extensionStart[1].y == Approx(550));
  REQUIRE_FALSE(line.label);
}

TEST_CASE("a bend of an extension line goes half with each end") {
  PlacedLine line = lineBelow();
  line.extensionStart = {{300, 500}, {320, 550}, {300, 600}};
  line.line.start += Vec3(1, -2, 0);
  projectLine(line, frontView(), std::nullopt);
  REQUIRE(glm::length(line.extensionStart[1] - Vec2(370, 650)) < 1e-9);
  REQUIRE(glm::length(line.extensionStart.front() - Vec2(300, 500)) < 1e-9);
  REQUIRE(glm::length(line.extensionStart.back() - Vec2(400, 800)) < 1e-9);
}

TEST_CASE("an extension line that runs beside its line's end stays there while the line moves") {
  PlacedLine line = lineBelow();
  line.extensionEnd = {{696, 500}, {696, 600}};
  for (const double x : {3.0, 2.5}) {
    line.base.end.x = line.line.end.x = x;
    projectLine(line, frontView(), labelAnchor(line));
    REQUIRE(line.extensionEnd.front().x == Approx(line.baseScreen.end.x - 4));
    REQUIRE(line.extensionEnd.back().x == Approx(line.lineScreen.end.x - 4));
  }
}

TEST_CASE("what lies behind the viewer cannot be projected") {
  Camera camera;
  camera.eye = {0, 0, 1};
  camera.target = {0, 0, 0};
  const View view(camera, 1000, 1000, Bounds{Vec3(-5), Vec3(5)});
  PlacedLine line = lineBelow();
  REQUIRE(canProject(line, view));
  line.line.end.z = 2;
  REQUIRE_FALSE(canProject(line, view));
}
