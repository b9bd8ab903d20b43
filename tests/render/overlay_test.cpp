#include "render/overlay_line.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/constants.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;
using Kind = OverlayShape::Kind;

namespace {

/// Colours that can be told apart, without opacity of their own.
Theme testTheme() {
  Theme theme;
  theme.line = srgb(0x000001);
  theme.lineHovered = srgb(0x000002);
  theme.extension = srgb(0x000003);
  theme.handle = srgb(0x000004);
  theme.handleHovered = srgb(0x000005);
  theme.halo = srgb(0x000006);
  return theme;
}

/// The blue byte, which tells testTheme's colours apart.
unsigned inkOf(const OverlayShape& shape) { return (shape.rgba >> 16U) & 255U; }
unsigned opacityOf(const OverlayShape& shape) { return shape.rgba >> 24U; }

std::vector<OverlayShape> build(const OverlayLine& line) {
  std::vector<OverlayShape> shapes;
  buildOverlay({.lines = {&line, 1}}, testTheme(), shapes);
  return shapes;
}

std::vector<OverlayShape> withInk(const std::vector<OverlayShape>& shapes, unsigned ink) {
  std::vector<OverlayShape> found;
  for (const OverlayShape& shape : shapes) {
    if (inkOf(shape) == ink) found.push_back(shape);
  }
  return found;
}

std::vector<OverlayShape> build(const OverlayArc& arc) {
  std::vector<OverlayShape> shapes;
  buildOverlay({.arcs = {&arc, 1}}, testTheme(), shapes);
  return shapes;
}

std::vector<OverlayShape> build(const OverlayThread& thread) {
  std::vector<OverlayShape> shapes;
  buildOverlay({.threads = {&thread, 1}}, testTheme(), shapes);
  return shapes;
}

/// A quarter circle of 100 px about (200, 200), from the right to the top.
std::vector<Vec2> quarter() {
  std::vector<Vec2> points;
  for (int i = 0; i <= 24; ++i) {
    const double rad = i * 1.5707963267948966 / 24;
    points.emplace_back(200 + 100 * std::cos(rad), 200 - 100 * std::sin(rad));
  }
  return points;
}

OverlayArc arcOf(const std::vector<Vec2>& points) {
  OverlayArc arc;
  arc.points = points;
  arc.center = {200, 200};
  return arc;
}

OverlayLine lineFrom(const Vec2& start, const Vec2& end) {
  OverlayLine line;
  line.line = {start, end};
  return line;
}

}  // namespace

TEST_CASE("a line is a stroke between two arrowheads whose tips are its ends; only the draggable one has the handle's colour") {
  const std::vector<OverlayShape> shapes = build(lineFrom({100, 50}, {300, 50}));
  const std::vector<OverlayShape> dark = withInk(shapes, 1);
  const std::vector<OverlayShape> orange = withInk(shapes, 4);
  REQUIRE(dark.size() == 2);
  REQUIRE(orange.size() == 1);
  CHECK(dark[0].kind == Kind::kStroke);
  CHECK(dark[0].startPx.x > 100.0F);
  CHECK(dark[0].endPx.x < 300.0F);
  CHECK(dark[1].kind == Kind::kArrow);
  CHECK(dark[1].startPx == glm::vec2(100, 50));
  CHECK(dark[1].endPx == glm::vec2(100 + kArrowLengthPx, 50));
  CHECK(orange[0].startPx == glm::vec2(300, 50));
  CHECK(orange[0].endPx == glm::vec2(300 - kArrowLengthPx, 50));
  CHECK(orange[0].halfWidthPx == Approx(kArrowHalfWidthPx));
}

TEST_CASE("the stroke ends where the arrowheads are wide enough to hide its corners") {
  for (const OverlayShape& stroke : withInk(build(lineFrom({0, 0}, {200, 0})), 1)) {
    if (stroke.kind != Kind::kStroke) continue;
    const float intoArrow = stroke.startPx.x;
    const auto arrowHalfWidth = static_cast<float>(kArrowHalfWidthPx / kArrowLengthPx) * intoArrow;
    CHECK(arrowHalfWidth > stroke.halfWidthPx);
    CHECK(intoArrow < static_cast<float>(kArrowLengthPx));
  }
}

