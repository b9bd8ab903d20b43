#include "models/tree_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/power.h"

// Each kind grows by a rule of its own, in about the size that is asked for. Its leaves are on a few sprigs that are put up many times over,
// since making and preparing thousands of leaves one by one is what takes time. Then all is stretched a little so that the leaves fill the
// crown's box. Nothing that depends on the sizes decides how many random numbers are drawn, so a tree that is dragged larger stays the same tree.

namespace dimline::tree {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGoldenRad = 2.399963229728653;  // from one branch to the next around a leader

Vec3 level(double angleRad) { return {std::cos(angleRad), 0, std::sin(angleRad)}; }

/// A curve that leaves `from` towards `via` and comes to `to`.
std::vector<Vec3> curve(const Vec3& from, const Vec3& via, const Vec3& to, int segments) {
  std::vector<Vec3> path;
  for (int i = 0; i <= segments; ++i) {
    const double t = static_cast<double>(i) / segments;
    path.push_back(from * ((1 - t) * (1 - t)) + via * (2 * t * (1 - t)) + to * (t * t));
  }
  return path;
}

/// A place on a path, by its share.
Vec3 along(std::span<const Vec3> path, double share) {
  const double at = share * static_cast<double>(path.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), path.size() - 2);
  return glm::mix(path[i], path[i + 1], at - static_cast<double>(i));
}

/// Any direction at right angles to a unit vector, by an angle about it.
Vec3 across(const Vec3& n, double angleRad) {
  const Vec3 a = glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
  return a * std::cos(angleRad) + glm::cross(n, a) * std::sin(angleRad);
}

struct LeafShape {
  double length, width;  ///< m
  double fold = 0.3;     ///< how far the sides are raised, as a share of half the width
  double waist = 0.45;   ///< where along it the leaf is widest
};

/// A frame that is turned about the vertical.
std::array<Vec3, 3> turned(double angleRad) { return {level(angleRad), Vec3(0, 1, 0), Vec3(-std::sin(angleRad), 0, std::cos(angleRad))}; }

Vec3 inFrame(const std::array<Vec3, 3>& axes, const Vec3& p) { return axes[0] * p.x + axes[1] * p.y + axes[2] * p.z; }

/// Runs visit(point) over all points of a sprig's leaves.
template <typename SprigType, typename Visit>
void eachLeafPoint(SprigType& sprig, Visit&& visit) {
  for (auto& l : sprig.leaves) {
    for (auto* p : {&l.base, &l.tip, &l.left, &l.right}) visit(*p);
  }
}

class Grower {
public:
  Grower(const Crown& crown, double trunkDiameterM, std::uint32_t seed)
      : radius_(0.5 * crown.width),
        height_(crown.height),
        trunk_(0.5 * trunkDiameterM),
        size_(std::cbrt(crown.width * crown.width * crown.height)),
        random_(seed) {}

  Growth oak();
  Growth birch();
  Growth spruce();
  Growth palm();

private:
  /// A leaf from `base` along `way` (unit), its face towards `face`.
  void leaf(Sprig& sprig, const Vec3& base, const Vec3& way, const Vec3& face, const LeafShape& shape, std::size_t tone) {
    const Vec3 side = glm::normalize(glm::cross(face, way)), up = glm::cross(way, side);
    const Vec3 waist = base + way * (shape.length * shape.waist), raised = up * (shape.fold * 0.5 * shape.width);
    sprig.leaves.push_back({base, base + way * shape.length, waist + side * (0.5 * shape.width) + raised,
                            waist - side * (0.5 * shape.width) + raised, tone, static_cast<float>(random_.real(0, 1))});
  }

  std::size_t add(Sprig sprig) {
    growth_.sprigs.push_back(std::move(sprig));
    return growth_.sprigs.size() - 1;
  }
  void place(std::size_t sprig, const Vec3& at, const std::array<Vec3, 3>& axes) { growth_.places.push_back({sprig, at, axes}); }

  std::size_t clump(const Vec3& radius, int leaves, const LeafShape& shape);
  std::size_t hangingTwig(double lengthM, int leaves, const LeafShape& shape);
  std::size_t bough(double lengthM, double rise, double sag, int pairs, std::size_t tone);
  std::size_t frond(double riseRad, double lengthM);

  void stretchBetweenPlaces(int axis, double low, double middle, double high);
  void stretchSprigs(const Vec3& scale);

