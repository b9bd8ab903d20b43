#include "gltf/gltf_container.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "gltf/tinygltf_only.h"

namespace dimline {

namespace {

using nlohmann::json;

/// The parser recurses into what it does not know (extras, extensions); real files stay far below this.
constexpr int kMaxNesting = 64;

/// Extensions that a file may require: they change nothing that is read here, or are read.
constexpr std::array<std::string_view, 5> kReadableExtensions{"KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_unlit",
                                                              "KHR_lights_punctual", "KHR_node_visibility"};

std::uint32_t littleEndian(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return value;
}

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The chunks of a .glb: the JSON's text, and the size of the binary one.
struct Chunks {
  std::string_view json;
  std::uint64_t binaryLength = 0;
};

Result<Chunks> chunksOf(std::span<const std::byte> bytes) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBin = 0x004E4942;
  if (bytes.size() < 20) return Error{"the file ends within its header."};
  if (littleEndian(bytes, 4) != 2) {
    return Error{"this is binary glTF of version " + std::to_string(littleEndian(bytes, 4)) +
                 "; only version 2 is read."};
  }
  const std::uint64_t length = littleEndian(bytes, 8);
  if (length > bytes.size()) {
    return Error{"the file is cut off: it says that it has " + std::to_string(length) + " bytes, but there are " +
                 std::to_string(bytes.size()) + "."};
  }
  const std::uint64_t jsonEnd = 20 + std::uint64_t{littleEndian(bytes, 12)};
  if (littleEndian(bytes, 16) != kJson || jsonEnd > length) {
    return Error{"the file is damaged: its first part is not the JSON that it should be."};
  }
  Chunks chunks{asText(bytes.subspan(20, jsonEnd - 20)), 0};
  if (jsonEnd == length) return chunks;
  if (jsonEnd + 8 > length) return Error{"the file is damaged: it ends within the header of its second part."};
  chunks.binaryLength = littleEndian(bytes, jsonEnd);
  if (littleEndian(bytes, jsonEnd + 4) != kBin || jsonEnd + 8 + chunks.binaryLength > length ||
      chunks.binaryLength % 4 != 0) {
    return Error{"the file is damaged: its second part is not the binary data that it should be."};
  }
  return chunks;
}

bool isNestedTooDeep(std::string_view text) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxNesting) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

// --- JSON that is not what it should be gives nothing, never an abort -----------------------------------------------

const json* member(const json* object, const char* name) {
  if (object == nullptr || !object->is_object()) return nullptr;
  const auto found = object->find(name);
  return found == object->end() ? nullptr : &*found;
}

const json* element(const json* array, const json* index) {
  if (array == nullptr || !array->is_array() || index == nullptr || !index->is_number_unsigned()) return nullptr;
  const auto i = index->get<std::uint64_t>();
  return i < array->size() ? &(*array)[static_cast<std::size_t>(i)] : nullptr;
}

/// A size that may be missing; nothing when it is no whole number from 0 to kMaxGltfSize.
std::optional<std::uint64_t> sizeOf(const json& object, const char* name, std::uint64_t whenMissing) {
  const json* value = member(&object, name);
  if (value == nullptr) return whenMissing;
  if (!value->is_number_unsigned() || value->get<std::uint64_t>() > kMaxGltfSize) return std::nullopt;
  return value->get<std::uint64_t>();
}

std::string stringOf(const json* object, const char* name) {
  const json* value = member(object, name);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

/// The named array of objects; empty when it is missing.
Result<std::span<const json>> objectsOf(const json& root, const char* name) {
  const json* array = member(&root, name);
  if (array == nullptr) return std::span<const json>();
  const auto badly = [&] {
    return Error{"the file is damaged: its " + std::string(name) + " are no list of objects."};
  };
  if (!array->is_array()) return badly();
  const auto& elements = *array->get_ptr<const json::array_t*>();
  for (const json& object : elements) {
    if (!object.is_object()) return badly();
  }
  return std::span<const json>(elements);
}

// --- Checks -----------------------------------------------------------------------------------------------------------

Status checkVersion(const json& root) {
  const std::string version = stringOf(member(&root, "asset"), "version");
  if (version.empty()) return Error{"this is no glTF: it does not say which version it is (asset.version)."};
  if (!version.starts_with("2."))
    return Error{"this is glTF of version " + inQuotes(version) + "; only version 2 is read."};

  const json* required = member(&root, "extensionsRequired");
  if (required == nullptr || !required->is_array()) return okStatus();
  for (const json& extension : *required) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : std::string();
    if (std::find(kReadableExtensions.begin(), kReadableExtensions.end(), name) == kReadableExtensions.end()) {
      const bool compressed = name.find("compression") != std::string::npos;
      return Error{"the file needs the extension " + inQuotes(name) + ", which is not supported; export it without " +
                   (compressed ? "compression." : "it.")};
    }
  }
  return okStatus();
}

