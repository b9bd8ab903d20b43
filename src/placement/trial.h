#pragma once

#include <span>
#include <vector>

#include "placement/candidates.h"
#include "placement/label_memory.h"
#include "placement/look_ahead.h"
#include "placement/measured.h"
#include "placement/occupied.h"
#include "placement/visibility.h"

namespace dimline {

/// What a parameter's lines are chosen against in one frame.
struct ChoiceContext {
  const View& view;
  const DistanceFields& model;              ///< the model's own fields
  const Occupied& occupied;
  const LookAhead& lookAhead;
  const LabelMemory& labels;
  const ObjectPlanesInFrame& objectPlanes;
  Foresight& foresight;
  std::span<const Scope> scopes;
  std::span<const char> usable;             ///< one a scope: whether it may carry a line in this frame
  std::span<const Sight> sights;            ///< one a scope: how much of it is seen
  double toleranceM = 0;                    ///< kSamePlaneDistance of the model's size
  bool viewMoved = false;                   ///< since the last frame
  bool firm = false;                        ///< the last frame's place is kept wherever it still is one
  bool patient = false;                     ///< what has had a better kind of place for less than kPatienceFrames, or kPatienceSmallViewportFrames, does not take it yet
  const AvoidedPlace* avoid = nullptr;      ///< places that are not looked at
  const Segment* inHand = nullptr;          ///< a line of the same chain that is dragged, and with which it goes
  bool asksForRoom = false;                 ///< labels may yet give way, in another round of the same frame
  FrameKind kind;
  bool calm = false;                        ///< no line runs across another's extension line, nor has any for kCalmFrames
  bool showAll = false;                     ///< base lines that are short or point at the viewer can be used too

  /// Whether what has that history came so lately that it stays though it would not come now.
  [[nodiscard]] bool dwells(const History& history) const { return patient && history.cameLately(); }
  /// Whether a scope is in plain view; `stays`: a line inside the model showed it in the last frame.
  [[nodiscard]] bool inPlainView(std::size_t scope, bool stays = false) const { return dimline::inPlainView(view, scopes[scope].box, sights[scope], stays); }
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
  LabelPlace labelPlace;
};

/// By what the thresholds of constants.h are multiplied for what is too short or points at the viewer.
double thresholdFactor(const Measured& measured, const ChoiceContext& context);

/// The line that a candidate inside the model, or by itself, stands for.
ChosenLine chosenLine(const Candidate& candidate);

/// A candidate outside the model put to the test: the lines that it stands for, their labels, and what they run into. Keeps its memory from one candidate to the next.
class Trial {
 public:
  /// A candidate's score with what it runs into, of the lines that have landed and of those ahead.
  struct AmongOthers {
    double score = 0;             ///< px
    Landed::Crossings landed;
    bool nestsWrongly = false;
    bool crossesAhead = false;    ///< one ahead, in place of one that has landed: an extension line with a line
    [[nodiscard]] bool tangled() const { return landed.extensions || crossesAhead; }
  };
  /// Of its own line; of a score that comes to `enough` or less, no more is worked out.
  [[nodiscard]] static AmongOthers amongOthers(const Candidate& candidate, const Measured& measured, const ChoiceContext& context, double enough);

  /// Expands a candidate to lines() and gives it a label, moving it further out where the label has no room. False when there is none.
  bool settle(Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  /// The same where it is, with a label or without.
  bool takeAsItIs(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  /// Adds what the extension lines of a chain's members run across: of the chain itself, the score knows those at its ends alone, where there may be no member left. After settle().
  void addMembers(AmongOthers& among, const ChoiceContext& context);
  /// Moves a candidate that runs across another's extension line, or across whose extension line another runs, further out until none does, where there is such an offset and its
  /// label has room there. The last frame's choice goes there by kClearPx a frame, and where it is not clear of what is ahead it stays as far out as it is. Beyond the paper, whose lines lie at the least offset (4.1). After settle().
  void pushClear(Candidate& candidate, AmongOthers& among, const Measured& measured, const ChoiceContext& context, const History& history);

  /// Of the candidate that was settled last, as it lies now.
  [[nodiscard]] std::span<const ChosenLine> lines() const { return lines_; }
  /// Gives them away, and takes memory for the next ones.
  void swapLines(std::vector<ChosenLine>& with) { lines_.swap(with); }
  /// The extension lines of a line, or of all members of a chain, in parts; until it is asked for the next.
  std::span<const Segment2> extensionsOf(std::span<const ChosenLine> lines);

 private:
  bool expand(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  bool expandChain(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);
  bool placeLabels(const Candidate& candidate, const Measured& measured, const ChoiceContext& context);

  std::vector<ChosenLine> lines_;
  std::vector<Segment2> extensions_;
  std::vector<Segment2> fellows_;   ///< lines_ on screen
  std::vector<Box2> labels_;        ///< theirs so far
  TakenStretches chainStretches_;
};

}  // namespace dimline
