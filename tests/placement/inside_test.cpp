#include <catch2/catch.hpp>

#include <optional>

#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

// Lines that lie on their base lines, where there is no room outside: mostly in views from near by.

namespace {

constexpr const char* kAcrossPlate = "@Handle(scope=Plate, type=linear-center, orient=right, slip=scope)";

/// A wall that fills every picture of it from near by, with a short line across its middle, and a mast of the wall's height before it.
ModelDefinition wallWithMast() {
  return measuring({kAcrossPlate, "@Handle(scope=Mast, type=linear-center, orient=up, slip=scope)"}, [](const Values&) {
    return sceneOf({{"Wall", boxAt({-20, -10, -1}, {40, 20, 1})}, {"Plate", boxAt({-0.5, -0.1, 0}, {1, 0.2, 0.1})}, {"Mast", boxAt({-0.1, -10, 0}, {0.2, 20, 0.1})}});
  });
}

/// The same wall, with a short line near its top, which goes up and out, and a rail along it at a height, so long (m): mostly it leads out of the picture.
ModelDefinition wallWithRail(double heightM, double lengthM = 40) {
  return measuring({kAcrossPlate, "@Handle(scope=Rail, type=linear-center, orient=right, slip=none)"}, [heightM, lengthM](const Values&) {
    return sceneOf({{"Wall", boxAt({-20, -10, -1}, {40, 20, 1})}, {"Plate", boxAt({-0.5, 8.9, 0}, {1, 0.2, 0.1})}, {"Rail", boxAt({-lengthM / 2, heightM, 0}, {lengthM, 0.1, 0.1})}});
  });
}

/// How much of that wall is seen (m).
constexpr double kSeenM = 4;

}  // namespace

TEST_CASE("zoomed in until the silhouette leaves the viewport, lines lie on their base lines") {
  Stage stage(boxWithDoor());
  Camera camera = orbitCamera({0, 1, 3}, 3.5, 10, 5);
  const Layout& layout = stage.look(camera);
  REQUIRE_FALSE(layout.lines.empty());
  for (const PlacedLine& line : layout.lines) {
    CHECK(line.placement == PlacementKind::kInside);
    CHECK(line.planeKind == PlaneKind::kNone);
    CHECK(line.line.start == line.base.start);
    CHECK(line.extensionStart.empty());
  }
  CHECK(stage.find("DoorHeight") != nullptr);
}

TEST_CASE("inside the model, a line that leads out of the picture gives way to one that it would run across") {
  Stage stage(wallWithMast());
  stage.look(straightAt(0, kSeenM));
  REQUIRE(stage.find("Width") != nullptr);
  CHECK(stage.find("Width")->placement == PlacementKind::kInside);
  CHECK(stage.find("Height") == nullptr);
  REQUIRE(stage.layout.hidden.size() == 1);
  CHECK(stage.layout.hidden[0].reason == HiddenReason::kOutOfView);
  // All hidden handles are shown on demand, this one too.
  stage.placer.showHidden(true);
  stage.look(straightAt(0, kSeenM));
  CHECK(stage.find("Height") != nullptr);
}

TEST_CASE("inside the model, a line that leads out of the picture gives way to another's extension lines, but not at once when it has just come") {
  Stage stage(wallWithRail(9.5));
  stage.look(straightAt(9, kSeenM));
  REQUIRE(stage.find("Width") != nullptr);
  CHECK(stage.find("Width")->placement == PlacementKind::kOutside);
  CHECK(stage.find("Height") == nullptr);

  Stage below(wallWithRail(8.5));
  below.look(straightAt(9, kSeenM));
  REQUIRE(below.find("Height") != nullptr);
  CHECK(below.find("Height")->placement == PlacementKind::kInside);

  // At first the plate is out of the picture.
  Stage moving(wallWithRail(9.5));
  moving.look(straightAt(11.1, kSeenM));
  REQUIRE(moving.find("Height") != nullptr);
  REQUIRE(moving.find("Width") == nullptr);
  int frames = 0;
  for (; moving.find("Height") != nullptr && frames < 100; ++frames) {
    moving.look(straightAt(10.9 - 0.01 * frames, kSeenM));
    REQUIRE(moving.find("Width") != nullptr);
  }
  // The first picture, placed in two rounds, counts as one frame more.
  CHECK(frames == kDwellFrames - 1);
}

