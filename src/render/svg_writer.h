#pragma once

#include <string>

#include "model/scene.h"
#include "placement/layout.h"

namespace dimline {

/// A dimensioned drawing as an SVG document of the viewport's size: the model as a line drawing, hidden lines removed, its surfaces in
/// light tones; over it the layout's dimension lines, drawn as in the page, and its angles, with their texts. Switches and choices are left
/// out. The text is set in Barlow where that is installed, and keeps its measured width in any other font.
///
/// `title` is what the document is called. The same input gives the same bytes. The document needs nothing from outside.
std::string writeSvg(const Scene& scene, const Layout& layout, const std::string& title);

}  // namespace dimline
