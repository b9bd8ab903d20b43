#include <catch2/catch.hpp>

#include "placement/label_memory.h"
#include "placement/labels.h"
#include "support/fields.h"

using namespace dimline;

namespace {

const Box2 kViewport{{0, 0}, {1000, 1000}};
const Vec2 kText{48, 16};

PlacedLine placed(const Segment2& line, std::optional<Box2> label = std::nullopt) {
  PlacedLine out;
  out.lineScreen = line;
  out.label = label;
  return out;
}

std::optional<Box2> labelBox(const LabelRequest& request, const Landed& landed, const Box2& viewport) {
  const auto found = placeLabel(request, landed, viewport);
  return found ? std::optional(found->box) : std::nullopt;
}

}  // namespace

TEST_CASE("a label rides on the middle of a line that is long enough") {
  const auto box = labelBox({.line = {{100, 500}, {300, 500}}, .textSize = kText}, Landed{}, kViewport);
  REQUIRE(box);
  CHECK(box->min == Vec2(176, 492));
  CHECK(box->max == Vec2(224, 508));
}

TEST_CASE("the line is interrupted by the text's width along it and the padding") {
  CHECK(interruptedLengthPx(kText, {1, 0}) == Approx(48 + 8));
  CHECK(interruptedLengthPx(kText, {0, 1}) == Approx(16 + 8));
}

TEST_CASE("a label moves along its line when the middle is taken") {
  Landed landed;
  landed.add(placed({{190, 400}, {190, 600}}), -1);
  const auto box = labelBox({.line = {{100, 500}, {300, 500}}, .textSize = kText}, landed, kViewport);
  REQUIRE(box);
  CHECK(box->center().y == Approx(500));
  CHECK(landed.hasRoom(*box));
  CHECK(box->center().x != Approx(200));
}

TEST_CASE("a label finds room between the places that are tried first") {
  Landed landed;
  // Its middle may lie 56 px to either side of the line's. On the right there is room for it from 34 to 37 px alone.
  for (const double x : {100.0, 206.0, 265.0}) landed.add(placed({{x, 400}, {x, 600}}), -1);
  for (const double x : {140.0, 185.0}) landed.addLabel({{x, 495}, {x + 5, 505}});
  const auto box = labelBox({.line = {{100, 500}, {300, 500}}, .textSize = kText}, landed, kViewport);
  REQUIRE(box);
  CHECK(box->center().x == Approx(200 + 56 * 0.625));
}

TEST_CASE("a label stands beside its line further along where something is beside the middle") {
  Landed landed;
  // Beyond either end of a line that is too short for its text, and at the left above and below it.
  for (const Box2& taken : {Box2{{470, 495}, {475, 505}}, Box2{{360, 495}, {365, 505}}, Box2{{392, 478}, {398, 490}}, Box2{{392, 510}, {398, 522}}}) landed.addLabel(taken);
  const auto box = labelBox({.line = {{400, 500}, {440, 500}}, .textSize = kText}, landed, kViewport);
  REQUIRE(box);
  CHECK(box->center().x == Approx(420 + 10));
  CHECK(std::abs(box->center().y - 500) == Approx(16));
}

TEST_CASE("extension lines may run under a label where that is allowed, lines and labels not") {
  Landed landed;
  PlacedLine line = placed({{100, 100}, {100, 200}}, Box2{{80, 140}, {120, 160}});
  line.extensionStart = {{300, 100}, {100, 100}};
  landed.add(line, -1);
  CHECK(landed.hasRoom({{200, 97}, {240, 107}}, true));
  CHECK_FALSE(landed.hasRoom({{98, 120}, {110, 130}}, true));
  CHECK_FALSE(landed.hasRoom({{122, 145}, {140, 155}}, true));
}

TEST_CASE("a label stands beyond the end of a line that is too short") {
  const auto box = labelBox({.line = {{100, 500}, {140, 500}}, .textSize = kText}, Landed{}, kViewport);
  REQUIRE(box);
  CHECK(box->min.x > 140);
  CHECK(box->center().y == Approx(500));
}

