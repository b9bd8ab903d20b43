#pragma once

#include "core/fixed_vector.h"
#include "placement/base_lines.h"
#include "placement/layout.h"

namespace dimline {

/// A plane on which a base line may slip (paper figure 6), and the direction it slips in there.
struct SlipPlane {
  PlaneKind kind = PlaneKind::kNone;
  Facing facing = Facing::kNone;
  Plane plane;
  Vec3 across{0.0};   ///< unit length, in the plane, at right angles to the base line; candidates go along +across and -across
  int number = 0;     ///< which of the base line's planes; the same over frames
};

/// At most two a base line.
using SlipPlanes = FixedVector<SlipPlane, 2>;

/// The planes of a base line (DESIGN.md section 4, "Planes").
///
/// scope: those through the line along each of the scope's other axes. The normal is the outward normal of the face the plane lies in, and through the
/// middle the one towards the viewer; the spherical types have none and take the billboard's. billboard: one, holding the line, as square to
/// the view as that allows. none: no plane. Planes within kEdgeOnAngleRad of edge-on are left out: there a small move on screen is a long way
/// in the world.
SlipPlanes slipPlanes(const BaseLine& line, Slip slip, const View& view);

}  // namespace dimline