TEST_CASE("a line is interrupted around its label, with padding") {
  OverlayLine line = lineFrom({100, 50}, {300, 50});
  line.label = Box2{{180, 40}, {220, 60}};
  std::vector<OverlayShape> strokes;
  for (const OverlayShape& shape : withInk(build(line), 1)) {
    if (shape.kind == Kind::kStroke) strokes.push_back(shape);
  }
  REQUIRE(strokes.size() == 2);
  CHECK(strokes[0].endPx.x == Approx(180 - kLabelPaddingPx));
  CHECK(strokes[1].endPx.x == Approx(220 + kLabelPaddingPx));
  CHECK(strokes[1].startPx.x > 285.0F);   // from its own arrowhead inwards
}

TEST_CASE("a label beside a line leaves it whole") {
  OverlayLine line = lineFrom({100, 50}, {300, 50});
  line.label = Box2{{310, 40}, {350, 60}};
  CHECK(withInk(build(line), 1).size() == 2);
  line.label = Box2{{180, 70}, {220, 90}};
  CHECK(withInk(build(line), 1).size() == 2);
}

TEST_CASE("extension lines stand off the base line and run past the final line") {
  OverlayLine line = lineFrom({100, 50}, {300, 50});
  const std::vector<Vec2> start{{100, 150}, {100, 50}};
  const std::vector<Vec2> end{{300, 150}, {320, 100}, {300, 50}};
  line.extensionStart = start;
  line.extensionEnd = end;
  const std::vector<OverlayShape> extensions = withInk(build(line), 3);
  REQUIRE(extensions.size() == 3);
  CHECK(extensions[0].startPx == glm::vec2(100, 150 - kExtensionGapPx));
  CHECK(extensions[0].endPx == glm::vec2(100, 50 - kExtensionOvershootPx));
  CHECK(extensions[1].endPx == glm::vec2(320, 100));
  CHECK(extensions[2].startPx == glm::vec2(320, 100));
  CHECK(extensions[2].endPx.y < 50.0F);
}

TEST_CASE("an extension line shorter than its gap is left out") {
  OverlayLine line = lineFrom({100, 50}, {300, 50});
  const std::vector<Vec2> start{{100, 53}, {100, 50}};
  line.extensionStart = start;
  CHECK(withInk(build(line), 3).empty());
}

TEST_CASE("an extension line that two lines share is drawn once, as strong as the stronger of them") {
  const std::vector<Vec2> shared{{200, 150}, {200, 50}};
  const std::vector<Vec2> own{{300, 150}, {300, 50}};
  std::vector<OverlayLine> lines{lineFrom({100, 50}, {200, 50}), lineFrom({200, 50}, {300, 50})};
  lines[0].extensionEnd = shared;
  lines[0].opacity = 0.25F;
  lines[1].extensionStart = shared;
  lines[1].extensionEnd = own;
  std::vector<OverlayShape> shapes;
  buildOverlay({.lines = lines}, testTheme(), shapes);
  const std::vector<OverlayShape> extensions = withInk(shapes, 3);
  REQUIRE(extensions.size() == 2);
  CHECK(opacityOf(extensions[0]) == 255);
  CHECK(opacityOf(extensions[1]) == 255);
}

TEST_CASE("an indirect line is stippled") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  CHECK(withInk(build(line), 1)[0].dashPx == 0.0F);
  line.indirect = true;
  CHECK(withInk(build(line), 1)[0].dashPx > 0.0F);
}

