#pragma once

#include "math/camera.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

/// Whether any of a box may be seen: not all of its corners lie beyond one side of the view frustum.
bool inView(const View& view, const Obb& box);
/// Whether all of it may be.
bool wholeInView(const View& view, const Obb& box);

/// Whether a scope counts as seen, over frames. Leaves are gap and cover in turn, and what shows between them leaps from frame to frame: so what has come into
/// sight stays there for kReturnFrames, then until too little of it has been seen for kFramesToLoseSight on end, and what has left it comes back within kReturnFrames only
/// when plenty of it is seen.
/// Before a still camera it says the same again, unless another share is measured: the model has changed, or what was on its way has come. That counts at once.
class Sight {
 public:
  /// To be told before a frame, of how many frames of a steady movement it has the weight; 0 for one whose view is the last one's.
  void age(int frames);
  /// Takes the share of the scope that is seen in this frame, 0 to 1, and which of its edges are; says whether it counts as seen.
  bool see(double share, SeenEdges edges = SeenEdges::all());
  /// The share of it that was seen in the last frame.
  [[nodiscard]] double share() const { return share_; }
  /// The edges that were seen in the last frame.
  [[nodiscard]] SeenEdges edges() const { return edges_; }
  /// Whether enough of it was seen in the last frame, so that it may be shown anew; what only stays in sight may not.
  [[nodiscard]] bool seenEnough() const { return framesTooLittle_ == 0; }

 private:
  int frames_ = 0;        ///< since it came into sight, or, negative, since it left it; to kReturnFrames; 0 before the first
  bool still_ = false;    ///< the view is the last frame's
  int newFrames_ = 0;     ///< of how many this one has the weight
  int framesTooLittle_ = 0;   ///< on end, in which too little was seen
  double share_ = -1;     ///< of the last frame; negative before the first
  SeenEdges edges_ = SeenEdges::all();   ///< of the last frame
};

/// Whether a scope is in the picture as a whole, and at least kSeenShareInPlainView of it not behind the model. `stays`: a line inside the model showed it in the last frame, so that less is enough.
bool inPlainView(const View& view, const Obb& box, const Sight& sight, bool stays);

}  // namespace dimline
