#include "placement/base_lines.h"

#include <algorithm>
#include <cmath>

namespace dimline {

namespace {

const Vec3& axisAt(const Obb& scope, int axis) { return scope.axes[static_cast<std::size_t>(axis)]; }

/// Plane `number` of a linear base line is the one along the first or the second of the scope's other axes; its normal is the remaining one's.
/// `side`: on which side of the middle the line lies along that remaining axis (0: in the middle).
ScopePlane planeAlong(const Obb& scope, int acrossAxis, int normalAxis, int side) {
  return {.across = axisAt(scope, acrossAxis), .normal = axisAt(scope, normalAxis) * (side < 0 ? -1.0 : 1.0), .inFace = side != 0};
}

/// The line along an axis at the given sides of the box (-1 and +1 its faces, 0 the middle), from the end that the sense points away from.
BaseLine linear(const Obb& scope, const AxisSense& along, int sideA, int sideB, int number, const Vec3& translate) {
  const int axisA = (along.axis + 1) % 3;
  const int axisB = (along.axis + 2) % 3;
  Vec3 from = translate;
  from[axisA] += 0.5 + 0.5 * sideA;
  from[axisB] += 0.5 + 0.5 * sideB;
  Vec3 to = from;
  (along.sense > 0 ? to : from)[along.axis] += 1.0;
  BaseLine line;
  line.number = number;
  line.segment = {scope.at(from), scope.at(to)};
  line.scopePlanes.push_back(planeAlong(scope, axisA, axisB, sideB));
  line.scopePlanes.push_back(planeAlong(scope, axisB, axisA, sideA));
  for (const ScopePlane& plane : line.scopePlanes) {
    if (plane.inFace) line.faces.push_back(plane.normal);
  }
  return line;
}

/// From the centre of a face's inscribed ellipse to its rim, at right angles to the view (paper figure 5, row 3); zero when the
/// face has no extent.
///
///        .-----.        the view's direction crossed with the axis lies in the
///      /    c---r       face; the rim is where the ellipse meets it
///        `-----'
Vec3 radiusAcrossView(const Obb& scope, int axis, const Vec3& faceCenter, const View& view) {
  const int axisA = (axis + 1) % 3;
  const int axisB = (axis + 2) % 3;
  Vec3 direction = glm::cross(view.directionTo(faceCenter), axisAt(scope, axis));
  // Looking along the axis, every diameter is at right angles to the view; the one that is level on screen reads best.
  if (!(glm::length(direction) > 1e-6)) direction = view.right();
  const double a = glm::dot(direction, axisAt(scope, axisA));
  const double b = glm::dot(direction, axisAt(scope, axisB));
  const double radiusA = 0.5 * scope.size[axisA];
  const double radiusB = 0.5 * scope.size[axisB];
  if (!(radiusA > 0 && radiusB > 0)) return Vec3(0.0);
  const double scale = 1.0 / std::hypot(a / radiusA, b / radiusB);
  return (axisAt(scope, axisA) * a + axisAt(scope, axisB) * b) * scale;
}

void addCircular(const Annotation& annotation, const Obb& scope, const View& view, BaseLines& lines) {
  const int axis = axisOf(annotation.orient).axis;
  if (axis < 0) return;
  for (const int face : {-1, 1}) {
    Vec3 middle = Vec3(0.5) + annotation.translate;
    middle[axis] += 0.5 * face;
    const Vec3 center = scope.at(middle);
    const Vec3 radius = radiusAcrossView(scope, axis, center, view);
    if (radius == Vec3(0.0)) continue;
    const Vec3 along = glm::normalize(radius);
    const Vec3 normal = axisAt(scope, axis) * static_cast<double>(face);
    const auto add = [&](const Segment& segment) {
      BaseLine line;
      line.number = static_cast<int>(lines.size());
      line.segment = segment;
      line.scopePlanes.push_back({.across = glm::cross(normal, along), .normal = normal, .inFace = true});
      line.scopePlanes.push_back({.across = axisAt(scope, axis), .normal = glm::cross(along, axisAt(scope, axis)), .inFace = false});
      lines.push_back(line);
    };
    if (annotation.type == HandleType::kDiametric) {
      add({center - radius, center + radius});
    } else {
      add({center, center + radius});
      add({center, center - radius});
    }
  }
}

double sphereRadius(const Obb& scope) { return 0.5 * std::min({scope.size.x, scope.size.y, scope.size.z}); }

void addSpherical(const Annotation& annotation, const Obb& scope, const View& view, BaseLines& lines) {
  const Vec3 center = scope.at(Vec3(0.5) + annotation.translate);
  // The sphere's outline is seen at right angles to the ray through its centre, not to the camera's own direction.
  const Vec3 sight = view.directionTo(center);
  const Vec3 wanted = annotation.orient == Orient::kVertical ? view.up() : view.right();
  const Vec3 radius = glm::normalize(wanted - sight * glm::dot(wanted, sight)) * sphereRadius(scope);
  const auto add = [&](const Segment& segment) {
    BaseLine line;
    line.number = static_cast<int>(lines.size());
    line.segment = segment;
    lines.push_back(line);
  };
  if (annotation.type == HandleType::kSphericalDiametric) {
    add({center - radius, center + radius});
    add({center + radius, center - radius});
  } else {
    add({center, center + radius});
    add({center, center - radius});
    add({center + radius, center});
    add({center - radius, center});
  }
}

}  // namespace

bool turnedAway(const BaseLine& line, const View& view, double leastSin) {
  const Vec3 sight = view.directionTo(line.segment.middle());
  return !line.faces.empty() && std::ranges::all_of(line.faces, [&](const Vec3& normal) { return glm::dot(normal, sight) > leastSin; });
}

BaseLines baseLines(const Annotation& annotation, const Obb& scope, const View& view) {
  BaseLines lines;
  const AxisSense along = axisOf(annotation.orient);
  switch (annotation.type) {
    case HandleType::kLinearContour:
      if (along.axis < 0) break;
      for (int i = 0; i < 4; ++i) {
        lines.push_back(linear(scope, along, (i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, i, annotation.translate));
      }
      break;
    case HandleType::kLinearCenter:
      if (along.axis >= 0) lines.push_back(linear(scope, along, 0, 0, 0, annotation.translate));
      break;
    case HandleType::kDiametric:
    case HandleType::kRadial: addCircular(annotation, scope, view, lines); break;
    case HandleType::kSphericalDiametric:
    case HandleType::kSphericalRadial: addSpherical(annotation, scope, view, lines); break;
    case HandleType::kAngular:
    case HandleType::kBoolean:
    case HandleType::kRange: break;
  }
  return lines;
}

double meanBaseLengthM(const Annotation& annotation, const Obb& scope) {
  const int axis = axisOf(annotation.orient).axis;
  const auto meanDiameter = [&] { return axis < 0 ? 0.0 : 0.5 * (scope.size[(axis + 1) % 3] + scope.size[(axis + 2) % 3]); };
  switch (annotation.type) {
    case HandleType::kLinearContour:
    case HandleType::kLinearCenter: return axis < 0 ? 0.0 : scope.size[axis];
    case HandleType::kDiametric: return meanDiameter();
    case HandleType::kRadial: return 0.5 * meanDiameter();
    case HandleType::kSphericalDiametric: return 2.0 * sphereRadius(scope);
    case HandleType::kSphericalRadial: return sphereRadius(scope);
    case HandleType::kAngular:
    case HandleType::kBoolean:
    case HandleType::kRange: return 0.0;
  }
  return 0.0;
}

}  // namespace dimline
