#pragma once

#include <array>
#include <random>
#include <vector>

#include "models/tree_parts.h"

// How a realistic crown grows: a leader, limbs, and sprigs with leaves in three tones. Places are metres from the middle of the crown's floor. Inner header
// of the tree models.

namespace dimline::tree {

/// Reproducible random numbers: the same with every standard library, unlike its distributions.
class Random {
public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  /// In [low, high).
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0); }
  /// Even over the unit sphere.
  Vec3 direction();

private:
  std::mt19937 engine_;
};

struct Limb {
  std::vector<Vec3> path;  ///< at least two points
  double startRadius = 0, endRadius = 0;
  int sides = 4;
};

inline constexpr std::size_t kTones = 3;

/// A leaf, or a spray of them, seen as one: a rhombus folded along its middle.
///
///          left
///       .-'    '-.
///   base ------- tip
///       '-.    .-'
///          right
struct Leaf {
  Vec3 base, tip, left, right;
  std::size_t tone = 0;  ///< 0 dark to kTones - 1 light
  float shade = 0;       ///< 0 to 1: where in its tone
};

/// A piece of the crown that is made once and put up in many places: a clump, a twig, a bough, a frond. Its frame has its foot at the
/// origin and, for all but the clumps, y up; x is away from the stem.
struct Sprig {
  std::vector<Limb> limbs;
  std::vector<Leaf> leaves;
  Vec3 middle{0.0};  ///< leaves are shaded as if they lay around it
};

struct SprigPlace {
  std::size_t sprig = 0;
  Vec3 at{0.0};
  std::array<Vec3, 3> axes;
};

struct Growth {
  std::vector<Vec3> leader;  ///< what the stem goes on to, from the crown's floor up
  double leaderEnd = 0.1;    ///< its width at the end, as a share of the stem's diameter
  std::vector<Limb> limbs;
  std::vector<Sprig> sprigs;
  std::vector<SprigPlace> places;
};

/// The same seed and sizes give the same growth; the leaves fill the crown's box.
Growth grow(const Crown& crown, double trunkDiameterM, std::uint32_t seed);

/// Adds a leaf's two triangles.
void addLeaf(const Leaf& leaf, const Vec3& middle, Builder::Surface& surface);

/// 0xRRGGBB.
std::uint32_t leafColor(Kind kind, std::size_t tone);

}  // namespace dimline::tree
