#pragma once

#include <cstdint>
#include <vector>

#include "silhouette/depth_buffer.h"

namespace dimline {

/// How much of each scope can be seen, for dropping the lines of features on the model's far side (algorithm 1, line 1).
/// One value a scope, in the scene's order: the share of the box's screen area (of kPlentySeenShare of the viewport, if that is less) where the box is not behind
/// the model, 0 (hidden, or out of view) to 1.
/// Two producers fill it, on the CPU and on the GPU; both count a scope's box as seen where it is nearer than the model, or no farther
/// behind its surface than kScopeSkinShare of the model's size (boxes mostly lie in the model's faces).
struct ScopeVisibility {
  std::vector<float> seenShare;
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
