#include "render/sun_shadow.h"

#include <glm/gtc/type_ptr.hpp>

#include "shaders.h"

namespace dimline {

namespace {

/// Texels along a side. A house of 15 m gets one texel per centimetre, which a filter of a few texels turns into a crisp but not hard edge.
constexpr int kMapSize = 2048;

}  // namespace

SunShadow::SunShadow(const GlContext& context)
    : context_(&context),
      program_(context, {.label = "shadow", .vertex = {shaders::instance_glsl, shaders::mask_vert}, .fragment = {shaders::depth_frag}}) {}

Status SunShadow::prepare() {
  if (Status status = program_.status(); !status) return status;
  matrix_ = program_.uniform("worldToClip");
  depth_ = makeTexture2D(*context_, GL_DEPTH_COMPONENT24, kMapSize, kMapSize, Sampling::kShadow);
  framebuffer_ = bindFramebufferOf(*context_, 0, depth_.id());
  return okStatus();
}

void SunShadow::render(const GpuScene& scene, const Vec3& towardsSun) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, kMapSize, kMapSize);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  if (scene.bounds().empty()) return;
  view_ = fitLightView(scene.bounds(), towardsSun, kMapSize);

  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  // Surfaces are pushed away from the sun by their slope, or they would shade themselves.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0F, 2.0F);
  program_.use();
  const glm::mat4 matrix(view_.worldToClip);
  glUniformMatrix4fv(matrix_, 1, GL_FALSE, glm::value_ptr(matrix));
  scene.drawPositions();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace dimline
