#include "silhouette/scope_visibility.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace dimline {

namespace {

/// The six faces of a box by corner number (bit 0: x, bit 1: y, bit 2: z), outward.
constexpr std::array<std::array<int, 4>, 6> kFaces{{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

float seenShare(const Obb& box, const View& view, const DepthBuffer& depth, double skinM) {
  DepthBuffer::Seen total;
  for (const auto& face : kFaces) {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = box.corner(face[i]);
    // Faces that look away lie behind the box itself; a viewer in the box sees only those, and the box counts by its middle.
    const Vec3 normal = glm::cross(p[1] - p[0], p[3] - p[0]);
    if (glm::dot(normal, view.directionTo((p[0] + p[2]) * 0.5)) > 0) continue;
    for (const auto& triangle : {std::array<Vec3, 3>{p[0], p[1], p[2]}, {p[0], p[2], p[3]}}) {
      const DepthBuffer::Seen seen = depth.test(triangle, skinM);
      total.covered += seen.covered;
      total.seen += seen.seen;
    }
  }
  const auto samples = static_cast<std::size_t>(depth.width()) * static_cast<std::size_t>(depth.height());
  if (total.covered > 0) {
    return seenShareOf({static_cast<std::uint32_t>(total.covered), static_cast<std::uint32_t>(total.seen), false}, samples);
  }
  const Vec3 middle = box.center();
  if (!view.inFrontOfNear(middle)) return 0.0F;
  const Vec3 nearer = middle - view.directionTo(middle) * skinM;
  const Vec4 clip = view.viewProjection() * Vec4(nearer, 1.0);
  const Vec3 ndc = Vec3(clip) / clip.w;
  if (!(std::abs(ndc.x) < 1 && std::abs(ndc.y) < 1)) return 0.0F;   // nor a place that is no number
  const int x = static_cast<int>((ndc.x * 0.5 + 0.5) * depth.width());
  const int y = static_cast<int>((0.5 - ndc.y * 0.5) * depth.height());
  return seenShareOf({0, 0, ndc.z <= static_cast<double>(depth.at(x, y))}, samples);
}

}  // namespace

float seenShareOf(const ScopeSamples& samples, std::size_t viewportSamples) {
  if (samples.covered == 0) return samples.middleSeen ? 1.0F : 0.0F;
  const double plenty = std::max(1.0, kPlentySeenShare * static_cast<double>(viewportSamples));
  return static_cast<float>(std::min(1.0, samples.seen / std::min(static_cast<double>(samples.covered), plenty)));
}

void CpuVisibility::measure(const Scene& scene, const View& view, ScopeVisibility& visibility) {
  depth_.reset(view, kVisibilitySamples);
  depth_.draw(scene);
  const double skinM = kScopeSkinShare * scene.bounds.diagonal();
  visibility.seenShare.clear();
  for (const Scope& scope : scene.scopes) visibility.seenShare.push_back(seenShare(scope.box, view, depth_, skinM));
}

}  // namespace dimline
