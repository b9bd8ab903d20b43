#include <catch2/catch.hpp>

#include <array>

#include "support/allocation_count.h"
#include "support/same_layout.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Distance of a segment on screen from the model: from the outlines of all its projected triangles, or 0 inside one. Shares nothing with the fields.
double distanceToModel(const Segment2& segment, const Scene& scene, const View& view) {
  double least = std::numeric_limits<double>::infinity();
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const auto& triangle : mesh.triangles) {
      std::array<Vec2, 3> p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = view.toScreen(Vec3(instance.transform * glm::vec4(mesh.positions[triangle[i]], 1.0F)));
      int positive = 0;
      int negative = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        least = std::min(least, distanceBetween(segment, Segment2{p[i], p[(i + 1) % 3]}));
        (cross(p[(i + 1) % 3] - p[i], segment.start - p[i]) > 0 ? positive : negative)++;
      }
      if (positive == 3 || negative == 3) least = 0;
    }
  }
  return least;
}

/// Two segments run beside each other where the shadow of one on the other is longer than a pixel.
bool besideEachOther(const Segment2& a, const Segment2& b) {
  const Vec2 d = glm::normalize(a.end - a.start);
  if (std::abs(cross(d, glm::normalize(b.end - b.start))) > 0.05) return false;
  const double b0 = glm::dot(b.start - a.start, d);
  const double b1 = glm::dot(b.end - a.start, d);
  return std::min(std::max(b0, b1), a.length()) - std::max(std::min(b0, b1), 0.0) > 1.0;
}

std::vector<Camera> cameras(const Vec3& target, double distanceM) {
  std::vector<Camera> all;
  for (const double elevation : {10.0, 30.0, 60.0}) {
    for (double azimuth = 0; azimuth < 360; azimuth += 7) all.push_back(orbitCamera(target, distanceM, azimuth, elevation));
  }
  return all;
}

struct WallPlan {
  double heightM;
  double plateM;            ///< of the plate over the wall's foot
  double baysM;             ///< of the bays
  std::string plateAlign;
};

/// A wall seen from the front with a chain of three bays, and a plate whose line, when both lie below, is run across by the extension lines between the bays.
ModelDefinition wallWithPlateAndBays(const WallPlan& plan) {
  ModelDefinition definition;
  definition.name = "wall";
  definition.title = "Wall";
  const auto length = [&](const char* name, double value, const std::string& annotation) {
    definition.parameters.push_back(
        {.name = name, .title = name, .unit = Unit::kMetre, .defaultValue = value, .min = 0.5, .max = 5, .step = 0.1, .annotation = annotation});
  };
  length("Plate", 1, "@Handle(scope=Plate, type=linear-center, orient=right, slip=scope, align=" + plan.plateAlign + ")");
  length("Bay", 3, "@Handle(scope=Bay, type=linear-contour, orient=right, slip=scope, chained)");
  definition.build = [plan](const Values& v) {
    const double bay = v.at(1);
    Scene scene = sceneOf({{"Wall", boxAt({-5, 0, -1}, {10, plan.heightM, 1})}, {"Plate", boxAt({1, plan.plateM, 0}, {v.at(0), 0.2, 0.05})}});
    for (std::uint32_t i = 0; i < 3; ++i) scene.scopes.push_back({"Bay", i, boxAt({-1.5 * bay + i * bay, plan.baysM, 0}, {bay, 1, 0.05})});
    return scene;
  };
  return definition;
}

/// A tower with rows of bays on its front and on its left side, so that a bay's width has a chain for each row.
ModelDefinition towerWithBays() {
  return measuring({"@Handle(scope=Bay, type=linear-contour, orient=right, slip=scope, chained)"}, [](const Values&) {
    Scene scene = sceneOf({{"Wall", boxAt({-12, -8, -8}, {24, 16, 16})}});
    std::uint32_t bays = 0;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 6; ++column) {
        const double y = -7.0 + 4 * row;
        for (const Obb& bay : {boxAt({-11.0 + 4 * column, y, 8}, {2, 2, 0.1}), boxAt({-12.1, y, -7.5 + 2.6 * column}, {0.1, 2, 1.5})}) {
          addBox(scene, bay);
          scene.scopes.push_back({"Bay", bays++, bay});
        }
      }
    }
    finish(scene);
    return scene;
  });
}

}  // namespace

