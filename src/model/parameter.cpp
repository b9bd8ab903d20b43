#include "model/parameter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/text.h"

namespace dimline {

namespace {

/// Share of the range by which a typed value may miss its limits: a limit that went through text is still the limit.
constexpr double kRangeTolerance = 1e-9;

bool isWhole(const Parameter& parameter) {
  return parameter.type == ParameterType::kInt || parameter.type == ParameterType::kBool ||
         parameter.type == ParameterType::kChoice;
}

struct Range {
  double min, max;
};

/// The limits that count: a switch and a choice have their own whatever the definition says, a count has whole ones.
Range rangeOf(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::kBool:
      return {0, 1};
    case ParameterType::kChoice:
      return {0, std::max<double>(0, static_cast<double>(parameter.choices.size()) - 1)};
    case ParameterType::kInt:
      return {std::ceil(parameter.min), std::floor(parameter.max)};
    case ParameterType::kFloat:
    case ParameterType::kAngle:
      break;
  }
  return {parameter.min, parameter.max};
}

/// The double nearest to the value's first 12 digits: 0.6 + 7 * 0.05 becomes 0.95 and not its neighbour.
double withoutNoise(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.12g", value);
  return std::strtod(buffer, nullptr);
}

/// Decimals at which the parameter's steps can be told apart, for a quantity that is read with `least` of them.
int decimalsFor(const Parameter& parameter, int least) {
  const double step = parameter.step > 0 ? parameter.step : (parameter.max - parameter.min) / 1000;
  if (!(step > 0)) return least;
  // Half a decimal's tolerance keeps 0.01, which is no exact double, at two.
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), least, 6);
}

/// Takes the parameter's own unit from the end of a number, in the ways in which people type it.
std::string_view withoutUnit(std::string_view text, Unit unit) {
  static constexpr std::string_view kMetre[] = {"m"};
  static constexpr std::string_view kDegree[] = {"degrees", "deg", "\xC2\xB0"};
  static constexpr std::string_view kSquareMetre[] = {"m2", "m\xC2\xB2"};
  std::span<const std::string_view> spellings;
  if (unit == Unit::kMetre) spellings = kMetre;
  if (unit == Unit::kDegree) spellings = kDegree;
  if (unit == Unit::kSquareMetre) spellings = kSquareMetre;
  for (const std::string_view spelling : spellings) {
    if (text.ends_with(spelling)) return trim(text.substr(0, text.size() - spelling.size()));
  }
  return text;
}

Result<double> parseBool(const Parameter& parameter, std::string_view text) {
  for (const std::string_view yes : {"true", "on", "yes", "1"}) {
    if (equalIgnoringCase(text, yes)) return 1.0;
  }
  for (const std::string_view no : {"false", "off", "no", "0"}) {
    if (equalIgnoringCase(text, no)) return 0.0;
  }
  return Error{parameter.name + " is a switch: it takes true or false, not " + inQuotes(text) + "."};
}

Result<double> parseChoice(const Parameter& parameter, std::string_view text) {
  const auto& choices = parameter.choices;
  auto found = std::find(choices.begin(), choices.end(), text);
  if (found == choices.end()) {
    found =
        std::find_if(choices.begin(), choices.end(), [&](const std::string& c) { return equalIgnoringCase(c, text); });
  }
  if (found != choices.end()) return static_cast<double>(found - choices.begin());
  const std::vector<std::string_view> names(choices.begin(), choices.end());
  return Error{parameter.name + " takes " + joined(names, "or") + ", not " + inQuotes(text) + "."};
}

Result<double> parseNumber(const Parameter& parameter, std::string_view text) {
  const std::optional<double> value = parseDouble(withoutUnit(text, parameter.unit));
  if (!value)
    return Error{parameter.name + " takes a number, such as " + formatValue(parameter, parameter.defaultValue) +
                 ", not " + inQuotes(text) + "."};
  if (parameter.type == ParameterType::kInt && *value != std::round(*value)) {
    return Error{parameter.name + " takes a whole number, not " + inQuotes(text) + "."};
  }
  const Range range = rangeOf(parameter);
  const double tolerance = kRangeTolerance * (range.max - range.min);
  if (*value < range.min - tolerance || *value > range.max + tolerance) {
    return Error{parameter.name + " must lie between " + formatValue(parameter, range.min) + " and " +
                 formatValue(parameter, range.max) + ", so it cannot be " + inQuotes(text) + "."};
  }
  return std::clamp(*value, range.min, range.max);
}

}  // namespace

