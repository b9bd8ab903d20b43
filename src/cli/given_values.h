#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments.h"
#include "model/model.h"

namespace dimline {

/// The --set NAME=VALUE of a command line, in order; views into it.
using Assignments = std::vector<std::pair<std::string_view, std::string_view>>;

/// The rule of --set, for the list that Arguments::parse() takes.
inline constexpr OptionRule kSetRule{"--set", OptionRule::Kind::kRepeatable, "NAME=VALUE"};

/// The error's exit status is kBadArguments.
Result<Assignments> assignmentsOf(const Arguments& arguments);

/// The model's defaults with what was set, later ones last, each in its parameter's own unit; off-step is accepted. An unknown name, a text that is no value and a
/// value out of range are errors: kBadInput.
Result<Values> valuesOf(const Model& model, const Assignments& assignments);

}  // namespace dimline
