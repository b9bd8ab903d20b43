#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/fading_list.h"
#include "placement/layout.h"

namespace dimline {

/// Carries lines from where they were to where they are placed, so that an eye can follow them (paper 5, "Animation").
///
/// Animated is the difference to the place, in the world: a line that keeps its place sticks to it exactly however fast
/// the camera moves, and one that got a new place, or whose label did, glides there within kGlideMs, whatever happens on
/// the way. Lines come and go by opacity, and so does one whose new place is far away.
class LineAnimator {
public:
  /// Without motion lines are where they are placed, at once.
  void setReducedMotion(bool reduced) { reducedMotion_ = reduced; }
  /// Forgets all lines; those of the next frame are there without animation.
  void reset();

  /// One frame. `placed` is what the placer gave, perhaps for a slightly older view; `drawn` is what this function
  /// filled in the last frame, and becomes what `view` shows now; `scopes` are the scene's. Where nothing moves and
  /// `view` is the placer's, it is an exact copy of `placed`. `drawn.others` is left to HandleAnimator. Time must not run
  /// backwards. `held`: those of the placed lines that are being dragged, which never set out to glide, wherever their base lines go.
  void update(const Layout& placed, std::span<const Scope> scopes, const View& view, double nowMs, Layout& drawn, std::span<const PlacedLine> held = {});

  /// Nothing glides or fades.
  [[nodiscard]] bool atRest() const { return atRest_; }
  /// One for each line that update() drew last.
  [[nodiscard]] std::span<const double> opacities() const { return opacities_; }
  [[nodiscard]] std::span<const Fading<PlacedLine>> fading() const { return fading_.items(); }

private:
  /// What is remembered of a line from one frame to the next.
  struct Tracked {
    Identity identity;
    std::uint32_t scopeIndex = 0;  ///< among those of its name
    // Where it was drawn, and in the same frame placed.
    Segment base, line;
    Vec2 labelCenter{0.0};
    bool hasLabel = false;
    LabelPlace labelPlace;
    Vec2 offsetPx{0.0};  ///< from the base line's middle to the line's, as placed
    // What was left between the two when its glide began.
    Segment baseRest, lineRest;
    double glideStartMs = 0;
    bool gliding = false;
    // The same of its label, on its line.
    Vec2 labelRest{0.0};
    double labelStartMs = 0;
    bool labelGliding = false;
    bool labelHops = false;  ///< in this frame
    double fadeStartMs = 0;
    double startOpacity = 1;
  };

  void match(const Layout& placed, std::span<const Scope> scopes, double nowMs, bool animate, Layout& drawn, std::span<const PlacedLine> held);
  [[nodiscard]] std::optional<std::size_t> findBefore(const PlacedLine& line, std::uint32_t scopeIndex,
                                                      std::size_t hint, bool exactly) const;
  void glideLabel(double nowMs, bool lineSetsOut, Tracked& tracked, Box2& label);
  bool drawLine(const PlacedLine& placed, const View& view, bool sameView, double nowMs, Tracked& tracked,
                PlacedLine& drawn);

  bool reducedMotion_ = false;
  bool fresh_ = true;  ///< the next frame's lines appear at once
  bool atRest_ = true;
  std::vector<Tracked> tracked_;  ///< parallel to the lines drawn last
  std::vector<Tracked> next_;
  std::vector<bool> taken_;
  std::vector<bool> changed_;  ///< parallel to next_: its place is another one than in the last frame
  std::vector<double> opacities_;
  FadingList<PlacedLine> fading_;
};

}  // namespace dimline
