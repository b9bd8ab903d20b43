#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace dimline {

/// What came of placing a frame's lines one after the other, so that two attempts at one frame can be compared.
struct Outcome {
  double worth = 0;             ///< px, the sum of what the chosen places are worth by themselves (Chooser::worth())
  double changes = 0;           ///< how many lines left their place of the last frame; a leap counts as kChangesOfLeap, a way back to what was left lately as kChangesOfReturn more
  int tangles = 0;              ///< how many lines run across another's extension line
  int nestedWrongly = 0;        ///< how many lines have a shorter one outside, or a longer one within
  std::vector<char> changed;    ///< one a rank: it is among those
  std::vector<char> outside;    ///< one a rank: it has a place outside the model
  std::vector<char> amiss;      ///< one a rank: it runs across another's extension line, or another across one of its own, or a longer line lies within a shorter one

  /// The ranks of two lines one of which runs across the other's extension line, in the order in which they were placed.
  using Tangled = std::pair<std::size_t, std::size_t>;
  std::vector<Tangled> tangled;

  void begin(std::size_t ranks);
  /// By more than rounding.
  [[nodiscard]] bool betterThan(const Outcome& other) const;
};

/// Whose place is looked at again. The paper's greedy order (4.5) leaves lines that run across others' extension lines where another order would not, and shifts many
/// lines for the good of one. So lines stand firm from frame to frame as long as their places are any, and in each moved frame a few attempts let one line look
/// for another place, with all that follows from it, or two lines be placed in another order; the best attempt is kept. A repair step, which the paper names as future work, spread over frames.
class Mending {
 public:
  /// A moved frame begins.
  void begin();
  /// The rank of the line that shall look for another place in the next attempt at this frame: in the first a line that has just changed its place, since what pushed
  /// it may have a better place as well, or else, every kFramesToLookAround frames, any; otherwise those with which something is amiss, in turns. Nothing when nobody needs to. `outcome`: of
  /// the best attempt so far.
  std::optional<std::size_t> next(const Outcome& outcome);
  /// Another order of placing: the line of one rank before that of another, or the shortest first again.
  struct Order {
    bool shortestFirst = false;
    std::size_t rank = 0, before = 0;
  };
  /// The order to be tried after all attempts of next(): of two lines that are in a tangle the later one first, in turns; or, now and then, the shortest first again, if it is not so now. That one may stay even
  /// when it is no better.
  std::optional<Order> nextOrder(const Outcome& outcome, bool shortestFirst);

 private:
  int attempts_ = 0;             ///< at this frame so far
  std::optional<std::size_t> first_;   ///< who looked in the first of them
  int frames_ = 0;               ///< since any line was looked at
  std::size_t lastAmiss_ = 0;    ///< whose turn it was
  std::size_t lastOfAll_ = 0;
  std::size_t orders_ = 0;       ///< tried so far
};

}  // namespace dimline
