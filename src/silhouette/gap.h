#pragma once

#include <optional>

#include "silhouette/slide.h"

namespace dimline {

/// A stretch of offsets (m).
struct Gap {
  double fromM, toM;
};

/// The nearest stretch of offsets in [lowM, mostM] at which the slid line is outside though further out the model is in
/// its way again: it stands between two parts of the model, and one of the two viewport edges beside its way sees it
/// whole. Beyond the paper, which moves a line away from all that is there. A gap that leaves less than 8 px to move in
/// is passed by, one of 12 px is not; where it ends is known to 4 px. Nothing when there is none on the first pixels of
/// the way, twice as many as the viewport is wide and high, or `mostM` is not finite. Allocates nothing.
std::optional<Gap> nearestGap(const DistanceFields& fields, const Slide& slide, double lowM, double mostM);

}  // namespace dimline
