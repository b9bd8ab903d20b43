#include "render/picture.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "core/constants.h"

using namespace dimline;
using test::Picture;
using test::PictureFixture;

namespace {

constexpr double kSizePx = 120;

/// Nothing but white paper, and lines on it without halos.
struct PaperFixture : PictureFixture {
  PaperFixture() {
    setScene(Scene{});
    options.theme.backgroundTop = options.theme.backgroundBottom = srgb(0xFFFFFF);
    options.theme.line = options.theme.extension = options.theme.handle = srgb(0x000000);
    options.theme.halo = srgb(0xFFFFFF, 0.0F);
  }
  Picture drawLine(const OverlayLine& line, double ratio) { return draw(View({}, kSizePx, kSizePx, {}), ratio, {.lines = {&line, 1}}); }
  Picture drawArc(const OverlayArc& arc, double ratio) { return draw(View({}, kSizePx, kSizePx, {}), ratio, {.arcs = {&arc, 1}}); }
};

/// Ink, 0 to 1, of a pixel. The paper is dithered, which some graphics cards round down by a step where it is white: one step alone is none.
double ink(const Picture& picture, int x, int y) {
  const double steps = 255.0 - static_cast<double>(picture.at(x, y).g);
  return steps > 1 ? steps / 255.0 : 0.0;
}

struct RowOfInk {
  double sum = 0;      ///< device px
  double middle = 0;   ///< device px
};

RowOfInk rowOfInk(const Picture& picture, int y) {
  RowOfInk row;
  for (int x = 0; x < picture.width; ++x) {
    row.sum += ink(picture, x, y);
    row.middle += ink(picture, x, y) * (x + 0.5);
  }
  row.middle /= std::max(row.sum, 1e-9);
  return row;
}

}  // namespace

TEST_CASE("a line lies where it was asked to a fraction of a pixel, in its width, at any pixel ratio") {
  PaperFixture fixture;
  for (const double ratio : {1.0, 1.5, 3.0}) {
    for (const double x : {60.0, 60.25, 60.5, 60.8}) {
      OverlayLine line;
      line.line = {{x, 10}, {x, 110}};
      const Picture picture = fixture.drawLine(line, ratio);
      for (const double y : {40.0, 60.0, 77.0}) {
        const int row = static_cast<int>(y * ratio);
        INFO("ratio " << ratio << ", x " << x);
        CHECK(rowOfInk(picture, row).sum / ratio == Approx(1.25).margin(0.03));
        for (int column = 0; column < picture.width; ++column) {
          // The part of the pixel that the line covers.
          const double covered = std::min(column + 1.0, (x + 0.625) * ratio) - std::max(column + 0.0, (x - 0.625) * ratio);
          REQUIRE(ink(picture, column, row) == Approx(std::max(covered, 0.0)).margin(0.01));
        }
      }
    }
  }
}

TEST_CASE("a slanted line has the same ink everywhere along it") {
  PaperFixture fixture;
  OverlayLine line;
  line.line = {{50, 10}, {70, 110}};
  const Picture picture = fixture.drawLine(line, 1);
  const double slant = std::sqrt(1 + 0.2 * 0.2);
  for (int y = 30; y < 90; ++y) {
    CHECK(rowOfInk(picture, y).sum == Approx(1.25 * slant).margin(0.12));
    CHECK(rowOfInk(picture, y).middle == Approx(50 + (y + 0.5 - 10) * 0.2).margin(0.1));
  }
}

TEST_CASE("arrowheads end at their tips and are as wide as the constants say") {
  PaperFixture fixture;
  for (const double ratio : {1.0, 1.5, 3.0}) {
    OverlayLine line;
    line.line = {{60, 20}, {60, 100}};
    const Picture picture = fixture.drawLine(line, ratio);
    const double across = kArrowHalfWidthPx * 2;
    // The width grows evenly from the tip; a row's ink is its width at the row's middle.
    for (const double fromTip : {4.0, 8.0}) {
      const int y = static_cast<int>((20 + fromTip) * ratio);
      const double expected = across * ((y + 0.5) / ratio - 20) / kArrowLengthPx;
      CHECK(rowOfInk(picture, y).sum / ratio == Approx(expected).margin(0.15));
    }
    CHECK(rowOfInk(picture, static_cast<int>(18 * ratio)).sum == 0);
    CHECK(rowOfInk(picture, static_cast<int>(102 * ratio)).sum == 0);
  }
}

TEST_CASE("a line is interrupted where its label is, and nowhere else") {
  PaperFixture fixture;
  OverlayLine line;
  line.line = {{60, 10}, {60, 110}};
  line.label = Box2{{45, 52}, {75, 68}};
  const Picture picture = fixture.drawLine(line, 1);
  for (int y = 49; y < 71; ++y) CHECK(rowOfInk(picture, y).sum == 0);
  CHECK(rowOfInk(picture, 46).sum == Approx(1.25).margin(0.03));
  CHECK(rowOfInk(picture, 73).sum == Approx(1.25).margin(0.03));
}

