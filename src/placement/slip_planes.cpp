#include "placement/slip_planes.h"

#include <cmath>

namespace dimline {

namespace {

bool edgeOn(const Vec3& normal, const Vec3& viewDirection) {
  return std::abs(glm::dot(normal, viewDirection)) < std::sin(kEdgeOnAngleRad);
}

void addScopePlanes(const BaseLine& line, const Vec3& viewDirection, SlipPlanes& planes) {
  for (std::size_t i = 0; i < line.scopePlanes.size(); ++i) {
    const ScopePlane& scopePlane = line.scopePlanes[i];
    if (edgeOn(scopePlane.normal, viewDirection)) continue;
    const bool facesAway = glm::dot(scopePlane.normal, viewDirection) > 0;
    planes.push_back({.kind = PlaneKind::kScope,
                      .facing = facesAway && scopePlane.inFace ? Facing::kBack : Facing::kFront,
                      .plane = {line.segment.start, facesAway && !scopePlane.inFace ? -scopePlane.normal : scopePlane.normal},
                      .across = scopePlane.across,
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

SlipPlanes slipPlanes(const BaseLine& line, Slip slip, const View& view) {
  SlipPlanes planes;
  const Vec3 viewDirection = view.directionTo(line.segment.middle());
  if (slip == Slip::kScope && !line.scopePlanes.empty()) {
    addScopePlanes(line, viewDirection, planes);
  } else if (slip == Slip::kBillboard || slip == Slip::kScope) {
    addBillboardPlane(line, viewDirection, planes);
  }
  return planes;
}

}  // namespace dimline
