#include <catch2/catch.hpp>

#include "app/line_animator.h"
#include "app/motion.h"
#include "editing/line_projection.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

View frontView(double targetX = 0) {
  Camera camera;
  camera.eye = {targetX, 0, 20};
  camera.target = {targetX, 0, 0};
  camera.orthoHeightM = 10;  // 100 px a metre
  return {camera, 1000, 1000, Bounds{Vec3(-5), Vec3(5)}};
}

/// A line of parameter 0, 4 m long, 1 m below or above its base line.
PlacedLine placedLine(double offsetM, int direction, const View& view) {
  PlacedLine line;
  line.identity = {0, 0, -1, 0, 0, static_cast<std::int8_t>(direction)};
  line.placement = PlacementKind::kOutside;
  line.base = {{-2, 0, 0}, {2, 0, 0}};
  line.line = {{-2, offsetM, 0}, {2, offsetM, 0}};
  line.extensionStart.resize(2);
  line.extensionEnd.resize(2);
  line.handles = {{true, {}}};
  line.text = "4.00 m";
  projectLine(line, view, LabelAnchor{.size = {40, 18}});
  return line;
}

struct Stage {
  std::vector<Scope> scopes{{"Box", 0, boxAt({-2, -2, -2}, {4, 4, 4})}};
  LineAnimator animator;
  Layout placed, drawn;

  explicit Stage(const View& view, std::vector<PlacedLine> lines) { place(view, std::move(lines)); }
  void place(const View& view, std::vector<PlacedLine> lines) {
    placed.view = view;
    placed.lines = std::move(lines);
  }
  const Layout& at(double ms, const View& view) {
    animator.update(placed, scopes, view, ms, drawn);
    return drawn;
  }
  const Layout& at(double ms) { return at(ms, placed.view); }
};

bool same(const PlacedLine& a, const PlacedLine& b) {
  return a.base.start == b.base.start && a.base.end == b.base.end && a.line.start == b.line.start &&
         a.line.end == b.line.end && a.lineScreen.start == b.lineScreen.start && a.lineScreen.end == b.lineScreen.end &&
         a.label->min == b.label->min && a.label->max == b.label->max && a.extensionStart == b.extensionStart &&
         a.handles[0].screen == b.handles[0].screen;
}

}  // namespace

TEST_CASE("the first lines are there at once, exactly as placed") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  REQUIRE(same(stage.at(0).lines[0], stage.placed.lines[0]));
  REQUIRE(stage.animator.opacities()[0] == 1);
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("a line whose choice changes glides from the old place to the new one, world and screen together") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);
  stage.place(view, {placedLine(1, 1, view)});

  REQUIRE(stage.at(16).lines[0].line.start.y == Approx(-1));  // the frame of the change shows where it was
  REQUIRE_FALSE(stage.animator.atRest());
  double before = -1;
  for (const double ms : {50.0, 90.0, 130.0, 170.0}) {
    const PlacedLine& line = stage.at(ms).lines[0];
    REQUIRE(line.line.start.y > before);
    REQUIRE(line.line.start.y < 1);
    before = line.line.start.y;
    const Segment2 projected = view.toScreen(line.line);
    REQUIRE(glm::length(projected.start - line.lineScreen.start) < 1e-9);
    REQUIRE(line.handles[0].screen == line.lineScreen.end);
    REQUIRE(line.extensionEnd.back() == line.lineScreen.end);
    REQUIRE(line.label->center().y == Approx(line.lineScreen.middle().y));
  }
  REQUIRE(same(stage.at(200).lines[0], stage.placed.lines[0]));
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("with reduced motion a line is at its new place at once") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.animator.setReducedMotion(true);
  stage.at(0);
  stage.place(view, {placedLine(1, 1, view)});
  REQUIRE(same(stage.at(16).lines[0], stage.placed.lines[0]));
  stage.place(view, {});
  stage.at(32);
  REQUIRE(stage.animator.fading().empty());
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("a line that keeps its place sticks to it while the camera moves") {
  Stage stage(frontView(), {placedLine(-1, -1, frontView())});
  stage.at(0);
  for (int i = 1; i < 10; ++i) {
    const View view = frontView(0.3 * i);
    stage.place(view, {placedLine(-1, -1, view)});
    REQUIRE(same(stage.at(16.0 * i).lines[0], stage.placed.lines[0]));
    REQUIRE(stage.animator.atRest());
  }
}

TEST_CASE("a line placed for an older view is shown where the present view has it") {
  const View old = frontView();
  Stage stage(old, {placedLine(-1, -1, old)});
  stage.at(0);
  const View now = frontView(0.5);  // 50 px to the right: everything moves 50 px to the left
  const PlacedLine& line = stage.at(16, now).lines[0];
  REQUIRE(line.line.start == stage.placed.lines[0].line.start);
  REQUIRE(line.lineScreen.start.x == Approx(stage.placed.lines[0].lineScreen.start.x - 50));
  REQUIRE(line.label->center().x == Approx(stage.placed.lines[0].label->center().x - 50));
  REQUIRE(stage.drawn.view.camera().target.x == 0.5);
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("a jump of a line that stays the same one is softened, a drift is not") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);
  stage.place(view, {placedLine(-1.2, -1, view)});  // 20 px
  REQUIRE(same(stage.at(16).lines[0], stage.placed.lines[0]));
  stage.place(view, {placedLine(-1.7, -1, view)});  // 50 px
  REQUIRE(stage.at(32).lines[0].line.start.y == Approx(-1.2));
  REQUIRE(stage.at(120).lines[0].line.start.y < -1.2);
  REQUIRE(same(stage.at(300).lines[0], stage.placed.lines[0]));
}

