#include "app/scope_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/motion.h"
#include "core/constants.h"

namespace dimline {

namespace {

/// Samples along the longer side of the depth buffer: a few pixels each, which is as exact as a faint line needs to be.
constexpr int kDepthSamples = 512;

/// ms. While a drag changes the model, what hides an edge changes by little from frame to frame.
constexpr double kDepthIntervalMs = 150.0;

/// px. An edge is looked at in steps of this length, at most so many.
constexpr double kPiecePx = 5.0;
constexpr int kMostPieces = 160;

/// Share of the model's size by which an edge may lie behind a surface and still be seen: boxes lie in the faces that they belong to. Less than for a whole
/// scope (kScopeSkinShare), since an edge a brick behind a wall would shine through.
constexpr double kEdgeSkinShare = 0.3 * kScopeSkinShare;

}  // namespace

void ScopeMarks::begin(const Scene& scene, const View& view, double nowMs) {
  if (depth_.width() > 0 && sameView(view_, view) && (!stale_ || nowMs - drawnMs_ < kDepthIntervalMs)) return;
  drawnMs_ = nowMs;
  stale_ = false;
  view_ = view;
  skinM_ = kEdgeSkinShare * scene.bounds.diagonal();
  depth_.reset(view, kDepthSamples);
  depth_.draw(scene);
}

/// Whether a point is not behind the farthest of the four samples around it: between samples the benefit of the doubt.
bool ScopeMarks::seen(const Vec3& point) const {
  const Vec3 nearer = point - view_.directionTo(point) * skinM_;
  const Vec4 clip = view_.viewProjection() * Vec4(nearer, 1.0);
  if (!(clip.w > 0)) return false;
  const Vec3 ndc = Vec3(clip) / clip.w;
  if (!(std::abs(ndc.x) < 1 && std::abs(ndc.y) < 1)) return true;
  const int x = static_cast<int>(std::floor((ndc.x * 0.5 + 0.5) * depth_.width() - 0.5));
  const int y = static_cast<int>(std::floor((0.5 - ndc.y * 0.5) * depth_.height() - 0.5));
  float farthest = -1;
  for (const int dy : {0, 1}) {
    for (const int dx : {0, 1}) {
      farthest = std::max(farthest, depth_.at(std::clamp(x + dx, 0, depth_.width() - 1), std::clamp(y + dy, 0, depth_.height() - 1)));
    }
  }
  return ndc.z <= static_cast<double>(farthest);
}

void ScopeMarks::add(const Obb& box, float opacity, bool hiddenToo, std::vector<OverlayEdge>& edges) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.size[axis] > 0)) continue;
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from(0.0);
      from[first] = corner & 1;
      from[second] = corner >> 1;
      // A box without thickness has each of its edges once.
      if ((from[first] > 0 && !(box.size[first] > 0)) || (from[second] > 0 && !(box.size[second] > 0))) continue;
      Vec3 to = from;
      to[axis] = 1;
      const Segment edge{box.at(from), box.at(to)};
      if (view_.inFrontOfNear(edge.start) && view_.inFrontOfNear(edge.end)) addEdge(edge, opacity, hiddenToo, edges);
    }
  }
}

void ScopeMarks::addEdge(const Segment& edge, float opacity, bool hiddenToo, std::vector<OverlayEdge>& edges) const {
  const Segment2 screen = view_.toScreen(edge);
  const double pieces = std::clamp(std::ceil(screen.length() / kPiecePx), 1.0, static_cast<double>(kMostPieces));
  const int count = static_cast<int>(pieces);
  const auto at = [&](double piece) { return edge.start + (edge.end - edge.start) * (piece / pieces); };
  std::array<bool, kMostPieces> shown{};
  for (int i = 0; i < count; ++i) shown[static_cast<std::size_t>(i)] = seen(at(i + 0.5));
  // One piece by itself that differs from both neighbours is the samples' doing.
  for (int i = 1; i + 1 < count; ++i) {
    const auto n = static_cast<std::size_t>(i);
    if (shown[n - 1] == shown[n + 1]) shown[n] = shown[n - 1];
  }
  for (int i = 0; i < count;) {
    int end = i + 1;
    while (end < count && shown[static_cast<std::size_t>(end)] == shown[static_cast<std::size_t>(i)]) ++end;
    const bool hidden = !shown[static_cast<std::size_t>(i)];
    if (!hidden || hiddenToo) edges.push_back({{view_.toScreen(at(i)), view_.toScreen(at(end))}, hidden, opacity});
    i = end;
  }
}

}  // namespace dimline
