#include "placement/text_metrics.h"

#include <catch2/catch.hpp>
#include <string>

using dimline::labelSizePx;
using dimline::textWidthPx;

// The font's units are thousandths of the size, so at 1000 px a width is the sum of the glyphs' advances:
// 0 566, 2 544, 4 570, point 275, space 200, m 826 (as any font viewer shows them for Barlow Medium).

TEST_CASE("a text is as wide as its glyphs' advances", "[text]") {
  CHECK(textWidthPx("2.40 m", 1000) == 544 + 275 + 570 + 566 + 200 + 826);
  CHECK(textWidthPx("2.40 m", 14) == Approx(0.014 * 2981));
  CHECK(textWidthPx("", 14) == 0);
  CHECK(textWidthPx(" ", 1000) == 200);
}

TEST_CASE("width is additive: there is no kerning", "[text]") {
  CHECK(textWidthPx("AVATAR To.", 1000) ==
        textWidthPx("AVA", 1000) + textWidthPx("TAR", 1000) + textWidthPx(" To.", 1000));
}

TEST_CASE("characters beyond ASCII count once, whatever their bytes", "[text]") {
  CHECK(textWidthPx("35\u00B0", 1000) == 524 + 523 + 379);
  CHECK(textWidthPx("m\u00B2", 1000) == 826 + 332);
  CHECK(textWidthPx("\u2212", 1000) == textWidthPx("+", 1000));  // a minus is as wide as a plus
  CHECK(textWidthPx("\u2026", 1000) == 815);
}

TEST_CASE("a character outside the table counts as an m", "[text]") {
  CHECK(textWidthPx("\u4E2D", 1000) == 826);      // three bytes
  CHECK(textWidthPx("\U0001F3E0", 1000) == 826);  // four bytes
  CHECK(textWidthPx("\n", 1000) == 826);
  CHECK(textWidthPx("a\u007Fb", 1000) == 517 + 826 + 553);
}

TEST_CASE("broken UTF-8 is measured byte by byte and never read past its end", "[text]") {
  CHECK(textWidthPx("\xFF\xFE", 1000) == 2 * 826);
  CHECK(textWidthPx("\x80", 1000) == 826);
  CHECK(textWidthPx("\xC0\xA0", 1000) == 2 * 826);  // an overlong space
  CHECK(textWidthPx("\xC2", 1000) == 826);          // ends in the middle
  CHECK(textWidthPx("\xE2\x80", 1000) == 2 * 826);
  CHECK(textWidthPx("\xC2m", 1000) == 2 * 826);  // what follows is kept
  CHECK(textWidthPx(std::string("1\0"
                                "1",
                                3),
                    1000) == 352 + 826 + 352);
}

TEST_CASE("a label is one line of 14 px text", "[text]") {
  const dimline::Vec2 size = labelSizePx("12.00 m");
  CHECK(size.x == Approx(textWidthPx("12.00 m", 14)));
  CHECK(size.y == Approx(16.8));
}