TEST_CASE("inside the model, a line of what is mostly hidden gives way to another's extension lines, and one that is there already only when less is seen") {
  const auto seen = [](double railShare) { return ScopeVisibility{.seenShare = {1, 1, static_cast<float>(railShare)}, .seenEdges = {}}; };
  const auto lookAtRail = [&](Stage& stage, double heightM, double railShare) {
    const ScopeVisibility visibility = seen(railShare);
    stage.look(straightAt(heightM, kSeenM), 1000, 1000, &visibility);
    REQUIRE(stage.find("Width") != nullptr);
    return stage.find("Height");
  };
  for (const double heightM : {8.5, 9.5}) {   // below the plate, and above it, where its extension lines are
    Stage hidden(wallWithRail(heightM, 3));
    CHECK((lookAtRail(hidden, 9, 0.9 * kSeenShareInPlainView) != nullptr) == (heightM < 9));
    if (heightM > 9) CHECK(hidden.layout.hidden.at(0).reason == HiddenReason::kOccluded);
    Stage plain(wallWithRail(heightM, 3));
    CHECK(lookAtRail(plain, 9, kSeenShareInPlainView) != nullptr);
  }
  Stage stage(wallWithRail(9.5, 3));
  double heightM = 9;
  const auto look = [&](double railShare) { return lookAtRail(stage, heightM -= 0.002, railShare); };
  for (int frame = 0; frame < 2 * kDwellFrames; ++frame) REQUIRE(look(1) != nullptr);
  CHECK(look(1.1 * kSeenShareToStayInPlainView) != nullptr);
  CHECK(look(0.9 * kSeenShareToStayInPlainView) == nullptr);
  // When it is seen better again it is back at once.
  CHECK(look(1.1 * kSeenShareToStayInPlainView) == nullptr);
  CHECK(look(kSeenShareInPlainView) != nullptr);
}

TEST_CASE("inside the model, a line that waits for its room to last is hidden for what keeps it from plain view") {
  const ScopeVisibility mostlyHidden{.seenShare = {1, 1, 0.9F * static_cast<float>(kSeenShareInPlainView)}, .seenEdges = {}};
  Stage stage(wallWithRail(9.5, 3));
  stage.look(straightAt(9, kSeenM), 1000, 1000, &mostlyHidden);
  REQUIRE(stage.find("Height") == nullptr);   // the plate's extension lines are there
  int waited = 0;
  for (double heightM = 11.1; stage.find("Height") == nullptr && waited < 100; heightM += 0.01, ++waited) {
    stage.look(straightAt(heightM, kSeenM), 1000, 1000, &mostlyHidden);
    REQUIRE(stage.find("Width") == nullptr);
    if (stage.find("Height") == nullptr) CHECK(stage.layout.hidden.back().reason == HiddenReason::kOccluded);
  }
  CHECK(waited > kPatienceFrames);
  CHECK(waited < 100);
}

TEST_CASE("inside the model, a line that gave way comes back when it has had room for a while, and not before a still camera") {
  Stage stage(wallWithMast());
  stage.look(straightAt(0, kSeenM));
  REQUIRE(stage.find("Height") == nullptr);
  // The short line is out of the picture at once.
  int frames = 0;
  for (; stage.find("Height") == nullptr && frames < 100; ++frames) {
    stage.look(straightAt(4 + 0.01 * frames, kSeenM));
    REQUIRE(stage.find("Width") == nullptr);
    for (int still = 0; frames == 3 && still < 40; ++still) {
      stage.look(straightAt(4 + 0.01 * frames, kSeenM));
      REQUIRE(stage.find("Height") == nullptr);
    }
  }
  CHECK(frames > kPatienceFrames);
  CHECK(frames <= kPatienceFrames + 2);
  // What has never given way is shown at once.
  Stage fresh(wallWithMast());
  fresh.look(straightAt(4, kSeenM));
  CHECK(fresh.find("Height") != nullptr);
}