TEST_CASE("a label that would leave the viewport goes elsewhere, and where nothing is left there is none") {
  const auto box = labelBox({.line = {{950, 500}, {990, 500}}, .textSize = kText}, Landed{}, kViewport);
  REQUIRE(box);
  CHECK(box->max.x < 950);
  CHECK_FALSE(placeLabel({.line = {{10, 10}, {30, 10}}, .textSize = kText}, Landed{}, {{0, 0}, {40, 20}}));
}

TEST_CASE("whether a label would have room in the viewport, were nothing else there") {
  const Vec2 right{1, 0};
  // On an upright line it reaches 24 px to either side, and the margin is 6 px.
  CHECK(labelFits({{970, 300}, {970, 500}}, kText, right, kViewport));
  CHECK_FALSE(labelFits({{971, 300}, {971, 500}}, kText, right, kViewport));
  // One that is too short for it has it beyond its ends, or beside it on the side that leads away from the model.
  CHECK(labelFits({{900, 500}, {910, 500}}, kText, {0, 1}, kViewport));
  CHECK_FALSE(labelFits({{980, 20}, {980, 30}}, kText, right, kViewport));
  CHECK(labelFits({{980, 20}, {980, 30}}, kText, -right, kViewport));
}

TEST_CASE("a label stays where it was, or as near by as it can, though places before that are free") {
  LabelRequest request{.line = {{100, 500}, {300, 500}}, .textSize = kText};
  request.last = LastLabelPlace{.place = LabelPlace{.side = LabelPlace::Side::kOnLine, .eighth = 4}};
  Landed landed;
  auto found = placeLabel(request, landed, kViewport);
  REQUIRE(found);
  CHECK(found->place == request.last->place);
  CHECK(found->box.center().x == Approx(200 + 56 * 0.5));
  // What comes there leaves room at the end of the line and, a little further away, on the other side of its middle, which comes first where nothing was.
  landed.add(placed({{225, 400}, {225, 600}}), -1);
  found = placeLabel(request, landed, kViewport);
  REQUIRE(found);
  CHECK(found->place.side == LabelPlace::Side::kOnLine);
  CHECK(found->place.eighth == 8);
  request.last->mayLeave = true;
  CHECK(placeLabel(request, landed, kViewport)->place.eighth == -4);
  request.last = LastLabelPlace{.place = LabelPlace{.side = LabelPlace::Side::kInward}};
  CHECK(placeLabel(request, Landed{}, kViewport)->place == request.last->place);
}

TEST_CASE("a label that was over extension lines stays there as it was") {
  Landed landed;
  PlacedLine line = placed({{600, 100}, {600, 200}});
  line.extensionStart = {{200, 400}, {200, 600}};
  landed.add(line, -1);
  LabelRequest request{.line = {{100, 500}, {300, 500}}, .textSize = kText};
  CHECK(placeLabel(request, landed, kViewport)->place.eighth != 0);
  request.last = LastLabelPlace{.place = LabelPlace{.overExtensions = true}};
  CHECK(placeLabel(request, landed, kViewport)->place == request.last->place);
}

TEST_CASE("where a label was is remembered for its line alone, and for so many moved frames") {
  PlacedLine line = placed({{100, 500}, {300, 500}}, Box2{{176, 492}, {224, 508}});
  line.identity = {.parameter = 3, .scopeIndex = 1, .baseLine = 2, .plane = 0, .direction = 1};
  line.labelPlace = {.side = LabelPlace::Side::kOutward, .eighth = -4};
  PlacedLine other = line;
  other.identity.scopeIndex = 2;
  other.labelPlace = {};
  const std::vector lines{other, line};
  LabelMemory memory;
  const auto place = [&](const PlacedLine& of) { return memory.last(of.identity, 0, true).value().place; };
  CHECK_FALSE(memory.last(line.identity, 0, true));
  memory.note(lines, true);
  CHECK(place(line) == line.labelPlace);
  CHECK(place(other) == other.labelPlace);
  CHECK(memory.last(line.identity, 1, true)->place == line.labelPlace);
  CHECK_FALSE(memory.last(line.identity, 1, true)->mayLeave);
  PlacedLine elsewhere = line;
  elsewhere.identity.baseLine = 3;
  CHECK_FALSE(memory.last(elsewhere.identity, 0, true));

  for (int frame = 0; frame < kReturnFrames; ++frame) memory.note(lines, false);
  CHECK_FALSE(memory.last(line.identity, 0, true)->mayLeave);
  for (int frame = 0; frame < kReturnFrames; ++frame) memory.note(lines, true);
  CHECK(memory.last(line.identity, 0, true)->mayLeave);
  CHECK_FALSE(memory.last(line.identity, 0, false)->mayLeave);   // before a still camera it never moves
  line.labelPlace.eighth = 4;
  memory.note(std::span(&line, 1), true);
  CHECK(place(line) == line.labelPlace);
  CHECK_FALSE(memory.last(line.identity, 0, true)->mayLeave);
  CHECK_FALSE(memory.last(other.identity, 0, true));
  memory.forget();
  CHECK_FALSE(memory.last(line.identity, 0, false));
}

