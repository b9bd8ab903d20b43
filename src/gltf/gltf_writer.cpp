#include "gltf/gltf_writer.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>
#include <unordered_map>

#include <glm/gtc/type_ptr.hpp>

#include "core/version.h"
#include "gltf/image_encoder.h"
#include "gltf/tinygltf_only.h"

namespace dimline {

namespace {

/// What tells one vertex from another.
struct Vertex {
  glm::vec3 position, normal;
  glm::vec2 uv{0.0F};
  bool operator==(const Vertex&) const = default;
};

struct VertexHash {
  std::size_t operator()(const Vertex& vertex) const {
    std::size_t hash = 0;
    const auto add = [&hash](float number) { hash = hash * 1'000'003 + std::hash<float>()(number); };
    for (int i = 0; i < 3; ++i) add(vertex.position[i]), add(vertex.normal[i]);
    add(vertex.uv.x), add(vertex.uv.y);
    return hash;
  }
};

/// The triangles of one material in a mesh.
struct Part {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

class Writer {
public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  Result<std::string> write(std::string_view title) {
    if (scene_.triangleCount() == 0) return Error{"the model has no triangles, so there is nothing to write."};
    file_.asset.version = "2.0";
    file_.asset.generator = "Dimline " + std::string(kVersion);
    file_.buffers.emplace_back();
    if (Status status = writeImages(); !status) return status.error();
    materials_.assign(scene_.materials.size(), -1);
    meshes_.assign(scene_.meshes.size(), -1);
    for (const Instance& instance : scene_.instances) {
      if (meshes_[instance.mesh] < 0) meshes_[instance.mesh] = writeMesh(scene_.meshes[instance.mesh]);
    }
    writeNodes(title);
    // Lengths in a .glb have 32 bits, those of its JSON included.
    if (bytes().size() > std::numeric_limits<std::uint32_t>::max() / 2) return Error{"the model is too large for a .glb file, which ends at 4 GB."};
    std::ostringstream stream;
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&file_, stream, false, true);
    return std::move(stream).str();
  }

private:
  std::vector<unsigned char>& bytes() { return file_.buffers.front().data; }

