#include "cli/export_command.h"

#include <ostream>

#include "cli/given_values.h"
#include "cli/load_model.h"
#include "cli/output_file.h"
#include "core/text.h"
#include "gltf/gltf_writer.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline export MODEL [--set NAME=VALUE …] -o OUT.glb\n\n"
    "Writes a model as binary glTF 2.0: geometry, base colours and their textures. MODEL is a built-in name\n"
    "(dimline models lists them), or the path of a .gltf or .glb file.\n\n"
    "The file is the model at these values: parameters and scopes stay behind, and patterns, which the renderer\n"
    "draws, become one colour: a brick wall that of its bricks.\n\n"
    "  --set NAME=VALUE     a parameter's value, in its own unit; repeatable\n"
    "  -o OUT.glb           where the model goes; - is standard output\n";

constexpr OptionRule kRules[] = {kSetRule, {"-o", OptionRule::Kind::kValue, "OUT.glb"}};

Outcome run(std::span<const std::string_view> list, const Streams& streams) {
  const auto arguments = Arguments::parse(list, kRules);
  if (!arguments) return badArguments(arguments.error().message);
  const auto name = modelArgument(*arguments);
  if (!name) return badArguments(name.error().message);
  const auto assignments = assignmentsOf(*arguments);
  if (!assignments) return badArguments(assignments.error().message);
  const auto output = arguments->value("-o");
  if (!output) return badArguments("-o is missing: say where the model shall be written, as in -o OUT.glb.");
  if (output->empty()) return badArguments("-o needs a path that is not empty.");
  // Another ending would promise another format.
  if (*output != "-" && !endsIgnoringCase(*output, ".glb")) return badArguments("-o takes a name that ends in .glb, for that is what is written, not " + inQuotes(*output) + ".");

  const auto model = loadModel(*name, streams.err);
  if (!model) return badInput(model.error());
  const auto values = valuesOf(*model, *assignments);
  if (!values) return badInput(values.error());
  const auto glb = writeGlb(model->definition.build(*values), model->definition.title);
  if (!glb) return badInput({std::string(*name) + ": " + glb.error().message});
  if (*output == "-") {
    streams.out << *glb;
    return std::nullopt;
  }
  if (Status status = writeFile(std::string(*output), *glb); !status) return badInput(status.error());
  return std::nullopt;
}

}  // namespace

Command exportCommand() { return {"export", "a model as a .glb file", kHelp, run}; }

}  // namespace dimline
