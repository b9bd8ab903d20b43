#include "placement/landed.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "placement/jogs.h"

using namespace dimline;

namespace {

constexpr int kGuide = 3;
constexpr double kShortM = 2;

/// A line 2 m and 100 px long at y = 40 that has moved up from its base line at y = 100, and lies on a guide.
Landed withShortLine() {
  PlacedLine line;
  line.lengthM = kShortM;
  line.baseScreen = {{100, 100}, {200, 100}};
  line.lineScreen = {{100, 40}, {200, 40}};
  Landed landed;
  landed.add(line, kGuide);
  return landed;
}

Landed::Tangle tangle(const Landed& landed, const Segment2& base, const Segment2& line) { return landed.tangle(line, extensionParts(base, base, line)); }

}  // namespace

TEST_CASE("a longer line nests wrongly when it is nearer to the model than a shorter one beside it on the same side") {
  const Landed landed = withShortLine();
  const Segment2 base{{50, 100}, {300, 100}};
  const auto nestsWrongly = [&](const Segment2& line, int guide = -1) { return landed.nestsWrongly(base, line, 2 * kShortM, guide); };
  CHECK(nestsWrongly({{50, 70}, {300, 70}}));
  CHECK(nestsWrongly({{300, 70}, {50, 70}}));                  // drawn the other way round
  CHECK(nestsWrongly({{50, 70}, {300, 84}}));                  // 3 degrees off looks parallel
  CHECK_FALSE(nestsWrongly({{50, 10}, {300, 10}}));            // farther out
  CHECK_FALSE(nestsWrongly({{50, 130}, {300, 130}}));          // on the other side
  CHECK_FALSE(nestsWrongly({{50, 70}, {300, 70}}, kGuide));    // on one guide
  CHECK_FALSE(nestsWrongly({{50, 70}, {50, 70}}));             // a line of no length
  CHECK_FALSE(landed.nestsWrongly({{201, 100}, {300, 100}}, {{201, 70}, {300, 70}}, 2 * kShortM, -1));    // past its end
  CHECK_FALSE(landed.nestsWrongly({{150, 100}, {150, 300}}, {{150, 45}, {150, 245}}, 2 * kShortM, -1));   // at right angles to it
}

TEST_CASE("a shorter line nests wrongly when a longer one that has landed is nearer to the model; lines of one length never do") {
  const Landed landed = withShortLine();
  const Segment2 base{{100, 100}, {200, 100}};
  const Segment2 nearer{{100, 70}, {200, 70}};
  const Segment2 farther{{100, 10}, {200, 10}};
  CHECK(landed.nestsWrongly(base, farther, 0.5 * kShortM, -1));
  CHECK_FALSE(landed.nestsWrongly(base, nearer, 0.5 * kShortM, -1));
  for (const double factor : {1 / 1.005, 1.0, 1.005}) {
    CHECK_FALSE(landed.nestsWrongly(base, farther, factor * kShortM, -1));
    CHECK_FALSE(landed.nestsWrongly(base, nearer, factor * kShortM, -1));
  }
}

TEST_CASE("neighbours in a chain land the extension line between them once, and go back together") {
  constexpr int kChain = 4;
  PlacedLine member;
  member.parameter = kChain;
  member.extensionStart = {{100, 100}, {100, 40}};
  member.extensionEnd = {{200, 100}, {200, 40}};
  PlacedLine next = member;
  next.extensionStart = {{200, 100 + 1e-9}, {200, 40}};   // but for rounding
  next.extensionEnd = {{300, 100}, {300, 40}};
  Landed landed;
  const Landed::Mark before = landed.mark();
  landed.add(member, kGuide);
  CHECK(landed.hasExtension({{200, 100}, {200, 40}}, kChain));
  CHECK_FALSE(landed.hasExtension({{200, 100}, {200, 40}}, kChain + 1));   // another's may go while this one stays
  CHECK_FALSE(landed.hasExtension({{200, 40}, {200, 100}}, kChain));
  landed.add(next, kGuide);
  CHECK(landed.mark().extensions == 3);
  CHECK_FALSE(landed.clearsExtensions({{195, 60}, {205, 70}}));
  landed.backTo(before);
  CHECK(landed.clearsExtensions({{195, 60}, {205, 70}}));
}

