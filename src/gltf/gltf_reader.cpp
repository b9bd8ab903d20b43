#include "gltf/gltf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <unordered_map>

#include <glm/gtc/matrix_transform.hpp>

#include "core/text.h"
#include "gltf/gltf_container.h"
#include "gltf/gltf_file.h"
#include "model/mesh_faces.h"

namespace dimline {

namespace {

/// m. Farther out, floats leave no room for the model's own detail.
constexpr double kMaxCoordinateM = 1e8;
/// How many times its size a model may lie from the origin. Maps and surveys put theirs hundreds of kilometres away, where floats have no digits left for its parts.
constexpr double kFarFromOrigin = 1000.0;
/// m. Smaller models would be measured in digits that no label has.
constexpr double kLeastDiagonalM = 1e-5;

struct PositionHash {
  std::size_t operator()(const glm::vec3& p) const {
    std::array<std::uint32_t, 3> bits;
    std::memcpy(bits.data(), &p, sizeof bits);
    std::uint64_t hash = 0;
    for (const std::uint32_t b : bits) hash = (hash ^ b) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(hash ^ (hash >> 29U));
  }
};

/// One mesh of all primitives, with positions that agree shared among them: files repeat a position for each normal and uv that
/// meet there, which would make every edge a border. Positions that no triangle uses are left out: files keep several meshes' in one list, and they would count as the model's size.
Mesh weld(const GltfMesh& source) {
  Mesh mesh;
  std::unordered_map<glm::vec3, std::uint32_t, PositionHash> known;
  const bool hasUvs = std::any_of(source.primitives.begin(), source.primitives.end(),
                                  [](const GltfPrimitive& primitive) { return !primitive.uvs.empty(); });
  for (const GltfPrimitive& primitive : source.primitives) {
    const auto welded = [&](std::uint32_t corner) {
      const glm::vec3 key = primitive.positions[corner] + 0.0F;  // -0 and 0 are one place
      const auto [entry, isNew] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
      if (isNew) mesh.positions.push_back(key);
      return entry->second;
    };
    for (const auto& corners : primitive.triangles) {
      const Vec3 area = areaVector(primitive.positions, corners);
      if (!(glm::dot(area, area) > 0)) continue;
      const std::array<std::uint32_t, 3> triangle{welded(corners[0]), welded(corners[1]), welded(corners[2])};
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

/// Walks the tree, parents before children. Without recursion: a file may be a chain of a hundred thousand nodes.
void place(const GltfFile& file, ImportedScene& scene) {
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
      scene.parts[*step.leaving].endPlaced = static_cast<std::uint32_t>(scene.placed.size());
      continue;
    }
    const GltfNode& node = file.nodes[static_cast<std::size_t>(step.node)];
    const Mat4 world = step.parent * node.transform;
    // "Model" is the scope of the whole.
    if (!node.name.empty() && node.name != "Model") {
      open.push_back({step.node, world, scene.parts.size()});
      scene.parts.push_back({node.name, world, static_cast<std::uint32_t>(scene.placed.size()), 0});
    }
    if (node.mesh >= 0 && !scene.meshes[static_cast<std::size_t>(node.mesh)].triangles.empty()) {
      scene.placed.push_back({static_cast<std::uint32_t>(node.mesh), world});
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      open.push_back({*child, world, {}});
  }
  std::erase_if(scene.parts, [](const ImportedScene::NamedPart& part) { return part.firstPlaced == part.endPlaced; });
}

/// Puts what lies far away at the origin, and says so.
void bringHome(ImportedScene& scene) {
  const Vec3 middle = scene.bounds.center();
  const double awayM = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
  if (awayM <= kFarFromOrigin * scene.bounds.diagonal()) return;
  const Vec3 home = -Vec3(middle.x, scene.bounds.min.y, middle.z);
  const Mat4 move = glm::translate(Mat4(1.0), home);
  for (ImportedScene::Placed& placed : scene.placed) placed.world = move * placed.world;
  for (ImportedScene::NamedPart& part : scene.parts) part.world = move * part.world;
  scene.bounds = {scene.bounds.min + home, scene.bounds.max + home};
  scene.diagnostics.push_back("The model lies far from its origin, " + formatFixed(awayM / 1000, 0) + " km; it is shown at the origin.");
}

Result<ImportedScene> sceneOf(GltfFile file) {
  ImportedScene scene;
  scene.materials = std::move(file.materials);
  scene.images = std::move(file.images);
  scene.diagnostics = std::move(file.diagnostics);
  for (const GltfMesh& mesh : file.meshes) scene.meshes.push_back(weld(mesh));
  place(file, scene);
  for (const ImportedScene::Placed& placed : scene.placed) {
    for (const glm::vec3& p : scene.meshes[placed.mesh].positions) {
      const Vec3 world(placed.world * Vec4(p, 1.0));
      for (int i = 0; i < 3; ++i) {
        if (!(std::abs(world[i]) <= kMaxCoordinateM)) {
          return Error{"the model reaches farther than 100,000 km from its origin; scale it down."};
        }
      }
      scene.bounds.add(world);
    }
  }
  if (!(scene.bounds.diagonal() > 0)) {
    const std::string why = scene.diagnostics.empty() ? "" : " " + scene.diagnostics.front();
    return Error{"the file shows no triangles, so there is nothing to dimension." + why};
  }
  if (scene.bounds.diagonal() < kLeastDiagonalM)
    return Error{"the model is less than a hundredth of a millimetre large, too small to be measured; lengths in glTF are in metres, so scale it up."};
  bringHome(scene);
  return scene;
}

}  // namespace

Result<ImportedScene> importGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve) {
  const auto inFile = [&](const Error& error) { return Error{std::string(name) + ": " + error.message}; };
  auto file = loadGltf(bytes, resolve);
  if (!file) return inFile(file.error());
  auto read = sceneOf(std::move(file).value());
  if (!read) return inFile(read.error());
  ImportedScene scene = std::move(read).value();
  scene.name = name;
  return scene;
}

Result<Model> readGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve) {
  auto scene = importGltf(name, bytes, resolve);
  if (!scene) return scene.error();
  return stretchedModel(std::move(scene).value());
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
