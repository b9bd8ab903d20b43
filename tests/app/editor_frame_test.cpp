#include <algorithm>
#include <catch2/catch.hpp>

#include "app/editor_stage.h"
#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"

using namespace dimline;
using namespace dimline::test;

namespace {

void requireNothingMoves(EditorStage& stage) {
  const Layout before = stage.editor.layout();
  for (int i = 0; i < 100; ++i) {
    stage.frame();
    REQUIRE(stage.editor.atRest());
    REQUIRE(sameLayout(before, stage.editor.layout()));
  }
}

/// Turns the camera in frames, as a script would; `look()` after each.
template <typename Look>
void turnInFrames(EditorStage& stage, int frames, Look look) {
  for (int i = 0; i < frames; ++i) {
    REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 30, 3.0 * i, 20)));
    stage.frame();
    look();
  }
}
void turnInFrames(EditorStage& stage, int frames) {
  turnInFrames(stage, frames, [] {});
}

}  // namespace

TEST_CASE("a still camera moves nothing, bit for bit") {
  EditorStage stage;
  requireNothingMoves(stage);
}

TEST_CASE("at rest the layout is what the placer gives for the present camera") {
  EditorStage stage;
  const Model model = makeModel(boxWithDoor()).value();
  const Values values(model.parameters());
  const Scene scene = model.definition.build(values);
  CpuFields producer;
  producer.setScene(scene);
  Placer placer;
  placer.setScene(model, scene);
  CpuVisibility visibility;
  ScopeVisibility seen;
  DistanceFields fields;
  Layout expected;
  for (int i = 0; i <= 12; ++i) {
    // First the view in which the editor opened: what was placed there counts later.
    const Camera camera = i == 0 ? stage.editor.camera() : orbitCamera({0, 2, 0}, 30, 29.0 * i, 15 + i);
    REQUIRE(stage.editor.setCamera(camera));
    if (i > 0) stage.settle();
    const View view(camera, 1000, 1000, scene.bounds);
    producer.produce(view, fields);
    visibility.measure(scene, view, seen);
    placer.place(view, fields, values, expected, &seen);
    if (!placer.settled()) placer.placeSettled(view, fields, values, expected, &seen);
    REQUIRE(sameLayout(expected, stage.editor.layout()));
  }
}

TEST_CASE("a steady orbit comes to rest soon after it ends") {
  EditorStage stage;
  turnInFrames(stage, 60, [&] {
    const Layout& layout = stage.editor.layout();
    REQUIRE(stage.editor.lineStates().size() == layout.lines.size());
    for (const PlacedLine& line : layout.lines) {
      REQUIRE(glm::length(layout.view.toScreen(line.line.end) - line.lineScreen.end) < 1e-6);  // mid-animation too
    }
  });
  REQUIRE(stage.settle() <= 36);  // 350 ms, 180 ms and some frames
  REQUIRE(stage.editor.fadingLines().empty());
}

TEST_CASE("every parameter with a line is in lines or hidden, never in both, in every frame") {
  EditorStage stage;
  for (int i = 0; i < 120; ++i) {
    REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 14, 7.0 * i, -10 + i)));
    stage.frame();
    std::vector<int> count(5, 0);
    for (const PlacedLine& line : stage.editor.layout().lines) ++count[line.parameter];
    for (const HiddenParameter& hidden : stage.editor.layout().hidden) ++count[hidden.parameter];
    REQUIRE(count == std::vector<int>(5, 1));
  }
}

TEST_CASE("with reduced motion nothing glides or fades") {
  EditorStage stage;
  stage.editor.setReducedMotion(true);
  const auto nothingMoves = [&] {
    return stage.editor.fadingLines().empty() && std::ranges::all_of(stage.editor.lineStates(), [](const auto& state) { return state.opacity == 1; });
  };
  for (int i = 0; i < 60; ++i) {
    REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 30, 6.0 * i, 20)));
    stage.frame();
    REQUIRE(nothingMoves());
  }
  for (int frames = 0; !stage.editor.atRest(); ++frames) {
    const Layout before = stage.editor.layout();
    stage.frame();
    REQUIRE(nothingMoves());
    // Only the last one is another picture.
    REQUIRE((stage.editor.atRest() || sameLayout(before, stage.editor.layout())));
    REQUIRE(frames < 100);
  }
}

