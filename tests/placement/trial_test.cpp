#include "placement/trial.h"

#include <catch2/catch.hpp>

#include <limits>

#include "support/fields.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

// What a candidate's score loses by what it runs into: lambda 5 is -30.

namespace {

/// A candidate 100 px to the right of its base line, whose score by itself is 7, among lines that have landed.
struct Among {
  View view{straightAt(0, 10), 1000, 1000, Bounds{{-5, -5, -1}, {5, 5, 1}}};
  DistanceFields model = fieldsCovering({{0, 900}, {1000, 1000}}, 1000, 1000);
  Occupied occupied;
  LookAhead ahead;
  LabelMemory labels;
  ObjectPlanesInFrame planes;
  Measured measured;
  Candidate candidate;

  Among() {
    occupied.begin(model);
    occupied.clear();
    candidate.baseScreen = candidate.footScreen = {{500, 400}, {500, 600}};
    candidate.lineScreen = {{600, 400}, {600, 600}};
    candidate.base = {{0, 1, 0}, {0, -1, 0}};
    candidate.score = 7;
  }
  void land(const Segment2& base, const Segment2& lineScreen, double lengthM = 1) {
    PlacedLine line;
    line.placement = PlacementKind::kOutside;
    line.parameter = 1;
    line.baseScreen = base;
    line.lineScreen = lineScreen;
    line.base = {{0, 0, 0}, {lengthM, 0, 0}};
    line.lengthM = lengthM;
    line.extensionStart = {base.start, lineScreen.start};
    line.extensionEnd = {base.end, lineScreen.end};
    line.line = {{0, 0, 0}, {1, 0, 0}};
    occupied.add(line, occupied.addGuide({{0, 0, 0}, {0, 0, 1}}, line.line));
  }
  [[nodiscard]] double score() const {
    Foresight still;
    const ChoiceContext context{.view = view,
                                .model = model,
                                .occupied = occupied,
                                .lookAhead = ahead,
                                .labels = labels,
                                .objectPlanes = planes,
                                .foresight = still,
                                .scopes = {},
                                .usable = {},
                                .sights = {},
                                .kind = {}};
    return Trial::amongOthers(candidate, measured, context, -std::numeric_limits<double>::infinity()).score;
  }
};

}  // namespace

TEST_CASE("Intersect: once, for whatever crosses what has landed") {
  Among among;
  CHECK(among.score() == Approx(7));
  SECTION("its line another line") {
    among.land({{580, 500}, {620, 500}}, {{580, 500}, {620, 500}});
    CHECK(among.score() == Approx(7 - 30));
  }
  SECTION("one of its extension lines another's extension line") {
    among.land({{550, 300}, {560, 300}}, {{550, 450}, {560, 450}});
    CHECK(among.score() == Approx(7 - 30));
    among.land({{530, 300}, {540, 300}}, {{530, 450}, {540, 450}});
    CHECK(among.score() == Approx(7 - 30));
  }
  SECTION("what is beside it, or on its base line's other side, costs nothing") {
    among.land({{700, 300}, {710, 300}}, {{700, 450}, {710, 450}});
    among.land({{400, 380}, {410, 380}}, {{400, 450}, {410, 450}});
    CHECK(among.score() == Approx(7));
  }
}

TEST_CASE("beyond the paper, a line across an extension line costs more than Intersect alone") {
  Among among;
  SECTION("another's line across its own") {
    among.land({{540, 390}, {540, 410}}, {{550, 390}, {550, 410}});
    CHECK(among.score() == Approx(7 + kScoreIntersect + kScoreCrossesExtension));
  }
  SECTION("its line across another's") {
    among.land({{590, 500}, {590, 550}}, {{650, 500}, {650, 550}}, 3);   // the longer one is further out, as it should be
    CHECK(among.score() == Approx(7 + kScoreIntersect + kScoreCrossesExtension));
  }
}