  double radius_, height_, trunk_, size_;
  Random random_;
  Growth growth_;
};

// --- Filling the crown's box ----------------------------------------------------------------------------------------------

/// Moves places, limbs and leader along an axis, away from `middle` or towards it, until the outermost leaves touch `low` and `high`. Either side
/// is stretched evenly, so limbs still end where their sprigs are.
void Grower::stretchBetweenPlaces(int axis, double low, double middle, double high) {
  double up = std::numeric_limits<double>::infinity(), down = up;
  for (const SprigPlace& place : growth_.places) {
    double reachUp = 0, reachDown = 0;
    eachLeafPoint(growth_.sprigs[place.sprig], [&](const Vec3& p) {
      const double along = inFrame(place.axes, p)[axis];
      reachUp = std::max(reachUp, along);
      reachDown = std::max(reachDown, -along);
    });
    const double at = place.at[axis] - middle;
    if (at > 1e-9) up = std::min(up, std::max(high - middle - reachUp, 0.0) / at);
    if (at < -1e-9) down = std::min(down, std::max(middle - low - reachDown, 0.0) / -at);
  }
  if (!std::isfinite(up)) up = 1;
  if (!std::isfinite(down)) down = 1;
  const auto move = [&](Vec3& p) { p[axis] = middle + (p[axis] - middle) * (p[axis] > middle ? up : down); };
  for (SprigPlace& place : growth_.places) move(place.at);
  for (Limb& limb : growth_.limbs) {
    for (Vec3& p : limb.path) {
      move(p);
      p.y = std::max(p.y, 0.02 * height_);
    }
  }
  for (Vec3& p : growth_.leader) move(p);
}

void Grower::stretchSprigs(const Vec3& scale) {
  for (Sprig& sprig : growth_.sprigs) {
    eachLeafPoint(sprig, [&](Vec3& p) { p *= scale; });
    for (Limb& limb : sprig.limbs) {
      for (Vec3& p : limb.path) p *= scale;
    }
    sprig.middle *= scale;
  }
}

// --- Oak: a dome of clumps on crooked limbs -------------------------------------------------------------------------------

/// Leaves all around a middle, denser and lighter on the outer side, which is x.
std::size_t Grower::clump(const Vec3& radius, int leaves, const LeafShape& shape) {
  Sprig sprig;
  sprig.middle = {-1.2 * radius.x, -0.4 * radius.x, 0};
  sprig.leaves.reserve(static_cast<std::size_t>(leaves));
  for (int i = 0; i < leaves; ++i) {
    Vec3 d = random_.direction();
    const double depth = random_.real(0.72, 1.0), turn = random_.real(0, 2 * kPi), size = random_.real(0.75, 1.2), tilt = random_.real(0, 1);
    const Vec3 jitter = random_.direction();
    if (d.x < -0.3) d = -d;
    const Vec3 face = glm::normalize(d + Vec3(0, 0.3, 0) + jitter * 0.55);
    const Vec3 way = glm::normalize(across(face, turn) - Vec3(0, 0.3, 0) * tilt);
    const double lit = 0.4 * d.y + 0.5 * d.x + 0.4 * (tilt - 0.5);
    leaf(sprig, d * radius * depth - way * (0.5 * shape.length * size), way, face,
         {shape.length * size, shape.width * size, shape.fold, shape.waist}, lit > 0.5 ? 2 : lit > 0.08 ? 1 : 0);
  }
  return add(std::move(sprig));
}