TEST_CASE("what the model hides of a line is faint and without a halo, but for its ends and while the pointer is at it") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  line.label = Box2{{80, -10}, {120, 10}};
  line.depths = EndDepths(0.2F, 0.6F);
  unsigned strokes = 0;
  for (const OverlayShape& shape : build(line)) {
    CHECK(opacityOf(shape) == 255);   // where nothing hides it
    if (shape.kind != Kind::kStroke) {
      CHECK(shape.hiddenShare == 1.0F);
      continue;
    }
    ++strokes;
    CHECK(shape.hiddenShare < (inkOf(shape) == 6 ? 0.01F : 0.5F));
    // Depth grows evenly along the line, whichever end a piece is drawn from.
    CHECK(shape.depths.x == Approx(0.2 + 0.4 * static_cast<double>(shape.startPx.x) / 200));
    CHECK(shape.depths.y == Approx(0.2 + 0.4 * static_cast<double>(shape.endPx.x) / 200));
  }
  CHECK(strokes == 4);
  line.hovered = true;
  for (const OverlayShape& shape : build(line)) CHECK(shape.hiddenShare == 1.0F);
  line.hovered = false;
  line.depths.reset();
  for (const OverlayShape& shape : build(line)) CHECK(shape.hiddenShare == 1.0F);
}

TEST_CASE("hovering changes the colours and widens the stroke; the handle's size is the caller's") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  const float atRest = withInk(build(line), 1)[0].halfWidthPx;
  line.hovered = true;
  line.handleScale = 1.5F;
  const std::vector<OverlayShape> shapes = build(line);
  CHECK(withInk(shapes, 1).empty());
  CHECK(withInk(shapes, 2)[0].halfWidthPx > atRest);
  const std::vector<OverlayShape> handles = withInk(shapes, 5);
  REQUIRE(handles.size() == 1);
  CHECK(glm::length(handles[0].endPx - handles[0].startPx) == Approx(1.5 * kArrowLengthPx));
}

TEST_CASE("the arrowheads of a short line leave something of it between them") {
  for (const double length : {4.0, 8.0, 15.0, 23.0}) {
    OverlayLine line = lineFrom({0, 0}, {length, 0});
    line.handleScale = 2.0F;
    double arrows = 0;
    for (const OverlayShape& shape : build(line)) {
      if (shape.kind == Kind::kArrow && inkOf(shape) != 6) arrows += static_cast<double>(glm::length(shape.endPx - shape.startPx));
    }
    CHECK(arrows > 0.3 * length);
    CHECK(arrows < 0.8 * length);
  }
}

TEST_CASE("the arrowheads of a short line are broader for their length, never broader than others") {
  double lastHalfWidth = 0;
  for (const double length : {4.0, 8.0, 16.0, 24.0, 40.0}) {
    OverlayLine line = lineFrom({0, 0}, {length, 0});
    for (const OverlayShape& shape : build(line)) {
      if (shape.kind != Kind::kArrow || inkOf(shape) == 6) continue;
      const auto headPx = static_cast<double>(glm::length(shape.endPx - shape.startPx));
      const auto halfWidthPx = static_cast<double>(shape.halfWidthPx);
      CHECK(halfWidthPx <= kArrowHalfWidthPx + 1e-6);
      CHECK(halfWidthPx >= lastHalfWidth);
      if (headPx < kArrowLengthPx) CHECK(halfWidthPx / headPx > kArrowHalfWidthPx / kArrowLengthPx + 0.01);
      lastHalfWidth = halfWidthPx;
    }
  }
  CHECK(lastHalfWidth == Approx(kArrowHalfWidthPx));
}

TEST_CASE("all halos lie under all ink") {
  std::vector<OverlayLine> lines{lineFrom({0, 0}, {100, 0}), lineFrom({50, -50}, {50, 50})};
  std::vector<OverlayShape> shapes;
  buildOverlay({.lines = lines}, testTheme(), shapes);
  std::size_t lastHalo = 0;
  std::size_t firstInk = shapes.size();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (inkOf(shapes[i]) == 6) {
      lastHalo = i;
    } else {
      firstInk = std::min(firstInk, i);
    }
  }
  CHECK(lastHalo + 1 == firstInk);
}

