#pragma once

#include <cstddef>

#include "model/model.h"

namespace dimline {

/// Models that are made to be measured, of any size.

/// 100 columns in a square, about so many triangles in all (>= 1000), and four lengths with 16 base lines.
ModelDefinition columnField(std::size_t triangles);

/// A block with so many windows on its four sides, 8 base lines each: width and height of a window, chained or each for
/// itself.
ModelDefinition windowWall(std::size_t windows, bool chained);

}  // namespace dimline