Growth Grower::oak() {
  constexpr int kLimbs = 7, kClumps = 34, kClumpKinds = 5, kLeavesInClump = 70;
  const double sway = 0.05 * std::min(radius_, 0.4 * height_);
  growth_.leader = curve({0, 0, 0}, {0.6 * sway, 0.25 * height_, -0.8 * sway}, {-sway, 0.6 * height_, 0.6 * sway}, 4);
  growth_.leaderEnd = 0.22;
  const std::vector<Vec3> leader = growth_.leader;
  const double thick = std::min(0.5 * trunk_, 0.09 * radius_);
  for (int i = 0; i < kLimbs; ++i) {
    const double share = static_cast<double>(i) / (kLimbs - 1), a = i * kGoldenRad + random_.real(-0.3, 0.3);
    const Vec3 from = along(leader, 0.14 + 0.76 * share), out = level(a);
    const Vec3 to = out * (radius_ * (0.66 - 0.3 * share * share)) + Vec3(0, height_ * (0.3 + 0.5 * share), 0);
    const Vec3 via = from + out * (0.35 * radius_) + Vec3(0, (to.y - from.y) * random_.real(0.2, 0.5), 0);
    growth_.limbs.push_back({curve(from, via, to, 5), thick * (1 - 0.3 * share), thick * 0.3, 5});
  }
  // In a flat or a narrow crown clumps must stay small enough to have a place to either side of the middle.
  const double size = std::min(size_, 1.5 * std::min(height_, 2 * radius_));
  const LeafShape shape{0.09 * size, 0.05 * size};
  for (int i = 0; i < kClumpKinds; ++i) clump(Vec3(0.11, 0.15, 0.15) * (size * (0.85 + 0.3 * i / (kClumpKinds - 1))), kLeavesInClump, shape);
  const Vec3 middle(0, 0.4 * height_, 0);
  for (int i = 0; i < kClumps; ++i) {
    // Evenly over the dome, which has no floor: the lowest clumps hang around it.
    const double y = 1 - 1.42 * (i + 0.5) / kClumps, r = std::sqrt(1 - y * y), a = i * kGoldenRad + random_.real(-0.2, 0.2);
    const Vec3 out(r * std::cos(a), y, r * std::sin(a));
    // Below the middle as far as leaves hardly reach the floor, so that nothing needs to be stretched towards it.
    const double tall = y > 0 ? 0.46 * height_ : (middle.y - 0.17 * size) / 0.42;
    const Vec3 at = middle + Vec3(0.72 * radius_, tall, 0.72 * radius_) * out * random_.real(0.86, 1.0);
    // A twig from the nearest place on a limb.
    Vec3 nearest = leader.back();
    for (std::size_t k = 0; k < kLimbs; ++k) {
      for (const double t : {0.45, 0.7, 1.0}) {
        const Vec3 p = along(growth_.limbs[k].path, t);
        if (glm::length(p - at) < glm::length(nearest - at)) nearest = p;
      }
    }
    const Vec3 via = glm::mix(nearest, at, 0.5) + Vec3(0, 0.15 * glm::length(at - nearest), 0);
    growth_.limbs.push_back({curve(nearest, via, at, 2), thick * 0.32, thick * 0.1, 4});
    const Vec3 side = across(out, random_.real(0, 2 * kPi));
    place(static_cast<std::size_t>(i % kClumpKinds), at, {out, glm::cross(side, out), side});
  }
  stretchBetweenPlaces(0, -radius_, 0, radius_);
  stretchBetweenPlaces(1, 0, middle.y, height_);
  stretchBetweenPlaces(2, -radius_, 0, radius_);
  return std::move(growth_);
}

// --- Birch: a slender leader, thin branches, twigs that hang ----------------------------------------------------------------

std::size_t Grower::hangingTwig(double lengthM, int leaves, const LeafShape& shape) {
  Sprig sprig;
  sprig.middle = {-1.5 * lengthM, -0.8 * lengthM, 0};
  const Vec3 lean = glm::normalize(Vec3(1, 0, random_.real(-0.5, 0.5))) * (0.24 * lengthM);
  for (int i = 0; i < leaves; ++i) {
    const double t = (i + 0.5) / leaves, turn = i * kGoldenRad + random_.real(-0.4, 0.4), size = random_.real(0.8, 1.2);
    const Vec3 at = lean * std::sqrt(t) - Vec3(0, lengthM * t, 0);
    const Vec3 side = level(turn), way = glm::normalize(side + Vec3(0, -0.9, 0));
    const Vec3 face = glm::normalize(Vec3(0.9, 0.6, 0) + side * 0.5);
    leaf(sprig, at + side * (0.1 * shape.length), way, face, {shape.length * size, shape.width * size, shape.fold, 0.4},
         t < 0.35 ? 2 : random_.real(0, 1) < 0.6 ? 1 : 0);
  }
  return add(std::move(sprig));
}

