#pragma once

#include <optional>

#include "placement/layout.h"

namespace dimline {

/// Where a label stands relative to its line on screen: from the start, the middle or the end, whichever is nearest. So
/// a label beyond an arrowhead stays beyond it, and one in the middle in the middle, while the line grows or turns.
struct LabelAnchor {
  enum class To : std::uint8_t { kStart, kMiddle, kEnd } to = To::kMiddle;
  Vec2 offset{0.0};  ///< px, from there to the middle of the label's box
  Vec2 size{0.0};    ///< px
};

/// The anchor of a line's label, by its lineScreen; nothing when the line has no label.
std::optional<LabelAnchor> labelAnchor(const PlacedLine& line);

/// Middle of an anchored label's box (px) for a line on screen.
Vec2 labelCenter(const LabelAnchor& anchor, const Segment2& lineScreen);

/// Whether all four ends of a line and its base lie in front of `view`'s near plane, so that it can be projected.
bool canProject(const PlacedLine& line, const View& view);

/// Makes the screen parts of a line (baseScreen, lineScreen, extensions, handles, label) anew from its world parts,
/// which may have changed, as `view` shows them. The label keeps to `anchor`, and goes when there is none. Extension
/// lines follow: their ends as far as those of base line and line go on screen, bends by the mean of that. Requires
/// canProject().
void projectLine(PlacedLine& line, const View& view, const std::optional<LabelAnchor>& anchor);

}  // namespace dimline
