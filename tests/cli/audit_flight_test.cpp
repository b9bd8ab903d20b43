#include <catch2/catch.hpp>

#include "cli/audit_run.h"
#include "cli/audit_stage.h"

// The flights that the audit flies, and the lines that stay fixed in the world along them.

namespace dimline::test {
namespace {

TEST_CASE("audit: lines that stay fixed in the world break what placed lines keep") {
  const auto model = makeModel(boxWithDoor());
  std::ostringstream progress;
  const auto parts = auditModel(*model, Values(model->parameters()), {.stepDeg = 10, .every = 4}, progress);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].flights.size() == 3);
  CHECK(parts[0].frames == 108);
  CHECK(parts[0].framesMeasured == 27);
  for (const AuditRow row : {AuditRow::kCrossesModel, AuditRow::kTouchesModel, AuditRow::kModelDistance}) {
    INFO(definition(row).title);
    CHECK(parts[0].placed.figure(row).judged > 100);
    CHECK(parts[0].placed.figure(row).met);
    CHECK_FALSE(parts[0].frozen.figure(row).met);
  }
  // They never change, whatever else they do.
  for (const AuditRow row : {AuditRow::kIdentityChanges, AuditRow::kFlicker})
    CHECK(parts[0].frozen.figure(row).offences == 0);
  CHECK(parts[0].placed.figure(AuditRow::kStillCamera).offences == 0);
}

TEST_CASE("audit: frozen lines are the first frame's, projected") {
  const auto model = makeModel(boxWithDoor());
  const Values values(model->parameters());
  const Scene scene = model->definition.build(values);
  AuditTally tally;
  const FlownFlight flown = fly(*model, scene, values, orbit(scene.bounds, 30, 45, 500, 400), tally);
  REQUIRE(flown.layouts.size() == 8);
  const std::vector<Layout> still = frozen(flown, scene);
  REQUIRE(still.size() == 8);
  const std::vector<PlacedLine>& first = flown.layouts[0].lines;
  REQUIRE(first.size() == still[3].lines.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(still[0].lines[i].lineScreen.start == first[i].lineScreen.start);
    REQUIRE(still[0].lines[i].label.has_value() == first[i].label.has_value());
    if (first[i].label) CHECK(glm::length(still[0].lines[i].label->center() - first[i].label->center()) < 1e-6);
    CHECK(still[3].lines[i].line.end == first[i].line.end);
    CHECK(still[3].lines[i].lineScreen.end == flown.layouts[3].view.toScreen(first[i].line.end));
  }
}

TEST_CASE("audit: the orbit goes round the model once") {
  Bounds bounds;
  bounds.add({-4, 0, -3});
  bounds.add({4, 5, 3});
  const Flight flight = orbit(bounds, 30, 1, 1000, 1000);
  REQUIRE(flight.cameras.size() == 360);
  const Vec3 front = flight.cameras[0].eye - bounds.center();
  CHECK(front.x == Approx(0).margin(1e-9));
  CHECK(front.z > 0);
  CHECK((flight.cameras[90].eye - bounds.center()).x > 0);  // then to the right
  for (const Camera& camera : flight.cameras) {
    CHECK(glm::length(camera.eye - bounds.center()) == Approx(glm::length(front)));
    const View view(camera, 1000, 1000, bounds);
    for (int i = 0; i < 8; ++i) {
      const Vec2 corner = view.toScreen(bounds.corner(i));
      CHECK((corner.x > 50 && corner.x < 950 && corner.y > 50 && corner.y < 950));
    }
  }
}

TEST_CASE("audit: random flights use every sort of lens and come back") {
  Bounds bounds;
  bounds.add({-4, 0, -3});
  bounds.add({4, 5, 3});
  bool anyOrtho = false, anyNarrow = false, anyWide = false, anySmall = false, anyLarge = false;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Flight flight = randomFlight(bounds, i);
    REQUIRE(flight.cameras.size() == flight.names.size());
    for (const Camera& camera : flight.cameras) REQUIRE(validate(camera).ok());
    const Camera& camera = flight.cameras.front();
    anyOrtho = anyOrtho || camera.orthographic();
    anyNarrow = anyNarrow || camera.fovRad < 0.01;
    anyWide = anyWide || camera.fovRad > 1.2;
    anySmall = anySmall || flight.widthPx == 300;
    anyLarge = anyLarge || flight.widthPx == 3840;
    CHECK(camera.fovRad >= 0.2 / 57.3);
    CHECK(camera.fovRad <= 100 / 57.2);
    // In the middle the model, which is as large as that, leaves the picture on all sides; in the end it is as large again as it was.
    const auto sizePx = [&](const Camera& at) { return 4 / View(at, flight.widthPx, flight.heightPx, bounds).metresPerPixelAt(bounds.center()); };
    const auto nearest = std::ranges::max_element(flight.cameras, {}, sizePx);
    CHECK(sizePx(*nearest) > std::max(flight.widthPx, flight.heightPx));
    CHECK(nearest != flight.cameras.begin());
    CHECK(sizePx(flight.cameras.back()) < 1.03 * sizePx(camera));
    CHECK(sizePx(flight.cameras.back()) > 0.97 * sizePx(camera));
  }
  CHECK((anyOrtho && anyNarrow && anyWide && anySmall && anyLarge));
}

}  // namespace
}  // namespace dimline::test
