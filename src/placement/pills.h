#pragma once

#include <optional>

#include "placement/other_handles.h"

namespace dimline {

/// Places a boolean or a range handle: a pill of fixed size for its parameter, moved from the middle of the scope's face in the direction of `orient` to where
/// it clears the padded fields and all that has landed, in one of eight directions on screen; scored like a line by distance, alignment, damping and
/// crossings (paper 5: "placed similarly to dimension lines"). At its anchor when there is no place outside, or with slip=none. Returns nothing
/// when it is placed, else the reason: no scope's anchor is in the viewport, or there is no room.
std::optional<HiddenReason> placePill(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed);

/// Size of a pill (px): the widest text that it may have to show, so that it does not change with its value.
Vec2 pillSizePx(const Parameter& parameter);

/// The least shift s >= 0 (px) along a unit direction at which the box clears the fields; infinite when there is none in the viewport.
double leastShiftPx(const DistanceFields& fields, const Box2& box, const Vec2& direction);

}  // namespace dimline
