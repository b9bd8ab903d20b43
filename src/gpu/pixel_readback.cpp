#include "gpu/pixel_readback.h"

#include <utility>

#include "gpu/platform.h"

namespace dimline {

PixelReadback::PixelReadback(const GlContext& context) : context_(&context), buffer_(context) {}

PixelReadback::PixelReadback(PixelReadback&& other) noexcept
    : context_(other.context_),
      buffer_(std::move(other.buffer_)),
      capacity_(std::exchange(other.capacity_, 0)),
      fence_(std::exchange(other.fence_, nullptr)) {}

PixelReadback& PixelReadback::operator=(PixelReadback&& other) noexcept {
  if (this != &other) {
    finish();
    context_ = other.context_;
    buffer_ = std::move(other.buffer_);
    capacity_ = std::exchange(other.capacity_, 0);
    fence_ = std::exchange(other.fence_, nullptr);
  }
  return *this;
}

PixelReadback::~PixelReadback() { finish(); }

void PixelReadback::begin(std::size_t bytes) {
  finish();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  if (bytes > capacity_) {
    // Chromium warns at each reuse of a STREAM_READ buffer, and not of this.
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_COPY);
    capacity_ = bytes;
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void PixelReadback::read(int x, int y, int width, int height, GLenum format, GLenum type, std::size_t offset) {
  glReadPixels(x, y, width, height, format, type, const_cast<void*>(bufferOffset(offset)));
}

void PixelReadback::end() {
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glFlush();
}

bool PixelReadback::ready() {
  if (fence_ == nullptr) return false;
  const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

void PixelReadback::copy(std::size_t offset, std::span<std::uint8_t> pixels) {
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  readBuffer(GL_PIXEL_PACK_BUFFER, offset, pixels);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void PixelReadback::finish() {
  if (fence_ != nullptr && !context_->lost()) glDeleteSync(fence_);
  fence_ = nullptr;
}

}  // namespace dimline
