#pragma once

#include <cstdint>
#include <vector>

#include "cli/audit_rows.h"
#include "math/camera.h"
#include "model/model.h"
#include "placement/layout.h"

namespace dimline {

/// A way for the camera around a model, frame by frame.
struct Flight {
  double widthPx = 1000;
  double heightPx = 1000;
  std::vector<Camera> cameras{};
  std::vector<FrameName> names{};  ///< one a camera
  std::size_t restEvery = 0;       ///< after so many frames the movement rests in one, and the lines settle there; 0: it never does
};

/// Once round a model at one elevation, around the middle of its bounds, at the distance at which it fits the viewport
/// from everywhere on the way. Azimuth runs from the front (+z) towards the right (+x), in steps of `stepDeg` > 0.
Flight orbit(const Bounds& bounds, double elevationDeg, double stepDeg, double widthPx, double heightPx);

/// A flight made up from a number: some way round, then towards the model until its silhouette has left the viewport,
/// then back; a degree, or 1.7 % of the distance, a step. Perspective with 0.2 to 100 degrees of field of view, or
/// orthographic; viewport from 300x200 to 3840x2160.
Flight randomFlight(const Bounds& bounds, std::uint64_t number);

/// A flight with what was placed for each camera, in their order, the lines of one frame known to the next.
struct FlownFlight {
  Flight flight;
  std::vector<Layout> layouts;
};

/// Places a model along a flight, each frame with fields of its own, as `dimline layout` does. Measures the still camera on the way,
/// with a placer of its own that sees every frame three times.
FlownFlight fly(const Model& model, const Scene& scene, const Values& values, Flight flight, AuditTally& tally);

/// The practice that moving lines improve on: the first frame's lines stay in the world where they are, and are only
/// projected. A label stays with the point of its line's plane that is under its middle in the first frame, a handle
/// that is no line with the point at the depth of its scope's middle.
std::vector<Layout> frozen(const FlownFlight& flown, const Scene& scene);

}  // namespace dimline
