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

/// In how many directions on screen a pill is moved out of the silhouette, in what steps and how far from there it looks for room, and then how far beyond all that has landed; and when
/// it stays inside, in how many rings around its anchor, how far apart, and in how many directions. Fewer: it is hidden as crowded where a person would see a place. Further: it stands too far from what
/// it belongs to.
constexpr int kPillWays = 24;
constexpr double kPillStepPx = 8.0;
constexpr double kPillFurtherPx = 200.0;
constexpr int kPillRings = 19;
constexpr double kPillRingPx = 0.5 * kPillHeightPx;
constexpr int kPillRingPlaces = 16;

/// Directions are alike within one of eight sides: a pill that moves among those is still where it was, but for the distance. More: it changes sides more often.
constexpr int kPillSides = 8;
constexpr int kWaysOfSide = kPillWays / kPillSides;

/// px. Shifts in search of room are whole numbers of this, so that before a still camera the place that was found is found again to the last bit.
constexpr double kShiftUnitPx = 0.125;

/// By less a score is not better than another: what is as good but for rounding would change places before a still camera.
constexpr double kBetter = 1e-6;

/// px. How far a pill goes on at least where it looks for the least shift, towards the viewport's edge and along it. More: it may stand as much further out than it must.
constexpr double kLeastShiftStepPx = 0.25;
constexpr double kSidewaysStepPx = 4.0;

double wholeUnits(double shift) { return std::ceil(shift / kShiftUnitPx) * kShiftUnitPx; }

/// A direction on screen: 0 is right, then clockwise in so many equal steps.
Vec2 compass(int number, int steps = kPillWays) {
  const double rad = 2 * std::numbers::pi * number / steps;
  return {std::cos(rad), std::sin(rad)};
}

int sideOf(int way) { return (way + kWaysOfSide / 2) / kWaysOfSide % kPillSides; }

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

/// A scope that a pill may stand at: its anchor on screen, and a box about that, in the viewport.
struct PillAnchor {
  std::size_t scope = 0;
  Vec2 anchor{0.0};
  Box2 box;
};

/// A place for a pill.
struct PillPlace {
  std::size_t scope = 0;
  Vec2 anchor{0.0};
  Box2 box;
  Identity identity;
  double score = 0;
};

void offer(const PillPlace& place, std::optional<PillPlace>& best) {
  if (!best || place.score > best->score + kBetter) best = place;
}

/// What it costs that the thread from a pill to its anchor runs across what has landed. In a movement pills would change sides for the sake of other threads, so there these cost what extension lines do.
double scoreThread(const Vec2& anchor, const Box2& box, const Landed& landed, bool settles) {
  if (box.contains(anchor)) return 0.0;
  const Landed::Across across = landed.across({anchor, box.center()});
  return across.lines * kScoreThreadOverLine + across.extensions * kScoreThreadOverExtension + across.threads * (settles ? kScoreThreadOverThread : kScoreThreadOverExtension) +
         across.labels * kScoreThreadOverLabel;
}

/// Whether a place is where the pill was in the last frame, or near that.
bool stays(const OtherHandle& handle, const PillPlace& place) {
  const Vec2 awayPx = place.box.center() - place.anchor;
  return handle.history.stays(place.identity, {awayPx, awayPx});
}

double scoreOutside(const OtherHandle& handle, const OtherHandleContext& context, const PillPlace& place) {
  const Vec2 middle = place.box.center();
  const bool near = stays(handle, place);
  const auto& last = handle.history.awayPx();
  const double movedPx = near && last ? glm::length(middle - place.anchor - last->start) : 0.0;
  double hysteresis = 0;
  if (handle.settles) {
    hysteresis = near ? -kScoreChangeSettling : 0.0;
  } else if (near) {
    hysteresis = kScorePillStays + kScoreDistance * movedPx;
  } else if (place.identity == handle.history.last()) {
    hysteresis = kScorePillStaysOnSide;
  } else if (handle.history.leftLately(place.identity)) {
    hysteresis = kScoreReturn;
  }
  return score({.base = {place.anchor, place.anchor}, .candidate = {middle, middle}, .align = handle.annotation.align, .sameAsLastFrame = near}) +
         hysteresis + scoreThread(place.anchor, place.box, context.landed, handle.settles);
}