  /// Appends to the buffer, on an offset that numbers of four bytes may have. `target`: of the view, 0 for none.
  int appendView(const void* data, std::size_t size, int target) {
    bytes().resize((bytes().size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes().size();
    view.byteLength = size;
    view.target = target;
    const auto* first = static_cast<const unsigned char*>(data);
    bytes().insert(bytes().end(), first, first + size);
    file_.bufferViews.push_back(std::move(view));
    return static_cast<int>(file_.bufferViews.size()) - 1;
  }

  template <typename T>
  int appendAccessor(const std::vector<T>& values, int componentType, int type, int target) {
    tinygltf::Accessor accessor;
    accessor.bufferView = appendView(values.data(), values.size() * sizeof(T), target);
    accessor.componentType = componentType;
    accessor.type = type;
    accessor.count = values.size();
    file_.accessors.push_back(std::move(accessor));
    return static_cast<int>(file_.accessors.size()) - 1;
  }

  Status writeImages() {
    for (const SharedImage& image : scene_.images) {
      const std::vector<unsigned char> png = encodePng(*image);
      if (png.empty()) return Error{"a texture of " + std::to_string(image->width) + " x " + std::to_string(image->height) + " pixels cannot be packed."};
      tinygltf::Image written;
      written.mimeType = "image/png";
      written.bufferView = appendView(png.data(), png.size(), 0);
      tinygltf::Texture texture;
      texture.source = static_cast<int>(file_.images.size());
      file_.images.push_back(std::move(written));
      file_.textures.push_back(std::move(texture));
    }
    return okStatus();
  }

  /// A material's number in the file, which holds those that are used.
  int numberOf(std::size_t material) {
    if (materials_[material] < 0) {
      materials_[material] = static_cast<int>(file_.materials.size());
      file_.materials.push_back(written(scene_.materials[material]));
    }
    return materials_[material];
  }

  static tinygltf::Material written(const Material& material) {
    tinygltf::Material result;
    auto& surface = result.pbrMetallicRoughness;
    surface.baseColorFactor = {material.color.r, material.color.g, material.color.b, 1.0};
    surface.metallicFactor = 0;
    surface.roughnessFactor = material.roughness;
    surface.baseColorTexture.index = material.image;
    result.doubleSided = material.twoSided;
    return result;
  }

  std::vector<Part> partsOf(const Mesh& mesh) const {
    std::vector<Part> parts(scene_.materials.size());
    std::vector<std::unordered_map<Vertex, std::uint32_t, VertexHash>> known(parts.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::size_t material = mesh.materials[i];
      Part& part = parts[material];
      // A builder's texture coordinates are for its patterns.
      const bool textured = scene_.materials[material].image >= 0 && !mesh.uvs.empty();
      for (std::size_t c = 0; c < 3; ++c) {
        const Vertex vertex{mesh.positions[mesh.triangles[i][c]], mesh.normals[i][c], textured ? mesh.uvs[i][c] : glm::vec2(0.0F)};
        const auto [entry, added] = known[material].try_emplace(vertex, static_cast<std::uint32_t>(part.vertices.size()));
        if (added) part.vertices.push_back(vertex);
        part.indices.push_back(entry->second);
      }
    }
    return parts;
  }

  int appendPositions(const Part& part) {
    std::vector<glm::vec3> positions;
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const Vertex& vertex : part.vertices) {
      positions.push_back(vertex.position);
      low = glm::min(low, vertex.position);
      high = glm::max(high, vertex.position);
    }
    const int accessor = appendAccessor(positions, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
    file_.accessors.back().minValues = {low.x, low.y, low.z};
    file_.accessors.back().maxValues = {high.x, high.y, high.z};
    return accessor;
  }

  int appendIndices(const Part& part) {
    // 65,535 would be the sign that starts a strip anew.
    if (part.vertices.size() > 65'535)
      return appendAccessor(part.indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    const std::vector<std::uint16_t> indices(part.indices.begin(), part.indices.end());
    return appendAccessor(indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

  /// The mesh's number in the file. Of a mesh without triangles there is nothing to write, since glTF wants a primitive at least: -1.
  int writeMesh(const Mesh& mesh) {
    tinygltf::Mesh written;
    const std::vector<Part> parts = partsOf(mesh);
    for (std::size_t material = 0; material < parts.size(); ++material) {
      const Part& part = parts[material];
      if (part.indices.empty()) continue;
      tinygltf::Primitive primitive;
      primitive.mode = TINYGLTF_MODE_TRIANGLES;
      primitive.material = numberOf(material);
      primitive.attributes["POSITION"] = appendPositions(part);
      std::vector<glm::vec3> normals;
      for (const Vertex& vertex : part.vertices) normals.push_back(vertex.normal);
      primitive.attributes["NORMAL"] = appendAccessor(normals, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
      if (scene_.materials[material].image >= 0 && !mesh.uvs.empty()) {
        std::vector<glm::vec2> uvs;
        for (const Vertex& vertex : part.vertices) uvs.push_back(vertex.uv);
        primitive.attributes["TEXCOORD_0"] = appendAccessor(uvs, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, TINYGLTF_TARGET_ARRAY_BUFFER);
      }
      primitive.indices = appendIndices(part);
      written.primitives.push_back(std::move(primitive));
    }
    if (written.primitives.empty()) return -1;
    file_.meshes.push_back(std::move(written));
    return static_cast<int>(file_.meshes.size()) - 1;
  }

  void writeNodes(std::string_view title) {
    tinygltf::Node root;
    root.name = title;
    file_.nodes.push_back(root);
    for (const Instance& instance : scene_.instances) {
      if (meshes_[instance.mesh] < 0) continue;
      tinygltf::Node node;
      node.mesh = meshes_[instance.mesh];
      if (instance.transform != glm::mat4(1.0F)) {
        const float* numbers = glm::value_ptr(instance.transform);
        node.matrix.assign(numbers, numbers + 16);
      }
      file_.nodes.front().children.push_back(static_cast<int>(file_.nodes.size()));
      file_.nodes.push_back(std::move(node));
    }
    tinygltf::Scene scene;
    scene.nodes = {0};
    file_.scenes.push_back(std::move(scene));
    file_.defaultScene = 0;
  }

  const Scene& scene_;
  tinygltf::Model file_;
  std::vector<int> materials_;  ///< of each material of the scene: its number in the file, or -1
  std::vector<int> meshes_;     ///< of each mesh, likewise
};

}  // namespace

Result<std::string> writeGlb(const Scene& scene, std::string_view title) { return Writer(scene).write(title); }

}  // namespace dimline
