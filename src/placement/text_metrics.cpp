#include "placement/text_metrics.h"

#include <algorithm>
#include <cstddef>

#include "core/constants.h"
#include "placement/barlow_advances.h"

namespace dimline {
namespace {

constexpr char32_t kBroken = 0xFFFFFFFF;

/// The code point that begins at `at`, which moves behind it. A byte that begins none is kBroken by itself, so that
/// broken text is measured too.
char32_t nextCodePoint(std::string_view text, std::size_t& at) {
  const auto byteAt = [&](std::size_t i) -> unsigned { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byteAt(at++);
  if (lead < 0x80) return lead;
  const std::size_t continuations = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  if (lead < 0xC2 || lead > 0xF4 || at + continuations > text.size()) return kBroken;
  char32_t code = lead & (0x3Fu >> continuations);
  for (std::size_t i = 0; i < continuations; ++i) {
    const unsigned next = byteAt(at + i);
    if ((next & 0xC0) != 0x80) return kBroken;
    code = (code << 6) | (next & 0x3F);
  }
  at += continuations;
  return code;
}

int advanceUnits(char32_t code) {
  using namespace barlow;
  if (code >= kBasicLatinFirst && code - kBasicLatinFirst < kBasicLatin.size()) {
    return kBasicLatin[code - kBasicLatinFirst];
  }
  if (code >= kLatin1First && code - kLatin1First < kLatin1.size()) return kLatin1[code - kLatin1First];
  const auto other = std::find_if(kOthers.begin(), kOthers.end(), [&](const Advance& a) { return a.code == code; });
  return other != kOthers.end() ? other->units : kBasicLatin['m' - kBasicLatinFirst];
}

}  // namespace

double textWidthPx(std::string_view text, double fontSizePx) {
  int units = 0;
  for (std::size_t at = 0; at < text.size();) units += advanceUnits(nextCodePoint(text, at));
  return units * fontSizePx / barlow::kUnitsPerEm;
}

Vec2 labelSizePx(std::string_view text) {
  const double lineHeightEm = static_cast<double>(barlow::kAscender - barlow::kDescender) / barlow::kUnitsPerEm;
  return {textWidthPx(text, kLabelFontSizePx), lineHeightEm * kLabelFontSizePx};
}

}  // namespace dimline