TEST_CASE("inside the model, a line that is cut off comes when it has had room for a while, one that is whole at once") {
  Stage stage(wallWithMast());
  // Above the wall; then the mast is in the picture, but not from end to end.
  stage.look(straightAt(14, kSeenM));
  REQUIRE(stage.find("Height") == nullptr);
  int frames = 0;
  for (; stage.find("Height") == nullptr && frames < 100; ++frames) stage.look(straightAt(4 + 0.01 * frames, kSeenM));
  CHECK(frames > kPatienceFrames);
  CHECK(frames <= kPatienceFrames + 2);

  Stage other(wallWithMast());
  other.look(straightAt(4, kSeenM));
  REQUIRE(other.find("Width") == nullptr);
  other.look(straightAt(0, kSeenM));
  CHECK(other.find("Width") != nullptr);
}

TEST_CASE("inside the model, a line of what is seen in part does not come in place of one that is there, and one of what is in plain view does") {
  Stage stage(wallWithMast());
  ScopeVisibility visibility{.seenShare = {1, 0, 1}, .seenEdges = {}};
  double heightM = 0;
  const auto look = [&](double plateShare) {
    visibility.seenShare[1] = static_cast<float>(plateShare);
    stage.look(straightAt(heightM += 0.001, kSeenM), 1000, 1000, &visibility);
  };
  look(0);
  for (int frame = 0; frame < kReturnFrames + 2 * kPatienceFrames; ++frame) {
    look(0.9 * kSeenShareInPlainView);
    REQUIRE(stage.find("Height") != nullptr);
    CHECK(stage.find("Width") == nullptr);
  }
  look(1);
  CHECK(stage.find("Height") == nullptr);
  CHECK(stage.find("Width") != nullptr);
}

TEST_CASE("inside the model, a line that comes takes a whole base line at once rather than wait with a longer one that is cut off, and keeps it before a still camera") {
  ModelDefinition definition = wallWithMast();
  definition.build = [](const Values&) {
    return sceneOf({{"Wall", boxAt({-20, -10, -1}, {40, 20, 1})}, {"Plate", boxAt({-3, 0.5, 0}, {6, 0.2, 0.1})}, {"Plate", boxAt({-0.5, -0.5, 0}, {1, 0.2, 0.1})}});
  };
  Stage stage(definition);
  stage.look(straightAt(14, kSeenM));
  REQUIRE(stage.find("Width") == nullptr);
  for (int frame = 0; frame < 3; ++frame) {
    stage.look(straightAt(0, kSeenM));
    REQUIRE(stage.find("Width") != nullptr);
    CHECK(stage.find("Width")->placement == PlacementKind::kInside);
    CHECK(stage.find("Width")->baseScreen.length() < 0.5 * stage.layout.view.viewport().max.x);
  }
  // Who has been there from the start may as well be on the longer one.
  Stage fresh(definition);
  fresh.look(straightAt(0, kSeenM));
  REQUIRE(fresh.find("Width") != nullptr);
  CHECK(fresh.find("Width")->baseScreen.length() > fresh.layout.view.viewport().max.x);
}

TEST_CASE("inside the model, lines lie on edges that are seen rather than behind it") {
  ModelDefinition definition = boxWithDoor();
  for (Parameter& parameter : definition.parameters) parameter.annotation.replace(parameter.annotation.find("slip="), std::string::npos, "slip=none)");
  Stage stage(definition);
  for (double azimuth = 5; azimuth < 360; azimuth += 10) {
    stage.placer.forget();
    stage.look(orbitCamera({0, 2.5, 0}, 30, azimuth, 15));
    for (const std::string_view name : {"Width", "Height", "Depth"}) {
      const PlacedLine* line = stage.find(name);
      REQUIRE(line != nullptr);
      REQUIRE(line->placement == PlacementKind::kInside);
      // The box is convex: an edge is seen when one of the two faces that it bounds is.
      const Vec3 middle = line->base.middle() - Vec3(0, 2.5, 0);
      const Vec3 toEye = stage.layout.view.camera().eye - line->base.middle();
      bool seen = false;
      for (int axis = 0; axis < 3; ++axis) seen = seen || (std::abs(middle[axis]) > 0.1 && middle[axis] * toEye[axis] > 0);
      INFO(name << " at " << azimuth);
      CHECK(seen);
    }
  }
}

