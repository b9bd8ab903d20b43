#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/model.h"

namespace dimline {

/// Gives the bytes of a file that a .gltf names, or says why it cannot. `uri` is spelled as in the file: relative to it, and
/// percent-encoded.
using GltfFileResolver = std::function<Result<std::vector<std::byte>>(std::string_view uri)>;

/// Reads a glTF 2.0 file, .gltf or .glb (told apart by their first bytes), as a model that can be stretched.
///
/// Geometry: every mesh that the default scene places, with its node's transform; triangles, strips and fans; positions that agree
/// exactly are shared between faces, and normals are computed where there are none. Mirrored nodes come out with their faces turned
/// outwards. Base colour, its texture (PNG, JPEG; at most 1024 pixels a side, reduced when larger), roughness and
/// doubleSided are kept.
///
/// Parameters: Width, Height and Depth of the bounding box, in metres, at first the file's; each stretches the whole along its axis, away from
/// the left, lower and back side, which stay. An axis in which the model has no extent has no parameter.
///
/// Scopes: "Model", the bounding box; and for each named node with something to see in or below it its own box, in the node's frame.
///
/// `name` is the file's, with or without a folder: the model is called after it, and errors start with it. A file that is damaged, or that
/// needs what is not supported, gives an error. What can be left out (a texture that cannot be read, lines and points) is, and stands in the
/// model's diagnostics.
Result<Model> readGltf(std::string_view name, std::span<const std::byte> bytes, const GltfFileResolver& resolve);

/// The URIs that readGltf would ask its resolver for, each once, for hosts that must fetch them beforehand.
Result<std::vector<std::string>> externalGltfFiles(std::string_view name, std::span<const std::byte> bytes);

/// readGltf on a path, with the other files taken from beside it. Not for the page, which has no files.
Result<Model> readGltfFile(const std::string& path);

}  // namespace dimline
