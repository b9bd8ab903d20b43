#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gltf/gltf_reader.h"
#include "math/types.h"
#include "model/scene.h"

namespace dimline {

/// Triangles of one material. `normals` and `uvs` are empty or one a vertex; indices are valid; numbers are finite.
struct GltfPrimitive {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::uint16_t material = 0;
};

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
};

struct GltfNode {
  std::string name;
  Mat4 transform{1.0};        ///< to the parent's frame
  int mesh = -1;              ///< valid, or -1
  std::vector<int> children;  ///< valid; each node is the child of one at most, and never of itself
};

/// What a glTF file holds of what a Scene can hold, all references checked.
struct GltfFile {
  std::vector<GltfNode> nodes;
  std::vector<int> roots;
  std::vector<GltfMesh> meshes;
  std::vector<Material> materials;  ///< at least one
  std::vector<Image> images;
  std::vector<std::string> diagnostics;
};

/// Errors are sentences without the file's name.
Result<GltfFile> loadGltf(std::span<const std::byte> bytes, const GltfFileResolver& resolve);

}  // namespace dimline
