#pragma once

#include <algorithm>

#include "math/camera.h"

/// How what lies over the picture moves: lines and the other handles alike.
namespace dimline {

/// ms. Long enough to be followed, short enough not to be waited for.
inline constexpr double kGlideMs = 180.0;
inline constexpr double kFadeMs = 140.0;

/// px. What stays the same one but moves against the model by more than this from one frame to the next glides too.
/// Below, it is the usual drift of what keeps its distance while the camera turns.
inline constexpr double kJumpPx = 24.0;

/// px. A line whose new choice lies further away than this does not glide: it fades where it was and appears where it is. Less: lines vanish that could be followed. More: while the model is turned, lines
/// fly across it.
inline constexpr double kFarPx = 240.0;

/// Fast at first: most of the way is done while the eye still turns to it.
inline double easeOut(double t) {
  const double left = 1.0 - std::clamp(t, 0.0, 1.0);
  return 1.0 - left * left * left;
}

inline bool sameView(const View& a, const View& b) {
  return a.worldToPixels() == b.worldToPixels() && a.widthPx() == b.widthPx() && a.heightPx() == b.heightPx() &&
         a.nearM() == b.nearM();
}

}  // namespace dimline
