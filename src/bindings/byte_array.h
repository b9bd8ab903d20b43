#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <emscripten/val.h>

namespace dimline {

/// A copy of a Uint8Array; nothing for any other thing.
inline std::optional<std::vector<std::byte>> bytesOf(const emscripten::val& array) {
  if (!array.instanceof(emscripten::val::global("Uint8Array"))) return std::nullopt;
  std::vector<std::byte> bytes(array["length"].as<unsigned>());
  emscripten::val(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<unsigned char*>(bytes.data())))
      .call<void>("set", array);
  return bytes;
}

/// A Uint8Array of its own, outside this module's memory.
inline emscripten::val byteArrayOf(std::span<const std::byte> bytes) {
  return emscripten::val(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<const unsigned char*>(bytes.data())))
      .call<emscripten::val>("slice");
}

}  // namespace dimline
