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

/// At how many eighths of the way from a line's middle to either end a label is tried.
constexpr int kEighths = 8;

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

/// The places of a label on one line.
class Places {
 public:
  /// `line`: the part of it that is in the picture.
  Places(const LabelRequest& request, const Segment2& line, const Landed& landed, const Box2& viewport)
      : request_(request), line_(line), landed_(landed), allowed_(viewport.grown(-kViewportMarginPx)), length_(line.length()),
        direction_(length_ > 0 ? (line.end - line.start) / length_ : Vec2(1, 0)), normal_(-direction_.y, direction_.x),
        room_(0.5 * (length_ - interruptedLengthPx(request.textSize, direction_)) - kArrowLengthPx - kLabelPaddingPx) {
    if (glm::dot(normal_, request.outward) < 0) normal_ = -normal_;
  }

  [[nodiscard]] std::optional<LabelFound> tryAt(const LabelPlace& place) const {
    if (!exists(place)) return std::nullopt;
    const Box2 box = Box2::around(center(place), request_.textSize);
    if (!allowed_.contains(box)) return std::nullopt;
    if (!fellowsLeaveRoom(box) || !landed_.hasRoom(box, place.overExtensions)) return std::nullopt;
    if (request_.model != nullptr && !clears(*request_.model, box.grown(kLabelClearancePx))) return std::nullopt;
    return LabelFound{box, place};
  }

 private:
  [[nodiscard]] bool fellowsLeaveRoom(const Box2& label) const {
    const Box2 grown = label.grown(kLabelClearancePx);
    const auto isOwn = [&](const Segment2& line) { return line.start == request_.line.start && line.end == request_.line.end; };
    return std::ranges::none_of(request_.fellows, [&](const Segment2& line) { return meets(line, grown) && !isOwn(line); }) &&
           std::ranges::none_of(request_.fellowLabels, [&](const Box2& other) { return grown.overlaps(other); });
  }
  [[nodiscard]] bool exists(const LabelPlace& place) const {
    if (place.side == LabelPlace::Side::kOnLine) return room_ >= 0;
    // Beyond the ends of a chain's member lie others.
    return request_.fellows.size() < 2 || (place.side != LabelPlace::Side::kBeyondEnd && place.side != LabelPlace::Side::kBeyondStart);
  }
  [[nodiscard]] Vec2 center(const LabelPlace& place) const {
    const Vec2 half = request_.textSize * 0.5;
    const double beyond = reach(half, direction_) + kArrowHalfWidthPx + kLabelPaddingPx;
    const double beside = halfExtent(half, normal_) + kArrowHalfWidthPx + kLabelPaddingPx;
    const double share = static_cast<double>(place.eighth) / kEighths;
    switch (place.side) {
      case LabelPlace::Side::kOnLine: break;
      case LabelPlace::Side::kBeyondEnd: return request_.line.end + direction_ * beyond;
      case LabelPlace::Side::kBeyondStart: return request_.line.start - direction_ * beyond;
      case LabelPlace::Side::kOutward: return line_.middle() + direction_ * (share * 0.5 * length_) + normal_ * beside;
      case LabelPlace::Side::kInward: return line_.middle() + direction_ * (share * 0.5 * length_) - normal_ * beside;
    }
    return line_.middle() + direction_ * (share * room_);
  }

  const LabelRequest& request_;
  Segment2 line_;
  const Landed& landed_;
  Box2 allowed_;
  double length_;
  Vec2 direction_;
  Vec2 normal_;      ///< away from the model
  double room_;      ///< px, from the line's middle to the last place of a label that rides on it
};

}  // namespace

double interruptedLengthPx(const Vec2& textSize, const Vec2& lineDirection) {
  return 2.0 * (reach(textSize * 0.5, lineDirection) + kLabelPaddingPx);
}

std::optional<LabelFound> placeLabel(const LabelRequest& request, const Landed& landed, const Box2& viewport) {
  // A line inside the model may run out of the picture; its label stays with the part that is seen.
  const auto visible = clipped(request.line, viewport.grown(-kViewportMarginPx));
  if (!visible) return std::nullopt;
  const Places places(request, *visible, landed, viewport);
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
