#include "cli/bench_scenes.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>

namespace dimline {

namespace {

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const glm::vec3 normal =
      glm::normalize(glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
  mesh.triangles.push_back({a, b, c});
  mesh.materials.push_back(0);
  mesh.normals.push_back({normal, normal, normal});
}

/// A closed column of so many sides and rings, swelling a little in the middle, 1 m across and 5 m high.
Mesh column(std::uint32_t sides, std::uint32_t rings) {
  Mesh mesh;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    const float height = static_cast<float>(ring) / static_cast<float>(rings);
    const float radius = 0.4F + 0.1F * std::sin(3.14159265F * height);
    for (std::uint32_t side = 0; side < sides; ++side) {
      const float angle = 6.28318531F * static_cast<float>(side) / static_cast<float>(sides);
      mesh.positions.emplace_back(radius * std::cos(angle), 5 * height, -radius * std::sin(angle));
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t side) { return ring * sides + side % sides; };
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t side = 0; side < sides; ++side) {
      addTriangle(mesh, at(ring, side), at(ring, side + 1), at(ring + 1, side + 1));
      addTriangle(mesh, at(ring, side), at(ring + 1, side + 1), at(ring + 1, side));
    }
  }
  for (std::uint32_t side = 1; side + 1 < sides; ++side) {
    addTriangle(mesh, at(0, 0), at(0, side + 1), at(0, side));
    addTriangle(mesh, at(rings, 0), at(rings, side), at(rings, side + 1));
  }
  return mesh;
}

/// A box on the ground, its middle over the origin.
Mesh block(const glm::vec3& size) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(((i & 1) != 0 ? 0.5F : -0.5F) * size.x, (i & 2) != 0 ? size.y : 0.0F,
                                ((i & 4) != 0 ? 0.5F : -0.5F) * size.z);
  }
  for (const auto& face : {std::array<std::uint32_t, 4>{0, 4, 6, 2},
                           {1, 3, 7, 5},
                           {0, 1, 5, 4},
                           {2, 6, 7, 3},
                           {0, 2, 3, 1},
                           {4, 5, 7, 6}}) {
    addTriangle(mesh, face[0], face[1], face[2]);
    addTriangle(mesh, face[0], face[2], face[3]);
  }
  return mesh;
}

constexpr double kWallM = 40.0;
constexpr double kLeastWindowM = 1.5;

Parameter lengthParameter(const char* name, double value, const char* annotation) {
  return {.name = name,
          .title = name,
          .unit = Unit::kMetre,
          .defaultValue = value,
          .min = 0.1,
          .max = 1000,
          .annotation = annotation};
}

}  // namespace

ModelDefinition columnField(std::size_t triangles) {
  constexpr int kColumnsASide = 10;
  constexpr double kSpacingM = 2.0;
  ModelDefinition definition;
  definition.name = "column-field";
  definition.title = "Columns";
  definition.parameters = {lengthParameter("Width", 20, "@Handle(scope=Field, type=linear-contour, orient=right)"),
                           lengthParameter("Depth", 20, "@Handle(scope=Field, type=linear-contour, orient=back)"),
                           lengthParameter("Height", 5, "@Handle(scope=Field, type=linear-contour, orient=up)"),
                           lengthParameter("Column", 5, "@Handle(scope=Column, type=linear-contour, orient=up)")};
  // Two triangles a side and ring, twice as many sides as rings where there are enough.
  const double each = static_cast<double>(triangles) / (kColumnsASide * kColumnsASide);
  const auto rings = static_cast<std::uint32_t>(std::max(1.0, std::sqrt(each / 4)));
  const auto sides = static_cast<std::uint32_t>(std::max(3.0, (each + 4) / (2 * rings + 2)));
  definition.build = [rings, sides](const Values&) {
    Scene scene;
    scene.materials.emplace_back();
    scene.meshes.push_back(column(sides, rings));
    for (int i = 0; i < kColumnsASide; ++i) {
      for (int k = 0; k < kColumnsASide; ++k) {
        const glm::vec3 foot(kSpacingM * (i - 0.5 * (kColumnsASide - 1)), 0,
                             kSpacingM * (k - 0.5 * (kColumnsASide - 1)));
        scene.instances.push_back({0, glm::translate(glm::mat4(1.0F), foot)});
      }
    }
    const double side = kColumnsASide * kSpacingM;
    scene.scopes.push_back({"Field", 0, {.origin = {-side / 2, 0, -side / 2}, .size = {side, 5, side}}});
    scene.scopes.push_back({"Column", 0, {.origin = {side / 2 - 1.5, 0, side / 2 - 1.5}, .size = {1, 5, 1}}});
    finish(scene);
    return scene;
  };
  return definition;
}

ModelDefinition windowWall(std::size_t windows, bool chained) {
  ModelDefinition definition;
  definition.name = "window-wall";
  definition.title = "Windows";
  const char* across = chained ? "@Handle(scope=Window, type=linear-contour, orient=right, chained)"
                               : "@Handle(scope=Window, type=linear-contour, orient=right)";
  const char* upwards = chained ? "@Handle(scope=Window, type=linear-contour, orient=up, chained)"
                                : "@Handle(scope=Window, type=linear-contour, orient=up)";
  definition.parameters = {lengthParameter("WindowWidth", 0.5, across), lengthParameter("WindowHeight", 0.5, upwards)};
  definition.build = [windows](const Values&) {
    Scene scene;
    scene.materials.emplace_back();
    scene.meshes.push_back(block(glm::vec3(kWallM)));
    scene.instances.push_back({0, glm::mat4(1.0F)});
    const std::size_t onEach = (windows + 3) / 4;
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(onEach))));
    const std::size_t rows = (onEach + columns - 1) / columns;
    const Vec2 cell(kWallM / static_cast<double>(columns), kWallM / static_cast<double>(rows));
    for (std::size_t i = 0; i < windows; ++i) {
      const std::size_t wall = i % 4;
      const std::size_t place = i / 4;
      const Vec3 outward[] = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}};
      const Vec3 up(0, 1, 0);
      const Vec3 right = glm::cross(up, outward[wall]);
      // However many there are, a window stays large enough to be shown; then they overlap.
      const Vec2 size(std::max(0.5 * cell.x, kLeastWindowM), std::max(0.5 * cell.y, kLeastWindowM));
      const Vec2 corner = glm::min(
          Vec2(static_cast<double>(place % columns), static_cast<double>(place / columns)) * cell, Vec2(kWallM) - size);
      scene.scopes.push_back({"Window",
                              0,
                              {.origin = outward[wall] * (kWallM / 2) + right * (corner.x - kWallM / 2) + up * corner.y,
                               .axes = {right, up, outward[wall]},
                               .size = {size.x, size.y, 0.1}}});
    }
    finish(scene);
    return scene;
  };
  return definition;
}

}  // namespace dimline
