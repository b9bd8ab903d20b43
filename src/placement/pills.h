#pragma once

#include <limits>
#include <optional>

#include "placement/other_handles.h"

namespace dimline {

/// Places a boolean or a range handle: a pill of fixed size for its parameter, moved from its anchor, the middle of the scope's face in the direction of `orient`, to where it clears the model and all that has
/// landed: between the model and its lines where there is room, or else beyond them. Scored like a line by distance, alignment and damping, and by what the thread from pill to anchor runs across
/// (paper 5: "placed similarly to dimension lines"). Where lines settle a change costs little, and threads across each other cost much. Its identity says on which of eight sides it stands. At its anchor or near it when
/// there is no place outside that is not too far away (kLongestThreadShare), or with slip=none. Before a still camera it stays where it was to the last bit. Returns nothing when it is placed, else the reason: no scope's anchor is in the viewport, or there is no room.
std::optional<HiddenReason> placePill(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed);

/// What a pill is worth where it stands (px) in a picture in which lines settle, by itself and by what its thread runs across of all that has landed, itself included; the greater, the better.
double pillWorth(const PlacedHandle& pill, const Annotation& annotation, const Landed& landed);

/// Size of a pill (px): the widest text that it may have to show, so that it does not change with its value.
Vec2 pillSizePx(const Parameter& parameter);

/// The least shift s >= 0 (px) along a unit direction at which the box clears the fields; infinite when there is none in the viewport, or below `mostPx`.
double leastShiftPx(const DistanceFields& fields, const Box2& box, const Vec2& direction, double mostPx = std::numeric_limits<double>::infinity());

}  // namespace dimline