TEST_CASE("a line on a guide has room that keeps 30 px from lines of other guides, crosses no extension line and keeps off labels") {
  Landed landed = withShortLine();   // at y = 40, from x = 100 to 200
  CHECK_FALSE(landed.hasRoom({{120, 40 + kHandleSpacingPx - 0.5}, {180, 40 + kHandleSpacingPx - 0.5}}, kGuide + 1));
  CHECK(landed.hasRoom({{120, 40 + kHandleSpacingPx + 0.5}, {180, 40 + kHandleSpacingPx + 0.5}}, kGuide + 1));
  CHECK(landed.hasRoom({{200, 40}, {260, 40}}, kGuide));         // its neighbour on the same guide
  CHECK_FALSE(landed.hasRoom({{200, 40}, {260, 40}}, kGuide + 1));
  const Segment2 far{{400, 100}, {500, 100}};
  CHECK(landed.hasRoom(far, kGuide));
  Landed labelled = landed;
  labelled.addLabel({{440, 100 + kLabelClearancePx - 0.5}, {460, 130}});
  CHECK_FALSE(labelled.hasRoom(far, kGuide));
  landed.add({{450, 200}, {600, 200}}, {{450, 200}, {600, 200}}, {{450, 20}, {600, 20}});   // whose extension line runs up at x = 450
  CHECK_FALSE(landed.hasRoom(far, kGuide));
}

TEST_CASE("what lies on an extension line runs along it, what touches its end or crosses it does not") {
  Landed landed;
  landed.add({{450, 200}, {600, 200}}, {{450, 200}, {600, 200}}, {{450, 20}, {600, 20}});   // extension lines from y = 200 up to 20
  CHECK(landed.runsAlongExtension({{450, 50}, {450, 150}}));
  CHECK(landed.runsAlongExtension({{450, 400}, {450, 100}}));
  CHECK_FALSE(landed.runsAlongExtension({{450, 400}, {450, 201}}));
  CHECK_FALSE(landed.runsAlongExtension({{400, 100}, {500, 100}}));
  CHECK_FALSE(landed.runsAlongExtension({{500, 200}, {550, 200}}));
}

TEST_CASE("what was added after a mark is taken back") {
  Landed landed = withShortLine();
  const Landed::Mark mark = landed.mark();
  landed.add({{0, 300}, {400, 300}}, {{0, 300}, {400, 300}}, {{0, 250}, {400, 250}});
  REQUIRE(landed.comesWithin(10, {{0, 255}, {400, 255}}));
  landed.backTo(mark);
  CHECK_FALSE(landed.comesWithin(10, {{0, 255}, {400, 255}}));
  CHECK(landed.comesWithin(10, {{100, 45}, {200, 45}}));
}

TEST_CASE("a thread counts the lines, the extension lines and the labels that it runs across") {
  Landed landed;
  landed.add({{100, 100}, {200, 100}}, {{100, 100}, {200, 100}}, {{100, 40}, {200, 40}});   // extension lines at x = 100 and x = 200
  landed.addLabel({{140, 10}, {160, 30}});
  const auto across = [&](const Vec2& from, const Vec2& to) {
    const Landed::Across found = landed.across({from, to});
    return std::array{found.lines, found.extensions, found.labels};
  };
  CHECK(across({150, 90}, {150, 0}) == std::array{1, 0, 1});
  CHECK(across({150, 90}, {150, 35}) == std::array{1, 0, 0});
  CHECK(across({90, 70}, {210, 70}) == std::array{0, 2, 0});
  CHECK(across({150, 90}, {150, 50}) == std::array{0, 0, 0});
}

TEST_CASE("another pill's thread counts by itself, and its pill as a label") {
  Landed landed;
  PlacedHandle pill;
  pill.anchor = {100, 100};
  pill.box = Box2::around({200, 100}, {40, 28});
  landed.add(pill, View{});
  const Landed::Across found = landed.across({{150, 90}, {150, 110}});
  CHECK(found.threads == 1);
  CHECK(found.extensions + found.lines + found.labels == 0);
  CHECK(landed.across({{200, 80}, {200, 120}}).labels == 1);
  CHECK(landed.across({{50, 90}, {50, 110}}).threads == 0);
}

