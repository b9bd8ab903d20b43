#include "placement/pills.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "placement/label_text.h"
#include "placement/on_screen.h"
#include "placement/score.h"
#include "placement/text_metrics.h"

namespace dimline {

namespace {

/// In how many directions on screen a pill is moved out of the silhouette, and how far beyond the least shift it looks for room; and when it stays inside, in how many rings around its anchor, how far apart, and in how many directions. Fewer: it is
/// hidden as crowded where a person would see a place. Further: it stands too far from what it belongs to.
constexpr int kPillWays = 8;
constexpr double kPillStepPx = 8.0;
constexpr int kPillSteps = 25;
constexpr int kPillRings = 19;
constexpr double kPillRingPx = 0.5 * kPillHeightPx;
constexpr int kPillRingPlaces = 16;

/// px. How far a pill goes on at least where it looks for the least shift, towards the viewport's edge and along it. More: it may stand as much further out than it must.
constexpr double kLeastShiftStepPx = 0.25;
constexpr double kSidewaysStepPx = 4.0;

/// A direction on screen: 0 is right, then clockwise in so many equal steps.
Vec2 compass(int number, int steps = kPillWays) {
  const double rad = 2 * std::numbers::pi * number / steps;
  return {std::cos(rad), std::sin(rad)};
}

/// The middle of a scope's face in the direction of `orient`.
Vec3 anchorOf(const Annotation& annotation, const Obb& scope) {
  Vec3 uvw = Vec3(0.5) + annotation.translate;
  const AxisSense along = axisOf(annotation.orient);
  if (along.axis >= 0) uvw[along.axis] += 0.5 * along.sense;
  return scope.at(uvw);
}

/// How far a unit direction leads towards a viewport edge; what is not above kStandsStill is rounding.
constexpr double kStandsStill = 1e-9;
double towards(ViewportEdge edge, const Vec2& direction) {
  switch (edge) {
    case ViewportEdge::kLeft: return -direction.x;
    case ViewportEdge::kRight: return direction.x;
    case ViewportEdge::kTop: return -direction.y;
    case ViewportEdge::kBottom: return direction.y;
  }
  return 0;
}

/// The shift at which one field is cleared; infinity when it is none below `mostPx`. Moving on changes the strips under the box, which may ask for more; each round goes as far as the
/// strips seen so far ask, so it only grows.
double leastShiftPx(const DistanceFields& fields, ViewportEdge edge, const Box2& box, const Vec2& direction, double mostPx) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const bool rows = edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight;
  const int away = rows ? 0 : 1;
  const int along = 1 - away;
  const bool fromLow = edge == ViewportEdge::kLeft || edge == ViewportEdge::kTop;
  const double towardsEdge = towards(edge, direction);
  const double farSide = fromLow ? box.max[away] : fields.extentPx(edge) - box.min[away];
  const bool moves = std::abs(direction[along]) > kStandsStill;
  const DistanceField& field = fields[edge];
  const double end = static_cast<double>(field.size());
  double shift = 0;
  while (shift < mostPx) {
    const double low = box.min[along] + shift * direction[along];
    const double high = box.max[along] + shift * direction[along];
    if (!(low >= 0 && high <= end)) return kNowhere;
    const auto first = static_cast<std::size_t>(std::min(std::floor(low), end - 1));
    const auto last = static_cast<std::size_t>(std::clamp(std::ceil(high) - 1, static_cast<double>(first), end - 1));
    const double needed = farSide - shift * towardsEdge - static_cast<double>(field.min(first, last));
    if (needed <= 1e-9) return shift;
    if (towardsEdge > kStandsStill) {
      shift += std::max(needed / towardsEdge, kLeastShiftStepPx);
    } else if (moves) {
      shift += kSidewaysStepPx / std::abs(direction[along]);   // only other strips can help
    } else {
      return kNowhere;
    }
  }
  return kNowhere;
}

Box2 shifted(const Box2& box, const Vec2& by) { return {box.min + by, box.max + by}; }

/// The box, moved into the viewport's margin by the shortest way.
Box2 shiftedInto(const Box2& box, const Box2& viewport) {
  const Box2 allowed = viewport.grown(-kViewportMarginPx);
  Vec2 by{0.0};
  for (int axis = 0; axis < 2; ++axis) {
    by[axis] = std::max(allowed.min[axis] - box.min[axis], 0.0) + std::min(allowed.max[axis] - box.max[axis], 0.0);
  }
  return shifted(box, by);
}

/// The first place outside in a direction on screen, from the least shift on in steps, that all that has landed leaves free; nothing when there is none in the
/// viewport.
std::optional<Box2> roomTowards(const Box2& from, const Vec2& direction, const OtherHandleContext& context) {
  double shift = leastShiftPx(context.padded, from, direction);
  if (!std::isfinite(shift)) return std::nullopt;
  for (int step = 0; step < kPillSteps; ++step, shift += kPillStepPx) {
    const Box2 box = shifted(from, direction * shift);
    if (!onScreen(box, context.view)) return std::nullopt;
    if (clears(context.padded, box) && context.landed.hasRoom(box)) return box;
  }
  return std::nullopt;
}

/// The box, or the nearest place on rings around it, that is in the viewport and that all that has landed leaves free.
std::optional<Box2> roomAround(const Box2& box, const OtherHandleContext& context) {
  for (int ring = 0; ring < kPillRings; ++ring) {
    for (int number = 0; number < (ring == 0 ? 1 : kPillRingPlaces); ++number) {
      const Box2 place = shifted(box, compass(number, kPillRingPlaces) * (ring * kPillRingPx));
      if (onScreen(place, context.view) && context.landed.hasRoom(place)) return place;
    }
  }
  return std::nullopt;
}

/// A place for a pill.
struct PillPlace {
  std::size_t scope = 0;
  Vec2 anchor{0.0};
  Box2 box;
  Identity identity;
  double score = 0;
};

void offer(const PillPlace& place, std::optional<PillPlace>& best) {
  if (!best || place.score > best->score) best = place;
}

double scoreOutside(const OtherHandle& handle, const OtherHandleContext& context, const PillPlace& place) {
  const Vec2 tip = place.box.center() - compass(place.identity.plane) * (0.5 * (place.box.max.y - place.box.min.y));
  const Segment2 anchor{place.anchor, place.anchor};
  const Landed::Crossings crossings = context.landed.crossings(anchor, anchor, {tip, tip});
  return score({.base = anchor,
                .candidate = {place.box.center(), place.box.center()},
                .align = handle.annotation.align,
                .sameAsLastFrame = place.identity == handle.history.last(),
                .intersects = crossings.lines}) +
         handle.history.bonus(place.identity) + (crossings.labels ? kScoreCoversLabel : 0.0);
}

/// Whether a box outside is still in the viewport when the picture has grown by kBriefZoom about its middle.
bool lastsNearing(const Box2& box, const View& view) {
  return onScreen(shifted(box, (box.center() - view.viewport().center()) * std::expm1(kBriefZoom)), view);
}

/// Whether a place outside is another than the last frame's, and would be lost soon because the camera comes nearer.
bool isBrief(const OtherHandle& handle, const OtherHandleContext& context, const PillPlace& outside) {
  return handle.firm && handle.nearing && handle.history.any() && outside.identity != handle.history.last() && !lastsNearing(outside.box, context.view);
}

/// Whether a place outside is taken, or waited for, whatever there is inside.
bool comesAnyway(const OtherHandle& handle, const PillPlace& outside) { return !handle.history.wasInside() && !handle.history.leftLately(outside.identity); }

/// A place outside beats any inside, as for lines, but for one that was left a moment ago. What had no room, or was inside, waits until a better kind of place has been there for
/// some frames; and while the camera comes nearer, what is inside stays there.
std::optional<PillPlace> choose(const OtherHandle& handle, const std::optional<PillPlace>& inside, const std::optional<PillPlace>& outside) {
  History& history = handle.history;
  const bool returns = outside && history.leftLately(outside->identity);
  const bool stays = history.wasInside() && handle.firm && handle.nearing;
  if (inside && (returns || stays)) return inside;
  const std::optional<PillPlace>& best = outside ? outside : inside;
  const bool better = best && (history.hiddenForWantOfRoom() || (history.wasInside() && inside && outside));
  if (!better || history.betterIsThere() || !handle.firm) return best;
  return history.wasInside() ? inside : std::nullopt;
}

/// Where the options of a range are offered: in a column under the pill, or over it when there is no room below.
void placeOptions(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed) {
  const auto& choices = handle.definition.choices;
  const double height = placed.box.max.y - placed.box.min.y;
  const double below = placed.box.max.y + height * static_cast<double>(choices.size());
  const bool up = below > context.view.heightPx() && placed.box.min.y > context.view.heightPx() * 0.5;
  placed.options.resize(choices.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const double step = height * static_cast<double>(i + 1);
    const Vec2 offset{0, up ? -step : step};
    placed.options[i].value = static_cast<double>(i);
    placed.options[i].text = choices[i];
    placed.options[i].box = shifted(placed.box, offset);
  }
}

}  // namespace

