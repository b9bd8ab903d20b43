#pragma once

#include <optional>

#include "placement/landed.h"
#include "placement/layout.h"

namespace dimline {

// A jog is a bend by which an extension line gets past something, as draughtsmen draw it. Lines come to lie across others' extension lines by their very ends, mostly: where that is all, the extension line goes
// round the end, and nobody has to change places. Beyond the paper, which moves an extension line aside only where it would lie on a dimension line (5, "Extension Lines").

/// Where an extension line bends to get just past the end of `line`, which runs across its last part. It sets out from where it is, so that a jog grows from nothing as the camera turns. Nothing where the line
/// reaches over by more than kMostJoggedPx, or too near to an end of the part for kMostJogSlope.
std::optional<Vec2> jogPastEnd(const Segment2& line, const Segment2& lastPart);

/// The same among what has landed: nothing, too, where it would run across a line there, or through a label where it runs through none without a jog. Neither of the two need have landed.
std::optional<Vec2> jogPast(const Segment2& line, const Segment2& lastPart, const Landed& landed);

/// Whether a line's extension lines bend at its plane, apart from jogs. A jog is the last point but one; where they bend there it comes after that.
bool bendsAtPlane(const PlacedLine& line);

/// Takes a line's jogs away.
void straighten(PlacedLine& line);

}  // namespace dimline
