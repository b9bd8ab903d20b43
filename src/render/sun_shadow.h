#pragma once

#include <glm/mat4x4.hpp>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"

namespace dimline {

/// What the sun sees: a depth map, drawn anew only when the model changes.
class SunShadow {
 public:
  explicit SunShadow(const GlContext& context);
  Status prepare();

  /// Draws the map for a scene lit from `towardsSun` (unit). Covers the scene's bounds.
  void render(const GpuScene& scene, const glm::dvec3& towardsSun);

  [[nodiscard]] GLuint texture() const { return depth_.id(); }
  /// World to the unit cube of the map: (u, v, depth).
  [[nodiscard]] const glm::mat4& worldToShadow() const { return worldToShadow_; }
  [[nodiscard]] float texelM() const { return texelM_; }

 private:
  const GlContext* context_;
  Program program_;
  GLint matrix_ = -1;
  int size_ = 2048;
  Texture depth_;
  Framebuffer framebuffer_;
  glm::mat4 worldToShadow_{1.0F};
  float texelM_ = 1.0F;
};

}  // namespace dimline
