#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <memory>

#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// What a placer keeps from one frame to the next, and when it forgets.

TEST_CASE("what is kept, and what is mended, stays before a still camera") {
  Stage stage(boxWithDoor());
  for (double azimuth = 0; azimuth < 360; azimuth += 1) {
    const Camera camera = orbitCamera({0, 2.5, 0}, 30, azimuth, 22);
    const std::vector<PlacedLine> moved = stage.look(camera).lines;
    for (int frame = 0; frame < 2; ++frame) {
      stage.look(camera);
      REQUIRE(stage.layout.lines.size() == moved.size());
      for (std::size_t i = 0; i < moved.size(); ++i) CHECK(stage.layout.lines[i].lineScreen.end == moved[i].lineScreen.end);
    }
  }
}

TEST_CASE("a view that turns far in one frame begins anew") {
  Stage stage(boxWithDoor());
  for (double azimuth = 0; azimuth <= 80; azimuth += 1) stage.look(orbitCamera({0, 2.5, 0}, 30, azimuth, 20));
  Stage fresh(boxWithDoor());
  const Camera behind = orbitCamera({0, 2.5, 0}, 30, 215, 35);
  stage.look(behind);
  fresh.look(behind);
  REQUIRE(stage.layout.lines.size() == fresh.layout.lines.size());
  for (std::size_t i = 0; i < fresh.layout.lines.size(); ++i) {
    CHECK(stage.layout.lines[i].identity == fresh.layout.lines[i].identity);
    CHECK(stage.layout.lines[i].lineScreen.end == fresh.layout.lines[i].lineScreen.end);
  }
}

TEST_CASE("while the camera turns, lines keep their places where frames on their own would change them") {
  Stage stage(boxWithDoor());
  int changes = 0;
  int changesOnTheirOwn = 0;
  std::vector<PlacedLine> last;
  std::vector<PlacedLine> lastOnItsOwn;
  const auto changed = [](const std::vector<PlacedLine>& from, const std::vector<PlacedLine>& to) {
    return static_cast<int>(std::ranges::count_if(to, [&](const PlacedLine& line) {
      const auto was = std::ranges::find(from, line.parameter, &PlacedLine::parameter);
      return was != from.end() && was->identity != line.identity;
    }));
  };
  Stage onItsOwn(boxWithDoor());
  for (double azimuth = 0; azimuth < 360; azimuth += 1) {
    const Camera camera = orbitCamera({0, 2.5, 0}, 30, azimuth, 22);
    changes += changed(last, stage.look(camera).lines);
    last = stage.layout.lines;
    onItsOwn.placer.forget();
    changesOnTheirOwn += changed(lastOnItsOwn, onItsOwn.look(camera).lines);
    lastOnItsOwn = onItsOwn.layout.lines;
  }
  CHECK(changes > 0);
  CHECK(changes < changesOnTheirOwn);
}

TEST_CASE("a model with another annotation is another one: of its lines nothing is remembered") {
  ModelDefinition other = boxWithDoor();
  other.parameters[4].annotation = "@Handle(scope=Door, type=linear-center, orient=up, slip=billboard, color=#112233)";
  const auto differing = [](const Stage& a, const Stage& b) {
    return std::ranges::count_if(a.layout.lines, [&](const PlacedLine& line) { return b.find(a.nameOf(line)) == nullptr || b.find(a.nameOf(line))->identity != line.identity; });
  };
  std::ptrdiff_t remembered = 0;
  for (double azimuth = 10; azimuth < 360; azimuth += 10) {
    const Camera camera = orbitCamera({0, 2.5, 0}, 30, azimuth, 22);
    const auto arrive = [&](const ModelDefinition& at) {
      Stage stage(boxWithDoor());
      for (double before = 15; before > 0; before -= 1) stage.look(orbitCamera({0, 2.5, 0}, 30, azimuth - before, 22));
      stage.model = makeModel(at).value();
      stage.rebuild();
      stage.look(camera);
      return stage;
    };
    Stage fresh(boxWithDoor());
    fresh.look(camera);
    remembered += differing(arrive(boxWithDoor()), fresh);
    CHECK(differing(arrive(other), fresh) == 0);
  }
  CHECK(remembered > 0);
}

