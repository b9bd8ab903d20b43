#include "placement/layout.h"

#include <cmath>

namespace dimline {

Vec3 Arc::at(double rad) const {
  return center + (from * std::cos(rad) + glm::cross(axis, from) * std::sin(rad)) * radiusM;
}

std::string_view name(PlacementKind kind) {
  switch (kind) {
    case PlacementKind::kOutside: return "outside";
    case PlacementKind::kGuide: return "guide";
    case PlacementKind::kInside: return "inside";
  }
  return "";
}

std::string_view name(PlaneKind kind) {
  switch (kind) {
    case PlaneKind::kNone: return "none";
    case PlaneKind::kScope: return "scope";
    case PlaneKind::kBillboard: return "billboard";
    case PlaneKind::kObject: return "object";
  }
  return "";
}

std::string_view name(Facing facing) {
  switch (facing) {
    case Facing::kNone: return "none";
    case Facing::kFront: return "front";
    case Facing::kBack: return "back";
  }
  return "";
}

std::string_view name(HiddenReason reason) {
  switch (reason) {
    case HiddenReason::kOccluded: return "occluded";
    case HiddenReason::kOutOfView: return "out-of-view";
    case HiddenReason::kTooShort: return "too-short";
    case HiddenReason::kForeshortened: return "foreshortened";
    case HiddenReason::kCrowded: return "crowded";
    case HiddenReason::kNoScope: return "no-scope";
  }
  return "";
}

std::string identityText(const Identity& identity, std::span<const Parameter> parameters) {
  const auto parameter = static_cast<std::size_t>(identity.parameter);
  std::string text = identity.parameter >= 0 && parameter < parameters.size() ? parameters[parameter].name : "?";
  for (const int part : {int{identity.scopeIndex}, int{identity.chain}, int{identity.baseLine}, int{identity.plane}}) {
    text += part < 0 ? std::string("/-") : "/" + std::to_string(part);
  }
  text += identity.direction > 0 ? "/+" : identity.direction < 0 ? "/-" : "/0";
  return text;
}

}  // namespace dimline
