#include "gpu/quad_indices.h"

#include <cstdint>
#include <vector>

namespace dimline {

void QuadIndices::bind(std::size_t quads) {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_.id());
  if (quads <= quads_) return;
  quads_ = quads + quads / 2;
  std::vector<std::uint32_t> indices;
  indices.reserve(quads_ * 6);
  for (std::size_t i = 0; i < quads_; ++i) {
    const auto first = static_cast<std::uint32_t>(i * 4);
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) indices.push_back(first + corner);
  }
  upload(buffer_, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(indices), GL_STATIC_DRAW);
}

}  // namespace dimline
