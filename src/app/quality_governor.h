#pragma once

namespace dimline {

/// Decides how good a picture may be while something moves, by the time between frames: that is what people see, and
/// the only measure that also counts what the GPU does. At rest the picture is always of full quality.
class QualityGovernor {
public:
  /// A new context. A software rasterizer never affords full quality in motion.
  void start(bool software);

  /// Notes a frame. `moving`: its picture is another one than the last frame's.
  void noteFrame(double nowMs, bool moving);

  /// Whether the picture of the frame noted last is drawn at reduced quality.
  [[nodiscard]] bool reduced() const { return slow_ && inMotion_; }

private:
  bool software_ = false;
  bool slow_ = false;
  bool inMotion_ = false;
  bool hadMotion_ = false;  ///< in the frame before
  double lastFrameMs_ = 0;
  double lastMotionMs_ = 0;
  int slowFrames_ = 0;  ///< one after the other
  int fastFrames_ = 0;
  int patience_ = 0;  ///< fast frames after which full quality is tried again
};

}  // namespace dimline