TEST_CASE("inside the model, no line is begun on an edge that the model hides, unless what it measures is in plain view") {
  const auto wallWithPost = [](double heightM) {
    return measuring({kAcrossPlate, "@Handle(scope=Post, type=linear-contour, orient=up, slip=none)"}, [heightM](const Values&) {
      Scene scene = sceneOf({{"Wall", boxAt({-20, -10, -1}, {40, 20, 1})}, {"Plate", boxAt({-0.5, -0.1, 0}, {1, 0.2, 0.1})}});
      scene.scopes.push_back({"Post", 0, boxAt({1, -heightM / 2, -0.5}, {0.4, heightM, 0.5})});
      return scene;
    });
  };
  const auto look = [](Stage& stage, double heightM, SeenEdges edges) {
    const ScopeVisibility visibility{.seenShare = {1, 1, 1}, .seenEdges = {SeenEdges::all(), SeenEdges::all(), edges}};
    stage.look(straightAt(heightM, kSeenM), 1000, 1000, &visibility);
    return stage.find("Height");
  };
  for (const double heightM : {1.0, 20.0}) {
    Stage hidden(wallWithPost(heightM));
    INFO(heightM << " m");
    CHECK((look(hidden, 0, SeenEdges(0)) != nullptr) == (heightM < kSeenM));
    Stage seen(wallWithPost(heightM));
    CHECK(look(seen, 0, SeenEdges::all()) != nullptr);
  }
  // Where it is, it stays: what passes before it for a moment is no reason to go.
  Stage stage(wallWithPost(20));
  REQUIRE(look(stage, 0, SeenEdges::all()) != nullptr);
  for (int frame = 1; frame < 2 * kDwellFrames; ++frame) CHECK(look(stage, 0.002 * frame, SeenEdges(0)) != nullptr);
  // On demand it is shown, behind the wall or not.
  Stage demanded(wallWithPost(20));
  REQUIRE(look(demanded, 0, SeenEdges(0)) == nullptr);
  CHECK(demanded.layout.hidden.at(0).reason == HiddenReason::kOutOfView);
  demanded.placer.showHidden(true);
  CHECK(look(demanded, 0, SeenEdges(0)) != nullptr);
}

TEST_CASE("inside the model, a line of a row lies where more of what it measures is seen, and stays there") {
  ModelDefinition definition = wallWithMast();
  definition.build = [](const Values&) {
    return sceneOf({{"Wall", boxAt({-20, -10, -1}, {40, 20, 1})}, {"Plate", boxAt({-1.5, 0, 0}, {1, 0.2, 0.1})}, {"Plate", boxAt({0.5, 0, 0}, {1, 0.2, 0.1})}});
  };
  for (const std::size_t plain : {1, 2}) {
    Stage stage(definition);
    ScopeVisibility visibility;
    visibility.seenShare = {1, 0.4F, 0.4F};
    visibility.seenShare[plain] = 0.9F;
    stage.look(straightAt(0, kSeenM), 1000, 1000, &visibility);
    REQUIRE(stage.find("Width") != nullptr);
    CHECK(stage.find("Width")->scope == plain);
    // A little more of the other is no reason to leave.
    std::swap(visibility.seenShare[1], visibility.seenShare[2]);
    stage.look(straightAt(0.01, kSeenM), 1000, 1000, &visibility);
    REQUIRE(stage.find("Width") != nullptr);
    CHECK(stage.find("Width")->scope == plain);
  }
}