Growth Grower::birch() {
  constexpr int kBranches = 34, kLengths = 4;
  const double sway = 0.05 * std::min(radius_, 0.4 * height_);
  growth_.leader = curve({0, 0, 0}, {sway, 0.5 * height_, 0.8 * sway}, {-0.4 * sway, 0.93 * height_, 0}, 6);
  growth_.leaderEnd = 0.08;
  const std::vector<Vec3> leader = growth_.leader;
  const LeafShape shape{0.05 * size_, 0.036 * size_, 0.25};
  // Twigs at a branch's tip, behind it and in its middle, shorter from the lowest quarter of the branches to the uppermost.
  for (int i = 0; i < kLengths; ++i) {
    const double hang = height_ * (0.19 - 0.027 * i);
    hangingTwig(hang, 26, shape);
    hangingTwig(hang * 0.9, 22, shape);
    hangingTwig(hang * 0.7, 16, shape);
  }
  for (int i = 0; i < kBranches; ++i) {
    const double share = (i + 0.5) / kBranches, a = i * kGoldenRad + random_.real(-0.3, 0.3);
    const Vec3 from = along(leader, 0.06 + 0.9 * share), out = level(a);
    // Egg-shaped: widest below the middle, pointed at the top.
    const double reach = radius_ * (power(std::sin(kPi * power(1 - 0.93 * share, 1.25)), 0.7) * random_.real(0.82, 1.0) + 0.04);
    // A long branch arches over, a short one just climbs.
    const double climb = height_ * (0.10 + 0.04 * share), arch = 0.6 * climb + std::min(0.65 * climb, 0.3 * reach);
    const double thick = std::min(0.22 * trunk_, 0.06 * radius_) * (1 - 0.6 * share);
    std::vector<Vec3> path = curve(from, from + out * (0.55 * reach) + Vec3(0, arch, 0), from + out * reach + Vec3(0, climb, 0), 3);
    const std::size_t twigs = 3 * static_cast<std::size_t>(i * kLengths / kBranches);
    place(twigs, path.back(), turned(a));
    place(twigs + 1, along(path, 0.72), turned(a + 0.2));
    place(twigs + 2, along(path, 0.45), turned(a - 0.2));
    growth_.limbs.push_back({std::move(path), thick, thick * 0.3, 3});
  }
  place(3 * (kLengths - 1), leader.back() + Vec3(0, 0.02 * height_, 0), turned(1));
  stretchBetweenPlaces(0, -radius_, 0, radius_);
  stretchBetweenPlaces(1, 0, 0.5 * height_, height_);
  stretchBetweenPlaces(2, -radius_, 0, radius_);
  return std::move(growth_);
}

// --- Spruce: whorls of boughs that hang and lift their tips -----------------------------------------------------------------

/// A flat feather of needle sprays on both sides of a branch.
std::size_t Grower::bough(double lengthM, double rise, double sag, int pairs, std::size_t tone) {
  Sprig sprig;
  sprig.middle = {0.3 * lengthM, -1.2 * lengthM, 0};
  const std::vector<Vec3> path = curve({0, 0, 0}, {0.6 * lengthM, (rise - sag) * lengthM, 0}, {lengthM, rise * lengthM, 0}, 4);
  sprig.limbs.push_back({{path[0], path[2], path[4]}, 0.016 * lengthM + 0.012, 0.004 * lengthM + 0.004, 3});
  for (int i = 0; i < pairs; ++i) {
    const double t = 0.12 + 0.88 * (i + 0.5) / pairs;
    const Vec3 at = along(path, t), way = glm::normalize(along(path, std::min(t + 0.1, 1.0)) - along(path, t - 0.1));
    const double reach = lengthM * (0.34 * (1 - t) + 0.12);
    for (const double s : {-1.0, 1.0}) {
      const Vec3 spray = glm::normalize(way * 0.75 + Vec3(0, random_.real(-0.5, -0.15), s));
      const double length = reach * random_.real(0.85, 1.15);
      leaf(sprig, at, spray, glm::normalize(Vec3(0.25, 1, 0.3 * s)), {length, 0.42 * length + 0.02 * lengthM, 0.2, 0.4}, (i + (s > 0 ? 1 : 0)) % 3 == 0 ? 0 : tone);
    }
  }
  const Vec3 end = glm::normalize(path[4] - path[3]);
  leaf(sprig, path[4] - end * (0.1 * lengthM), end, {0, 1, 0}, {0.22 * lengthM, 0.09 * lengthM, 0.2, 0.4}, std::min<std::size_t>(tone + 1, kTones - 1));
  return add(std::move(sprig));
}

