#include "placement/arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "placement/label_text.h"
#include "placement/on_screen.h"
#include "placement/score.h"
#include "placement/text_metrics.h"

namespace dimline {

namespace {

constexpr std::size_t kArcSamples = 16;

/// px. In what steps an arc is slid out of the silhouette.
constexpr double kArcStepPx = 6.0;

/// Where along the arc the angle's text may stand, in the order of preference.
constexpr std::array kLabelShares = {0.5, 0.25, 0.75, 0.0, 1.0};

/// The arc as a polyline on screen. False when a part of it is nearer than the near plane.
bool project(const Arc& arc, const View& view, std::array<Vec2, kArcSamples + 1>& points) {
  for (std::size_t i = 0; i <= kArcSamples; ++i) {
    const Vec3 p = arc.at(arc.angleRad * static_cast<double>(i) / kArcSamples);
    if (!view.inFrontOfNear(p)) return false;
    points[i] = view.toScreen(p);
  }
  return view.inFrontOfNear(arc.center);
}

/// Where the angle's text stands: beyond the arc at `share` of its length, away from the centre.
Box2 arcLabel(const Arc& arc, const Vec2& size, const View& view, double share) {
  const Vec2 middle = view.toScreen(arc.at(arc.angleRad * share));
  const Vec2 center = view.toScreen(arc.center);
  const Vec2 out = middle - center;
  const double length = glm::length(out);
  const Vec2 direction = length > 0 ? out / length : Vec2(0, -1);
  const double reach = 0.5 * (std::abs(direction.x) * size.x + std::abs(direction.y) * size.y);
  return Box2::around(middle + direction * (reach + kLabelPaddingPx * 2), size);
}

/// The text at the first of those places that lies in the picture or, if there is none, moved in from the picture's edge.
Box2 labelInPicture(const Arc& arc, const Vec2& size, const View& view) {
  for (const double share : kLabelShares) {
    const Box2 label = arcLabel(arc, size, view, share);
    if (onScreen(label, view)) return label;
  }
  const Box2 usual = arcLabel(arc, size, view, kLabelShares.front());
  const Box2 allowed = view.viewport().grown(-kViewportMarginPx);
  const Vec2 half = 0.5 * size;
  return Box2::around(glm::max(glm::min(usual.center(), allowed.max - half), allowed.min + half), size);
}

/// Moves an arc along its plane until arc, arms and label clear the padded fields, in steps of a few pixels. False when none of them does in the viewport.
bool slideArc(Arc& arc, const Vec3& outward, const Vec2& labelSize, const OtherHandleContext& context) {
  const double stepM = context.view.metresPerPixelAt(arc.center) * kArcStepPx;
  const int most = static_cast<int>((context.view.widthPx() + context.view.heightPx()) / kArcStepPx);
  std::array<Vec2, kArcSamples + 1> points;
  for (int step = 0; step < most; ++step, arc.center += outward * stepM) {
    if (!project(arc, context.view, points)) return false;
    Box2 all = arcLabel(arc, labelSize, context.view, kLabelShares.front());
    for (const Vec2& p : points) all.add(p);
    all.add(context.view.toScreen(arc.center));
    if (step > 0 && !onScreen(all, context.view)) return false;
    if (clears(context.padded, all) && context.landed.hasRoom(all)) return true;
  }
  return false;
}

/// px on screen. By the default angle, so that the radius stays while the angle is dragged; of an angle of 0 the greatest.
double leastArcRadiusPx(const Parameter& definition) {
  const double angleRad = std::abs(definition.defaultValue) * kRadPerDeg;
  return std::clamp(kArcMinLengthPx / std::max(angleRad, kArcMinLengthPx / kArcMaxRadiusPx), kArcMinRadiusPx, kArcMaxRadiusPx);
}

/// How far from edge-on (rad) an arc's plane must be for it to be shown.
double leastFacingRad(const OtherHandle& handle) {
  if (handle.showAll) return kArcForeshortenedAngleRad * kShowAllLengthPx / kMinLineLengthPx;
  return handle.history.hidden() ? kArcShownAgainAngleRad : kArcForeshortenedAngleRad;
}

}  // namespace

Arc arcAt(const Annotation& annotation, const Obb& scope, double angleRad, double minRadiusM, double maxRadiusM) {
  const AxisSense along = axisOf(annotation.orient);
  const int axis = along.axis < 0 ? 2 : along.axis;
  const int first = (axis + 1) % 3;
  const int second = (axis + 2) % 3;
  Arc arc;
  arc.center = scope.at(annotation.translate);
  arc.from = scope.axes[static_cast<std::size_t>(first)];
  arc.axis = scope.axes[static_cast<std::size_t>(axis)];
  arc.radiusM = std::clamp(kArcRadiusShare * std::min(scope.size[first], scope.size[second]), minRadiusM, maxRadiusM);
  arc.angleRad = angleRad;
  return arc;
}

std::optional<HiddenReason> placeArc(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed) {
  const std::string text = labelText(handle.definition, handle.value);
  const Vec2 labelSize = labelSizePx(text);
  const double leastFacing = std::sin(leastFacingRad(handle));
  bool found = false;
  bool facing = false;   // one is not edge-on
  double bestScore = -std::numeric_limits<double>::infinity();
  for (const std::size_t scope : handle.scopes) {
    const Obb& box = context.scopes[scope].box;
    const double metresPerPx = context.view.metresPerPixelAt(box.origin);
    const Arc home = arcAt(handle.annotation, box, handle.value * kRadPerDeg, leastArcRadiusPx(handle.definition) * metresPerPx, kArcMaxRadiusPx * metresPerPx);
    const double facingShare = std::abs(glm::dot(home.axis, context.view.directionTo(box.center())));
    if (facingShare < leastFacing) continue;
    facing = true;
    const auto offer = [&](const Arc& arc, PlacementKind placement, int direction, double offerScore) {
      std::array<Vec2, kArcSamples + 1> points;
      if (offerScore <= bestScore || !project(arc, context.view, points)) return;
      // Both ends of the arms count, since the hand takes one of them; and what the arc says.
      const Box2 label = labelInPicture(arc, labelSize, context.view);
      if (!isWhole({context.view.toScreen(arc.center), points[kArcSamples]}, context.view) || !onScreen(label, context.view)) return;
      found = true;
      bestScore = offerScore;
      placed.scope = scope;
      placed.anchor = context.view.toScreen(home.center);
      placed.box = label;
      placed.placement = placement;
      placed.arc = arc;
      placed.handles.clear();
      placed.handles.push_back({true, points[kArcSamples]});
      placed.identity = identityOf(handle, context.scopes[scope], direction);
    };
    const auto damp = [&](int direction) {
      const Identity identity = identityOf(handle, context.scopes[scope], direction);
      return (identity == handle.history.last() ? kScoreDamp : 0.0) + handle.history.bonus(identity);
    };
    // In its frame the arc that is turned most towards the viewer reads best; that is worth as much as the plane's facing is to a line.
    offer(home, PlacementKind::kInside, -1, kScorePlane * facingShare + damp(-1) - 1e6 * (handle.annotation.slip == Slip::kNone ? 0 : 1));
    if (handle.annotation.slip == Slip::kNone) continue;
    const Vec3 other = glm::cross(home.axis, home.from);
    for (int direction = 0; direction < 4; ++direction) {
      Arc moved = home;
      const Vec3 outward = (direction < 2 ? home.from : other) * (direction % 2 == 0 ? 1.0 : -1.0);
      if (!slideArc(moved, outward, labelSize, context)) continue;
      const Vec2 offset = context.view.toScreen(moved.center) - context.view.toScreen(home.center);
      offer(moved, PlacementKind::kOutside, direction, kScorePlane * facingShare + damp(direction) + score({.base = {Vec2(0.0), Vec2(0.0)}, .candidate = {offset, offset}, .align = handle.annotation.align}));
    }
  }
  if (!found) return facing ? HiddenReason::kOutOfView : HiddenReason::kForeshortened;
  placed.parameter = handle.parameter;
  placed.type = HandleType::kAngular;
  placed.value = handle.value;
  placed.text = text;
  placed.options.clear();
  return std::nullopt;
}

}  // namespace dimline