TEST_CASE("on orbits, every line keeps handleSpacing from the model, and labels do not touch it") {
  Stage stage(boxWithDoor());
  std::size_t outside = 0;
  for (const Camera& camera : cameras(stage.scene.bounds.center(), 30)) {
    const Layout& layout = stage.look(camera);
    for (const PlacedLine& line : layout.lines) {
      INFO(stage.nameOf(line) << " from " << camera.eye.x << ", " << camera.eye.y << ", " << camera.eye.z);
      REQUIRE(line.placement == PlacementKind::kOutside);
      ++outside;
      CHECK(distanceToModel(line.lineScreen, stage.scene, layout.view) >= 29.5);
      REQUIRE(line.label.has_value());
      const Box2& b = *line.label;
      for (const Segment2& side : {Segment2{b.min, {b.max.x, b.min.y}}, Segment2{{b.max.x, b.min.y}, b.max}, Segment2{b.max, {b.min.x, b.max.y}},
                                   Segment2{{b.min.x, b.max.y}, b.min}}) {
        CHECK(distanceToModel(side, stage.scene, layout.view) >= 2.0);
      }
    }
  }
  CHECK(outside > 500);
}

TEST_CASE("on orbits, lines keep handleSpacing from each other, never cross, and their labels keep apart") {
  Stage stage(boxWithDoor());
  for (const Camera& camera : cameras(stage.scene.bounds.center(), 30)) {
    const Layout& layout = stage.look(camera);
    for (std::size_t i = 0; i < layout.lines.size(); ++i) {
      for (std::size_t j = i + 1; j < layout.lines.size(); ++j) {
        const PlacedLine& a = layout.lines[i];
        const PlacedLine& b = layout.lines[j];
        INFO(stage.nameOf(a) << " and " << stage.nameOf(b) << " from " << camera.eye.x << ", " << camera.eye.y << ", " << camera.eye.z);
        CHECK_FALSE(segmentsCross(a.lineScreen, b.lineScreen));
        if (besideEachOther(a.lineScreen, b.lineScreen)) CHECK(distanceBetween(a.lineScreen, b.lineScreen) >= 29.5);
        if (a.label && b.label) CHECK_FALSE(a.label->overlaps(*b.label));
        if (a.label) CHECK_FALSE(meets(b.lineScreen, *a.label));
        if (b.label) CHECK_FALSE(meets(a.lineScreen, *b.label));
      }
    }
  }
}

TEST_CASE("every parameter with a dimension line is shown or hidden, once") {
  Stage stage(boxWithDoor());
  for (const Camera& camera : cameras(stage.scene.bounds.center(), 30)) {
    const Layout& layout = stage.look(camera);
    std::vector<int> seen(stage.model.parameters().size(), 0);
    for (const PlacedLine& line : layout.lines) ++seen[line.parameter];
    for (const HiddenParameter& hidden : layout.hidden) ++seen[hidden.parameter];
    CHECK(seen == std::vector<int>(seen.size(), 1));
  }
}

TEST_CASE("a line is its base line moved in parallel, and its extension lines tie the two") {
  Stage stage(boxWithDoor());
  const Layout& layout = stage.look(orbitCamera({0, 2.5, 0}, 30, 35, 20));
  REQUIRE(layout.lines.size() == 5);
  for (const PlacedLine& line : layout.lines) {
    CHECK(glm::length((line.line.end - line.line.start) - (line.base.end - line.base.start)) < 1e-9);
    CHECK(std::abs(glm::dot(line.line.start - line.plane.point, line.plane.normal)) < 1e-9);
    CHECK(line.extensionStart.front() == line.baseScreen.start);
    CHECK(line.extensionEnd.back() == line.lineScreen.end);
    CHECK(line.lengthM == Approx(line.value));
    CHECK(line.handles.size() == 1);
    CHECK(line.handles[0].screen == line.lineScreen.end);
  }
}

