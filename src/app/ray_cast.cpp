#include "app/ray_cast.h"

#include <cmath>

#include <glm/matrix.hpp>

namespace dimline {

namespace {

bool meetsBox(const Bounds& box, const Vec3& origin, const Vec3& direction) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) {
      if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return false;
      continue;
    }
    const double a = (box.min[axis] - origin[axis]) / direction[axis];
    const double b = (box.max[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

/// Distance along the ray, in lengths of `direction`, at which it passes through a triangle, from whichever side;
/// infinite when it does not.
double distanceTo(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& origin, const Vec3& direction) {
  constexpr double kMisses = std::numeric_limits<double>::infinity();
  const Vec3 edge1 = b - a;
  const Vec3 edge2 = c - a;
  const Vec3 p = glm::cross(direction, edge2);
  const double determinant = glm::dot(edge1, p);
  if (determinant == 0.0) return kMisses;
  const Vec3 fromA = origin - a;
  const double u = glm::dot(fromA, p) / determinant;
  if (!(u >= 0.0 && u <= 1.0)) return kMisses;
  const Vec3 q = glm::cross(fromA, edge1);
  const double v = glm::dot(direction, q) / determinant;
  if (!(v >= 0.0 && u + v <= 1.0)) return kMisses;
  return glm::dot(edge2, q) / determinant;
}

}  // namespace

std::optional<Vec3> castRay(const Scene& scene, const View::Ray& ray, double atLeastM) {
  std::vector<Bounds> boxes(scene.meshes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const glm::vec3& p : scene.meshes[i].positions) boxes[i].add(Vec3(p));
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toMesh = glm::inverse(Mat4(instance.transform));
    const Vec3 origin(toMesh * Vec4(ray.origin, 1.0));
    const Vec3 direction(toMesh * Vec4(ray.direction, 0.0));  // not of unit length: distances stay those of the world
    if (!meetsBox(boxes[instance.mesh], origin, direction)) continue;
    for (const auto& corners : mesh.triangles) {
      const double distance = distanceTo(Vec3(mesh.positions[corners[0]]), Vec3(mesh.positions[corners[1]]),
                                         Vec3(mesh.positions[corners[2]]), origin, direction);
      if (distance >= atLeastM && distance < nearest) nearest = distance;
    }
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return ray.origin + ray.direction * nearest;
}

}  // namespace dimline