TEST_CASE("where labels were is remembered for chains that have other numbers now, and forgotten for those that are no more") {
  std::vector<PlacedLine> lines(3, placed({{100, 500}, {300, 500}}, Box2{{176, 492}, {224, 508}}));
  for (int i = 0; i < 3; ++i) {
    lines[static_cast<std::size_t>(i)].identity = {.parameter = i < 2 ? 3 : 4, .scopeIndex = i, .chain = i, .baseLine = 0, .plane = 0, .direction = 1};
  }
  LabelMemory memory;
  memory.note(lines, true);
  memory.renumberChains(3, [](std::int32_t number) { return number == 0 ? 5 : -1; });
  CHECK_FALSE(memory.last(lines[0].identity, 0, true));
  CHECK_FALSE(memory.last(lines[1].identity, 0, true));
  CHECK(memory.last(lines[2].identity, 0, true));
  lines[0].identity.chain = 5;
  CHECK(memory.last(lines[0].identity, 0, true));
}

TEST_CASE("that a line had no label is remembered like a label's place") {
  PlacedLine line;
  line.identity = {.parameter = 3, .plane = 1};
  LabelMemory memory;
  memory.note(std::span(&line, 1), true);
  REQUIRE(memory.last(line.identity, 0, true));
  CHECK_FALSE(memory.last(line.identity, 0, true)->place);
  for (int frame = 0; frame < kReturnFrames; ++frame) {
    CHECK_FALSE(memory.last(line.identity, 0, true)->mayLeave);
    memory.note(std::span(&line, 1), true);
  }
  CHECK(memory.last(line.identity, 0, true)->mayLeave);
  line.label = Box2{{0, 0}, {10, 10}};
  memory.note(std::span(&line, 1), true);
  CHECK(memory.last(line.identity, 0, true)->place == LabelPlace{});
  CHECK_FALSE(memory.last(line.identity, 0, true)->mayLeave);
}

TEST_CASE("a label keeps clear of its chain's other lines and their labels, and finds another place for that") {
  LabelRequest request{.line = {{400, 500}, {440, 500}}, .textSize = kText};
  std::vector<Segment2> fellows{request.line, {{440, 500}, {480, 500}}};
  request.fellows = fellows;
  const auto alone = placeLabel(request, Landed{}, kViewport);
  REQUIRE(alone);
  const std::vector fellowLabels{alone->box};
  request.fellowLabels = fellowLabels;
  const auto beside = placeLabel(request, Landed{}, kViewport);
  REQUIRE(beside);
  CHECK_FALSE(beside->box.grown(kLabelClearancePx).overlaps(alone->box));
  fellows.push_back({{300, beside->box.center().y}, {600, beside->box.center().y}});
  request.fellows = fellows;
  CHECK_FALSE(placeLabel(request, Landed{}, kViewport));   // neither above the line nor below it
}

TEST_CASE("a label clears the model") {
  // The model's left side runs down at x = 220 beside a vertical line at x = 200: text riding on the line would touch it.
  const DistanceFields model = test::fieldsCovering({{220, 0}, {1000, 1000}});
  const auto box = labelBox({.line = {{200, 300}, {200, 700}}, .textSize = kText, .outward = {-20, 0}, .model = &model},
                              Landed{}, kViewport);
  REQUIRE(box);
  CHECK(box->max.x + kLabelClearancePx <= 220);
}

