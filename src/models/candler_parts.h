#pragma once

#include "model/builder.h"

// The pieces that the Candler Building is drawn from. Inner header of that model.

namespace dimline::candler {

// Metres, and counts.
inline constexpr double kBay = 4.2;         ///< from pier to pier
inline constexpr int kFrontBays = 5;        ///< of front and back
inline constexpr int kSideBays = 6;
inline constexpr double kCorner = 2.3;      ///< width of a corner pier
inline constexpr double kPlinth = 0.35;
inline constexpr double kGround = 5.7;      ///< height of the ground floor
inline constexpr int kUpperStoreys = 16;    ///< above it; seventeen in all
inline constexpr int kBaseStoreys = 2;      ///< those of them that belong to the base
inline constexpr double kSill = 0.75;       ///< above the floor
inline constexpr double kReveal = 0.42;     ///< from the wall's face back to the glass
inline constexpr double kWallDepth = 0.6;
inline constexpr double kEntablature = 3.9; ///< from the top of the last storey to the cornice's upper edge

struct Plan {
  double floorHeight = 0, windowHeight = 0, windowWidth = 0, courseHeight = 0, overhang = 0;
  bool cresting = false;

  [[nodiscard]] double width() const { return kFrontBays * kBay + 2 * kCorner; }
  [[nodiscard]] double depth() const { return kSideBays * kBay + 2 * kCorner; }
  /// Height of an upper storey's floor; 0 is the first above the ground floor.
  [[nodiscard]] double floorAt(int storey) const { return kGround + storey * floorHeight; }
  [[nodiscard]] double top() const { return floorAt(kUpperStoreys); }
  /// From the head of one window to the sill of the next.
  [[nodiscard]] double spandrelHeight() const { return floorHeight - windowHeight; }
};

struct Palette {
  explicit Palette(Builder& b);
  MaterialId marble, carved, spandrel, granite, sash, glass, bronze, awning, copper, gravel, brick, flag;
};

/// All that a piece needs to know. The builder's scope is the building: its footprint, from the ground to the top of the last storey.
struct Candler {
  Builder& b;
  const Plan& plan;
  const Palette& m;
};

/// A moulding around the building. The section's points are metres outwards from the wall's face and up from `heightM`.
void drawBand(const Candler& c, double heightM, MaterialId material, const Ring& section);

/// Granite piers, shopfronts with awnings, and the portal in the middle of the front: candler_ground_floor.cpp.
void drawGroundFloor(const Candler& c);

// candler_cornice.cpp
/// Architrave, frieze and the great cornice: dentils, modillions, corona, cymatium and cresting.
void drawCornice(const Candler& c);
/// Parapet, roof, lift house, and the flag.
void drawRoof(const Candler& c);

}  // namespace dimline::candler
