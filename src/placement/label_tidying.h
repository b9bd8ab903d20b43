#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/sort_keys.h"
#include "placement/labels.h"
#include "placement/layout.h"

namespace dimline {

/// Looks for the places of labels once more when all lines of a picture are there and none has to give way to a label any more. While lines are placed a label keeps off what may still come, and takes what is left.
/// Beyond the paper, whose figures have labels but no rule for them.
class LabelTidying {
 public:
  /// Places the labels of one parameter's lines outside the model anew: of a line, or of a chain.
  /// A chain measures one size many times: its numbers stand on one side, at every line if all have room, or else at an even step, as small as there is room for, and then each at its own line's middle. One number more,
  /// beside the bound of two lines, or a gap in a row, says less.
  /// A single line that can carry its label has it beside itself, where there is no room on it, before it has it beyond an end.
  /// Where that finds nothing each label goes where it would go by itself, and where none has room they stay as they are.
  /// `landed`: all that is there, these lines and their labels included; it is told of the labels' new places.
  void tidy(std::span<PlacedLine> lines, const Vec2& textSize, const DistanceFields& model, const Box2& viewport, Landed& landed);

 private:
  /// Which of a chain's lines have a label, and where.
  struct Pattern {
    std::optional<LabelPlace::Side> side = {};
    bool centred = false;
    std::size_t start = 0, step = 1;
  };
  struct Place {
    std::span<const PlacedLine> lines;
    const Vec2& textSize;
    const DistanceFields& model;
    const Box2& viewport;
    const Landed& landed;
  };
  void putInOrder(std::span<const PlacedLine> lines);
  bool label(const Place& among, const Pattern& pattern, bool all);
  bool labelOnOneSide(const Place& among);
  bool labelEvenly(const Place& among);

  // Memory of one call, kept so that the next allocates nothing.
  std::vector<Segment2> members_;   ///< of a chain, on screen
  std::vector<SortKey> inOrder_;    ///< the same along the chain
  std::vector<Box2> labels_;        ///< theirs so far
  std::vector<std::optional<LabelFound>> found_;
};

}  // namespace dimline