TEST_CASE("an extension line that would lie on a dimension line runs a little beside it") {
  // The post's line is 30 px beside the wall, and there, 0.6 m beside it, the beam ends that is measured above the wall.
  const auto lookAt = [](double beamEndM) {
    Stage stage(measuring({"@Handle(scope=Post, type=linear-center, orient=up, slip=scope, align=right)", "@Handle(scope=Beam, type=linear-center, orient=right, slip=scope, align=top)"},
                          [beamEndM](const Values&) {
                            Scene scene = sceneOf({{"Wall", boxAt({-5, 0, -1}, {10, 16, 1})}, {"Post", boxAt({4.8, 14.5, 0}, {0.1, 1.4, 0.02})}});
                            scene.scopes.push_back({"Beam", 0, boxAt({beamEndM - 4, 14.2, 0}, {4, 0.02, 0.02})});
                            return scene;
                          }));
    stage.look(straightAt(8));
    REQUIRE(stage.layout.lines.size() == 2);
    REQUIRE(stage.layout.lines[0].lineScreen.start.x == Approx(780).margin(0.5));
    return stage.layout.lines[1];
  };
  const PlacedLine onIt = lookAt(5.6);
  CHECK(onIt.extensionStart.front() == onIt.baseScreen.start);
  for (const auto& [extension, line] : {std::pair(onIt.extensionEnd.front(), onIt.baseScreen.end), std::pair(onIt.extensionEnd.back(), onIt.lineScreen.end)}) {
    CHECK(extension.x == Approx(line.x - kExtensionAsidePx));
    CHECK(extension.y == Approx(line.y));
  }
  const PlacedLine besideIt = lookAt(5.66);
  CHECK(besideIt.extensionEnd.front() == besideIt.baseScreen.end);
  CHECK(besideIt.extensionEnd.back() == besideIt.lineScreen.end);
}

TEST_CASE("parameters are placed shortest first") {
  Stage stage(boxWithDoor());
  const Layout& layout = stage.look(orbitCamera({0, 2.5, 0}, 30, 35, 20));
  for (std::size_t i = 1; i < layout.lines.size(); ++i) CHECK(layout.lines[i - 1].lengthM <= layout.lines[i].lengthM);
}

TEST_CASE("a still camera never moves a line, and the same frames give the same bits") {
  Stage one(boxWithDoor());
  Stage two(boxWithDoor());
  for (const Camera& camera : cameras(one.scene.bounds.center(), 30)) {
    one.look(camera);
    const std::vector<PlacedLine> first = one.layout.lines;
    one.look(camera);
    two.look(camera);
    two.look(camera);
    REQUIRE(one.layout.lines.size() == first.size());
    REQUIRE(two.layout.lines.size() == first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (const PlacedLine* other : {&one.layout.lines[i], &two.layout.lines[i]}) {
        CHECK(other->identity == first[i].identity);
        CHECK(other->lineScreen.start == first[i].lineScreen.start);
        CHECK(other->lineScreen.end == first[i].lineScreen.end);
        CHECK(other->label->min == first[i].label->min);
      }
    }
  }
}

TEST_CASE("an orthographic camera gives lines parallel to their base lines on screen, 30 px or more outside") {
  Stage stage(boxWithDoor());
  Camera camera = orbitCamera(stage.scene.bounds.center(), 30, 35, 25);
  camera.orthoHeightM = 20;
  const Layout& layout = stage.look(camera);
  REQUIRE(layout.lines.size() == 5);
  for (const PlacedLine& line : layout.lines) {
    const Vec2 moved = line.lineScreen.end - line.lineScreen.start;
    const Vec2 base = line.baseScreen.end - line.baseScreen.start;
    CHECK(glm::length(moved - base) < 1e-6);
    CHECK(distanceToModel(line.lineScreen, stage.scene, layout.view) >= 29.5);
  }
}

TEST_CASE("a lone box seen orthographically from the front: the width line lies 30 px off, worked out by hand") {
  ModelDefinition definition = boxWithDoor();
  definition.parameters.resize(1);
  definition.build = [](const Values& v) {
    Scene scene;
    const Obb box = boxAt({-v.at(0) / 2, 0, -3}, {v.at(0), 5, 6});
    addBox(scene, box);
    scene.scopes.push_back({"Box", 0, box});
    finish(scene);
    return scene;
  };
  Stage stage(std::move(definition));
  Camera camera;
  camera.eye = {0, 2.5, 30};
  camera.target = {0, 2.5, 0};
  camera.orthoHeightM = 20;   // 50 px a metre; the box covers x 300..700, y 375..625
  const Layout& layout = stage.look(camera);
  REQUIRE(layout.lines.size() == 1);
  const PlacedLine& line = layout.lines[0];
  CHECK(line.lineScreen.start.x == Approx(300));
  CHECK(line.lineScreen.end.x == Approx(700));
  const double y = line.lineScreen.start.y;
  CHECK(line.lineScreen.end.y == Approx(y));
  // Above or below, as far as the front or the back face puts it; the padded field counts whole strips.
  CHECK((std::abs(y - 345) < 1.0 || std::abs(y - 655) < 1.0));
  CHECK(line.facing == Facing::kFront);
  REQUIRE(line.label);
  CHECK(line.label->center().x == Approx(500));
}

