#include "placement/object_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.h"
#include "math/hull.h"

namespace dimline {

std::vector<ObjectPlane> objectPlanes(std::span<const Segment> baseLines, const Bounds& object) {
  std::vector<Vec2> ground;
  Bounds all = object;
  for (const Segment& line : baseLines) {
    for (const Vec3& p : {line.start, line.end}) {
      ground.emplace_back(p.x, p.z);
      all.add(p);
    }
  }
  std::vector<ObjectPlane> planes;
  // Faces narrower than the tolerance for equal planes would be planes that no line could tell apart.
  const std::vector<Vec2> hull = convexHull(ground, kSamePlaneDistance * all.diagonal());
  if (hull.size() < 3) return planes;
  const double middleY = all.center().y;
  Vec2 centroid{0.0};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& a = hull[i];
    const Vec2& b = hull[(i + 1) % hull.size()];
    centroid += a / static_cast<double>(hull.size());
    // Counter-clockwise in (x, z) as in (x, y): the outside is to the right.
    const Vec2 side = glm::normalize(b - a);
    const Vec3 middle{(a.x + b.x) * 0.5, middleY, (a.y + b.y) * 0.5};
    planes.push_back({{middle, Vec3(side.y, 0, -side.x)}, middle});
  }
  for (const double sense : {1.0, -1.0}) {
    const Vec3 middle{centroid.x, sense > 0 ? all.max.y : all.min.y, centroid.y};
    planes.push_back({{middle, Vec3(0, sense, 0)}, middle});
  }
  return planes;
}

void facePlanes(std::span<const ObjectPlane> planes, const View& view, std::vector<ObjectPlaneUse>& uses) {
  uses.clear();
  for (const ObjectPlane& p : planes) {
    const double facing = glm::dot(p.plane.normal, view.directionTo(p.middle));
    uses.push_back(std::abs(facing) < std::sin(kEdgeOnAngleRad) ? ObjectPlaneUse::kLeftOut
                   : facing < 0                                 ? ObjectPlaneUse::kFront
                                                                : ObjectPlaneUse::kBack);
  }
}

OffsetRange offsetsWithin(std::span<const ObjectPlane> planes, std::span<const ObjectPlaneUse> uses, std::size_t number, const Segment& onPlane,
                          const Vec3& across, double toleranceM) {
  OffsetRange range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i == number || uses[i] != uses[number]) continue;
    const Plane& other = planes[i].plane;
    // Inside the other plane's half-space: beyond + slope * t <= tolerance, for the end that is further out.
    const double beyond = std::max(glm::dot(onPlane.start - other.point, other.normal), glm::dot(onPlane.end - other.point, other.normal));
    const double slope = glm::dot(across, other.normal);
    if (std::abs(slope) < 1e-9) {
      if (beyond > toleranceM) return {1, 0};
    } else if (slope > 0) {
      range.highM = std::min(range.highM, (toleranceM - beyond) / slope);
    } else {
      range.lowM = std::max(range.lowM, (toleranceM - beyond) / slope);
    }
  }
  return range;
}

}  // namespace dimline
