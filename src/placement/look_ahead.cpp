#include "placement/look_ahead.h"

#include <algorithm>
#include <cmath>

namespace dimline {

namespace {

/// px. Lines stand exactly handleSpacing apart; what is compared with that must not hang on rounding.
constexpr double kSlackPx = 1.0;

unsigned bit(ViewportEdge edge) { return 1U << static_cast<unsigned>(edge); }

/// Whether a segment, grown by `growPx`, comes anywhere between a viewport edge and a line, by more than `byPx`.
bool standsBefore(const Segment2& s, double growPx, ViewportEdge edge, const Segment2& line, double byPx = 0) {
  const bool rows = edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight;
  const int away = rows ? 0 : 1;
  const int along = 1 - away;
  const double sign = edge == ViewportEdge::kLeft || edge == ViewportEdge::kTop ? 1.0 : -1.0;
  const double from = std::max(std::min(line.start[along], line.end[along]), std::min(s.start[along], s.end[along]) - growPx);
  const double to = std::min(std::max(line.start[along], line.end[along]), std::max(s.start[along], s.end[along]) + growPx);
  if (from > to) return false;
  const auto distanceAt = [&](const Segment2& of, double at) {
    const double run = of.end[along] - of.start[along];
    if (std::abs(run) < 1.0) return std::min(sign * of.start[away], sign * of.end[away]);
    return sign * (of.start[away] + (of.end[away] - of.start[away]) * std::clamp((at - of.start[along]) / run, 0.0, 1.0));
  };
  return distanceAt(s, from) - growPx + byPx < distanceAt(line, from) || distanceAt(s, to) - growPx + byPx < distanceAt(line, to);
}

}  // namespace

void LookAhead::Lines::begin(bool changed) {
  if (changed) std::swap(past, present);
  present.reserve(past.capacity());   // they change places: what one has room for the other needs as well
  present.clear();
}

void LookAhead::Lines::forgetAhead(std::size_t ranks) {
  ahead.clear();
  marks.resize(ranks);
}

void LookAhead::begin(bool changed, bool shown) {
  if (changed) shown_ = shown;
  outside_.begin(changed);
  inside_.begin(changed);
}

void LookAhead::project(std::span<const Measured> lines, std::span<const std::uint32_t> order, const View& view, const DistanceFields& model) {
  outside_.forgetAhead(lines.size());
  inside_.forgetAhead(lines.size());
  free_.clear();
  inside_.present.reserve(lines.size());   // one a parameter at most, however few there were until now
  for (std::size_t turn = order.size(); turn-- > 0;) {
    const std::size_t rank = order[turn];
    outside_.marks[rank] = outside_.ahead.mark();
    inside_.marks[rank] = inside_.ahead.mark();
    for (const Line& l : inside_.past) {
      if (l.parameter != lines[rank].parameter || !view.inFrontOfNear(l.base)) continue;
      const Segment2 base = view.toScreen(l.base);
      inside_.ahead.add(base, base, base);
    }
    for (const Line& l : outside_.past) {
      if (l.parameter != lines[rank].parameter || !view.inFrontOfNear(l.base) || !view.inFrontOfNear(l.foot) || !view.inFrontOfNear(l.line)) continue;
      const Segment2 line = view.toScreen(l.line);
      outside_.ahead.add(view.toScreen(l.base), view.toScreen(l.foot), line);
      Free& free = free_.emplace_back();
      free.line = line;
      for (const ViewportEdge edge : kViewportEdges) {
        if (clears(model, edge, line)) free.edges |= bit(edge);
      }
    }
  }
}

void LookAhead::reach(std::size_t rank) {
  outside_.ahead.backTo(outside_.marks[rank]);
  inside_.ahead.backTo(inside_.marks[rank]);
  free_.resize(outside_.marks[rank].lines);
}

/// Whether a line ahead that stood free towards a viewport edge does so towards none any more. `comesBetween(edge, line)`: whether something comes between the two.
template <typename ComesBetween>
bool LookAhead::shadowsAny(ComesBetween comesBetween) const {
  return std::ranges::any_of(free_, [&](const Free& free) {
    return free.edges != 0 && std::ranges::none_of(kViewportEdges, [&](ViewportEdge edge) {
             return (free.edges & bit(edge)) != 0 && !comesBetween(edge, free.line);
           });
  });
}

bool LookAhead::shadows(const Segment2& foot, const Segment2& line) const {
  return shadowsAny([&](ViewportEdge edge, const Segment2& of) {
    return standsBefore(line, kHandleSpacingPx - kSlackPx, edge, of) || standsBefore({foot.start, line.start}, kExtensionClearancePx, edge, of) ||
           standsBefore({foot.end, line.end}, kExtensionClearancePx, edge, of);
  });
}

bool LookAhead::shadows(const Box2& label) const {
  const double mayMovePx = shown_ ? 0.0 : kLeapPx;
  const double middle = label.center().y;
  // At its sides by half its height more than it covers: what is just beside it now is behind it in the next frames.
  const double growPx = 0.5 * (label.max.y - label.min.y) + kLabelClearancePx;
  return shadowsAny([&](ViewportEdge edge, const Segment2& of) { return standsBefore({{label.min.x, middle}, {label.max.x, middle}}, growPx, edge, of, mayMovePx); });
}

bool LookAhead::crowds(const Segment2& line) const { return outside_.ahead.comesWithin(kHandleSpacingPx - kSlackPx, line); }

void LookAhead::noteAgain(const LookAhead& other, const Noted& noted) {
  const auto noteFirst = [](std::size_t count, const Lines& from, Lines& to) { to.present.assign(from.present.begin(), from.present.begin() + static_cast<std::ptrdiff_t>(count)); };
  noteFirst(noted.outside, other.outside_, outside_);
  noteFirst(noted.inside, other.inside_, inside_);
}

void LookAhead::forget() {
  for (Lines* lines : {&outside_, &inside_}) {
    lines->past.clear();
    lines->present.clear();
  }
}

}  // namespace dimline
