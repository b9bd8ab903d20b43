#include "placement/label_tidying.h"

#include <catch2/catch.hpp>

#include <vector>

#include "support/fields.h"

using namespace dimline;
using namespace dimline::test;

namespace {

const Box2 kPicture{{0, 0}, {1000, 1000}};
const Vec2 kNumberSize{48, 16};
/// px. Where the lines are; the model is above them.
constexpr double kLineY = 500;
constexpr double kModelY = 460;

/// Lines side by side below a model, of one parameter, as a picture has them; their labels are for LabelTidying to place.
struct Row {
  DistanceFields model = fieldsCovering({{100, 100}, {900, kModelY}}, 1000, 1000);
  std::vector<PlacedLine> lines;
  Landed landed;
  LabelTidying tidying;

  /// From `x` on, each so many px long.
  Row(double x, const std::vector<double>& lengthsPx) {
    for (const double length : lengthsPx) {
      PlacedLine line;
      line.parameter = 3;
      line.baseScreen = {{x, kModelY}, {x + length, kModelY}};
      line.lineScreen = {{x, kLineY}, {x + length, kLineY}};
      line.extensionStart = {{x, kModelY}, {x, kLineY}};
      line.extensionEnd = {{x + length, kModelY}, {x + length, kLineY}};
      lines.push_back(line);
      x += length;
    }
  }
  void land() {
    for (const PlacedLine& line : lines) landed.add(line, 0);
  }
  void tidy() { tidying.tidy(lines, kNumberSize, model, kPicture, landed); }
  /// Which lines have a number.
  [[nodiscard]] std::vector<std::size_t> numbered() const {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].label) which.push_back(i);
    }
    return which;
  }
  void checkCentredBelow() const {
    for (const PlacedLine& line : lines) {
      if (!line.label) continue;
      CHECK(line.label->center().x == Approx(line.lineScreen.middle().x));
      CHECK(line.label->min.y > kLineY);
    }
  }
};

using Numbered = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a label rides on its line when what was in its way has gone, and what has landed knows of it") {
  Row row(300, {200});
  row.lines[0].label = Box2::around({540, kLineY}, kNumberSize);
  row.lines[0].labelPlace.side = LabelPlace::Side::kBeyondEnd;
  row.land();
  row.tidy();
  REQUIRE(row.lines[0].label);
  CHECK(row.lines[0].label->center() == Vec2(400, kLineY));
  CHECK(row.lines[0].labelPlace == LabelPlace{});
  CHECK_FALSE(row.landed.coversLabel({{540, 480}, {540, 520}}));
  CHECK(row.landed.coversLabel({{400, 480}, {400, 520}}));
}

TEST_CASE("where there is no room on a line that can carry its label, it stands beside the middle rather than beyond an end; on a short line beyond") {
  for (const double length : {200.0, 40.0}) {
    Row row(300, {length});
    for (double x = 300; x < 300 + length; x += 10) row.landed.addLabel({{x, kLineY - 12}, {x + 5, kLineY + 2}});
    row.land();
    row.tidy();
    REQUIRE(row.lines[0].label);
    CHECK((row.lines[0].labelPlace.side == LabelPlace::Side::kOutward) == (length > 100));
    CHECK((row.lines[0].label->min.x > 300 + length) == (length < 100));
  }
}

TEST_CASE("a label keeps off its own extension lines") {
  // One that leads askew under where the label would stand beyond the line's end.
  Row row(300, {40});
  row.lines[0].extensionEnd = {{430, kLineY + 6}, {340, kLineY}};
  row.land();
  row.tidy();
  REQUIRE(row.lines[0].label);
  CHECK(row.lines[0].label->max.x < 300);
}

TEST_CASE("numbers of a chain stand at every line if all have room on one side") {
  Row row(300, {100, 100, 100});
  row.land();
  row.tidy();
  CHECK(row.numbered() == Numbered{0, 1, 2});
  for (const PlacedLine& line : row.lines) CHECK(line.labelPlace.side == LabelPlace::Side::kOnLine);
  // A line on which there is no room takes the others with it.
  Row other(300, {100, 100, 100});
  other.landed.addLabel({{440, kLineY - 10}, {460, kLineY - 5}});
  other.land();
  other.tidy();
  CHECK(other.numbered() == Numbered{0, 1, 2});
  other.checkCentredBelow();
}

TEST_CASE("numbers of a chain that have no room at every line stand at an even step, each at its own line's middle, and begin where lines are longer") {
  Row odd(300, std::vector<double>(7, 35.0));
  odd.land();
  odd.tidy();
  CHECK(odd.numbered() == Numbered{0, 2, 4, 6});
  odd.checkCentredBelow();

  Row dwindling(300, {40, 39, 38, 37, 36, 35});
  dwindling.land();
  dwindling.tidy();
  CHECK(dwindling.numbered() == Numbered{0, 2, 4});
  Row growing(300, {35, 36, 37, 38, 39, 40});
  growing.land();
  growing.tidy();
  CHECK(growing.numbered() == Numbered{1, 3, 5});

  // So short that there is room at every third alone, with as many bare ones at either end.
  Row short_(300, std::vector<double>(6, 20.0));
  short_.land();
  short_.tidy();
  CHECK(short_.numbered() == Numbered{1, 4});
  short_.checkCentredBelow();
}

TEST_CASE("where no even step has room, numbers stand where they would by themselves") {
  Row row(300, {35, 35, 35});
  // Below none of the lines can a number stand at the middle; below the first alone one can stand at its beginning.
  for (const double x : {329.0, 350.0, 385.0}) row.landed.addLabel({{x, kLineY + 5}, {x + 4, kLineY + 30}});
  row.land();
  row.tidy();
  REQUIRE(row.numbered() == Numbered{0});
  CHECK(row.lines[0].label->center().x == Approx(300));
}

TEST_CASE("where no label has room those that are there stay") {
  Row row(300, {35, 35, 35});
  row.lines[1].label = Box2::around({352, kLineY + 16}, kNumberSize);
  row.landed.addLabel({{0, 0}, {1000, 1000}});
  row.land();
  row.tidy();
  CHECK(row.numbered() == Numbered{1});
  CHECK(row.landed.coversLabel({{352, kLineY + 10}, {352, kLineY + 20}}));
}
