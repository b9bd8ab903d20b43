#include "render/sky_light.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "render/light_view.h"
#include "shaders.h"

namespace dimline {

namespace {

/// The atlas: tiles of 8 x 4 maps.
constexpr int kTileSize = 128;
constexpr int kTilesAcross = 8;
constexpr int kTilesDown = 4;

/// Directions, points along the longest side of the box, and texels of the ground's two textures.
struct Fineness {
  std::size_t directions;
  int volume;
  int groundSky;
  int ground;
};
constexpr Fineness fineness(LightDetail detail) {
  // The directions cost the most: a map of all of the model each.
  return detail == LightDetail::kFine ? Fineness{32, 48, 128, 512} : Fineness{detail == LightDetail::kRough ? 6U : 16U, 28, 64, 256};
}

/// Of the ground's map of the sky; it is blurred by them.
constexpr int kGroundSkyLevels = 4;

/// Binding point of the maps' uniform block: the one that needs no telling.
constexpr GLuint kMapsBinding = 0;

/// How wide the sun's disc is, as the sine of its radius. Several times the real one: shadows on the ground soften visibly with their distance.
constexpr double kSunRadius = 0.022F;

/// Directions spread evenly over the upper half of the sphere (a Fibonacci lattice).
Vec3 skyDirection(std::size_t i, std::size_t count) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double y = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
  const double r = std::sqrt(1.0 - y * y);
  const double angle = kGoldenAngle * static_cast<double>(i);
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// Whether the light of one box, stretched, can stand in for that of the other for a while. Nothing is like a box that is not there yet.
bool alike(const Vec3& size, const Vec3& other) {
  constexpr double kMostStretch = 1.5;
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > other[axis] * kMostStretch || other[axis] > size[axis] * kMostStretch) return false;
  }
  return other != Vec3(0.0);
}

glm::vec4 row(const Mat4& m, int i) { return glm::vec4(glm::dvec4(m[0][i], m[1][i], m[2][i], m[3][i])); }

}  // namespace

SkyLight::SkyLight(const GlContext& context)
    : context_(&context),
      depthProgram_(context, {.label = "sky maps", .vertex = {shaders::instance_glsl, shaders::mask_vert}, .fragment = {shaders::depth_frag}}),
      volumeProgram_(context, {.label = "sky volume",
                               .vertex = {shaders::fullscreen_vert},
                               .fragment = {shaders::sky_maps_glsl, shaders::sky_volume_frag}}),
      groundSkyProgram_(context, {.label = "sky on the ground",
                                  .vertex = {shaders::fullscreen_vert},
                                  .fragment = {shaders::sky_maps_glsl, shaders::ground_sky_frag}}),
      groundProgram_(context, {.label = "light on the ground", .vertex = {shaders::fullscreen_vert}, .fragment = {shaders::ground_light_frag}}),
      mapsBuffer_(context),
      noVertices_(context),
      plainDepths_(context) {}

