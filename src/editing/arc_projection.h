#pragma once

#include <vector>

#include "placement/layout.h"

namespace dimline {

/// The points of an arc on screen (px), close enough to each other to look like a curve; the first on its fixed leg, the last on the one that moves. Replaces
/// the contents of `points`. False, and nothing of use in `points`, when the arc or its centre is nearer than `view`'s near plane.
bool arcOnScreen(const Arc& arc, const View& view, std::vector<Vec2>& points);

/// What the pointer aims at (px): the middle of the arrowhead at the arc's moving end; on an arc too short for two of them, a quarter of the way along.
/// Requires that arcOnScreen() can draw it.
Vec2 arcArrowMiddle(const Arc& arc, const View& view);

/// From the middle of an angular handle's arc to the middle of its label's box (px). Requires that arcOnScreen() can draw it.
Vec2 arcLabelOffset(const PlacedHandle& handle, const View& view);

/// Makes the screen parts of an angular handle (its handle, its label's box) anew from its arc, which may have changed, as `view` shows it. The label
/// keeps its size and stands at `labelOffset` (arcLabelOffset). Requires that arcOnScreen() can draw it.
void projectArcHandle(PlacedHandle& handle, const View& view, const Vec2& labelOffset);

/// Whether the whole arc and its centre lie in front of `view`'s near plane.
bool canProject(const Arc& arc, const View& view);

}  // namespace dimline
