#include "placement/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dimline {

namespace {

/// How far along a unit direction the border of a box lies from its middle.
double reach(const Vec2& halfSize, const Vec2& direction) {
  const double dx = std::abs(direction.x);
  const double dy = std::abs(direction.y);
  const double alongX = dx > 0 ? halfSize.x / dx : std::numeric_limits<double>::infinity();
  const double alongY = dy > 0 ? halfSize.y / dy : std::numeric_limits<double>::infinity();
  return std::min(alongX, alongY);
}

/// Half the extent of a box at right angles to a line of the given normal.
double halfExtent(const Vec2& halfSize, const Vec2& normal) {
  return halfSize.x * std::abs(normal.x) + halfSize.y * std::abs(normal.y);
}

/// From the middle of a line of that length to the last place of a label that rides on it; negative when it is too short for that.
double roomAlongPx(double length, const Vec2& textSize, const Vec2& direction) {
  return 0.5 * (length - interruptedLengthPx(textSize, direction)) - kArrowLengthPx - kLabelPaddingPx;
}

/// At how many eighths of the way from a line's middle to either end a label is tried.
constexpr int kEighths = 8;

/// px. What has landed since keeps as far from a label as the fields tell, which know it by whole strips: by so much less at most.
constexpr double kLabelSlackPx = 1.0;

/// All places in the order of preference. Along the line in few large steps first, so that a label does not slide to and fro with what passes by, then between them. More of them: fewer lines have no room
/// for their label.
constexpr auto kOrder = [] {
  using enum LabelPlace::Side;
  constexpr std::array<std::int8_t, 2 * kEighths + 1> kAlong = {0, -4, 4, -8, 8, -2, 2, -6, 6, -1, 1, -3, 3, -5, 5, -7, 7};
  std::array<LabelPlace, 3 * kAlong.size() + 2> order;
  auto next = order.begin();
  for (const std::int8_t eighth : kAlong) *next++ = {.side = kOnLine, .eighth = eighth};
  *next++ = {.side = kBeyondEnd};
  *next++ = {.side = kBeyondStart};
  for (const std::int8_t eighth : kAlong) {
    *next++ = {.side = kOutward, .eighth = eighth};
    *next++ = {.side = kInward, .eighth = eighth};
  }
  return order;
}();

/// The places of a label on one line, were nothing else in the picture.
class Places {
 public:
  /// `whole`: the line, px; `seen`: the part of it that is in the picture. `outward`: px, which of its sides is away from the model; zero inside.
  Places(const Segment2& whole, const Segment2& seen, const Vec2& textSize, const Vec2& outward, const Box2& viewport)
      : whole_(whole), seen_(seen), textSize_(textSize), allowed_(viewport.grown(-kViewportMarginPx)), length_(seen.length()),
        direction_(length_ > 0 ? (seen.end - seen.start) / length_ : Vec2(1, 0)), normal_(-direction_.y, direction_.x),
        room_(roomAlongPx(length_, textSize, direction_)) {
    if (glm::dot(normal_, outward) < 0) normal_ = -normal_;
  }

  /// The label there; nothing when it leaves the viewport's margin, or the line is too short for it to ride on.
  [[nodiscard]] std::optional<Box2> at(const LabelPlace& place) const {
    if (place.side == LabelPlace::Side::kOnLine && room_ < 0) return std::nullopt;
    const Box2 box = Box2::around(center(place), textSize_);
    return allowed_.contains(box) ? std::optional(box) : std::nullopt;
  }

 private:
  [[nodiscard]] Vec2 center(const LabelPlace& place) const {
    const Vec2 half = textSize_ * 0.5;
    const double beyond = reach(half, direction_) + kArrowHalfWidthPx + kLabelPaddingPx;
    const double beside = halfExtent(half, normal_) + kArrowHalfWidthPx + kLabelPaddingPx;
    const double share = static_cast<double>(place.eighth) / kEighths;
    switch (place.side) {
      case LabelPlace::Side::kOnLine: break;
      case LabelPlace::Side::kBeyondEnd: return whole_.end + direction_ * beyond;
      case LabelPlace::Side::kBeyondStart: return whole_.start - direction_ * beyond;
      case LabelPlace::Side::kOutward: return seen_.middle() + direction_ * (share * 0.5 * length_) + normal_ * beside;
      case LabelPlace::Side::kInward: return seen_.middle() + direction_ * (share * 0.5 * length_) - normal_ * beside;
    }
    return seen_.middle() + direction_ * (share * room_);
  }

