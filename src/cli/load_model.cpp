#include "cli/load_model.h"

#include <algorithm>
#include <ostream>

#include "core/text.h"
#include "gltf/gltf_reader.h"
#include "model/unknown_scopes.h"
#include "models/models.h"
#include "placement/untrue_lengths.h"

namespace dimline {

namespace {

bool isGltfPath(std::string_view name) { return endsIgnoringCase(name, ".gltf") || endsIgnoringCase(name, ".glb"); }

}  // namespace

Result<std::string_view> modelArgument(const Arguments& arguments) {
  const auto positional = arguments.positional();
  if (positional.empty())
    return Error{"Name a model: a built-in one (dimline models lists them), or a .gltf or .glb file."};
  if (positional.size() > 1) return Error{"One model at a time: " + inQuotes(positional[1]) + " is too much."};
  return positional[0];
}

void printNotes(std::string_view name, const Model& model, bool builtIn, std::ostream& err) {
  const auto note = [&](const std::string& diagnostic) { err << "dimline: note: " << name << ": " << diagnostic << "\n"; };
  std::ranges::for_each(model.diagnostics, note);
  if (!builtIn) return;
  std::ranges::for_each(findUnknownScopes(model), note);
  std::ranges::for_each(findUntrueLengths(model), note);
}

Result<Model> loadModel(std::string_view nameOrPath, std::ostream& err) {
  const bool fromFile = isGltfPath(nameOrPath);
  auto model = fromFile ? readGltfFile(std::string(nameOrPath)) : findBuiltInModel(nameOrPath);
  const bool unknown = !fromFile && std::ranges::find(builtInModels(), nameOrPath, &BuiltInModel::name) == builtInModels().end();
  if (unknown) return Error{model.error().message + " A model in a file ends in .gltf or .glb."};
  if (!model) return model.error();
  printNotes(nameOrPath, *model, !fromFile, err);
  return model;
}

}  // namespace dimline
