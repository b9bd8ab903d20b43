#include "placement/chains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.h"
#include "core/sort_keys.h"

namespace dimline {

namespace {

/// Unit vectors that differ by less than kSamePlaneAngleRad; for so small an angle the chord is the angle. Written out, since every base line asks it of every cluster, and where code is
/// compiled for size, as for pages, vectors' operators are calls: the Candler building's clusters take half the time so.
bool sameDirection(const Vec3& a, const Vec3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z < kSamePlaneAngleRad * kSamePlaneAngleRad;
}

Cluster* findCluster(std::vector<Cluster>& clusters, const Vec3& along, const ScopePlane& plane, const Vec3& point, double modelSizeM) {
  for (Cluster& cluster : clusters) {
    if (!sameDirection(cluster.along, along) || !sameDirection(cluster.plane.normal, plane.normal)) continue;
    if (cluster.plane.inFace != plane.inFace) continue;
    const double apartM = glm::dot(point - cluster.members.front().segment.start, cluster.plane.normal);
    if (std::abs(apartM) <= kSamePlaneDistance * modelSizeM) return &cluster;
  }
  return nullptr;
}

/// The rectangle around the members, and each member's place in it.
void measure(Cluster& cluster) {
  const Vec3 origin = cluster.members.front().segment.start;
  const auto alongOf = [&](const Vec3& p) { return glm::dot(p - origin, cluster.along); };
  const auto acrossOf = [&](const ChainMember& m) { return glm::dot(m.segment.start - origin, cluster.plane.across); };
  double fromM = std::numeric_limits<double>::infinity();
  double toM = -fromM;
  double lowM = fromM;
  double highM = -fromM;
  for (const ChainMember& m : cluster.members) {
    fromM = std::min(fromM, alongOf(m.segment.start));
    toM = std::max(toM, alongOf(m.segment.end));
    lowM = std::min(lowM, acrossOf(m));
    highM = std::max(highM, acrossOf(m));
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec3 foot = origin + cluster.plane.across * (side == 0 ? lowM : highM);
    cluster.sides[side] = {foot + cluster.along * fromM, foot + cluster.along * toM};
    auto& order = cluster.nearestFirst[side];
    // Equally near members keep the order of their making: from the model's description, the same in every build of it.
    std::vector<SortKey> keys;
    for (const ChainMember& m : cluster.members) {
      keys.push_back({side == 0 ? acrossOf(m) - lowM : highM - acrossOf(m), static_cast<std::uint32_t>(keys.size())});
    }
    sortKeys(keys);
    order.clear();
    for (const SortKey& key : keys) order.push_back(key.index);
  }
  for (ChainMember& m : cluster.members) {
    m.fromM = alongOf(m.segment.start) - fromM;
    m.toM = alongOf(m.segment.end) - fromM;
  }
}

}  // namespace

std::vector<Cluster> clusterBaseLines(const Annotation& annotation, std::span<const Scope> scopes,
                                      std::span<const std::size_t> measuredScopes, double modelSizeM) {
  std::vector<Cluster> clusters;
  if (!isLinear(annotation.type)) return clusters;
  const View anyView;   // the linear types do not look at it
  for (const std::size_t scope : measuredScopes) {
    for (const BaseLine& line : baseLines(annotation, scopes[scope].box, anyView)) {
      const double lengthM = line.segment.length();
      if (!(lengthM > 0)) continue;
      const Vec3 along = (line.segment.end - line.segment.start) / lengthM;
      for (const ScopePlane& plane : line.scopePlanes) {
        Cluster* cluster = findCluster(clusters, along, plane, line.segment.start, modelSizeM);
        if (cluster == nullptr) {
          cluster = &clusters.emplace_back();
          cluster->along = along;
          cluster->plane = plane;
        }
        cluster->members.push_back({.scope = scope, .baseLine = line.number, .segment = line.segment});
      }
    }
  }
  for (Cluster& cluster : clusters) {
    measure(cluster);
    for (std::size_t side = 0; side < 2; ++side) {
      const ChainMember& nearest = cluster.members[cluster.nearestFirst[side].front()];
      cluster.faces[side] = baseLine(annotation, scopes[nearest.scope].box, nearest.baseLine, nearest.segment).faces;
    }
  }
  return clusters;
}

std::int32_t successor(const Cluster& was, std::span<const Cluster> now) {
  // An edit turns a wall by little from one frame to the next; what is at right angles to it is another wall.
  constexpr double kTurnedCos = 0.9;
  std::int32_t nearest = -1;
  double leastM = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Cluster& is = now[i];
    if (is.plane.inFace != was.plane.inFace || glm::dot(is.along, was.along) < kTurnedCos || glm::dot(is.plane.normal, was.plane.normal) < kTurnedCos) continue;
    const double apartM = glm::length(is.sides[0].middle() - was.sides[0].middle()) + glm::length(is.sides[1].middle() - was.sides[1].middle());
    if (apartM >= leastM) continue;
    leastM = apartM;
    nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

BaseLine chainBaseLine(const Cluster& cluster, int side) {
  BaseLine line;
  line.segment = cluster.sides[static_cast<std::size_t>(side)];
  line.number = side;
  line.faces = cluster.faces[static_cast<std::size_t>(side)];
  ScopePlane plane = cluster.plane;
  if (side == 0) plane.across = -plane.across;
  line.scopePlanes.push_back(plane);
  return line;
}

bool TakenStretches::free(double fromM, double toM, double toleranceM) const {
  return std::ranges::none_of(stretches_,
                              [&](const Stretch& s) { return fromM < s.toM - toleranceM && s.fromM < toM - toleranceM; });
}

}  // namespace dimline
