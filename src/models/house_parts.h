#pragma once

#include "model/builder.h"
#include "models/house_plan.h"

// The pieces that the family house is drawn from. Inner header of the house model.

namespace dimline::house {

/// The materials of the house.
struct Palette {
  explicit Palette(Builder& b);
  MaterialId plaster, plinth, stone, paving, trim, frame, glass, door, shutter, tiles, timber, soffit, brick, metal,
      darkMetal, gravel, clay;
};

/// All that a piece needs to know. The builder's scope is the one that each function names.
struct House {
  Builder& b;
  const Plan& plan;
  const Palette& m;
};

/// Scope: the box of all storeys. Walls with their openings up to the roof's underside, windows, doors.
void buildFacades(const House& house);
/// Scope: the box of all storeys.
void buildRoof(const House& house);
/// Scope: the box of all storeys. Landing, steps, canopy or balcony, and the terrace behind.
void buildEntrance(const House& house);

/// Outline of a facade's wall above its openings, in facade coordinates, between the wall's ends: the roof's underside there. From right to left.
Ring wallTop(const Plan& plan, const Facade& facade, double fromX, double toX);

/// How far behind the front the two slopes of a shed roof part, as a share of the depth.
inline constexpr double kShedSplit = 0.42;

}  // namespace dimline::house
