// Made by tools/make_text_metrics.mjs from assets/fonts/barlow-500.woff2 (Barlow Medium, SIL Open Font License 1.1). Do not edit.
#pragma once

#include <array>
#include <cstdint>

/// The label font's metrics, in font units.
namespace dimline::barlow {

// clang-format off

inline constexpr int kUnitsPerEm = 1000;
inline constexpr int kAscender = 1000;
inline constexpr int kDescender = -200;

/// Advances of U+0020 to U+007E.
inline constexpr char32_t kBasicLatinFirst = 0x0020;
inline constexpr std::array<std::int16_t, 95> kBasicLatin{
    200, 328, 297, 669, 563, 839, 675, 145, 291, 291, 398, 495, 264, 400, 275, 426,
    566, 352, 544, 524, 570, 523, 523, 481, 527, 525, 348, 312, 495, 495, 495, 482,
    823, 630, 624, 607, 618, 598, 565, 613, 645, 260, 579, 616, 570, 715, 673, 622,
    593, 582, 613, 588, 574, 641, 601, 878, 604, 585, 551, 393, 426, 393, 458, 498,
    209, 517, 553, 526, 553, 536, 367, 543, 542, 255, 248, 512, 235, 826, 542, 555,
    558, 558, 371, 487, 369, 538, 491, 743, 499, 476, 451, 329, 179, 329, 513,
};

/// Advances of U+00A0 to U+00FF.
inline constexpr char32_t kLatin1First = 0x00A0;
inline constexpr std::array<std::int16_t, 96> kLatin1{
    200, 328, 526, 609, 540, 687, 179, 468, 360, 850, 326, 529, 495, 400, 449, 278,
    379, 495, 332, 323, 209, 548, 594, 219, 151, 188, 358, 529, 813, 798, 907, 482,
    630, 630, 630, 630, 630, 630, 935, 607, 598, 598, 598, 598, 260, 260, 260, 260,
    678, 672, 622, 622, 622, 622, 622, 430, 622, 641, 641, 641, 641, 585, 572, 563,
    517, 517, 517, 517, 517, 517, 834, 526, 537, 537, 537, 537, 221, 221, 221, 221,
    538, 542, 541, 541, 541, 541, 541, 495, 530, 541, 541, 541, 541, 476, 544, 476,
};

/// Characters outside those two ranges, by code point.
struct Advance {
  char32_t code;
  std::int16_t units;
};
inline constexpr std::array<Advance, 8> kOthers{{
    {0x2013, 460}, {0x2014, 676}, {0x2018, 163}, {0x2019, 163}, {0x201C, 301}, {0x201D, 301},
    {0x2026, 815}, {0x2212, 495},
}};
// clang-format on

}  // namespace dimline::barlow
