#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/camera.h"
#include "model/model.h"

/// A world put elsewhere, and the camera along with it, so that the picture stays, or is the mirror's.
namespace dimline::test {

/// x -> scale * turn * mirror * x + move.
struct Motion {
  Vec3 move{0.0};
  double turnRad = 0;      ///< about y
  double scale = 1;
  bool mirrored = false;   ///< x -> -x, before it is turned

  [[nodiscard]] Vec3 direction(const Vec3& d) const {
    // A quarter turn's cosine is rounded to 6e-17: as 0 it leaves all other numbers as exact as they are.
    const double cosine = std::abs(std::cos(turnRad)) < 1e-15 ? 0 : std::cos(turnRad);
    const double sine = std::sin(turnRad);
    const double x = mirrored ? -d.x : d.x;
    return {cosine * x + sine * d.z, d.y, -sine * x + cosine * d.z};
  }
  [[nodiscard]] Vec3 point(const Vec3& p) const { return direction(p) * scale + move; }
};

/// Right-handed again: in the mirror the first axis runs the other way, from the other end.
inline Obb moved(Obb box, const Motion& motion) {
  if (motion.mirrored) {
    box.origin += box.axes[0] * box.size.x;
    box.axes[0] = -box.axes[0];
  }
  box.origin = motion.point(box.origin);
  for (Vec3& axis : box.axes) axis = motion.direction(axis);
  box.size *= motion.scale;
  return box;
}

inline Camera moved(Camera camera, const Motion& motion) {
  camera.eye = motion.point(camera.eye);
  camera.target = motion.point(camera.target);
  camera.up = motion.direction(camera.up);
  if (camera.orthoHeightM) camera.orthoHeightM = *camera.orthoHeightM * motion.scale;
  return camera;
}

/// Each instance a mesh in the world's frame: so that vertices are rounded once only, as they are moved.
inline Scene moved(Scene scene, const Motion& motion) {
  Scene there;
  there.materials = std::move(scene.materials);
  there.images = std::move(scene.images);
  for (const Instance& instance : scene.instances) {
    Mesh mesh = scene.meshes[instance.mesh];
    for (auto& p : mesh.positions) p = glm::vec3(motion.point(Vec3(glm::vec3(instance.transform * glm::vec4(p, 1.0F)))));
    for (auto& normals : mesh.normals) {
      for (auto& n : normals) n = glm::normalize(glm::vec3(motion.direction(Vec3(glm::mat3(instance.transform) * n))));
    }
    if (motion.mirrored) {
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
        std::swap(mesh.normals[i][1], mesh.normals[i][2]);
        if (!mesh.uvs.empty()) std::swap(mesh.uvs[i][1], mesh.uvs[i][2]);
      }
    }
    there.instances.push_back({static_cast<std::uint32_t>(there.meshes.size()), glm::mat4(1.0F)});
    there.meshes.push_back(std::move(mesh));
  }
  for (Scope& scope : scene.scopes) there.scopes.push_back({scope.name, 0, moved(scope.box, motion)});
  finish(there);
  return there;
}

/// Two words for one another, wherever an annotation has them.
inline std::string exchanged(std::string annotation, std::string_view one, std::string_view other) {
  for (std::size_t at = 0; at < annotation.size(); ++at) {
    for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
      if (annotation.compare(at, from.size(), from) != 0) continue;
      annotation.replace(at, from.size(), to);
      at += to.size() - 1;
      break;
    }
  }
  return annotation;
}

/// In the mirror what is measured to the right is measured to the left.
inline ModelDefinition moved(ModelDefinition definition, const Motion& motion) {
  definition.build = [build = definition.build, motion](const Values& values) { return moved(build(values), motion); };
  if (motion.mirrored) {
    for (Parameter& parameter : definition.parameters) parameter.annotation = exchanged(parameter.annotation, "left", "right");
  }
  return definition;
}

/// The same parameters in another order: at place i the one that was at order[i].
inline ModelDefinition reordered(ModelDefinition definition, std::vector<std::size_t> order) {
  const std::vector<Parameter> parameters = definition.parameters;
  for (std::size_t i = 0; i < order.size(); ++i) definition.parameters[i] = parameters[order[i]];
  definition.build = [build = definition.build, parameters, order = std::move(order)](const Values& values) {
    Values back(parameters);
    for (std::size_t i = 0; i < order.size(); ++i) back.set(order[i], values.at(i));
    return build(back);
  };
  return definition;
}

}  // namespace dimline::test
