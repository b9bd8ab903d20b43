#pragma once

#include <optional>
#include <span>

#include "placement/label_memory.h"
#include "placement/look_ahead.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Where the text of a line goes: upright, riding on the line, which is interrupted for it; when the line
/// is too short for that, beyond one of its ends or beside its middle.
///
///        |<----- 2.40 m ----->|        |<->| 2.40 m        2.40 m
///                                                          |<->|
struct LabelRequest {
  Segment2 line;                  ///< px, the final line
  Vec2 textSize{0.0};             ///< px, without padding
  Vec2 outward{0.0};              ///< screen direction from the model to the line; zero when inside
  const DistanceFields* model = nullptr;   ///< the label clears these fields; null when the line lies inside the model
  bool overExtensions = false;    ///< extension lines may run under it
  int parameter = Landed::kNobody;              ///< whose lines have landed already: they count as fellows alone, their extension lines like any others, and other things may be a hair (1 px) nearer
  std::optional<LabelPlace::Side> side = {};    ///< the label goes nowhere else, and
  bool centred = false;                         ///< there to the line's middle alone
  std::span<const Segment2> fellows = {};       ///< px, the lines of its chain, this one among them, and
  std::span<const Box2> fellowLabels = {};      ///< their labels so far: to be kept clear of as well
  const LookAhead* ahead = nullptr;   ///< the label keeps off what is ahead where it can
  bool orNone = false;                ///< where it cannot there shall be none, unless it stays where it was; nor one that was left out just now: others of its chain say the same
  std::optional<LastLabelPlace> last = {};
};

struct LabelFound {
  Box2 box;           ///< px
  LabelPlace place;
};

/// The first place with room, in the order of preference: the middle of the line, along it, beyond its end, beyond its start, beside its middle, beside it further along; and of those the first that leaves
/// room for what is ahead, if there is one. Within the viewport's margin, clear of the model and of all that has landed. A label stays where it was if it can or, as long as it may not leave, goes along the
/// line as little as it must; one that may leave does so only for a place that leaves room for what is ahead. Nothing when there is no place.
std::optional<LabelFound> placeLabel(const LabelRequest& request, const Landed& landed, const Box2& viewport);

/// Whether the label of a line that is in the viewport would have room there, were nothing else in the picture: on the line, beyond one of its ends, or beside it on the side that `outward` (px, a direction) leads to.
bool labelFits(const Segment2& line, const Vec2& textSize, const Vec2& outward, const Box2& viewport);

/// Whether a line is so long that its label can ride on it.
bool carriesLabel(const Segment2& line, const Vec2& textSize);

/// Length (px) of a line that its label covers when it rides on it.
double interruptedLengthPx(const Vec2& textSize, const Vec2& lineDirection);

}  // namespace dimline
