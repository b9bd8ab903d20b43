#pragma once

#include "math/geometry.h"

namespace dimline {

/// A parallel light's view of a box: what a square depth map of the box needs, seen from the light.
struct LightView {
  Mat4 worldToClip{1.0};
  Mat4 worldToUnit{1.0};    ///< to the unit cube that the map covers: (u, v, depth)
  Vec2 unitsPerM{1.0};      ///< of u and v, per metre at right angles to the light
  double texelM = 1.0;      ///< the larger side of a texel in the world
  double depthRangeM = 1.0; ///< world length of depths 0 to 1
};

/// Fits a map of `texels` x `texels` around `bounds` (not empty), seen against the unit direction `towardsLight`. A border of a few texels
/// stays empty, so that filters which look past the box find nothing there.
LightView fitLightView(const Bounds& bounds, const Vec3& towardsLight, int texels);

}  // namespace dimline
