#include "model/model.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace dimline {

namespace {

Status checkNumbers(const Parameter& parameter) {
  const std::string& name = parameter.name;
  if (!std::isfinite(parameter.min) || !std::isfinite(parameter.max)) {
    return Error{name + "'s range must have finite limits."};
  }
  if (parameter.min > parameter.max) {
    return Error{name + "'s range is empty: its least value, " + formatFixed(parameter.min, 3) +
                 ", is above its greatest, " + formatFixed(parameter.max, 3) + "."};
  }
  if (!std::isfinite(parameter.step) || parameter.step < 0) {
    return Error{name + "'s step must be 0 (any value) or a positive number."};
  }
  if (!(parameter.defaultValue >= parameter.min && parameter.defaultValue <= parameter.max)) {
    return Error{name + "'s default, " + formatFixed(parameter.defaultValue, 3) + ", lies outside its range, " +
                 formatFixed(parameter.min, 3) + " to " + formatFixed(parameter.max, 3) + "."};
  }
  const bool whole = parameter.type != ParameterType::kFloat && parameter.type != ParameterType::kAngle;
  for (const double number : {parameter.min, parameter.max, parameter.defaultValue, parameter.step}) {
    if (whole && number != std::round(number)) {
      return Error{name + " takes whole numbers only: its limits, default and step must be whole too."};
    }
  }
  return okStatus();
}

Status checkChoices(const Parameter& parameter) {
  const auto& choices = parameter.choices;
  if (choices.empty()) return Error{parameter.name + " is a choice without names to choose from."};
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (trim(choices[i]).empty()) return Error{parameter.name + " has a choice without a name."};
    if (std::find(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(i), choices[i]) !=
        choices.begin() + static_cast<std::ptrdiff_t>(i)) {
      return Error{parameter.name + " has two choices named " + inQuotes(choices[i]) + "."};
    }
  }
  return okStatus();
}

/// A switch and a choice have the only range they can have, and an angle its unit, so that nobody needs to write it down.
void normalise(Parameter& parameter) {
  if (parameter.type == ParameterType::kAngle) parameter.unit = Unit::kDegree;
  if (parameter.type == ParameterType::kBool) {
    parameter.min = 0;
    parameter.max = 1;
    parameter.step = 1;
  } else if (parameter.type == ParameterType::kChoice) {
    parameter.min = 0;
    parameter.max = std::max<double>(0, static_cast<double>(parameter.choices.size()) - 1);
    parameter.step = 1;
  } else if (parameter.type == ParameterType::kInt && parameter.step == 0) {
    parameter.step = 1;
  }
}

/// What kind of parameter a handle type is for, when this one is of another kind; empty when they go together.
std::string_view mismatch(const Parameter& parameter, const Annotation& annotation) {
  const ParameterType type = parameter.type;
  switch (annotation.type) {
    case HandleType::kBoolean:
      return type == ParameterType::kBool ? "" : "a switch";
    case HandleType::kRange:
      return type == ParameterType::kChoice ? "" : "a choice";
    case HandleType::kAngular:
      return type == ParameterType::kAngle || annotation.indirect ? "" : "an angle";
    default:
      break;
  }
  // A length can stand for a count or an angle, but only where the author says that the two differ.
  if (type == ParameterType::kFloat || type == ParameterType::kInt) return "";
  return type == ParameterType::kAngle && annotation.indirect ? "" : "a length";
}

/// The annotation beside a parameter, if it has a usable one; what is wrong with it goes to the diagnostics.
std::optional<Annotation> readAnnotation(const Parameter& parameter, std::vector<std::string>& diagnostics) {
  if (trim(parameter.annotation).empty()) return std::nullopt;
  auto parsed = parseAnnotation(parameter.annotation);
  if (!parsed) {
    diagnostics.push_back(parameter.name + ": " + parsed.error().message);
    return std::nullopt;
  }
  for (const std::string& warning : parsed->warnings) diagnostics.push_back(parameter.name + ": " + warning);
  const HandleType type = parsed->annotation.type;
  const std::string_view wanted = parameter.measure && !isLine(type) ? "a parameter, and this is a measure" : mismatch(parameter, parsed->annotation);
  if (wanted.empty()) {
    if (parsed->annotation.chained && !isLinear(type)) diagnostics.push_back(parameter.name + ": chained is for linear lines, so it is left out.");
    return parsed->annotation;
  }
  diagnostics.push_back(parameter.name + ": type=" + std::string(name(type)) + " is for " + std::string(wanted) + ", so it gets no handle.");
  return std::nullopt;
}

}  // namespace

