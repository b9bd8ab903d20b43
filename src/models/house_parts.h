#pragma once

#include "model/builder.h"
#include "models/house_plan.h"

// The pieces that the family house is drawn from. Inner header of the house model.

namespace dimline::house {

/// The materials of the house.
struct Palette {
  explicit Palette(Builder& b);
  MaterialId plaster, plinth, stone, paving, trim, frame, glass, door, shutter, tiles, timber, soffit, brick, clay,
      metal, darkMetal, gravel, lamp;
};

/// All that a piece needs to know. The builder's scope is the one that each function names.
struct House {
  Builder& b;
  const Plan& plan;
  const Palette& m;
};

// --- Facades: house_facades.cpp -----------------------------------------------------------------------------------------

/// Scope: the box of all storeys. Walls with their openings up to the roof's underside, windows and their shutters.
void buildFacades(const House& house);

/// Frame and glass over an opening's x and y, kReveal behind its z = 0. Scope: the opening in its facade.
void drawGlazing(const House& house, int columns, int rows);
/// Flat trim on the wall beside and above an opening; below too when `closed`. Scope: the opening in its facade.
void drawSurround(const House& house, bool closed);

// --- Entrance: house_entrance.cpp ---------------------------------------------------------------------------------------

/// Scope: the box of all storeys. Landing, steps, canopy or balcony, and the terrace behind.
void buildEntrance(const House& house);
/// Scope: the door's opening in its facade.
void drawDoor(const House& house);

// --- Roof: house_roof.cpp, house_roof_details.cpp, house_dormers.cpp --------------------------------------------------------

inline constexpr double kRoofSlab = 0.22;  ///< thickness of a pitched roof at right angles to the slope (m)

/// Scope: the box of all storeys.
void buildRoof(const House& house);

// For all that follows the scope is the roof's base: level with the walls' upper outer edges, where the underside
// meets them.

/// Half-round tiles along ridge and hips.
void drawRidges(const House& house, const Roof& roof);
/// Gutters along all eaves; downpipes at the ends of the first one, down to the ground.
void drawRainwater(const House& house, const Roof& roof);
/// The rafters' ends under the eaves. Those of a hip roof keep away from the corners.
void drawRafters(const House& house, const Roof& roof, bool hip);
/// The purlins' ends under the verges of a gable roof.
void drawPurlins(const House& house, const Roof& roof);
/// A stack whose middle is at (x, z) = `at`; named, from where it leaves the roof on its upper side to its top.
void drawChimney(const House& house, const Roof& roof, const Vec2& at);
/// Dormers in front, windows in the slope behind, where there is room for them.
void drawRoofWindows(const House& house, const Roof& roof, bool hip);

}  // namespace dimline::house
