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

/// The scope that a measure's annotation may name in place of one of the model's: the upright box about all of it. Parameters cannot, since it is there only
/// while measures are shown.
inline constexpr std::string_view kModelScope = "Model";

/// A value that follows from others and is only read: an overall height, a floor area.
struct Measure {
  Parameter shown;   ///< its name, title, help, unit and annotation, which must be that of a dimension line, or none; range, step and default mean nothing
  /// In the unit of `shown`. Empty: the size, along the line's axis, of the first scope that the annotation names.
  std::function<double(const Values&, const Scene&)> value{};
};

/// A parametric model: its parameters and the rule that turns values into a scene. The rule is a pure function: the same
/// values give the same bytes. It must accept every value that clampValue lets through.
struct ModelDefinition {
  std::string name;    ///< id: "house"
  std::string title;   ///< for people: "Family house"
  std::vector<Parameter> parameters;
  std::function<Scene(const Values&)> build;
  std::vector<Measure> measures{};
};

/// A model whose annotations have been read. Parallel to `definition.parameters`: annotation i belongs to parameter i, and
/// a parameter without one (or with one that has an error) has none. Nothing that an author misspells keeps a model from loading.
struct Model {
  ModelDefinition definition;
  std::vector<std::optional<Annotation>> annotations;
  std::vector<std::optional<Annotation>> measureAnnotations;   ///< parallel to `definition.measures`
  std::vector<std::string> diagnostics;   ///< errors and warnings of the annotations, each naming its parameter

  [[nodiscard]] std::span<const Parameter> parameters() const { return definition.parameters; }
};

/// Reads the annotations of a definition. An error only when the definition itself is unusable: two parameters of one name, a
/// range that is empty or not finite, a default outside it, a choice without names.
Result<Model> makeModel(ModelDefinition definition);

/// The model with its measures as further parameters behind its own, for a placer that shows them too.
Model withMeasures(const Model& model);

/// The values that belong to it: those of the parameters, then those of the measures in a scene.
Values withMeasures(const Model& model, const Values& values, const Scene& scene);

/// Adds kModelScope to a scene of the model, if a measure is about it.
void addMeasureScopes(const Model& model, Scene& scene);

/// What one of the model's measures amounts to.
double measuredValue(const Model& model, std::size_t measure, const Values& values, const Scene& scene);

}  // namespace dimline
