#include "placement/foresight.h"

#include <algorithm>
#include <cmath>

#include "placement/on_screen.h"

namespace dimline {

namespace {

/// rad, and the logarithm of a ratio of sizes on screen. A view that moved by less since the last frame says nothing about where it is going.
constexpr double kLeastTurnRad = 1e-4;
constexpr double kLeastZoom = 1e-4;
/// Frames of the same movement. A slow one is followed less far; what it takes away is taken late as well.
constexpr int kMostFramesAhead = 60;

Mat3 axes(const View& view) { return {view.right(), view.up(), view.forward()}; }

/// By what the camera's distance, or the height that an orthographic one sees, was multiplied from one view to the next.
double zoomBetween(const Camera& before, const Camera& now) {
  if (now.orthoHeightM && before.orthoHeightM) return *now.orthoHeightM / *before.orthoHeightM;
  return glm::length(now.eye - now.target) / glm::length(before.eye - before.target);
}

/// The movement from one view to the next, gone on with until the view has turned by kForesightRad or come nearer by kForesightZoom.
std::optional<View> goneOn(const View& before, const View& now, const Bounds& bounds) {
  const double turnRad = turnBetween(before, now);
  const double zoom = zoomBetween(before.camera(), now.camera());
  const double zooming = std::abs(std::log(zoom));
  const bool turns = turnRad >= kLeastTurnRad;
  const bool zooms = zooming >= kLeastZoom;   // false for a NaN too
  if (!turns && !zooms) return std::nullopt;
  int frames = kMostFramesAhead;
  if (turns) frames = std::min(frames, static_cast<int>(kForesightRad / turnRad));
  if (zooms) frames = std::min(frames, static_cast<int>(kForesightZoom / zooming));
  const Mat3 turn = axes(now) * glm::transpose(axes(before));
  Camera camera = now.camera();
  Vec3 shift = camera.target - before.camera().target;
  Vec3 arm = camera.eye - camera.target;
  for (frames = std::max(frames, 1); frames > 0; --frames) {
    shift = turn * shift;
    camera.target += shift;
    camera.up = turn * camera.up;
    arm = turn * arm;
    if (zooms && camera.orthoHeightM) *camera.orthoHeightM *= zoom;
    if (zooms && !camera.orthoHeightM) arm *= zoom;
  }
  camera.eye = camera.target + arm;
  return View(camera, now.widthPx(), now.heightPx(), bounds);
}

}  // namespace

void Foresight::begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM) {
  if (!before) ahead_.reset();
  if (before && before->viewProjection() != now.viewProjection()) ahead_ = goneOn(*before, now, bounds);
  if (!ahead_) return;
  facePlanes(objectPlanes, *ahead_, objectUses_);
  object_ = {objectPlanes, objectUses_, toleranceM};
}

bool Foresight::lasts(const BaseLine& line, Slip slip, const SlipPlane& plane, int direction, double offsetM) {
  if (!ahead_) return true;
  slipPlanes(line, slip, *ahead_, object_, planes_);
  const auto then = std::ranges::find(planes_, plane.number, &SlipPlane::number);
  if (then == planes_.end()) return false;
  return direction > 0 ? then->lowM <= offsetM && offsetM <= then->highM : -then->highM <= offsetM && offsetM <= -then->lowM;
}

bool Foresight::staysInside(const Segment& line) const {
  return !ahead_ || onScreen(line, *ahead_);
}

bool Foresight::staysInSight(const Segment& base) const {
  if (!ahead_) return true;
  return ahead_->inFrontOfNear(base.start) && ahead_->inFrontOfNear(base.end) && meets(ahead_->toScreen(base), ahead_->viewport());
}

}  // namespace dimline
