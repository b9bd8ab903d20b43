#include "gpu/field_scan.h"

#include <string_view>

#include <catch2/catch.hpp>

#include "silhouette/coverage_mask.h"
#include "support/random.h"

using namespace dimline;

namespace {

using Range = MaskExtremes::Range;
constexpr Range kEmpty{};

std::vector<std::uint8_t> maskOf(std::initializer_list<std::string_view> rows) {
  std::vector<std::uint8_t> mask;
  for (const std::string_view row : rows) {
    for (const char c : row) mask.push_back(c == '#' ? 255 : 0);
  }
  return mask;
}

std::vector<float> valuesOf(const DistanceFields& fields, ViewportEdge edge) {
  const std::span<const float> values = fields[edge].values();
  return {values.begin(), values.end()};
}

}  // namespace

TEST_CASE("a mask's extremes are the first and last covered pixel of each row and column") {
  const std::vector<std::uint8_t> mask = maskOf({
      "..........",  //
      "..#..##...",  //
      ".........#",  //
  });
  MaskExtremes extremes;
  scanMask(mask, 10, 3, extremes);
  CHECK(extremes.rows == std::vector<Range>{kEmpty, {2, 7}, {9, 10}});
  CHECK(extremes.columns == std::vector<Range>{kEmpty, kEmpty, {1, 2}, kEmpty, kEmpty, {1, 2}, {1, 2}, kEmpty, kEmpty, {2, 3}});
}

TEST_CASE("a hole does not hide what is covered beyond it") {
  MaskExtremes extremes;
  scanMask(maskOf({"#", ".", "#"}), 1, 3, extremes);
  CHECK(extremes.columns == std::vector<Range>{{0, 3}});
}

TEST_CASE("at one device pixel a CSS pixel, fields are the extremes") {
  const std::vector<std::uint8_t> mask = maskOf({
      ".....",  //
      ".##..",  //
  });
  MaskExtremes extremes;
  scanMask(mask, 5, 2, extremes);
  DistanceFields fields;
  fieldsFromExtremes(extremes, 5, 2, fields);
  constexpr float kNone = kNoSilhouette;
  CHECK(valuesOf(fields, ViewportEdge::kLeft) == std::vector<float>{kNone, 1});
  CHECK(valuesOf(fields, ViewportEdge::kRight) == std::vector<float>{kNone, 2});
  CHECK(valuesOf(fields, ViewportEdge::kTop) == std::vector<float>{kNone, 1, 1, kNone, kNone});
  CHECK(valuesOf(fields, ViewportEdge::kBottom) == std::vector<float>{kNone, 0, 0, kNone, kNone});
}

TEST_CASE("at a pixel ratio of 1.5 a strip takes the nearest of the device strips that it touches") {
  // Six device columns are four CSS pixels: strip 0 touches columns 0 and 1, strip 1 columns 1 and 2, and so on.
  const std::vector<std::uint8_t> mask = maskOf({
      ".#....",  //
      ".#....",  //
      ".#...#",  //
  });
  MaskExtremes extremes;
  scanMask(mask, 6, 3, extremes);
  DistanceFields fields;
  fieldsFromExtremes(extremes, 4, 2, fields);
  constexpr float kNone = kNoSilhouette;
  CHECK(valuesOf(fields, ViewportEdge::kTop) == std::vector<float>{0, 0, kNone, 2.0F / 1.5F});
  CHECK(valuesOf(fields, ViewportEdge::kBottom) == std::vector<float>{0, 0, kNone, 0});
  CHECK(valuesOf(fields, ViewportEdge::kLeft) == std::vector<float>{1.0F / 1.5F, 1.0F / 1.5F});
  CHECK(valuesOf(fields, ViewportEdge::kRight)[0] == Approx(4 - 2 / 1.5));
  CHECK(valuesOf(fields, ViewportEdge::kRight)[1] == 0);
}

TEST_CASE("a viewport of a fraction of a pixel more has one more strip") {
  MaskExtremes extremes;
  scanMask(maskOf({"####"}), 4, 1, extremes);
  DistanceFields fields;
  fieldsFromExtremes(extremes, 3.5, 1, fields);
  CHECK(fields.widthPx == 4);
  CHECK(valuesOf(fields, ViewportEdge::kTop) == std::vector<float>{0, 0, 0, 0});
  CHECK(valuesOf(fields, ViewportEdge::kLeft) == std::vector<float>{0});
  CHECK(valuesOf(fields, ViewportEdge::kRight) == std::vector<float>{0.5F});
}

TEST_CASE("at a pixel ratio of 1 the fields are those of the plainly written mask scan") {
  test::Random random(7);
  for (int round = 0; round < 50; ++round) {
    CoverageMask mask;
    mask.widthPx = random.whole(1, 40);
    mask.heightPx = random.whole(1, 40);
    for (int i = 0; i < mask.widthPx * mask.heightPx; ++i) mask.pixels.push_back(random.chance(0.03) ? 255 : 0);
    DistanceFields expected;
    fieldsFromMask(mask, expected);
    MaskExtremes extremes;
    scanMask(mask.pixels, mask.widthPx, mask.heightPx, extremes);
    DistanceFields fields;
    fieldsFromExtremes(extremes, mask.widthPx, mask.heightPx, fields);
    for (const ViewportEdge edge : kViewportEdges) REQUIRE(valuesOf(fields, edge) == valuesOf(expected, edge));
  }
}
