#pragma once

#include <optional>

#include "core/constants.h"
#include "math/camera.h"

namespace dimline {

/// Whether a box on screen lies within the viewport's margin.
inline bool onScreen(const Box2& box, const View& view) { return view.viewport().grown(-kViewportMarginPx).contains(box); }

/// A line on screen (px), when it may be a final line: in front of the near plane as a whole, and within the viewport's margin.
inline std::optional<Segment2> onScreen(const Segment& line, const View& view) {
  if (!view.inFrontOfNear(line)) return std::nullopt;
  const Segment2 screen = view.toScreen(line);
  const Box2 allowed = view.viewport().grown(-kViewportMarginPx);
  return allowed.contains(screen.start) && allowed.contains(screen.end) ? std::optional(screen) : std::nullopt;
}

/// Whether a base line's two ends are in the picture.
inline bool isWhole(const Segment2& base, const View& view) { return view.viewport().contains(base.start) && view.viewport().contains(base.end); }

}  // namespace dimline
