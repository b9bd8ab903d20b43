#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/result.h"
#include "gpu/flights.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "math/camera.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

/// Measures with the GPU how much of each scope is seen: the model's depths are drawn at the resolution that the CPU's way has too, and
/// one pass looks every scope's box up in them, sample by sample; so there is no query a scope. What is read back, through a buffer and a fence, is one pixel a
/// scope. It counts what CpuVisibility counts; of a box larger than 64 samples along a side it looks at every second sample, or every third ..., along that side.
///
/// Calls as GpuFields has them. Leaves framebuffer 0, no vertex array and its own viewport bound.
class GpuVisibility {
 public:
  /// An error when the driver does not take the shaders.
  static Result<GpuVisibility> make(const GlContext& context);

  /// Replaces the scopes. What is under way for others is dropped.
  void setScene(const Scene& scene);

  /// Draws what `view` sees of `scene` and starts the way back. Returns the request's number, 1 and up, or 0 when kInFlight are
  /// under way already, when there is no scope, or when the driver refuses the depth buffer.
  std::uint64_t request(const GpuScene& scene, const View& view);

  /// The newest request that has arrived since the last call; older ones are dropped. Never waits.
  std::optional<std::uint64_t> poll(ScopeVisibility& visibility);

  /// Waits for the newest request. Nothing when none is under way.
  std::optional<std::uint64_t> finish(ScopeVisibility& visibility);

  /// Nobody waits for what is under way any more.
  void drop() { flights_.dropAll(); }

 private:
  struct Counted {
    std::size_t viewportSamples = 0;
  };

  explicit GpuVisibility(const GlContext& context);
  Status resizeDepth(const View& view);
  void drawDepth(const GpuScene& scene, const View& view);
  void countSamples(const View& view);
  std::optional<std::uint64_t> land(Flights<Counted>::Flight* flight, ScopeVisibility& visibility);

  const GlContext* context_;
  Program depthProgram_, countProgram_, sumProgram_;
  GLint depthMatrix_ = -1, countMatrix_ = -1, eye_ = -1, forward_ = -1, skin_ = -1, scopes_ = -1;
  VertexArray noVertices_;
  DrawnTexture depth_;
  Texture boxes_;
  DrawnTexture counts_, sums_;
  int scopeCount_ = 0;
  int rows_ = 0;   ///< scopes that stand over each other in counts_ and sums_
  double skinM_ = 0;
  Flights<Counted> flights_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace dimline
