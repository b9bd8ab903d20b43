#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "gltf/tinygltf_only.h"

namespace dimline {

/// Reads accessors, every index and range checked. Errors name the accessor.
class AccessorReader {
public:
  explicit AccessorReader(const tinygltf::Model& model) : model_(model) {}

  /// All elements one after the other, `components` (2, 3 or 4) numbers each: floats, or integers, normalized or not. Sparse accessors
  /// are filled in. All are finite.
  [[nodiscard]] Result<std::vector<float>> floats(int accessor, int components) const;

  /// Unsigned integers, one each.
  [[nodiscard]] Result<std::vector<std::uint32_t>> indices(int accessor) const;

private:
  /// The bytes of `count` elements of `elementSize`, `stride` apart, checked to lie within their buffer.
  struct Elements {
    std::span<const unsigned char> bytes;
    std::size_t stride = 0;
    [[nodiscard]] const unsigned char* at(std::size_t i) const { return bytes.data() + i * stride; }
  };
  [[nodiscard]] Result<const tinygltf::Accessor*> find(int accessor) const;
  [[nodiscard]] Result<Elements> elements(int bufferView, std::size_t byteOffset, std::size_t count,
                                          std::size_t elementSize, const std::string& label) const;
  [[nodiscard]] Status fillSparse(const tinygltf::Accessor& accessor, int components, const std::string& label,
                                  std::vector<float>& values) const;

  const tinygltf::Model& model_;
};

}  // namespace dimline
