#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/parameter.h"
#include "support/random.h"

/// Built-in models, and settings of a model's parameters, for what must hold in all of them.
namespace dimline::test {

/// Under the sanitizers, where all is slow, a few models stand for all.
inline bool tested([[maybe_unused]] std::string_view model) {
#ifdef __SANITIZE_ADDRESS__
  return model == "house" || model == "lever" || model == "facade";
#else
  return true;
#endif
}

/// Any setting: limits more often than chance would have them, floats off their steps.
inline Values anySetting(std::span<const Parameter> parameters, Random& random) {
  Values values(parameters);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& p = parameters[i];
    const double pick = random.real(0, 1);
    values.set(i, clampValue(p, pick < 0.15 ? p.min : pick < 0.3 ? p.max : random.real(p.min, p.max)));
  }
  return values;
}

/// The defaults, each parameter's limits and choices, and so many random settings.
inline std::vector<Values> manySettings(std::span<const Parameter> parameters, std::size_t randomOnes) {
  std::vector<Values> all{Values(parameters)};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    const int stops = p.type == ParameterType::kChoice ? static_cast<int>(p.choices.size()) : 2;
    for (int k = 0; k < stops; ++k) {
      all.emplace_back(parameters);
      all.back().set(i, p.min + (p.max - p.min) * k / (stops > 1 ? stops - 1 : 1));
    }
  }
  Random random(20);
  for (std::size_t i = 0; i < randomOnes; ++i) all.push_back(anySetting(parameters, random));
  return all;
}

inline std::string text(std::span<const Parameter> parameters, const Values& values) {
  std::string s;
  for (std::size_t i = 0; i < values.size(); ++i) s += parameters[i].name + "=" + formatValue(parameters[i], values.at(i)) + " ";
  return s;
}

}  // namespace dimline::test
