#pragma once

#include <algorithm>
#include <span>

#include "placement/layout.h"

/// When two layouts are the same one to a test.
namespace dimline::test {

inline bool sameBox(const Box2& a, const Box2& b) { return a.min == b.min && a.max == b.max; }

inline bool samePlaces(const Handle& a, const Handle& b) { return a.atEnd == b.atEnd && a.screen == b.screen; }

/// Bit for bit.
inline bool sameLine(const PlacedLine& a, const PlacedLine& b) {
  return a.identity == b.identity && a.placement == b.placement && a.planeKind == b.planeKind && a.base.start == b.base.start && a.base.end == b.base.end && a.line.start == b.line.start && a.line.end == b.line.end &&
         a.lineScreen.start == b.lineScreen.start && a.lineScreen.end == b.lineScreen.end && a.text == b.text &&
         a.label.has_value() == b.label.has_value() &&
         (!a.label || sameBox(*a.label, *b.label)) && a.extensionStart == b.extensionStart && a.extensionEnd == b.extensionEnd &&
         std::ranges::equal(a.handles, b.handles, samePlaces);
}

inline bool sameArc(const Arc& a, const Arc& b) {
  return a.center == b.center && a.from == b.from && a.axis == b.axis && a.radiusM == b.radiusM && a.angleRad == b.angleRad;
}

inline bool sameHandle(const PlacedHandle& a, const PlacedHandle& b) {
  const auto sameOption = [](const RangeOption& one, const RangeOption& other) { return one.value == other.value && one.text == other.text && sameBox(one.box, other.box); };
  return a.identity == b.identity && a.placement == b.placement && a.value == b.value && a.text == b.text && a.anchor == b.anchor && sameBox(a.box, b.box) &&
         a.arc.has_value() == b.arc.has_value() && (!a.arc || sameArc(*a.arc, *b.arc)) && std::ranges::equal(a.handles, b.handles, samePlaces) &&
         std::ranges::equal(a.options, b.options, sameOption);
}

inline bool sameLayout(const Layout& a, const Layout& b) {
  const auto sameHidden = [](const HiddenParameter& one, const HiddenParameter& other) { return one.parameter == other.parameter && one.reason == other.reason; };
  return std::ranges::equal(a.lines, b.lines, sameLine) && std::ranges::equal(a.others, b.others, sameHandle) && std::ranges::equal(a.hidden, b.hidden, sameHidden);
}

/// The same choices, wherever they lie by now.
inline bool sameIdentities(std::span<const PlacedLine> a, std::span<const PlacedLine> b) { return std::ranges::equal(a, b, {}, &PlacedLine::identity, &PlacedLine::identity); }

}  // namespace dimline::test
