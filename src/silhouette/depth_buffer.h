#pragma once

#include <array>
#include <utility>
#include <vector>

#include "math/camera.h"
#include "model/scene.h"

namespace dimline {

/// The nearest depth at each pixel's centre, rendered on the CPU. For questions about what hides what where no GL is at hand; its
/// resolution is its own, not the viewport's.
class DepthBuffer {
 public:
  /// A place in the buffer: samples (x right, y down) and normalised device depth.
  struct Corner {
    double x = 0, y = 0, depth = 0;
    int column = 0, row = 0;   ///< the first ones whose centres do not come before it; those of the buffer's end where there are none
  };

  /// Samples along x and y of a buffer over the view's whole viewport, never finer than its pixels.
  static std::pair<int, int> sizeFor(const View& view, int maxSide);

  /// A buffer over the view's whole viewport, at most `maxSide` samples along its longer side. Empty: everything at the far end.
  void reset(const View& view, int maxSide);

  /// Draws every triangle of a scene, cut at the near plane; both faces count.
  void draw(const Scene& scene);
  void draw(const std::array<Vec3, 3>& triangleWorld);

  /// How much of a triangle is nearer than what has been drawn: samples covered, and samples of those that are not behind it. `towardsViewerM` moves
  /// the triangle that far towards the viewer first, so that a surface does not hide itself.
  struct Seen {
    int covered = 0;
    int seen = 0;
  };
  [[nodiscard]] Seen test(const std::array<Vec3, 3>& triangleWorld, double towardsViewerM) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Normalised device depth, -1 near to 1 far; 1 where nothing has been drawn.
  [[nodiscard]] float at(int x, int y) const {
    return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

 private:
  struct Vertex {
    Corner corner;          ///< meaningless unless inFront
    bool inFront = false;   ///< of the near plane, or on it
  };

  [[nodiscard]] Corner cornerAt(const Vec3& world) const;
  void keepNearest(int x, int y, double depth);
  template <typename PerSample>
  void rasterise(const std::array<Vec3, 3>& triangleWorld, PerSample perSample) const;

  View view_;
  int width_ = 0, height_ = 0;
  std::vector<float> depth_;
  std::vector<Vertex> vertices_;   ///< of the instance that is drawn
};

}  // namespace dimline