/// Finds the places outside in one direction of a pill.
class WayOut {
 public:
  /// Places that score less than `enough` need not be found.
  WayOut(const OtherHandle& handle, const OtherHandleContext& context, const PillAnchor& at, int way, double enough)
      : handle_(handle), context_(context), at_(at), direction_(compass(way)), place_{at.scope, at.anchor, {}, identityOf(handle, context.scopes[at.scope], sideOf(way))} {
    const bool last = place_.identity == handle_.history.last();
    mostPx_ = glm::length(at.box.center() - at.anchor) + kScoreAlign + (last ? kScorePillStays + kScoreDamp : 0.0) - enough;
  }

  /// Hands to `use` the place nearest to the model, between it and its lines where there is room; and in the last frame's direction the one where the pill was, or somewhat nearer.
  template <typename Use>
  void forEachPlace(Use use) {
    const double least = leastShiftPx(context_.paddedModel, at_.box, direction_, mostPx_);
    if (!std::isfinite(least)) return;
    const double nearest = wholeUnits(least);
    if (findRoom(nearest)) use(place_);
    if (!handle_.history.awayPx() || place_.identity != handle_.history.last()) return;
    const Vec2 last = at_.anchor + handle_.history.awayPx()->start - at_.box.center();
    if (std::abs(direction_.x * last.y - direction_.y * last.x) > kShiftUnitPx) return;   // in another direction
    const double lastShift = std::round(glm::dot(last, direction_) / kShiftUnitPx) * kShiftUnitPx;
    const double shift = lastShift - (handle_.viewMoved ? kRelaxPx : 0.0);
    if (shift > nearest && findRoomBelow(shift + kPillFurtherPx, shift)) use(place_);
  }

 private:
  /// The first place from the nearest on that has room: near the model, or else beyond all that has landed.
  bool findRoom(double nearest) {
    if (findRoomBelow(nearest + kPillFurtherPx, nearest)) return true;
    const double clearOfAll = wholeUnits(leastShiftPx(context_.padded, at_.box, direction_, mostPx_));
    return findRoomBelow(clearOfAll + kPillFurtherPx, clearOfAll);
  }
  bool findRoomBelow(double most, double shift) {
    for (; shift < std::min(most, mostPx_); shift += kPillStepPx) {
      place_.box = shifted(at_.box, direction_ * shift);
      if (!onScreen(place_.box, context_.view)) return false;
      if (!clears(context_.paddedModel, place_.box) || !context_.landed.hasRoom(place_.box)) continue;
      place_.score = scoreOutside(handle_, context_, place_);
      return true;
    }
    return false;
  }

  const OtherHandle& handle_;
  const OtherHandleContext& context_;
  const PillAnchor& at_;
  Vec2 direction_;
  PillPlace place_;
  double mostPx_ = 0;   ///< further out it scores less than is enough
};

/// The best place inside: at the anchor, or on rings around it, in the viewport and clear of all that has landed.
void offerInside(const OtherHandle& handle, const OtherHandleContext& context, const PillAnchor& at, std::optional<PillPlace>& best) {
  PillPlace place{at.scope, at.anchor, {}, identityOf(handle, context.scopes[at.scope], -1)};
  const double mostPx = glm::length(at.box.center() - at.anchor) + (place.identity == handle.history.last() ? kScoreStay : 0.0);
  for (int ring = 0; ring < kPillRings; ++ring) {
    if (best && mostPx - ring * kPillRingPx < best->score) return;   // none from here on can be better
    for (int number = 0; number < (ring == 0 ? 1 : kPillRingPlaces); ++number) {
      place.box = shifted(at.box, compass(number, kPillRingPlaces) * (ring * kPillRingPx));
      if (!onScreen(place.box, context.view) || !context.landed.hasRoom(place.box)) continue;
      const Vec2 awayPx = place.box.center() - place.anchor;
      place.score = handle.history.bonus(place.identity, {awayPx, awayPx}) - glm::length(awayPx) + scoreThread(place.anchor, place.box, context.landed, handle.settles);
      offer(place, best);
    }
  }
}

/// Whether a box outside is still in the viewport when the picture has grown by kBriefZoom about its middle.
bool lastsNearing(const Box2& box, const View& view) {
  return onScreen(shifted(box, (box.center() - view.viewport().center()) * std::expm1(kBriefZoom)), view);
}

