#pragma once

#include "core/result.h"
#include "gpu/gl_objects.h"

namespace dimline {

/// The buffers that a picture is drawn in before it goes to the screen: colour and depth, multisampled or not. The finished picture stays with its depths,
/// so that it can be shown again under changed dimension lines.
class PictureTarget {
 public:
  explicit PictureTarget(const GlContext& context) : context_(&context) {}

  /// Makes the buffers of that size and sample count (1: none) where they are not there yet.
  Status resize(int width, int height, int samples);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Binds it for drawing, whole.
  void bind() const;
  /// Resolves the samples, once all is drawn.
  void resolve() const;
  /// The finished picture's depths, one sample a pixel.
  [[nodiscard]] GLuint depthTexture() const { return depth_.id(); }

  /// Copies the finished picture to a framebuffer of that size, smoothly if the sizes differ. Leaves that framebuffer bound.
  void show(GLuint framebuffer, int width, int height) const;

 private:
  const GlContext* context_;
  int width_ = 0, height_ = 0, samples_ = 0;
  Renderbuffer samplesColor_, samplesDepth_;
  Texture color_, depth_;
  Framebuffer drawn_, finished_;   ///< the same when there are no samples: then only drawn_ is set
};

}  // namespace dimline
