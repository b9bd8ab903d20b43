#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene.h"

namespace dimline {

/// An edge of the model as it may be inked: a crease, seen whenever one of its faces is, or a round surface's edge, seen only where the
/// surface turns away from the viewer.
struct EdgeLine {
  glm::vec3 a{0.0F}, b{0.0F};          ///< ends in the world (m)
  glm::vec3 normalA{0.0F}, normalB{0.0F};   ///< of the faces on either side; opposite ones for the border of an open surface
  /// Width (m) of the narrower face beside it, for fading out what would run together on screen. Negative for a round surface's edge.
  float widthM = 0.0F;
};

/// All edges of a scene worth inking, those of instances included. Edges between triangles in one plane are left out. Replaces the contents
/// of `edges`.
void findEdgeLines(const Scene& scene, std::vector<EdgeLine>& edges);

}  // namespace dimline
