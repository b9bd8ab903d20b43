#include "app/line_animator.h"

#include <algorithm>
#include <utility>

#include "app/motion.h"
#include "editing/line_projection.h"

namespace dimline {

namespace {

Vec2 offsetPx(const PlacedLine& line) { return line.lineScreen.middle() - line.baseScreen.middle(); }

Segment difference(const Segment& a, const Segment& b) { return {a.start - b.start, a.end - b.end}; }
Segment moved(const Segment& s, const Segment& by, double share) {
  return {s.start + by.start * share, s.end + by.end * share};
}

}  // namespace

void LineAnimator::reset() {
  tracked_.clear();
  fading_.clear();
  opacities_.clear();
  fresh_ = true;
  atRest_ = true;
}

void LineAnimator::update(const Layout& placed, std::span<const Scope> scopes, const View& view, double nowMs,
                          Layout& drawn, std::span<const PlacedLine> held) {
  const bool animate = !fresh_ && !reducedMotion_;
  if (!animate) {
    tracked_.clear();
    fading_.clear();
  }
  fading_.reserve(placed.lines.size(), drawn.lines.size());
  match(placed, scopes, nowMs, animate, drawn, held);
  fresh_ = false;
  atRest_ = true;

  const bool same = sameView(placed.view, view);
  drawn.view = view;
  drawn.hidden.reserve(placed.hidden.capacity());   // or the first frame that hides more than any before would allocate
  drawn.hidden = placed.hidden;
  drawn.visibleScopes = placed.visibleScopes;
  fading_.resize(drawn.lines, placed.lines.size());
  opacities_.resize(placed.lines.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < placed.lines.size(); ++i) {
    // A line of an older view may have passed the near plane since then; it is left out until it is placed anew.
    if (!drawLine(placed.lines[i], view, same, nowMs, next_[i], drawn.lines[kept])) continue;
    next_[kept] = next_[i];
    opacities_[kept] = animate ? appearedBy(nowMs, next_[i].fadeStartMs, next_[i].startOpacity) : 1.0;
    if (opacities_[kept] < 1.0) atRest_ = false;
    ++kept;
  }
  fading_.resize(drawn.lines, kept);
  opacities_.resize(kept);
  next_.resize(kept);
  tracked_.swap(next_);
  fading_.update(nowMs, [&](PlacedLine& line) {
    if (!canProject(line, view)) return false;
    projectLine(line, view, labelAnchor(line));
    return true;
  });
  if (!fading_.items().empty()) atRest_ = false;
}

/// The line of the last frame that is this one: the very same choice for the same scope; or else another choice of its
/// parameter, of which a chain's members only stand for themselves.
std::optional<std::size_t> LineAnimator::findBefore(const PlacedLine& line, std::uint32_t scopeIndex, std::size_t hint,
                                                    bool exactly) const {
  for (std::size_t n = 0; n < tracked_.size(); ++n) {
    const std::size_t j = (hint + n) % tracked_.size();
    const Tracked& before = tracked_[j];
    if (taken_[j] || before.identity.parameter != line.identity.parameter) continue;
    const bool sameScope = before.scopeIndex == scopeIndex;
    const bool chained = before.identity.chain >= 0 && line.identity.chain >= 0;
    if (exactly ? before.identity == line.identity && (sameScope || !chained) : sameScope || !chained) return j;
  }
  return std::nullopt;
}

/// Finds each placed line among those of the last frame, unless it has gone far. What is left of those fades.
void LineAnimator::match(const Layout& placed, std::span<const Scope> scopes, double nowMs, bool animate,
                         Layout& drawn, std::span<const PlacedLine> held) {
  next_.assign(placed.lines.size(), {});
  changed_.assign(placed.lines.size(), true);
  taken_.assign(tracked_.size(), false);
  for (const bool exactly : {true, false}) {
    std::size_t hint = 0;  // lines mostly keep their order
    for (std::size_t i = 0; i < placed.lines.size(); ++i) {
      if (next_[i].identity.parameter >= 0) continue;
      const auto found = findBefore(placed.lines[i], scopes[placed.lines[i].scope].index, hint, exactly);
      if (!found) continue;
      if (!exactly && glm::length(placed.lines[i].lineScreen.middle() - drawn.lines[*found].lineScreen.middle()) > kFarPx) continue;
      next_[i] = tracked_[*found];
      taken_[*found] = true;
      hint = *found + 1;
      const bool inHand = exactly && std::ranges::find(held, placed.lines[i].identity, &PlacedLine::identity) != held.end();
      changed_[i] = !exactly || (!inHand && glm::length(offsetPx(placed.lines[i]) - next_[i].offsetPx) > kJumpPx);
      next_[i].labelHops = changed_[i] || (!inHand && placed.lines[i].labelPlace != next_[i].labelPlace);
    }
  }
  for (std::size_t i = 0; i < placed.lines.size(); ++i) {
    Tracked& line = next_[i];
    if (line.identity.parameter < 0) {
      line.fadeStartMs = nowMs;
      line.startOpacity = animate ? 0.0 : 1.0;
    } else if (changed_[i]) {
      line.baseRest = difference(line.base, placed.lines[i].base);
      line.lineRest = difference(line.line, placed.lines[i].line);
      line.glideStartMs = nowMs;
      line.gliding = true;
    }
    line.identity = placed.lines[i].identity;
    line.scopeIndex = scopes[placed.lines[i].scope].index;
  }
  for (std::size_t j = 0; j < tracked_.size(); ++j) {
    if (taken_[j]) continue;
    fading_.add(drawn.lines[j], opacities_[j], nowMs);
  }
}

/// Draws one line, on its way or at its place. False when `view` cannot show it.
bool LineAnimator::drawLine(const PlacedLine& placed, const View& view, bool same, double nowMs, Tracked& tracked,
                            PlacedLine& drawn) {
  const bool justChanged = tracked.gliding && tracked.glideStartMs == nowMs;
  const double rest = tracked.gliding ? 1.0 - easeOut((nowMs - tracked.glideStartMs) / kGlideMs) : 0.0;
  drawn = placed;
  if (rest <= 0.0) tracked.gliding = false;
  const auto anchor = labelAnchor(placed);
  if (tracked.gliding) {
    drawn.base = moved(placed.base, tracked.baseRest, rest);
    drawn.line = moved(placed.line, tracked.lineRest, rest);
    if (!canProject(drawn, view)) {
      tracked.gliding = false;
      drawn.base = placed.base;
      drawn.line = placed.line;
    }
  }
  if (tracked.gliding || !same) {
    if (!canProject(drawn, view)) return false;
    projectLine(drawn, view, anchor);
  }
  if (drawn.label) glideLabel(nowMs, justChanged, tracked, *drawn.label);
  if (tracked.gliding) atRest_ = false;
  tracked.base = drawn.base;
  tracked.line = drawn.line;
  tracked.hasLabel = drawn.label.has_value();
  tracked.labelPlace = placed.labelPlace;
  if (drawn.label) tracked.labelCenter = drawn.label->center();
  tracked.offsetPx = offsetPx(placed);
  return true;
}

/// Moves a label on its way to its place. One that hops again on the way is there no later for that, unless it is nearly there or its line sets out as well.
void LineAnimator::glideLabel(double nowMs, bool lineSetsOut, Tracked& tracked, Box2& label) {
  constexpr double kNearlyThere = 0.3;
  double share = tracked.labelGliding ? 1.0 - easeOut((nowMs - tracked.labelStartMs) / kGlideMs) : 0.0;
  if (tracked.labelHops && tracked.hasLabel) {
    if (lineSetsOut || share < kNearlyThere) {
      tracked.labelStartMs = nowMs;
      share = 1.0;
    }
    tracked.labelRest = (tracked.labelCenter - label.center()) / share;
  }
  tracked.labelGliding = tracked.hasLabel && share > 0.0;
  if (!tracked.labelGliding) return;
  atRest_ = false;
  label.min += tracked.labelRest * share;
  label.max += tracked.labelRest * share;
}

}  // namespace dimline
