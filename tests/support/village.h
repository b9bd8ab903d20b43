#pragma once

#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "model/scene.h"

/// A scene with some of everything that drawing depends on, made by hand.
namespace dimline::test {

namespace village {

/// A flat convex face over points of the mesh, counter-clockwise seen from outside.
inline void addFace(Mesh& mesh, std::initializer_list<std::uint32_t> ring, std::uint16_t material) {
  const std::vector<std::uint32_t> points(ring);
  const auto at = [&](std::size_t i) { return mesh.positions[points[i]]; };
  const glm::vec3 n = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
  for (std::size_t i = 2; i < points.size(); ++i) {
    mesh.triangles.push_back({points[0], points[i - 1], points[i]});
    mesh.materials.push_back(material);
    mesh.normals.push_back({n, n, n});
  }
}

inline void addPrism(Mesh& mesh, std::uint16_t material, float x0, float x1, float z0, float z1, float eave, float ridge) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const float middle = (z0 + z1) * 0.5F;
  for (const float x : {x0, x1}) {
    mesh.positions.insert(mesh.positions.end(), {{x, eave, z0}, {x, eave, z1}, {x, ridge, middle}});
  }
  const auto p = [&](std::uint32_t i) { return base + i; };
  addFace(mesh, {p(0), p(1), p(2)}, material);
  addFace(mesh, {p(3), p(5), p(4)}, material);
  addFace(mesh, {p(1), p(4), p(5), p(2)}, material);
  addFace(mesh, {p(0), p(2), p(5), p(3)}, material);
  addFace(mesh, {p(0), p(3), p(4), p(1)}, material);
}

inline void addCylinder(Mesh& mesh, std::uint16_t material, const glm::vec3& foot, float radius, float height, std::uint32_t segments) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < segments; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(segments);
    const glm::vec3 out(std::cos(angle), 0.0F, -std::sin(angle));
    mesh.positions.push_back(foot + out * radius);
    mesh.positions.push_back(foot + out * radius + glm::vec3(0.0F, height, 0.0F));
  }
  const std::uint32_t lower = base + 2 * segments;
  mesh.positions.push_back(foot);
  mesh.positions.push_back(foot + glm::vec3(0.0F, height, 0.0F));
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t a = base + 2 * i;
    const std::uint32_t b = base + 2 * ((i + 1) % segments);
    const std::size_t first = mesh.normals.size();
    addFace(mesh, {a, b, b + 1, a + 1}, material);
    const auto round = [&](std::uint32_t p) { return glm::normalize((mesh.positions[p] - foot) * glm::vec3(1, 0, 1)); };
    mesh.normals[first] = {round(a), round(b), round(b + 1)};
    mesh.normals[first + 1] = {round(a), round(b + 1), round(a + 1)};
    addFace(mesh, {lower, b, a}, material);
    addFace(mesh, {lower + 1, a + 1, b + 1}, material);
  }
}

inline void addBox(Mesh& mesh, const glm::vec3& min, const glm::vec3& max, std::uint16_t material) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1U) != 0 ? max.x : min.x, (i & 2U) != 0 ? max.y : min.y, (i & 4U) != 0 ? max.z : min.z);
  }
  const auto p = [&](std::uint32_t i) { return base + i; };
  addFace(mesh, {p(4), p(5), p(7), p(6)}, material);
  addFace(mesh, {p(1), p(0), p(2), p(3)}, material);
  addFace(mesh, {p(5), p(1), p(3), p(7)}, material);
  addFace(mesh, {p(0), p(4), p(6), p(2)}, material);
  addFace(mesh, {p(6), p(7), p(3), p(2)}, material);
  addFace(mesh, {p(0), p(1), p(5), p(4)}, material);
}

}  // namespace village

/// A small village: a house with a gable roof, a round tower, a balcony, and a row of posts as instances. About 12 x 9 x 10 m,
/// standing on y = 0; patterns and glass; everything but doors and windows is at least 0.4 m thick.
inline Scene villageScene() {
  using namespace village;
  using Pattern = Material::Pattern;
  Scene scene;
  scene.materials = {{.color = {0.80F, 0.78F, 0.73F}, .roughness = 0.9F, .pattern = Pattern::kPlaster},
                     {.color = {0.42F, 0.16F, 0.10F}, .roughness = 0.7F, .pattern = Pattern::kRoofTiles},
                     {.color = {0.45F, 0.20F, 0.13F}, .roughness = 0.8F, .pattern = Pattern::kBrick},
                     {.color = {0.40F, 0.27F, 0.16F}, .roughness = 0.7F, .pattern = Pattern::kPlanks},
                     {.color = {0.35F, 0.42F, 0.48F}, .roughness = 0.1F, .pattern = Pattern::kGlass}};
  scene.meshes.resize(3);
  Mesh& house = scene.meshes[0];
  addBox(house, {-4.0F, 0.0F, -3.0F}, {4.0F, 5.2F, 3.0F}, 0);
  addPrism(house, 1, -4.5F, 4.5F, -3.6F, 3.6F, 5.2F, 8.0F);
  addBox(house, {-2.6F, 2.5F, 3.0F}, {2.6F, 2.9F, 4.4F}, 3);
  addBox(house, {-0.5F, 0.0F, 2.95F}, {0.6F, 2.1F, 3.05F}, 3);
  for (const float x : {-3.2F, -1.9F, 1.4F, 2.7F}) {
    addBox(house, {x, 0.9F, 2.9F}, {x + 0.9F, 2.2F, 3.03F}, 4);
    addBox(house, {x, 3.6F, 2.9F}, {x + 0.9F, 4.8F, 3.03F}, 4);
  }
  addCylinder(scene.meshes[1], 2, {0.0F, 0.0F, 0.0F}, 1.4F, 8.6F, 48);
  addBox(scene.meshes[2], {-0.2F, 0.0F, -0.2F}, {0.2F, 1.2F, 0.2F}, 3);

  const glm::mat4 one(1.0F);
  scene.instances.push_back({0, one});
  scene.instances.push_back({1, glm::translate(one, {5.2F, 0.0F, -1.8F})});
  for (int i = 0; i < 7; ++i) {
    const glm::mat4 place = glm::translate(one, {-5.6F + 1.9F * static_cast<float>(i), 0.0F, 5.4F});
    scene.instances.push_back({2, glm::scale(glm::rotate(place, 0.3F * static_cast<float>(i), {0, 1, 0}), {1.0F, 1.0F + 0.1F * static_cast<float>(i), 1.0F})});
  }
  finish(scene);
  return scene;
}

}  // namespace dimline::test
