#pragma once

#include <array>
#include <optional>

#include "core/result.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "math/camera.h"
#include "render/edge_renderer.h"
#include "render/frame_block.h"
#include "render/picture_target.h"
#include "render/sky_light.h"
#include "render/sun_shadow.h"
#include "render/theme.h"

namespace dimline {

/// How much a picture may cost. The host measures and decides.
enum class RenderQuality : std::uint8_t {
  kFull,     ///< multisampled, wide shadow filter
  kReduced   ///< for software rasterizers and weak machines while something moves
};

/// Draws a scene in sun and sky light on a calm ground, into a PictureTarget.
class SceneRenderer {
 public:
  explicit SceneRenderer(const GlContext& context);
  /// To be called once before draw(): waits for the compiler.
  Status prepare();

  /// The scene has changed: its edges are found and shaders for its materials are on their way; its light will be worked out anew by the next draw().
  void sceneChanged(const Scene& source, const GpuScene& scene);

  /// Fills the bound target. `devicePixelRatio`: of the target.
  Status draw(const GpuScene& scene, const View& view, const Theme& theme, RenderQuality quality, LightDetail light, bool ground,
              const PictureTarget& target, double devicePixelRatio);

 private:
  /// The shaders of one pattern: plain, and with an image.
  struct SurfacePrograms {
    std::array<Program, 2> variants;
    std::array<bool, 2> ready{};
  };
  /// Starts the compiler for what the scene's materials need and is not there yet. All are started before the first is waited for: drivers compile several
  /// at a time.
  void startSurfaces(const GpuScene& scene);
  Status finishSurfaces(const GpuScene& scene);
  /// Shadow and sky light; nothing to do when the present ones are as fine as `wanted`.
  void updateLight(const GpuScene& scene, LightDetail wanted);
  void fillFrameBlock(const GpuScene& scene, const View& view, const Theme& theme, RenderQuality quality, bool ground,
                      const PictureTarget& target, double devicePixelRatio);

  static constexpr std::size_t kPatterns = 11;

  const GlContext* context_;
  FrameBlock frame_;
  Buffer frameBuffer_;
  VertexArray noVertices_;
  SunShadow shadow_;
  SkyLight sky_;
  EdgeRenderer edges_;
  bool shadowStale_ = true;
  std::optional<LightDetail> lightDetail_;   ///< that of the present scene; nothing: not worked out yet
  Program backdrop_, depth_, groundLine_;
  std::array<SurfacePrograms, kPatterns> surfaces_;   ///< by pattern
};

}  // namespace dimline
