#pragma once

#include <string_view>

#include "math/types.h"

namespace dimline {

/// Width (px) of a line of UTF-8 text in the project's label font (Barlow Medium, assets/fonts) at `fontSizePx`, by its advance table:
/// the same in page, SVG and command line, whatever fonts a machine has. A character outside the table counts as an `m`.
double textWidthPx(std::string_view text, double fontSizePx);

/// Size of a label's box at the font size of dimension lines: advance width and line height, without padding.
Vec2 labelSizePx(std::string_view text);

}  // namespace dimline
