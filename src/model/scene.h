#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "math/geometry.h"

namespace dimline {

/// A named oriented box in the model (paper 2, "scope"). Several may share a name; `index` counts among those.
struct Scope {
  std::string name;
  std::uint32_t index = 0;
  Obb box;
};

/// What a surface is like. The pattern is drawn by the shader from world positions or uv, in metres, so that a model needs no image files.
struct Material {
  enum class Pattern : std::uint8_t { kPlain, kBrick, kPlaster, kPlanks, kRoofTiles, kStone, kGlass, kMetal, kGrass, kLeaves, kFabric };
  glm::vec3 color{0.8F};       ///< linear-light base colour, 0 to 1
  float roughness = 0.8F;      ///< 0 mirror to 1 chalk
  Pattern pattern = Pattern::kPlain;
  int image = -1;              ///< index into Scene::images for a base colour texture, or -1
  bool twoSided = false;       ///< leaves, sails, glTF's doubleSided; both faces are drawn and both belong to the silhouette
  bool operator==(const Material&) const = default;
};

/// A base colour texture, RGBA8 sRGB, top row first.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// One that all evaluations of a model have in common: pictures are far larger than the geometry, and no parameter changes them. Never null.
using SharedImage = std::shared_ptr<const Image>;
inline SharedImage share(Image image) { return std::make_shared<const Image>(std::move(image)); }

/// Triangles that are used as a whole. Positions are shared between the faces that meet there (so that silhouette edges can be
/// found); normals and uv belong to corners, since buildings have hard edges.
struct Mesh {
  std::vector<glm::vec3> positions;                      ///< m, in the mesh's own frame
  std::vector<std::array<std::uint32_t, 3>> triangles;   ///< counter-clockwise seen from outside
  std::vector<std::uint16_t> materials;                  ///< one a triangle: index into Scene::materials
  std::vector<std::array<glm::vec3, 3>> normals;         ///< one a corner, unit length
  std::vector<std::array<glm::vec2, 3>> uvs;             ///< one a corner, or empty. Builder: metres along the face; glTF: texture coordinates
};

/// A mesh put into the world.
struct Instance {
  std::uint32_t mesh = 0;
  glm::mat4 transform{1.0F};   ///< mesh to world: rotation, positive scale per axis, translation (no mirror unless determinant > 0)
};

/// All that one evaluation of a parametric model gives: geometry and scopes. Plain data, no identity.
struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<SharedImage> images;
  std::vector<Scope> scopes;   ///< in order of creation; Scope::index is set
  Bounds bounds;               ///< of all instances' vertices

  [[nodiscard]] std::size_t triangleCount() const;   ///< instances counted each
};

/// Fills Scene::bounds from the instances, and Scope::index from the scopes' names; a scope with a number that is not finite goes. The Builder and the glTF reader call it last.
void finish(Scene& scene);

}  // namespace dimline
