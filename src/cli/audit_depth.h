#pragma once

#include <array>
#include <vector>

#include "math/camera.h"
#include "model/scene.h"

namespace dimline {

/// The audit's own way to say whether a feature is in plain view: the model drawn into a depth picture of half the
/// viewport's resolution, and boxes and points held against it. Shares nothing with what the placer goes by.
class DepthPicture {
public:
  /// Draws every triangle of the scene, both sides, cut at the near plane.
  void draw(const Scene& scene, const View& view);

  /// Of the samples at which a box's faces that look at the viewer would be seen if they stood alone: how many there
  /// are, and on how many the model is not more than `skinM` nearer.
  struct Seen {
    int samples = 0;
    int seen = 0;
  };
  [[nodiscard]] Seen test(const Obb& box, double skinM) const;

  /// The share of points along a segment at which the model is not more than `skinM` nearer. Points out of the picture
  /// do not count as seen.
  [[nodiscard]] double seenShare(const Segment& segment, double skinM) const;

private:
  struct Corner {
    double x, y;      ///< samples
    double nearness;  ///< linear on screen, larger is nearer
  };
  [[nodiscard]] double nearness(double depthM) const;
  template <typename Use>
  void walk(const std::array<Vec3, 3>& triangle, Use use) const;

  View view_;
  int width_ = 0, height_ = 0;
  std::vector<double> nearest_;  ///< -infinity where there is nothing
};

}  // namespace dimline
