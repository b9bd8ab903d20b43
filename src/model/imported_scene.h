#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "math/types.h"
#include "model/model.h"
#include "model/scene.h"

namespace dimline {

/// What a file of another program shows, apart from how that file says it: checked, and fit to be stretched.
struct ImportedScene {
  /// A mesh put into the world, in whatever way: mirrored and sheared too.
  struct Placed {
    std::uint32_t mesh = 0;
    Mat4 world{1.0};
  };
  /// Placed meshes that belong together under a name, and the frame that they have in common.
  struct NamedPart {
    std::string name;
    Mat4 world{1.0};
    std::uint32_t firstPlaced = 0, endPlaced = 0;
  };

  std::string name;  ///< the file's, with or without a folder
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Placed> placed;
  std::vector<NamedPart> parts;
  Bounds bounds;                         ///< of all that is placed; not empty
  std::vector<std::string> diagnostics;  ///< what of the file had to be left out
};

/// The scene as a model that can be stretched, called after its file.
///
/// Parameters: Width, Height and Depth of the bounding box, in metres, at first the file's; each stretches the whole along its axis, away from
/// the left, lower and back side, which stay. An axis in which the model has no extent has no parameter.
///
/// Scopes: "Model", the bounding box; and for each named part its own box, in the part's frame.
Result<Model> stretchedModel(ImportedScene scene);

/// The scene as bytes, to be taken from one WebAssembly module into another of the same build: files are read in a module of their own, which
/// pages fetch only when a file is opened.
std::vector<std::byte> bytesOf(const ImportedScene& scene);

/// The scene out of bytesOf(). An error when they are cut off or of another version, or when the scene refers to what it does not hold.
Result<ImportedScene> importedSceneFrom(std::span<const std::byte> bytes);

}  // namespace dimline