/// Fills the external buffers; the sizes of all buffers.
Result<std::vector<std::uint64_t>> checkBuffers(const json& root, bool binary, std::uint64_t binaryLength,
                                                GltfContainer& container) {
  const auto buffers = objectsOf(root, "buffers");
  if (!buffers) return buffers.error();
  std::vector<std::uint64_t> sizes;
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const json& buffer = (*buffers)[i];
    const std::string label = "buffer " + std::to_string(i);
    const auto size = sizeOf(buffer, "byteLength", 0);
    if (!size || *size == 0)
      return Error{label + " does not say how many bytes it has (byteLength), or says nonsense."};
    sizes.push_back(*size);

    const std::string uri = stringOf(&buffer, "uri");
    if (uri.empty()) {
      if (!binary) return Error{label + " names no file that holds its bytes (uri)."};
      if (*size > binaryLength) {
        return Error{label + " should have " + std::to_string(*size) + " bytes, but the file holds " +
                     std::to_string(binaryLength) + "."};
      }
    } else if (!uri.starts_with("data:")) {
      container.externalBuffers.push_back({i, uri, *size});
    } else if (!tinygltf::IsDataURI(uri.substr(0, 64))) {
      return Error{label +
                   " is spelled out in a way that is not understood; use data:application/octet-stream;base64."};
    }
  }
  return sizes;
}

Status checkBufferViews(const json& root, std::span<const std::uint64_t> bufferSizes) {
  const auto views = objectsOf(root, "bufferViews");
  if (!views) return views.error();
  for (std::size_t i = 0; i < views->size(); ++i) {
    const json& view = (*views)[i];
    const std::string label = "buffer view " + std::to_string(i);
    const auto buffer = sizeOf(view, "buffer", kMaxGltfSize);
    if (!buffer || *buffer >= bufferSizes.size()) return Error{label + " belongs to a buffer that does not exist."};
    const auto offset = sizeOf(view, "byteOffset", 0);
    const auto length = sizeOf(view, "byteLength", 0);
    if (!offset || !length || *length == 0 || *offset + *length > bufferSizes[*buffer]) {
      return Error{label + " reaches past the end of its buffer."};
    }
  }
  return okStatus();
}

Status checkAccessors(const json& root) {
  const auto accessors = objectsOf(root, "accessors");
  if (!accessors) return accessors.error();
  for (std::size_t i = 0; i < accessors->size(); ++i) {
    const json& accessor = (*accessors)[i];
    const auto count = sizeOf(accessor, "count", 0);
    if (!sizeOf(accessor, "byteOffset", 0) || !count || *count == 0) {
      return Error{"accessor " + std::to_string(i) + " has a count or an offset that makes no sense."};
    }
  }
  return okStatus();
}

/// The external images that a material uses as its base colour; whatever is broken on the way there is somebody else's to tell.
std::vector<std::string> baseColorFiles(const json& root) {
  std::vector<std::string> files;
  const json* materials = member(&root, "materials");
  if (materials == nullptr || !materials->is_array()) return files;
  for (const json& material : *materials) {
    const json* info = member(member(&material, "pbrMetallicRoughness"), "baseColorTexture");
    const json* texture = element(member(&root, "textures"), member(info, "index"));
    const json* image = element(member(&root, "images"), member(texture, "source"));
    const std::string uri = stringOf(image, "uri");
    const bool known = std::find(files.begin(), files.end(), uri) != files.end();
    if (!uri.empty() && !uri.starts_with("data:") && !known) files.push_back(uri);
  }
  return files;
}

}  // namespace

Result<GltfContainer> openGltf(std::span<const std::byte> bytes) {
  if (bytes.empty()) return Error{"the file is empty."};
  if (bytes.size() > kMaxGltfSize) return Error{"the file has more than 2 GB; only smaller ones are read."};

  GltfContainer container;
  container.json = asText(bytes);
  container.binary = container.json.starts_with("glTF");
  std::uint64_t binaryLength = 0;
  if (container.binary) {
    const auto chunks = chunksOf(bytes);
    if (!chunks) return chunks.error();
    container.json = chunks->json;
    binaryLength = chunks->binaryLength;
  }
  if (isNestedTooDeep(container.json)) {
    return Error{"the JSON is nested more than " + std::to_string(kMaxNesting) + " deep, which no glTF is."};
  }
  const json root = json::parse(container.json, nullptr, false);
  if (!root.is_object()) return Error{"this is no glTF: it is neither a .glb nor a .gltf's JSON, or it is cut off."};

  if (Status status = checkVersion(root); !status) return status.error();
  const auto sizes = checkBuffers(root, container.binary, binaryLength, container);
  if (!sizes) return sizes.error();
  if (Status status = checkBufferViews(root, *sizes); !status) return status.error();
  if (Status status = checkAccessors(root); !status) return status.error();
  for (const char* name : {"meshes", "nodes", "scenes", "materials", "textures", "images"}) {
    if (const auto objects = objectsOf(root, name); !objects) return objects.error();
  }
  container.externalImages = baseColorFiles(root);
  return container;
}

}  // namespace dimline
