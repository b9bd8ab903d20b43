#include "render/edge_renderer.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "gpu/packing.h"
#include "render/frame_block.h"
#include "shaders.h"

namespace dimline {

namespace {

/// px. The shader has faded out every edge whose narrower face is no wider than this on screen.
constexpr double kLeastWidthPx = 0.6;

/// What edges are sorted by: the width on which fading depends.
float rank(const EdgeLine& edge) { return edge.widthM < 0.0F ? std::numeric_limits<float>::infinity() : edge.widthM; }

}  // namespace

EdgeRenderer::EdgeRenderer(const GlContext& context)
    : program_(context, {.label = "edges",
                         .vertex = {shaders::frame_glsl, shaders::edge_vert},
                         .fragment = {shaders::edge_frag}}),
      buffer_(context),
      vertexArray_(context),
      indices_(context) {
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

Status EdgeRenderer::prepare() {
  if (Status status = program_.status(); !status) return status;
  program_.bindBlock("Frame", kFrameBlockBinding);
  return okStatus();
}

void EdgeRenderer::setScene(const Scene& scene) {
  findEdgeLines(scene, edges_);
  std::stable_sort(edges_.begin(), edges_.end(), [](const EdgeLine& a, const EdgeLine& b) { return rank(a) > rank(b); });
  corners_.clear();
  for (const EdgeLine& edge : edges_) {
    corners_.insert(corners_.end(), 4, {edge.a, edge.b, packNormal(edge.normalA), packNormal(edge.normalB), edge.widthM});
  }
  upload(buffer_, GL_ARRAY_BUFFER, std::span<const Corner>(corners_), GL_DYNAMIC_DRAW);
}

void EdgeRenderer::draw(double mostPxPerM) {
  const auto leastWidth = static_cast<float>(kLeastWidthPx / mostPxPerM);
  const auto tooFine = std::partition_point(edges_.begin(), edges_.end(), [&](const EdgeLine& e) { return rank(e) > leastWidth; });
  const auto count = static_cast<std::size_t>(tooFine - edges_.begin());
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
