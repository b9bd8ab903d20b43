#pragma once

#include <cstddef>

#include "gpu/gl_objects.h"

namespace dimline {

/// An index buffer that makes two triangles of every four vertices: (0, 1, 2) and (2, 1, 3), and so on. Shapes are laid out as four vertices each
/// rather than as instances, because software rasterizers treat every instance as a draw call of its own. A shader tells the four corners apart by
/// gl_VertexID & 3.
class QuadIndices {
 public:
  explicit QuadIndices(const GlContext& context) : buffer_(context) {}

  /// Binds the buffer, for the vertex array that is bound too, and makes sure that it reaches `quads`.
  void bind(std::size_t quads);

 private:
  Buffer buffer_;
  std::size_t quads_ = 0;
};

}  // namespace dimline
