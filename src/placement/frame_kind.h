#pragma once

namespace dimline {

/// What is known of a frame before its lines are placed, by which places and attempts are judged.
struct FrameKind {
  bool isFirst = false;         ///< nobody has seen one before it, so changes disturb nobody
  bool settles = false;         ///< a movement ends with it (Placer::settle()), so a change costs little
  bool zooms = false;           ///< the camera comes nearer or goes away

  /// Whether it will be looked at for long, and is mended as far as that goes.
  [[nodiscard]] bool rests() const { return isFirst || settles; }
};

}  // namespace dimline
