#include "render/overlay_line.h"

#include <cmath>

#include "core/constants.h"
#include "placement/jogs.h"

namespace dimline {

namespace {

/// The colour that an author gave a line, if any.
std::optional<glm::vec4> colorOf(const LineLook& look) {
  if (!look.color) return std::nullopt;
  const auto& [red, green, blue] = *look.color;
  return srgb(static_cast<unsigned>(red) << 16U | static_cast<unsigned>(green) << 8U | blue);
}

/// How far (m) a box reaches from its middle in a direction of unit length.
double reachOf(const Obb& box, const Vec3& direction) {
  double reach = 0;
  for (std::size_t axis = 0; axis < box.axes.size(); ++axis) reach += 0.5 * std::abs(glm::dot(box.axes[axis], direction)) * box.size[static_cast<glm::length_t>(axis)];
  return reach;
}

/// How much nearer to the viewer (m) a line's base line may be said to lie: where it is no edge of its scope, it is as near as the scope.
double withinScopeM(const PlacedLine& line, const Scene& scene, const View& view) {
  const bool edge = line.type == HandleType::kLinearContour || line.scope >= scene.scopes.size();
  return edge ? 0.0 : reachOf(scene.scopes[line.scope].box, view.directionTo(line.base.middle()));
}

}  // namespace

EndDepths endDepths(const Segment& world, const View& view, double nearerM) {
  const auto depthAt = [&](const Vec3& p) {
    const Vec3 nearer = p - view.directionTo(p) * nearerM;
    return view.inFrontOfNear(nearer) ? static_cast<float>(view.windowDepth(nearer)) : 0.0F;
  };
  return {depthAt(world.start), depthAt(world.end)};
}

OverlayLine overlayLine(const PlacedLine& line, const Scene& scene, const View& view) {
  OverlayLine drawn;
  drawn.line = line.lineScreen;
  drawn.extensionStart = line.extensionStart;
  drawn.extensionEnd = line.extensionEnd;
  drawn.label = line.label;
  drawn.startDraggable = drawn.endDraggable = false;
  for (const Handle& handle : line.handles) (handle.atEnd ? drawn.endDraggable : drawn.startDraggable) = true;
  drawn.indirect = line.indirect;
  const double modelM = scene.bounds.diagonal();
  const double withinM = withinScopeM(line, scene, view);
  if (line.placement == PlacementKind::kInside) {
    drawn.depths = endDepths(line.line, view, kEdgeSkinShare * modelM + withinM);
  } else {
    const auto depthsOf = [&](const Segment& world, double nearerM) { return endDepths(world, view, kScopeSkinShare * modelM + nearerM); };
    drawn.extensionDepths = {depthsOf(line.base, withinM), std::nullopt, depthsOf(line.line, 0.0)};
    if (bendsAtPlane(line)) drawn.extensionDepths->foot = depthsOf(line.foot, withinM);
  }
  drawn.sphereEnds = line.look.skin == HandleSkin::kSphere;
  drawn.color = colorOf(line.look);
  return drawn;
}

}  // namespace dimline