TEST_CASE("labels keep clear of lines, extension lines and labels that have landed") {
  Landed landed;
  PlacedLine line = placed({{100, 100}, {100, 200}}, Box2{{80, 140}, {120, 160}});
  line.extensionStart = {{300, 100}, {100, 100}};
  landed.add(line, -1);
  CHECK_FALSE(landed.hasRoom({{98, 120}, {110, 130}}));    // on the line
  CHECK_FALSE(landed.hasRoom({{200, 97}, {240, 107}}));    // on the extension line
  CHECK_FALSE(landed.hasRoom({{122, 145}, {140, 155}}));   // 2 px beside the label
  CHECK(landed.hasRoom({{126, 145}, {140, 155}}));
}

TEST_CASE("crossings: lines and extension lines through what has landed") {
  Landed landed;
  PlacedLine line = placed({{100, 100}, {100, 200}}, Box2{{80, 140}, {120, 160}});
  line.extensionStart = {{300, 100}, {100, 100}};
  line.extensionEnd = {{300, 200}, {100, 200}};
  landed.add(line, -1);
  const auto crossings = [&](const Segment2& base, const Segment2& to) { return landed.crossings(base, base, to); };
  const auto throughLine = crossings({{300, 110}, {300, 130}}, {{60, 110}, {60, 130}});
  CHECK(throughLine.lines);
  CHECK_FALSE(throughLine.labels);
  CHECK(crossings({{200, 50}, {220, 50}}, {{200, 150}, {220, 150}}).lines);   // through an extension line
  CHECK(crossings({{300, 120}, {300, 150}}, {{110, 120}, {110, 150}}).labels);
  const auto beside = crossings({{300, 110}, {300, 130}}, {{140, 110}, {140, 130}});
  CHECK_FALSE(beside.lines);
  CHECK_FALSE(beside.labels);
}

TEST_CASE("an extension line that bends is looked at on both its parts") {
  Landed landed;
  landed.add(placed({{100, 100}, {100, 200}}), -1);
  const Segment2 base{{50, 150}, {50, 160}};
  CHECK(landed.crossings(base, {{150, 150}, {150, 160}}, {{150, 50}, {150, 60}}).lines);
  CHECK_FALSE(landed.crossings(base, {{50, 50}, {50, 60}}, {{150, 50}, {150, 60}}).lines);
}

TEST_CASE("what lies on a line that has landed, and what runs into one") {
  Landed landed;
  landed.add({{100, 300}, {300, 300}}, {{100, 300}, {300, 300}}, {{100, 200}, {300, 200}});
  CHECK(landed.liesOnLine({{250, 200}, {400, 200}}));
  CHECK(landed.liesOnLine({{400, 201}, {250, 201}}));             // a pixel aside, and the other way round
  CHECK_FALSE(landed.liesOnLine({{250, 202}, {400, 202}}));
  CHECK_FALSE(landed.liesOnLine({{298, 200}, {400, 200}}));       // they all but touch
  CHECK_FALSE(landed.liesOnLine({{250, 150}, {250, 250}}));       // across
  CHECK(landed.runsInto({{250, 150}, {250, 250}}));
  CHECK(landed.runsInto({{250, 200}, {400, 200}}));
  CHECK_FALSE(landed.runsInto({{250, 199.8}, {250, 250}}));       // reaches past it by less than is seen
  CHECK_FALSE(landed.runsInto({{250, 250}, {250, 290}}));
  CHECK(landed.comesWithin(10, {{320, 200}, {309, 200}}));
  CHECK_FALSE(landed.comesWithin(10, {{320, 200}, {311, 200}}));
}

TEST_CASE("what was added since a mark is taken back") {
  Landed landed;
  landed.add({{100, 300}, {300, 300}}, {{100, 300}, {300, 300}}, {{100, 200}, {300, 200}});
  const Landed::Mark mark = landed.mark();
  landed.add({{100, 300}, {300, 300}}, {{100, 300}, {300, 300}}, {{100, 100}, {300, 100}});
  CHECK(landed.runsInto({{200, 50}, {200, 150}}));
  landed.backTo(mark);
  CHECK_FALSE(landed.runsInto({{200, 50}, {200, 150}}));
  CHECK(landed.runsInto({{200, 150}, {200, 250}}));
}
