#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace dimline {

/// Bytes of a file, and whatever it counts: what fits here fits every integer type on the way, on 32-bit hosts too.
inline constexpr std::uint64_t kMaxGltfSize = (std::uint64_t{1} << 31U) - 1;

/// A glTF file taken apart and checked as far as its parser takes things on trust: a .glb's chunks lie within the file, the JSON is
/// an object of version 2 that is not nested without end, needs no extension that is not supported, and its buffer views lie within its buffers.
struct GltfContainer {
  bool binary = false;
  std::string_view json;

  /// A buffer that is a file of its own, in the order of the buffers.
  struct ExternalBuffer {
    std::size_t index = 0;
    std::string uri;
    std::uint64_t byteLength = 0;
  };
  std::vector<ExternalBuffer> externalBuffers;

  /// Images of their own file that serve as a base colour.
  std::vector<std::string> externalImages;
};

/// Views point into `bytes`. An error is a sentence without the file's name.
Result<GltfContainer> openGltf(std::span<const std::byte> bytes);

}  // namespace dimline
