#include <catch2/catch.hpp>

#include "app/handle_animator.h"
#include "app/motion.h"
#include "editing/arc_projection.h"
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

/// The choice of parameter 0, whose box is 100 x 28 px about `center`.
PlacedHandle pillAt(const Vec2& center, int direction) {
  PlacedHandle pill;
  pill.type = HandleType::kRange;
  pill.identity = {.parameter = 0, .scopeIndex = 0, .baseLine = 0, .plane = static_cast<std::int16_t>(direction)};
  pill.placement = PlacementKind::kOutside;
  pill.anchor = {500, 500};
  pill.box = {center - Vec2(50, 14), center + Vec2(50, 14)};
  pill.handles = {{true, center}};
  pill.options = {{0, "gable", {pill.box.min + Vec2(0, 28), pill.box.max + Vec2(0, 28)}}};
  return pill;
}

/// The angle of parameter 1: 30 degrees about `center`, 1 m large, in the plane of the picture.
PlacedHandle arcAbout(const Vec3& center, int direction, int scopeIndex, const View& view) {
  PlacedHandle arc;
  arc.parameter = 1;
  arc.type = HandleType::kAngular;
  arc.identity = {.parameter = 1, .scopeIndex = scopeIndex, .baseLine = 0, .plane = static_cast<std::int16_t>(direction)};
  arc.arc = Arc{center, {1, 0, 0}, {0, 0, 1}, 1.0, 0.5235987755982988};
  arc.handles = {{true, {}}};
  arc.box = {{0, 0}, {30, 17}};
  arc.anchor = view.toScreen(center);
  projectArcHandle(arc, view, {40, -10});
  return arc;
}

struct Stage {
  std::vector<Scope> scopes{{"Box", 0, boxAt({-1, -1, -1}, {2, 2, 2})}};
  HandleAnimator animator;
  Layout placed, drawn;

  Stage(const View& view, std::vector<PlacedHandle> handles) { place(view, std::move(handles)); }
  void place(const View& view, std::vector<PlacedHandle> handles) {
    placed.view = view;
    placed.others = std::move(handles);
  }
  const std::vector<PlacedHandle>& at(double ms, const View& view) {
    animator.update(placed, scopes, view, ms, drawn);
    return drawn.others;
  }
  const std::vector<PlacedHandle>& at(double ms) { return at(ms, placed.view); }
};

}  // namespace

TEST_CASE("the first handles are there at once, exactly as placed") {
  const View view = frontView();
  Stage stage(view, {pillAt({700, 300}, 1), arcAbout({0, 0, 0}, -1, 0, view)});
  const auto& drawn = stage.at(0);
  REQUIRE(drawn.size() == 2);
  CHECK(drawn[0].box.min == stage.placed.others[0].box.min);
  CHECK(drawn[1].box.min == stage.placed.others[1].box.min);
  CHECK(drawn[1].handles[0].screen == stage.placed.others[1].handles[0].screen);
  CHECK(stage.animator.opacities()[0] == 1);
  CHECK(stage.animator.atRest());
}

TEST_CASE("a pill that is placed elsewhere glides there with all it holds") {
  const View view = frontView();
  Stage stage(view, {pillAt({700, 300}, 1)});
  stage.at(0);
  stage.place(view, {pillAt({300, 300}, 2)});
  CHECK(stage.at(16)[0].box.center().x == Approx(700));
  CHECK_FALSE(stage.animator.atRest());
  const PlacedHandle half = stage.at(16 + kGlideMs / 2)[0];
  CHECK(half.box.center().x > 300);
  CHECK(half.box.center().x < 500);  // most of the way is done in the first half
  CHECK(half.box.center() == half.handles[0].screen);
  CHECK(half.options[0].box.min == half.box.min + Vec2(0, 28));
  CHECK(stage.at(17 + kGlideMs)[0].box.center() == Vec2(300, 300));
  CHECK(stage.animator.atRest());
}

TEST_CASE("what drifts with the camera does not glide, what jumps does") {
  const View view = frontView();
  Stage stage(view, {pillAt({700, 300}, 1)});
  stage.at(0);
  stage.place(view, {pillAt({700 + kJumpPx - 1, 300}, 1)});
  CHECK(stage.at(16)[0].box.center().x == Approx(700 + kJumpPx - 1));
  CHECK(stage.animator.atRest());
  stage.place(view, {pillAt({700 + 3 * kJumpPx, 300}, 1)});
  CHECK(stage.at(32)[0].box.center().x == Approx(700 + kJumpPx - 1));
  CHECK_FALSE(stage.animator.atRest());
}

TEST_CASE("an arc glides in the world, and its screen parts are those of where it is") {
  const View view = frontView();
  Stage stage(view, {arcAbout({0, 0, 0}, -1, 0, view)});
  stage.at(0);
  stage.place(view, {arcAbout({2, 0, 0}, 1, 0, view)});
  const PlacedHandle half = stage.at(16)[0];
  CHECK(half.arc->center.x == Approx(0).margin(1e-9));
  const PlacedHandle later = stage.at(16 + kGlideMs / 2)[0];
  CHECK(later.arc->center.x > 1);
  CHECK(later.arc->center.x < 2);
  CHECK(glm::length(later.handles[0].screen - view.toScreen(later.arc->at(later.arc->angleRad))) < 1e-9);
  CHECK(arcLabelOffset(later, view).x == Approx(40));
}

TEST_CASE("an arc that goes to another scope fades here and appears there") {
  const View view = frontView();
  Stage stage(view, {arcAbout({0, 0, 0}, -1, 0, view)});
  stage.at(0);
  stage.place(view, {arcAbout({2, 0, 0}, -1, 1, view)});
  CHECK(stage.at(16)[0].arc->center.x == 2);
  CHECK(stage.animator.opacities()[0] == 0);
  REQUIRE(stage.animator.fading().size() == 1);
  CHECK(stage.animator.fading()[0].placed.arc->center.x == 0);
  stage.at(16 + kFadeMs / 2);
  CHECK(stage.animator.opacities()[0] == Approx(0.5));
  CHECK(stage.animator.fading()[0].opacity == Approx(0.5));
  stage.at(17 + kFadeMs);
  CHECK(stage.animator.fading().empty());
  CHECK(stage.animator.atRest());
}

TEST_CASE("a handle that is placed no more fades away, and without motion it is gone at once") {
  const View view = frontView();
  for (const bool reduced : {false, true}) {
    Stage stage(view, {pillAt({700, 300}, 1)});
    stage.animator.setReducedMotion(reduced);
    stage.at(0);
    stage.place(view, {});
    CHECK(stage.at(16).empty());
    CHECK(stage.animator.fading().size() == (reduced ? 0 : 1));
  }
}

TEST_CASE("for a newer view than the placer's, a pill moves with its scope and an arc is projected anew") {
  const View old = frontView();
  Stage stage(old, {pillAt({700, 300}, 1), arcAbout({0, 0, 0}, -1, 0, old)});
  stage.at(0);
  const View now = frontView(1);  // everything moves 100 px to the left
  const auto& drawn = stage.at(16, now);
  CHECK(drawn[0].box.center().x == Approx(600));
  CHECK(drawn[0].anchor.x == Approx(400));
  CHECK(drawn[0].options[0].box.center().x == Approx(600));
  CHECK(glm::length(drawn[1].handles[0].screen - now.toScreen(drawn[1].arc->at(drawn[1].arc->angleRad))) < 1e-9);
  CHECK(arcLabelOffset(drawn[1], now).x == Approx(40));
  CHECK(stage.animator.atRest());
}