/// Whether a place outside is another than where the pill was in the last frame, and worse than any inside: it would be lost soon because the camera comes nearer, or its thread would lead so far across the
/// picture that nobody sees what the pill belongs to.
bool isLastResort(const OtherHandle& handle, const OtherHandleContext& context, const PillPlace& outside) {
  if (stays(handle, outside)) return false;
  const bool far = glm::length(outside.box.center() - outside.anchor) > kLongestThreadShare * std::min(context.view.widthPx(), context.view.heightPx());
  return far || (handle.firm && handle.nearing && handle.history.any() && !lastsNearing(outside.box, context.view));
}

/// Whether a place outside is taken whatever there is inside.
bool comesAnyway(const OtherHandle& handle, const PillPlace& outside) {
  return !handle.history.wasInside() && !handle.history.hiddenForWantOfRoom() && !handle.history.leftLately(outside.identity);
}

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

double leastShiftPx(const DistanceFields& fields, const Box2& box, const Vec2& direction, double mostPx) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  double least = mostPx;
  // Where it moves towards an edge it soon clears that one's field, and need not look much further at the others.
  for (const bool nearing : {true, false}) {
    for (const ViewportEdge edge : kViewportEdges) {
      if ((towards(edge, direction) > kStandsStill) == nearing) least = std::min(least, leastShiftPx(fields, edge, box, direction, least));
    }
  }
  return least < mostPx ? least : kNowhere;
}

double pillWorth(const PlacedHandle& pill, const Annotation& annotation, const Landed& landed) {
  const Vec2 middle = pill.box.center();
  const double inside = pill.placement == PlacementKind::kInside ? kScoreInside : 0.0;
  return inside + score({.base = {pill.anchor, pill.anchor}, .candidate = {middle, middle}, .align = annotation.align}) + scoreThread(pill.anchor, pill.box, landed, true);
}

Vec2 pillSizePx(const Parameter& parameter) {
  double width = textWidthPx(parameter.title, kLabelFontSizePx);
  for (const std::string& choice : parameter.choices) width = std::max(width, textWidthPx(choice, kLabelFontSizePx));
  return {width + kPillExtraWidthPx, kPillHeightPx};
}

std::optional<HiddenReason> placePill(const OtherHandle& handle, const OtherHandleContext& context, PlacedHandle& placed) {
  const Vec2 size = pillSizePx(handle.definition);
  bool anchored = false;   // an anchor is in the viewport
  // The last frame's comes first, so that the others need be looked at only where they may be better; and so with the directions.
  const auto last = std::ranges::find(handle.scopes, handle.history.last().scopeIndex, [&](std::size_t scope) { return static_cast<std::int32_t>(context.scopes[scope].index); });
  const auto first = static_cast<std::size_t>(last == handle.scopes.end() ? 0 : last - handle.scopes.begin());
  const auto forEachAnchor = [&](auto use) {
    for (std::size_t i = 0; i < handle.scopes.size(); ++i) {
      const std::size_t scope = handle.scopes[(first + i) % handle.scopes.size()];
      const Vec3 world = anchorOf(handle.annotation, context.scopes[scope].box);
      if (!context.view.inFrontOfNear(world)) continue;
      const Vec2 anchor = context.view.toScreen(world);
      if (!onScreen(Box2{anchor, anchor}, context.view)) continue;
      anchored = true;
      use({scope, anchor, shiftedInto(Box2::around(anchor, size), context.view.viewport())});
    }
  };
  std::optional<PillPlace> outside;
  std::optional<PillPlace> lastResort;   // outside too
  forEachAnchor([&](const PillAnchor& at) {
    if (handle.annotation.slip == Slip::kNone) return;
    const int firstWay = std::max<int>(handle.history.last().plane, 0) * kWaysOfSide + kPillWays - kWaysOfSide / 2;
    for (int i = 0; i < kPillWays; ++i) {
      const double enough = outside ? outside->score : -std::numeric_limits<double>::infinity();
      WayOut wayOut(handle, context, at, (firstWay + i) % kPillWays, enough);
      wayOut.forEachPlace([&](const PillPlace& place) { offer(place, isLastResort(handle, context, place) ? lastResort : outside); });
    }
  });
  std::optional<PillPlace> inside;
  if (!outside || !comesAnyway(handle, *outside)) forEachAnchor([&](const PillAnchor& at) { offerInside(handle, context, at, inside); });
  const auto place = choose(handle, inside, outside || inside ? outside : lastResort);
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
