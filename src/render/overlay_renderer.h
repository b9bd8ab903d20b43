#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/program.h"
#include "gpu/quad_indices.h"
#include "render/overlay.h"

namespace dimline {

/// Draws overlay shapes over whatever the bound framebuffer holds, each anti-aliased analytically: no multisampling is needed.
class OverlayRenderer {
 public:
  explicit OverlayRenderer(const GlContext& context);
  /// An error when the driver does not take the shaders. Call once, before draw().
  Status prepare();

  /// Into the bound framebuffer and viewport, which show widthPx by heightPx CSS pixels. `depths`: the depths of the picture below, of any size.
  void draw(std::span<const OverlayShape> shapes, GLuint depths, double widthPx, double heightPx, double devicePixelRatio);

 private:
  Program program_;
  GLint viewport_ = -1;
  Buffer buffer_;
  std::size_t capacity_ = 0;
  VertexArray vertexArray_;
  QuadIndices indices_;
  std::vector<OverlayShape> corners_;   ///< each shape four times
};

}  // namespace dimline
