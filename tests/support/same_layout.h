#pragma once

#include <algorithm>
#include <span>

#include "placement/layout.h"

/// When two layouts are the same one to a test.
namespace dimline::test {

/// Bit for bit.
inline bool sameLine(const PlacedLine& a, const PlacedLine& b) {
  return a.identity == b.identity && a.line.start == b.line.start && a.line.end == b.line.end &&
         a.lineScreen.start == b.lineScreen.start && a.lineScreen.end == b.lineScreen.end && a.text == b.text &&
         a.label.has_value() == b.label.has_value() &&
         (!a.label || (a.label->min == b.label->min && a.label->max == b.label->max)) &&
         a.extensionStart == b.extensionStart && a.extensionEnd == b.extensionEnd;
}

inline bool sameLayout(const Layout& a, const Layout& b) {
  return a.lines.size() == b.lines.size() && a.hidden.size() == b.hidden.size() &&
         std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), sameLine);
}

/// The same choices, wherever they lie by now.
inline bool sameIdentities(std::span<const PlacedLine> a, std::span<const PlacedLine> b) { return std::ranges::equal(a, b, {}, &PlacedLine::identity, &PlacedLine::identity); }

}  // namespace dimline::test