TEST_CASE("while the camera comes nearer, no line comes out of the model for a few frames") {
  Stage stage(boxWithDoor());
  int inside = 0;
  for (double azimuth = 0; azimuth < 90; azimuth += 5) {
    stage.placer.forget();
    std::vector<std::vector<PlacedLine>> frames;
    double distanceM = 28;
    for (int i = 0; i < 110; ++i, distanceM *= 0.983) frames.push_back(stage.look(orbitCamera({0, 2.5, 0}, distanceM, azimuth + 0.25 * i, 20)).lines);
    const auto insideIn = [&](std::size_t frame, std::size_t parameter) -> std::optional<bool> {
      const auto found = std::ranges::find(frames[frame], parameter, &PlacedLine::parameter);
      return found == frames[frame].end() ? std::nullopt : std::optional(found->placement == PlacementKind::kInside);
    };
    for (std::size_t parameter = 0; parameter < 5; ++parameter) {
      for (std::size_t i = 1; i + 5 < frames.size(); ++i) {
        inside += insideIn(i, parameter) == true ? 1 : 0;
        const bool comesOut = insideIn(i - 1, parameter) == true && insideIn(i, parameter) == false;
        if (!comesOut) continue;
        INFO("azimuth " << azimuth << ", frame " << i << ", parameter " << parameter);
        for (std::size_t k = i; k < i + 5; ++k) CHECK(insideIn(k, parameter) != true);
      }
    }
  }
  CHECK(inside > 100);
}

TEST_CASE("while the camera comes nearer, no line is shown inside the model for its feature's last moments") {
  Stage stage(boxWithDoor());
  int begun = 0;
  for (double azimuth = 0; azimuth < 90; azimuth += 5) {
    stage.placer.forget();
    std::array<Identity, 5> last{};
    std::array<int, 5> held{};
    double distanceM = 28;
    for (int i = 0; i < 150; ++i, distanceM *= 0.983) {
      stage.look(orbitCamera({0, 2.5, 0}, distanceM, azimuth + 0.25 * i, 20));
      std::array<Identity, 5> now{};
      for (const PlacedLine& line : stage.layout.lines) now[line.parameter] = line.identity;
      for (std::size_t p = 0; p < now.size(); ++p) {
        if (now[p] == last[p]) {
          ++held[p];
          continue;
        }
        INFO("azimuth " << azimuth << ", frame " << i << ", parameter " << p);
        const bool wasInside = last[p] != Identity{} && last[p].plane < 0;
        if (wasInside && now[p] == Identity{}) CHECK(held[p] >= 3);
        begun += now[p] != Identity{} && now[p].plane < 0 ? 1 : 0;
        held[p] = 0;
      }
      last = now;
    }
  }
  CHECK(begun > 20);
}

TEST_CASE("while the camera comes nearer, a line that has no room outside any more lies inside for as long as its feature is in plain view") {
  constexpr double kRightM = 1.6;   // where the wall and the plate end
  Stage stage(measuring({"@Handle(scope=Plate, type=linear-contour, orient=up, slip=scope)"}, [](const Values&) {
    return sceneOf({{"Wall", boxAt({-20, -10, -1}, {20 + kRightM, 20, 1})}, {"Plate", boxAt({kRightM - 0.2, -0.2, 0}, {0.2, 0.4, 0.1})}});
  }));
  int outside = 0, inside = 0;
  for (double seenM = 5; seenM > 2 * kRightM; seenM *= 0.97) {
    stage.look(straightAt(0, seenM));
    INFO(seenM << " m are seen");
    const PlacedLine* line = stage.find("Width");
    REQUIRE(line != nullptr);
    ++(line->placement == PlacementKind::kInside ? inside : outside);
  }
  CHECK(outside > 5);
  CHECK(inside > 2);
}

TEST_CASE("no line outside the model runs across one that stays on its base line") {
  // Nothing is drawn of the pole, so the silhouette does not know of it.
  Stage stage(measuring({"@Handle(scope=Box, type=linear-contour, orient=right, slip=scope, align=top)", "@Handle(scope=Pole, type=linear-center, orient=up, slip=none)"}, [](const Values&) {
    Scene scene = sceneOf({{"Box", boxAt({-4, 0, -3}, {8, 5, 6})}});
    scene.scopes.push_back({"Pole", 0, boxAt({-0.1, 5, 3}, {0.2, 4, 0.1})});
    finish(scene);
    return scene;
  }));
  for (double azimuth = -20; azimuth <= 20; azimuth += 1) {
    stage.look(orbitCamera({0, 2.5, 0}, 30, azimuth, 10));
    REQUIRE(stage.find("Width") != nullptr);
    REQUIRE(stage.find("Height") != nullptr);
    CHECK(stage.find("Width")->placement == PlacementKind::kOutside);
    CHECK_FALSE(segmentsCross(stage.find("Width")->lineScreen, stage.find("Height")->lineScreen, kCrossingPx));
  }
}

