#pragma once

#include <optional>
#include <vector>

#include "placement/object_planes.h"
#include "placement/slip_planes.h"

namespace dimline {

/// Which places the movement of the camera is about to take away. A plane that is turning edge-on is left out soon (paper 4.4), and so is the part of an object plane that a
/// neighbour is about to cut off; a line that goes there has to move again at once. So whoever needs a new place asks whether it will still be one when the camera has gone on
/// for a while as it does now. Beyond the paper, which judges each frame by itself.
class Foresight {
 public:
  /// A frame begins. `before`: the view of the last frame, if there is one that this one follows from. `bounds`: of the model, in metres.
  void begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM);
  /// Whether a plane that a base line may slip on in this frame will still have room for it at `offsetM` in that direction, +1 or -1. True when the view does not turn.
  [[nodiscard]] bool lasts(const BaseLine& line, Slip slip, const SlipPlane& plane, int direction, double offsetM);

 private:
  std::optional<View> ahead_;       ///< nothing when the view does not turn
  std::vector<ObjectPlaneUse> objectUses_;
  ObjectPlanesInFrame object_;
  std::vector<SlipPlane> planes_;   ///< memory for one base line's
};

}  // namespace dimline
