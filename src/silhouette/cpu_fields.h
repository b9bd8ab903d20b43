#pragma once

#include <memory>

#include "math/camera.h"
#include "model/scene.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Measures the four fields on the CPU: vertices are projected, edges between a front and a
/// back face (and borders) are scanned into row and column extremes. No fill: a 1-D field only wants extremes. Where
/// the model leaves the viewport or passes the near plane, the faces that cross are cut there, so that a field is 0
/// wherever the silhouette touches its edge. Exact in real-valued screen space: each strip has the extreme of the
/// silhouette over the whole strip, so a part thinner than a pixel is seen too. Cost grows with vertices and
/// silhouette edges, not with the viewport's area.
class CpuFields {
public:
  CpuFields();
  ~CpuFields();
  CpuFields(CpuFields&&) noexcept;
  CpuFields& operator=(CpuFields&&) noexcept;

  /// Prepares a scene: edges and their faces, per mesh. Copies what it needs.
  void setScene(const Scene& scene);

  /// Measures what `view` shows into `fields`, which is reset to the viewport's size rounded up; trees are built.
  /// Allocates nothing once it has seen this scene and size.
  void produce(const View& view, DistanceFields& fields);

private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace dimline