double leastShiftPx(const DistanceFields& fields, const Box2& box, const Vec2& direction) {
  double least = std::numeric_limits<double>::infinity();
  // Where it moves towards an edge it soon clears that one's field, and need not look much further at the others.
  for (const bool nearing : {true, false}) {
    for (const ViewportEdge edge : kViewportEdges) {
      if ((towards(edge, direction) > kStandsStill) == nearing) least = std::min(least, leastShiftPx(fields, edge, box, direction, least));
    }
  }
  return least;
}

Vec2 pillSizePx(const Parameter& parameter) {
  double width = textWidthPx(parameter.title, kLabelFontSizePx);
  for (const std::string& choice : parameter.choices) width = std::max(width, textWidthPx(choice, kLabelFontSizePx));
  return {width + kPillExtraWidthPx, kPillHeightPx};
}

std::optional<HiddenReason> placePill(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed) {
  const Vec2 size = pillSizePx(handle.definition);
  bool anchored = false;   // an anchor is in the viewport
  const auto forEachAnchor = [&](auto use) {
    for (const std::size_t scope : handle.scopes) {
      const Vec3 world = anchorOf(handle.annotation, context.scopes[scope].box);
      if (!context.view.inFrontOfNear(world)) continue;
      const Vec2 anchor = context.view.toScreen(world);
      if (!onScreen(Box2{anchor, anchor}, context.view)) continue;
      anchored = true;
      use(scope, anchor, shiftedInto(Box2::around(anchor, size), context.view.viewport()));
    }
  };
  std::optional<PillPlace> outside;
  std::optional<PillPlace> brief;   // outside too, but worse than any inside
  forEachAnchor([&](std::size_t scope, const Vec2& anchor, const Box2& atAnchor) {
    if (handle.annotation.slip == Slip::kNone) return;
    for (int way = 0; way < kPillWays; ++way) {
      const auto box = roomTowards(atAnchor, compass(way), context);
      if (!box) continue;
      PillPlace place{scope, anchor, *box, identityOf(handle, context.scopes[scope], way)};
      place.score = scoreOutside(handle, context, place);
      offer(place, isBrief(handle, context, place) ? brief : outside);
    }
  });
  std::optional<PillPlace> inside;
  if (!outside || !comesAnyway(handle, *outside)) {
    forEachAnchor([&](std::size_t scope, const Vec2& anchor, const Box2& atAnchor) {
      const auto box = roomAround(atAnchor, context);
      if (!box) return;
      const Identity identity = identityOf(handle, context.scopes[scope], -1);
      offer({scope, anchor, *box, identity, handle.history.bonus(identity) - glm::length(box->center() - anchor)}, inside);
    });
  }
  const auto place = choose(handle, inside, outside || inside ? outside : brief);
  if (!place) return anchored ? HiddenReason::kCrowded : HiddenReason::kOutOfView;
  placed.scope = place->scope;
  placed.anchor = place->anchor;
  placed.box = place->box;
  placed.placement = place->identity.plane < 0 ? PlacementKind::kInside : PlacementKind::kOutside;
  placed.identity = place->identity;
  placed.parameter = handle.parameter;
  placed.type = handle.annotation.type;
  placed.value = handle.value;
  placed.text = labelText(handle.definition, handle.value);
  placed.arc.reset();
  placed.handles.clear();
  placed.handles.push_back({true, placed.box.center()});
  if (handle.annotation.type == HandleType::kRange) {
    placeOptions(handle, context, placed);
  } else {
    placed.options.clear();
  }
  return std::nullopt;
}

}  // namespace dimline