TEST_CASE("a hand that lets go of the camera ends the movement: the lines rest soon after") {
  EditorStage stage;
  const Vec2 from{500, 900};
  REQUIRE(stage.down(from) == PointerTarget::kCamera);
  for (int i = 1; i <= 60; ++i) {
    stage.move(from + Vec2(4.0 * i, 0));
    stage.frame();
  }
  // While it holds the camera still the lines stay where they are, however long.
  for (int i = 0; i < 12; ++i) stage.frame();
  const Layout held = stage.editor.layout();
  requireNothingMoves(stage);
  stage.up(from + Vec2(240, 0));
  REQUIRE_FALSE(stage.editor.atRest());
  REQUIRE(stage.settle() <= 14 + kRoundsSettling);  // as many frames in which they settle, 180 ms and a frame
  REQUIRE_FALSE(sameLayout(held, stage.editor.layout()));
  requireNothingMoves(stage);
}

TEST_CASE("after a leap to another view the lines settle at once") {
  EditorStage stage;
  for (int i = 1; i <= 6; ++i) {
    REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 14, 35 + 100.0 * i, 20)));
    stage.frame();
    CHECK(stage.settle() <= 14 + kRoundsSettling);
  }
}

TEST_CASE("without a hand a movement is over when the camera has stood still for a while") {
  EditorStage stage;
  turnInFrames(stage, 40);
  // Not between two steps a quarter of a second apart.
  for (int step = 0; step < 3; ++step) {
    REQUIRE(stage.editor.setCamera(orbitCamera({0, 2, 0}, 30, 117 + 0.01 * step, 20)));
    stage.frame();
    const Layout before = stage.editor.layout();
    for (int i = 0; i < 15; ++i) stage.frame();
    REQUIRE(sameIdentities(before.lines, stage.editor.layout().lines));
  }
  const Layout before = stage.editor.layout();
  stage.settle();
  REQUIRE_FALSE(sameIdentities(before.lines, stage.editor.layout().lines));
}

TEST_CASE("who takes hold of a line takes the picture as it is: nothing settles when it is let go of") {
  EditorStage stage;
  turnInFrames(stage, 40);
  for (int i = 0; i < 15; ++i) stage.frame();
  REQUIRE_FALSE(stage.editor.atRest());
  const Vec2 at = stage.handle("Height");
  REQUIRE(stage.down(at) == PointerTarget::kHandle);
  stage.frame();
  const Layout held = stage.editor.layout();
  stage.up(at);
  stage.settle();
  REQUIRE(sameIdentities(held.lines, stage.editor.layout().lines));
}

TEST_CASE("hidden and shown again, the picture is as it was: what was taken as it is does not settle") {
  EditorStage stage;
  turnInFrames(stage, 40);
  const Vec2 at = stage.handle("Height");
  stage.down(at);
  stage.frame();
  stage.up(at);
  stage.settle();
  const Layout before = stage.editor.layout();
  stage.editor.resize(0, 0, 1);
  stage.frame();
  stage.editor.resize(1000, 1000, 1);
  stage.settle();
  CHECK(sameLayout(before, stage.editor.layout()));
}

TEST_CASE("labels are laid out once an edit is over: when the hand lets go, or nothing has been edited for a while") {
  EditorStage stage;
  const Vec2 at = stage.handle("Height");
  stage.down(at);
  stage.frame();
  stage.move(at + Vec2(0, -30));
  stage.frame();
  stage.up(at + Vec2(0, -30));
  CHECK(stage.settle() <= 14);   // 180 ms and two frames
  stage.set("Height", 3);
  CHECK(stage.settle() >= 350 / 16);
  requireNothingMoves(stage);
}

TEST_CASE("a value that changes moves its line at once, without lagging behind the model") {
  EditorStage stage;
  for (int i = 1; i <= 20; ++i) {
    stage.editor.setValueContinuous(stage.indexOf("Height"), 5 + 0.05 * i);
    stage.frame();
    const PlacedLine& line = *stage.line("Height");
    REQUIRE(line.line.length() == Approx(5 + 0.05 * i));
    REQUIRE(line.base.length() == Approx(5 + 0.05 * i));
  }
}

TEST_CASE("two editors given the same do the same, bit for bit") {
  EditorStage one;
  EditorStage two;
  for (int i = 0; i < 40; ++i) {
    for (EditorStage* stage : {&one, &two}) {
      REQUIRE(stage->editor.setCamera(orbitCamera({0, 2, 0}, 30, 9.0 * i, 20)));
      stage->frame();
    }
    REQUIRE(sameLayout(one.editor.layout(), two.editor.layout()));
  }
}

TEST_CASE("frames of an orbit allocate nothing once the orbit has been flown") {
  EditorStage stage;
  const auto fly = [&] { return allocatedInFlight(stage, 90, 1, [](int i) { return orbitCamera({0, 2, 0}, 30, 4.0 * i, 20); }); };
  fly();
  fly();
  REQUIRE(fly() == 0);
}
