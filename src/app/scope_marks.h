#pragma once

#include <vector>

#include "model/scene.h"
#include "render/overlay.h"
#include "silhouette/depth_buffer.h"

namespace dimline {

/// The edges of scopes' boxes as they are marked in the picture: plain where they are seen, faint where the model hides them.
class ScopeMarks {
public:
  void sceneChanged() { stale_ = true; }
  /// Whether what was added last went by the depth of an older scene.
  [[nodiscard]] bool behind() const { return stale_; }

  /// To be called before add(). Draws the model's depth when it is not that of this scene and view any more: some milliseconds, so that for a scene that
  /// changes in every frame it is drawn now and then only. `nowMs`: of any steady clock.
  void begin(const Scene& scene, const View& view, double nowMs);

  /// Adds the twelve edges of a box, in pieces that are seen or hidden; without those that are hidden unless `hiddenToo`.
  void add(const Obb& box, float opacity, bool hiddenToo, std::vector<OverlayEdge>& edges) const;

private:
  [[nodiscard]] bool seen(const Vec3& point) const;
  void addEdge(const Segment& edge, float opacity, bool hiddenToo, std::vector<OverlayEdge>& edges) const;

  DepthBuffer depth_;
  View view_;
  double skinM_ = 0;
  bool stale_ = true;
  double drawnMs_ = 0;
};

}  // namespace dimline
