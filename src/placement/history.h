#pragma once

#include <array>

#include "core/constants.h"
#include "placement/layout.h"

namespace dimline {

/// What a parameter's handle was in the frames before: what damping and hysteresis look at (paper 4.2, Damp, and principle 9).
class History {
 public:
  explicit History(std::int32_t parameter) : last_{.parameter = parameter} {}

  /// The choice of the last frame; only its `parameter` is set when there was none.
  [[nodiscard]] const Identity& last() const { return last_; }

  /// What hysteresis adds to a candidate's score beyond the paper's Damp: kScoreStay for the last frame's choice, and kScoreReturn for those that were
  /// left within the last kReturnFrames. Damp alone cannot hold a line that others push to and fro.
  [[nodiscard]] double bonus(const Identity& candidate) const;

  /// The offset (m) at which the last frame's choice shall lie now, when it may lie anywhere from `leastM` on: nearer than it was by `stepM` at most, and no further
  /// out than kMostOffsetRatio of what it must. `leastM` when the model has changed since.
  [[nodiscard]] double relaxedOffsetM(double leastM, double stepM) const;

  /// To be told before a frame whose view is another than the last one's. Frames before a still camera do not count, or a line could move with time alone.
  void age();
  /// Notes this frame's choice and its offset (negative: none that the next frame should look at).
  void choose(const Identity& choice, double offsetM);
  /// The model has changed: offsets of the last frame mean nothing any more.
  void forgetOffset() { offsetM_ = -1; }
  /// Nothing was shown.
  void choseNone();

 private:
  struct Left {
    Identity identity;
    int framesAgo = kReturnFrames;
  };
  Identity last_;
  double offsetM_ = -1;               ///< of the last choice; negative when it is not known
  std::array<Left, kReturnFrames> left_;   ///< what was left of late
};

}  // namespace dimline
