#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/parameter.h"
#include "model/scene.h"

namespace dimline {

/// A parametric model: its parameters and the rule that turns values into a scene. The rule is a pure function: the same
/// values give the same bytes. It must accept every value that clampValue lets through.
struct ModelDefinition {
  std::string name;    ///< id: "house"
  std::string title;   ///< for people: "Family house"
  std::vector<Parameter> parameters;
  std::function<Scene(const Values&)> build;
};

/// A model whose annotations have been read. Parallel to `definition.parameters`: annotation i belongs to parameter i, and
/// a parameter without one (or with one that has an error) has none. Nothing that an author misspells keeps a model from loading.
struct Model {
  ModelDefinition definition;
  std::vector<std::optional<Annotation>> annotations;
  std::vector<std::string> diagnostics;   ///< errors and warnings of the annotations, each naming its parameter

  [[nodiscard]] std::span<const Parameter> parameters() const { return definition.parameters; }
};

/// Reads the annotations of a definition. An error only when the definition itself is unusable: two parameters of one name, a
/// range that is empty or not finite, a default outside it, a choice without names.
Result<Model> makeModel(ModelDefinition definition);

}  // namespace dimline
