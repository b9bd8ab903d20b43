#pragma once

#include "models/boat_plan.h"

// The pieces that the galleon is drawn from. Inner header of the boat model. Unless a function says otherwise, the
// builder's scope is the ship's: metres along the axes of boat_plan.h.

namespace dimline::boat {

/// The materials of the ship.
struct Palette {
  explicit Palette(Builder& b);
  MaterialId tallow, oak, darkOak, tar, deck, ochre, red, green, gilt, glass, iron, spar, canvas, cloth, hemp,
      tarredRope, flagRed, flagWhite, flagBlue, shadow, light;
};

/// All that a piece needs to know.
struct Ship {
  Builder& b;
  const Plan& plan;
  const Palette& m;
};

inline constexpr int kSides[] = {1, -1};  ///< starboard, port

// --- Tools: boat_tools.cpp ----------------------------------------------------------------------------------------------

/// A point of the starboard side, mirrored to port when `side` is -1.
Vec3 mirrored(const Vec3& p, int side);

/// Puts the scope at a point, along axes of the current scope: unit length, right-handed. Its size becomes `size`.
void enterFrame(Builder& b, const Vec3& origin, const std::array<Vec3, 3>& axes, const Vec3& size = Vec3(0.0));

/// A timber along a strake from one place to another, on the side that is given. The section's x counts outwards from
/// the planking, its y upwards.
void drawStrake(const Ship& ship, const Ring& section, double fromX, double toX, double h, int side);

/// A round bar between two points. `profile` is of (radius, share of the way).
void drawSpar(const Ship& ship, const Vec3& from, const Vec3& to, std::span<const Vec2> profile, int segments);

/// A rope through the points.
void drawRope(const Ship& ship, std::span<const Vec3> way, double radiusM, int sides = 4);
void drawRope(const Ship& ship, const Vec3& from, const Vec3& to, double radiusM, int sides = 4);
/// A rope that hangs a little between its ends.
void drawSlackRope(const Ship& ship, const Vec3& from, const Vec3& to, double sagM, double radiusM);

/// Puts the scope at a point, its z to the outside of the hull's side there, level, and its y up.
void enterSide(const Ship& ship, double x, double h, int side);

/// Names the box between two opposite corners.
void nameBetween(const Ship& ship, std::string_view name, const Vec3& a, const Vec3& b);

// --- Hull: boat_hull.cpp -------------------------------------------------------------------------------------------------

/// Planking up to the main deck, keel, stem, sternpost and rudder, wales, bulwarks of the waist, and the blocks on which
/// she stands.
void buildHull(const Ship& ship);
/// Gun ports with their lids and guns, and the bays between them: boat_guns.cpp.
void buildGuns(const Ship& ship);

// --- Upper works: boat_castles.cpp, boat_stern.cpp, boat_beakhead.cpp ---------------------------------------------------------

/// The sides, decks, bulkheads and railings of forecastle and sterncastle, and what stands on the decks.
void buildCastles(const Ship& ship);
/// The transom with its windows, the gallery, taffrail and lanterns.
void buildStern(const Ship& ship);
/// The beakhead with its knee, rails, grating and figurehead.
void buildBeakhead(const Ship& ship);

// --- Rig: boat_rig.cpp, boat_ropes.cpp ------------------------------------------------------------------------------------

/// Masts, tops, bowsprit, yards, sails and flags.
void buildRig(const Ship& ship);
/// Shrouds with ratlines, stays, braces, sheets and lifts.
void buildRopes(const Ship& ship);

}  // namespace dimline::boat
