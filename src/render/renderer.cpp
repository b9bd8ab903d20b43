#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dimline {

namespace {

/// Samples a pixel of the full picture. Four is what every OpenGL ES 3 driver has.
constexpr int kSamples = 4;

/// A reduced picture has at most so many pixels and is stretched to its framebuffer: lines stay sharp, and a software rasterizer keeps up.
constexpr double kReducedPixels = 600e3;

}  // namespace

Renderer::Renderer() : scene_(context_), sceneRenderer_(context_), overlayRenderer_(context_), target_(context_) {
  glFlush();   // a browser hands commands on when it has many of them; the compiler shall begin now
}

void Renderer::setScene(const Scene& scene) {
  shown_.reset();
  scene_.upload(scene);
  visibilitySceneStale_ = true;
  sceneRenderer_.sceneChanged(scene, scene_);
  glFlush();
}

std::uint64_t Renderer::requestVisibility(const Scene& scene, const View& view) {
  GpuVisibility* const measurer = visibility_.get(context_);
  if (measurer == nullptr) return 0;
  if (visibilitySceneStale_) measurer->setScene(scene);
  visibilitySceneStale_ = false;
  return measurer->request(scene_, view);
}

std::optional<std::uint64_t> Renderer::pollVisibility(ScopeVisibility& visibility) {
  GpuVisibility* const measurer = visibility_.ifMade();
  return measurer != nullptr && !visibilitySceneStale_ ? measurer->poll(visibility) : std::nullopt;
}

void Renderer::dropFields() {
  if (GpuFields* const measurer = fields_.ifMade()) measurer->drop();
}

void Renderer::dropVisibility() {
  if (GpuVisibility* const measurer = visibility_.ifMade()) measurer->drop();
}

bool Renderer::shows(const Shown& wanted) const {
  if (!shown_) return false;
  // A full picture that is there already is no worse than a reduced one.
  Shown present = *shown_;
  if (present.quality == RenderQuality::kFull) present.quality = wanted.quality;
  return present == wanted;
}

Status Renderer::prepare() {
  if (prepared_) return okStatus();
  if (Status status = sceneRenderer_.prepare(); !status) return status;
  if (Status status = overlayRenderer_.prepare(); !status) return status;
  prepared_ = true;
  return okStatus();
}

Status Renderer::draw(const View& view, const Overlay& overlay, const RenderOptions& options) {
  if (options.widthPx < 1 || options.heightPx < 1) return okStatus();
  if (Status status = prepare(); !status) return status;
  const Shown wanted{glm::mat4(view.viewProjection()), options.widthPx, options.heightPx, options.devicePixelRatio,
                     options.quality, options.light, options.ground, options.theme};
  if (!shows(wanted)) {
    shown_.reset();
    const bool full = options.quality == RenderQuality::kFull;
    const double area = static_cast<double>(options.widthPx) * options.heightPx;
    const double scale = full ? 1.0 : std::min(1.0, std::sqrt(kReducedPixels / area));
    const auto scaled = [&](int px) { return std::max(1, static_cast<int>(std::lround(px * scale))); };
    if (Status status = target_.resize(scaled(options.widthPx), scaled(options.heightPx), full ? kSamples : 1); !status) return status;
    if (Status status = sceneRenderer_.draw(scene_, view, options.theme, options.quality, full ? options.light : LightDetail::kStretched,
                                                 options.ground, target_, options.devicePixelRatio * scale);
        !status) {
      return status;
    }
    target_.resolve();
    shown_ = wanted;
  }
  target_.show(options.framebuffer, options.widthPx, options.heightPx);
  glViewport(0, 0, options.widthPx, options.heightPx);
  buildOverlay(overlay, options.theme, shapes_);
  overlayRenderer_.draw(shapes_, target_.depthTexture(), view.widthPx(), view.heightPx(), options.devicePixelRatio);
  return okStatus();
}

}  // namespace dimline
