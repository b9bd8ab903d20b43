#include "silhouette/scope_visibility.h"

#include <algorithm>
#include <optional>

#include "core/constants.h"

namespace dimline {

namespace {

/// The six faces of a box by corner number (bit 0: x, bit 1: y, bit 2: z), outward.
constexpr std::array<std::array<int, 4>, 6> kFaces{{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// Whether what has these clip coordinates is not behind the model; nothing when it is out of view, or a place that is no number.
std::optional<bool> isSeen(const Vec4& clip, const DepthBuffer& depth) {
  const Vec3 ndc = Vec3(clip) / clip.w;
  const double x = (ndc.x * 0.5 + 0.5) * depth.width();
  const double y = (0.5 - ndc.y * 0.5) * depth.height();
  if (!(clip.w > 0 && x >= 0 && x < depth.width() && y >= 0 && y < depth.height())) return std::nullopt;
  return ndc.z <= static_cast<double>(depth.at(static_cast<int>(x), static_cast<int>(y)));
}

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
  return seenShareOf({0, 0, isSeen(view.viewProjection() * Vec4(nearer, 1.0), depth).value_or(false)}, samples);
}

/// Moving a point towards the viewer leaves it where it is on screen, and what lies between two corners lies between their clip coordinates, so only corners are moved and projected.
SeenEdges seenEdges(const Obb& box, const View& view, const DepthBuffer& depth, double skinM) {
  std::array<Vec4, 8> clip;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = box.corner(i);
    clip[static_cast<std::size_t>(i)] = view.viewProjection() * Vec4(corner - view.directionTo(corner) * skinM, 1.0);
  }
  std::uint32_t edges = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int number = 0; number < 4; ++number) {
      const int from = ((number & 1) << (axis + 1) % 3) + (number >> 1 << (axis + 2) % 3);
      const Vec4& a = clip[static_cast<std::size_t>(from)];
      const Vec4& b = clip[static_cast<std::size_t>(from + (1 << axis))];
      int points = 0;
      int seen = 0;
      for (int i = 0; i < SeenEdges::kPointsPerEdge; ++i) {
        const std::optional<bool> isPointSeen = isSeen(a + (b - a) * ((i + 0.5) / SeenEdges::kPointsPerEdge), depth);
        points += isPointSeen.has_value() ? 1 : 0;
        seen += isPointSeen.value_or(false) ? 1 : 0;
      }
      if (2 * seen >= points) edges |= SeenEdges::bit(axis, number);
    }
  }
  return SeenEdges(edges);
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
  visibility.seenEdges.clear();
  for (const Scope& scope : scene.scopes) {
    visibility.seenShare.push_back(seenShare(scope.box, view, depth_, skinM));
    visibility.seenEdges.push_back(seenEdges(scope.box, view, depth_, skinM));
  }
}

}  // namespace dimline