TEST_CASE("the halo of an arrowhead keeps the same distance on all three sides") {
  OverlayLine line = lineFrom({0, 0}, {100, 0});
  OverlayShape halo;
  OverlayShape arrow;
  for (const OverlayShape& shape : build(line)) {
    if (shape.kind != Kind::kArrow || shape.endPx.x > 50.0F) continue;
    (inkOf(shape) == 6 ? halo : arrow) = shape;
  }
  const float back = halo.endPx.x - arrow.endPx.x;
  REQUIRE(back > 0.0F);
  // The slanted sides are parallel; their distance is that of the tips along the axis times the sine of half the tip's angle.
  const float slope = arrow.halfWidthPx / arrow.endPx.x;
  CHECK(halo.halfWidthPx / (halo.endPx.x - halo.startPx.x) == Approx(slope));
  CHECK((arrow.startPx.x - halo.startPx.x) * slope / std::sqrt(1 + slope * slope) == Approx(back));
}

TEST_CASE("opacity fades every part of a line; what cannot be seen is left out") {
  OverlayLine line = lineFrom({0, 0}, {100, 0});
  line.opacity = 0.5F;
  for (const OverlayShape& shape : build(line)) CHECK(opacityOf(shape) == 128);
  line.opacity = 0.0F;
  CHECK(build(line).empty());
  CHECK(build(lineFrom({3, 3}, {3, 3})).empty());
  CHECK(build(lineFrom({0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0})).empty());
  CHECK(build(lineFrom({0, 0}, {std::numeric_limits<double>::infinity(), 0})).empty());
}

TEST_CASE("balls stand about the ends of a line, the draggable one in the handle's colour, and grow with the handle") {
  OverlayLine line = lineFrom({100, 50}, {300, 50});
  line.sphereEnds = true;
  line.handleScale = 1.5F;
  std::vector<OverlayShape> shapes = build(line);
  CHECK(std::ranges::none_of(shapes, [](const OverlayShape& shape) { return shape.kind == Kind::kArrow; }));
  const std::vector<OverlayShape> orange = withInk(shapes, 4);
  REQUIRE(orange.size() == 1);
  CHECK(orange[0].kind == Kind::kDisc);
  CHECK(0.5F * (orange[0].startPx + orange[0].endPx) == glm::vec2(300, 50));
  CHECK(orange[0].halfWidthPx == Approx(1.5 * kSphereRadiusPx));
  const std::vector<OverlayShape> dark = withInk(shapes, 1);
  REQUIRE(dark.size() == 2);   // the stroke, and the ball that cannot be dragged
  CHECK(dark[0].startPx.x < 100 + static_cast<float>(kSphereRadiusPx));   // the stroke begins within the ball
  CHECK(0.5F * (dark[1].startPx + dark[1].endPx) == glm::vec2(100, 50));
  CHECK(dark[1].halfWidthPx == Approx(kSphereRadiusPx));
}

TEST_CASE("an author's colour takes the theme's place but for what can be dragged, and is darker under the pointer") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  line.color = srgb(0x0000C8);
  const std::vector<OverlayShape> shapes = build(line);
  CHECK(withInk(shapes, 200).size() == 2);
  CHECK(withInk(shapes, 1).empty());
  CHECK(withInk(shapes, 4).size() == 1);
  line.hovered = true;
  CHECK(withInk(build(line), 160).size() == 2);

  PlacedLine placed;
  placed.placement = PlacementKind::kOutside;
  CHECK_FALSE(overlayLine(placed, {}, {}).color);
  placed.look.color = {255, 51, 0};
  const auto color = overlayLine(placed, {}, {}).color;
  REQUIRE(color);
  CHECK(color->r == Approx(1.0F));
  CHECK(color->g == Approx(0.2F));
  CHECK(color->b == 0.0F);
}

