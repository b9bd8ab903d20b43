#include "cli/bench_straightforward.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.h"

namespace dimline {

namespace {

/// A corner of a triangle as a slide sees it, in homogeneous coordinates: along the line u / w, across it t / w, before
/// the viewer where `front` > 0.
struct Seen {
  double u, t, w, front;
};

Seen mix(const Seen& a, const Seen& b, double share) {
  const auto at = [&](double from, double to) { return from + (to - from) * share; };
  return {at(a.u, b.u), at(a.t, b.t), at(a.w, b.w), at(a.front, b.front)};
}

/// The corners of a convex polygon on the side where inside(corner) >= 0.
template <typename Inside>
std::size_t clip(std::array<Seen, 8>& corners, std::size_t count, Inside inside) {
  std::array<Seen, 8> kept;
  std::size_t keptCount = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Seen& a = corners[i];
    const Seen& b = corners[(i + 1) % count];
    const double atA = inside(a);
    const double atB = inside(b);
    if (atA >= 0) kept[keptCount++] = a;
    if ((atA >= 0) != (atB >= 0)) kept[keptCount++] = mix(a, b, atA / (atA - atB));
  }
  corners = kept;
  return keptCount;
}

/// The largest offset that a triangle needs.
double offsetPast(std::array<Seen, 8>& corners) {
  constexpr double kHorizon = 1e-9;
  std::size_t count = clip(corners, 3, [](const Seen& c) { return c.front; });
  count = clip(corners, count, [](const Seen& c) { return c.u; });
  count = clip(corners, count, [](const Seen& c) { return c.w - c.u; });
  double most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (corners[i].w > kHorizon) {
      most = std::max(most, corners[i].t / corners[i].w);
    } else if (corners[i].t > 0) {
      return std::numeric_limits<double>::infinity();
    }
  }
  return most;
}

}  // namespace

Straightforward::Straightforward(const Model& model, const Scene& scene) : scopes_(scene.scopes) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Mat4 toWorld(instance.transform);
    const auto first = static_cast<std::uint32_t>(corners_.size());
    for (const glm::vec3& p : mesh.positions) corners_.emplace_back(toWorld * Vec4(Vec3(p), 1.0));
    for (const auto& t : mesh.triangles) triangles_.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (Measured& measured : measure(model, scopes_, scene.bounds.diagonal())) {
    if (isLine(measured.annotation.type)) measured_.push_back(std::move(measured));
  }
  toleranceM_ = kSamePlaneDistance * scene.bounds.diagonal();
  objectPlanes_ = objectPlanes(fixedBaseLines(measured_, scopes_), scene.bounds);
}

double Straightforward::leastOffsetM(const Slide& slide, const View& view) const {
  double most = 0;
  for (const auto& triangle : triangles_) {
    std::array<Seen, 8> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = corners_[triangle[i]];
      const Vec3 h = view.worldToPixels() * Vec4(p, 1.0);
      corners[i] = {glm::dot(slide.uForm(), h), glm::dot(slide.tForm(), h), glm::dot(slide.wForm(), h),
                    view.depth(p) - view.nearM()};
    }
    most = std::max(most, offsetPast(corners));
  }
  return most;
}

void Straightforward::placeLine(const BaseLine& line, Slip slip, bool chain, const View& view, Frame& frame) {
  if (!view.inFrontOfNear(line.segment)) return;
  slipPlanes(line, slip, view, {objectPlanes_, objectUses_, toleranceM_}, planes_);
  for (const SlipPlane& plane : planes_) {
    for (const double direction : {1.0, -1.0}) {
      if (direction < 0 && chain && plane.kind == PlaneKind::kScope)
        continue;  // a chain slips away from its members only
      const Segment onPlane{line.segment.start + plane.onto, line.segment.end + plane.onto};
      const auto slide = Slide::make(view, onPlane, plane.across * direction);
      if (!slide) continue;
      ++frame.candidates;
      const double offsetM = leastOffsetM(*slide, view);
      if (std::isfinite(offsetM)) frame.sumM += offsetM;
    }
  }
}

Straightforward::Frame Straightforward::place(const View& view) {
  Frame frame;
  facePlanes(objectPlanes_, view, objectUses_);
  for (const Measured& measured : measured_) {
    const Slip slip = measured.annotation.slip;
    for (const Cluster& cluster : measured.clusters) {
      for (const int side : {0, 1}) placeLine(chainBaseLine(cluster, side), slip, true, view, frame);
    }
    if (!measured.clusters.empty()) continue;  // then its scopes' own stand back
    for (const std::size_t scope : measured.scopes) {
      for (const BaseLine& line : baseLines(measured.annotation, scopes_[scope].box, view))
        placeLine(line, slip, false, view, frame);
    }
  }
  return frame;
}

}  // namespace dimline
