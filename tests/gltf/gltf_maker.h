#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <nlohmann/json.hpp>

namespace dimline {

/// Puts a glTF file together, piece by piece, good or bad: `root` is open to any mischief.
struct GltfMaker {
  nlohmann::json root;
  std::vector<std::byte> bin;

  GltfMaker() {
    root["asset"]["version"] = "2.0";
    root["scenes"][0]["nodes"] = nlohmann::json::array();
    root["scene"] = 0;
  }

  /// A buffer view over the bytes; its index.
  int view(std::span<const std::byte> bytes, int byteStride = 0) {
    while (bin.size() % 4 != 0) bin.push_back(std::byte{0});
    nlohmann::json v = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    if (byteStride != 0) v["byteStride"] = byteStride;
    bin.insert(bin.end(), bytes.begin(), bytes.end());
    root["bufferViews"].push_back(v);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  int accessor(int view, int componentType, std::size_t count, const char* type) {
    root["accessors"].push_back(
        {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return static_cast<int>(root["accessors"].size()) - 1;
  }
  int floats(const std::vector<glm::vec3>& values) {
    return accessor(view(std::as_bytes(std::span(values))), 5126, values.size(), "VEC3");
  }
  int floats(const std::vector<glm::vec2>& values) {
    return accessor(view(std::as_bytes(std::span(values))), 5126, values.size(), "VEC2");
  }
  int indices(const std::vector<std::uint16_t>& values) {
    return accessor(view(std::as_bytes(std::span(values))), 5123, values.size(), "SCALAR");
  }

  /// A mesh of one primitive; its index.
  int mesh(nlohmann::json primitive) {
    root["meshes"].push_back({{"primitives", nlohmann::json::array({std::move(primitive)})}});
    return static_cast<int>(root["meshes"].size()) - 1;
  }

  /// A node at the top of the scene; its index.
  int node(nlohmann::json properties) {
    const int index = child(std::move(properties));
    root["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  /// A node that the caller hangs in himself.
  int child(nlohmann::json properties) {
    root["nodes"].push_back(std::move(properties));
    return static_cast<int>(root["nodes"].size()) - 1;
  }

  /// A box from (0,0,0) to `size` as exporters write it: 24 vertices with flat normals, so that no two faces share any.
  int box(glm::vec3 size, nlohmann::json extra = {}) {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint16_t> triangles;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        const auto first = static_cast<std::uint16_t>(positions.size());
        for (int corner = 0; corner < 4; ++corner) {
          // Counter-clockwise seen from outside: on the near side the second axis turns into the third.
          const int a = corner == 1 || corner == 2 ? 1 : 0, b = corner >= 2 ? 1 : 0;
          glm::vec3 p(0.0F);
          p[axis] = static_cast<float>(side);
          p[(axis + 1) % 3] = static_cast<float>(side == 1 ? a : b);
          p[(axis + 2) % 3] = static_cast<float>(side == 1 ? b : a);
          positions.push_back(p * size);
          glm::vec3 n(0.0F);
          n[axis] = side == 1 ? 1.0F : -1.0F;
          normals.push_back(n);
        }
        for (const int k : {0, 1, 2, 0, 2, 3}) triangles.push_back(static_cast<std::uint16_t>(first + k));
      }
    }
    nlohmann::json primitive = {{"attributes", {{"POSITION", floats(positions)}, {"NORMAL", floats(normals)}}},
                                {"indices", indices(triangles)}};
    if (extra.is_object()) primitive.update(extra);
    return mesh(primitive);
  }

  [[nodiscard]] std::vector<std::byte> glb() const {
    nlohmann::json whole = root;
    std::vector<std::byte> data = bin;
    while (data.size() % 4 != 0) data.push_back(std::byte{0});
    if (!data.empty() && !whole.contains("buffers")) whole["buffers"][0]["byteLength"] = bin.size();
    std::string text = whole.dump();
    while (text.size() % 4 != 0) text += ' ';

    std::vector<std::byte> file;
    const auto word = [&](std::size_t value) {
      for (unsigned shift = 0; shift < 32; shift += 8) file.push_back(static_cast<std::byte>((value >> shift) & 0xFFU));
    };
    word(0x46546C67);
    word(2);
    word(20 + text.size() + (data.empty() ? 0 : 8 + data.size()));
    word(text.size());
    word(0x4E4F534A);
    for (const char c : text) file.push_back(static_cast<std::byte>(c));
    if (!data.empty()) {
      word(data.size());
      word(0x004E4942);
      file.insert(file.end(), data.begin(), data.end());
    }
    return file;
  }

  /// The JSON alone, its buffer a file of the given name.
  [[nodiscard]] std::vector<std::byte> gltf(const std::string& bufferUri) const {
    nlohmann::json whole = root;
    if (!whole.contains("buffers")) whole["buffers"][0] = {{"byteLength", bin.size()}, {"uri", bufferUri}};
    const std::string text = whole.dump();
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
  }
};

}  // namespace dimline
