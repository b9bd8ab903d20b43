#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/reserved.h"
#include "model/scene.h"
#include "placement/base_lines.h"

namespace dimline {

/// A base line as a member of a chain.
struct ChainMember {
  std::size_t scope = 0;      ///< index into Scene::scopes
  int baseLine = 0;           ///< which of its base lines
  Segment segment;
  double fromM = 0, toM = 0;  ///< its stretch along the cluster's direction, counted from `Cluster::sides[…].start`; fromM < toM
};

/// Base lines of one parameter that run in one direction in one plane (paper 4.3 and figure 13), and the rectangle that holds them.
///
///       side 1  - - - - - - - - - ->   across
///               ->   ->     ->            ^
///               ->   ->                   |
///       side 0  - - - - - - - - - ->      +--> along
struct Cluster {
  Vec3 along{0.0};
  ScopePlane plane;                 ///< `across` is the direction from side 0 to side 1
  std::vector<ChainMember> members;
  std::array<Segment, 2> sides;     ///< the chain base lines: the rectangle's two sides along the members
  std::array<FixedVector<Vec3, 2>, 2> faces;   ///< of each side: outward normals of the faces that meet in the member nearest to it
  /// For each side the members' indices, nearest to that side first: in this order they are projected.
  std::array<std::vector<std::uint32_t>, 2> nearestFirst;
};

/// Clusters the base lines of a parameter by direction and plane. Each base line is in as many clusters as it has scope planes. Only base lines that
/// are the same for all views can be clustered, so the linear types alone give clusters. `modelSizeM` scales kSamePlaneDistance.
std::vector<Cluster> clusterBaseLines(const Annotation& annotation, std::span<const Scope> scopes,
                                      std::span<const std::size_t> measuredScopes, double modelSizeM);

/// Which of `now` is the cluster that `was` has become in an edited model: with the same faces, turned by little, and nearest; -1 when there is none.
std::int32_t successor(const Cluster& was, std::span<const Cluster> now);

/// The chain base line of a side, as a base line that slips away from the members.
BaseLine chainBaseLine(const Cluster& cluster, int side);

/// Stretches of a line that are taken, in metres along it.
class TakenStretches {
 public:
  void reserve(std::size_t stretches) { stretches_.reserve(stretches); }
  void makeRoomLike(const TakenStretches& other) { dimline::makeRoomLike(other.stretches_, stretches_); }
  void clear() { stretches_.clear(); }
  /// Whether [from, to] overlaps nothing by more than `toleranceM`; touching ends are no overlap.
  [[nodiscard]] bool free(double fromM, double toM, double toleranceM) const;
  void add(double fromM, double toM) { stretches_.push_back({fromM, toM}); }

 private:
  struct Stretch {
    double fromM, toM;
  };
  std::vector<Stretch> stretches_;
};

}  // namespace dimline
