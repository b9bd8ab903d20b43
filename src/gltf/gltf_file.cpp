#include "gltf/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

#include "core/text.h"
#include "gltf/accessor_reader.h"
#include "gltf/gltf_container.h"
#include "gltf/image_decoder.h"
#include "gltf/tinygltf_only.h"

namespace dimline {

namespace {

/// A texture is looked at on a surface of some hundred pixels, and goes with every rebuilt scene.
constexpr std::uint32_t kMaxTextureSidePx = 1024;

/// Characters of what the parser says: it may quote a whole buffer.
constexpr std::size_t kMaxReason = 200;

/// By how much a matrix's last row may miss 0, 0, 0, 1: what exporters that multiply in single precision leave.
constexpr double kMatrixTolerance = 1e-5;

// --- Files for tinygltf ---------------------------------------------------------------------------------------------

/// What the resolver gave for each external buffer. tinygltf asks for them one by one, in order, under names that it has decoded in
/// its own way, so only the order counts.
struct BufferFiles {
  std::vector<std::vector<std::byte>> files;
  std::size_t next = 0;
};

bool fileExists(const std::string&, void*) { return true; }
std::string samePath(const std::string& path, void*) { return path; }
bool readNextFile(std::vector<unsigned char>* out, std::string*, const std::string&, void* user) {
  auto& files = *static_cast<BufferFiles*>(user);
  if (files.next >= files.files.size()) return false;
  const std::vector<std::byte>& file = files.files[files.next++];
  out->resize(file.size());
  if (!file.empty()) std::memcpy(out->data(), file.data(), file.size());
  return true;
}

/// Keeps an image as it is stored: most are never shown.
bool keepImage(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
               int size, void*) {
  image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

Result<BufferFiles> resolveBuffers(const GltfContainer& container, const GltfFileResolver& resolve) {
  BufferFiles files;
  for (const auto& buffer : container.externalBuffers) {
    auto bytes = resolve(buffer.uri);
    if (!bytes) return bytes.error();
    std::vector<std::byte> file = std::move(bytes).value();
    if (file.size() < buffer.byteLength) {
      return Error{"the file " + inQuotes(buffer.uri) + " should have " + std::to_string(buffer.byteLength) +
                   " bytes, but has " + std::to_string(file.size()) + "."};
    }
    // A few exporters pad the file; tinygltf wants the exact size.
    file.resize(static_cast<std::size_t>(buffer.byteLength));
    files.files.push_back(std::move(file));
  }
  return files;
}

Result<tinygltf::Model> parse(std::span<const std::byte> bytes, const GltfContainer& container, BufferFiles& files) {
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({fileExists, samePath, readNextFile, nullptr, &files});
  parser.SetImageLoader(keepImage, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned int>(bytes.size());
  const bool good = container.binary ? parser.LoadBinaryFromMemory(&model, &error, &warning, data, size)
                                     : parser.LoadASCIIFromString(&model, &error, &warning,
                                                                  reinterpret_cast<const char*>(data), size, "");
  if (good) return model;
  std::string reason = error.substr(0, error.find('\n'));
  while (reason.ends_with('.') || reason.ends_with(' ')) reason.pop_back();
  return Error{"the file is damaged: " + (reason.empty() ? std::string("it cannot be parsed") : readable(reason, kMaxReason)) + "."};
}

// --- Conversion -----------------------------------------------------------------------------------------------------

/// How a base colour texture is laid on: which set of coordinates, and KHR_texture_transform.
struct TextureUse {
  int image = -1;  ///< index into GltfFile::images
  int texCoord = 0;
  glm::mat3 transform{1.0F};
};

/// A number of an extension, kept to what makes sense as texture coordinates.
float coordinateOf(const tinygltf::Value& value) {
  return static_cast<float>(std::clamp(value.GetNumberAsDouble(), -1e6, 1e6));
}

glm::vec2 vec2Of(const tinygltf::Value& extension, const char* name, glm::vec2 whenMissing) {
  if (!extension.Has(name)) return whenMissing;
  const tinygltf::Value& value = extension.Get(name);
  if (value.ArrayLen() != 2 || !value.Get(0).IsNumber() || !value.Get(1).IsNumber()) return whenMissing;
  return {coordinateOf(value.Get(0)), coordinateOf(value.Get(1))};
}

void readTextureTransform(const tinygltf::TextureInfo& info, TextureUse& use) {
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found == info.extensions.end() || !found->second.IsObject()) return;
  const tinygltf::Value& extension = found->second;
  const glm::vec2 offset = vec2Of(extension, "offset", glm::vec2(0.0F));
  const glm::vec2 scale = vec2Of(extension, "scale", glm::vec2(1.0F));
  float angle = 0;
  if (extension.Has("rotation") && extension.Get("rotation").IsNumber()) {
    angle = coordinateOf(extension.Get("rotation"));
  }
  if (extension.Has("texCoord") && extension.Get("texCoord").IsInt()) {
    use.texCoord = extension.Get("texCoord").GetNumberAsInt();
  }
  const float c = std::cos(angle), s = std::sin(angle);
  use.transform =
      glm::mat3(glm::vec3(c * scale.x, -s * scale.x, 0), glm::vec3(s * scale.y, c * scale.y, 0), glm::vec3(offset, 1));
}

class Converter {
public:
  Converter(const tinygltf::Model& model, const GltfFileResolver& resolve)
      : model_(model), resolve_(resolve), accessors_(model) {}

  Result<GltfFile> convert() {
    if (Status status = convertMaterials(); !status) return status.error();
    if (Status status = convertMeshes(); !status) return status.error();
    if (Status status = convertNodes(); !status) return status.error();
    if (Status status = findRoots(); !status) return status.error();
    return std::move(file_);
  }

private:
  void leaveOut(const std::string& what) {
    if (std::ranges::find(file_.diagnostics, what) == file_.diagnostics.end()) file_.diagnostics.push_back(what);
  }

  // Materials and images

  Status convertMaterials() {
    if (model_.materials.size() >= std::numeric_limits<std::uint16_t>::max()) {
      return Error{"the file has more than 65,534 materials."};
    }
    for (const tinygltf::Material& source : model_.materials) {
      const auto& pbr = source.pbrMetallicRoughness;
      Material material;
      material.color = glm::vec3(1.0F);
      // The parser may have read fewer than four.
      for (glm::length_t c = 0; c < 3 && static_cast<std::size_t>(c) < pbr.baseColorFactor.size(); ++c) {
        material.color[c] = static_cast<float>(std::clamp(pbr.baseColorFactor[static_cast<std::size_t>(c)], 0.0, 1.0));
      }
      material.roughness = static_cast<float>(std::clamp(pbr.roughnessFactor, 0.0, 1.0));
      material.twoSided = source.doubleSided;
      if (source.alphaMode != "OPAQUE") leaveOut("Material " + std::to_string(file_.materials.size()) + " is shown without its transparency.");
      TextureUse use;
      if (pbr.baseColorTexture.index >= 0) {
        use.texCoord = pbr.baseColorTexture.texCoord;
        readTextureTransform(pbr.baseColorTexture, use);
        use.image = imageOf(pbr.baseColorTexture.index);
      }
      material.image = use.image;
      file_.materials.push_back(material);
      textures_.push_back(use);
    }
    file_.materials.emplace_back();  // for surfaces without one
    textures_.emplace_back();
    return okStatus();
  }

  /// The index in file_.images of a texture's picture, decoded when it is first asked for; -1 when there is none to be had.
  int imageOf(int texture) {
    if (static_cast<std::size_t>(texture) >= model_.textures.size()) {
      leaveOut("Texture " + std::to_string(texture) + " is used but does not exist; its surfaces have a plain colour.");
      return -1;
    }
    const int source = model_.textures[static_cast<std::size_t>(texture)].source;
    if (source < 0 || static_cast<std::size_t>(source) >= model_.images.size()) {
      leaveOut("Texture " + std::to_string(texture) + " has no PNG or JPEG image; its surfaces have a plain colour.");
      return -1;
    }
    const auto known = images_.find(source);
    if (known != images_.end()) return known->second;
    const tinygltf::Image& stored = model_.images[static_cast<std::size_t>(source)];
    const std::string label = "Image " + (stored.uri.empty() ? std::to_string(source) : inQuotes(stored.uri));
    Result<Image> image = decode(stored);
    int index = -1;
    if (image) {
      index = static_cast<int>(file_.images.size());
      file_.images.push_back(std::move(image).value());
    } else {
      leaveOut(label + " cannot be shown: " + image.error().message + "; its surfaces have a plain colour.");
    }
    images_.emplace(source, index);
    return index;
  }

  Result<Image> decode(const tinygltf::Image& stored) {
    if (stored.uri.empty()) return decodeImage(std::as_bytes(std::span(stored.image)), kMaxTextureSidePx);
    const auto file = resolve_(stored.uri);
    if (!file) {
      std::string reason = file.error().message;
      while (reason.ends_with('.')) reason.pop_back();
      return Error{reason};
    }
    return decodeImage(*file, kMaxTextureSidePx);
  }

  // Meshes

  Status convertMeshes() {
    for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
      GltfMesh mesh;
      for (const tinygltf::Primitive& primitive : model_.meshes[i].primitives) {
        if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
          leaveOut("Mesh " + std::to_string(i) + " has points or lines, which are left out.");
          continue;
        }
        if (primitive.attributes.find("POSITION") == primitive.attributes.end()) continue;
        if (primitive.attributes.contains("COLOR_0")) leaveOut("Mesh " + std::to_string(i) + " is shown without the colours of its vertices.");
        if (!primitive.targets.empty()) leaveOut("Mesh " + std::to_string(i) + " is shown without its morph targets.");
        Result<GltfPrimitive> converted = convertPrimitive(primitive);
        if (!converted) return Error{"in mesh " + std::to_string(i) + ", " + converted.error().message};
        if (!converted->triangles.empty()) mesh.primitives.push_back(std::move(converted).value());
      }
      file_.meshes.push_back(std::move(mesh));
    }
    return okStatus();
  }

