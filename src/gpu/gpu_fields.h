#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/result.h"
#include "gpu/field_scan.h"
#include "gpu/flights.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "math/camera.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Who turns the mask into fields. On a GPU reading a few thousand numbers back is cheap; on a software rasterizer the mask is in the
/// CPU's memory anyway, and scanning it there is faster than drawing passes.
enum class FieldReduction : std::uint8_t { kOnGpu, kOnCpu };

/// Measures the four fields with the GPU (the paper's 4.1): the model is drawn as a mask at device pixels, the mask is
/// reduced to the first and last covered pixel of each row and column, and these are read back through a buffer and a fence. A pixel is
/// covered when a triangle, of either side, covers its centre; so a part thinner than a device pixel can be missed.
///
///     request(view)  ->  frames go by  ->  poll(fields)          in a page: never waits
///     request(view)  ->  finish(fields)                          tests, command line
///
/// Leaves framebuffer 0, no vertex array and its own viewport bound.
class GpuFields {
 public:
  /// An error when the driver does not take the shaders.
  static Result<GpuFields> make(const GlContext& context);

  /// Starts as kOnCpu on a software rasterizer, else as kOnGpu. Takes effect with the next request.
  void setReduction(FieldReduction reduction) { reduction_ = reduction; }
  [[nodiscard]] FieldReduction reduction() const { return reduction_; }

  /// Draws the mask of `scene` as `view` shows it and starts the way back. `devicePixelRatio` > 0: device pixels per CSS pixel; reduced
  /// where the driver's largest texture would not do. Returns the request's number, 1 and up, or 0 when kInFlight are under way already.
  std::uint64_t request(const GpuScene& scene, const View& view, double devicePixelRatio);

  /// The newest request that has arrived since the last call, as fields of its viewport's size rounded up. Older ones are dropped. Never waits.
  std::optional<std::uint64_t> poll(DistanceFields& fields);

  /// Waits for the newest request. Nothing when none is under way.
  std::optional<std::uint64_t> finish(DistanceFields& fields);

  /// Nobody waits for what is under way any more.
  void drop() { flights_.dropAll(); }

 private:
  struct MaskSent {
    FieldReduction reduction = FieldReduction::kOnCpu;
    int width = 0, height = 0;  ///< of the mask
    double widthPx = 0, heightPx = 0;
    int bytesPerPixel = 1;
  };

  explicit GpuFields(const GlContext& context);
  void resize(int width, int height);
  void drawMask(const GpuScene& scene, const View& view);
  /// Reduces the mask along one axis; returns the target that holds the extremes, bound for reading.
  const DrawnTexture& reduce(bool alongRows);
  std::optional<std::uint64_t> land(Flights<MaskSent>::Flight* flight, DistanceFields& fields);

  const GlContext* context_;
  FieldReduction reduction_;
  Program maskProgram_, firstStepProgram_, stepProgram_;
  GLint maskMatrix_ = -1, firstAxis_ = -1, stepAxis_ = -1;
  VertexArray noVertices_;
  DrawnTexture mask_;
  std::vector<DrawnTexture> rowSteps_, columnSteps_;
  Flights<MaskSent> flights_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint8_t> gray_;
  MaskExtremes extremes_;
};

}  // namespace dimline