Growth Grower::spruce() {
  constexpr int kWhorls = 15;
  growth_.leader = {{0, 0.2 * height_, 0}, {0, 0.5 * height_, 0}, {0, 0.8 * height_, 0}, {0, 0.985 * height_, 0}};
  growth_.leaderEnd = 0.06;
  // Boughs of a tree that is wider than high cannot hang as far; those of a slender one hang further, and fill the gaps between the whorls.
  const double slender = height_ / radius_, hang = std::max(std::min(1.0, 0.55 * slender), 0.28 * slender);
  double widest = 0;
  for (int w = 0; w < kWhorls; ++w) {
    const double share = static_cast<double>(w) / (kWhorls - 1);
    const double length = (radius_ * 0.95 * power(1 - share, 0.85) + 0.06 * radius_) * (w == 0 ? 1.05 : random_.real(0.86, 1.02));
    const std::size_t made = bough(length, hang * (-0.3 + 0.85 * share * share), 0.28 * hang, 11 - static_cast<int>(5 * share), 1);
    eachLeafPoint(growth_.sprigs[made], [&](const Vec3& p) { widest = std::max(widest, std::hypot(p.x, p.z)); });
    // The lowest whorl reaches furthest; it has boughs straight to all four sides.
    const int boughs = w == 0 ? 12 : 11 - static_cast<int>(5 * share);
    const double y = height_ * (0.05 + 0.9 * power(share, 0.93));
    for (int i = 0; i < boughs; ++i) {
      const double jitter = random_.real(-0.2, 0.2), drop = random_.real(-0.015, 0.015) * height_;
      place(made, {0, y + (w == 0 ? 0.0 : drop), 0}, turned(w * kGoldenRad + 2 * kPi * (i + (w == 0 ? 0.0 : jitter)) / boughs));
    }
  }
  Sprig top;
  top.middle = {0, -0.1 * height_, 0};
  for (int i = 0; i < 6; ++i) {
    const Vec3 way = glm::normalize(level(i * kPi / 3) * 0.25 + Vec3(0, 1, 0));
    leaf(top, {0, 0, 0}, way, level(i * kPi / 3), {0.07 * height_, 0.016 * height_, 0.2, 0.4}, 2);
  }
  place(add(std::move(top)), {0, 0.93 * height_, 0}, turned(0));
  stretchSprigs({radius_ / widest, 1, radius_ / widest});
  stretchBetweenPlaces(1, 0, 0.5 * height_, height_);
  return std::move(growth_);
}

// --- Palm: a head of fronds that bend under their leaflets ------------------------------------------------------------------

std::size_t Grower::frond(double riseRad, double lengthM) {
  constexpr int kPairs = 23;
  Sprig sprig;
  sprig.middle = {0.2 * lengthM, -1.2 * lengthM, 0};
  const Vec3 start(std::cos(riseRad), std::sin(riseRad), 0);
  const double sag = 0.42 + 0.25 * std::cos(riseRad);
  std::vector<Vec3> path;
  for (int i = 0; i <= 6; ++i) {
    const double t = i / 6.0;
    path.push_back(start * (lengthM * t * (1 - 0.18 * t)) - Vec3(0, sag * lengthM * t * t, 0));
  }
  for (int i = 0; i < kPairs; ++i) {
    const double t = 0.14 + 0.86 * (i + 0.5) / kPairs;
    const Vec3 at = along(path, t), way = glm::normalize(along(path, std::min(t + 0.08, 1.0)) - along(path, t - 0.08));
    const double reach = lengthM * 0.3 * power(std::sin(kPi * (0.08 + 0.86 * t)), 0.6);
    const Vec3 up = glm::normalize(glm::cross(Vec3(0, 0, 1), way));
    for (const double s : {-1.0, 1.0}) {
      const Vec3 leaflet = glm::normalize(Vec3(0, -random_.real(0.2, 0.5), s) + way * (0.35 + 0.7 * t) + up * 0.18);
      const Vec3 face = (up.y >= 0 ? up : -up) + Vec3(0, 0, 0.35 * s);
      leaf(sprig, at, leaflet, glm::normalize(face), {reach * random_.real(0.9, 1.1), 0.05 * lengthM, 0.25, 0.35},
           riseRad < -0.1 ? 0 : i % 4 == 0 ? 2 : 1);
    }
  }
  sprig.limbs.push_back({std::move(path), 0.013 * lengthM + 0.012, 0.003 * lengthM + 0.004, 3});
  return add(std::move(sprig));
}

