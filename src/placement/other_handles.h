#pragma once

#include <optional>
#include <span>

#include "model/model.h"
#include "placement/history.h"
#include "placement/landed.h"
#include "placement/layout.h"

namespace dimline {

/// What the other handles of one frame are placed against.
struct OtherHandleContext {
  const View& view;
  const DistanceFields& padded;   ///< model and landed things, with handleSpacing
  const Landed& landed;
  std::span<const Scope> scopes;
};

/// A parameter whose handle is no line, and the scopes in view that it may stand at.
struct OtherHandle {
  std::size_t parameter = 0;
  const Parameter& definition;
  const Annotation& annotation;
  std::span<const std::size_t> scopes;
  double value = 0;
  History& history;
  bool firm = false;         ///< no better kind of place is taken at once
  bool nearing = false;      ///< the camera comes nearer, so that places outside do not last
};

/// Places a boolean or a range handle: a pill of fixed size for its parameter, moved from the middle of the scope's face in the direction of `orient` to where
/// it clears the padded fields and all that has landed, in one of eight directions on screen; scored like a line by distance, alignment, damping and
/// crossings (paper 5: "placed similarly to dimension lines"). At its anchor when there is no place outside, or with slip=none. Returns nothing
/// when it is placed, else the reason: no scope's anchor is in the viewport, or there is no room.
std::optional<HiddenReason> placePill(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed);

/// Places an angular handle: an arc in its scope's frame, from the axis that follows `orient`'s towards the next one, around the scope's origin corner. With a
/// slip other than none it is moved along its plane to outside the silhouette. Returns nothing when it is placed, else the reason: all scopes' arcs stand edge-on, or out of view.
std::optional<HiddenReason> placeArc(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed);

/// Size of a pill (px): the widest text that it may have to show, so that it does not change with its value.
Vec2 pillSizePx(const Parameter& parameter);

/// The arc of an angular handle at a scope, `minRadiusM` to `maxRadiusM` (m).
Arc arcAt(const Annotation& annotation, const Obb& scope, double angleRad, double minRadiusM, double maxRadiusM);

/// The least shift s >= 0 (px) along a unit direction at which the box clears the fields; infinite when there is none in the viewport.
double leastShiftPx(const DistanceFields& fields, const Box2& box, const Vec2& direction);

}  // namespace dimline
