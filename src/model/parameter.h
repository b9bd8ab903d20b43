#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/annotation.h"

namespace dimline {

enum class ParameterType { kFloat, kInt, kAngle, kBool, kChoice };
enum class Unit { kNone, kMetre, kDegree, kSquareMetre };

/// One named value that shapes a model: what an author writes down. A value is always a double: metres, a count, degrees
/// for an angle (its own unit, at every outer boundary and inside Values alike; models convert where they use it), 0 or 1, or the index
/// of a choice.
struct Parameter {
  std::string name{};                ///< identifier, unique in the model: "WindowWidth"
  std::string title{};               ///< for people: "Window width"
  std::string help{};                ///< one sentence for a novice: what it changes
  std::string group{};               ///< heading under which the panel shows it: "Windows"
  ParameterType type = ParameterType::kFloat;
  Unit unit = Unit::kNone;
  double defaultValue = 0;
  double min = 0;
  double max = 1;
  double step = 0;                   ///< 0: any value; typed and scripted values may be off-step, drags snap to it
  std::string noun{};                ///< what a count counts, in the singular, for labels: "floor" gives "2 floors"
  std::string plural{};              ///< where it is not the noun with an s: "shelves"
  std::vector<std::string> choices{};  ///< names of the choices, for kChoice
  std::string annotation{};          ///< the text beside the definition (model/annotation.h reads it); empty: only in the panel
  bool measure = false;              ///< follows from other values: shown by a line that nobody can drag (see Measure)
  char decimalMark = '.';            ///< in values that people read: '.' or ','. Never an author's choice; a host sets it to its visitor's
};

/// The values of a model's parameters, in the order of their definition.
class Values {
 public:
  Values() = default;
  explicit Values(std::span<const Parameter> parameters);

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] double at(std::size_t index) const { return values_[index]; }
  void set(std::size_t index, double value) { values_[index] = value; }
  void append(double value) { values_.push_back(value); }
  bool operator==(const Values&) const = default;

 private:
  std::vector<double> values_;
};

/// Index of the parameter with that name, or nothing.
std::optional<std::size_t> findParameter(std::span<const Parameter> parameters, std::string_view name);
/// Their names for a sentence, "Width, Depth and Floors".
std::string namesOf(std::span<const Parameter> parameters);

/// The nearest value that the parameter allows: into [min, max], whole for counts, choices and booleans; NaN gives the default.
/// Does not round floats to the step.
double clampValue(const Parameter& parameter, double value);

/// clampValue, then to the nearest step counted from min. The limits themselves are always reachable.
double snapValue(const Parameter& parameter, double value);

/// A value from text in the parameter's own unit ("3.5", "true", "gable"), or an error that names the parameter, what was
/// read, and the values that are allowed. Out of range is an error; off-step is not.
Result<double> parseValue(const Parameter& parameter, std::string_view text);

/// The value as people read it, with its unit and the parameter's decimal mark: "2.40 m", "35°", "3", "on", "gable".
std::string formatValue(const Parameter& parameter, double value);

/// What several of a count are called: its plural, or its noun with an s.
std::string pluralNoun(const Parameter& parameter);

/// The unit as it follows a number: " m", "°", " m²", "".
std::string_view unitSuffix(Unit unit);

/// "float", "int", "angle", "bool", "choice"; and "m", "deg", "m2" or "".
std::string_view name(ParameterType type);
std::string_view name(Unit unit);

}  // namespace dimline
