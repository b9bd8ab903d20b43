#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "core/result.h"
#include "gpu/gl.h"
#include "gpu/gl_context.h"

namespace dimline {

/// A GL object that is deleted with its owner: move-only; empty by default. `Kind` says how the object is made and deleted.
template <typename Kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const GlContext& context) : context_(&context), id_(Kind::make()) {}
  GlObject(GlObject&& other) noexcept
      : context_(std::exchange(other.context_, nullptr)), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      reset();
      context_ = std::exchange(other.context_, nullptr);
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  ~GlObject() { reset(); }

  /// Deletes the object, or just forgets it when its context is lost.
  void reset() {
    if (id_ != 0 && !context_->lost()) Kind::destroy(id_);
    id_ = 0;
  }

  [[nodiscard]] GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  const GlContext* context_ = nullptr;
  GLuint id_ = 0;
};

struct BufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
  static GLuint make() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct RenderbufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct VertexArrayKind {
  static GLuint make() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct SamplerKind {
  static GLuint make() {
    GLuint id = 0;
    glGenSamplers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteSamplers(1, &id); }
};

using Buffer = GlObject<BufferKind>;
using Texture = GlObject<TextureKind>;
using Framebuffer = GlObject<FramebufferKind>;
using Renderbuffer = GlObject<RenderbufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using Sampler = GlObject<SamplerKind>;

/// Binds `buffer` to `target` and gives it new contents.
void upload(const Buffer& buffer, GLenum target, std::span<const std::byte> bytes, GLenum usage);
template <typename T>
void upload(const Buffer& buffer, GLenum target, std::span<const T> items, GLenum usage) {
  upload(buffer, target, std::as_bytes(items), usage);
}

/// How a texture is looked up.
enum class Sampling : std::uint8_t { kNearest, kLinear, kShadow };

/// A 2-D texture without contents, clamped at its edges. kShadow compares depths, filtered. With more than one level, sampling is
/// trilinear, and the levels are the caller's to fill.
Texture makeTexture2D(const GlContext& context, GLenum internalFormat, int width, int height, Sampling sampling, int levels = 1);

/// A framebuffer of those textures (0 for none), bound when it returns. That they can be drawn to is not checked, because that waits for everything the driver
/// has still to do; of the formats that OpenGL ES 3.0 calls renderable, one colour or one depth texture alone always can.
Framebuffer bindFramebufferOf(const GlContext& context, GLuint colorTexture, GLuint depthTexture);

/// The same, checked. An error names `label`.
Result<Framebuffer> makeFramebuffer(const GlContext& context, std::string_view label, GLuint colorTexture, GLuint depthTexture);

/// A texture of one level, and the framebuffer that draws to it.
struct DrawnTexture {
  Texture texture;
  Framebuffer framebuffer;
  int width = 0, height = 0;
};

/// One whose colours are looked up unfiltered, of a format that OpenGL ES 3.0 calls renderable. Its framebuffer is bound when it returns.
DrawnTexture makeDrawnTexture(const GlContext& context, GLenum colorFormat, int width, int height);

/// An error naming `label` unless the bound framebuffer can be drawn to.
Status checkFramebuffer(std::string_view label);

/// The byte offset of a vertex attribute as GL wants it.
inline const void* bufferOffset(std::size_t bytes) {
  const char* const base = nullptr;
  return base + bytes;
}

}  // namespace dimline