TEST_CASE("a stippled line is half ink, half paper") {
  PaperFixture fixture;
  OverlayLine line;
  line.line = {{60, 5}, {60, 115}};
  line.indirect = true;
  const Picture picture = fixture.drawLine(line, 1);
  double sum = 0;
  int bare = 0;
  for (int y = 30; y < 86; ++y) {
    sum += rowOfInk(picture, y).sum;
    bare += rowOfInk(picture, y).sum < 0.05 ? 1 : 0;
  }
  CHECK(sum / 56 == Approx(1.25 / 2).margin(0.05));
  CHECK(bare >= 14);
}

TEST_CASE("opacity and colour come out as asked; a halo lightens what is under the line") {
  PaperFixture fixture;
  OverlayLine line;
  line.line = {{20, 60.5}, {100, 60.5}};
  line.opacity = 0.5F;
  fixture.options.theme.line = srgb(0xFF0000);
  CHECK(ink(fixture.drawLine(line, 1), 60, 60) == Approx(0.5).margin(0.01));
  CHECK(fixture.drawLine(line, 1).at(60, 60).r == 255);

  fixture.options.theme.backgroundTop = fixture.options.theme.backgroundBottom = srgb(0x808080);
  fixture.options.theme.halo = srgb(0xFFFFFF, 0.6F);
  line.opacity = 1.0F;
  const Picture picture = fixture.drawLine(line, 1);
  CHECK(picture.at(60, 59).g > 140);
  CHECK(picture.at(60, 50).g == Approx(128).margin(1));
}

TEST_CASE("a curve has the same ink everywhere: its pieces leave no seams") {
  PaperFixture fixture;
  std::vector<Vec2> points;
  for (int i = 0; i <= 48; ++i) {
    const double rad = 3.141592653589793 * i / 48;
    points.emplace_back(60 + 50 * std::cos(rad), 100 - 50 * std::sin(rad));
  }
  OverlayArc arc;
  arc.points = points;
  arc.center = {60, 300};   // its legs leave the picture
  // Opacities that are a whole number of steps, so that no rounding is between them and the picture.
  for (const float opacity : {1.0F, 128.0F / 255.0F}) {
    arc.opacity = opacity;
    for (const double ratio : {1.0, 3.0}) {
      const Picture picture = fixture.drawArc(arc, ratio);
      // Ink by direction from the centre, in sectors of five degrees away from the arrowheads. The first is half a sector early: the pixels along a
      // diagonal lie in the middle of one.
      std::vector<double> sectors(37, 0.0);
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          const Vec2 offset((x + 0.5) / ratio - 60, 100 - (y + 0.5) / ratio);
          const double radius = glm::length(offset);
          if (offset.y <= 0 || radius < 46 || radius > 54) continue;
          sectors[static_cast<std::size_t>(std::atan2(offset.y, offset.x) / 3.141592653589793 * 36 + 0.5)] += ink(picture, x, y) / (ratio * ratio);
        }
      }
      const double expected = 1.25 * 50 * 3.141592653589793 / 36 * static_cast<double>(opacity);
      double mean = 0;
      for (std::size_t i = 6; i < 30; ++i) {
        INFO("opacity " << opacity << ", ratio " << ratio << ", sector " << i);
        CHECK(sectors[i] == Approx(expected).epsilon(ratio > 2 ? 0.06 : 0.2));
        mean += sectors[i] / 24;
      }
      CHECK(mean == Approx(expected).epsilon(0.02));
    }
  }
}

TEST_CASE("a ball's disc is round and as large as its radius says, at any pixel ratio") {
  PaperFixture fixture;
  fixture.options.theme.line = srgb(0xFF0000);
  for (const double ratio : {1.0, 2.0}) {
    OverlayLine line;
    line.line = {{60, 30}, {60, 90}};
    line.sphereEnds = true;
    line.endDraggable = false;
    const Picture picture = fixture.drawLine(line, ratio);
    double area = 0;
    for (int y = 0; y < static_cast<int>(30 * ratio); ++y) area += rowOfInk(picture, y).sum;
    // The half of the ball that lies beyond the line's end; its highlight takes some of the ink.
    const double half = 0.5 * 3.141592653589793 * kSphereRadiusPx * kSphereRadiusPx;
    CHECK(area / (ratio * ratio) > 0.6 * half);
    CHECK(area / (ratio * ratio) < 1.02 * half);
    CHECK(rowOfInk(picture, static_cast<int>((30 - kSphereRadiusPx - 1) * ratio)).sum == 0);
    CHECK(rowOfInk(picture, static_cast<int>(30 * ratio)).middle / ratio == Approx(60).margin(0.6));
  }
}
