#pragma once

#include <memory>

#include "core/result.h"
#include "math/camera.h"
#include "model/scene.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Distance fields for one scene, from the producer that was asked for.
class FieldMeasurer {
public:
  virtual ~FieldMeasurer() = default;
  virtual Status measure(const View& view, DistanceFields& fields) = 0;

  static std::unique_ptr<FieldMeasurer> onCpu(const Scene& scene);
  /// An error where there is no OpenGL ES 3, with what to install; what else to do depends on who asked.
  static Result<std::unique_ptr<FieldMeasurer>> onGpu(const Scene& scene);
};

}  // namespace dimline
