#pragma once

#include <array>
#include <optional>

#include "editing/drag_marks.h"
#include "editing/line_projection.h"
#include "editing/snap.h"
#include "editing/value_search.h"
#include "model/model.h"
#include "placement/layout.h"

namespace dimline {

/// One drag of a dimension line's end (paper 5, "Interactive Editing"): where the pointer is -> which value, and where
/// the line is then.
///
/// Everything is computed from the start of the drag: the values, the line and the pointer's offset from the handle
/// then, and the pointer now. So the same pointer gives the same value however it came there, and the handle keeps its
/// distance to the pointer.
///
/// During the drag the line stays on its carrier, the line in the world on which it lay, whatever the model does; only
/// its ends move. The scope it measures is the same one as long as the model has as many of that name. When their number
/// changes, as where a spacing is rounded to fit a wall, it is the one whose dragged end is nearest to where the drag began
/// (the paper's rule), and the line takes its length alone: its other end stays where it was. So the handle follows the
/// pointer, where the ends of whichever scope is nearest would go to and fro.
class HandleDrag {
public:
  /// Takes hold of a handle of `line`, as drawn in `view`, with the pointer at `pointer` (px). `model` must outlive the
  /// drag. `values` and `scene` are the present ones. Nothing when the line points at the viewer, so that no movement
  /// on screen says anything about its length, or when `scene` is not the one in which it was placed.
  static std::optional<HandleDrag> begin(const Model& model, const Values& values, const Scene& scene,
                                         const PlacedLine& line, const Handle& handle, const Vec2& pointer,
                                         const View& view);

  [[nodiscard]] std::size_t parameter() const { return line_.parameter; }
  [[nodiscard]] bool atEnd() const { return atEnd_; }
  /// The values before the drag: what cancelling restores, and the undo step.
  [[nodiscard]] const Values& startValues() const { return startValues_; }
  /// The line as it was when the drag began.
  [[nodiscard]] const PlacedLine& startLine() const { return line_; }

  /// The value at which the dragged end is nearest to the pointer, along the line's direction on screen; of those that
  /// `snap` allows, in the range. A pointer that is not a number gives the last value. The camera must be the one of
  /// begin(); the viewport may have changed.
  double valueAt(const Vec2& pointer, const View& view, Snap snap = Snap::kStep);

  /// The same while other parameters are not as they were at the start, as when they are dragged too: the end comes to the pointer in the model with their
  /// values in `others`. What `others` says of this parameter does not matter.
  double valueAmong(const Values& others, const Vec2& pointer, const View& view, Snap snap = Snap::kStep);

  /// The pointer takes hold anew of the line, drawn as `now` in `view`: what it does next begins there. For a viewport whose size changed under it.
  void regrip(const PlacedLine& now, const Vec2& pointer, const View& view) { grabOffset_ = pointer - view.toScreen(endOf(now.line)); }

  /// The dragged line on a rebuilt scene, in the world and as `view` shows it. Nothing when the model has no such scope
  /// any more or the line cannot be projected.
  [[nodiscard]] std::optional<PlacedLine> lineOn(const Scene& scene, const Values& values, const View& view) const;

  /// Adds what is shown beside the line while it has this value and is drawn as `now`: the old extent, as far as it reaches beyond, the values that come
  /// next, the ends of the range. Where the rule is rounded or bent, only as far as learnNearby() has found them out. `view`: of the same camera as begin()'s.
  void addMarks(double value, const PlacedLine& now, const View& view, Snap snap, std::vector<DragMark>& marks);

  /// Finds out where one more of the values ends that addMarks() shows, the nearest first: one evaluation of the model. False when all are known, as where
  /// ends are in proportion to values. What was found is kept as long as the drag lasts.
  bool learnNearby(double value, const PlacedLine& now, const View& view, Snap snap);

  /// How often the model was evaluated so far.
  [[nodiscard]] int evaluations() const;

private:
  struct Tracked {
    std::size_t scope;
    Segment base;
  };

  HandleDrag(const Model& model, const Values& values, const PlacedLine& line, const Handle& handle,
             const Vec2& grabOffset, const View& view, double toleranceM);
  [[nodiscard]] ValueSearch& search(Snap snap);
  [[nodiscard]] const Annotation& annotation() const { return *model_->annotations[line_.parameter]; }
  void findMeasured(const Scene& scene);
  [[nodiscard]] std::size_t countScopes(const Scene& scene) const;
  [[nodiscard]] std::optional<Tracked> track(const Scene& scene) const;
  [[nodiscard]] Segment keptInPlace(const Segment& base) const;
  [[nodiscard]] std::optional<double> endAt(double value) const { return endIn(startValues_, value); }
  [[nodiscard]] std::optional<double> endIn(const Values& others, double value) const;
  /// The ends of values as the marks need them, as far as they are known.
  struct Nearby;
  Nearby lookNearby(double value, const PlacedLine& now, const View& view, Snap snap);
  [[nodiscard]] double targetM(const Vec2& screen, const View& view) const;
  [[nodiscard]] const Vec3& endOf(const Segment& segment) const { return atEnd_ ? segment.end : segment.start; }

  const Model* model_;
  Values startValues_;
  View startView_;  ///< base lines of round scopes turn with the view
  PlacedLine line_;
  std::optional<LabelAnchor> labelAnchor_;
  bool atEnd_;
  // What it measured when the drag began: which scope out of how many of the name, which of its base lines.
  std::uint32_t scopeIndex_ = 0;
  std::size_t scopeCount_ = 0;
  std::optional<std::size_t> baseLine_;
  Vec3 direction_;   ///< unit, of the line from start to end
  Vec2 grabOffset_;  ///< px, from the handle to the pointer
  double toleranceM_;   ///< along the line, what cannot be told apart on screen
  std::array<std::optional<ValueSearch>, 3> searches_;   ///< one a Snap, made when it is needed
  double lastValue_;
};

}  // namespace dimline