  Result<GltfPrimitive> convertPrimitive(const tinygltf::Primitive& source) {
    GltfPrimitive primitive;
    if (source.material >= static_cast<int>(model_.materials.size())) {
      return Error{"material " + std::to_string(source.material) + " is used but does not exist."};
    }
    primitive.material = static_cast<std::uint16_t>(source.material < 0 ? model_.materials.size()
                                                                        : static_cast<std::size_t>(source.material));
    const auto positions = accessors_.floats(source.attributes.at("POSITION"), 3);
    if (!positions) return positions.error();
    const std::size_t count = positions->size() / 3;
    for (std::size_t i = 0; i < count; ++i) primitive.positions.push_back(glm::make_vec3(positions->data() + 3 * i));

    if (const auto found = source.attributes.find("NORMAL"); found != source.attributes.end()) {
      const auto normals = accessors_.floats(found->second, 3);
      if (!normals) return normals.error();
      if (normals->size() != 3 * count) return Error{"there are not as many normals as positions."};
      for (std::size_t i = 0; i < count; ++i) primitive.normals.push_back(glm::make_vec3(normals->data() + 3 * i));
    }
    if (Status status = convertUvs(source, count, primitive); !status) return status.error();
    if (Status status = convertTriangles(source, count, primitive); !status) return status.error();
    return primitive;
  }

