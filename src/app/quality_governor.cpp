#include "app/quality_governor.h"

#include <algorithm>

namespace dimline {

namespace {

/// ms between frames above which motion is no longer smooth, and below which there may be room for full quality again.
constexpr double kSlowIntervalMs = 30.0;
constexpr double kFastIntervalMs = 20.0;

/// ms. A longer pause is no slow frame: the page slept, or compiled something.
constexpr double kPauseMs = 300.0;

/// Slow frames, one after the other, after which quality is reduced: a hiccup is no reason.
constexpr int kSlowFrames = 6;

/// Fast frames after which full quality is tried again, and at most, since each trial that fails doubles it: nobody
/// shall see the quality flap.
constexpr int kFirstPatience = 120;
constexpr int kMostPatience = 4000;

/// ms without motion after which the picture is drawn in full. Short enough to seem at once, longer than the pauses of
/// a hand. They count from the first frame without motion: the last one with it may have taken longer than that to draw, and a full picture begun
/// right after would come in the way of showing it.
constexpr double kSettleMs = 120.0;

}  // namespace

void QualityGovernor::start(bool software) {
  *this = {};
  software_ = slow_ = software;
  patience_ = kFirstPatience;
}

void QualityGovernor::noteFrame(double nowMs, bool moving) {
  const double intervalMs = nowMs - lastFrameMs_;
  const bool counts = moving && hadMotion_ && intervalMs > 0 && intervalMs < kPauseMs;
  lastFrameMs_ = nowMs;
  if (moving || hadMotion_) lastMotionMs_ = nowMs;
  hadMotion_ = moving;
  inMotion_ = moving || nowMs - lastMotionMs_ < kSettleMs;
  if (!counts || software_) return;

  slowFrames_ = intervalMs > kSlowIntervalMs ? slowFrames_ + 1 : 0;
  fastFrames_ = intervalMs < kFastIntervalMs ? fastFrames_ + 1 : 0;
  if (!slow_ && slowFrames_ >= kSlowFrames) {
    slow_ = true;
    fastFrames_ = 0;
  } else if (slow_ && fastFrames_ >= patience_) {
    slow_ = false;
    slowFrames_ = 0;
    patience_ = std::min(2 * patience_, kMostPatience);
  }
}

}  // namespace dimline
