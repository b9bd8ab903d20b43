#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/audit_depth.h"
#include "cli/audit_pixels.h"
#include "model/model.h"
#include "placement/layout.h"

// Slow searches for what the placer should have found: lines are moved in small steps over their planes, projected, and
// held against the mask's pixels and what else is drawn. Where they may go is in audit_planes.h.
namespace dimline {

class Odds;

/// One frame as the audit sees it. The scene is the layout's; the pictures are of its view.
struct AuditedFrame {
  const Model* model = nullptr;
  const Scene* scene = nullptr;
  const Layout* layout = nullptr;
  MaskPicture* mask = nullptr;
  const DepthPicture* depth = nullptr;
  Odds* odds = nullptr;     ///< of the flight that the frame is of; null: nothing is asked of frames before and after
  std::size_t number = 0;   ///< there
};

/// How many times as far as need be the line of that number in the layout lies from its base line (AuditRow::kOffset);
/// nothing for lines that row leaves out. 1 when no lesser offset will do.
std::optional<double> offsetRatio(const AuditedFrame& frame, std::size_t line);

/// A place for a line outside.
struct OutsidePlace {
  Segment2 screen;
  bool seesAnEdge = false;  ///< all of it is visible straight from one edge of the viewport
};
/// Which places are looked for: all that there is room for, or only those where no other line would run across one's
/// extension lines (AuditRow::kExtensionCrossings). That one runs across those of others makes it no place at all.
enum class PlacesWanted : std::uint8_t { kAll, kClear };
/// A place where the line of that number, which lies inside, could be outside (AuditRow::kNeedlesslyInside).
std::optional<OutsidePlace> outsidePlace(const AuditedFrame& frame, std::size_t line,
                                         PlacesWanted wanted = PlacesWanted::kAll);

/// Whether two lines inside that cross, or lie on each other, have no other way: each base line of the one in view, of a
/// visible scope, crosses or lies on each of the other's. False unless both are of the linear types.
bool mustCross(const AuditedFrame& frame, std::size_t one, std::size_t other);

/// The scope of a parameter that is in plain view (AuditRow::kUnshown): its index in the scene. `frame.depth` must be
/// there.
std::optional<std::size_t> scopeInPlainView(const AuditedFrame& frame, std::size_t parameter);

}  // namespace dimline
