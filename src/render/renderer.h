#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/result.h"
#include "gpu/gpu_fields.h"
#include "gpu/gpu_scene.h"
#include "gpu/gpu_visibility.h"
#include "math/camera.h"
#include "render/overlay.h"
#include "render/overlay_renderer.h"
#include "render/scene_renderer.h"

namespace dimline {

/// What a frame is drawn into, and how.
struct RenderOptions {
  GLuint framebuffer = 0;            ///< what to draw into; 0 is the canvas. Needs colour only; it may have alpha or not, but no samples
  int widthPx = 1, heightPx = 1;     ///< its size in device pixels
  double devicePixelRatio = 1.0;     ///< device pixels per CSS pixel; the view's size is in CSS pixels
  RenderQuality quality = RenderQuality::kFull;
  LightDetail light = LightDetail::kFine;   ///< of a full picture; a reduced one stretches what there is
  bool ground = true;
  Theme theme;
};

/// Everything that is drawn with GL in one context, and the fields that GL measures. Needs its context current whenever it is called,
/// abandon() excepted.
///
/// A frame is drawn on demand. When nothing but the lines changed since the last one, the picture under them is used again; a full one also where
/// a reduced one would do.
class Renderer {
 public:
  /// Starts the compiler for all shaders that a picture needs, and waits for nothing.
  Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer() = default;

  /// Replaces the model. Its light is worked out by the next draw().
  void setScene(const Scene& scene);

  /// Draws a frame: the model as `view` sees it, and the overlay over it. Fills all of the framebuffer with opaque pixels. A size below one pixel draws nothing.
  /// An error that a person can read when the driver lacks something.
  Status draw(const View& view, const Overlay& overlay, const RenderOptions& options);

  /// What measures fields of the model in this context; its shaders are compiled at the first call. Null when the driver does not take them.
  [[nodiscard]] GpuFields* fields() { return fields_.get(context_); }
  [[nodiscard]] bool fieldsRefused() const { return fields_.refused(); }
  /// Nobody waits for fields that are under way any more.
  void dropFields();
  [[nodiscard]] const GpuScene& scene() const { return scene_; }

  /// How much of each scope of `scene`, the one of setScene(), is seen, measured in this context; as GpuVisibility describes it. 0 also when the driver does
  /// not take its shaders, which are compiled at the first call.
  std::uint64_t requestVisibility(const Scene& scene, const View& view);
  std::optional<std::uint64_t> pollVisibility(ScopeVisibility& visibility);
  /// Nobody waits for what is under way of it any more.
  void dropVisibility();

  [[nodiscard]] const GlContext& context() const { return context_; }

  /// The context is lost: no GL call is made from here on. Destroy the renderer; make another when there is a context again, and give it the scene.
  void abandon() { context_.markLost(); }

 private:
  /// Waits for the compiler, before the first picture.
  Status prepare();

  /// What is made when it is first asked for; once only, should the driver not take its shaders.
  template <typename Measurer>
  class OnDemand {
   public:
    Measurer* get(const GlContext& context) {
      if (!made_ && !refused_) {
        Result<Measurer> made = Measurer::make(context);
        if (made) made_.emplace(std::move(made).value());
        refused_ = !made_;
      }
      return ifMade();
    }
    [[nodiscard]] Measurer* ifMade() { return made_ ? &*made_ : nullptr; }
    [[nodiscard]] bool refused() const { return refused_; }

   private:
    std::optional<Measurer> made_;
    bool refused_ = false;
  };

  /// What the finished picture shows.
  struct Shown {
    glm::mat4 viewProjection{1.0F};
    int widthPx = 0, heightPx = 0;
    double devicePixelRatio = 0;
    RenderQuality quality = RenderQuality::kFull;
    LightDetail light = LightDetail::kFine;
    bool ground = true;
    Theme theme;
    bool operator==(const Shown&) const = default;
  };

  [[nodiscard]] bool shows(const Shown& wanted) const;

  GlContext context_;   // first: outlives everything made with it
  GpuScene scene_;
  OnDemand<GpuFields> fields_;
  OnDemand<GpuVisibility> visibility_;
  bool visibilitySceneStale_ = true;
  SceneRenderer sceneRenderer_;
  OverlayRenderer overlayRenderer_;
  PictureTarget target_;
  bool prepared_ = false;
  std::optional<Shown> shown_;
  std::vector<OverlayShape> shapes_;
};

}  // namespace dimline
