#include "render/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "shaders.h"

namespace dimline {

namespace {

/// Direction to the sun: from the front left, so that the opening view (from the front right) has a sunlit front and a side in shade.
constexpr double kSunAzimuthRad = -0.72;   // from the front (+z) towards the right (+x)
constexpr double kSunElevationRad = 0.78;

/// The ground has faded away at this many diagonals of the model from its middle.
constexpr double kGroundRadius = 2.2;

/// FrameBlock::detail of a full and of a reduced picture.
constexpr int kShadowLookUpsReduced = 3;
constexpr int kNoiseLayers = 2;

/// Texels of the shadow map over which its edge is softened, to all sides.
constexpr double kShadowSoftness = 2.1;

/// Texture units.
enum Unit : int { kUnitMaterials = 0, kUnitShadow = 1, kUnitImage = 2, kUnitSky = 3 };

/// Which of a pattern's shaders draws a group.
std::size_t variantOf(const GpuScene::Group& group) {
  return group.image >= 0 ? 1 : 0;
}

/// CSS pixels that a metre has on screen where the box is nearest to the viewer.
double mostPxPerM(const Bounds& bounds, const View& view) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) least = std::min(least, view.metresPerPixelAt(bounds.corner(i)));
  return 1.0 / least;
}

Vec3 towardsSun() {
  return {std::sin(kSunAzimuthRad) * std::cos(kSunElevationRad), std::sin(kSunElevationRad),
          std::cos(kSunAzimuthRad) * std::cos(kSunElevationRad)};
}

}  // namespace

glm::vec4 eyeOf(const View& view) {
  return view.orthographic() ? glm::vec4(glm::vec3(-view.forward()), 0.0F) : glm::vec4(glm::vec3(view.camera().eye), 1.0F);
}

SceneRenderer::SceneRenderer(const GlContext& context)
    : context_(&context),
      frameBuffer_(context),
      noVertices_(context),
      shadow_(context),
      sky_(context),
      edges_(context),
      backdrop_(context, {.label = "backdrop",
                          .vertex = {shaders::frame_glsl, shaders::backdrop_vert},
                          .fragment = {shaders::frame_glsl, shaders::tone_glsl, shaders::backdrop_frag}}),
      depth_(context, {.label = "depth", .vertex = {shaders::instance_glsl, shaders::frame_glsl, shaders::depth_vert}, .fragment = {shaders::depth_frag}}),
      groundLine_(context, {.label = "ground line",
                            .vertex = {shaders::frame_glsl, shaders::ground_line_vert},
                            .fragment = {shaders::frame_glsl, shaders::ground_line_frag}}) {}

Status SceneRenderer::prepare() {
  for (Program* program : {&backdrop_, &depth_, &groundLine_}) {
    if (Status status = program->status(); !status) return status;
  }
  if (Status status = edges_.status(); !status) return status;
  if (Status status = shadow_.prepare(); !status) return status;
  return sky_.prepare();
}

void SceneRenderer::sceneChanged(const Scene& source, const GpuScene& scene) {
  startSurfaces(scene);
  edges_.setScene(source);
  shadowStale_ = true;
  lightDetail_.reset();
}

void SceneRenderer::startSurfaces(const GpuScene& scene) {
  for (const GpuScene::Group& group : scene.groups()) {
    Program& program = surfaces_[static_cast<std::size_t>(group.pattern)].variants[variantOf(group)];
    if (program) continue;
    const std::string defines = "#define PATTERN " + std::to_string(static_cast<int>(group.pattern)) + "\n" +
                                (group.image >= 0 ? "#define HAS_IMAGE 1\n" : "");
    program = Program(*context_, {.label = "surfaces",
                                  .vertex = {shaders::instance_glsl, shaders::frame_glsl, shaders::surface_vert},
                                  .fragment = {shaders::frame_glsl, shaders::tone_glsl, shaders::light_glsl, shaders::patterns_glsl,
                                               shaders::surface_frag},
                                  .defines = defines});
  }
}

Status SceneRenderer::finishSurfaces(const GpuScene& scene) {
  for (const GpuScene::Group& group : scene.groups()) {
    SurfacePrograms& programs = surfaces_[static_cast<std::size_t>(group.pattern)];
    const std::size_t variant = variantOf(group);
    if (programs.ready[variant]) continue;
    Program& program = programs.variants[variant];
    if (Status status = program.status(); !status) return status;
    program.bindSampler("materials", kUnitMaterials);
    program.bindSampler("shadowMap", kUnitShadow);
    program.bindSampler("skyVolume", kUnitSky);
    program.bindSampler("image", kUnitImage);
    programs.ready[variant] = true;
  }
  return okStatus();
}