TEST_CASE("nothing has room on an arc, however long it is, and there is room within it") {
  // 100 px a metre: three quarters of a circle of 100 px round the middle of the picture.
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.target = Vec3(0.0);
  camera.orthoHeightM = 4;
  const View view(camera, 400, 400, Bounds{Vec3(-1), Vec3(1)});
  PlacedHandle angle;
  angle.arc = Arc{.radiusM = 1, .angleRad = 270 * kRadPerDeg};
  angle.box = {{10, 10}, {20, 20}};
  Landed landed;
  landed.add(angle, view);
  const auto at = [&](double radiusM, double deg) { return Box2::around(view.toScreen(Vec3(std::cos(deg * kRadPerDeg), std::sin(deg * kRadPerDeg), 0) * radiusM), {2, 2}); };
  for (int deg = 5; deg < 270; deg += 5) {
    INFO(deg);
    CHECK_FALSE(landed.hasRoom(at(1, deg)));
    CHECK(landed.hasRoom(at(1.1, deg)));
    if (deg >= 10 && deg <= 260) CHECK(landed.hasRoom(at(0.85, deg)));
  }
  CHECK(landed.hasRoom(at(1, 300)));
}

TEST_CASE("a label that is taken away leaves its room, and no other does") {
  Landed landed;
  landed.addLabel({{100, 100}, {140, 116}});
  landed.addLabel({{200, 100}, {240, 116}});
  landed.removeLabel({{100, 100}, {140, 116}});
  CHECK(landed.hasRoom({{100, 100}, {140, 116}}));
  CHECK_FALSE(landed.hasRoom({{200, 100}, {240, 116}}));
}

TEST_CASE("a label's room among its own lines: they do not count, their extension lines do") {
  Landed landed;
  PlacedLine line;
  line.parameter = 5;
  line.lineScreen = {{100, 40}, {200, 40}};
  line.extensionStart = {{100, 100}, {100, 40}};
  landed.add(line, -1);
  CHECK_FALSE(landed.hasRoom({{140, 32}, {160, 48}}));
  CHECK(landed.hasRoom({{140, 32}, {160, 48}}, false, 5));
  CHECK_FALSE(landed.hasRoom({{140, 32}, {160, 48}}, false, 4));
  CHECK_FALSE(landed.hasRoom({{90, 60}, {110, 76}}, false, 5));
}

TEST_CASE("a tangle counts the lines across extension lines, this one and those that have landed") {
  // The landed line is parameter 5; its extension lines run at x = 100 and x = 200 from y = 100 to y = 40.
  PlacedLine line;
  line.parameter = 5;
  line.baseScreen = {{100, 100}, {200, 100}};
  line.lineScreen = {{100, 40}, {200, 40}};
  line.extensionStart = {{100, 100}, {100, 40}};
  line.extensionEnd = {{200, 100}, {200, 40}};
  Landed landed;
  landed.add(line, -1);

  const Segment2 beside{{300, 100}, {400, 100}};
  CHECK(tangle(landed, beside, {{300, 20}, {400, 20}}).lines == 0);
  CHECK(tangle(landed, beside, {{300, 20}, {400, 20}}).parameter == -1);

  // From x = 150 to 300: farther out its extension line crosses the landed line, nearer it runs across the landed one's extension line.
  const Segment2 overlapping{{150, 100}, {300, 100}};
  const Landed::Tangle farther = tangle(landed, overlapping, {{150, 10}, {300, 10}});
  CHECK(farther.lines == 1);
  CHECK(farther.parameter == 5);
  const Landed::Tangle nearer = tangle(landed, overlapping, {{150, 70}, {300, 70}});
  CHECK(nearer.lines == 1);
  CHECK(nearer.parameter == 5);

  // Two extension lines that cross each other are no tangle.
  const Segment2 crossing{{50, 50}, {50, 200}};
  CHECK(tangle(landed, crossing, {{80, 50}, {80, 200}}).lines == 0);

  PlacedLine second = line;
  second.parameter = 6;
  second.lineScreen = {{100, 20}, {200, 20}};
  landed.add(second, -1);
  CHECK(tangle(landed, overlapping, {{150, 0}, {300, 0}}).lines == 2);   // its extension line runs across both
}