TEST_CASE("in a viewport of another size, and the same shape, lines lie no further out than in one of that size from the start") {
  Stage stage(boxWithDoor());
  const Camera camera = orbitCamera({0, 2.5, 0}, 30, 35, 22);
  stage.look(camera, 500, 500);
  stage.look(camera, 1000, 1000);
  Stage fresh(boxWithDoor());
  fresh.look(camera, 1000, 1000);
  REQUIRE(stage.layout.lines.size() == fresh.layout.lines.size());
  REQUIRE_FALSE(fresh.layout.lines.empty());
  for (const PlacedLine& line : fresh.layout.lines) {
    INFO(fresh.nameOf(line));
    REQUIRE(stage.find(fresh.nameOf(line)) != nullptr);
    CHECK(glm::length(stage.find(fresh.nameOf(line))->lineScreen.end - line.lineScreen.end) < 1e-6);
  }
}

namespace {

/// Width and Depth cross in the middle of the box, but for someone who looks along one of them.
ModelDefinition boxWithCrossingLines() {
  ModelDefinition definition = boxWithDoor();
  definition.parameters[0].annotation = "@Handle(scope=Box, type=linear-center, orient=right, slip=none, occlusion=false)";
  definition.parameters[2].annotation = "@Handle(scope=Box, type=linear-center, orient=back, slip=none, occlusion=false)";
  return definition;
}

std::ptrdiff_t crowdedIn(const Layout& layout) { return std::ranges::count(layout.hidden, HiddenReason::kCrowded, &HiddenParameter::reason); }

}  // namespace

TEST_CASE("who forgets, forgets as well which lines were too many") {
  const ModelDefinition definition = boxWithCrossingLines();
  const auto from = [](double azimuth, double elevation) { return orbitCamera({0, 1.5, 0}, 40, azimuth, elevation); };
  Stage fresh(definition);
  const auto ofItself = crowdedIn(fresh.look(from(0, 0), 240, 160));
  std::ptrdiff_t most = 0;
  for (double azimuth = 0; azimuth < 360; azimuth += 10) {
    Stage stage(definition);
    most = std::max(most, crowdedIn(stage.look(from(azimuth, 60), 240, 160)));
    stage.placer.forget();
    CHECK(crowdedIn(stage.look(from(0, 0), 240, 160)) == ofItself);
  }
  CHECK(most > ofItself);   // or nothing was there to be forgotten
}

TEST_CASE("a line that had to go in a small viewport comes back when there has been room for it for a while") {
  Stage stage(boxWithCrossingLines());
  const auto look = [&](double azimuth, double elevation) { return crowdedIn(stage.look(orbitCamera({0, 1.5, 0}, 40, azimuth, elevation), 240, 160)); };
  const auto crowded = look(25, 20);
  REQUIRE(crowded > 0);
  for (int frame = 0; frame < kPatienceSmallViewportFrames; ++frame) CHECK(look(3 - 0.1 * frame, 2) == crowded);
  CHECK(look(0, 2) < crowded);
  // And not when the room was there for a moment only.
  REQUIRE(look(25, 20) == crowded);
  for (int frame = 0; frame < kPatienceSmallViewportFrames; ++frame) look(3 - 0.1 * frame, 2);
  CHECK(look(25, 20) == crowded);
  CHECK(look(3, 2) == crowded);
}

TEST_CASE("in a viewport that is too small a line that would run into another is hidden, and never in one that is not") {
  Stage stage(boxWithDoor());
  std::ptrdiff_t crowded = 0;
  for (double azimuth = 0; azimuth < 360; azimuth += 2) {
    for (const auto& [width, height] : {std::pair(240.0, 160.0), std::pair(1000.0, 1000.0)}) {
      const Layout& layout = stage.look(orbitCamera({0, 1.5, 0}, 9, azimuth, 12), width, height);   // so near that lines stay inside
      if (width == 1000) CHECK(crowdedIn(layout) == 0);
      crowded += crowdedIn(layout);
      if (width < 1000) {
        for (std::size_t a = 0; a < layout.lines.size(); ++a) {
          for (std::size_t b = 0; b < a; ++b) CHECK_FALSE(segmentsCross(layout.lines[a].lineScreen, layout.lines[b].lineScreen, kCrossingPx));
        }
      }
    }
  }
  CHECK(crowded > 0);
}

