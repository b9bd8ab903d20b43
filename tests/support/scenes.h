#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

#include "model/model.h"

/// Small scenes made by hand, so that tests of the modules below the Builder need nothing from it.
namespace dimline::test {

/// Adds a closed box as a mesh of its own: 8 shared positions, 12 triangles, outward.
inline void addBox(Scene& scene, const Obb& box) {
  static constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(box.corner(i));
  for (const auto& face : kFaces) {
    for (const auto& corners : {std::array<std::uint32_t, 3>{face[0], face[1], face[2]}, {face[0], face[2], face[3]}}) {
      const glm::vec3 normal = glm::normalize(glm::cross(mesh.positions[corners[1]] - mesh.positions[corners[0]],
                                                         mesh.positions[corners[2]] - mesh.positions[corners[0]]));
      mesh.triangles.push_back(corners);
      mesh.materials.push_back(0);
      mesh.normals.push_back({normal, normal, normal});
    }
  }
  if (scene.materials.empty()) scene.materials.emplace_back();
  scene.instances.push_back({static_cast<std::uint32_t>(scene.meshes.size()), glm::mat4(1.0F)});
  scene.meshes.push_back(std::move(mesh));
}

inline Obb boxAt(const Vec3& origin, const Vec3& size) { return {.origin = origin, .size = size}; }

/// Boxes, each with a scope of its name.
inline Scene sceneOf(std::initializer_list<std::pair<const char*, Obb>> boxes) {
  Scene scene;
  for (const auto& [name, box] : boxes) {
    addBox(scene, box);
    scene.scopes.push_back({name, 0, box});
  }
  finish(scene);
  return scene;
}

/// A box 8 wide, 5 high and 6 deep on the ground around the origin, with Width, Height and Depth measured on the scope `Box`, and a smaller box (a
/// "door", 1 by 2) on its front with a width and a height of its own.
inline ModelDefinition boxWithDoor() {
  ModelDefinition definition;
  definition.name = "box";
  definition.title = "Box";
  const auto length = [&](const char* name, double value, const char* annotation) {
    definition.parameters.push_back({.name = name,
                                     .title = name,
                                     .unit = Unit::kMetre,
                                     .defaultValue = value,
                                     .min = 0.5,
                                     .max = 20,
                                     .step = 0.1,
                                     .annotation = annotation});
  };
  length("Width", 8, "@Handle(scope=Box, type=linear-contour, orient=right, slip=scope)");
  length("Height", 5, "@Handle(scope=Box, type=linear-contour, orient=up, slip=scope)");
  length("Depth", 6, "@Handle(scope=Box, type=linear-contour, orient=back, slip=scope)");
  length("DoorWidth", 1, "@Handle(scope=Door, type=linear-contour, orient=right, slip=scope)");
  length("DoorHeight", 2, "@Handle(scope=Door, type=linear-center, orient=up, slip=billboard)");
  definition.build = [](const Values& v) {
    const Vec3 size{v.at(0), v.at(1), v.at(2)};
    const Obb box = boxAt({-size.x / 2, 0, -size.z / 2}, size);
    const Obb door = boxAt({-v.at(3) / 2, 0, size.z / 2}, {v.at(3), v.at(4), 0.1});
    return sceneOf({{"Box", box}, {"Door", door}});
  };
  return definition;
}

/// A scene that a test makes itself, of which the first of that box's parameters are measured, Width, Height and Depth before all: one an annotation.
inline ModelDefinition measuring(std::initializer_list<std::string> annotations, std::function<Scene(const Values&)> build) {
  ModelDefinition definition = boxWithDoor();
  definition.parameters.resize(annotations.size());
  auto parameter = definition.parameters.begin();
  for (const std::string& annotation : annotations) (parameter++)->annotation = annotation;
  definition.build = std::move(build);
  return definition;
}

/// A camera on an orbit around a point: azimuth from +z towards +x, elevation above the horizon.
inline Camera orbitCamera(const Vec3& target, double distanceM, double azimuthDeg, double elevationDeg, double fovDeg = 35) {
  Camera camera;
  camera.target = target;
  camera.eye = target + distanceM * Vec3(std::sin(azimuthDeg * kRadPerDeg) * std::cos(elevationDeg * kRadPerDeg), std::sin(elevationDeg * kRadPerDeg),
                                         std::cos(azimuthDeg * kRadPerDeg) * std::cos(elevationDeg * kRadPerDeg));
  camera.fovRad = fovDeg * kRadPerDeg;
  return camera;
}

/// Orthographic, from the front and horizontally at a height, over so many metres of height: in 1000x1000, 50 px a metre unless told.
inline Camera straightAt(double heightM, double seenM = 20) {
  Camera camera;
  camera.eye = {0, heightM, 30};
  camera.target = {0, heightM, 0};
  camera.orthoHeightM = seenM;
  return camera;
}

}  // namespace dimline::test
