#pragma once

#include "math/camera.h"

namespace dimline {

/// How far the camera may go, by the size of what it looks at. Limits bind movements, not cameras: one that a script
/// put outside stays there until it is moved, and then may only come nearer to what is allowed.
struct CameraLimits {
  double minDistanceM = 0;  ///< eye to target; also the least orthographic height
  double maxDistanceM = 0;
  Vec3 center{0.0};
  double maxTargetDistanceM = 0;  ///< target to center
};
CameraLimits cameraLimits(const Bounds& bounds);

// Movements in the manner of three.js's OrbitControls. Each is computed from the camera at the start of a gesture and
// what the pointer has travelled since then; none has inertia. Pixels are CSS pixels, y down; `heightPx` is the
// viewport's.

struct OrbitMove {
  Camera camera;
  /// px of the vertical travel that did nothing because a limit was reached. A gesture that starts over from there
  /// answers at once when the pointer turns back.
  double overrunPx = 0;
};
/// Turns the eye about the target, a whole turn for a travel of the viewport's height: sideways about the camera's up,
/// up and down as far as the poles, never over them, and not far below the horizon.
OrbitMove orbit(const Camera& start, const Vec2& travelPx, double heightPx);

/// Moves eye and target parallel to the screen, so that what lies at the target's depth stays under the pointer.
Camera pan(const Camera& start, const Vec2& travelPx, double heightPx, const CameraLimits& limits);

/// Scales eye and target (or the orthographic height) about a point of the world, which stays where it is on screen.
/// `factor` < 1 goes nearer; within the limits.
Camera zoom(const Camera& start, double factor, const Vec3& pivot, const CameraLimits& limits);

/// The zoom factor of a wheel that turned by so many pixels (three.js: 5 % for 100), and of a vertical drag with the
/// middle button.
double wheelZoomFactor(double deltaPx);
double dragZoomFactor(double travelPx);

/// The point under a pixel that is as deep in the picture as the target.
Vec3 pointAtTargetDepth(const View& view, const Vec2& screen);

/// The camera with the other projection that shows what is at the target in the same size.
Camera withProjection(const Camera& camera, bool orthographic);

}  // namespace dimline