Status SkyLight::prepare() {
  for (Program* program : {&depthProgram_, &volumeProgram_, &groundSkyProgram_, &groundProgram_}) {
    if (Status status = program->status(); !status) return status;
  }
  depthMatrix_ = depthProgram_.uniform("worldToClip");
  volumeOriginUniform_ = volumeProgram_.uniform("firstPoint");
  volumeSlice_ = volumeProgram_.uniform("spacing");
  groundSkySquare_ = groundSkyProgram_.uniform("square");
  groundSquareUniform_ = groundProgram_.uniform("square");
  groundToShadow_ = groundProgram_.uniform("worldToShadow");
  groundSun_ = groundProgram_.uniform("sunDisc");
  groundSharpest_ = groundProgram_.uniform("sharpest");
  groundProgram_.bindSampler("shadowMap", 0);
  groundProgram_.bindSampler("shadowDepths", 1);
  groundProgram_.bindSampler("groundSky", 2);
  glSamplerParameteri(plainDepths_.id(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
  glSamplerParameteri(plainDepths_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glSamplerParameteri(plainDepths_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glSamplerParameteri(plainDepths_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(plainDepths_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  atlas_ = makeTexture2D(*context_, GL_DEPTH_COMPONENT16, kTileSize * kTilesAcross, kTileSize * kTilesDown, Sampling::kShadow);
  atlasFramebuffer_ = bindFramebufferOf(*context_, 0, atlas_.id());
  return okStatus();
}

LightDetail SkyLight::bake(const GpuScene& scene, const SunShadow& shadow, const Vec3& towardsSun, LightDetail detail) {
  const Bounds& bounds = scene.bounds();
  if (bounds.empty()) return detail;
  if (detail == LightDetail::kStretched && !alike(bounds.size(), skyOf_)) detail = LightDetail::kRough;
  const bool stretch = detail == LightDetail::kStretched;
  if (!stretch) {
    drawAtlas(scene, detail);
    skyOf_ = bounds.size();
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(noVertices_.id());
  placeGround(bounds, towardsSun);
  if (!stretch) {
    glBindBuffer(GL_UNIFORM_BUFFER, mapsBuffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(maps_), &maps_, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kMapsBinding, mapsBuffer_.id());
    bakeVolume(bounds, detail);
    bakeGroundSky(detail);
  }
  placeVolume(bounds);
  bakeGround(shadow, detail);
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
  return detail;
}

void SkyLight::drawAtlas(const GpuScene& scene, LightDetail detail) {
  const std::size_t count = fineness(detail).directions;
  glBindFramebuffer(GL_FRAMEBUFFER, atlasFramebuffer_.id());
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  depthProgram_.use();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 direction = skyDirection(i, count);
    const LightView view = fitLightView(scene.bounds(), direction, kTileSize);
    maps_.u[i] = row(view.worldToUnit, 0);
    maps_.v[i] = row(view.worldToUnit, 1);
    maps_.depth[i] = row(view.worldToUnit, 2);
    maps_.direction[i] = glm::vec4(glm::vec3(direction), 0.0F);
    const auto column = static_cast<int>(i) % kTilesAcross;
    const auto line = static_cast<int>(i) / kTilesAcross;
    glViewport(column * kTileSize, line * kTileSize, kTileSize, kTileSize);
    const glm::mat4 matrix(view.worldToClip);
    glUniformMatrix4fv(depthMatrix_, 1, GL_FALSE, glm::value_ptr(matrix));
    scene.drawPositions();
  }
  maps_.count = glm::ivec4(static_cast<int>(count), 0, 0, 0);
}

void SkyLight::bakeVolume(const Bounds& bounds, LightDetail detail) {
  const Vec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z, 1e-6});
  // Surfaces look up a point one spacing outside themselves, so the grid reaches that far beyond the box.
  const double spacing = longest / (fineness(detail).volume - 3);
  const glm::ivec3 points = glm::clamp(glm::ivec3(glm::ceil(size / spacing)) + 3, glm::ivec3(4), glm::ivec3(fineness(detail).volume));
  if (points != volumeSize_) {
    volume_ = Texture(*context_);
    volumeSize_ = points;
    glBindTexture(GL_TEXTURE_3D, volume_.id());
    glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, points.x, points.y, points.z);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
      glTexParameteri(GL_TEXTURE_3D, side, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  const Vec3 first = bounds.center() - Vec3(points - 1) * (spacing * 0.5);
  voxelM_ = static_cast<float>(spacing);

  Framebuffer framebuffer(*context_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, 0, points.x, points.y);
  volumeProgram_.use();
  glUniform1f(volumeSlice_, voxelM_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, atlas_.id());
  for (int z = 0; z < points.z; ++z) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, volume_.id(), 0, z);
    const glm::vec3 point(first + Vec3(0, 0, z * spacing));
    glUniform3fv(volumeOriginUniform_, 1, glm::value_ptr(point));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void SkyLight::placeVolume(const Bounds& bounds) {
  // The grid that was worked out for a box of size skyOf_, laid over this one.
  const Vec3 grid = Vec3(volumeSize_) * static_cast<double>(voxelM_);
  const Vec3 size = grid * glm::max(bounds.size(), Vec3(1e-9)) / glm::max(skyOf_, Vec3(1e-9));
  volumeOrigin_ = glm::vec3(bounds.center() - size * 0.5);
  volumeScale_ = glm::vec3(1.0 / size);
}

void SkyLight::placeGround(const Bounds& bounds, const Vec3& towardsSun) {
  // All the sun's shadow, and what the model hides of the sky for as far as one would notice.
  const double height = bounds.size().y;
  Bounds area;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = bounds.corner(i);
    area.add(corner - Vec3(0.7 * height, 0, 0.7 * height));
    area.add(corner + Vec3(0.7 * height, 0, 0.7 * height));
    area.add(corner - towardsSun * ((corner.y - bounds.min.y) / towardsSun.y));
  }
  const double half = std::max({area.size().x, area.size().z, 1e-6}) * 0.55;
  groundSquare_ = glm::vec4(area.center().x, area.center().z, half, bounds.min.y);
}

void SkyLight::bakeGroundSky(LightDetail detail) {
  const Fineness fine = fineness(detail);
  if (groundSkySize_ != fine.groundSky) {
    groundSky_ = makeTexture2D(*context_, GL_R8, fine.groundSky, fine.groundSky, Sampling::kLinear, kGroundSkyLevels);
    groundSkySize_ = fine.groundSky;
  }
  const Framebuffer sky = bindFramebufferOf(*context_, groundSky_.id(), 0);
  glViewport(0, 0, fine.groundSky, fine.groundSky);
  groundSkyProgram_.use();
  glUniform4fv(groundSkySquare_, 1, glm::value_ptr(groundSquare_));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, atlas_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glBindTexture(GL_TEXTURE_2D, groundSky_.id());
  glGenerateMipmap(GL_TEXTURE_2D);
}

void SkyLight::bakeGround(const SunShadow& shadow, LightDetail detail) {
  const Fineness fine = fineness(detail);
  if (groundSize_ != fine.ground) {
    ground_ = makeTexture2D(*context_, GL_RG8, fine.ground, fine.ground, Sampling::kLinear);
    groundSize_ = fine.ground;
  }
  const Framebuffer ground = bindFramebufferOf(*context_, ground_.id(), 0);
  glViewport(0, 0, fine.ground, fine.ground);
  groundProgram_.use();
  glUniform4fv(groundSquareUniform_, 1, glm::value_ptr(groundSquare_));
  const glm::mat4 toShadow(shadow.view().worldToUnit);
  glUniformMatrix4fv(groundToShadow_, 1, GL_FALSE, glm::value_ptr(toShadow));
  const LightView& sun = shadow.view();
  glUniform3f(groundSun_, static_cast<float>(kSunRadius * sun.unitsPerM.x), static_cast<float>(kSunRadius * sun.unitsPerM.y),
              static_cast<float>(sun.depthRangeM));
  const double texelM = 2.0 * static_cast<double>(groundSquare_.z) / fine.ground;
  glUniform2f(groundSharpest_, static_cast<float>(0.7 * texelM * sun.unitsPerM.x), static_cast<float>(0.7 * texelM * sun.unitsPerM.y));
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, shadow.texture());
  glBindSampler(1, plainDepths_.id());
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_2D, groundSky_.id());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, shadow.texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindSampler(1, 0);
}

}  // namespace dimline
