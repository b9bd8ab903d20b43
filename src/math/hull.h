#pragma once

#include <span>
#include <vector>

#include "math/types.h"

namespace dimline {

/// The convex hull of points in a plane, counter-clockwise, starting at the point that is least in x and then in y; points on a side, or within
/// `tolerance` (in the points' own unit) of one, are no corners. Fewer than three corners when the points lie on a line.
std::vector<Vec2> convexHull(std::span<const Vec2> points, double tolerance);

}  // namespace dimline