  Segment2 whole_;
  Segment2 seen_;
  Vec2 textSize_;
  Box2 allowed_;
  double length_;
  Vec2 direction_;
  Vec2 normal_;      ///< away from the model
  double room_;      ///< px, from the line's middle to the last place of a label that rides on it
};

/// Those of them that what else there is leaves free.
class FreePlaces {
 public:
  /// `seen`: the part of the line that is in the picture.
  FreePlaces(const LabelRequest& request, const Segment2& seen, const Landed& landed, const Box2& viewport)
      : request_(request), places_(request.line, seen, request.textSize, request.outward, viewport), landed_(landed) {}

  [[nodiscard]] std::optional<LabelFound> tryAt(const LabelPlace& place) const {
    // Beyond the ends of a chain's member lie others.
    const bool beyond = place.side == LabelPlace::Side::kBeyondEnd || place.side == LabelPlace::Side::kBeyondStart;
    if (beyond && request_.fellows.size() > 1) return std::nullopt;
    if ((request_.side && place.side != *request_.side) || (request_.centred && place.eighth != 0)) return std::nullopt;
    const auto box = places_.at(place);
    const double slackPx = request_.parameter != Landed::kNobody ? kLabelSlackPx : 0.0;
    if (!box || !fellowsLeaveRoom(*box) || !landed_.hasRoom(box->grown(-slackPx), place.overExtensions, request_.parameter)) return std::nullopt;
    if (request_.model != nullptr && !clears(*request_.model, box->grown(kLabelClearancePx))) return std::nullopt;
    return LabelFound{*box, place};
  }

 private:
  [[nodiscard]] bool fellowsLeaveRoom(const Box2& label) const {
    const Box2 grown = label.grown(kLabelClearancePx);
    const auto isOwn = [&](const Segment2& line) { return line.start == request_.line.start && line.end == request_.line.end; };
    return std::ranges::none_of(request_.fellows, [&](const Segment2& line) { return meets(line, grown) && !isOwn(line); }) &&
           std::ranges::none_of(request_.fellowLabels, [&](const Box2& other) { return grown.overlaps(other); });
  }

  const LabelRequest& request_;
  Places places_;
  const Landed& landed_;
};

}  // namespace

double interruptedLengthPx(const Vec2& textSize, const Vec2& lineDirection) {
  return 2.0 * (reach(textSize * 0.5, lineDirection) + kLabelPaddingPx);
}

bool carriesLabel(const Segment2& line, const Vec2& textSize) {
  const double length = line.length();
  return length > 0 && roomAlongPx(length, textSize, (line.end - line.start) / length) >= 0;
}

bool labelFits(const Segment2& line, const Vec2& textSize, const Vec2& outward, const Box2& viewport) {
  const Places places(line, line, textSize, outward, viewport);
  return std::ranges::any_of(kOrder, [&](const LabelPlace& place) { return place.side != LabelPlace::Side::kInward && places.at(place); });
}

std::optional<LabelFound> placeLabel(const LabelRequest& request, const Landed& landed, const Box2& viewport) {
  // A line inside the model may run out of the picture; its label stays with the part that is seen.
  const auto visible = clipped(request.line, viewport.grown(-kViewportMarginPx));
  if (!visible) return std::nullopt;
  const FreePlaces places(request, *visible, landed, viewport);
  const bool mayLeave = request.last && request.last->mayLeave;
  const std::optional<LabelPlace> last = request.last ? request.last->place : std::nullopt;
  const bool wasLeftOut = request.last && !last;
  if (request.orNone && wasLeftOut && !mayLeave) return std::nullopt;
  if (last && !mayLeave) {
    if (auto found = places.tryAt(*last)) return found;
  }
  std::optional<LabelFound> inTheWay;   // of what is ahead
  const auto tryAt = [&](LabelPlace place) -> std::optional<LabelFound> {
    place.overExtensions = request.overExtensions;
    const auto found = places.tryAt(place);
    if (!found || request.ahead == nullptr || request.ahead->leavesRoom(found->box)) return found;
    if (!inTheWay) inTheWay = found;
    return std::nullopt;
  };
  // Where something is in its way now it goes as little along the line as it can.
  const bool alongLine = last && !mayLeave && last->side == LabelPlace::Side::kOnLine;
  for (int by = 0; alongLine && by <= 2 * kEighths; ++by) {
    LabelPlace place = *last;
    for (const int sense : {-1, 1}) {
      const int eighth = last->eighth + sense * by;
      if (std::abs(eighth) > kEighths || (by == 0 && sense > 0)) continue;
      place.eighth = static_cast<std::int8_t>(eighth);
      if (auto found = tryAt(place)) return found;
    }
  }
  for (const LabelPlace& place : kOrder) {
    if (auto found = tryAt(place)) return found;
  }
  if (request.orNone) return std::nullopt;
  if (last && mayLeave && request.ahead != nullptr) {
    if (auto found = places.tryAt(*last)) return found;
  }
  return inTheWay;
}

}  // namespace dimline
