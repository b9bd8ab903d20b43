#include "placement/labels.h"

#include <array>
#include <cmath>

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

Box2 boxAround(const Vec2& center, const Vec2& size) { return {center - size * 0.5, center + size * 0.5}; }

/// Shares of the way from a line's middle to either end at which a label is tried, in this order: in few large steps first, so that a label does not slide to and fro with what passes by, then between
/// them. More of them: fewer lines have no room for their label.
constexpr std::array kPlacesAlong = {0.0, -0.5, 0.5, -1.0, 1.0, -0.25, 0.25, -0.75, 0.75, -0.125, 0.125, -0.375, 0.375, -0.625, 0.625, -0.875, 0.875};

/// Tries places in order and keeps the first that has room.
class Search {
 public:
  Search(const LabelRequest& request, const Landed& landed, const Box2& viewport)
      : request_(request), landed_(landed), allowed_(viewport.grown(-kViewportMarginPx)) {}

  bool tryAt(const Vec2& center) {
    const Box2 box = boxAround(center, request_.textSize);
    if (box.min.x < allowed_.min.x || box.min.y < allowed_.min.y || box.max.x > allowed_.max.x || box.max.y > allowed_.max.y) {
      return false;
    }
    if (request_.model != nullptr && !clears(*request_.model, box.grown(kLabelClearancePx))) return false;
    if (!landed_.hasRoom(box, request_.overExtensions)) return false;
    found_ = box;
    return true;
  }
  [[nodiscard]] const std::optional<Box2>& found() const { return found_; }

 private:
  const LabelRequest& request_;
  const Landed& landed_;
  Box2 allowed_;
  std::optional<Box2> found_;
};

}  // namespace

double interruptedLengthPx(const Vec2& textSize, const Vec2& lineDirection) {
  return 2.0 * (reach(textSize * 0.5, lineDirection) + kLabelPaddingPx);
}

std::optional<Box2> placeLabel(const LabelRequest& request, const Landed& landed, const Box2& viewport) {
  // A line inside the model may run out of the picture; its label stays with the part that is seen.
  const auto visible = clipped(request.line, viewport.grown(-kViewportMarginPx));
  if (!visible) return std::nullopt;
  const double length = visible->length();
  const Vec2 direction = length > 0 ? (visible->end - visible->start) / length : Vec2(1, 0);
  const Vec2 half = request.textSize * 0.5;
  Search search(request, landed, viewport);

  const double room = 0.5 * (length - interruptedLengthPx(request.textSize, direction)) - kArrowLengthPx - kLabelPaddingPx;
  if (room >= 0) {
    for (const double share : kPlacesAlong) {
      if (search.tryAt(visible->middle() + direction * (share * room))) return search.found();
    }
  }
  if (!request.inChain) {
    const double beyond = reach(half, direction) + kArrowHalfWidthPx + kLabelPaddingPx;
    if (search.tryAt(request.line.end + direction * beyond)) return search.found();
    if (search.tryAt(request.line.start - direction * beyond)) return search.found();
  }

  Vec2 normal{-direction.y, direction.x};
  if (glm::dot(normal, request.outward) < 0) normal = -normal;
  const double beside = halfExtent(half, normal) + kArrowHalfWidthPx + kLabelPaddingPx;
  for (const double share : kPlacesAlong) {
    const Vec2 center = visible->middle() + direction * (share * 0.5 * length);
    if (search.tryAt(center + normal * beside) || search.tryAt(center - normal * beside)) return search.found();
  }
  return std::nullopt;
}

}  // namespace dimline
