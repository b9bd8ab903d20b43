#include "gltf/gltf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/power.h"
#include "core/text.h"
#include "gltf/gltf_container.h"
#include "gltf/gltf_file.h"

// The file becomes a `Source` once; each evaluation of the model is the source under a stretch. A node whose transform, stretched, is still
// a rotation with a positive scale per axis shares its mesh as an instance; one that is mirrored or sheared (a turned node in a
// stretched whole) is written out in world coordinates, as Instance cannot say it.

namespace dimline {

namespace {

/// m. Farther out, floats leave no room for the model's own detail.
constexpr double kMaxCoordinateM = 1e8;

/// An axis in which the model has less than this share of its size is flat: it cannot be stretched.
constexpr double kFlatShare = 1e-6;

/// How far columns may be from right angles, as the cosine between them, to count as a rotation with scales.
constexpr double kRightAngle = 1e-6;

struct Placed {
  std::size_t mesh = 0;
  Mat4 world{1.0};
};

struct NamedNode {
  std::string name;
  Mat4 world{1.0};
  std::size_t firstPlaced = 0, endPlaced = 0;  ///< what is in or below it
};

struct Source {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Placed> placed;
  std::vector<NamedNode> nodes;
  Bounds bounds;
};

// --- Meshes -----------------------------------------------------------------------------------------------------------

struct PositionHash {
  std::size_t operator()(const glm::vec3& p) const {
    std::array<std::uint32_t, 3> bits;
    std::memcpy(bits.data(), &p, sizeof bits);
    std::uint64_t hash = 0;
    for (const std::uint32_t b : bits) hash = (hash ^ b) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(hash ^ (hash >> 29U));
  }
};

/// Not normalised: twice the area. Zero for a triangle that is none. In double, so that millimetres do not vanish when squared.
Vec3 areaVector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  return glm::cross(b - a, c - a);
}

/// A vector as a unit normal; the fallback when it has no direction.
glm::vec3 unitOr(const Vec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  if (length > 1e-12) return glm::vec3(v / length);
  return glm::vec3(glm::normalize(fallback));
}

/// One mesh of all primitives, with positions that agree shared among them: files repeat a position for each normal and uv that
/// meet there, which would make every edge a border.
Mesh weld(const GltfMesh& source) {
  Mesh mesh;
  std::unordered_map<glm::vec3, std::uint32_t, PositionHash> known;
  const bool hasUvs = std::any_of(source.primitives.begin(), source.primitives.end(),
                                  [](const GltfPrimitive& primitive) { return !primitive.uvs.empty(); });
  for (const GltfPrimitive& primitive : source.primitives) {
    std::vector<std::uint32_t> indices;
    indices.reserve(primitive.positions.size());
    for (const glm::vec3& position : primitive.positions) {
      const glm::vec3 key = position + 0.0F;  // -0 and 0 are one place
      const auto [entry, isNew] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
      if (isNew) mesh.positions.push_back(key);
      indices.push_back(entry->second);
    }
    for (const auto& corners : primitive.triangles) {
      const std::array<std::uint32_t, 3> triangle{indices[corners[0]], indices[corners[1]], indices[corners[2]]};
      const Vec3 area = areaVector(mesh, triangle);
      if (!(glm::dot(area, area) > 0)) continue;
      mesh.triangles.push_back(triangle);
      mesh.materials.push_back(primitive.material);
      // glTF: without normals, faces are flat.
      auto& normals = mesh.normals.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        normals[c] = unitOr(primitive.normals.empty() ? Vec3(0.0) : Vec3(primitive.normals[corners[c]]), area);
      }
      if (!hasUvs) continue;
      auto& uvs = mesh.uvs.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) uvs[c] = primitive.uvs.empty() ? glm::vec2(0.0F) : primitive.uvs[corners[c]];
    }
  }
  return mesh;
}

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

// --- The source --------------------------------------------------------------------------------------------------------

/// Walks the tree, parents before children. Without recursion: a file may be a chain of a hundred thousand nodes.
void place(const GltfFile& file, Source& source) {
  struct Step {
    int node = 0;
    Mat4 parent{1.0};
    std::optional<std::size_t> leaving;  ///< the named node that ends here
  };
  std::vector<Step> open;
  for (auto root = file.roots.rbegin(); root != file.roots.rend(); ++root) open.push_back({*root, Mat4(1.0), {}});
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    if (step.leaving) {
      source.nodes[*step.leaving].endPlaced = source.placed.size();
      continue;
    }
    const GltfNode& node = file.nodes[static_cast<std::size_t>(step.node)];
    const Mat4 world = step.parent * node.transform;
    // "Model" is the scope of the whole.
    if (!node.name.empty() && node.name != "Model") {
      open.push_back({step.node, world, source.nodes.size()});
      source.nodes.push_back({node.name, world, source.placed.size(), 0});
    }
    if (node.mesh >= 0 && !source.meshes[static_cast<std::size_t>(node.mesh)].triangles.empty()) {
      source.placed.push_back({static_cast<std::size_t>(node.mesh), world});
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      open.push_back({*child, world, {}});
  }
  std::erase_if(source.nodes, [](const NamedNode& node) { return node.firstPlaced == node.endPlaced; });
}

