#pragma once

#include "math/camera.h"

namespace dimline {

/// Whether any of a box may be seen: not all of its corners lie beyond one side of the view frustum.
bool inView(const View& view, const Obb& box);

}  // namespace dimline
