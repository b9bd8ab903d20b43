#pragma once

#include <memory>
#include <span>

#include "placement/layout.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

/// Places all dimension lines of a model for one camera (paper section 4).
///
/// The placer is a function of (model, scene, view, fields, last frame) to a layout; what it keeps between frames is the last frame's choices, for
/// the term Damp, and memory, so that a warmed-up frame allocates nothing. Nothing here knows how the fields were measured.
class Placer {
 public:
  Placer();
  ~Placer();
  Placer(Placer&&) noexcept;
  Placer& operator=(Placer&&) noexcept;

  /// Prepares a model's scene: which scopes each parameter measures, and the order in which parameters are placed (paper 4.5: shortest first, by
  /// the mean world length of their base lines). The choices of the last frame are kept when the parameters are the same ones: a rebuilt
  /// model keeps its lines where they are. Copies what it needs.
  void setScene(const Model& model, const Scene& scene);

  /// Forgets the last frame, as for another model.
  void forget();

  /// What the placer remembers of the frames before, to be put back when all that was done since is taken back, as by a drag that is cancelled. Only for the
  /// same model and, when recalled, the same scene as then.
  class Memory {
   private:
    friend class Placer;
    struct Content;
    std::shared_ptr<const Content> content_;
  };
  [[nodiscard]] Memory memory() const;
  void recall(const Memory& memory);

  /// To be told before each frame after a movement or an edit has ended, until settled(). It says nothing while the scene changes or a line is held.
  /// After a movement lines settle: while the camera moves they stay where they are as long as they can, so that the eye can follow, and end up far out or along what has turned away; now each looks for a better place, as in a
  /// first picture, and changes when that is better by more than kScoreChangeSettling; in the end labels (label_tidying.h) and switches are laid out as a whole. That takes kRoundsSettling + 1 frames of the same view, which may
  /// be the last frame's, each some milliseconds: until the last of them place() leaves the layout as it is. Any other frame breaks it off, and all is as it was before.
  /// After an edit of what has settled lines stay where someone has just worked with them, and one frame lays out labels and switches as a whole.
  void settle();
  /// All these frames at once, where nobody waits for the next one; what has settled settles once more.
  void placeSettled(const View& view, const DistanceFields& fields, const Values& values, Layout& layout, const ScopeVisibility* visibility = nullptr);
  /// Whether there is nothing left to settle: the view and the scene are those in which lines settled last, or there has been no frame yet. Once a line is held there is nothing either, until the hand changes the scene: who
  /// takes hold of a line takes the picture as it is. An arc in the hand is no line.
  [[nodiscard]] bool settled() const;
  /// Whether the last frame was a first picture, since nothing was known of one before, or one of a view too far from it: what is placed at once is not as good as what settles, and nobody has seen lines that would move.
  [[nodiscard]] bool anew() const;

  /// From the next frame on, handles are shown too that are hidden as occluded, too short, foreshortened or crowded (paper 5, "Rendering Handles": a modifier key
  /// shows all hidden handles). At the start they are not. They find their places beside those that are there anyway, none of which moves for them, and leave nothing behind.
  void showHidden(bool shown);

  /// One frame. `fields` are the model's own, of the same viewport as `view`; `visibility` says how much of each of the scene's scopes is seen, from
  /// this frame or a recent one (null: nothing is hidden by the model). `values` are what the labels say. `held`: lines that are being dragged, one a
  /// parameter; at their parameter's turn they are taken as they are, and later lines keep clear of them as of any other. All lines leave their labels room. A chain one of whose several
  /// members is held is placed as a whole: it is for the caller to put that member in its place.
  void place(const View& view, const DistanceFields& fields, const Values& values, Layout& layout,
             const ScopeVisibility* visibility = nullptr, std::span<const PlacedLine> held = {});

  /// To be told after a frame whose fields were still another scene's or view's: what an edit lets find another place is looked at once more, when they have come.
  void awaitFields();

  /// Whether each attempt to mend a frame (placement/mending.h) places all lines, in place of those alone from whose turn on it differs from the best one before it. The layouts are the same, after
  /// twice the time: for tests of just that.
  void placeAttemptsWhole(bool whole);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dimline
