#pragma once

#include <array>
#include <vector>

#include "math/camera.h"
#include "model/model.h"
#include "placement/measured.h"
#include "placement/slip_planes.h"
#include "silhouette/slide.h"

namespace dimline {

/// The way without distance fields, for comparison: for every candidate each triangle of the model is looked at, as the
/// paper's version for the CPU does (its table 1, "CPU impl"). Finds the offsets of the same candidates: chain base
/// lines for chained parameters, base lines for the others, each plane, the object's too, and both ways on it. Nothing is
/// scored, labelled or kept apart.
class Straightforward {
public:
  Straightforward(const Model& model, const Scene& scene);

  /// The least offset (m, >= 0) at which a slid line has all that the model shows inside its wedge behind it; infinite
  /// when the model reaches the plane's horizon there.
  [[nodiscard]] double leastOffsetM(const Slide& slide, const View& view) const;

  /// One frame: leastOffsetM() of every candidate.
  struct Frame {
    std::size_t candidates = 0;
    double sumM = 0;  ///< of all finite offsets
  };
  Frame place(const View& view);

private:
  void placeLine(const BaseLine& line, Slip slip, bool chain, const View& view, Frame& frame);

  std::vector<Vec3> corners_;  ///< of the whole model, in the world
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Scope> scopes_;
  std::vector<Measured> measured_;  ///< with dimension lines
  std::vector<ObjectPlane> objectPlanes_;
  std::vector<ObjectPlaneUse> objectUses_;  ///< in the frame at hand
  double toleranceM_ = 0;
  std::vector<SlipPlane> planes_;
};

}  // namespace dimline
