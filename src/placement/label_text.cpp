#include "placement/label_text.h"

namespace dimline {

std::string labelText(const Parameter& parameter, double value) {
  const std::string text = formatValue(parameter, value);
  const bool bare = parameter.unit == Unit::kNone && (parameter.type == ParameterType::kInt || parameter.type == ParameterType::kFloat);
  if (!bare) return text;
  if (parameter.noun.empty()) return parameter.title + " " + text;
  return text + " " + (value == 1 ? parameter.noun : pluralNoun(parameter));
}

}  // namespace dimline