TEST_CASE("a chain keeps clear of a line that the extension lines of its inner members would run across") {
  Stage stage(wallWithPlateAndBays({.heightM = 6, .plateM = 1, .baysM = 1.5, .plateAlign = "bottom"}));
  const Layout& layout = stage.look(straightAt(3));
  const PlacedLine* plate = stage.find("Plate");
  const PlacedLine* bay = stage.find("Bay");
  REQUIRE(plate != nullptr);
  REQUIRE(bay != nullptr);
  REQUIRE(std::ranges::count(layout.lines, bay->chain, &PlacedLine::chain) == 3);
  CHECK(plate->lineScreen.start.y > 650);   // the wall covers y from 350 to 650
  CHECK(bay->lineScreen.start.y < 350);
}

TEST_CASE("a chain of which one member is left keeps clear of a line that this one's extension lines would run across") {
  Stage stage(wallWithPlateAndBays({.heightM = 6, .plateM = 1, .baysM = 1.5, .plateAlign = "bottom"}));
  ScopeVisibility visibility;
  visibility.seenShare = {1, 1, 0, 1, 0};   // wall, plate, and the three bays
  const Layout& layout = stage.look(straightAt(3), 1000, 1000, &visibility);
  const PlacedLine* plate = stage.find("Plate");
  const PlacedLine* bay = stage.find("Bay");
  REQUIRE(plate != nullptr);
  REQUIRE(bay != nullptr);
  REQUIRE(bay->chain >= 0);
  REQUIRE(std::ranges::count(layout.lines, bay->chain, &PlacedLine::chain) == 1);
  CHECK(plate->lineScreen.start.y > 650);   // the wall covers y from 350 to 650
  CHECK(bay->lineScreen.start.y < 350);
}

TEST_CASE("a chain stays with its row in an edited model, whatever the row's number is there") {
  // The row lies a little above the wall's foot; the edit puts another one below and before it, in a plane of its own, which comes first.
  ModelDefinition definition = boxWithDoor();
  definition.parameters = {{.name = "Bay", .title = "Bay", .unit = Unit::kMetre, .defaultValue = 2, .min = 1, .max = 3, .step = 0.1,
                            .annotation = "@Handle(scope=Bay, type=linear-center, orient=right, slip=scope, chained)"},
                           {.name = "Rows", .title = "Rows", .type = ParameterType::kInt, .defaultValue = 1, .min = 1, .max = 2}};
  definition.build = [](const Values& values) {
    Scene scene = sceneOf({{"Wall", boxAt({-5, 0, -1}, {10, 6, 1})}});
    std::uint32_t bays = 0;
    for (const double y : {0.5, 0.8}) {
      if (y < 0.6 && values.at(1) < 2) continue;
      for (int column = 0; column < 3; ++column) scene.scopes.push_back({"Bay", bays++, boxAt({-3.0 + column * values.at(0), y, y < 0.6 ? 1.0 : 0.0}, {values.at(0), 0.2, 0.05})});
    }
    return scene;
  };
  Stage stage(std::move(definition));
  const Camera front = straightAt(3);
  stage.look(front);
  const PlacedLine* bay = stage.find("Bay");
  REQUIRE(bay != nullptr);
  REQUIRE(bay->chain >= 0);
  REQUIRE(bay->base.start.y == Approx(0.9));
  stage.values.set(1, 2);
  stage.rebuild();
  stage.look(front);
  bay = stage.find("Bay");
  REQUIRE(bay != nullptr);
  CHECK(bay->base.start.y == Approx(0.9));
  Placer anew;
  stage.placer = std::move(anew);
  stage.rebuild();
  stage.look(front);
  CHECK(stage.find("Bay")->base.start.y == Approx(0.6));   // where it would go by itself
}

