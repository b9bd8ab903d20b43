#pragma once

#include <vector>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/program.h"
#include "gpu/quad_indices.h"
#include "render/edge_lines.h"

namespace dimline {

/// Inks the model's edges over its surfaces: thin anti-aliased lines, hidden where the model hides them, contours stronger than creases.
class EdgeRenderer {
 public:
  explicit EdgeRenderer(const GlContext& context);
  /// Waits for the compiler.
  Status status() { return program_.status(); }

  void setScene(const Scene& scene);

  /// Draws into the bound framebuffer, against its depth. The frame's uniform block must be bound. `mostPxPerM`: CSS pixels that a metre has on
  /// screen where the model is nearest; edges that must be too fine to be seen are left out by it.
  void draw(double mostPxPerM);

 private:
  /// An edge as the shader wants it, once for each of four corners.
  struct Corner {
    glm::vec3 a, b;
    std::uint32_t normalA, normalB;   ///< signed, 10 bits an axis
    float widthM;
  };

  Program program_;
  Buffer buffer_;
  VertexArray vertexArray_;
  QuadIndices indices_;
  std::vector<EdgeLine> edges_;
  std::vector<Corner> corners_;               ///< four an edge, the widest first, those of round surfaces before all
  std::vector<std::size_t> endOfClass_;       ///< how many edges are in a class of width or in those before it
};

}  // namespace dimline