Values::Values(std::span<const Parameter> parameters) {
  values_.reserve(parameters.size());
  for (const Parameter& parameter : parameters) values_.push_back(parameter.defaultValue);
}

std::optional<std::size_t> findParameter(std::span<const Parameter> parameters, std::string_view name) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == name) return i;
  }
  return std::nullopt;
}

std::string namesOf(std::span<const Parameter> parameters) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return joined(names);
}

double clampValue(const Parameter& parameter, double value) {
  if (std::isnan(value)) return parameter.defaultValue;
  const Range range = rangeOf(parameter);
  if (range.max < range.min) return parameter.defaultValue;
  const double clamped = std::clamp(value, range.min, range.max);
  return isWhole(parameter) ? std::round(clamped) : clamped;
}

double snapValue(const Parameter& parameter, double value) {
  const double clamped = clampValue(parameter, value);
  const Range range = rangeOf(parameter);
  // A choice has no distance between its values, so a step says nothing about it.
  const bool stepless = parameter.type == ParameterType::kBool || parameter.type == ParameterType::kChoice;
  if (stepless || !(parameter.step > 0) || clamped == range.min || clamped == range.max) return clamped;

  const double steps = std::round((clamped - range.min) / parameter.step);
  double snapped = withoutNoise(range.min + steps * parameter.step);
  // The last step may be a short one.
  if (snapped > range.max || std::abs(range.max - clamped) < std::abs(snapped - clamped)) snapped = range.max;
  return clampValue(parameter, snapped);
}

Result<double> parseValue(const Parameter& parameter, std::string_view text) {
  const std::string_view trimmed = trim(text);
  switch (parameter.type) {
    case ParameterType::kBool:
      return parseBool(parameter, trimmed);
    case ParameterType::kChoice:
      return parseChoice(parameter, trimmed);
    case ParameterType::kFloat:
    case ParameterType::kInt:
    case ParameterType::kAngle:
      break;
  }
  return parseNumber(parameter, trimmed);
}

std::string pluralNoun(const Parameter& parameter) { return parameter.plural.empty() ? parameter.noun + "s" : parameter.plural; }

std::string_view unitSuffix(Unit unit) {
  switch (unit) {
    case Unit::kMetre:
      return " m";
    case Unit::kDegree:
      return "\xC2\xB0";
    case Unit::kSquareMetre:
      return " m\xC2\xB2";
    case Unit::kNone:
      break;
  }
  return "";
}

std::string formatValue(const Parameter& parameter, double value) {
  switch (parameter.type) {
    case ParameterType::kBool:
      return value >= 0.5 ? "on" : "off";
    case ParameterType::kChoice: {
      const auto index = static_cast<std::size_t>(clampValue(parameter, value));
      return index < parameter.choices.size() ? parameter.choices[index] : std::string();
    }
    case ParameterType::kInt:
      return formatFixed(value, 0) + std::string(unitSuffix(parameter.unit));
    case ParameterType::kFloat:
    case ParameterType::kAngle:
      break;
  }
  int decimals = 2;
  if (parameter.unit == Unit::kDegree || parameter.unit == Unit::kSquareMetre) {
    // Whole degrees and square metres are what people say; a value between them shows that it is one.
    const bool wholeSteps = parameter.step > 0 && parameter.step == std::round(parameter.step);
    decimals = wholeSteps && std::abs(value - std::round(value)) < 0.05 ? 0 : 1;
  } else {
    decimals = decimalsFor(parameter, 2);
  }
  std::string text = formatFixed(value, decimals);
  std::ranges::replace(text, '.', parameter.decimalMark);
  return text + std::string(unitSuffix(parameter.unit));
}

std::string_view name(ParameterType type) {
  switch (type) {
    case ParameterType::kFloat:
      return "float";
    case ParameterType::kInt:
      return "int";
    case ParameterType::kAngle:
      return "angle";
    case ParameterType::kBool:
      return "bool";
    case ParameterType::kChoice:
      return "choice";
  }
  return "";
}

std::string_view name(Unit unit) {
  switch (unit) {
    case Unit::kNone:
      return "";
    case Unit::kMetre:
      return "m";
    case Unit::kDegree:
      return "deg";
    case Unit::kSquareMetre:
      return "m2";
  }
  return "";
}

}  // namespace dimline
