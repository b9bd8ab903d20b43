#include "render/edge_renderer.h"

#include <cstddef>

#include "render/frame_block.h"
#include "shaders.h"

namespace dimline {

EdgeRenderer::EdgeRenderer(const GlContext& context)
    : program_(context, {.label = "edges",
                         .vertex = {shaders::frame_glsl, shaders::edge_vert},
                         .fragment = {shaders::edge_frag}}),
      buffer_(context),
      vertexArray_(context) {
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [](GLuint location, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribDivisor(location, 1);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(EdgeLine), bufferOffset(offset));
  };
  attribute(0, 3, offsetof(EdgeLine, a));
  attribute(1, 3, offsetof(EdgeLine, b));
  attribute(2, 3, offsetof(EdgeLine, normalA));
  attribute(3, 3, offsetof(EdgeLine, normalB));
  attribute(4, 1, offsetof(EdgeLine, widthM));
  glBindVertexArray(0);
}

Status EdgeRenderer::prepare() {
  if (Status status = program_.status(); !status) return status;
  program_.bindBlock("Frame", kFrameBlockBinding);
  return okStatus();
}

void EdgeRenderer::setScene(const Scene& scene) {
  findEdgeLines(scene, edges_);
  upload(buffer_, GL_ARRAY_BUFFER, std::span<const EdgeLine>(edges_), GL_DYNAMIC_DRAW);
}

void EdgeRenderer::draw() const {
  if (edges_.empty()) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  glBindVertexArray(vertexArray_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(edges_.size()));
  glBindVertexArray(0);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace dimline
