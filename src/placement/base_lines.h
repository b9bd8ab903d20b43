#pragma once

#include "core/fixed_vector.h"
#include "math/camera.h"
#include "model/annotation.h"

namespace dimline {

/// A plane through a base line along one of its scope's axes (paper figure 6, left).
struct ScopePlane {
  Vec3 across{0.0};         ///< unit length, in the plane, at right angles to the base line
  Vec3 normal{0.0};         ///< unit length; outward when the plane lies in a face of the scope
  bool inFace = true;       ///< false: the plane passes through the scope's middle and has no outward side
};

/// Where a dimension would be on the object itself (paper 3.2 and figure 5), fixed end first.
struct BaseLine {
  Segment segment;
  /// Which of the scope's base lines this is; the same line of the same scope keeps its number over frames and rebuilds.
  int number = 0;
  FixedVector<ScopePlane, 2> scopePlanes;   ///< none for the spherical types
  FixedVector<Vec3, 2> faces;               ///< outward normals of the scope's faces that meet in it, of linear-contour; none for the other types
};

/// Whether a base line lies behind its scope: all faces that meet in it are turned away from the viewer, each by more than an angle of that sine. Never for a line that no faces meet in.
bool turnedAway(const BaseLine& line, const View& view, double leastSin);

/// At most four a scope.
using BaseLines = FixedVector<BaseLine, 4>;
using BaseSegments = FixedVector<Segment, 4>;

/// Where the base lines of a scope are as seen by `view`; the place of each is its number. Plain geometry: whether a line can be seen is for the caller to find
/// out.
///
/// linear-contour       the 4 edges along the axis
/// linear-center        1 through the middle
/// diametric            2: on each face across the axis, the diameter of the inscribed ellipse at right angles to the view
/// radial               4: the halves of those diameters, from the centre to the rim
/// spherical-diametric  2: the horizontal (or vertical) screen diameter of the inscribed sphere, in both senses
/// spherical-radial     4: its halves from the centre to the rim, then from the rim to the centre
///
/// Handles that are no lines have none. `annotation.translate` moves base lines, in sizes of the scope.
BaseSegments baseSegments(const Annotation& annotation, const Obb& scope, const View& view);

/// One of those with its planes and faces, which take longer to find than where it is.
BaseLine baseLine(const Annotation& annotation, const Obb& scope, int number, const Segment& segment);

/// All of them with their planes and faces.
BaseLines baseLines(const Annotation& annotation, const Obb& scope, const View& view);

/// Mean world length (m) of a scope's base lines over all views; 0 without any. By it parameters are ordered once for all cameras
/// (paper 4.5): exact for the linear and spherical types, and the mean of the ellipse's two axes for the diametric ones.
double meanBaseLengthM(const Annotation& annotation, const Obb& scope);

}  // namespace dimline
