#include "render/overlay_renderer.h"

#include "shaders.h"

namespace dimline {

OverlayRenderer::OverlayRenderer(const GlContext& context)
    : program_(context, {.label = "dimension lines", .vertex = {shaders::overlay_vert}, .fragment = {shaders::overlay_frag}}),
      buffer_(context),
      vertexArray_(context),
      indices_(context) {
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [](GLuint location, GLint size, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(location);
    const void* const pointer = bufferOffset(offset);
    if (type == GL_UNSIGNED_INT) {
      glVertexAttribIPointer(location, size, type, sizeof(OverlayShape), pointer);
    } else {
      glVertexAttribPointer(location, size, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, sizeof(OverlayShape), pointer);
    }
  };
  attribute(0, 2, GL_FLOAT, offsetof(OverlayShape, startPx));
  attribute(1, 2, GL_FLOAT, offsetof(OverlayShape, endPx));
  attribute(2, 4, GL_FLOAT, offsetof(OverlayShape, halfWidthPx));   // and softness, dash, hidden share
  attribute(3, 1, GL_UNSIGNED_INT, offsetof(OverlayShape, kind));
  attribute(5, 4, GL_FLOAT, offsetof(OverlayShape, lean));   // and depths
  attribute(4, 4, GL_UNSIGNED_BYTE, offsetof(OverlayShape, rgba));
  glBindVertexArray(0);
}

Status OverlayRenderer::prepare() {
  if (Status status = program_.status(); !status) return status;
  viewport_ = program_.uniform("viewport");
  program_.bindSampler("depths", 0);
  glUniform1f(program_.uniform("hiderReach"), static_cast<float>(kHiderReachPx));
  return okStatus();
}

void OverlayRenderer::draw(std::span<const OverlayShape> shapes, GLuint depths, double widthPx, double heightPx, double devicePixelRatio) {
  if (shapes.empty()) return;
  corners_.clear();
  for (const OverlayShape& shape : shapes) corners_.insert(corners_.end(), 4, shape);
  const std::size_t bytes = corners_.size() * sizeof(OverlayShape);
  if (bytes > capacity_) {
    capacity_ = bytes * 2;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), corners_.data());

  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depths);
  program_.use();
  glUniform3f(viewport_, static_cast<float>(widthPx), static_cast<float>(heightPx), static_cast<float>(devicePixelRatio));
  glBindVertexArray(vertexArray_.id());
  indices_.bind(shapes.size());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(shapes.size() * 6), GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
}

}  // namespace dimline