TEST_CASE("an arc runs from arrowhead to arrowhead along its points; only the moving end has the handle's colour") {
  const std::vector<Vec2> points = quarter();
  const std::vector<OverlayShape> shapes = build(arcOf(points));
  const std::vector<OverlayShape> orange = withInk(shapes, 4);
  REQUIRE(orange.size() == 1);
  CHECK(orange[0].kind == Kind::kArrow);
  CHECK(glm::length(Vec2(orange[0].startPx) - points.back()) < 1e-4);
  // The arrowhead's axis is the chord that it covers: its back lies on the circle, or next to it.
  CHECK(std::abs(glm::length(Vec2(orange[0].endPx) - Vec2(200, 200)) - 100) < 0.5);

  std::vector<OverlayShape> pieces;
  for (const OverlayShape& shape : withInk(shapes, 1)) {
    if (shape.kind == Kind::kCurve) pieces.push_back(shape);
  }
  REQUIRE(pieces.size() > 15);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK(std::abs(glm::length(Vec2(pieces[i].startPx) - Vec2(200, 200)) - 100) < 0.1);
    if (i == 0) continue;
    // Neighbours meet in a point, and are cut along the same line there: the half of the bend each, so leans that differ in sign only.
    CHECK(glm::length(pieces[i].startPx - pieces[i - 1].endPx) < 1e-3F);
    CHECK(pieces[i].lean.x == Approx(-pieces[i - 1].lean.y).margin(1e-5));
    CHECK(std::abs(pieces[i].lean.x) == Approx(std::tan(1.5707963267948966 / 24 / 2)).epsilon(0.01));
  }
  CHECK(pieces.front().startPx.y < 199.0F);   // within the arrowheads, not at their tips
  CHECK(pieces.back().endPx.x > 201.0F);
}

TEST_CASE("an arc's legs are extension lines from its centre past its ends") {
  const std::vector<Vec2> points = quarter();
  const std::vector<OverlayShape> legs = withInk(build(arcOf(points)), 3);
  REQUIRE(legs.size() == 2);
  CHECK(legs[0].startPx.x == Approx(200 + kExtensionGapPx));
  CHECK(legs[0].endPx.x == Approx(300 + kExtensionOvershootPx));
  CHECK(legs[1].endPx.y == Approx(100 - kExtensionOvershootPx));
}

TEST_CASE("an arc that is hovered, fades, or cannot be drawn") {
  const std::vector<Vec2> points = quarter();
  OverlayArc arc = arcOf(points);
  arc.hovered = true;
  arc.handleScale = 1.5F;
  const std::vector<OverlayShape> handles = withInk(build(arc), 5);
  REQUIRE(handles.size() == 1);
  CHECK(glm::length(handles[0].endPx - handles[0].startPx) == Approx(1.5 * kArrowLengthPx));
  arc.opacity = 0.5F;
  for (const OverlayShape& shape : withInk(build(arc), 5)) CHECK(opacityOf(shape) == 128);
  arc.opacity = 0.0F;
  CHECK(build(arc).empty());
  std::vector<Vec2> broken = points;
  broken[3].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(build(arcOf(broken)).empty());
  CHECK(build(arcOf({})).empty());
}

TEST_CASE("a thread runs from its dot to the edge of the box, and is not drawn inside it") {
  OverlayThread thread;
  thread.anchor = {100, 100};
  thread.box = {{200, 86}, {300, 114}};
  std::vector<OverlayShape> shapes = build(thread);
  const std::vector<OverlayShape> threads = withInk(shapes, 3);
  REQUIRE(threads.size() == 1);
  CHECK(threads[0].startPx == glm::vec2(100, 100));
  CHECK(threads[0].endPx == glm::vec2(200, 100));
  const std::vector<OverlayShape> dots = withInk(shapes, 1);
  REQUIRE(dots.size() == 1);
  CHECK(dots[0].kind == Kind::kDisc);
  CHECK(0.5F * (dots[0].startPx + dots[0].endPx) == glm::vec2(100, 100));
  thread.anchor = {250, 100};
  CHECK(build(thread).empty());
}

