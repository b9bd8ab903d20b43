#pragma once

#include <cstdint>
#include <vector>

#include "silhouette/depth_buffer.h"

namespace dimline {

/// Which of a box's twelve edges are seen: those of which at least half of what is in the viewport is not behind the model, as a whole scope is judged; so a line that lies on one does not seem to
/// measure what is before it. Edge `number` along `axis` lies on the box's far side along axis + 1 when the number's lowest bit is set, and along axis + 2 when the next one is (axes counted
/// round): base lines of linear-contour have the same numbers (placement/base_lines.h).
class SeenEdges {
 public:
  static constexpr int kCount = 12;
  static constexpr int kPointsPerEdge = 8;

  /// From what a producer packs: a bit for each edge.
  explicit SeenEdges(std::uint32_t bits) : bits_(bits) {}

  [[nodiscard]] static constexpr std::uint32_t bit(int axis, int number) { return 1U << (4 * axis + number); }
  [[nodiscard]] static SeenEdges all() { return SeenEdges((1U << kCount) - 1); }
  [[nodiscard]] bool has(int axis, int number) const { return (bits_ & bit(axis, number)) != 0; }

 private:
  std::uint32_t bits_ = 0;
};

/// How much of each scope can be seen, for dropping the lines of features on the model's far side (algorithm 1, line 1).
/// One value a scope, in the scene's order: the share of the box's screen area (of kPlentySeenShare of the viewport, if that is less) where the box is not behind
/// the model, 0 (hidden, or out of view) to 1.
/// Two producers fill it, on the CPU and on the GPU; both count a scope's box as seen where it is nearer than the model, or no farther
/// behind its surface than kScopeSkinShare of the model's size (boxes mostly lie in the model's faces).
struct ScopeVisibility {
  std::vector<float> seenShare;
  std::vector<SeenEdges> seenEdges;   ///< of each scope too; empty: all are
};

/// What either producer counts of a scope's box, in samples of the model's depth.
struct ScopeSamples {
  std::uint32_t covered = 0;   ///< by the faces that look to the viewer, within the viewport
  std::uint32_t seen = 0;      ///< of those
  bool middleSeen = false;     ///< whether the box's middle is; it stands for a box between the samples
};

/// The share that follows, for a depth buffer of that many samples.
float seenShareOf(const ScopeSamples& samples, std::size_t viewportSamples);

/// Measures visibility on the CPU: the model into a depth buffer of at most kVisibilitySamples along its longer side, then every scope's box against it.
/// Cost grows with the triangles of the model.
class CpuVisibility {
 public:
  void measure(const Scene& scene, const View& view, ScopeVisibility& visibility);

 private:
  DepthBuffer depth_;
};

}  // namespace dimline
