#include <catch2/catch.hpp>

#include <map>
#include <tuple>
#include <utility>

#include "models/models.h"
#include "silhouette/scope_visibility.h"
#include "support/stage.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// How far a line outside the model lies off its base line on screen (px).
Vec2 off(const PlacedLine& line) { return line.lineScreen.middle() - line.baseScreen.middle(); }

}  // namespace

TEST_CASE("lines do not go to and fro while the camera turns slowly", "[models]") {
  // A jerk and back, as of lines that are pushed out in one frame and come nearer in the next.
  constexpr double kJerkPx = 3;
  constexpr double kMostShare = 0.007;   // of lines; one in twenty would be plain to see
  const auto [model, elevationDeg] = GENERATE(std::pair(&defineHouse, 3.0), std::pair(&defineHouse, 12.0), std::pair(&defineLever, 3.0));
  Stage stage(model());
  CpuVisibility visibility;
  ScopeVisibility seen;
  const double distanceM = stage.scene.bounds.diagonal() * 1.75;
  using Key = std::tuple<std::size_t, std::size_t, std::string>;   // which line of a parameter it is, and in which place
  std::map<Key, Vec2> last, moved;
  int lines = 0, reversals = 0;
  for (double azimuth = -60; azimuth < 120; azimuth += 0.5) {
    const Camera camera = orbitCamera(stage.scene.bounds.center(), distanceM, azimuth, elevationDeg);
    visibility.measure(stage.scene, View(camera, 1000, 750, stage.scene.bounds), seen);
    stage.look(camera, 1000, 750, &seen);
    std::map<Key, Vec2> now, movedNow;
    for (const PlacedLine& line : stage.layout.lines) {
      if (line.placement == PlacementKind::kInside) continue;
      const Key key{line.parameter, line.scope, identityText(line.identity, stage.model.parameters())};
      now[key] = off(line);
      if (!last.contains(key)) continue;
      movedNow[key] = now[key] - last[key];
      if (!moved.contains(key)) continue;
      ++lines;
      const Vec2 before = moved[key], after = movedNow[key];
      if (glm::dot(before, after) < 0 && glm::length(before) > kJerkPx && glm::length(after) > kJerkPx) ++reversals;
    }
    last = now;
    moved = movedNow;
  }
  CAPTURE(stage.model.definition.name, elevationDeg, lines, reversals);
  CHECK(lines > 1000);
  CHECK(reversals <= kMostShare * lines);
}
