#include "model/unknown_scopes.h"

#include <algorithm>
#include <set>

#include "core/text.h"

namespace dimline {

namespace {

using Names = std::set<std::string, std::less<>>;

void addScopes(const Model& model, const Values& values, Names& names) {
  for (const Scope& scope : model.definition.build(values).scopes) names.insert(scope.name);
}

/// An annotation with what it stands beside.
struct Use {
  const Parameter& beside;
  const Annotation& annotation;
};

std::vector<Use> usesOf(const Model& model) {
  std::vector<Use> uses;
  for (std::size_t i = 0; i < model.annotations.size(); ++i) {
    if (model.annotations[i]) uses.push_back({model.parameters()[i], *model.annotations[i]});
  }
  for (std::size_t i = 0; i < model.measureAnnotations.size(); ++i) {
    const auto& annotation = model.measureAnnotations[i];
    if (annotation && annotation->scope != kModelScope) uses.push_back({model.definition.measures[i].shown, *annotation});
  }
  return uses;
}

}  // namespace

std::vector<std::string> findUnknownScopes(const Model& model) {
  const std::vector<Use> uses = usesOf(model);
  const auto parameters = model.parameters();
  const Values defaults(parameters);
  Names names;
  const auto allKnown = [&] { return std::ranges::all_of(uses, [&](const Use& use) { return names.contains(use.annotation.scope); }); };
  addScopes(model, defaults, names);
  for (std::size_t i = 0; i < parameters.size() && !allKnown(); ++i) {
    const bool choice = parameters[i].type == ParameterType::kChoice;
    const double step = choice ? 1 : std::max(parameters[i].max - parameters[i].min, 1e-9);
    for (double value = parameters[i].min; value <= parameters[i].max; value += step) {
      Values values = defaults;
      values.set(i, value);
      addScopes(model, values, names);
    }
  }

  std::vector<std::string> found;
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const Use& use : uses) {
    if (names.contains(use.annotation.scope)) continue;
    const std::string_view why = use.annotation.scope == kModelScope ? ", which is for measures only" : "";
    found.push_back(use.beside.name + ": the model has no scope named " + inQuotes(use.annotation.scope) + std::string(why) + ", so this gets no handle; " +
                    (known.empty() ? std::string("it has none at all.") : "it has " + joined(known) + "."));
  }
  return found;
}

}  // namespace dimline
