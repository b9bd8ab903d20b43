#pragma once

#include <optional>
#include <span>

#include "placement/layout.h"

namespace dimline {

/// A handle of a layout, by position.
struct HandleRef {
  std::size_t line = 0;    ///< index into Layout::lines
  std::size_t handle = 0;  ///< index into that line's handles
  bool operator==(const HandleRef&) const = default;
};

/// Middle of a handle's arrowhead on screen (px), from whose tip at `handle.screen` it points back into the line; on a
/// line too short for two arrowheads, half way to the line's middle. What the pointer aims at.
Vec2 arrowMiddle(const Segment2& lineScreen, const Handle& handle);

/// The handle that a pointer at `screen` takes hold of: the one whose arrowhead's middle is nearest, within `radiusPx`
/// (kGrabRadiusMousePx, kGrabRadiusTouchPx). Of handles at the same distance the first. Nothing when there is none, or
/// when `screen` is not a number.
std::optional<HandleRef> hitHandle(std::span<const PlacedLine> lines, const Vec2& screen, double radiusPx);

/// The line that a pointer at `screen` points at without taking hold of it: over whose label it is, or else the nearest within
/// `radiusPx` (kPointAtPx). Nothing when there is none, or when `screen` is not a number.
std::optional<std::size_t> hitLine(std::span<const PlacedLine> lines, const Vec2& screen, double radiusPx);

/// The angular handle that a pointer takes hold of, by index into `handles`: as hitHandle(), and nearer than `radiusPx`. `view`: the one they are drawn in.
std::optional<std::size_t> hitArc(std::span<const PlacedHandle> handles, const View& view, const Vec2& screen, double radiusPx);

}  // namespace dimline
