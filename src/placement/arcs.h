#pragma once

#include <optional>

#include "placement/other_handles.h"

namespace dimline {

/// Places an angular handle: an arc in its scope's frame, from the axis that follows `orient`'s towards the next one, around the scope's origin corner. With a
/// slip other than none it is moved along its plane to outside the silhouette. Returns nothing when it is placed, else the reason: all scopes' arcs stand edge-on, or out of view.
std::optional<HiddenReason> placeArc(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed);

/// The arc of an angular handle at a scope, `minRadiusM` to `maxRadiusM` (m).
Arc arcAt(const Annotation& annotation, const Obb& scope, double angleRad, double minRadiusM, double maxRadiusM);

}  // namespace dimline