Result<Model> makeModel(ModelDefinition definition) {
  if (trim(definition.name).empty()) return Error{"A model needs a name."};
  if (!definition.build) return Error{"The model " + inQuotes(definition.name) + " has no rule that builds it."};

  Model model;
  auto& parameters = definition.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Parameter& parameter = parameters[i];
    const auto inModel = [&](const Error& error) {
      return Error{"In the model " + inQuotes(definition.name) + ": " + error.message};
    };
    if (trim(parameter.name).empty()) return inModel(Error{"parameter " + std::to_string(i + 1) + " has no name."});
    if (trim(parameter.name) != parameter.name || parameter.name.find('=') != std::string::npos) {
      return inModel(Error{"the name " + inQuotes(parameter.name) + " has a blank at an end or an = in it, so nobody could set it by name."});
    }
    if (parameter.measure) return inModel(Error{parameter.name + " is a measure; it belongs among the model's measures."});
    if (*findParameter(parameters, parameter.name) != i) {
      return inModel(Error{"two parameters are named " + inQuotes(parameter.name) + "."});
    }
    if (parameter.type == ParameterType::kChoice) {
      if (Status status = checkChoices(parameter); !status) return inModel(status.error());
    }
    normalise(parameter);
    if (Status status = checkNumbers(parameter); !status) return inModel(status.error());

    model.annotations.push_back(readAnnotation(parameter, model.diagnostics));
  }
  for (Measure& measure : definition.measures) {
    const auto sameName = [&](const Measure& other) { return other.shown.name == measure.shown.name; };
    if (trim(measure.shown.name).empty() || findParameter(parameters, measure.shown.name) || std::ranges::count_if(definition.measures, sameName) > 1) {
      return Error{"In the model " + inQuotes(definition.name) + ": a measure needs a name of its own, not " + inQuotes(measure.shown.name) + "."};
    }
    measure.shown.measure = true;
    measure.shown.step = measure.shown.unit == Unit::kMetre ? 0.01 : 1;   // so many decimals are read
    model.measureAnnotations.push_back(readAnnotation(measure.shown, model.diagnostics));
  }
  model.definition = std::move(definition);
  return model;
}

Model withMeasures(const Model& model) {
  Model all = model;
  for (const Measure& measure : model.definition.measures) all.definition.parameters.push_back(measure.shown);
  all.annotations.insert(all.annotations.end(), model.measureAnnotations.begin(), model.measureAnnotations.end());
  all.definition.measures.clear();
  all.measureAnnotations.clear();
  return all;
}

Values withMeasures(const Model& model, const Values& values, const Scene& scene) {
  Values all = values;
  for (std::size_t i = 0; i < model.definition.measures.size(); ++i) all.append(measuredValue(model, i, values, scene));
  return all;
}

void addMeasureScopes(const Model& model, Scene& scene) {
  const auto aboutAll = [](const std::optional<Annotation>& annotation) { return annotation && annotation->scope == kModelScope; };
  if (scene.bounds.empty() || std::ranges::none_of(model.measureAnnotations, aboutAll)) return;
  scene.scopes.push_back({std::string(kModelScope), 0, {.origin = scene.bounds.min, .size = scene.bounds.size()}});
}

double measuredValue(const Model& model, std::size_t measure, const Values& values, const Scene& scene) {
  if (const auto& value = model.definition.measures[measure].value) return value(values, scene);
  const auto& annotation = model.measureAnnotations[measure];
  if (!annotation) return 0;
  const int axis = axisOf(annotation->orient).axis;
  if (annotation->scope == kModelScope && axis >= 0 && !scene.bounds.empty()) return scene.bounds.size()[axis];
  const auto scope = std::ranges::find(scene.scopes, annotation->scope, &Scope::name);
  return scope != scene.scopes.end() && axis >= 0 ? scope->box.size[axis] : 0;
}

}  // namespace dimline
