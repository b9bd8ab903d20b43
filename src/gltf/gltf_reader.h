#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/imported_scene.h"

namespace dimline {

/// Gives the bytes of a file that a .gltf names, or says why it cannot. `uri` is spelled as in the file: relative to it, and
/// percent-encoded.
using GltfFileResolver = std::function<Result<std::vector<std::byte>>(std::string_view uri)>;

/// Reads a glTF 2.0 file, .gltf or .glb (told apart by their first bytes).
///
/// Geometry: every mesh that the default scene places, with its node's transform; triangles, strips and fans; positions that agree
/// exactly are shared between faces, and normals are computed where there are none. Base colour, its texture (PNG, JPEG; at most 1024
/// pixels a side, reduced when larger), roughness and doubleSided are kept. Each named node with something to see in or below it is a
/// named part. What lies more than a thousand times its size from the origin is put there.
///
/// `name` is the file's, with or without a folder; errors start with it. A file that is damaged, or that needs what is not supported, gives
/// an error. What can be left out (a texture that cannot be read, lines and points, transparency, colours of vertices, instances, poses) is, and stands in the diagnostics.
Result<ImportedScene> importGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve);

/// The same as a model that can be stretched (stretchedModel() says how).
Result<Model> readGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve);

/// The URIs that importGltf would ask its resolver for, each once, for hosts that must fetch them beforehand.
Result<std::vector<std::string>> externalGltfFiles(std::string_view name, std::span<const std::byte> bytes);

/// readGltf on a path, with the other files taken from beside it. Not for the page, which has no files.
Result<Model> readGltfFile(const std::string& path);

}  // namespace dimline
