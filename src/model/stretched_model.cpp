#include "model/imported_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/power.h"
#include "core/text.h"
#include "model/mesh_faces.h"

// Each evaluation of the model is the imported scene under a stretch. A part whose transform, stretched, is still a rotation with a positive
// scale per axis shares its mesh as an instance; one that is mirrored or sheared (a turned part in a stretched whole) is written out in
// world coordinates, as Instance cannot say it.

namespace dimline {

namespace {

/// An axis in which the model has less than this share of its size is flat: it cannot be stretched.
constexpr double kFlatAxisShare = 1e-6;

/// How far columns may be from right angles, as the cosine between them, to count as a rotation with scales.
constexpr double kRightAngle = 1e-6;

/// The mesh in world coordinates. A mirror turns every triangle inside out, so its corners change order.
Mesh bake(const Mesh& mesh, const Mat4& world) {
  const Mat3 linear(world);
  const bool mirrored = glm::determinant(linear) < 0;
  // Normals go by the cofactors: right under any scale, and no division where one is zero.
  const Mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                       glm::cross(linear[0], linear[1]));
  const Mat3 forNormals = mirrored ? cofactors * -1.0 : cofactors;

  Mesh baked;
  baked.positions.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) baked.positions.emplace_back(world * Vec4(p, 1.0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::size_t, 3> order{0, 1, 2};
    if (mirrored) std::swap(order[1], order[2]);
    const auto& from = mesh.triangles[t];
    const std::array<std::uint32_t, 3> triangle{from[order[0]], from[order[1]], from[order[2]]};
    const Vec3 area = areaVector(baked, triangle);
    if (!(glm::dot(area, area) > 0)) continue;  // flattened
    baked.triangles.push_back(triangle);
    baked.materials.push_back(mesh.materials[t]);
    auto& normals = baked.normals.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) normals[c] = unitOr(forNormals * Vec3(mesh.normals[t][order[c]]), area);
    if (mesh.uvs.empty()) continue;
    auto& uvs = baked.uvs.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) uvs[c] = mesh.uvs[t][order[c]];
  }
  return baked;
}

/// A rotation with a positive scale per axis, and a translation.
bool isInstanceTransform(const Mat4& world) {
  const Mat3 m(world);
  if (!(glm::determinant(m) > 0)) return false;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = m[i], &b = m[(i + 1) % 3];
    if (std::abs(glm::dot(a, b)) > kRightAngle * glm::length(a) * glm::length(b)) return false;
  }
  return true;
}

