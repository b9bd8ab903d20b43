#pragma once

#include <span>
#include <vector>

#include "math/camera.h"

namespace dimline {

/// One face of the extruded hull (paper 4.4 and figure 15).
struct ObjectPlane {
  Plane plane;               ///< outward
  Vec3 middle{0.0};          ///< of the face
};

/// The object planes of a model: all base lines are projected onto the ground (xz), their convex hull is extruded to the object's height, and each face of
/// the prism, its caps too, is a plane. Made at model change. Empty when the base lines have no extent on the ground.
std::vector<ObjectPlane> objectPlanes(std::span<const Segment> baseLines, const Bounds& object);

/// How an object plane stands to the viewer in one frame.
enum class ObjectPlaneUse : char { kLeftOut, kFront, kBack };

/// Left out: normals within kEdgeOnAngleRad of a right angle to the view. `uses` gets one entry a plane.
void facePlanes(std::span<const ObjectPlane> planes, const View& view, std::vector<ObjectPlaneUse>& uses);

/// The offsets t for which a line moved by t along `across` on plane `number` stays within the part of that plane that its group leaves it: front planes are
/// clipped by the other front planes, back planes by the other back planes, each to the side on which the object lies. Empty (low > high)
/// when there is none.
///
///            \  A's part goes on past its free side ...
///       B     \ .
///     --------\----- A       ... and ends where the neighbour B of the same group cuts it
struct OffsetRange {
  double lowM, highM;
};
OffsetRange offsetsWithin(std::span<const ObjectPlane> planes, std::span<const ObjectPlaneUse> uses, std::size_t number, const Segment& onPlane,
                          const Vec3& across, double toleranceM);

}  // namespace dimline