TEST_CASE("a label that hops along its line glides there, and the line stays where it is") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  const Vec2 middle = stage.at(0).lines[0].label->center();
  PlacedLine hopped = placedLine(-1, -1, view);
  hopped.labelPlace.eighth = 4;
  hopped.label->min.x += 80;
  hopped.label->max.x += 80;
  stage.place(view, {hopped});
  REQUIRE(stage.at(16).lines[0].label->center() == middle);
  REQUIRE_FALSE(stage.animator.atRest());
  const PlacedLine line = stage.at(40).lines[0];
  REQUIRE(line.label->center().x > middle.x);
  REQUIRE(line.label->center().x < middle.x + 80);
  REQUIRE(line.lineScreen.start == hopped.lineScreen.start);
  // It hops again on the way, and is there no later for that.
  const double onTheWay = line.label->center().x;
  hopped.labelPlace.eighth = 6;
  hopped.label->min.x += 20;
  hopped.label->max.x += 20;
  stage.place(view, {hopped});
  REQUIRE(stage.at(42).lines[0].label->center().x == Approx(onTheWay).margin(3));
  REQUIRE(same(stage.at(200).lines[0], hopped));
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("a change on the way goes on from where the line is") {
  const View view = frontView();
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);
  stage.place(view, {placedLine(1, 1, view)});
  stage.at(16);
  const double there = stage.at(60).lines[0].line.start.y;
  stage.place(view, {placedLine(-1, -1, view)});
  REQUIRE(stage.at(76).lines[0].line.start.y >= there - 1e-9);
  REQUIRE(same(stage.at(400).lines[0], stage.placed.lines[0]));
}

TEST_CASE("lines come and go by opacity, and one that goes is no part of the layout") {
  const View view = frontView();
  PlacedLine other = placedLine(2, 1, view);
  other.identity.parameter = 1;
  other.parameter = 1;
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);

  stage.place(view, {placedLine(-1, -1, view), other});
  stage.at(100);
  REQUIRE(stage.animator.opacities()[0] == 1);
  REQUIRE(stage.animator.opacities()[1] == 0);
  stage.at(170);
  REQUIRE(stage.animator.opacities()[1] == Approx(0.5));
  stage.at(400);
  REQUIRE(stage.animator.opacities()[1] == 1);
  REQUIRE(stage.animator.atRest());

  stage.place(view, {other});
  REQUIRE(stage.at(500).lines.size() == 1);
  REQUIRE(stage.animator.fading().size() == 1);
  REQUIRE(stage.animator.fading()[0].opacity == 1);
  stage.at(570);
  REQUIRE(stage.animator.fading()[0].opacity == Approx(0.5));
  REQUIRE_FALSE(stage.animator.atRest());
  stage.at(700);
  REQUIRE(stage.animator.fading().empty());
  REQUIRE(stage.animator.atRest());
}

TEST_CASE("a line whose new choice is far away fades here and appears there, and glides when it stays the same one") {
  const View view = frontView();
  const double nearM = 0.99 * kFarPx / 100 - 1, farM = 1.01 * kFarPx / 100 - 1;
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);
  stage.place(view, {placedLine(farM, 1, view)});
  REQUIRE(same(stage.at(16).lines[0], stage.placed.lines[0]));
  REQUIRE(stage.animator.opacities()[0] == 0);
  REQUIRE(stage.animator.fading().size() == 1);
  REQUIRE(stage.animator.fading()[0].placed.line.start.y == -1);
  stage.at(86);
  REQUIRE(stage.animator.opacities()[0] == Approx(0.5));
  REQUIRE(stage.animator.fading()[0].opacity == Approx(0.5));
  REQUIRE(same(stage.at(400).lines[0], stage.placed.lines[0]));
  REQUIRE(stage.animator.atRest());

  Stage stays(view, {placedLine(-1, -1, view)});
  stays.at(0);
  stays.place(view, {placedLine(farM, -1, view)});
  REQUIRE(stays.at(16).lines[0].line.start.y == Approx(-1));
  Stage near(view, {placedLine(-1, -1, view)});
  near.at(0);
  near.place(view, {placedLine(nearM, 1, view)});
  REQUIRE(near.at(16).lines[0].line.start.y == Approx(-1));
  REQUIRE(near.animator.fading().empty());
}

TEST_CASE("what the present view cannot show is left out") {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.target = {0, 0, 0};
  const View view(camera, 1000, 1000, Bounds{Vec3(-5), Vec3(5)});
  Stage stage(view, {placedLine(-1, -1, view)});
  stage.at(0);
  camera.eye = {0, 0, -1};
  camera.target = {0, 0, -10};
  REQUIRE(stage.at(16, View(camera, 1000, 1000, Bounds{Vec3(-5), Vec3(5)})).lines.empty());
  REQUIRE(stage.animator.opacities().empty());
}
