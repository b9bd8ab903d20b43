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

/// On which sides of a scope's middle base line `number` of a linear type lies along the scope's two other axes: -1 and +1 its faces, 0 the middle.
struct Sides {
  int a = 0;
  int b = 0;
};

Sides sidesOf(HandleType type, int number) {
  if (type == HandleType::kLinearCenter) return {};
  return {(number & 1) != 0 ? 1 : -1, (number & 2) != 0 ? 1 : -1};
}

/// The line along an axis on those sides, from the end that the sense points away from.
Segment linearSegment(const Obb& scope, const AxisSense& along, const Sides& sides, const Vec3& translate) {
  Vec3 from = translate;
  from[(along.axis + 1) % 3] += 0.5 + 0.5 * sides.a;
  from[(along.axis + 2) % 3] += 0.5 + 0.5 * sides.b;
  Vec3 to = from;
  (along.sense > 0 ? to : from)[along.axis] += 1.0;
  return {scope.at(from), scope.at(to)};
}

void addLinearPlanes(const Obb& scope, int axis, const Sides& sides, BaseLine& line) {
  const int axisA = (axis + 1) % 3;
  const int axisB = (axis + 2) % 3;
  line.scopePlanes.push_back(planeAlong(scope, axisA, axisB, sides.b));
  line.scopePlanes.push_back(planeAlong(scope, axisB, axisA, sides.a));
  for (const ScopePlane& plane : line.scopePlanes) {
    if (plane.inFace) line.faces.push_back(plane.normal);
  }
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

void addCircular(const Annotation& annotation, const Obb& scope, const View& view, BaseSegments& segments) {
  const int axis = axisOf(annotation.orient).axis;
  if (axis < 0) return;
  for (const int face : {-1, 1}) {
    Vec3 middle = Vec3(0.5) + annotation.translate;
    middle[axis] += 0.5 * face;
    const Vec3 center = scope.at(middle);
    const Vec3 radius = radiusAcrossView(scope, axis, center, view);
    if (radius == Vec3(0.0)) return;   // and so on the other face
    if (annotation.type == HandleType::kDiametric) {
      segments.push_back({center - radius, center + radius});
    } else {
      segments.push_back({center, center + radius});
      segments.push_back({center, center - radius});
    }
  }
}

/// The face that a diameter or radius lies in, and the plane at right angles to it. Both radii of a face share their planes' directions.
void addCircularPlanes(const Annotation& annotation, const Obb& scope, BaseLine& line) {
  const bool radial = annotation.type == HandleType::kRadial;
  const Vec3& axis = axisAt(scope, axisOf(annotation.orient).axis);
  const Vec3 normal = axis * ((radial ? line.number / 2 : line.number) == 0 ? -1.0 : 1.0);
  const Vec3 along = glm::normalize(line.segment.end - line.segment.start) * (radial && line.number % 2 == 1 ? -1.0 : 1.0);
  line.scopePlanes.push_back({.across = glm::cross(normal, along), .normal = normal, .inFace = true});
  line.scopePlanes.push_back({.across = axis, .normal = glm::cross(along, axis), .inFace = false});
}

double sphereRadius(const Obb& scope) { return 0.5 * std::min({scope.size.x, scope.size.y, scope.size.z}); }

void addSpherical(const Annotation& annotation, const Obb& scope, const View& view, BaseSegments& segments) {
  const Vec3 center = scope.at(Vec3(0.5) + annotation.translate);
  // The sphere's outline is seen at right angles to the ray through its centre, not to the camera's own direction.
  const Vec3 sight = view.directionTo(center);
  const Vec3 wanted = annotation.orient == Orient::kVertical ? view.up() : view.right();
  const Vec3 radius = glm::normalize(wanted - sight * glm::dot(wanted, sight)) * sphereRadius(scope);
  if (annotation.type == HandleType::kSphericalDiametric) {
    segments.push_back({center - radius, center + radius});
    segments.push_back({center + radius, center - radius});
  } else {
    segments.push_back({center, center + radius});
    segments.push_back({center, center - radius});
    segments.push_back({center + radius, center});
    segments.push_back({center - radius, center});
  }
}

}  // namespace

bool turnedAway(const BaseLine& line, const View& view, double leastSin) {
  const Vec3 sight = view.directionTo(line.segment.middle());
  return !line.faces.empty() && std::ranges::all_of(line.faces, [&](const Vec3& normal) { return glm::dot(normal, sight) > leastSin; });
}

BaseSegments baseSegments(const Annotation& annotation, const Obb& scope, const View& view) {
  BaseSegments segments;
  const AxisSense along = axisOf(annotation.orient);
  switch (annotation.type) {
    case HandleType::kLinearContour:
    case HandleType::kLinearCenter:
      for (int i = 0; along.axis >= 0 && i < (annotation.type == HandleType::kLinearContour ? 4 : 1); ++i) {
        segments.push_back(linearSegment(scope, along, sidesOf(annotation.type, i), annotation.translate));
      }
      break;
    case HandleType::kDiametric:
    case HandleType::kRadial: addCircular(annotation, scope, view, segments); break;
    case HandleType::kSphericalDiametric:
    case HandleType::kSphericalRadial: addSpherical(annotation, scope, view, segments); break;
    case HandleType::kAngular:
    case HandleType::kBoolean:
    case HandleType::kRange: break;
  }
  return segments;
}

BaseLine baseLine(const Annotation& annotation, const Obb& scope, int number, const Segment& segment) {
  BaseLine line{.segment = segment, .number = number, .scopePlanes = {}, .faces = {}};
  switch (annotation.type) {
    case HandleType::kLinearContour:
    case HandleType::kLinearCenter: addLinearPlanes(scope, axisOf(annotation.orient).axis, sidesOf(annotation.type, number), line); break;
    case HandleType::kDiametric:
    case HandleType::kRadial: addCircularPlanes(annotation, scope, line); break;
    case HandleType::kSphericalDiametric:
    case HandleType::kSphericalRadial:
    case HandleType::kAngular:
    case HandleType::kBoolean:
    case HandleType::kRange: break;
  }
  return line;
}

BaseLines baseLines(const Annotation& annotation, const Obb& scope, const View& view) {
  BaseLines lines;
  for (const Segment& segment : baseSegments(annotation, scope, view)) lines.push_back(baseLine(annotation, scope, static_cast<int>(lines.size()), segment));
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