TEST_CASE("while the camera comes nearer, no chain is begun for a moment where one of its base lines would do") {
  Stage stage(towerWithBays());
  int begun = 0;
  for (double azimuth = -90; azimuth < 90; azimuth += 7) {
    stage.placer.forget();
    Identity last;
    int chainHeld = kPatienceFrames;
    double distanceM = 60;
    for (int i = 0; i < 110; ++i, distanceM *= 0.983) {
      stage.look(orbitCamera({5, 3, 0}, distanceM, azimuth + 0.25 * i, 25));
      Identity now;
      for (const PlacedLine& line : stage.layout.lines) now = line.identity;
      if (now.chain >= 0) now.scopeIndex = -1;
      if (now != last && last.chain >= 0) {
        INFO("azimuth " << azimuth << ", frame " << i);
        CHECK(chainHeld >= 5);
      }
      if (now == last) {
        ++chainHeld;
      } else if (i > 0) {
        begun += now.chain >= 0 ? 1 : 0;
        chainHeld = 0;
      }
      last = now;
    }
  }
  CHECK(begun > 5);
}

TEST_CASE("while the camera goes away, one base line stands for its chain until there is room to spare") {
  Stage stage(towerWithBays());
  int chains = 0;
  for (double azimuth = -90; azimuth < 90; azimuth += 7) {
    stage.placer.forget();
    Identity last;
    int held = kSingleStaysZooming;
    double distanceM = 9;
    for (int i = 0; i < 110; ++i, distanceM /= 0.983) {
      stage.look(orbitCamera({5, 3, 0}, distanceM, azimuth + 0.25 * i, 25));
      Identity now;
      for (const PlacedLine& line : stage.layout.lines) now = line.identity;
      if (now.chain >= 0) now.scopeIndex = -1;
      const bool fromSingle = last.chain < 0 && last.plane >= 0;
      if (now.chain >= 0 && fromSingle) {
        INFO("azimuth " << azimuth << ", frame " << i);
        CHECK(held >= kSingleStaysZooming - 1);
        ++chains;
      }
      held = now == last ? held + 1 : 0;
      last = now;
    }
  }
  CHECK(chains > 5);
}

TEST_CASE("a line that another would have to run into gives way, in the first picture already") {
  // The plate's way down is the shorter one by a little, the bays' by so much that they rather run across the plate's line; which could as well lie above.
  Stage stage(wallWithPlateAndBays({.heightM = 16, .plateM = 7.8, .baysM = 0.5, .plateAlign = "none"}));
  const auto isAbove = [&](const char* name) { return stage.find(name)->lineScreen.start.y < 100; };   // the wall covers y from 100 to 900
  stage.look(straightAt(8));
  CHECK(isAbove("Plate"));
  CHECK_FALSE(isAbove("Bay"));
  for (int frame = 1; frame <= 2 * kReturnFrames; ++frame) {
    stage.look(straightAt(8 + 1e-4 * frame));
    CHECK(isAbove("Plate"));
  }
}

TEST_CASE("a line that was hidden is not shown for a feature that is about to go out of sight") {
  // Round the box from its right side on: the door's width points at the viewer at 90 degrees, and can be read again from 101 on.
  const auto framesShown = [](double lastSeenDeg) {
    Stage stage(boxWithDoor());
    ScopeVisibility visibility;
    visibility.seenShare.assign(stage.scene.scopes.size(), 1.0F);
    int frames = 0;
    for (double azimuthDeg = 60; azimuthDeg <= 130; azimuthDeg += 1) {
      for (std::size_t i = 0; i < stage.scene.scopes.size(); ++i) {
        if (stage.scene.scopes[i].name == "Door" && azimuthDeg > lastSeenDeg) visibility.seenShare[i] = 0;
      }
      stage.look(orbitCamera({0, 2.5, 0}, 300, azimuthDeg, 0, 3), 1000, 1000, &visibility);
      if (azimuthDeg == 90) REQUIRE(stage.find("DoorWidth") == nullptr);
      if (azimuthDeg > 90 && stage.find("DoorWidth") != nullptr) ++frames;
    }
    return frames;
  };
  CHECK(framesShown(130) > 25);
  CHECK(framesShown(99) == 0);   // at 106 it is out of sight for good
}

