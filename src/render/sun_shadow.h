#pragma once

#include <glm/mat4x4.hpp>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "render/light_view.h"

namespace dimline {

/// What the sun sees: a depth map, drawn anew only when the model changes.
class SunShadow {
 public:
  explicit SunShadow(const GlContext& context);
  Status prepare();

  /// Draws the map, covering the scene's bounds, for a scene lit from `towardsSun` (unit).
  void render(const GpuScene& scene, const Vec3& towardsSun);

  /// Depths, compared when looked up.
  [[nodiscard]] GLuint texture() const { return depth_.id(); }
  [[nodiscard]] const LightView& view() const { return view_; }

 private:
  const GlContext* context_;
  Program program_;
  GLint matrix_ = -1;
  Texture depth_;
  Framebuffer framebuffer_;
  LightView view_;
};

}  // namespace dimline