TEST_CASE("a drag's marks are quieter than lines, but for the limit that is reached") {
  using Mark = DragMark::Kind;
  std::vector<DragMark> marks;
  for (const Mark kind : {Mark::kTick, Mark::kLongTick, Mark::kLimit, Mark::kGhost, Mark::kLimitReached}) {
    marks.push_back({kind, {{100, 100}, {100, 110}}, 0.5});
  }
  std::vector<OverlayShape> shapes;
  buildOverlay({.marks = marks}, testTheme(), shapes);
  REQUIRE(shapes.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(inkOf(shapes[i]) == 1);
    REQUIRE(opacityOf(shapes[i]) < 100);
    REQUIRE(shapes[i].halfWidthPx <= 0.75F);
  }
  REQUIRE(inkOf(shapes[4]) == 5);
  REQUIRE(opacityOf(shapes[4]) == 128);
  marks[0].line.start.x = std::numeric_limits<double>::quiet_NaN();
  buildOverlay({.marks = marks}, testTheme(), shapes);
  REQUIRE(shapes.size() == 4);
}

TEST_CASE("what the model hides of extension lines is faint, at the depth that they have there") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  const std::vector<Vec2> bent{{0, 100}, {0, 60}, {0, 0}};
  line.extensionStart = bent;
  line.extensionDepths = {{0.5F, 0.1F}, EndDepths(0.6F, 0.1F), {0.2F, 0.1F}};
  for (const unsigned ink : {3U, 6U}) {
    std::vector<OverlayShape> pieces = withInk(build(line), ink);
    std::erase_if(pieces, [](const OverlayShape& shape) { return shape.kind != Kind::kStroke || shape.startPx.x > 1.0F || shape.endPx.x > 1.0F; });
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].depths.x == Approx(0.5 + 0.1 * kExtensionGapPx / 40));
    CHECK(pieces[0].depths.y == Approx(0.6));
    CHECK(pieces[1].depths.x == Approx(0.6));
    CHECK(pieces[1].depths.y == Approx(0.2));
    for (const OverlayShape& piece : pieces) CHECK(piece.hiddenShare < (ink == 6 ? 0.01F : 0.5F));
  }
  line.active = true;
  for (const OverlayShape& shape : build(line)) CHECK(shape.hiddenShare == 1.0F);
}

TEST_CASE("a jog of an extension line is as deep as the line would be there without it") {
  OverlayLine line = lineFrom({0, 0}, {200, 0});
  const auto jogDepth = [&](const std::vector<Vec2>& polyline) {
    line.extensionStart = polyline;
    std::vector<OverlayShape> pieces = withInk(build(line), 3U);
    std::erase_if(pieces, [](const OverlayShape& shape) { return shape.kind != Kind::kStroke || shape.startPx.x > 9.0F; });
    REQUIRE(pieces.size() == polyline.size() - 1);
    CHECK(pieces.back().depths.x == pieces[pieces.size() - 2].depths.y);
    CHECK(pieces.back().depths.y == Approx(0.2));
    return pieces.back().depths.x;
  };
  // The jog is a quarter of the way from the line's end to the base line, or to the bend at the plane.
  line.extensionDepths = {EndDepths(0.6F), std::nullopt, EndDepths(0.2F)};
  CHECK(jogDepth({{0, 100}, {5, 25}, {0, 0}}) == Approx(0.3).margin(0.005));
  line.extensionDepths = {EndDepths(0.7F), EndDepths(0.6F), EndDepths(0.2F)};
  CHECK(jogDepth({{0, 140}, {0, 100}, {5, 25}, {0, 0}}) == Approx(0.3).margin(0.005));
}

TEST_CASE("an extension line that two lines share is as clear as the clearer of them") {
  std::array<OverlayLine, 2> lines{lineFrom({0, 0}, {100, 0}), lineFrom({0, 0}, {100, 0})};
  const std::vector<Vec2> shared{{0, 100}, {0, 0}};
  for (OverlayLine& line : lines) {
    line.extensionStart = shared;
    line.extensionDepths = ExtensionDepths{};
  }
  lines[1].hovered = true;
  std::vector<OverlayShape> shapes;
  buildOverlay({.lines = lines}, testTheme(), shapes);
  const std::vector<OverlayShape> hairs = withInk(shapes, 3);
  REQUIRE(hairs.size() == 1);
  CHECK(hairs[0].hiddenShare == 1.0F);
}

