#pragma once

#include <optional>
#include <span>
#include <vector>

#include "placement/layout.h"

namespace dimline {

/// Where labels lay on their lines in the last frame. Of several places a label would take the first that is free just now, and hop along its line with all that passes by; so it is looked for where it was, and
/// goes to a better place only after kReturnFrames moved frames. Beyond the paper, whose figures have labels but no rule for them.
class LabelMemory {
 public:
  /// Where the label of a line shall be looked for first: nowhere when it had none, the line was elsewhere, or the label has stayed for long enough and the view has moved. `nth`: which of its parameter's
  /// lines it is, to be found sooner.
  [[nodiscard]] std::optional<LabelPlace> last(const Identity& line, std::size_t nth, bool viewMoved) const;
  /// The frame is placed.
  void note(std::span<const PlacedLine> lines, bool viewMoved);
  void forget() { labels_.clear(); }

 private:
  struct Label {
    Identity line;
    LabelPlace place;
    int framesHeld = 0;   ///< moved frames since it came there; counts to kReturnFrames
  };
  [[nodiscard]] const Label* find(const Identity& line, std::size_t nth) const;

  std::vector<Label> labels_;   ///< those of a parameter one after the other
  std::vector<Label> before_;   ///< memory
};

}  // namespace dimline