TEST_CASE("a line that has no room outside all of the model stands between two parts of it") {
  double apartM = 1;
  const ModelDefinition definition = measuring({"@Handle(scope=Window, type=linear-contour, orient=up, slip=scope)"}, [&](const Values&) {
    return sceneOf({{"Left", boxAt({-4, -6, -1}, {4 - apartM / 2, 12, 1})},
                    {"Right", boxAt({apartM / 2, -6, -1}, {4 - apartM / 2, 12, 1})},
                    {"Window", boxAt({-apartM / 2 - 0.6, -0.5, 0}, {0.5, 1, 0.02})}});
  });
  SECTION("where there is room for it") {
    // 250 px a metre: the towers fill the picture but for the columns from 375 to 625.
    Stage stage(definition);
    stage.look(straightAt(0, 4));
    REQUIRE(stage.layout.lines.size() == 1);
    const PlacedLine& line = stage.layout.lines[0];
    CHECK(line.placement == PlacementKind::kOutside);
    CHECK(line.lineScreen.middle().x >= 375 + kHandleSpacingPx - 0.5);
    CHECK(line.lineScreen.middle().x <= 625 - kHandleSpacingPx);
    // What a still camera shows never moves.
    const Segment2 before = line.lineScreen;
    stage.look(straightAt(0, 4));
    CHECK(stage.layout.lines[0].lineScreen.start == before.start);
  }
  SECTION("but not where there is hardly any") {
    apartM = 0.26;   // 65 px, of which 5 are left
    Stage stage(definition);
    stage.look(straightAt(0, 4));
    REQUIRE(stage.layout.lines.size() == 1);
    CHECK(stage.layout.lines[0].placement == PlacementKind::kInside);
  }
}

TEST_CASE("inside the model, a line comes out to an object plane when it has had room there for a while, to its scope's plane at once") {
  const auto block = [](const char* slip) {
    return measuring({std::string("@Handle(scope=Block, type=linear-contour, orient=up, slip=") + slip + ")"},
                     [](const Values&) { return sceneOf({{"Block", boxAt({-1, -1, -1}, {2, 2, 2})}}); });
  };
  const auto framesUntilOutside = [](Stage& stage) {
    // The block fills the picture; then it is seen with room all round.
    stage.look(straightAt(0, 2.02));
    REQUIRE(stage.layout.lines.size() == 1);
    REQUIRE(stage.layout.lines[0].placement == PlacementKind::kInside);
    int frames = 0;
    do {
      stage.look(straightAt(0.001 * frames, 4));
      REQUIRE(stage.layout.lines.size() == 1);
      ++frames;
      // Before a still camera it waits.
      for (int still = 0; frames == 3 && still < 40; ++still) {
        const PlacementKind before = stage.layout.lines[0].placement;
        stage.look(straightAt(0.001 * (frames - 1), 4));
        REQUIRE(stage.layout.lines[0].placement == before);
      }
    } while (stage.layout.lines[0].placement == PlacementKind::kInside && frames < 100);
    return frames;
  };
  Stage object(block("object"));
  CHECK(framesUntilOutside(object) == kPatienceFrames + 1);
  CHECK(object.layout.lines[0].planeKind == PlaneKind::kObject);
  Stage scope(block("scope"));
  CHECK(framesUntilOutside(scope) == 1);
  // In a first picture there is nothing to wait for.
  Stage fresh(block("object"));
  fresh.look(straightAt(0, 4));
  CHECK(fresh.layout.lines[0].placement == PlacementKind::kOutside);
}
