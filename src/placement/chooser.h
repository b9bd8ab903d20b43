#pragma once

#include <span>
#include <vector>

#include "placement/candidates.h"
#include "placement/look_ahead.h"
#include "placement/measured.h"
#include "placement/occupied.h"

namespace dimline {

/// What a parameter's lines are chosen against in one frame.
struct ChoiceContext {
  const View& view;
  const DistanceFields& model;              ///< the model's own fields
  const Occupied& occupied;
  const LookAhead& lookAhead;
  const ObjectPlanesInFrame& objectPlanes;
  Foresight& foresight;
  std::span<const Scope> scopes;
  std::span<const char> usable;             ///< one a scope: whether it may carry a line in this frame
  double toleranceM = 0;                    ///< kSamePlaneDistance of the model's size
  bool viewMoved = false;                   ///< since the last frame
  bool firm = false;                        ///< the last frame's place is kept wherever it still is one
  const Identity* avoid = nullptr;          ///< a place that is not looked at
  bool showAll = false;                     ///< base lines that are short or point at the viewer can be used too
};

/// One line of a choice: the line itself, or a member of its chain.
struct ChosenLine {
  std::size_t scope = 0;
  Segment base;
  Segment2 baseScreen;
  Segment foot;
  Segment2 footScreen;
  Segment line;
  Segment2 lineScreen;
  std::optional<Box2> label;
};

/// getDimensionLine of the paper's algorithm 1 for one parameter: its candidates on guides, else outside the silhouette, else its base lines; the best of them by score, as one line or as the
/// members of a chain, with labels. Keeps its memory from frame to frame.
class Chooser {
 public:
  /// Finds the parameter's place. False when none of its base lines can be used; then tally() says why, and cramped() whether it is for want of room alone.
  bool choose(const Measured& measured, const ChoiceContext& context, const History& history);

  [[nodiscard]] const Candidate& winner() const { return winner_; }
  [[nodiscard]] std::span<const ChosenLine> lines() const { return winnerLines_; }
  /// What the choice is worth among what has landed before it.
  struct Worth {
    double score = 0;             ///< px; hysteresis left out, with what it runs into
    Landed::Tangle tangle;
    bool nestsWithin = false;
  };
  [[nodiscard]] Worth worth(const Landed& landed);
  /// Whether the choice is a base line that runs into a line that has landed, or all that could have been would have.
  [[nodiscard]] bool cramped() const { return cramped_; }
  [[nodiscard]] const BaseLineTally& tally() const { return tally_; }

 private:
  enum class Enough { kOne, kAll };
  bool gatherBases(const Measured& measured, const ChoiceContext& context, double factor, Enough enough);
  bool chooseOutside(std::span<const UsableBaseLine> bases, const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context);
  bool chooseAgain(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context);
  bool chooseBest(const Measured& measured, const ChoiceContext& context, const History& history);
  bool chooseInside(const CandidateContext& candidates, const ChoiceContext& context);
  struct AmongOthers {
    double score = 0;             ///< px
    Landed::Crossings landed;
    bool nestsWithin = false;
    bool crossesAhead = false;    ///< one ahead, in place of one that has landed: an extension line with a line
    [[nodiscard]] bool tangled() const { return landed.extensions || crossesAhead; }
  };
  [[nodiscard]] static AmongOthers amongOthers(const Candidate& candidate, const ChoiceContext& context, double enough);
  std::span<const Segment2> extensionsOf(std::span<const ChosenLine> lines);
  void addMembers(AmongOthers& among, const ChoiceContext& context);
  void pushClear(Candidate& candidate, AmongOthers& among, const Measured& measured, const ChoiceContext& context, const History& history);
  bool settle(Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  bool expand(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  bool expandChain(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  bool placeLabels(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  [[nodiscard]] bool fellowsLeaveRoom(const Box2& label, std::size_t own) const;

  BaseLineTally tally_;
  bool cramped_ = false;
  Candidate winner_;
  AmongOthers winnerAmongOthers_;           ///< of a winner outside
  std::vector<ChosenLine> winnerLines_;
  std::vector<ChosenLine> lines_;           ///< of the candidate that is looked at
  std::vector<Segment2> extensions_;        ///< of the lines that extensionsOf() was last asked for
  std::vector<UsableBaseLine> bases_;
  std::vector<UsableBaseLine> chainBases_;
  std::vector<Candidate> candidates_;
  std::vector<Candidate*> ranked_;          ///< candidates_, the best first
  std::vector<SlipPlane> slipPlanes_;
  TakenStretches chainStretches_;
};

}  // namespace dimline
