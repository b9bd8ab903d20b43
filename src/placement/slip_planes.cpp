#include "placement/slip_planes.h"

#include <cmath>

namespace dimline {

namespace {

bool edgeOn(const Vec3& normal, const Vec3& viewDirection) {
  return std::abs(glm::dot(normal, viewDirection)) < std::sin(kEdgeOnAngleRad);
}

void addScopePlanes(const BaseLine& line, const Obb& scope, const Vec3& viewDirection, SlipPlanes& planes) {
  for (std::size_t i = 0; i < 2; ++i) {
    // The plane along one other axis lies in a face of the remaining one.
    const Vec3& normalAxis = scope.axes[static_cast<std::size_t>(line.otherAxes[1 - i])];
    if (edgeOn(normalAxis, viewDirection)) continue;
    const int side = line.sides[1 - i];
    const double towardsViewer = glm::dot(normalAxis, viewDirection) < 0 ? 1.0 : -1.0;
    const Vec3 normal = normalAxis * (side != 0 ? static_cast<double>(side) : towardsViewer);
    planes.push_back({.kind = PlaneKind::kScope,
                      .facing = glm::dot(normal, viewDirection) < 0 ? Facing::kFront : Facing::kBack,
                      .plane = {line.segment.start, normal},
                      .across = scope.axes[static_cast<std::size_t>(line.otherAxes[i])],
                      .number = static_cast<int>(i)});
  }
}

void addBillboardPlane(const BaseLine& line, const Vec3& viewDirection, SlipPlanes& planes) {
  const Vec3 along = line.segment.end - line.segment.start;
  const Vec3 across = glm::cross(viewDirection, along);
  const double length = glm::length(across);
  if (!(length > 1e-9 * glm::length(along))) return;   // the line points at the viewer: no plane is square to the view
  const Vec3 acrossUnit = across / length;
  const Vec3 normal = glm::normalize(glm::cross(along, acrossUnit));
  planes.push_back({.kind = PlaneKind::kBillboard,
                    .facing = Facing::kFront,
                    .plane = {line.segment.start, glm::dot(normal, viewDirection) < 0 ? normal : -normal},
                    .across = acrossUnit,
                    .number = 0});
}

}  // namespace

SlipPlanes slipPlanes(const BaseLine& line, const Obb& scope, Slip slip, const View& view) {
  SlipPlanes planes;
  const Vec3 viewDirection = view.directionTo(line.segment.middle());
  if (slip == Slip::kScope) addScopePlanes(line, scope, viewDirection, planes);
  if (slip == Slip::kBillboard) addBillboardPlane(line, viewDirection, planes);
  return planes;
}

}  // namespace dimline
