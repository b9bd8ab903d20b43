#pragma once

#include <string_view>

#include "cli/arguments.h"
#include "cli/program.h"
#include "model/model.h"

namespace dimline {

/// The one MODEL that a command takes. The error's exit status is kBadArguments.
Result<std::string_view> modelArgument(const Arguments& arguments);

/// Says on `err` what of a model's annotations had to be left out, a line each; of a `builtIn` one also which scopes it never builds, and which lines do not measure what they say.
void printNotes(std::string_view name, const Model& model, bool builtIn, std::ostream& err);

/// The MODEL of a command line: a built-in name, or the path of a .gltf or .glb. Says on `err` what of it had to be left out.
Result<Model> loadModel(std::string_view nameOrPath, std::ostream& err);

}  // namespace dimline
