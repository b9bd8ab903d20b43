#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "math/geometry.h"

namespace dimline {

/// A pitched roof as one slab over a rectangle: the floor of the Builder's scope, x by z. Its underside passes through
/// the floor's edges, the outer upper edges of the walls, and runs on beyond them. Outer faces, underside and the
/// upright edges all around (the fascia) are one closed part.
///
///               /\                . ridge
///             / /\ \              .
///           / /    \ \            .
///         / / ...... \ \          . ...... is the scope's floor, on top of the walls
///        |/  |      |  \|         . the eave's underside hangs overhang * tan(pitch) below it (eaveDropM): to have
///            | wall |             . it level with something, move the scope up by that much
///
struct RoofOptions {
  double pitchRad = 0.6;                   ///< (0, 1.4)
  double overhangM = 0;                    ///< beyond the floor on all four sides, measured level, >= 0
  std::optional<double> topOverhangM{};     ///< the same at the upper edge of a shed roof; default: overhangM
  double thicknessM = 0.2;                 ///< at right angles to the slope, > 0
  std::optional<std::uint16_t> edge{};     ///< material of the fascia; default: the current one, as for the outer faces
  std::optional<std::uint16_t> underside{};///< material of the soffit
  [[nodiscard]] double eaveDropM() const;
};

/// A flat roof: a slab that lies on the floor's rectangle and reaches over it, with an upstand (parapet) along its
/// edge.
struct FlatRoofOptions {
  double overhangM = 0;
  double thicknessM = 0.25;     ///< of the slab, upright, > 0
  double parapetHeightM = 0.3;  ///< above the slab; 0: none
  double parapetWidthM = 0.2;
  std::optional<std::uint16_t> edge{};  ///< the slab's and the parapet's faces outwards, and the parapet's top
  std::optional<std::uint16_t> underside{};
};

/// What was built, for all that is fixed to a roof. Everything is in metres from the scope's origin, along its axes.
struct Roof {
  std::vector<std::vector<Vec3>> slopes;  ///< outer faces, counter-clockwise from above; the first edge is the eave
  std::vector<Segment> ridges;            ///< where outer faces meet: ridge first (if it has a length), then hips
  std::vector<Segment> eaves;             ///< upper edge of the fascia at each eave, counter-clockwise seen from above
  Vec3 min{0.0}, max{0.0};                ///< box around the slab: overhangs, fascia and thickness included

  /// Height of the outer faces, taken as endless planes: also right beyond the roof's edge.
  [[nodiscard]] double heightAt(double x, double z) const;
};

}  // namespace dimline
