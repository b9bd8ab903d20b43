#include "render/picture_target.h"

#include <algorithm>
#include <array>

namespace dimline {

Status PictureTarget::resize(int width, int height, int samples) {
  samples = std::min(samples, context_->maxSamples());
  if (width == width_ && height == height_ && samples == samples_) return okStatus();
  width_ = height_ = samples_ = 0;   // until all of it is there
  const bool multisampled = samples > 1;
  finished_.reset();
  samplesColor_.reset();
  samplesDepth_.reset();
  color_ = makeTexture2D(*context_, GL_RGBA8, width, height, Sampling::kLinear);
  // Depths are copied as they are, which takes the same format on both sides.
  depth_ = makeTexture2D(*context_, GL_DEPTH_COMPONENT24, width, height, Sampling::kNearest);
  if (multisampled) {
    const auto makeSamples = [&](GLenum format) {
      Renderbuffer made(*context_);
      glBindRenderbuffer(GL_RENDERBUFFER, made.id());
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
      return made;
    };
    samplesColor_ = makeSamples(GL_RGBA8);
    samplesDepth_ = makeSamples(GL_DEPTH_COMPONENT24);
    finished_ = bindFramebufferOf(*context_, color_.id(), depth_.id());
    drawn_ = Framebuffer(*context_);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samplesColor_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samplesDepth_.id());
  } else {
    drawn_ = bindFramebufferOf(*context_, color_.id(), depth_.id());
  }
  if (Status status = checkFramebuffer("picture"); !status) return status;
  width_ = width;
  height_ = height;
  samples_ = samples;
  return okStatus();
}

void PictureTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  glViewport(0, 0, width_, height_);
}

void PictureTarget::resolve() const {
  if (!finished_) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, finished_.id());
  // One by one: a driver that should refuse the depths, which some are particular about, still gives the picture.
  for (const GLbitfield buffer : {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT}) glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, buffer, GL_NEAREST);
  // Nobody will look at the samples again; tile-based GPUs then need not write them out.
  const std::array<GLenum, 2> all{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, all.size(), all.data());
}

void PictureTarget::show(GLuint framebuffer, int width, int height) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, finished_ ? finished_.id() : drawn_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  // Chromium clears a canvas lazily, at a frame's first draw or clear, and a blit is neither: without this the copy would be wiped by what is drawn next.
  glClear(GL_COLOR_BUFFER_BIT);
  const bool same = width == width_ && height == height_;
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace dimline
