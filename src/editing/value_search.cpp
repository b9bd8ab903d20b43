#include "editing/value_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/power.h"

// Values are searched as numbers of steps from the least one, so that "neighbouring value" means something for every
// type. The search keeps the greatest step known to be too small and the least known to be too great, and tries between
// them: by interpolation, every third time by halving, which bounds the number of tries where the rule has jumps. Until
// both sides are known it strides out from the one it has. All that it decides on comes from this search; what earlier
// ones learned only saves calls.

namespace dimline {

namespace {

/// Tries in one search. A straight rule takes two or three, halving a thousand steps ten; more than this helps nobody
/// who waits for a frame.
constexpr int kMaxTries = 24;

/// Values whose ends are remembered over searches; then the memory starts anew. About 24 bytes each.
constexpr std::size_t kMaxKnown = 4096;

/// Share of the range over which the slope is measured: wide enough to average rounding, narrow enough to be about
/// here.
constexpr double kProbeShare = 0.125;

/// Where on the way to the probe it is looked whether the rule is straight: no simple fraction, which a rounded rule might meet.
constexpr double kBetweenShare = 0.618;

constexpr double kMostSteps = 1e9;

}  // namespace

ValueSearch::ValueSearch(const Parameter& parameter, double startValue, double expectedSlope, double toleranceM)
    : parameter_(parameter),
      startValue_(startValue),
      expectedSlope_(expectedSlope),
      slope_(expectedSlope),
      toleranceM_(toleranceM),
      min_(clampValue(parameter, -std::numeric_limits<double>::max())),
      max_(clampValue(parameter, std::numeric_limits<double>::max())) {}

double ValueSearch::find(double targetM, const Reach& reach) {
  if (std::isnan(targetM) || std::abs(targetM) <= toleranceM_ || !(max_ > min_)) return startValue_;
  if (!measured_) measureSlope(reach);
  // So far away that every value falls short, and yet a number to calculate with.
  const double farM = 4.0 * std::abs(slope_) * (max_ - min_) + 1e6;
  const double target = std::clamp(targetM, -farM, farM);
  const double sense = slope_ > 0 ? 1.0 : -1.0;
  const double startStep = (startValue_ - min_) / stepSize_;

  Bracket bracket;
  (sense * target > 0 ? bracket.tooSmall : bracket.tooGreat) = Tried{startStep, -sense * target};
  double best = startValue_;
  double bestMissM = std::abs(target);
  // The first that is tried is what arithmetic suggests; it also wins against equals, the value of the start included.
  double step = std::clamp(std::round(startStep + target / (slope_ * stepSize_)), 0.0, lastStep_);
  double validStep = startStep;
  for (int round = 0; round < kMaxTries; ++round) {
    const double value = valueOfStep(step);
    const auto end = endAt(value, reach);
    if (!end) {
      // No line there: half way back to where there is one.
      const double back = std::trunc(0.5 * (step + validStep));
      if (std::abs(back - validStep) < 1.0 || back == step) break;
      step = back;
      continue;
    }
    validStep = step;
    const double missM = sense * (*end - target);
    if (std::abs(missM) < bestMissM - 0.01 * toleranceM_ ||
        (round == 0 && std::abs(missM) <= bestMissM + 0.01 * toleranceM_)) {
      best = value;
      bestMissM = std::abs(missM);
    }
    if (std::abs(missM) <= toleranceM_) break;
    (missM < 0 ? bracket.tooSmall : bracket.tooGreat) = Tried{step, missM};
    const auto next = nextStep(bracket, round);
    if (!next) break;
    step = *next;
  }
  return settled(best, target, reach);
}

/// Of all values that end where this one does, always the same one: the one that the length at that place suggests, or else
/// the nearest to that.
double ValueSearch::settled(double value, double targetM, const Reach& reach) {
  if (straight_ || value == startValue_) return value;
  const double endM = endAt(value, reach).value_or(0.0);
  const auto endsThere = [&](double other) {
    const auto end = endAt(other, reach);
    return end && std::abs(*end - endM) <= 1e-3 * toleranceM_;
  };
  // Whoever pulls further than a limit means the limit.
  const double beyondM = (slope_ > 0 ? 1.0 : -1.0) * (targetM - endM);
  const double limit = beyondM > 0 ? max_ : min_;
  if (value == limit || (std::abs(beyondM) > toleranceM_ && endsThere(limit))) return limit;
  const double suggested = std::abs(endM) <= toleranceM_ ? startValue_ : snapValue(parameter_, startValue_ + endM / expectedSlope_);
  if (suggested == value) return value;
  if (endsThere(suggested)) return suggested;
  double inside = std::round((value - min_) / stepSize_);
  double outside = std::round((suggested - min_) / stepSize_);
  const double neighbour = inside + (outside > inside ? 1.0 : -1.0);
  if (neighbour == outside || !endsThere(valueOfStep(neighbour))) return value;
  for (inside = neighbour; std::abs(outside - inside) > 1.0;) {
    const double middle = std::round(0.5 * (inside + outside));
    (endsThere(valueOfStep(middle)) ? inside : outside) = middle;
  }
  return valueOfStep(inside);
}

/// The step to try after these, or nothing when none lies between them.
std::optional<double> ValueSearch::nextStep(const Bracket& bracket, int round) const {
  if (bracket.tooSmall && bracket.tooGreat) {
    const Tried& low = *bracket.tooSmall;
    const Tried& high = *bracket.tooGreat;
    // The rule may fall where it is expected to rise; then there is no "between" to search.
    const double first = std::floor(low.step) + 1.0;
    const double last = std::ceil(high.step) - 1.0;
    if (first > last) return std::nullopt;
    const double share = round % 3 == 2 ? 0.5 : low.missM / (low.missM - high.missM);
    return std::clamp(std::round(low.step + share * (high.step - low.step)), first, last);
  }
  const bool up = bracket.tooSmall.has_value();
  const Tried& from = up ? *bracket.tooSmall : *bracket.tooGreat;
  const double stride =
      std::max(1.0, std::round(std::abs(from.missM / (slope_ * stepSize_)))) * std::ldexp(1.0, std::max(0, round - 1));
  const double next = std::clamp(up ? std::floor(from.step) + stride : std::ceil(from.step) - stride, 0.0, lastStep_);
  if (up ? next <= from.step : next >= from.step) return std::nullopt;
  return next;
}

void ValueSearch::measureSlope(const Reach& reach) {
  measured_ = true;
  const double expected = slope_;
  const double width = std::max(kProbeShare * (max_ - min_), parameter_.step);
  const double towardsRoom = max_ - startValue_ >= startValue_ - min_ ? 1.0 : -1.0;
  for (const double sense : {towardsRoom, -towardsRoom}) {
    const double probe = snapValue(parameter_, startValue_ + sense * width);
    if (probe == startValue_) continue;
    const auto end = endAt(probe, reach);
    if (!end) continue;
    const double slope = *end / (probe - startValue_);
    if (std::abs(slope) < 1e-3 * std::abs(expected) || !std::isfinite(slope)) continue;
    slope_ = slope;
    const double between = snapValue(parameter_, startValue_ + kBetweenShare * sense * width);
    if (const auto at = endAt(between, reach)) straight_ = std::abs(*at - slope * (between - startValue_)) <= toleranceM_;
    break;
  }
  chooseStep();
}

std::optional<double> ValueSearch::straightSlope(const Reach& reach) {
  if (!(max_ > min_)) return std::nullopt;
  if (!measured_) measureSlope(reach);
  return straight_ && !bendSeen_ ? std::optional(slope_) : std::nullopt;
}

void ValueSearch::chooseStep() {
  const double range = max_ - min_;
  stepSize_ = parameter_.step;
  if (!(stepSize_ > 0)) {
    stepSize_ = powerOfTenWithin(toleranceM_ / std::abs(slope_));
    stepSize_ = std::max(stepSize_, range / kMostSteps);
    parameter_.step = stepSize_;
  }
  lastStep_ = std::max(1.0, std::ceil(range / stepSize_ - 1e-9));
}

double ValueSearch::valueOfStep(double step) const {
  if (step <= 0) return min_;
  if (step >= lastStep_) return max_;
  return snapValue(parameter_, min_ + step * stepSize_);
}

bool ValueSearch::knows(double value) const {
  const auto place = std::ranges::lower_bound(known_, value, {}, [](const auto& entry) { return entry.first; });
  return place != known_.end() && place->first == value;
}

std::optional<double> ValueSearch::endAt(double value, const Reach& reach) {
  const auto place = std::ranges::lower_bound(known_, value, {}, [](const auto& entry) { return entry.first; });
  if (place != known_.end() && place->first == value) return place->second;
  std::optional<double> end = reach(value);
  ++evaluations_;
  if (end && !std::isfinite(*end)) end.reset();
  if (straight_ && (!end || std::abs(*end - slope_ * (value - startValue_)) > toleranceM_)) bendSeen_ = true;
  if (known_.size() >= kMaxKnown) {
    known_.clear();
    known_.emplace_back(value, end);
  } else {
    known_.insert(place, {value, end});
  }
  return end;
}

}  // namespace dimline
