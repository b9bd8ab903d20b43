#pragma once

#include "math/geometry.h"
#include "placement/layout.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// How much of what a frame shows a box on screen would hide, for a host that looks for a place for a box of its own: the name of what the pointer is at, the
/// value of what it drags. 0 where it hides nothing; a number that it hides counts by its area (px²), and what can be done without for a moment counts less:
/// arrowheads, lines, extension lines, and least of all the model.
///
/// Lines that fade away do not count. Of the model only what lies between its fields is known, so that a place in one of its bays may seem covered; fields of
/// another size than the layout's are left out.
double coverCost(const Box2& box, const Layout& drawn, const DistanceFields& fields);

}  // namespace dimline
