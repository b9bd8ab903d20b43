#include <string>
#include <utility>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "bindings/byte_array.h"
#include "core/text.h"
#include "gltf/gltf_reader.h"

// The module dimline_gltf: one function, which makes of a glTF file a scene for Editor.setScene(). It is a module of its own because most visitors
// open no file, and the reader, with its JSON parser and its picture decoders, is a seventh of what they would have to fetch.

namespace dimline {

namespace {

/// {"scene": a Uint8Array, "notes": a sentence for each thing that is left out}, or {"error": a sentence}. `files` holds a Uint8Array for each URI that a .gltf names; those that no surface shows may be missing.
emscripten::val importGltfFile(const std::string& name, const emscripten::val& bytes, const emscripten::val& files) {
  emscripten::val result = emscripten::val::object();
  const auto failed = [&](const std::string& sentence) {
    result.set("error", sentence);
    return result;
  };
  const auto content = bytesOf(bytes);
  if (!content) return failed("The contents of " + inQuotes(name) + " must be a Uint8Array.");
  const GltfFileResolver resolve = [&](std::string_view uri) -> Result<std::vector<std::byte>> {
    const emscripten::val file = files.isNull() || files.isUndefined() ? files : files[std::string(uri)];
    auto found = bytesOf(file);
    if (!found) return Error{"The file " + inQuotes(uri) + " was not given along."};
    return std::move(*found);
  };
  const auto scene = importGltf(name, *content, resolve);
  if (!scene) return failed(scene.error().message);
  result.set("scene", byteArrayOf(bytesOf(*scene)));
  result.set("notes", emscripten::val::array(scene->diagnostics));
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(dimline_gltf) { emscripten::function("importGltf", &importGltfFile); }

}  // namespace dimline
