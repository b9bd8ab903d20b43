#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "core/constants.h"
#include "placement/frame_kind.h"

namespace dimline {

/// What came of placing a frame's lines one after the other, so that two attempts at one frame can be compared.
struct Outcome {
  FrameKind frame;              ///< that all attempts at it share
  double worth = 0;             ///< px, the sum of what the chosen places are worth by themselves (Chooser::worth())
  double changes = 0;           ///< how many lines left their place of the last frame; a leap counts as kChangesOfLeap, and one to a place that is lost soon as kChangesOfPassing
  int returns = 0;              ///< how many of them went back to what they had left lately
  std::size_t returned = 0;     ///< the rank of the last of those
  int tangles = 0;              ///< how many lines run across another's extension line
  double tanglesAhead = 0;      ///< how many will when the camera goes on as it does (Foresight): at each look one, the nearer the look the more of one
  int nestedWrongly = 0;        ///< how many lines have a shorter one outside, or a longer one within
  std::vector<char> changed;    ///< one a rank: it is among those
  std::vector<char> outside;    ///< one a rank: it has a place outside the model
  std::vector<char> amiss;      ///< one a rank: it runs across another's extension line, or another across one of its own, or it is nested wrongly

  /// The ranks of two lines one of which runs across the other's extension line, in the order in which they were placed.
  using Tangled = std::pair<std::size_t, std::size_t>;
  std::vector<Tangled> tangled;

  void begin(std::size_t ranks, const FrameKind& kind = {});
  /// By more than rounding.
  [[nodiscard]] bool betterThan(const Outcome& other) const;
};

/// Another attempt at a frame: what is to be done otherwise than in the best one so far.
struct Attempt {
  /// The line of one rank is to be placed before that of another.
  struct Put {
    std::size_t rank = 0, before = 0;
  };
  std::optional<std::size_t> looks = std::nullopt;   ///< the rank of the line that must find another place than it has
  bool otherSide = false;                            ///< and on another side of its base line
  bool shortestFirst = false;                        ///< the shortest come first again, before anyone is put before others
  bool winsTies = false;                             ///< it is kept unless it is worse; others are when they are better
  std::array<Put, kMostPuts> puts{};
  std::size_t putCount = 0;                          ///< how many of these are meant
};

/// Whose place is looked at again. The paper's greedy order (4.5) leaves lines that run across others' extension lines where another order would not, and shifts many
/// lines for the good of one. So lines stand firm from frame to frame as long as their places are any, and in each moved frame a few attempts let one line look
/// for another place, with all that follows from it, or place the lines in another order; each goes on from the best one before it. A picture that rests, as a first one, is mended at once, as far as
/// that goes. A repair step, which the paper names as future work, spread over frames.
class Mending {
 public:
  /// A moved frame begins.
  void begin();
  /// What is to be tried next, nothing when that was all. `outcome`: of the best attempt so far; `shortestFirst`: whether it placed the shortest lines first.
  /// First one line looks for another place: one that has just changed its place, since what pushed it may have a better place as well, or else, every kFramesToLookAround frames, any; otherwise
  /// those with which something is amiss, in turns. In a picture that rests each does, one after the other, up to kLooksAtRest. Then a line that went back to what it had left lately comes before who else has
  /// changed its place; or else, of two lines that are in a tangle, the later one comes first, in turns; or, now and then, the shortest first again, if it is not so. Where any are in a tangle, or go
  /// back to what they had left, kShuffles attempts at random (kShufflesAtFirst in a first picture), and where lines settle kShufflesSettling in any case, come last: of what those in turns do not find they find as much as any other
  /// rule did, and they do not try the same in every frame.
  std::optional<Attempt> next(const Outcome& outcome, bool shortestFirst);

 private:
  std::optional<std::size_t> nextToLook(const Outcome& outcome);
  std::optional<Attempt> nextOrder(const Outcome& outcome, bool shortestFirst);
  Attempt shuffle(const Outcome& outcome);
  std::size_t anyOf(std::size_t count) { return dice_() % count; }
  /// Two different ones of at least two.
  std::pair<std::size_t, std::size_t> anyTwo(std::size_t count) {
    const std::size_t one = anyOf(count);
    return {one, (one + 1 + anyOf(count - 1)) % count};
  }

  // At this frame so far.
  std::size_t looks_ = 0;
  std::array<std::size_t, kMendingAttempts> looked_{};   ///< who looked, so many
  bool ordered_ = false;               ///< another order was asked for
  int shuffles_ = 0;

  // Whose turn it was.
  int frames_ = 0;                     ///< since any line was looked at
  std::size_t lastAmiss_ = 0;
  std::size_t lastOfAll_ = 0;
  std::size_t orders_ = 0;             ///< frames in which another order was wanted
  std::minstd_rand dice_;              ///< the same numbers on every machine, so that a flight gives the same pictures twice
};

}  // namespace dimline
