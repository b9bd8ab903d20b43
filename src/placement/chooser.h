#pragma once

#include <span>
#include <vector>

#include "core/reserved.h"
#include "core/sort_keys.h"
#include "placement/trial.h"

namespace dimline {

/// getDimensionLine of the paper's algorithm 1 for one parameter: its candidates on guides, else outside the silhouette, else its base lines; the best of them by score, as one line or as the
/// members of a chain, with labels. Keeps its memory from frame to frame.
class Chooser {
 public:
  /// Finds the parameter's place. False when none of its base lines can be used; then tally() says why, and cramped() whether it is for want of room alone. Tells the history of a better kind of place
  /// than the last frame's that has to wait (ChoiceContext::patient).
  bool choose(const Measured& measured, const ChoiceContext& context, History& history);

  [[nodiscard]] const Candidate& winner() const { return winner_; }
  [[nodiscard]] std::span<const ChosenLine> lines() const { return winnerLines_; }
  /// The lines of a place that would have been chosen had no label been in their way; none when there is no such place, or labels do not give way (ChoiceContext::asksForRoom).
  [[nodiscard]] std::span<const ChosenLine> wished() const { return wishedLines_; }
  /// What the choice is worth among what has landed before it, and what is amiss with it.
  struct Worth {
    double score = 0;             ///< px; hysteresis left out, with lines and labels that it runs into
    Landed::Tangle tangle;
    bool nestsWrongly = false;
  };
  [[nodiscard]] Worth worth(const Landed& landed);
  /// Whether the choice is a base line that runs into a line or a label that has landed, or all that could have been would have.
  [[nodiscard]] bool cramped() const { return cramped_; }
  [[nodiscard]] const BaseLineTally& tally() const { return tally_; }

 private:
  enum class Enough { kOne, kAll };
  bool gatherBases(const Measured& measured, const ChoiceContext& context, const View& view, Enough enough);
  bool gatherBases(const Measured& measured, const ChoiceContext& context, const View& view, double factor, Enough enough);
  bool comesBack(const Measured& measured, const ChoiceContext& context);
  enum class Outside { kNone, kWaits, kFound };
  Outside chooseOutside(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context, History* waits);
  bool chooseOutside(std::span<const UsableBaseLine> bases, const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context);
  bool chooseInHand(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context);
  bool chooseAgain(const Measured& measured, const CandidateContext& candidates, const ChoiceContext& context);
  bool chooseBest(const Measured& measured, const ChoiceContext& context, const History& history);
  bool chooseInside(const CandidateContext& candidates, const ChoiceContext& context);

  BaseLineTally tally_;
  bool cramped_ = false;
  double factor_ = 1;                       ///< by what thresholds for what is too short or points at the viewer are multiplied
  Candidate winner_;
  Trial::AmongOthers winnerAmongOthers_;    ///< of a winner outside
  std::vector<ChosenLine> winnerLines_;
  std::vector<ChosenLine> wishedLines_;
  double wishedScore_ = 0;                  ///< but for labels
  Trial trial_;                             ///< of the candidate that is looked at
  std::vector<UsableBaseLine> bases_;
  std::vector<UsableBaseLine> chainBases_;
  static constexpr std::size_t kReservedCandidates = 256;   // of one line; one that slips along an object's faces has more than a hundred now and then
  std::vector<Candidate> candidates_ = withRoomFor<Candidate>(kReservedCandidates);
  std::vector<SortKey> ranked_ = withRoomFor<SortKey>(kReservedCandidates);             ///< candidates_, the best first; of equal scores the one that was gathered first
  std::vector<SlipPlane> slipPlanes_;
};

}  // namespace dimline
