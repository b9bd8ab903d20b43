#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "cli/audit_flight.h"
#include "cli/audit_geometry.h"
#include "cli/load_model.h"

using namespace dimline;

namespace {

bool crossesExtension(const Layout& layout, const PlacedLine& line) {
  for (const PlacedLine& other : layout.lines) {
    if (&other == &line) continue;
    for (const auto* extension : {&other.extensionStart, &other.extensionEnd}) {
      for (std::size_t k = 1; k < extension->size(); ++k) {
        if (crossEachOther(line.lineScreen, {(*extension)[k - 1], (*extension)[k]})) return true;
      }
    }
  }
  return false;
}

/// Flies a model, and calls `look(layout, line)` for each line of each frame, or of each `every`th. Returns how many there were. `flightsOf(bounds)`: the flights.
template <typename FlightsOf, typename Look>
double flyLines(std::string_view name, FlightsOf flightsOf, Look look, std::size_t every = 1) {
  std::ostringstream errors;
  const auto model = loadModel(name, errors);
  REQUIRE(model);
  const Values values(model->parameters());
  const Scene scene = model->definition.build(values);
  std::size_t lines = 0;
  for (const Flight& flight : flightsOf(scene.bounds)) {
    AuditTally tally;
    const FlownFlight flown = fly(*model, scene, values, flight, tally);
    for (std::size_t i = 0; i < flown.layouts.size(); i += every) {
      const Layout& layout = flown.layouts[i];
      lines += layout.lines.size();
      for (const PlacedLine& line : layout.lines) look(layout, line);
    }
  }
  REQUIRE(lines > 500);
  return static_cast<double>(lines);
}

/// Of all lines in the frames of some flights, the share that runs across another's extension line.
template <typename FlightsOf>
double crossingShareOf(std::string_view name, FlightsOf flightsOf) {
  double crossing = 0;
  const double lines = flyLines(name, flightsOf, [&](const Layout& layout, const PlacedLine& line) { crossing += crossesExtension(layout, line) ? 1 : 0; });
  return crossing / lines;
}

/// How far all lines in the frames of some flights lie from their base lines, middle to middle, in the mean.
template <typename FlightsOf>
double meanDistancePx(std::string_view name, FlightsOf flightsOf, std::size_t every = 1) {
  double px = 0;
  const double lines = flyLines(name, flightsOf, [&](const Layout&, const PlacedLine& line) { px += glm::length(line.lineScreen.middle() - line.baseScreen.middle()); }, every);
  return px / lines;
}

/// The audit's three orbits of any model, in steps of so many degrees.
auto orbitsBy(double stepDeg) {
  return [=](const Bounds& bounds) {
    return std::vector{orbit(bounds, 10, stepDeg, 1000, 1000), orbit(bounds, 30, stepDeg, 1000, 1000), orbit(bounds, 60, stepDeg, 1000, 1000)};
  };
}

double crossingShare(std::string_view name, std::uint64_t flight) {
  return crossingShareOf(name, [&](const Bounds& bounds) { return std::vector{randomFlight(bounds, flight)}; });
}

}  // namespace

// With the shortest lines always first these shares are 0.9 %, 1.3 %, 1.2 %, 1.9 % and 5.0 %.
TEST_CASE("in flights, lines that would run across others' extension lines are placed in another order") {
  CHECK(crossingShare("helix-house", 5) < 0.004);
  CHECK(crossingShare("helix-house", 4) < 0.006);
  CHECK(crossingShare("house", 6) < 0.009);
  CHECK(crossingShare("lever", 0) < 0.004);
  CHECK(crossingShare("lever", 2) < 0.02);
}

// Where features that are mostly hidden, or partly out of the picture, get lines all the same, it is 3.3 %.
TEST_CASE("in flights, what is seen in part is not measured across others' extension lines") { CHECK(crossingShare("omni-tree", 1) < 0.02); }

// A turn of 36 degrees is more than kForgetTurnRad, so each of these frames is a first picture. Its lines lie 125 px away in the mean; where they do not look, 131 px; where each of them that goes elsewhere costs what it
// costs in a movement, 127 px.
TEST_CASE("in first pictures, each line looks for a better place when all are there") {
  CHECK(meanDistancePx("house", orbitsBy(36)) < 126.5);
}

// Long flights in which the sanitizers see nothing that the shorter ones, here and in the audit's own tests, do not show them, at several times the cost.
#ifndef __SANITIZE_ADDRESS__

// Where each frame is mended without a look at those ahead it is 2.4 to 3.5 %, as chance has it; with it 1.1 to 2.0 %.
TEST_CASE("in orbits of a crowded model, lines go where the movement does not bring them across others' extension lines at once") {
  CHECK(crossingShareOf("boat", orbitsBy(1)) < 0.022);
}

// Measured are frame 0 and each 10th of an orbit, in which a movement ends or goes on.
TEST_CASE("where a movement ends, lines lie nearer to what they measure than where it goes on") {
  constexpr std::size_t kEvery = 10;
  const auto orbits = orbitsBy(3);
  const auto orbitsWithRests = [&](const Bounds& bounds) {
    std::vector<Flight> flights = orbits(bounds);
    for (Flight& flight : flights) flight.restEvery = kEvery;
    return flights;
  };
  const double onTheWayPx = meanDistancePx("house", orbits, kEvery);
  const double atRestPx = meanDistancePx("house", orbitsWithRests, kEvery);
  INFO(atRestPx << " px at rest, " << onTheWayPx << " px on the way");
  CHECK(atRestPx < 0.85 * onTheWayPx);
}

#endif
