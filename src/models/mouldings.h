#pragma once

#include "model/builder.h"

// Mouldings of classical buildings, shared by several models. Inner header of the models.

namespace dimline {

/// A moulding around the rectangle of the scope's floor, from x = z = 0 to `sizeM`, mitred at its corners. The section's points are
/// metres outwards from the rectangle's edge and up from the floor.
void drawMoulding(Builder& b, const Vec2& sizeM, const Ring& section);

/// Adds to a section a curve from one point to another, level at neither end, that swells where it is low and hollows where it
/// is high: a cyma recta when it rises outwards.
void addCyma(Ring& section, const Vec2& from, const Vec2& to);

/// The outline of a palmette with its scrolls, standing on y = 0 with its middle at x = 0.
Ring palmette(double widthM, double heightM);

}  // namespace dimline
