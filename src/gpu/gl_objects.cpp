#include "gpu/gl_objects.h"

#include <string>

namespace dimline {

void upload(const Buffer& buffer, GLenum target, std::span<const std::byte> bytes, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), usage);
}

Texture makeTexture2D(const GlContext& context, GLenum internalFormat, int width, int height, Sampling sampling, int levels) {
  Texture texture(context);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexStorage2D(GL_TEXTURE_2D, levels, internalFormat, width, height);
  const GLint filter = sampling == Sampling::kNearest ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (sampling == Sampling::kShadow) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  return texture;
}

Status checkFramebuffer(std::string_view label) {
  const GLenum state = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (state == GL_FRAMEBUFFER_COMPLETE) return okStatus();
  const char* why = "for a reason the driver does not name";
  switch (state) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: why = "because an attachment has a format that cannot be drawn to"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT: why = "because it has no attachment"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS: why = "because its attachments differ in size"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE: why = "because its attachments differ in samples"; break;
    case GL_FRAMEBUFFER_UNSUPPORTED: why = "because the driver does not support this mix of formats"; break;
    default: break;
  }
  return Error{"The graphics driver cannot draw to the " + std::string(label) + " buffer, " + why + "."};
}

Framebuffer bindFramebufferOf(const GlContext& context, GLuint colorTexture, GLuint depthTexture) {
  Framebuffer framebuffer(context);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  if (colorTexture != 0) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colorTexture, 0);
  } else {
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
  }
  if (depthTexture != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depthTexture, 0);
  return framebuffer;
}

DrawnTexture makeDrawnTexture(const GlContext& context, GLenum colorFormat, int width, int height) {
  DrawnTexture made;
  made.width = width;
  made.height = height;
  made.texture = makeTexture2D(context, colorFormat, width, height, Sampling::kNearest);
  made.framebuffer = bindFramebufferOf(context, made.texture.id(), 0);
  return made;
}

Result<Framebuffer> makeFramebuffer(const GlContext& context, std::string_view label, GLuint colorTexture, GLuint depthTexture) {
  Framebuffer framebuffer = bindFramebufferOf(context, colorTexture, depthTexture);
  if (Status status = checkFramebuffer(label); !status) return status.error();
  return framebuffer;
}

}  // namespace dimline
