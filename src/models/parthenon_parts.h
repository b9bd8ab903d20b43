#pragma once

#include "model/builder.h"

// The pieces that the Parthenon is drawn from. Inner header of that model.

namespace dimline::parthenon {

inline constexpr int kSteps = 3;
inline constexpr double kTread = 0.7;           ///< of a step (m)
inline constexpr double kUpperRadius = 0.78;    ///< of a column, to its lower one

/// Where everything is. The stylobate is the uppermost step, on which the columns stand; x = z = 0 is a corner of it.
struct Plan {
  double width = 0, length = 0;                 ///< of the stylobate
  double stepHeight = 0, columnHeight = 0, radius = 0, capitalHeight = 0, entablature = 0, overhang = 0, pitchRad = 0;
  int baysAcross = 0, baysAlong = 0;

  [[nodiscard]] double stylobate() const { return kSteps * stepHeight; }
  [[nodiscard]] double architrave() const { return stylobate() + columnHeight; }   ///< its lower edge
  [[nodiscard]] double geison() const { return architrave() + 0.82 * entablature; }
  [[nodiscard]] double roof() const { return architrave() + entablature; }
  /// From the stylobate's edge to the columns' axes, and to the face of architrave and frieze.
  [[nodiscard]] double axisInset() const { return 1.06 * radius; }
  [[nodiscard]] double faceInset() const { return axisInset() - 0.92 * kUpperRadius * radius; }
  [[nodiscard]] double bayAcross() const { return (width - 2 * axisInset()) / baysAcross; }
  [[nodiscard]] double bayAlong() const { return (length - 2 * axisInset()) / baysAlong; }
  [[nodiscard]] double triglyph() const { return 0.2 * bayAcross(); }
  /// From the stylobate's edge to the inner building, the same on all four sides.
  [[nodiscard]] double ambulatory() const { return 0.15 * width; }
};

struct Palette {
  explicit Palette(Builder& b);
  MaterialId marble, shade, step, wall, blue, red, tiles, bronze, gold, ceiling;
};

/// All that a piece needs to know. The builder's scope is the stylobate's rectangle, at the height of the ground.
struct Parthenon {
  Builder& b;
  const Plan& plan;
  const Palette& m;
};

/// Architrave, frieze of triglyphs and metopes, and the geison with its mutules: parthenon_entablature.cpp.
void drawEntablature(const Parthenon& t);
/// Pediments, tiles and acroteria: parthenon_roof.cpp.
void drawRoof(const Parthenon& t);

// parthenon_sculpture.cpp
/// The gods of a pediment, between the ridge and the eaves `halfM` to both sides. x = 0 is under the ridge, where there is room for `riseM`
/// above y = 0; z = 0 is the middle of the ledge on which they stand.
PartId makePedimentFigures(const Parthenon& t, double halfM, double riseM);
/// A palmette on its pedestal, its middle at x = z = 0.
PartId makeAcroterion(const Parthenon& t, double widthM, double heightM);

}  // namespace dimline::parthenon