  Status convertUvs(const tinygltf::Primitive& source, std::size_t count, GltfPrimitive& primitive) {
    const TextureUse& use = textures_[primitive.material];
    const auto found = source.attributes.find("TEXCOORD_" + std::to_string(use.texCoord));
    if (use.image < 0 || found == source.attributes.end()) return okStatus();
    const auto uvs = accessors_.floats(found->second, 2);
    if (!uvs) return uvs.error();
    if (uvs->size() != 2 * count) return Error{"there are not as many texture coordinates as positions."};
    for (std::size_t i = 0; i < count; ++i) {
      primitive.uvs.emplace_back(use.transform * glm::vec3((*uvs)[2 * i], (*uvs)[2 * i + 1], 1.0F));
    }
    return okStatus();
  }

  Status convertTriangles(const tinygltf::Primitive& source, std::size_t count, GltfPrimitive& primitive) {
    std::vector<std::uint32_t> indices;
    if (source.indices >= 0) {
      auto read = accessors_.indices(source.indices);
      if (!read) return read.error();
      indices = std::move(read).value();
      for (const std::uint32_t index : indices) {
        if (index >= count) {
          return Error{"vertex " + std::to_string(index) + " is used, but there are only " + std::to_string(count) +
                       "."};
        }
      }
    } else {
      indices.resize(count);
      for (std::size_t i = 0; i < count; ++i) indices[i] = static_cast<std::uint32_t>(i);
    }
    auto& triangles = primitive.triangles;
    if (source.mode == TINYGLTF_MODE_TRIANGLES) {
      for (std::size_t i = 0; i + 3 <= indices.size(); i += 3)
        triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
      return okStatus();
    }
    for (std::size_t i = 2; i < indices.size(); ++i) {
      if (source.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        triangles.push_back({indices[0], indices[i - 1], indices[i]});
      } else if (i % 2 == 0) {
        triangles.push_back({indices[i - 2], indices[i - 1], indices[i]});
      } else {
        triangles.push_back(
            {indices[i - 1], indices[i - 2], indices[i]});  // every other one of a strip runs the other way
      }
    }
    return okStatus();
  }

