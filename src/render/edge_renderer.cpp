#include "render/edge_renderer.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>

#include "gpu/packing.h"
#include "render/frame_block.h"
#include "shaders.h"

namespace dimline {

namespace {

/// px. The shader has faded out every edge whose narrower face is no wider than this on screen.
constexpr double kLeastWidthPx = 0.6;

/// Edges are sorted by classes of width, four an octave: a float's bits down to the second of its fraction. Sorting more finely would take
/// longer than all the rest of a model's change. The first class is that of round surfaces' edges, which never fade.
constexpr int kBitsWithinClass = 21;
constexpr std::uint32_t kWidest = 0x7F800000U >> kBitsWithinClass;
constexpr std::size_t kClasses = kWidest + 2;

std::size_t classOf(float widthM) {
  if (widthM < 0.0F) return 0;
  return 1 + kWidest - std::min(std::bit_cast<std::uint32_t>(widthM) >> kBitsWithinClass, kWidest);
}

}  // namespace

EdgeRenderer::EdgeRenderer(const GlContext& context)
    : program_(context, {.label = "edges",
                         .vertex = {shaders::frame_glsl, shaders::edge_vert},
                         .fragment = {shaders::edge_frag}}),
      buffer_(context),
      vertexArray_(context),
      indices_(context),
      endOfClass_(kClasses, 0) {
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [](GLuint location, GLint size, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, type, type == GL_FLOAT ? GL_FALSE : GL_TRUE, sizeof(Corner), bufferOffset(offset));
  };
  attribute(0, 3, GL_FLOAT, offsetof(Corner, a));
  attribute(1, 3, GL_FLOAT, offsetof(Corner, b));
  attribute(2, 4, GL_INT_2_10_10_10_REV, offsetof(Corner, normalA));
  attribute(3, 4, GL_INT_2_10_10_10_REV, offsetof(Corner, normalB));
  attribute(4, 1, GL_FLOAT, offsetof(Corner, widthM));
  glBindVertexArray(0);
}

void EdgeRenderer::setScene(const Scene& scene) {
  findEdgeLines(scene, edges_);
  endOfClass_.assign(kClasses, 0);
  for (const EdgeLine& edge : edges_) ++endOfClass_[classOf(edge.widthM)];
  std::partial_sum(endOfClass_.begin(), endOfClass_.end(), endOfClass_.begin());
  corners_.resize(edges_.size() * 4);
  // From the back, each edge takes the last free place of its class; what is left then is where the class begins.
  std::vector<std::size_t> place = endOfClass_;
  for (auto edge = edges_.rbegin(); edge != edges_.rend(); ++edge) {
    const Corner corner{edge->a, edge->b, packNormal(edge->normalA), packNormal(edge->normalB), edge->widthM};
    std::fill_n(corners_.begin() + static_cast<std::ptrdiff_t>(--place[classOf(edge->widthM)] * 4), 4, corner);
  }
  upload(buffer_, GL_ARRAY_BUFFER, std::span<const Corner>(corners_), GL_DYNAMIC_DRAW);
}

void EdgeRenderer::draw(double mostPxPerM) {
  const auto leastWidth = static_cast<float>(kLeastWidthPx / mostPxPerM);
  const std::size_t count = endOfClass_[classOf(leastWidth)];
  if (count == 0) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  glBindVertexArray(vertexArray_.id());
  indices_.bind(count);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count * 6), GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace dimline
