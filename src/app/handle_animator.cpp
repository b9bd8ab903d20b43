#include "app/handle_animator.h"

#include <utility>

#include "app/motion.h"
#include "editing/arc_projection.h"

namespace dimline {

namespace {

void shift(PlacedHandle& handle, const Vec2& anchorBy, const Vec2& boxBy) {
  handle.anchor += anchorBy;
  handle.box = {handle.box.min + boxBy, handle.box.max + boxBy};
  for (Handle& end : handle.handles) end.screen += boxBy;
  for (RangeOption& option : handle.options) option.box = {option.box.min + boxBy, option.box.max + boxBy};
}

}  // namespace

void HandleAnimator::reset() {
  tracked_.clear();
  fading_.clear();
  opacities_.clear();
  fresh_ = true;
  atRest_ = true;
}

void HandleAnimator::update(const Layout& placed, std::span<const Scope> scopes, const View& view, double nowMs,
                            Layout& drawn) {
  const bool animate = !fresh_ && !reducedMotion_;
  if (!animate) {
    tracked_.clear();
    fading_.clear();
  }
  fresh_ = false;
  atRest_ = true;

  next_.assign(placed.others.size(), {});
  fading_.reserve(placed.others.size(), drawn.others.size());
  taken_.assign(tracked_.size(), 0);
  for (std::size_t i = 0; i < placed.others.size(); ++i) {
    if (const Tracked* known = before(placed.others[i], taken_)) {
      next_[i] = *known;
    } else {
      next_[i].fadeStartMs = nowMs;
      next_[i].startOpacity = animate ? 0.0 : 1.0;
    }
  }
  for (std::size_t j = 0; j < tracked_.size(); ++j) {
    if (!taken_[j]) fading_.add(drawn.others[j], opacities_[j], nowMs);
  }

  fading_.resize(drawn.others, placed.others.size());
  opacities_.resize(placed.others.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < placed.others.size(); ++i) {
    Tracked& tracked = next_[i];
    const PlacedHandle& handle = placed.others[i];
    const bool known = tracked.identity.parameter >= 0;
    const Vec2 offsetPx = handle.box.center() - handle.anchor;
    const bool changed =
        known && (tracked.identity != handle.identity || (!handle.arc && glm::length(offsetPx - tracked.offsetPx) > kJumpPx));
    tracked.identity = handle.identity;
    tracked.offsetPx = offsetPx;
    if (!drawHandle(handle, scopes, placed.view, view, nowMs, changed, tracked, drawn.others[kept])) continue;
    next_[kept] = tracked;
    opacities_[kept] = animate ? appearedBy(nowMs, tracked.fadeStartMs, tracked.startOpacity) : 1.0;
    if (opacities_[kept] < 1.0 || tracked.gliding) atRest_ = false;
    ++kept;
  }
  fading_.resize(drawn.others, kept);
  opacities_.resize(kept);
  next_.resize(kept);
  tracked_.swap(next_);

  fading_.update(nowMs, [&](const PlacedHandle& handle) { return !handle.arc || canProject(*handle.arc, view); });
  if (!fading_.items().empty()) atRest_ = false;
}

/// The handle of the last frame that is this one. A parameter has one at a time.
const HandleAnimator::Tracked* HandleAnimator::before(const PlacedHandle& handle, std::vector<char>& taken) const {
  for (std::size_t j = 0; j < tracked_.size(); ++j) {
    const Tracked& known = tracked_[j];
    if (taken[j] || known.identity.parameter != handle.identity.parameter || known.arc != handle.arc.has_value()) continue;
    if (known.arc && known.identity.scopeIndex != handle.identity.scopeIndex) continue;
    taken[j] = 1;
    return &known;
  }
  return nullptr;
}

/// Draws one handle, on its way or at its place. False when `view` cannot show it.
bool HandleAnimator::drawHandle(const PlacedHandle& placed, std::span<const Scope> scopes, const View& placedView,
                                const View& view, double nowMs, bool changed, Tracked& tracked, PlacedHandle& drawn) {
  drawn = placed;
  const bool same = sameView(placedView, view);
  if (!same) {
    const Vec3 middle = scopes[placed.scope].box.center();
    if (!view.inFrontOfNear(middle) || !placedView.inFrontOfNear(middle)) return false;
    const Vec2 moved = view.toScreen(middle) - placedView.toScreen(middle);
    shift(drawn, moved, moved);
  }
  if (changed) {
    tracked.anchorRest = tracked.anchor - drawn.anchor;
    tracked.centerRest = tracked.center - drawn.box.center();
    if (placed.arc) tracked.arcRest = tracked.arcCenter - placed.arc->center;
    tracked.glideStartMs = nowMs;
    tracked.gliding = true;
  }
  const double rest = tracked.gliding ? 1.0 - easeOut((nowMs - tracked.glideStartMs) / kGlideMs) : 0.0;
  if (rest <= 0.0) tracked.gliding = false;
  if (placed.arc) {
    if (!canProject(*placed.arc, placedView)) return false;
    if (tracked.gliding) drawn.arc->center += tracked.arcRest * rest;
    if (!canProject(*drawn.arc, view)) return false;
    if (tracked.gliding || !same) projectArcHandle(drawn, view, arcLabelOffset(placed, placedView));
  } else if (tracked.gliding) {
    shift(drawn, tracked.anchorRest * rest, tracked.centerRest * rest);
  }
  tracked.arc = placed.arc.has_value();
  tracked.anchor = drawn.anchor;
  tracked.center = drawn.box.center();
  if (placed.arc) tracked.arcCenter = drawn.arc->center;
  return true;
}

}  // namespace dimline
