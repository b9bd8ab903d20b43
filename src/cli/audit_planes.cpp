#include "cli/audit_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.h"
#include "math/hull.h"

namespace dimline {

namespace {

bool plainlyFaces(const Vec3& normal, const Vec3& sight) {
  return std::abs(glm::dot(normal, sight)) >= std::sin(kEdgeOnAngleRad + kPlainlyMoreRad);
}

void addObjectWays(const Segment& base, const View& view, const std::vector<ObjectFace>& object, double modelSizeM,
                   std::vector<SlipWay>& ways) {
  const Vec3 along = glm::normalize(base.end - base.start);
  const auto facing = [&](const ObjectFace& face) {
    return glm::dot(face.plane.normal, view.directionTo(face.middle));
  };
  for (const ObjectFace& face : object) {
    const Vec3& normal = face.plane.normal;
    if (std::abs(glm::dot(along, normal)) > kSamePlaneAngleRad || face.widthM < kSamePlaneDistance * modelSizeM)
      continue;
    if (!plainlyFaces(normal, view.directionTo(face.middle))) continue;
    const Vec3 onto = normal * glm::dot(face.plane.point - base.start, normal);
    SlipWay way{{base.start + onto, base.end + onto}, glm::normalize(glm::cross(normal, along)), {}};
    for (const ObjectFace& other : object) {
      if (&other != &face && facing(other) * facing(face) > 0) way.within.push_back(other.plane);
    }
    ways.push_back(way);
    way.direction = -way.direction;
    ways.push_back(way);
  }
}

}  // namespace

std::vector<Segment> linearBaseLines(const Annotation& annotation, const Obb& scope) {
  std::vector<Segment> lines;
  const AxisSense along = axisOf(annotation.orient);
  if (along.axis < 0) return lines;
  const auto add = [&](double a, double b) {
    Vec3 from = annotation.translate;
    from[(along.axis + 1) % 3] += a;
    from[(along.axis + 2) % 3] += b;
    Vec3 to = from;
    (along.sense > 0 ? to : from)[along.axis] += 1;
    lines.push_back({scope.at(from), scope.at(to)});
  };
  if (annotation.type == HandleType::kLinearCenter) add(0.5, 0.5);
  if (annotation.type == HandleType::kLinearContour) {
    for (const double a : {0.0, 1.0}) {
      for (const double b : {0.0, 1.0}) add(a, b);
    }
  }
  return lines;
}

std::vector<ObjectFace> objectFaces(const Model& model, const Scene& scene) {
  std::vector<Vec2> ground;
  Bounds all = scene.bounds;
  for (const auto& annotation : model.annotations) {
    if (!annotation) continue;
    for (const Scope& scope : scene.scopes) {
      if (scope.name != annotation->scope) continue;
      for (const Segment& line : linearBaseLines(*annotation, scope.box)) {
        for (const Vec3& p : {line.start, line.end}) {
          ground.emplace_back(p.x, p.z);
          all.add(p);
        }
      }
    }
  }
  std::vector<ObjectFace> faces;
  const std::vector<Vec2> hull = convexHull(ground, 0);
  if (hull.size() < 3) return faces;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& a = hull[i];
    const Vec2& b = hull[(i + 1) % hull.size()];
    const double widthM = glm::length(b - a);
    const Vec3 middle{(a.x + b.x) / 2, all.center().y, (a.y + b.y) / 2};
    faces.push_back({{middle, Vec3(b.y - a.y, 0, a.x - b.x) / widthM}, middle, widthM});
  }
  Vec2 center{0.0};
  for (const Vec2& p : hull) center += p / static_cast<double>(hull.size());
  for (const double y : {all.min.y, all.max.y}) {
    const Vec3 middle{center.x, y, center.y};
    faces.push_back({{middle, {0, y == all.max.y ? 1 : -1, 0}}, middle, std::numeric_limits<double>::infinity()});
  }
  return faces;
}

std::vector<SlipWay> slipWays(const Annotation& annotation, const Obb& scope, const Segment& base, const View& view,
                              const std::vector<ObjectFace>& object, double modelSizeM) {
  std::vector<SlipWay> ways;
  const Vec3 sight = view.directionTo(base.middle());
  const Vec3 along = glm::normalize(base.end - base.start);
  const auto add = [&](const Vec3& direction) {
    if (!plainlyFaces(glm::normalize(glm::cross(along, direction)), sight)) return;
    ways.push_back({base, direction, {}});
    ways.push_back({base, -direction, {}});
  };
  const int axis = axisOf(annotation.orient).axis;
  const auto axisAt = [&](int i) { return scope.axes[static_cast<std::size_t>(i)]; };
  if (annotation.slip == Slip::kBillboard || (annotation.slip == Slip::kScope && isSpherical(annotation.type))) {
    add(glm::normalize(glm::cross(sight, along)));
  } else if (annotation.slip == Slip::kScope && isLinear(annotation.type)) {
    add(axisAt((axis + 1) % 3));
    add(axisAt((axis + 2) % 3));
  } else if (annotation.slip == Slip::kScope) {
    add(axisAt(axis));
    add(glm::normalize(glm::cross(axisAt(axis), along)));
  } else if (annotation.slip == Slip::kObject) {
    addObjectWays(base, view, object, modelSizeM, ways);
  }
  return ways;
}

bool staysWithin(const SlipWay& way, const Segment& line, double modelSizeM) {
  const double roundingM = kSamePlaneDistance * modelSizeM;
  return std::ranges::all_of(way.within, [&](const Plane& plane) {
    return glm::dot(line.start - plane.point, plane.normal) <= roundingM &&
           glm::dot(line.end - plane.point, plane.normal) <= roundingM;
  });
}

}  // namespace dimline
