#include "app/composition.h"

#include <algorithm>
#include <cmath>

#include "silhouette/scope_visibility.h"

namespace dimline {

namespace {

/// The most by which the picture is moved, as a share of the viewport: a model weighs more than a thin line far below it, and must not be driven into a corner.
constexpr double kMostShift = 0.12;

/// A perspective camera that looks so nearly along an axis of the world is meant to.
constexpr double kAxisTolerance = 1e-9;

/// Cosine of the most by which the compass direction of a view may turn. Seen from right above, moving the picture aside a little would turn it round.
constexpr double kLeastSameBearing = 0.97;

bool mayTurn(const View& view) {
  if (view.orthographic()) return false;
  const Vec3 forward = glm::abs(view.forward());
  return std::max({forward.x, forward.y, forward.z}) < 1.0 - kAxisTolerance;
}

/// Cosine of the angle between the compass directions of two views.
double sameBearing(const Vec3& a, const Vec3& b, const Vec3& up) {
  const auto level = [&](const Vec3& v) { return v - up * (glm::dot(v, up) / glm::dot(up, up)); };
  const double lengths = glm::length(level(a)) * glm::length(level(b));
  return lengths > 0 ? glm::dot(level(a), level(b)) / lengths : 1.0;
}

void add(Box2& box, const Box2& other) {
  box.add(other.min);
  box.add(other.max);
}

}  // namespace

Box2 coveredBox(const Layout& layout, const DistanceFields& fields) {
  Box2 box;
  const auto nearest = [&](ViewportEdge edge) { return static_cast<double>(fields[edge].least(1)); };
  if (nearest(ViewportEdge::kLeft) < kNoSilhouette) {
    add(box, {{nearest(ViewportEdge::kLeft), nearest(ViewportEdge::kTop)},
              {fields.widthPx - nearest(ViewportEdge::kRight), fields.heightPx - nearest(ViewportEdge::kBottom)}});
  }
  for (const PlacedLine& line : layout.lines) {
    box.add(line.lineScreen.start);
    box.add(line.lineScreen.end);
    for (const Vec2& point : line.extensionStart) box.add(point);
    for (const Vec2& point : line.extensionEnd) box.add(point);
    if (line.label) add(box, *line.label);
  }
  for (const PlacedHandle& other : layout.others) {
    add(box, other.box);
    for (const Handle& handle : other.handles) box.add(handle.screen);
  }
  return box;
}

Camera centred(const Layout& layout, const DistanceFields& fields) {
  const View& view = layout.view;
  const Box2 box = coveredBox(layout, fields);
  if (box.empty() || !(view.orthographic() || mayTurn(view))) return view.camera();
  const Vec2 middle = view.viewport().center(), most = view.viewport().max * kMostShift;
  const View::Ray ray = view.rayThrough(middle + glm::clamp(box.center() - middle, -most, most));
  Camera camera = view.camera();
  if (!view.orthographic() && sameBearing(ray.direction, view.forward(), camera.up) < kLeastSameBearing) return camera;
  const double distance = glm::length(camera.target - camera.eye);
  camera.eye = ray.origin;   // an orthographic one's is across the view, a perspective one's the same
  camera.target = ray.origin + ray.direction * distance;
  return camera;
}

Camera composed(const View& view, const DistanceFields& fields, const Scene& scene, const Values& values, Placer& placer) {
  ScopeVisibility seen;
  CpuVisibility().measure(scene, view, seen);
  placer.forget();
  Layout layout;
  placer.place(view, fields, values, layout, &seen);
  placer.forget();
  return centred(layout, fields);
}

Camera lookingAlong(const Vec3& direction, const View& view) {
  Camera camera = view.camera();
  const Vec3 forward = view.right() * direction.x + view.up() * direction.y + view.forward() * direction.z;
  if (sameBearing(forward, view.forward(), camera.up) > 0) camera.target = camera.eye + forward * glm::length(camera.target - camera.eye);
  return camera;
}

Camera uncentred(const View& view, const Bounds& bounds) {
  Camera camera = view.camera();
  if (!mayTurn(view) || bounds.empty() || !view.inFrontOfNear(bounds.center())) return camera;
  const Vec2 fromMiddle = glm::abs(view.toScreen(bounds.center()) - view.viewport().center());
  // A pixel of slack: the middle of the turned picture is not quite where that of the other was.
  const Vec2 most = view.viewport().max * (kMostShift * 1.1) + 1.0;
  if (!(fromMiddle.x < most.x && fromMiddle.y < most.y)) return camera;
  if (sameBearing(bounds.center() - camera.eye, view.forward(), camera.up) >= kLeastSameBearing) camera.target = bounds.center();
  return camera;
}

}  // namespace dimline
