#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/gl_objects.h"

namespace dimline {

/// Bytes of an integer pixel that is read back, in the one format that every driver must offer: four 32-bit numbers.
inline constexpr std::size_t kIntegerPixelBytes = 16;

/// Pixels on their way from the GPU to the CPU, through a pixel-pack buffer with a fence behind it: nothing waits until somebody asks to.
/// One round: begin, read as often as wanted, end; then, when ready, copy.
class PixelReadback {
 public:
  PixelReadback() = default;
  explicit PixelReadback(const GlContext& context);
  PixelReadback(PixelReadback&& other) noexcept;
  PixelReadback& operator=(PixelReadback&& other) noexcept;
  ~PixelReadback();

  /// Makes room for `bytes` and binds the buffer as the target of reads.
  void begin(std::size_t bytes);
  /// Reads from the bound framebuffer, rows without padding, to `offset` in the buffer.
  void read(int x, int y, int width, int height, GLenum format, GLenum type, std::size_t offset);
  /// Sets the fence and unbinds the buffer.
  void end();

  [[nodiscard]] bool pending() const { return fence_ != nullptr; }
  /// Whether the pixels have arrived. Never waits.
  [[nodiscard]] bool ready();
  /// Takes pixels out of the buffer: at once when ready(), otherwise it waits for the GPU.
  void copy(std::size_t offset, std::span<std::uint8_t> pixels);
  /// Ends the round.
  void finish();

 private:
  const GlContext* context_ = nullptr;
  Buffer buffer_;
  std::size_t capacity_ = 0;
  GLsync fence_ = nullptr;
};

}  // namespace dimline