Growth Grower::palm() {
  constexpr int kRounds = 7;
  Bounds reach;
  std::size_t widest = 0;
  double widestM = 0;
  for (int i = 0; i < kRounds; ++i) {
    // The youngest stand up in the middle, the oldest hang.
    const double share = static_cast<double>(i) / (kRounds - 1), rise = 1.3 - 1.7 * power(share, 0.8);
    const double length = 0.72 + 0.4 * std::sin(kPi * std::min(share * 0.8 + 0.15, 1.0));
    const std::size_t made = frond(rise, radius_ * length * random_.real(0.95, 1.05));
    eachLeafPoint(growth_.sprigs[made], [&](const Vec3& p) {
      reach.add(p);
      const double m = std::hypot(p.x, p.z);
      if (m > widestM) {
        widest = made;
        widestM = m;
      }
    });
  }
  // In rounds of four; those that reach furthest point straight to all four sides.
  const double up = height_ / reach.size().y, head = -reach.min.y * up;
  for (std::size_t i = 0; i < kRounds; ++i) {
    for (int k = 0; k < 4; ++k) {
      const double sway = i == widest ? 0 : random_.real(-0.12, 0.12);
      place(i, {0, head, 0}, turned(0.5 * kPi * k + (static_cast<double>(i) - static_cast<double>(widest)) * kGoldenRad + sway));
    }
  }
  stretchSprigs({radius_ / widestM, up, radius_ / widestM});
  growth_.leader = {{0, 0.5 * head, 0}, {0, 0.85 * head, 0}, {0, head, 0}};
  growth_.leaderEnd = 0.45;
  return std::move(growth_);
}

}  // namespace

Vec3 Random::direction() {
  const double y = real(-1, 1), a = real(0, 2 * kPi), r = std::sqrt(1 - y * y);
  return {r * std::cos(a), y, r * std::sin(a)};
}

Growth grow(const Crown& crown, double trunkDiameterM, std::uint32_t seed) {
  Grower grower(crown, trunkDiameterM, seed);
  Growth growth;
  switch (crown.kind) {
    case Kind::kOak: growth = grower.oak(); break;
    case Kind::kBirch: growth = grower.birch(); break;
    case Kind::kSpruce: growth = grower.spruce(); break;
    case Kind::kPalm: growth = grower.palm(); break;
  }
  // The leader goes on where the stem ends, and always up.
  double least = 0.08 * crown.height;
  for (Vec3& p : growth.leader) {
    p.y = std::max(p.y, least);
    least = p.y + 0.03 * crown.height;
  }
  return growth;
}

void addLeaf(const Leaf& leaf, const Vec3& middle, Builder::Surface& surface) {
  const Vec3 left = glm::cross(leaf.tip - leaf.base, leaf.left - leaf.base), right = glm::cross(leaf.right - leaf.base, leaf.tip - leaf.base);
  Vec3 face = glm::normalize(glm::normalize(left) + glm::normalize(right));
  const Vec3 out = glm::normalize(0.5 * (leaf.base + leaf.tip) - middle);
  // Shaded half as what it is and half as a part of its sprig's surface, the foliage reads as one mass with light and shade.
  const bool turned = glm::dot(face, out) < 0;
  if (turned) face = -face;
  const Vec3 normal = glm::normalize(face + 0.7 * out);
  const auto first = static_cast<std::uint32_t>(surface.points.size());
  for (const Vec3& p : {leaf.base, leaf.tip, leaf.left, leaf.right}) {
    surface.points.push_back(p);
    surface.normals.push_back(normal);
    // One place of the pattern for all of a leaf gives it one shade.
    surface.uvs.emplace_back(leaf.shade * 97.0F, leaf.shade * 31.0F);
  }
  if (turned) {
    surface.triangles.push_back({first, first + 2, first + 1});
    surface.triangles.push_back({first, first + 1, first + 3});
  } else {
    surface.triangles.push_back({first, first + 1, first + 2});
    surface.triangles.push_back({first, first + 3, first + 1});
  }
}

std::uint32_t leafColor(Kind kind, std::size_t tone) {
  constexpr std::uint32_t kColors[4][kTones] = {{0x4F6B35, 0x6A8A43, 0x87A556}, {0x6F8F3F, 0x8DAA4E, 0xA9C067}, {0x2F4F3E, 0x3E6449, 0x5A8260}, {0x4E7340, 0x6A9150, 0x8AAC62}};
  return kColors[static_cast<std::size_t>(kind)][tone];
}

}  // namespace dimline::tree
