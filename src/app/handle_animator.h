#pragma once

#include <span>
#include <vector>

#include "app/fading_list.h"
#include "placement/layout.h"

namespace dimline {

/// As LineAnimator, for the handles that are no lines: arcs, switches and choices.
///
/// A switch or a choice glides on screen, an arc within its plane in the world. One that goes to another scope's frame is
/// another arc: the one fades, the other appears.
class HandleAnimator {
public:
  void setReducedMotion(bool reduced) { reducedMotion_ = reduced; }
  /// Forgets all handles; those of the next frame are there without animation.
  void reset();

  /// One frame, as LineAnimator::update(), for `drawn.others`; the rest of `drawn` is left alone. For a view that is not
  /// the placer's, a switch moves with the middle of its scope.
  void update(const Layout& placed, std::span<const Scope> scopes, const View& view, double nowMs, Layout& drawn);

  [[nodiscard]] bool atRest() const { return atRest_; }
  /// One for each handle that update() drew last.
  [[nodiscard]] std::span<const double> opacities() const { return opacities_; }
  [[nodiscard]] std::span<const Fading<PlacedHandle>> fading() const { return fading_.items(); }

private:
  /// What is remembered of a handle from one frame to the next.
  struct Tracked {
    Identity identity;
    bool arc = false;
    // Where it was drawn.
    Vec2 anchor{0.0}, center{0.0};
    Vec3 arcCenter{0.0};
    Vec2 offsetPx{0.0};  ///< from the anchor to the box, as placed
    // What was left to its place when its glide began.
    Vec2 anchorRest{0.0}, centerRest{0.0};
    Vec3 arcRest{0.0};
    double glideStartMs = 0;
    bool gliding = false;
    double fadeStartMs = 0;
    double startOpacity = 1;
  };

  [[nodiscard]] const Tracked* before(const PlacedHandle& handle, std::vector<char>& taken) const;
  bool drawHandle(const PlacedHandle& placed, std::span<const Scope> scopes, const View& placedView, const View& view,
                  double nowMs, bool changed, Tracked& tracked, PlacedHandle& drawn);

  bool reducedMotion_ = false;
  bool fresh_ = true;
  bool atRest_ = true;
  std::vector<Tracked> tracked_;  ///< parallel to the handles drawn last
  std::vector<Tracked> next_;
  std::vector<char> taken_;
  std::vector<double> opacities_;
  FadingList<PlacedHandle> fading_;
};

}  // namespace dimline
