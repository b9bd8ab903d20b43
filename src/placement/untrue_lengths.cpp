#include "placement/untrue_lengths.h"

#include <cmath>

#include "core/text.h"
#include "placement/measured.h"

namespace dimline {

namespace {

/// Of the value. What an author rounds is not meant.
constexpr double kUntrueShare = 0.01;

}  // namespace

std::vector<std::string> findUntrueLengths(const Model& model) {
  const Values defaults(model.parameters());
  const Scene scene = model.definition.build(defaults);
  std::vector<std::string> found;
  for (const Measured& measured : measure(model, scene.scopes, scene.bounds.diagonal())) {
    if (!isLine(measured.annotation.type) || measured.annotation.indirect || measured.scopes.empty()) continue;
    const double value = defaults.at(measured.parameter);
    if (std::abs(measured.meanLengthM - value) <= kUntrueShare * std::abs(value)) continue;
    const Parameter& parameter = model.parameters()[measured.parameter];
    found.push_back(parameter.name + ": the line on " + inQuotes(measured.annotation.scope) + " is " + formatFixed(measured.meanLengthM, 2) + " m long, but the value is " +
                    formatValue(parameter, value) + "; where that is meant, write indirect in the annotation, and a drag follows the value.");
  }
  return found;
}

}  // namespace dimline
