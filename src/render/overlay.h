#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "math/geometry.h"
#include "render/theme.h"

namespace dimline {

/// One dimension line as it is to be drawn, on screen (CSS px). Plain data: placement and animation are decided elsewhere.
///
///        |   label   |         overshoot
///     <--+-- 12.5 m -+-->      arrowheads' tips touch the extension lines
///        |           |         extension
///                              gap
///        o===========o         base line
struct OverlayLine {
  Segment2 line;                            ///< from arrow tip to arrow tip
  std::span<const Vec2> extensionStart;     ///< a polyline to line.start, base end first; empty for none. Must outlive the call it is given to.
  std::span<const Vec2> extensionEnd;       ///< to line.end
  std::optional<Box2> label;                ///< the line is interrupted around it
  bool startDraggable = false;
  bool endDraggable = true;
  bool indirect = false;                    ///< stippled
  bool hovered = false;                     ///< the pointer is over a handle of it
  bool active = false;                      ///< being dragged
  float opacity = 1.0F;                     ///< 0 to 1
  float handleScale = 1.0F;                 ///< size of the draggable arrowheads; 1 at rest
};

/// A stroke or an arrowhead, ready for the GPU, which draws it anti-aliased at device pixels.
struct OverlayShape {
  enum class Kind : std::uint32_t {
    kStroke,   ///< from start to end, cut square
    kArrow     ///< a triangle: start is the tip, end the middle of the opposite side
  };
  glm::vec2 startPx{0.0F};
  glm::vec2 endPx{0.0F};
  float halfWidthPx = 0.5F;      ///< an arrow's at its end
  float softnessPx = 0.0F;       ///< 0: as sharp as pixels allow; otherwise the outline fades over this width
  float dashPx = 0.0F;           ///< length of a dash and of the gap after it, counted from start; 0: solid
  Kind kind = Kind::kStroke;
  std::uint32_t rgba = 0;        ///< sRGB, red in the lowest byte, opacity not multiplied in
};

/// Turns lines into shapes, in drawing order: all halos, then extension lines, lines and arrowheads. Replaces the contents of `shapes`; allocates only when
/// it grows. Lines that are invisible or not finite are left out.
void buildOverlay(std::span<const OverlayLine> lines, const Theme& theme, std::vector<OverlayShape>& shapes);

}  // namespace dimline
