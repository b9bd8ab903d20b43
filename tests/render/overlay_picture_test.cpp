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
  Picture drawLine(const OverlayLine& line, double ratio) { return draw(View({}, kSizePx, kSizePx, {}), ratio, {&line, 1}); }
};

/// Ink, 0 to 1, of a pixel.
double ink(const Picture& picture, int x, int y) { return 1.0 - static_cast<double>(picture.at(x, y).g) / 255.0; }

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
