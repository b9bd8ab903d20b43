#pragma once

#include <optional>
#include <vector>

#include "placement/object_planes.h"
#include "placement/slip_planes.h"

namespace dimline {

/// Which places the movement of the camera is about to take away. A plane that is turning edge-on is left out soon (paper 4.4), and so is the part of an object plane that a
/// neighbour is about to cut off; and what the camera comes nearer to leaves the viewport. A line that goes there has to move again at once. So whoever needs a new place asks
/// whether it will still be one when the camera has gone on for a while as it does now. Beyond the paper, which judges each frame by itself.
class Foresight {
 public:
  /// A frame begins. `before`: the view of the last frame, if there is one that this one follows from; when it is the same one, before a still camera, the movement is
  /// thought to go on as it did. `bounds`: of the model, in metres.
  void begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM);
  /// Whether a plane that a base line may slip on in this frame will still have room for it at `offsetM` in that direction, +1 or -1. True when the view does not move.
  [[nodiscard]] bool lasts(const BaseLine& line, Slip slip, const SlipPlane& plane, int direction, double offsetM);
  /// Whether a line that is outside the model will still lie within the viewport's margin; true as well when the view does not move.
  [[nodiscard]] bool staysInside(const Segment& line) const;
  /// Whether something of a base line will still be seen in the viewport; true as well when the view does not move.
  [[nodiscard]] bool staysInSight(const Segment& base) const;

 private:
  std::optional<View> ahead_;       ///< nothing when the view does not move
  std::vector<ObjectPlaneUse> objectUses_;
  ObjectPlanesInFrame object_;
  std::vector<SlipPlane> planes_;   ///< memory for one base line's
};

}  // namespace dimline
