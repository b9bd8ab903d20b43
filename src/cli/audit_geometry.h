#pragma once

#include <optional>
#include <vector>

#include "placement/layout.h"

// The audit's own geometry of lines on screen: short and plain, and none of what the placer uses. Words as in
// audit_rows.h.
namespace dimline {

/// px. What looks like a touch: line ends that meet, or miss each other by rounding, are no crossing.
inline constexpr double kTouchPx = 0.5;

/// Distance of two segments (px); 0 where they cross.
double gapPx(const Segment2& a, const Segment2& b);

/// Whether each segment runs past the other, by more than kTouchPx on both sides.
bool crossEachOther(const Segment2& a, const Segment2& b);

/// Whether two segments run over each other for more than 2 px, less than a pixel apart.
bool lieOnEachOther(const Segment2& a, const Segment2& b);

/// Whether a segment enters a box by more than kTouchPx.
bool enters(const Segment2& segment, const Box2& box);
bool overlap(const Box2& a, const Box2& b);

/// The stretches of two segments that are beside each other, and the direction across them.
struct Beside {
  Segment2 a, b;  ///< the shared stretches
  Vec2 across;    ///< unit normal of the mean direction
};
/// Nothing when the segments share less than 2 px, or are at more than 60 degrees to each other.
std::optional<Beside> beside(const Segment2& a, const Segment2& b);

/// What of a handle is drawn as lines.
struct DrawnArc {
  std::vector<Segment2> curve;  ///< in chords
  std::vector<Segment2> arms;   ///< from its centre to its ends: hairlines, as extension lines are
};
/// Nothing, unless it is an arc, all of it before the viewer.
DrawnArc drawnArc(const PlacedHandle& handle, const View& view);

/// Parallel, in the world or on screen.
bool parallel(const PlacedLine& a, const PlacedLine& b);

/// Whether two lines lie on one guide. `modelSizeM` scales the tolerance.
bool onOneGuide(const PlacedLine& a, const PlacedLine& b, double modelSizeM);

inline bool isOutside(const PlacedLine& line) { return line.placement != PlacementKind::kInside; }

}  // namespace dimline