TEST_CASE("edges of a scope lie under everything else; what the model hides of them is faint, or left out") {
  const EndDepths depths(0.3F, 0.7F);
  const std::vector<OverlayEdge> edges{{{{10, 10}, {60, 10}}, depths, true, 1.0F}, {{{10, 40}, {60, 40}}, depths, false, 1.0F}, {{{10, 40}, {10.1, 40}}, depths, true, 1.0F}};
  OverlayLine line;
  line.line = {{100, 100}, {300, 100}};
  std::vector<OverlayShape> shapes;
  buildOverlay({.lines = {&line, 1}, .edges = edges}, testTheme(), shapes);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(inkOf(shapes[i]) == (i % 2 == 0 ? 6U : 5U));   // halo, ink, halo, ink
    CHECK(shapes[i].depths == depths);
  }
  CHECK(shapes[1].hiddenShare > 0.1F);
  CHECK(shapes[1].hiddenShare < 0.5F);
  for (const std::size_t i : {0U, 2U, 3U}) CHECK(shapes[i].hiddenShare == 0.0F);
  CHECK(shapes[4].startPx.x > 60);  // the third edge has no length; then come the line's shapes
}

TEST_CASE("inside the model a line can be hidden, but not by its own scope unless it is one of that scope's edges") {
  const Scene scene = sceneOf({{"Box", boxAt({-4, 0, -3}, {8, 5, 6})}});
  Camera camera;
  camera.eye = {0, 2.5, 30};
  camera.target = {0, 2.5, 0};
  const View view(camera, 400, 400, scene.bounds);
  PlacedLine placed;
  placed.placement = PlacementKind::kInside;
  placed.type = HandleType::kLinearContour;
  placed.base = placed.line = {{-4, 0, -3}, {4, 0, -3}};
  placed.baseScreen = placed.lineScreen = view.toScreen(placed.line);
  placed.handles.push_back({false, placed.lineScreen.start});
  const OverlayLine edge = overlayLine(placed, scene, view);
  CHECK(edge.line.start == placed.lineScreen.start);
  CHECK(edge.startDraggable);
  CHECK_FALSE(edge.endDraggable);
  const double frontFace = view.windowDepth({0, 2.5, 3});
  REQUIRE(edge.depths);
  CHECK(static_cast<double>(edge.depths->x) > frontFace);
  CHECK(static_cast<double>(edge.depths->x) < view.windowDepth({-4, 0, -3}));   // by its skin

  placed.type = HandleType::kLinearCenter;
  placed.line = {{-4, 2.5, 0}, {4, 2.5, 0}};
  const OverlayLine center = overlayLine(placed, scene, view);
  REQUIRE(center.depths);
  CHECK(static_cast<double>(center.depths->x) < frontFace);
  CHECK(static_cast<double>(center.depths->x) > view.windowDepth({0, 2.5, 6}));   // what stands before the box still hides it

  // Outside nothing hides the line, but its extension lines may begin behind the model.
  placed.type = HandleType::kLinearContour;
  placed.placement = PlacementKind::kOutside;
  placed.foot = {{-4, 0, -4}, {4, 0, -4}};
  placed.line = {{-4, -3, -4}, {4, -3, -4}};
  const OverlayLine outside = overlayLine(placed, scene, view);
  CHECK_FALSE(outside.depths);
  REQUIRE(outside.extensionDepths);
  REQUIRE(outside.extensionDepths->foot);
  CHECK(static_cast<double>(outside.extensionDepths->base.x) > frontFace);
  CHECK(outside.extensionDepths->base.x < outside.extensionDepths->foot->x);
  CHECK(outside.extensionDepths->foot->x == Approx(outside.extensionDepths->line.x).margin(1e-3));
  placed.foot = placed.base;
  CHECK_FALSE(overlayLine(placed, scene, view).extensionDepths->foot);   // nothing bends there
}