void SceneRenderer::updateLight(const GpuScene& scene, LightDetail wanted) {
  if (shadowStale_) shadow_.render(scene, towardsSun());
  shadowStale_ = false;
  if (lightDetail_ && *lightDetail_ >= wanted) return;
  lightDetail_ = sky_.bake(scene, shadow_, towardsSun(), wanted);
}

void SceneRenderer::fillFrameBlock(const GpuScene& scene, const View& view, const Theme& theme, RenderQuality quality, bool ground,
                                   const PictureTarget& target, double devicePixelRatio) {
  frame_.worldToClip = glm::mat4(view.viewProjection());
  frame_.clipToWorld = glm::mat4(glm::inverse(view.viewProjection()));
  frame_.worldToShadow = glm::mat4(shadow_.view().worldToUnit);
  frame_.eye = eyeOf(view);
  frame_.sun = glm::vec4(glm::vec3(towardsSun()), shadow_.view().texelM);
  frame_.viewport = {target.width(), target.height(), devicePixelRatio, 0.5 * view.projectionMatrix()[1][1] * target.height()};
  const Bounds& bounds = scene.bounds();
  const Vec3 center = bounds.empty() ? Vec3(0.0) : bounds.center();
  const double height = bounds.empty() ? 0.0 : bounds.min.y;
  frame_.ground = {center.x, center.z, height, std::max(bounds.diagonal(), 1e-3) * kGroundRadius};
  // Seen from under it the ground would hide the model: it fades away before the eye gets there.
  const Vec3 toViewer = -view.directionTo({center.x, height, center.z});
  const double shown = ground && !bounds.empty() ? 1.0 : 0.0;
  const double opacity = shown * std::clamp((toViewer.y - 0.005) / 0.06, 0.0, 1.0);
  const double lineOpacity = shown * std::clamp(1.0 - std::abs(toViewer.y) / 0.05, 0.0, 1.0);
  frame_.groundFade = {opacity, lineOpacity, 0, 0};
  const Vec3 across(view.right().x, 0, view.right().z);
  frame_.groundAcross = glm::vec4(glm::vec3(across * (0.75 * bounds.diagonal())), 0.0F);
  frame_.groundSquare = sky_.groundSquare();
  frame_.skyOrigin = glm::vec4(sky_.volumeOrigin(), sky_.voxelM());
  frame_.skyScale = glm::vec4(sky_.volumeScale(), 0.0F);
  frame_.backgroundTop = theme.backgroundTop;
  frame_.backgroundBottom = theme.backgroundBottom;
  const bool full = quality == RenderQuality::kFull;
  const int lookUps = full ? kShadowLookUps : kShadowLookUpsReduced;
  frame_.detail = glm::ivec4(lookUps, full ? kNoiseLayers : 0, 0, 0);
  for (int i = 0; i < lookUps; ++i) {
    // A Vogel spiral.
    const double angle = 2.399963229728653 * i;
    const double r = kShadowSoftness * std::sqrt((i + 0.5) / lookUps);
    frame_.shadowDisc[static_cast<std::size_t>(i)] = glm::vec4(r * std::cos(angle), r * std::sin(angle), 0, 0);
  }
  glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.id());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(frame_), &frame_, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlockBinding, frameBuffer_.id());
}

Status SceneRenderer::draw(const GpuScene& scene, const View& view, const Theme& theme, RenderQuality quality, LightDetail light, bool ground,
                           const PictureTarget& target, double devicePixelRatio) {
  if (Status status = finishSurfaces(scene); !status) return status;
  updateLight(scene, light);
  fillFrameBlock(scene, view, theme, quality, ground, target, devicePixelRatio);
  target.bind();
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  const auto bind = [](Unit unit, GLuint texture, GLenum kind = GL_TEXTURE_2D) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(kind, texture);
  };

  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(noVertices_.id());
  bind(kUnitMaterials, sky_.groundTexture());   // the backdrop's only one
  backdrop_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (frame_.groundFade.y > 0.0F) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    groundLine_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
  }

  bind(kUnitMaterials, scene.materialTexture());
  bind(kUnitShadow, shadow_.texture());
  bind(kUnitSky, sky_.volumeTexture(), GL_TEXTURE_3D);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  if (quality == RenderQuality::kReduced) {
    // On a software rasterizer shading costs more than drawing twice.
    depth_.use();
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    scene.drawPositions();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  for (std::size_t i = 0; i < scene.groups().size(); ++i) {
    const GpuScene::Group& group = scene.groups()[i];
    if (group.image >= 0) bind(kUnitImage, scene.imageTexture(group.image));
    surfaces_[static_cast<std::size_t>(group.pattern)].variants[variantOf(group)].use();
    scene.drawGroup(i);
  }
  edges_.draw(mostPxPerM(scene.bounds(), view));
  glDisable(GL_DEPTH_TEST);
  glActiveTexture(GL_TEXTURE0);
  return okStatus();
}

}  // namespace dimline