TEST_CASE("what cannot be shown says why") {
  Stage stage(boxWithDoor());
  Camera front;
  front.eye = {0, 2.5, 40};
  front.target = {0, 2.5, 0};
  front.orthoHeightM = 20;
  stage.look(front);
  CHECK(stage.reasonFor("Depth") == HiddenReason::kForeshortened);

  Camera away = front;
  away.target = {0, 2.5, 80};
  away.orthoHeightM.reset();
  stage.look(away);
  CHECK(stage.layout.lines.empty());
  CHECK(stage.reasonFor("Width") == HiddenReason::kOutOfView);
  CHECK(stage.layout.visibleScopes.empty());

  stage.look(orbitCamera({0, 2.5, 0}, 3000, 35, 20));
  CHECK(stage.layout.lines.empty());
  CHECK(stage.reasonFor("Height") == HiddenReason::kTooShort);

  // Of several doors the one in sight says why: it is too short, though others are hidden by the model.
  ModelDefinition doors = boxWithDoor();
  const auto oneDoor = doors.build;
  doors.build = [oneDoor](const Values& values) {
    Scene scene = oneDoor(values);
    const auto door = std::ranges::find(scene.scopes, "Door", &Scope::name);
    Scope another = *door;
    another.index = 1;
    scene.scopes.push_back(another);
    return scene;
  };
  Stage two(doors);
  ScopeVisibility visibility;
  visibility.seenShare.assign(two.scene.scopes.size(), 1.0F);
  visibility.seenShare.back() = 0;
  two.look(orbitCamera({0, 2.5, 0}, 3000, 35, 20), 1000, 1000, &visibility);
  CHECK(two.reasonFor("DoorHeight") == HiddenReason::kTooShort);
}

TEST_CASE("what is hidden by the model in all its scopes, or has none, says so") {
  ModelDefinition doors = measuring({"@Handle(scope=Door, type=linear-contour, orient=right, slip=scope)", "@Handle(scope=Gate, type=linear-contour, orient=right, slip=scope)"},
                                    [](const Values&) {
                                      Scene scene = sceneOf({{"Door", boxAt({-2, 0, 0}, {1, 2, 0.1})}, {"Door", boxAt({1, 0, 0}, {1, 2, 0.1})}});
                                      scene.scopes[1].index = 1;
                                      return scene;
                                    });
  Stage stage(doors);
  ScopeVisibility visibility{.seenShare = {0, 0}, .seenEdges = {}};
  stage.look(straightAt(1, 10), 1000, 1000, &visibility);
  CHECK(stage.layout.lines.empty());
  CHECK(stage.reasonFor("Width") == HiddenReason::kOccluded);
  CHECK(stage.reasonFor("Height") == HiddenReason::kNoScope);

  Stage oneSeen(doors);
  visibility.seenShare[1] = 1;
  oneSeen.look(straightAt(1, 10), 1000, 1000, &visibility);
  REQUIRE(oneSeen.find("Width") != nullptr);
  CHECK(oneSeen.find("Width")->scope == 1);
}

TEST_CASE("a line is shown from the least length on that its annotation asks for") {
  const auto shownAt = [](double px, const char* more) {
    Stage stage(measuring({"@Handle(scope=Plate, type=linear-contour, orient=right, slip=scope" + std::string(more) + ")"},
                          [](const Values&) { return sceneOf({{"Plate", boxAt({-0.5, 0, 0}, {1, 1, 0.1})}}); }));
    stage.look(straightAt(0.5, 1000 / px));
    if (stage.find("Width") != nullptr) return true;
    REQUIRE(stage.layout.hidden.size() == 1);
    CHECK(stage.reasonFor("Width") == HiddenReason::kTooShort);
    return false;
  };
  CHECK_FALSE(shownAt(79, ", min-length=80"));
  CHECK(shownAt(81, ", min-length=80"));
  CHECK(shownAt(79, ""));
  // Never shorter than any line may be.
  CHECK_FALSE(shownAt(kMinLineLengthPx - 0.5, ", min-length=1"));
  CHECK(shownAt(kMinLineLengthPx + 0.5, ", min-length=1"));
}

TEST_CASE("a camera inside the model gives a layout without a NaN") {
  Stage stage(boxWithDoor());
  int lines = 0;
  for (double azimuth = 0; azimuth < 360; azimuth += 15) {
    Camera camera;
    camera.eye = {0.3, 1.6, 0.2};
    camera.target = orbitCamera(camera.eye, 1, azimuth, 10).eye;
    camera.fovRad = 1.2;
    for (const PlacedLine& line : stage.look(camera).lines) {
      ++lines;
      CHECK(std::isfinite(line.lineScreen.start.x + line.lineScreen.start.y + line.lineScreen.end.x + line.lineScreen.end.y));
      if (line.label) CHECK(std::isfinite(line.label->min.x + line.label->min.y + line.label->max.x + line.label->max.y));
      for (const auto* extension : {&line.extensionStart, &line.extensionEnd}) {
        for (const Vec2& point : *extension) CHECK(std::isfinite(point.x + point.y));
      }
    }
  }
  CHECK(lines > 0);
}

