#pragma once

#include <limits>
#include <span>
#include <vector>

#include "placement/base_lines.h"
#include "placement/layout.h"
#include "placement/object_planes.h"

namespace dimline {

/// A plane on which a base line may slip (paper figures 6 and 7), and the direction it slips in there.
struct SlipPlane {
  PlaneKind kind = PlaneKind::kNone;
  Facing facing = Facing::kNone;
  Plane plane;
  Vec3 across{0.0};   ///< unit length, in the plane, at right angles to the base line; candidates go along +across and -across
  int number = 0;     ///< which of the base line's planes; the same over frames
  Vec3 onto{0.0};     ///< moves the base line onto the plane (m); zero unless the plane is the object's
  double lowM = -std::numeric_limits<double>::infinity();   ///< offsets along `across` that the plane has room for (m)
  double highM = std::numeric_limits<double>::infinity();
};

/// The model's object planes as they stand in one frame.
struct ObjectPlanesInFrame {
  std::span<const ObjectPlane> planes;
  std::span<const ObjectPlaneUse> uses;
  double toleranceM = 0;   ///< kSamePlaneDistance of the model's size
};

/// Writes the planes of a base line to `planes`, in place of what was there.
///
/// scope: those through the line along each of the scope's other axes. The normal is the outward normal of the face the plane lies in, and through the
/// middle the one towards the viewer; the spherical types have none and take the billboard's. billboard: one, holding the line, as square to
/// the view as that allows. object: the object's planes that the line is parallel to; a model without any (its base lines stand in one line)
/// takes the scope's. none: no plane. Planes within kEdgeOnAngleRad of edge-on are left out: there a small move on screen is a long way in the world.
void slipPlanes(const BaseLine& line, Slip slip, const View& view, const ObjectPlanesInFrame& object, std::vector<SlipPlane>& planes);

}  // namespace dimline
