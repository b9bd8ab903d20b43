#pragma once

#include <array>
#include <limits>
#include <optional>

#include "core/constants.h"
#include "placement/layout.h"

namespace dimline {

/// How far a line's ends lie from its base line's (px).
inline Segment2 away(const Segment2& base, const Segment2& line) { return {line.start - base.start, line.end - base.end}; }

/// What a parameter's handle was in the frames before: what damping and hysteresis look at (paper 4.2, Damp, and principle 9).
class History {
 public:
  explicit History(std::int32_t parameter) : last_{.parameter = parameter} {}

  /// The choice of the last frame; only its `parameter` is set when there was none.
  [[nodiscard]] const Identity& last() const { return last_; }
  [[nodiscard]] bool any() const { return last_ != Identity{.parameter = last_.parameter}; }
  /// How far from its base line, or its anchor, that lay on screen (px); nothing when the model has changed since.
  [[nodiscard]] const std::optional<Segment2>& awayPx() const { return awayPx_; }
  /// Whether that was inside the model.
  [[nodiscard]] bool wasInside() const { return any() && last_.plane < 0; }

  /// What hysteresis adds to a candidate's score beyond the paper's Damp: kScoreStay for the last frame's choice, and kScoreReturn for those that were
  /// left within the last kReturnFrames. Damp alone cannot hold a line that others push to and fro.
  /// The last frame's choice has none when it would jump: from `awayPx` off its base line then to elsewhere now, by more than kLeapPx.
  [[nodiscard]] double bonus(const Identity& candidate, const Segment2& awayPx = {}) const;

  /// Whether a candidate is the last frame's choice and has not leapt: its line lies `awayPx` off its base line on screen, within kLeapPx of where it did. Before a still
  /// camera it lies exactly there.
  [[nodiscard]] bool stays(const Identity& candidate, const Segment2& awayPx) const;

  /// Whether it was left for another within the last kReturnFrames.
  [[nodiscard]] bool leftLately(const Identity& candidate) const;

  /// The offset (m) at which the last frame's choice shall lie now, when it may lie anywhere from `leastM` on: nearer than it was by `stepM` at most, and no further
  /// out than kMostOffsetRatio of what it must, or on its way there by kHurryFactor steps. Before a still camera (`stepM` 0) it stays where it was. `leastM` when the model has changed since.
  [[nodiscard]] double relaxedOffsetM(double leastM, double stepM) const;

  /// How far out (m) the last frame's choice may lie now: further than it did by `stepM` at most. Any distance when its offset is not known.
  [[nodiscard]] double mostOffsetM(double stepM) const { return offsetM_ < 0 ? std::numeric_limits<double>::infinity() : offsetM_ + stepM; }

  /// To be told before a frame whose view is another than the last one's. Frames before a still camera do not count, or a line could move with time alone.
  void age();
  /// Notes this frame's choice, its offset (negative: none that the next frame should look at), and how far it lies from its base line on screen (px).
  void choose(const Identity& choice, double offsetM, const Segment2& awayPx = {});
  /// Notes the choice of a line that is held, `offsetM` from its foot: when it is let go of it stays there if it may, and keeps its place however far from there it must lie.
  void hold(const Identity& choice, double offsetM) {
    choose(choice, offsetM);
    awayPx_.reset();
  }
  /// A better kind of place is there than the last frame's: one outside the model for what was inside, any for what had no room. Returns whether one has been there for
  /// `patienceFrames` moved frames on end.
  bool betterIsThere(int patienceFrames = kPatienceFrames) {
    betterThere_ = true;
    return betterFrames_ >= patienceFrames;
  }
  /// This frame's choice was found better than another place, and need not be looked at again for a while.
  void prefer() { framesHeld_ = 0; }
  /// The model has changed: offsets of the last frame mean nothing any more.
  void forgetOffset();
  /// The model's clusters have other numbers now: each chain that is remembered gets the number that `numberNow` gives for its old one, or is forgotten when that is negative.
  template <typename NumberNow>
  void renumberChains(NumberNow numberNow) {
    const auto renumber = [&](Identity& identity) {
      if (identity.chain < 0) return;
      identity.chain = numberNow(identity.chain);
      if (identity.chain < 0) identity = {.parameter = identity.parameter};
    };
    renumber(last_);
    for (Left& left : left_) renumber(left.identity);
  }
  /// Nothing was shown; `forWantOfRoom`: though it would have been, had there been room.
  void choseNone(bool forWantOfRoom = false);
  /// Whether there was a last frame and nothing was shown in it.
  [[nodiscard]] bool hidden() const { return hidden_; }
  /// Whether what is shown now is shown anew: nothing was in the last frame or, before a still camera, in the one before the camera stood still.
  [[nodiscard]] bool shownAnew() const { return hidden_ || (wasHidden_ && !aged_); }
  [[nodiscard]] bool hiddenForWantOfRoom() const { return forWantOfRoom_; }
  /// Whether what was shown in the last frame had not been there for kDwellFrames moved frames; before a still camera not what came in its own frame.
  [[nodiscard]] bool cameLately() const { return !hidden_ && dwellFrames_ > 0 && dwellFrames_ < kDwellFrames; }
  /// Whether what was not shown in the last frame had been within the last kDwellFrames.
  [[nodiscard]] bool wentLately() const { return hidden_ && dwellFrames_ < kDwellFrames; }
  /// Moved frames since the last frame's choice was made for the first time, or since it was preferred to another; counts to kSingleStaysZooming.
  [[nodiscard]] int framesHeld() const { return framesHeld_; }

 private:
  struct Left {
    Identity identity;
    int framesAgo = kReturnFrames;
  };
  Identity last_;
  bool hidden_ = false;
  bool wasHidden_ = false;            ///< before the last choice
  int dwellFrames_ = 0;               ///< moved frames since it came or, while it is hidden, since it went; counts to kDwellFrames, where what never was there begins
  bool forWantOfRoom_ = false;
  int framesHeld_ = 0;
  bool betterThere_ = false;          ///< in this frame
  int betterFrames_ = 0;              ///< moved frames on end before this one; counts to kPatienceSmallViewportFrames
  std::optional<Segment2> awayPx_;    ///< of the last choice from its base line; nothing when the model has changed since
  bool aged_ = false;                 ///< since the last choice
  double offsetM_ = -1;               ///< of the last choice; negative when it is not known
  std::array<Left, kReturnFrames> left_;   ///< what was left of late
};

}  // namespace dimline
