#include "cli/given_values.h"

#include "core/text.h"

namespace dimline {

Result<Assignments> assignmentsOf(const Arguments& arguments) {
  Assignments assignments;
  for (const std::string_view assignment : arguments.values("--set")) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = trim(assignment.substr(0, equals));
    if (equals == std::string_view::npos || name.empty()) {
      return Error{"--set takes NAME=VALUE, such as Width=9.5, not " + inQuotes(assignment) + "."};
    }
    assignments.emplace_back(name, assignment.substr(equals + 1));
  }
  return assignments;
}

Result<Values> valuesOf(const Model& model, const Assignments& assignments) {
  const auto parameters = model.parameters();
  Values values(parameters);
  for (const auto& [name, text] : assignments) {
    const auto index = findParameter(parameters, name);
    if (!index) return Error{"The model has no parameter " + inQuotes(name) + "; it has " + namesOf(parameters) + "."};
    const auto value = parseValue(parameters[*index], text);
    if (!value) return value.error();
    values.set(*index, *value);
  }
  return values;
}

}  // namespace dimline
