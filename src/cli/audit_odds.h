#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cli/audit_rows.h"
#include "cli/audit_search.h"

namespace dimline {

/// Tells which offences are at odds with another row: a placer that did without the one would commit another. Lines may
/// not lie inside where there is room outside, nor may features in plain view be without a line; but room that is gone
/// within kTakenBackFrames, or a feature that is in view for no longer, makes a change that is taken back, and room
/// where another line runs across one's extension lines makes such a crossing. Looks at the frames before and after, at
/// each for itself, with all other lines where they are, as the audit's slow searches see them.
class Odds {
public:
  /// Of one flight; `names` belong to `layouts` one to one. All must outlive this.
  Odds(const Model& model, const Scene& scene, std::span<const Layout> layouts, std::span<const FrameName> names)
      : model_(model), scene_(scene), layouts_(layouts), names_(names) {}

  /// A line of the parameter is inside in that frame though there is room outside (AuditRow::kNeedlesslyInside):
  /// whether there is no room clear of other lines (PlacesWanted::kClear), or for at most kTakenBackFrames, between
  /// frames of the same movement in which it is inside for want of it.
  [[nodiscard]] bool lacksLastingRoom(std::size_t parameter, std::size_t frame);

  /// The parameter is hidden in that frame though a feature of it is in plain view (AuditRow::kUnshown): whether one is
  /// for at most kTakenBackFrames, between frames of the same movement in which it is hidden and none is.
  [[nodiscard]] bool isBrieflyInView(std::size_t parameter, std::size_t frame);

  /// What changed in frame `changed` is as before again in frame `back` (AuditRow::kFlicker): whether both had to be.
  /// A line that comes has a feature in plain view, or comes out of the model; and it goes since there is no base line
  /// to show, or no room outside. Or the same the other way round.
  [[nodiscard]] bool hadToGoBack(std::size_t parameter, std::size_t changed, std::size_t back);

private:
  enum class Sort : std::uint8_t { kHidden, kInside, kOutside };
  [[nodiscard]] Sort sortIn(std::size_t frame, std::size_t parameter) const;
  [[nodiscard]] bool isLineOf(std::size_t parameter) const;
  /// Whether it is outside, or there is room of that sort for it there.
  [[nodiscard]] bool hasRoom(std::size_t frame, std::size_t parameter, PlacesWanted wanted);
  [[nodiscard]] bool isInPlainView(std::size_t frame, std::size_t parameter);
  /// Whether it is hidden for what its feature looks like, and not for want of room.
  [[nodiscard]] bool cannotBeShown(std::size_t frame, std::size_t parameter);
  /// Whether `holds` in at most kTakenBackFrames round that frame, and before and after them, in the same movement, the
  /// parameter is of one sort.
  template <typename Holds>
  [[nodiscard]] bool isBrief(std::size_t parameter, std::size_t frame, Holds holds) const;
  [[nodiscard]] AuditedFrame at(std::size_t frame);

  const Model& model_;
  const Scene& scene_;
  std::span<const Layout> layouts_;
  std::span<const FrameName> names_;
  MaskPicture mask_;
  DepthPicture depth_;
  std::optional<std::size_t> drawn_;  ///< the frame that the pictures are of
};

}  // namespace dimline
