#include "placement/slip_planes.h"

#include <cmath>

namespace dimline {

namespace {

bool edgeOn(const Vec3& normal, const Vec3& viewDirection) {
  return std::abs(glm::dot(normal, viewDirection)) < std::sin(kEdgeOnAngleRad);
}

void addScopePlanes(const BaseLine& line, const Vec3& viewDirection, std::vector<SlipPlane>& planes) {
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

void addBillboardPlane(const BaseLine& line, const Vec3& viewDirection, std::vector<SlipPlane>& planes) {
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

void addObjectPlanes(const BaseLine& line, const ObjectPlanesInFrame& object, std::vector<SlipPlane>& planes) {
  const Vec3 along = glm::normalize(line.segment.end - line.segment.start);
  for (std::size_t i = 0; i < object.planes.size(); ++i) {
    if (object.uses[i] == ObjectPlaneUse::kLeftOut) continue;
    const Plane& plane = object.planes[i].plane;
    // For so small an angle its sine is the angle.
    if (std::abs(glm::dot(along, plane.normal)) > kSamePlaneAngleRad) continue;
    const Vec3 onto = plane.normal * glm::dot(plane.point - line.segment.start, plane.normal);
    const Vec3 across = glm::normalize(glm::cross(plane.normal, along));
    const OffsetRange range = offsetsWithin(object.planes, object.uses, i, {line.segment.start + onto, line.segment.end + onto}, across, object.toleranceM);
    if (range.lowM > range.highM) continue;
    planes.push_back({.kind = PlaneKind::kObject,
                      .facing = object.uses[i] == ObjectPlaneUse::kFront ? Facing::kFront : Facing::kBack,
                      .plane = {line.segment.start + onto, plane.normal},
                      .across = across,
                      .number = static_cast<int>(i),
                      .onto = onto,
                      .lowM = range.lowM,
                      .highM = range.highM});
  }
}

}  // namespace

void slipPlanes(const BaseLine& line, Slip slip, const View& view, const ObjectPlanesInFrame& object, std::vector<SlipPlane>& planes) {
  planes.clear();
  const Vec3 viewDirection = view.directionTo(line.segment.middle());
  switch (slip) {
    case Slip::kNone: break;
    case Slip::kBillboard: addBillboardPlane(line, viewDirection, planes); break;
    case Slip::kObject:
      if (!object.planes.empty()) {
        addObjectPlanes(line, object, planes);
        break;
      }
      [[fallthrough]];
    case Slip::kScope:
      if (line.scopePlanes.empty()) {
        addBillboardPlane(line, viewDirection, planes);
      } else {
        addScopePlanes(line, viewDirection, planes);
      }
      break;
  }
}

}  // namespace dimline
