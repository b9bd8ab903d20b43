#pragma once

#include <vector>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/program.h"
#include "render/edge_lines.h"

namespace dimline {

/// Inks the model's edges over its surfaces: thin anti-aliased lines, hidden where the model hides them, contours stronger than creases.
class EdgeRenderer {
 public:
  explicit EdgeRenderer(const GlContext& context);
  Status prepare();

  void setScene(const Scene& scene);

  /// Draws into the bound framebuffer, against its depth. The frame's uniform block must be bound.
  void draw() const;

 private:
  Program program_;
  Buffer buffer_;
  VertexArray vertexArray_;
  std::vector<EdgeLine> edges_;
};

}  // namespace dimline