/// An orthonormal frame along the columns of a matrix, as far as they allow: the first keeps its direction, the second its plane.
std::array<Vec3, 3> frameOf(const Mat4& world) {
  const auto directionOr = [](const Vec3& v, const Vec3& fallback) {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : fallback;
  };
  const Vec3 x = directionOr(Vec3(world[0]), {1, 0, 0});
  const Vec3 across = std::abs(x.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 someY = glm::normalize(across - x * glm::dot(across, x));
  const Vec3 column(world[1]);
  const Vec3 y = directionOr(column - x * glm::dot(column, x), someY);
  return {x, y, glm::cross(x, y)};
}

Obb boxAround(const ImportedScene& source, const ImportedScene::NamedPart& part, const Mat4& stretch) {
  Obb box;
  box.axes = frameOf(stretch * part.world);
  Bounds along;
  for (std::size_t i = part.firstPlaced; i < part.endPlaced; ++i) {
    const Mat4 world = stretch * source.placed[i].world;
    for (const glm::vec3& p : source.meshes[source.placed[i].mesh].positions) {
      const Vec3 q(world * Vec4(p, 1.0));
      along.add({glm::dot(q, box.axes[0]), glm::dot(q, box.axes[1]), glm::dot(q, box.axes[2])});
    }
  }
  box.origin = box.axes[0] * along.min.x + box.axes[1] * along.min.y + box.axes[2] * along.min.z;
  box.size = along.size();
  return box;
}

/// The source with each axis scaled away from the lower corner of its bounds.
Scene sceneOf(const ImportedScene& source, std::span<const SharedImage> images, const Vec3& factors) {
  Mat4 stretch(1.0);
  for (int i = 0; i < 3; ++i) {
    stretch[i][i] = factors[i];
    stretch[3][i] = source.bounds.min[i] * (1 - factors[i]);
  }

  Scene scene;
  scene.materials = source.materials;
  scene.images.assign(images.begin(), images.end());
  std::vector<std::optional<std::uint32_t>> shared(source.meshes.size());
  for (const ImportedScene::Placed& placed : source.placed) {
    const Mat4 world = stretch * placed.world;
    const Mesh& mesh = source.meshes[placed.mesh];
    if (!isInstanceTransform(world)) {
      Mesh baked = bake(mesh, world);
      if (baked.triangles.empty()) continue;
      scene.instances.push_back({static_cast<std::uint32_t>(scene.meshes.size()), glm::mat4(1.0F)});
      scene.meshes.push_back(std::move(baked));
      continue;
    }
    auto& index = shared[placed.mesh];
    if (!index) {
      index = static_cast<std::uint32_t>(scene.meshes.size());
      scene.meshes.push_back(mesh);
    }
    scene.instances.push_back({*index, glm::mat4(world)});
  }
  scene.scopes.push_back({"Model", 0, {}});
  for (const ImportedScene::NamedPart& part : source.parts) scene.scopes.push_back({part.name, 0, boxAround(source, part, stretch)});
  finish(scene);
  scene.scopes[0].box.origin = scene.bounds.min;
  scene.scopes[0].box.size = scene.bounds.size();
  return scene;
}

/// 1, 2 or 5 times a power of ten, the nearest (by ratio) to the value.
double roundNumberNear(double value) {
  const auto ratio = [value](double to) { return std::max(to / value, value / to); };
  const double ten = powerOfTenWithin(value);
  double best = ten;
  for (const double digit : {2.0, 5.0, 10.0}) {
    if (ratio(digit * ten) < ratio(best)) best = digit * ten;
  }
  return best;
}

/// Six digits: what a person would call the size of a box whose corners are floats.
double withoutFloatNoise(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

struct AxisText {
  const char *name, *help, *orient;
};
constexpr AxisText kAxisTexts[] = {{"Width", "Stretches the whole from left to right.", "right"},
                              {"Height", "Stretches the whole upwards.", "up"},
                              {"Depth", "Stretches the whole from back to front.", "front"}};

Parameter stretchParameter(int axis, double sizeM) {
  const AxisText& text = kAxisTexts[axis];
  Parameter p;
  p.name = p.title = text.name;
  p.help = text.help;
  p.group = "Size";
  p.unit = Unit::kMetre;
  p.defaultValue = withoutFloatNoise(sizeM);
  p.step = roundNumberNear(sizeM / 200);
  // Whole steps, so that dragging gives round numbers.
  p.min = withoutFloatNoise(std::max(std::round(sizeM / 4 / p.step), 1.0) * p.step);
  p.max = withoutFloatNoise(std::round(sizeM * 4 / p.step) * p.step);
  p.annotation = "@Handle(scope=Model, type=linear-contour, orient=" + std::string(text.orient) + ", slip=scope)";
  return p;
}

std::string_view stemOf(std::string_view name) {
  if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string_view::npos)
    name.remove_prefix(slash + 1);
  if (const std::size_t dot = name.find_last_of('.'); dot != std::string_view::npos && dot > 0)
    name = name.substr(0, dot);
  return name;
}

ModelDefinition definitionOf(std::shared_ptr<const ImportedScene> source, std::vector<SharedImage> images) {
  ModelDefinition definition;
  const std::string_view stem = trim(stemOf(source->name));
  definition.name = stem.empty() ? "model" : readable(stem);   // a file may have any name
  definition.title = definition.name;
  std::replace(definition.title.begin(), definition.title.end(), '_', ' ');

  std::vector<int> axes;
  std::vector<double> sizes;
  for (int i = 0; i < 3; ++i) {
    const double sizeM = source->bounds.size()[i];
    if (sizeM <= kFlatAxisShare * source->bounds.diagonal()) continue;
    definition.parameters.push_back(stretchParameter(i, sizeM));
    axes.push_back(i);
    sizes.push_back(definition.parameters.back().defaultValue);
  }
  definition.build = [source = std::move(source), images = std::move(images), axes, sizes](const Values& values) {
    Vec3 factors(1.0);
    for (std::size_t i = 0; i < axes.size(); ++i) factors[axes[i]] = values.at(i) / sizes[i];
    return sceneOf(*source, images, factors);
  };
  return definition;
}

}  // namespace

Result<Model> stretchedModel(ImportedScene imported) {
  std::vector<std::string> diagnostics = std::move(imported.diagnostics);
  std::vector<SharedImage> images;
  for (Image& image : std::exchange(imported.images, {})) images.push_back(share(std::move(image)));
  const auto source = std::make_shared<const ImportedScene>(std::move(imported));
  auto model = makeModel(definitionOf(source, std::move(images)));
  if (!model) return Error{source->name + ": " + model.error().message};
  Model result = std::move(model).value();
  result.diagnostics.insert(result.diagnostics.begin(), std::make_move_iterator(diagnostics.begin()), std::make_move_iterator(diagnostics.end()));
  return result;
}

}  // namespace dimline
