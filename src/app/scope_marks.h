#pragma once

#include <vector>

#include "math/camera.h"
#include "render/overlay.h"

namespace dimline {

/// How the edges of a scope's box are marked in the picture.
struct ScopeMark {
  double skinM = 0;          ///< by so much they may lie behind a surface and still be seen: boxes lie in the faces that they belong to
  float opacity = 1.0F;
  bool shownHidden = true;   ///< what the model hides of them is faint, or else left out
};

/// Adds the twelve edges of a box, each once where the box is flat, but for those that reach behind the viewer.
void addEdges(const Obb& box, const View& view, const ScopeMark& mark, std::vector<OverlayEdge>& edges);

}  // namespace dimline