TEST_CASE("in a viewport that is too small a line that would run through another's number is hidden") {
  // A short line whose number stands beside it or over it, between poles that have one place each.
  ModelDefinition definition = boxWithDoor();
  definition.parameters[0].annotation = "@Handle(scope=Post, type=linear-contour, orient=right, slip=scope)";
  const std::array<const char*, 4> poles = {"Height", "Depth", "DoorWidth", "DoorHeight"};
  for (std::size_t i = 0; i < poles.size(); ++i) definition.parameters[i + 1].annotation = std::string("@Handle(scope=") + poles[i] + ", type=linear-center, orient=up, slip=none)";
  definition.build = [poles](const Values&) {
    Scene scene = sceneOf({{"Post", boxAt({-0.25, 0, -0.25}, {0.5, 1, 0.5})}});
    for (std::size_t i = 0; i < poles.size(); ++i) scene.scopes.push_back({poles[i], 0, boxAt({0.9 * (static_cast<double>(i) - 1.5), 0.4, 0}, {0.01, 7.2, 0.01})});
    return scene;
  };
  Stage stage(definition);
  stage.look(straightAt(4, 8), 240, 160);
  REQUIRE(stage.find("Width") != nullptr);
  REQUIRE(stage.find("Width")->label.has_value());
  for (const PlacedLine& line : stage.layout.lines) {
    INFO(stage.nameOf(line));
    if (line.parameter != 0) CHECK_FALSE(meets(line.lineScreen, *stage.find("Width")->label));
  }
  CHECK(crowdedIn(stage.layout) > 0);
  CHECK(stage.look(straightAt(4, 8)).lines.size() == 1 + poles.size());
}

TEST_CASE("lines lie again where they lay in a picture that is recalled, whatever other scene was looked at since") {
  const auto blocks = std::make_shared<int>(5);
  Stage stage(measuring({"@Handle(scope=Block, type=linear-contour, orient=up, slip=object)"}, [blocks](const Values&) {
    const std::array<Obb, 5> all = {boxAt({0, 0, 0}, {1, 3, 1}), boxAt({5, 0, 1}, {1, 3, 1}), boxAt({6, 0, 5}, {1, 3, 1}), boxAt({2, 0, 8}, {1, 3, 1}), boxAt({-3, 0, 4}, {1, 3, 1})};
    if (*blocks == 1) return sceneOf({{"Block", all[0]}});
    return sceneOf({{"Block", all[0]}, {"Block", all[1]}, {"Block", all[2]}, {"Block", all[3]}, {"Block", all[4]}});
  }));
  const auto turned = [](double azimuthDeg) { return orbitCamera({2, 1.5, 4}, 40, azimuthDeg, 25); };
  for (int frame = 0; frame < 5; ++frame) stage.look(turned(frame));
  const Placer::Memory memory = stage.placer.memory();
  REQUIRE(stage.find("Width") != nullptr);
  const Segment2 there = stage.find("Width")->lineScreen;

  // Another scene, with fewer object planes, before a camera that turns; then back, by way of the memory.
  *blocks = 1;
  stage.rebuild();
  for (int frame = 5; frame < 9; ++frame) stage.look(turned(frame));
  *blocks = 5;
  stage.rebuild();
  stage.placer.recall(memory);
  stage.look(turned(4));
  REQUIRE(stage.find("Width") != nullptr);
  CHECK(glm::length(stage.find("Width")->lineScreen.start - there.start) < 1e-9);
  CHECK(glm::length(stage.find("Width")->lineScreen.end - there.end) < 1e-9);
}