  // Nodes

  static Result<Mat4> transformOf(const tinygltf::Node& node) {
    if (!node.matrix.empty()) {
      if (node.matrix.size() != 16) return Error{"has a matrix that has not 16 numbers."};
      const Mat4 matrix = glm::make_mat4(node.matrix.data());
      const Vec4 lastRow(0, 0, 0, 1);
      const Vec4 missedBy = glm::abs(glm::row(matrix, 3) - lastRow);
      if (!(std::max({missedBy.x, missedBy.y, missedBy.z, missedBy.w}) <= kMatrixTolerance)) return Error{"has a matrix whose last row is not 0, 0, 0, 1."};
      return glm::row(matrix, 3, lastRow);
    }
    const auto& t = node.translation;
    const auto& r = node.rotation;
    const auto& s = node.scale;
    if ((!t.empty() && t.size() != 3) || (!r.empty() && r.size() != 4) || (!s.empty() && s.size() != 3)) {
      return Error{"has a translation, rotation or scale with too few or too many numbers."};
    }
    Mat4 result(1.0);
    if (!r.empty()) {
      const glm::dquat rotation(r[3], r[0], r[1], r[2]);
      const double length = glm::length(rotation);
      if (!(length > 1e-6) || !std::isfinite(length)) return Error{"has a rotation that is no quaternion."};
      result = glm::mat4_cast(rotation / length);
    }
    if (!s.empty()) {
      for (glm::length_t c = 0; c < 3; ++c) result[c] *= s[static_cast<std::size_t>(c)];
    }
    if (!t.empty()) result[3] = Vec4(t[0], t[1], t[2], 1.0);
    return result;
  }

