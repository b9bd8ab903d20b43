#pragma once

#include <array>
#include <vector>

#include "math/camera.h"
#include "model/scene.h"
#include "silhouette/coverage_mask.h"

namespace dimline {

/// The audit's own picture of the model: the depth of what is seen at the middle of each pixel. Says which pixels the
/// model covers, and whether a box or a point is in plain view. Shares nothing with what the placer goes by.
class DepthPicture {
public:
  /// Draws every triangle of the scene, both sides, cut at the near plane.
  void draw(const Scene& scene, const View& view);

  /// The pixels that the model covers: as coverageMask() has them, but for single pixels whose centre lies on a border.
  [[nodiscard]] CoverageMask mask() const;

  /// Of the pixels at which a box's faces that look at the viewer would be seen if they stood alone: how many there
  /// are, and on how many the model is not more than `skinM` nearer.
  struct Seen {
    int pixels = 0;
    int seen = 0;
  };
  [[nodiscard]] Seen test(const Obb& box, double skinM) const;

  /// The share of points along a segment at which the model is not more than `skinM` nearer. Points out of the picture
  /// do not count as seen.
  [[nodiscard]] double seenShare(const Segment& segment, double skinM) const;

private:
  struct Corner {
    double x, y;      ///< px
    double nearness;  ///< linear on screen, larger is nearer
  };
  [[nodiscard]] double nearness(double depthM) const;
  template <typename Use>
  void walk(const std::array<Vec3, 3>& triangle, Use use) const;

  View view_;
  int width_ = 0, height_ = 0;
  std::vector<float> nearest_;  ///< -infinity where there is nothing
};

}  // namespace dimline
