#pragma once

#include <optional>
#include <span>
#include <vector>

#include "placement/layout.h"

namespace dimline {

/// Where a label lay on its line in the last frame.
struct LastLabelPlace {
  std::optional<LabelPlace> place;   ///< none: the line had no label
  bool mayLeave = false;   ///< for a better place, or be shown again; or else only when there is no room any more
};

/// Where labels lay on their lines in the last frame. Of several places a label would take the first that is free just now, and hop along its line with all that passes by; so it is looked for where it was, and
/// goes to a better place only after kReturnFrames moved frames. Beyond the paper, whose figures have labels but no rule for them.
class LabelMemory {
 public:
  /// Of a line that keeps its place. Its label may leave, or come back, when it has stayed, or been away, for kReturnFrames and the view has moved. `nth`: which of its parameter's lines it is, to be found sooner.
  [[nodiscard]] std::optional<LastLabelPlace> last(const Identity& line, std::size_t nth, bool viewMoved) const;
  /// The frame is placed.
  void note(std::span<const PlacedLine> lines, bool viewMoved);
  void forget() { labels_.clear(); }
  /// The clusters of a parameter have other numbers now: see History::renumberChains().
  template <typename NumberNow>
  void renumberChains(std::int32_t parameter, NumberNow numberNow) {
    for (Label& label : labels_) {
      if (label.line.parameter != parameter || label.line.chain < 0) continue;
      label.line.chain = numberNow(label.line.chain);
      if (label.line.chain < 0) label.line = {};
    }
    std::erase_if(labels_, [](const Label& label) { return label.line.parameter < 0; });
  }

 private:
  struct Label {
    Identity line;
    std::optional<LabelPlace> place;
    int framesHeld = 0;   ///< moved frames since it came there, or went; counts to kReturnFrames
  };
  [[nodiscard]] const Label* find(const Identity& line, std::size_t nth) const;

  std::vector<Label> labels_;   ///< those of a parameter one after the other
  std::vector<Label> before_;   ///< memory
};

}  // namespace dimline