  Status convertNodes() {
    std::vector<int> parents(model_.nodes.size(), -1);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      const tinygltf::Node& source = model_.nodes[i];
      const std::string label = "node " + std::to_string(i);
      GltfNode node;
      node.name = trim(source.name);
      const auto transform = transformOf(source);
      if (!transform) return Error{label + " " + transform.error().message};
      node.transform = *transform;
      node.mesh = source.mesh;
      if (node.mesh >= static_cast<int>(model_.meshes.size())) {
        return Error{label + " shows mesh " + std::to_string(node.mesh) + ", which does not exist."};
      }
      if (node.mesh < 0) node.mesh = -1;
      if (node.mesh >= 0 && source.skin >= 0) {
        leaveOut("Node " + std::to_string(i) + " is shown as it was modelled, without the pose of its skeleton.");
      }
      if (source.extensions.contains("EXT_mesh_gpu_instancing")) leaveOut("Node " + std::to_string(i) + " is shown once, without its instances.");
      for (const int child : source.children) {
        if (child < 0 || static_cast<std::size_t>(child) >= model_.nodes.size()) {
          return Error{label + " has a child that does not exist."};
        }
        if (std::exchange(parents[static_cast<std::size_t>(child)], static_cast<int>(i)) >= 0) {
          return Error{"node " + std::to_string(child) + " has two parents."};
        }
        node.children.push_back(child);
      }
      if (isHidden(source)) {
        node.mesh = -1;
        node.children.clear();
      }
      file_.nodes.push_back(std::move(node));
    }
    return checkForCircles(parents);
  }

  /// By KHR_node_visibility, with all below it.
  static bool isHidden(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_node_visibility");
    if (found == node.extensions.end() || !found->second.Has("visible")) return false;
    const tinygltf::Value& visible = found->second.Get("visible");
    return visible.IsBool() && !visible.Get<bool>();
  }

  /// Every node has one parent at most, so a circle has no way in: the walk upwards from a node never ends exactly when it is on one
  /// or below one.
  static Status checkForCircles(std::span<const int> parents) {
    std::vector<char> fine(parents.size(), 0);
    for (std::size_t i = 0; i < parents.size(); ++i) {
      std::size_t steps = 0;
      int node = static_cast<int>(i);
      while (node >= 0 && fine[static_cast<std::size_t>(node)] == 0) {
        if (++steps > parents.size()) return Error{"node " + std::to_string(node) + " is a part of itself."};
        node = parents[static_cast<std::size_t>(node)];
      }
      for (node = static_cast<int>(i); node >= 0 && fine[static_cast<std::size_t>(node)] == 0;
           node = parents[static_cast<std::size_t>(node)]) {
        fine[static_cast<std::size_t>(node)] = 1;
      }
    }
    return okStatus();
  }

  Status findRoots() {
    if (model_.scenes.empty()) {
      std::vector<char> isChild(file_.nodes.size(), 0);
      for (const GltfNode& node : file_.nodes) {
        for (const int child : node.children) isChild[static_cast<std::size_t>(child)] = 1;
      }
      for (std::size_t i = 0; i < isChild.size(); ++i) {
        if (isChild[i] == 0) file_.roots.push_back(static_cast<int>(i));
      }
      return okStatus();
    }
    const int scene = std::max(model_.defaultScene, 0);
    if (static_cast<std::size_t>(scene) >= model_.scenes.size()) {
      return Error{"scene " + std::to_string(scene) + " is to be shown but does not exist."};
    }
    std::vector<char> seen(file_.nodes.size(), 0);
    for (const int root : model_.scenes[static_cast<std::size_t>(scene)].nodes) {
      if (root < 0 || static_cast<std::size_t>(root) >= file_.nodes.size()) {
        return Error{"the scene shows node " + std::to_string(root) + ", which does not exist."};
      }
      if (std::exchange(seen[static_cast<std::size_t>(root)], 1) == 0) file_.roots.push_back(root);
    }
    return okStatus();
  }

  const tinygltf::Model& model_;
  const GltfFileResolver& resolve_;
  AccessorReader accessors_;
  GltfFile file_;
  std::vector<TextureUse> textures_;  ///< one a material
  std::map<int, int> images_;         ///< from the file's images to file_.images
};

}  // namespace

Result<GltfFile> loadGltf(std::span<const std::byte> bytes, const GltfFileResolver& resolve) {
  const auto container = openGltf(bytes);
  if (!container) return container.error();
  auto resolved = resolveBuffers(*container, resolve);
  if (!resolved) return resolved.error();
  BufferFiles files = std::move(resolved).value();
  const auto model = parse(bytes, *container, files);
  if (!model) return model.error();
  return Converter(*model, resolve).convert();
}

}  // namespace dimline
