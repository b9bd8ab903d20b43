#include "editing/arc_drag.h"

#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "editing/arc_projection.h"
#include "placement/label_text.h"
#include "placement/text_metrics.h"

// Rays from the centre within the arc's plane are rays from the centre on screen, under perspective too, and the map between their directions is the
// projection's derivative at the centre: a 2 x 2 matrix. So an angle is found without asking where the pointer's ray meets the plane, which near the
// plane's horizon is nowhere.

namespace dimline {

namespace {

/// px. Less movement of the handle than this is none; nobody sees it.
constexpr double kTolerancePx = 0.25;

/// How the arc's plane shows on screen at its centre: movements along `from`, and a quarter turn on from it (px per m).
struct PlaneOnScreen {
  Vec2 center;
  Vec2 first, second;
  [[nodiscard]] double determinant() const { return first.x * second.y - first.y * second.x; }
};

PlaneOnScreen planeOnScreen(const Arc& arc, const View& view) {
  const Vec3 at = view.worldToPixels() * Vec4(arc.center, 1.0);
  const auto derivative = [&](const Vec3& direction) {
    const Vec3 along = view.worldToPixels() * Vec4(direction, 0.0);
    return (Vec2(along) * at.z - Vec2(at) * along.z) / (at.z * at.z);
  };
  return {view.toScreen(arc.center), derivative(arc.from), derivative(glm::cross(arc.axis, arc.from))};
}

}  // namespace

std::optional<ArcDrag> ArcDrag::begin(const Model& model, const Values& values, const PlacedHandle& handle, const Vec2& pointer, const View& view) {
  if (!handle.arc || handle.handles.empty() || handle.parameter >= values.size() || !canProject(*handle.arc, view)) return std::nullopt;
  const PlaneOnScreen plane = planeOnScreen(*handle.arc, view);
  // What a square metre of the plane covers, against what it would cover if it faced the viewer.
  const double facing = std::abs(plane.determinant()) * std::pow(view.metresPerPixelAt(handle.arc->center), 2);
  if (!(facing > 0.5 * std::sin(kForeshortenedAngleRad))) return std::nullopt;
  const Vec2 tip = view.toScreen(handle.arc->at(handle.arc->angleRad));
  return ArcDrag(model, values, handle, pointer - tip, arcLabelOffset(handle, view));
}

ArcDrag::ArcDrag(const Model& model, const Values& values, const PlacedHandle& handle, const Vec2& grabOffset, const Vec2& labelOffset)
    : model_(&model),
      startValues_(values),
      handle_(handle),
      grabOffset_(grabOffset),
      labelOffset_(labelOffset),
      lastValue_(values.at(handle.parameter)) {}

std::optional<double> ArcDrag::angleRadAt(const Vec2& screen, const View& view) const {
  const PlaneOnScreen plane = planeOnScreen(*handle_.arc, view);
  const Vec2 offset = screen - plane.center;
  const double determinant = plane.determinant();
  if (!(glm::length(offset) > 1.0) || !std::isfinite(offset.x) || !std::isfinite(offset.y) || determinant == 0) return std::nullopt;
  const double x = (offset.x * plane.second.y - offset.y * plane.second.x) / determinant;
  const double y = (plane.first.x * offset.y - plane.first.y * offset.x) / determinant;
  return std::atan2(y, x);
}

double ArcDrag::valueAt(const Vec2& pointer, const View& view, Snap snap) {
  const Vec2 screen = pointer - grabOffset_;
  const auto angleRad = angleRadAt(screen, view);
  if (!angleRad) return lastValue_;
  const double start = startValues_.at(handle_.parameter);
  const Parameter& parameter = model_->parameters()[handle_.parameter];
  const Vec2 startTip = view.toScreen(handle_.arc->at(handle_.arc->angleRad));
  if (glm::length(screen - startTip) <= kTolerancePx) return lastValue_ = start;
  // Of the turns that lead there, the one that is in the range, or is the least outside it; of those the one nearest to the start.
  double best = start;
  double bestMiss = std::numeric_limits<double>::infinity();
  const double deg = *angleRad / kRadPerDeg;
  for (int turn = -2; turn <= 2; ++turn) {
    const double value = deg + 360.0 * turn;
    const double miss = std::abs(value - clampValue(parameter, value)) + 1e-6 * std::abs(value - start);
    if (miss < bestMiss) {
      bestMiss = miss;
      best = value;
    }
  }
  Parameter snapped = snappedBy(parameter, snap);
  if (!(snapped.step > 0)) {
    // Decimal angles finer than anybody can point at.
    const double radiusPx = std::max(glm::length(startTip - view.toScreen(handle_.arc->center)), 1.0);
    snapped.step = powerOfTenWithin(kTolerancePx / radiusPx / kRadPerDeg);
  }
  return lastValue_ = snapValue(snapped, best);
}

void ArcDrag::addMarks(double value, const View& view, Snap snap, std::vector<DragMark>& marks) const {
  const Arc& arc = *handle_.arc;
  const Parameter parameter = snappedBy(model_->parameters()[handle_.parameter], snap);
  const double start = startValues_.at(handle_.parameter);
  const auto placeOf = [&](double deg) -> std::optional<Vec2> {
    const Vec3 place = arc.at(deg * kRadPerDeg);
    if (!view.inFrontOfNear(place)) return std::nullopt;
    return view.toScreen(place);
  };
  const auto addBar = [&](double deg, DragMark::Kind kind) {
    const auto at = placeOf(deg);
    const auto beside = placeOf(deg + 0.1);
    if (!at || !beside || !(glm::length(*beside - *at) > 0) || !view.viewport().overlaps({*at, *at})) return;
    marks.push_back({kind, barAcross(*at, glm::normalize(*beside - *at), halfLengthPx(kind))});
  };
  if (value != start) {
    const auto from = placeOf(start);
    if (from && view.inFrontOfNear(arc.center)) marks.push_back({DragMark::Kind::kGhost, {view.toScreen(arc.center), *from}});
    addBar(start, DragMark::Kind::kGhost);
  }
  addTicks(parameter, value, placeOf, marks);
  for (const double limit : {parameter.min, parameter.max}) {
    addBar(limit, value == limit ? DragMark::Kind::kLimitReached : DragMark::Kind::kLimit);
  }
}

std::optional<PlacedHandle> ArcDrag::handleOn(const Values& values, const View& view) const {
  PlacedHandle handle = handle_;
  handle.value = values.at(handle.parameter);
  handle.arc->angleRad = handle.value * kRadPerDeg;
  handle.text = labelText(model_->parameters()[handle.parameter], handle.value);
  if (!canProject(*handle.arc, view)) return std::nullopt;
  const Vec2 size = labelSizePx(handle.text);
  handle.box = {Vec2(0.0), size};
  projectArcHandle(handle, view, labelOffset_);
  return handle;
}

}  // namespace dimline