Result<Source> sourceOf(GltfFile file) {
  Source source;
  source.materials = std::move(file.materials);
  source.images = std::move(file.images);
  for (const GltfMesh& mesh : file.meshes) source.meshes.push_back(weld(mesh));
  place(file, source);
  for (const Placed& placed : source.placed) {
    for (const glm::vec3& p : source.meshes[placed.mesh].positions) {
      const Vec3 world(placed.world * Vec4(p, 1.0));
      for (int i = 0; i < 3; ++i) {
        if (!(std::abs(world[i]) <= kMaxCoordinateM)) {
          return Error{"the model reaches farther than 100,000 km from its origin; scale it down."};
        }
      }
      source.bounds.add(world);
    }
  }
  if (!(source.bounds.diagonal() > 0)) return Error{"the file shows no triangles, so there is nothing to dimension."};
  return source;
}

// --- The model ---------------------------------------------------------------------------------------------------------

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

Obb boxAround(const Source& source, const NamedNode& node, const Mat4& stretch) {
  Obb box;
  box.axes = frameOf(stretch * node.world);
  Bounds along;
  for (std::size_t i = node.firstPlaced; i < node.endPlaced; ++i) {
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
Scene sceneOf(const Source& source, const Vec3& factors) {
  Mat4 stretch(1.0);
  for (int i = 0; i < 3; ++i) {
    stretch[i][i] = factors[i];
    stretch[3][i] = source.bounds.min[i] * (1 - factors[i]);
  }

  Scene scene;
  scene.materials = source.materials;
  scene.images = source.images;
  std::vector<std::optional<std::uint32_t>> shared(source.meshes.size());
  for (const Placed& placed : source.placed) {
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
  for (const NamedNode& node : source.nodes) scene.scopes.push_back({node.name, 0, boxAround(source, node, stretch)});
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
constexpr AxisText kAxes[] = {{"Width", "Stretches the whole from left to right.", "right"},
                              {"Height", "Stretches the whole upwards.", "up"},
                              {"Depth", "Stretches the whole from back to front.", "front"}};

Parameter stretchParameter(int axis, double sizeM) {
  const AxisText& text = kAxes[axis];
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

ModelDefinition definitionOf(std::string_view name, std::shared_ptr<const Source> source) {
  ModelDefinition definition;
  definition.name = trim(stemOf(name)).empty() ? "model" : std::string(trim(stemOf(name)));
  definition.title = definition.name;
  std::replace(definition.title.begin(), definition.title.end(), '_', ' ');

  std::vector<int> axes;
  std::vector<double> sizes;
  for (int i = 0; i < 3; ++i) {
    const double sizeM = source->bounds.size()[i];
    if (sizeM <= kFlatShare * source->bounds.diagonal()) continue;
    definition.parameters.push_back(stretchParameter(i, sizeM));
    axes.push_back(i);
    sizes.push_back(definition.parameters.back().defaultValue);
  }
  definition.build = [source = std::move(source), axes, sizes](const Values& values) {
    Vec3 factors(1.0);
    for (std::size_t i = 0; i < axes.size(); ++i) factors[axes[i]] = values.at(i) / sizes[i];
    return sceneOf(*source, factors);
  };
  return definition;
}

}  // namespace

Result<Model> readGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve) {
  const auto inFile = [&](const Error& error) { return Error{std::string(name) + ": " + error.message}; };
  auto file = loadGltf(bytes, resolve);
  if (!file) return inFile(file.error());
  std::vector<std::string> diagnostics = file->diagnostics;
  auto source = sourceOf(std::move(file).value());
  if (!source) return inFile(source.error());

  auto model = makeModel(definitionOf(name, std::make_shared<const Source>(std::move(source).value())));
  if (!model) return inFile(model.error());
  Model result = std::move(model).value();
  result.diagnostics.insert(result.diagnostics.begin(), diagnostics.begin(), diagnostics.end());
  return result;
}

Result<std::vector<std::string>> externalGltfFiles(std::string_view name, std::span<const std::byte> bytes) {
  const auto container = openGltf(bytes);
  if (!container) return Error{std::string(name) + ": " + container.error().message};
  std::vector<std::string> files;
  const auto add = [&](const std::string& uri) {
    if (std::find(files.begin(), files.end(), uri) == files.end()) files.push_back(uri);
  };
  for (const auto& buffer : container->externalBuffers) add(buffer.uri);
  for (const std::string& image : container->externalImages) add(image);
  return files;
}

}  // namespace dimline
