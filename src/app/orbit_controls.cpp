#include "app/orbit_controls.h"

#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "core/power.h"

namespace dimline {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// rad. How near to the pole an orbit may come. Right above the target a camera has no azimuth; a hundredth of a degree
/// beside it has.
constexpr double kPoleMarginRad = 1e-4;

/// rad. How far below the horizon an orbit may look up from. Enough to see under eaves; much further, and the ground is
/// between eye and model.
constexpr double kBelowHorizonRad = 0.35;

// Distances as shares of the model's diagonal: near enough for a door handle, far enough to lose nothing, and never so
// far that nobody finds back.
constexpr double kMinDistanceShare = 0.02;
constexpr double kMaxDistanceShare = 12.0;
constexpr double kMaxTargetShare = 3.0;

constexpr double kWheelZoomPer100Px = 0.95;
constexpr double kDragHalvesAfterPx = 200.0;

double heightAtTargetM(const Camera& camera) {
  if (camera.orthoHeightM) return *camera.orthoHeightM;
  return 2.0 * std::tan(camera.fovRad * 0.5) * glm::length(camera.target - camera.eye);
}

/// Moves eye and target back together when the target is farther out than allowed and has not come nearer.
void keepTargetNear(Camera& camera, const Camera& start, const CameraLimits& limits) {
  const double before = glm::length(start.target - limits.center);
  const double allowed = std::max(limits.maxTargetDistanceM, before);
  const Vec3 away = camera.target - limits.center;
  const double distance = glm::length(away);
  if (!(distance > allowed)) return;
  const Vec3 shift = away * (allowed / distance - 1.0);
  camera.target += shift;
  camera.eye += shift;
}

}  // namespace

CameraLimits cameraLimits(const Bounds& bounds) {
  const double size = bounds.empty() ? 1.0 : std::max(bounds.diagonal(), 1e-6);
  return {.minDistanceM = kMinDistanceShare * size,
          .maxDistanceM = kMaxDistanceShare * size,
          .center = bounds.empty() ? Vec3(0.0) : bounds.center(),
          .maxTargetDistanceM = kMaxTargetShare * size};
}

OrbitMove orbit(const Camera& start, const Vec2& travelPx, double heightPx) {
  const double radPerPx = 2.0 * kPi / heightPx;
  const Vec3 axis = glm::normalize(start.up);
  const double distance = glm::length(start.eye - start.target);
  const Vec3 outward = (start.eye - start.target) / distance;
  // The view's right has no part along the axis, even at the pole, where it says which way is round.
  const Vec3 right = View(start, 1, 1, Bounds{}).right();
  const Vec3 level = glm::cross(right, axis);

  const double startRad = std::asin(std::clamp(glm::dot(outward, axis), -1.0, 1.0));
  const double wantedRad = startRad + travelPx.y * radPerPx;
  const double lowest = std::max(std::min(-kBelowHorizonRad, startRad), -0.5 * kPi + kPoleMarginRad);
  const double elevationRad = std::clamp(wantedRad, lowest, 0.5 * kPi - kPoleMarginRad);

  const Vec3 turned = glm::angleAxis(-travelPx.x * radPerPx, axis) * level;
  OrbitMove move;
  move.camera = start;
  move.camera.eye = start.target + (turned * std::cos(elevationRad) + axis * std::sin(elevationRad)) * distance;
  // The last hundredth of a degree to the pole is no overrun worth starting over for.
  const double overrunRad = wantedRad - elevationRad;
  if (std::abs(overrunRad) > 2.0 * kPoleMarginRad) move.overrunPx = overrunRad / radPerPx;
  return move;
}

Camera pan(const Camera& start, const Vec2& travelPx, double heightPx, const CameraLimits& limits) {
  const View view(start, 1, 1, Bounds{});
  const double metresPerPx = heightAtTargetM(start) / heightPx;
  const Vec3 shift = (view.up() * travelPx.y - view.right() * travelPx.x) * metresPerPx;
  Camera camera = start;
  camera.eye += shift;
  camera.target += shift;
  keepTargetNear(camera, start, limits);
  return camera;
}

Camera zoom(const Camera& start, double factor, const Vec3& pivot, const CameraLimits& limits) {
  const double size = start.orthoHeightM ? *start.orthoHeightM : glm::length(start.target - start.eye);
  const double allowed =
      std::clamp(size * factor, std::min(limits.minDistanceM, size), std::max(limits.maxDistanceM, size));
  const double scale = allowed / size;
  if (!(scale > 0) || !std::isfinite(scale)) return start;
  Camera camera = start;
  if (start.orthoHeightM) {
    // Only what lies across the view matters; along it the eye stays, so that nothing changes place in depth.
    const Vec3 forward = glm::normalize(start.target - start.eye);
    Vec3 shift = (pivot - start.target) * (1.0 - scale);
    shift -= forward * glm::dot(shift, forward);
    camera.orthoHeightM = *start.orthoHeightM * scale;
    camera.eye += shift;
    camera.target += shift;
  } else {
    camera.eye = pivot + (start.eye - pivot) * scale;
    camera.target = pivot + (start.target - pivot) * scale;
  }
  keepTargetNear(camera, start, limits);
  return camera;
}

double wheelZoomFactor(double deltaPx) { return power(kWheelZoomPer100Px, -deltaPx / 100.0); }
double dragZoomFactor(double travelPx) { return power(2, travelPx / kDragHalvesAfterPx); }

Vec3 pointAtTargetDepth(const View& view, const Vec2& screen) {
  const View::Ray ray = view.rayThrough(screen);
  const double along = glm::dot(ray.direction, view.forward());
  return ray.origin + ray.direction * (glm::dot(view.camera().target - ray.origin, view.forward()) / along);
}

Camera withProjection(const Camera& camera, bool orthographic) {
  Camera other = camera;
  if (orthographic == camera.orthographic()) return other;
  if (orthographic) {
    other.orthoHeightM = heightAtTargetM(camera);
  } else {
    const double distance = *camera.orthoHeightM / (2.0 * std::tan(camera.fovRad * 0.5));
    other.orthoHeightM.reset();
    other.eye = camera.target - glm::normalize(camera.target - camera.eye) * distance;
  }
  return other;
}

}  // namespace dimline
