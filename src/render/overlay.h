#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "editing/drag_marks.h"
#include "math/geometry.h"
#include "render/theme.h"

namespace dimline {

/// Window depths (View::windowDepth) of the two ends of something straight: the model hides what lies behind it.
using EndDepths = glm::vec2;

/// Those of a line's extension lines: where they begin, where they bend at the plane, if they do, and where they end. A jog lies between the last two, as deep as what is straight would be there.
struct ExtensionDepths {
  EndDepths base{0.0F};
  std::optional<EndDepths> foot;
  EndDepths line{0.0F};
};

/// One dimension line as it is to be drawn, on screen (CSS px). Plain data: placement and animation are decided elsewhere.
///
///        |   label   |         overshoot
///     <--+-- 12.5 m -+-->      arrowheads' tips touch the extension lines
///        |           |         extension
///                              gap
///        o===========o         base line
struct OverlayLine {
  Segment2 line;                            ///< from arrow tip to arrow tip
  std::span<const Vec2> extensionStart;     ///< a polyline of at most four points to line.start, base end first; empty for none. Must outlive the call it is given to.
  std::span<const Vec2> extensionEnd;       ///< to line.end
  std::optional<Box2> label;                ///< the line is interrupted around it
  bool startDraggable = false;
  bool endDraggable = true;
  bool indirect = false;                    ///< stippled
  /// What the model hides is faint: of the line but for its ends, and of its extension lines. Empty: nothing hides it, and so it is while the pointer is at it.
  std::optional<EndDepths> depths;
  std::optional<ExtensionDepths> extensionDepths;
  bool sphereEnds = false;                  ///< balls about the ends in place of arrowheads
  std::optional<glm::vec4> color;           ///< of the line and its fixed ends, in place of the theme's
  bool hovered = false;                     ///< the pointer is over it
  bool active = false;                      ///< being dragged
  float opacity = 1.0F;                     ///< 0 to 1
  float handleScale = 1.0F;                 ///< size of the draggable arrowheads; 1 at rest
};

/// An angle, as it is to be drawn on screen: an arc between two legs.
///
///         leg
///        +
///       / )  arc, an arrowhead at either end;
///      /   ) its last point is the one that can be dragged
///     o----+ leg
///     center
struct OverlayArc {
  std::span<const Vec2> points;             ///< close enough to each other to look like a curve. Must outlive the call it is given to.
  Vec2 center{0.0};
  bool draggable = true;
  bool hovered = false;
  bool active = false;
  float opacity = 1.0F;
  float handleScale = 1.0F;
};

/// The thread that ties a switch or a choice to the feature it belongs to: from a dot there to the edge of its box.
struct OverlayThread {
  Vec2 anchor{0.0};
  Box2 box;
  float opacity = 1.0F;
};

/// An edge of a scope's box that is marked since a parameter drives the scope.
struct OverlayEdge {
  Segment2 line;
  EndDepths depths{0.0F};
  bool shownHidden = true;  ///< what the model hides of it is faint, or else left out
  float opacity = 1.0F;
};

/// All that is drawn over the picture in one frame.
struct Overlay {
  std::span<const OverlayLine> lines{};
  std::span<const OverlayArc> arcs{};
  std::span<const OverlayThread> threads{};
  std::span<const DragMark> marks{};
  std::span<const OverlayEdge> edges{};
};

/// px. The model hides a point of an overlay when it is before it there and at eight points in a circle of this radius around it. So what hides a line is at least twice as wide as
/// this. Less: ropes and bars before a line make it restless. More: lines shine through narrow walls.
inline constexpr double kHiderReachPx = 2.5;

/// A stroke, an arrowhead or a dot, ready for the GPU, which draws it anti-aliased at device pixels.
struct OverlayShape {
  enum class Kind : std::uint32_t {
    kStroke,   ///< from start to end, cut square
    kArrow,    ///< a triangle: start is the tip, end the middle of the opposite side
    kCurve,    ///< a stroke that is a piece of a curve: its ends lean so that it meets the pieces before and after it without a seam
    kDisc      ///< start and end are the ends of a diameter, halfWidthPx the radius
  };
  glm::vec2 startPx{0.0F};
  glm::vec2 endPx{0.0F};
  float halfWidthPx = 0.5F;      ///< an arrow's at its end
  float softnessPx = 0.0F;       ///< 0: as sharp as pixels allow; otherwise the outline fades over this width
  float dashPx = 0.0F;           ///< length of a dash and of the gap after it, counted from start; 0: solid
  float hiddenShare = 1.0F;      ///< what is left of the opacity where the model hides it (see kHiderReachPx); 1: nothing hides it
  glm::vec2 lean{0.0F};          ///< of a curve's piece: how far along its start and its end lie further on, for each px to the right of it
  EndDepths depths{0.0F};        ///< of start and end; meaningless when nothing hides it
  Kind kind = Kind::kStroke;
  std::uint32_t rgba = 0;        ///< sRGB, red in the lowest byte, opacity not multiplied in
};

/// Turns an overlay into shapes, in drawing order: edges of scopes, all halos, then extension lines, legs and threads, then a drag's marks, then lines, arcs and their ends. Replaces the contents of
/// `shapes`; allocates only when it grows. What is invisible or not finite is left out.
void buildOverlay(const Overlay& overlay, const Theme& theme, std::vector<OverlayShape>& shapes);

}  // namespace dimline