TEST_CASE("labels keep off an arc that stays in its scope's frame") {
  // A flap beside the box, where the lines of its height would like to be.
  ModelDefinition definition = boxWithDoor();
  definition.parameters.push_back({.name = "Flap",
                                   .title = "Flap",
                                   .type = ParameterType::kAngle,
                                   .unit = Unit::kDegree,
                                   .defaultValue = 60,
                                   .max = 90,
                                   .annotation = "@Handle(scope=Flap, type=angular, orient=front, slip=none)"});
  definition.build = [build = definition.build](const Values& values) {
    Scene scene = build(values);
    scene.scopes.push_back({"Flap", 0, boxAt({4, 1, 3}, {2, 2, 2})});
    return scene;
  };
  Stage stage(std::move(definition));
  std::size_t shown = 0;
  for (const Camera& camera : cameras({0, 2.5, 0}, 30)) {
    const Layout& layout = stage.look(camera);
    for (const PlacedHandle& arc : layout.others) {
      ++shown;
      for (const PlacedLine& line : layout.lines) {
        if (line.label) CHECK_FALSE(line.label->overlaps(arc.box));
        if (line.placement == PlacementKind::kOutside) CHECK_FALSE(meets(line.lineScreen, arc.box));
      }
    }
  }
  CHECK(shown > 50);
}

TEST_CASE("labels of shorter lines keep off the label of a line that is held") {
  Stage stage(boxWithDoor());
  stage.look(orbitCamera({0, 2.5, 0}, 30, 20, 22));
  const PlacedLine* door = stage.find("DoorWidth");
  REQUIRE(door != nullptr);
  REQUIRE(door->label.has_value());
  PlacedLine held = *stage.find("Width");
  held.label = door->label;
  stage.placer.place(stage.layout.view, stage.fields, stage.values, stage.layout, nullptr, {&held, 1});
  CHECK(stage.find("Width")->label->center() == held.label->center());
  for (const PlacedLine& line : stage.layout.lines) {
    if (stage.nameOf(line) != "Width" && line.label) CHECK_FALSE(line.label->overlaps(*held.label));
  }
}

TEST_CASE("a warmed-up orbit, in which lines change places, allocates nothing") {
  Stage stage(boxWithDoor());
  std::vector<View> views;
  for (double azimuth = 0; azimuth < 360; azimuth += 1) views.emplace_back(orbitCamera({0, 2.5, 0}, 30, azimuth, 22), 1000, 1000, stage.scene.bounds);
  std::vector<DistanceFields> fields(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) stage.producer.produce(views[i], fields[i]);
  const auto goRound = [&] {
    for (std::size_t i = 0; i < views.size(); ++i) stage.placer.place(views[i], fields[i], stage.values, stage.layout);
  };
  goRound();
  goRound();
  const std::size_t before = allocationCount();
  goRound();
  CHECK(allocationCount() == before);

  std::size_t changes = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::vector<PlacedLine> was = stage.layout.lines;
    stage.placer.place(views[i], fields[i], stage.values, stage.layout);
    changes += sameIdentities(was, stage.layout.lines) ? 0 : 1;
  }
  CHECK(changes >= 4);   // at each of the box's edges
}

TEST_CASE("a warmed-up frame allocates nothing") {
  Stage stage(boxWithDoor());
  const std::vector<Camera> all = cameras(stage.scene.bounds.center(), 30);
  std::vector<View> views;
  std::vector<DistanceFields> fields(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    views.emplace_back(all[i], 1000, 1000, stage.scene.bounds);
    stage.producer.produce(views[i], fields[i]);
    stage.placer.place(views[i], fields[i], stage.values, stage.layout);
  }
  const std::size_t before = allocationCount();
  for (std::size_t i = 0; i < all.size(); ++i) stage.placer.place(views[i], fields[i], stage.values, stage.layout);
  CHECK(allocationCount() == before);
  CHECK(stage.layout.lines.size() >= 4);
}
