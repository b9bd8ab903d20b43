#include "render/sun_shadow.h"

#include <algorithm>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "shaders.h"

namespace dimline {

SunShadow::SunShadow(const GlContext& context)
    : context_(&context),
      program_(context, {.label = "shadow", .vertex = {shaders::instance_glsl, shaders::mask_vert}, .fragment = {shaders::depth_frag}}) {}

Status SunShadow::prepare() {
  if (Status status = program_.status(); !status) return status;
  matrix_ = program_.uniform("worldToClip");
  depth_ = makeTexture2D(*context_, GL_DEPTH_COMPONENT24, size_, size_, Sampling::kShadow);
  Result<Framebuffer> framebuffer = makeFramebuffer(*context_, "shadow", 0, depth_.id());
  if (!framebuffer) return framebuffer.error();
  framebuffer_ = std::move(framebuffer).value();
  return okStatus();
}

void SunShadow::render(const GpuScene& scene, const glm::dvec3& towardsSun) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, size_, size_);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  const Bounds& bounds = scene.bounds();
  if (bounds.empty()) return;

  const glm::dvec3 center = bounds.center();
  const glm::dmat4 view = glm::lookAtRH(center + towardsSun, center, glm::dvec3(0, 1, 0));
  Bounds seen;
  for (int i = 0; i < 8; ++i) seen.add(Vec3(view * Vec4(bounds.corner(i), 1.0)));
  // A border of a few texels stays empty, so that filters which look past the edge find no shadow there.
  const Vec3 margin = seen.size() * (4.0 / size_) + 1e-4;
  seen.add(seen.min - margin);
  seen.add(seen.max + margin);
  const glm::dmat4 projection = glm::orthoRH_NO(seen.min.x, seen.max.x, seen.min.y, seen.max.y, -seen.max.z, -seen.min.z);
  const glm::dmat4 toUnit = glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
  worldToShadow_ = glm::mat4(toUnit * projection * view);
  texelM_ = static_cast<float>(std::max(seen.size().x, seen.size().y) / size_);

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  // Surfaces are pushed away from the sun by their slope, or they would shade themselves.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0F, 2.0F);
  program_.use();
  const glm::mat4 matrix(projection * view);
  glUniformMatrix4fv(matrix_, 1, GL_FALSE, glm::value_ptr(matrix));
  scene.drawPositions();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace dimline
