#pragma once

#include "math/camera.h"
#include "model/scene.h"
#include "placement/layout.h"
#include "render/overlay.h"

namespace dimline {

/// The window depths of a segment in the world once it is so much (m) nearer to the viewer; what is too near to be in the picture counts as nearest of all.
EndDepths endDepths(const Segment& world, const View& view, double nearerM);

/// A placed line as it is to be drawn at rest. A line inside the model, and extension lines, are hidden by what stands before them; where the base line is no
/// edge of its scope it lies within, so that the scope does not count. The result refers to the line's polylines.
OverlayLine overlayLine(const PlacedLine& line, const Scene& scene, const View& view);

}  // namespace dimline
