#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "model/parameter.h"

namespace dimline {

/// Where a value puts the dragged end: a coordinate (m) along the dragged line's carrier, 0 where it was when the drag
/// began. Nothing when the model has no such line at that value. Dear (the model is evaluated), and always the same for
/// the same value.
using Reach = std::function<std::optional<double>(double value)>;

/// Finds the value whose line ends nearest to where the pointer is (paper 5): the inverse of a rule that is only known
/// by trying.
///
/// The result is a function of the target alone, whatever was asked before: dragging there and back gives the very
/// value of the start. Tried are values on the parameter's steps, its limits and the value of the start; a parameter
/// without steps gets decimal ones finer than a quarter pixel. Growth on both sides, steps, rounding and kinks cost
/// tries, not correctness; where several values end equally near, the one that arithmetic on the length suggests is
/// taken. Where a rule is rounded and a whole stretch of values ends at the same place, that is one and the same value for
/// all targets nearest to there, so that what nobody sees change is not said to change.
class ValueSearch {
public:
  /// `expectedSlope`: metres that the end is expected to move when the value grows by one, not 0; measured as soon as a
  /// search needs it. `toleranceM` > 0: what cannot be told apart on screen (a quarter pixel).
  ValueSearch(const Parameter& parameter, double startValue, double expectedSlope, double toleranceM);

  /// The value for an end at `targetM`, any number but NaN.
  double find(double targetM, const Reach& reach);

  /// Metres that the end moves when the value grows by one, where that is the same everywhere (measured by a few tries the first time it is asked for);
  /// nothing where the rule is rounded or bent.
  std::optional<double> straightSlope(const Reach& reach);

  /// Metres that the end moves when the value grows by one, hereabouts and on average: as expected until straightSlope() or find() has measured it.
  [[nodiscard]] double slope() const { return slope_; }

  /// Where a value ends: as `reach` has it, which is asked once for each value.
  std::optional<double> endAt(double value, const Reach& reach);
  /// Whether endAt() has the answer without asking.
  [[nodiscard]] bool knows(double value) const;

  /// How often `reach` was called so far.
  [[nodiscard]] int evaluations() const { return evaluations_; }

private:
  /// A step's number along the range, and by how much its end misses the target: positive when the value is too great.
  struct Tried {
    double step;
    double missM;
  };
  struct Bracket {
    std::optional<Tried> tooSmall, tooGreat;
  };

  void measureSlope(const Reach& reach);
  void chooseStep();
  double settled(double value, double targetM, const Reach& reach);
  [[nodiscard]] double valueOfStep(double step) const;
  [[nodiscard]] std::optional<double> nextStep(const Bracket& bracket, int round) const;

  Parameter parameter_;
  double startValue_;
  double expectedSlope_;
  double slope_;  ///< as measured
  double toleranceM_;
  double min_ = 0, max_ = 0;
  double stepSize_ = 0;
  double lastStep_ = 0;  ///< number of the step at max_
  bool measured_ = false;
  bool straight_ = false;  ///< the end moves in proportion to the value, as far as the first tries told
  bool bendSeen_ = false;  ///< later ones told otherwise
  int evaluations_ = 0;
  std::vector<std::pair<double, std::optional<double>>> known_;  ///< value and where it ends, sorted by value
};

}  // namespace dimline
