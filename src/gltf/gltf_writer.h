#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "model/scene.h"

namespace dimline {

/// A scene as a binary glTF 2.0 file (.glb), metres and y up as glTF has them. Not for the page, whose core goes without.
///
/// A mesh that stands in many places is written once; each place is a node below one that is named `title`. Corners that agree in position, normal
/// and texture coordinates share a vertex. Base colour, its texture (as PNG), roughness and doubleSided are kept; patterns are not, since they are the
/// shader's: a brick wall has the colour of its bricks. Scopes are not geometry and are left out.
///
/// The same scene gives the same bytes. An error when there is no triangle, or when the file would be larger than 4 GB, which no .glb can be.
Result<std::string> writeGlb(const Scene& scene, std::string_view title);

}  // namespace dimline