TEST_CASE("an extension line gets past the end of one line by a jog, but not past its neighbour, another line or a label") {
  // From x = 105 an extension line runs up to y = -100, and a line that has landed ends 5 px beyond it at y = 20.
  const Segment2 base{{105, 140}, {400, 140}}, line{{105, -100}, {400, -100}};
  const auto lineTo = [](const Segment2& s, int parameter) {
    PlacedLine placed;
    placed.parameter = static_cast<std::size_t>(parameter);
    placed.lineScreen = placed.baseScreen = s;
    return placed;
  };
  Landed landed;
  landed.add(lineTo({{10, 20}, {110, 20}}, 5), -1);
  const auto jogs = [&](const Landed& among) { return among.jogOf({base.start, line.start}).has_value(); };
  REQUIRE(jogs(landed));
  CHECK(landed.jogOf({base.start, line.start}) == jogPastEnd({{10, 20}, {110, 20}}, {base.start, line.start}));
  CHECK(tangle(landed, base, line).lines == 0);
  CHECK_FALSE(landed.jogOf({base.end, line.end}));   // which runs across nothing
  CHECK(landed.crossesExtension(line) == false);
  CHECK_FALSE(landed.crossings(base, base, line).extensions);
  CHECK(landed.crossings(base, base, line).lines);   // a place where nothing need bend is a little better

  // The parts before the plane have no jog.
  CHECK(landed.tangle(line, extensionParts(base, {line.start, base.end}, line)).lines == 1);

  Landed chain = landed;
  chain.add(lineTo({{110, 20}, {180, 20}}, 5), -1);
  CHECK_FALSE(jogs(chain));
  CHECK(tangle(chain, base, line).lines == 1);
  Landed another = landed;
  another.add(lineTo({{106, 50}, {180, 50}}, 6), -1);
  CHECK_FALSE(jogs(another));
  CHECK(tangle(another, base, line).lines == 1);
  Landed labelled = landed;
  labelled.addLabel({{106, 60}, {150, 76}});
  CHECK_FALSE(jogs(labelled));
  labelled.removeLabel({{106, 60}, {150, 76}});
  labelled.addLabel({{90, 60}, {150, 76}});   // which it runs through in any case
  CHECK(jogs(labelled));
}

TEST_CASE("only a line's extension line has a jog for one that comes later, no arc's leg, no thread and no line in hand") {
  const Segment2 base{{100, 300}, {400, 300}}, line{{100, 50}, {400, 50}};
  const Segment2 later{{10, 170}, {104, 170}};   // 4 px over what runs up at x = 100
  PlacedLine placed;
  placed.baseScreen = base;
  placed.lineScreen = line;
  placed.extensionStart = {base.start, line.start};
  placed.extensionEnd = {base.end, line.end};
  Landed landed;
  landed.add(placed, -1);
  CHECK(landed.tangle(later, {}).lines == 0);
  placed.extensionStart = {base.start, {100, 100}, line.start};
  Landed bent;
  bent.add(placed, -1);
  CHECK(bent.tangle(later, {}).lines == 1);
  Landed ahead;
  ahead.add(base, base, line);
  CHECK(ahead.tangle(later, {}).lines == 0);
  Landed bentAhead;
  bentAhead.add(base, {{100, 100}, {400, 100}}, line);
  CHECK(bentAhead.tangle(later, {}).lines == 1);

  placed.lineScreen = {base.start, line.start};
  Landed inHand;
  inHand.reserve(placed);
  CHECK(inHand.tangle(later, {}).lines == 1);
  PlacedHandle pill;
  pill.anchor = {100, 300};
  pill.box = {{80, 30}, {120, 50}};
  Landed thread;
  thread.add(pill, View(Camera{}, 500, 500, Bounds{}));
  CHECK(thread.tangle(later, {}).lines == 1);
}

TEST_CASE("of a chain, all members' extension lines count") {
  Landed landed = withShortLine();
  landed.addLabel({{400, 20}, {440, 40}});
  const Segment2 across{{50, 10}, {300, 10}};
  const std::vector<Segment2> atEnds{{{50, 100}, {50, 10}}, {{300, 100}, {300, 10}}};
  CHECK(landed.tangle(across, atEnds).lines == 0);
  CHECK_FALSE(landed.extensionCrossings(atEnds).extensions);
  const std::vector<Segment2> between{{{50, 100}, {50, 10}}, {{150, 100}, {150, 10}}, {{160, 100}, {160, 10}}, {{300, 100}, {300, 10}}};
  CHECK(landed.tangle(across, between).lines == 1);   // one line, though two run across it
  CHECK(landed.extensionCrossings(between).extensions);
  CHECK_FALSE(landed.extensionCrossings(between).labels);
  CHECK(landed.extensionCrossings(std::vector<Segment2>{{{420, 100}, {420, 10}}}).labels);
}
