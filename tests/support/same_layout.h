#pragma once

#include <algorithm>
#include <span>

#include "placement/layout.h"

/// When two layouts are the same one to a test.
namespace dimline::test {

/// Bit for bit.
inline bool sameLine(const PlacedLine& a, const PlacedLine& b) {
  return a.identity == b.identity && a.placement == b.placement && a.planeKind == b.planeKind && a.base.start == b.base.start && a.base.end == b.base.end && a.line.start == b.line.start && a.line.end == b.line.end &&
         a.lineScreen.start == b.lineScreen.start && a.lineScreen.end == b.lineScreen.end && a.text == b.text &&
         a.label == b.label && a.extensionStart == b.extensionStart && a.extensionEnd == b.extensionEnd && a.handles == b.handles;
}

inline bool sameHandle(const PlacedHandle& a, const PlacedHandle& b) {
  return a.identity == b.identity && a.placement == b.placement && a.value == b.value && a.text == b.text && a.anchor == b.anchor && a.box == b.box && a.arc == b.arc &&
         a.handles == b.handles && a.options == b.options;
}

inline bool sameLayout(const Layout& a, const Layout& b) {
  const auto sameHidden = [](const HiddenParameter& one, const HiddenParameter& other) { return one.parameter == other.parameter && one.reason == other.reason; };
  return std::ranges::equal(a.lines, b.lines, sameLine) && std::ranges::equal(a.others, b.others, sameHandle) && std::ranges::equal(a.hidden, b.hidden, sameHidden);
}

/// The same choices, wherever they lie by now.
inline bool sameIdentities(std::span<const PlacedLine> a, std::span<const PlacedLine> b) { return std::ranges::equal(a, b, {}, &PlacedLine::identity, &PlacedLine::identity); }

}  // namespace dimline::test
