#include "placement/foresight.h"

#include <algorithm>
#include <cmath>

namespace dimline {

namespace {

/// rad. A view that turned by less since the last frame says nothing about where it is going.
constexpr double kLeastTurnRad = 1e-4;
/// Frames of the same movement. A slow one is followed less far; what it takes away is taken late as well.
constexpr int kMostFramesAhead = 60;

Mat3 axes(const View& view) { return {view.right(), view.up(), view.forward()}; }

/// The movement from one view to the next, gone on with until the view has turned by kForesightRad more.
std::optional<View> goneOn(const View& before, const View& now, const Bounds& bounds) {
  const double turnRad = turnBetween(before, now);
  if (turnRad < kLeastTurnRad) return std::nullopt;
  const Mat3 turn = axes(now) * glm::transpose(axes(before));
  Camera camera = now.camera();
  const Vec3 shift = camera.eye - turn * before.camera().eye;
  for (int frames = std::clamp(static_cast<int>(kForesightRad / turnRad), 1, kMostFramesAhead); frames > 0; --frames) {
    camera.eye = turn * camera.eye + shift;
    camera.target = turn * camera.target + shift;
    camera.up = turn * camera.up;
  }
  return View(camera, now.widthPx(), now.heightPx(), bounds);
}

}  // namespace

void Foresight::begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM) {
  ahead_ = before ? goneOn(*before, now, bounds) : std::nullopt;
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

}  // namespace dimline
