#include "cli/models_command.h"

#include <iomanip>
#include <ostream>

#include "app/json.h"
#include "cli/arguments.h"
#include "cli/load_model.h"
#include "cli/model_statistics.h"
#include "models/models.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline models [--json]\n\n"
    "Lists the built-in models, with their sizes at the default values.\n\n"
    "  --json    an array of objects: name, title, triangles, baseLines, clusteredBaseLines, clusters\n"
    "            and parameters\n";

void writeJson(const Model& model, JsonWriter& json) {
  const ModelStatistics statistics = statisticsOf(model, model.definition.build(Values(model.parameters())));
  json.beginObject();
  json.key("name").value(model.definition.name);
  json.key("title").value(model.definition.title);
  json.key("triangles").value(statistics.triangles);
  json.key("baseLines").value(statistics.baseLines);
  json.key("clusteredBaseLines").value(statistics.clusteredBaseLines);
  json.key("clusters").value(statistics.clusters);
  json.key("parameters");
  writeParameters(json, model.parameters(), Values(model.parameters()));
  json.endObject();
}

void writeTableRow(const Model& model, std::ostream& out) {
  const ModelStatistics statistics = statisticsOf(model, model.definition.build(Values(model.parameters())));
  out << std::left << std::setw(22) << model.definition.name << std::setw(28) << model.definition.title << std::right
      << std::setw(10) << statistics.triangles << std::setw(12) << model.parameters().size() << std::setw(12)
      << statistics.baseLines << std::setw(14) << statistics.clusteredBaseLines << std::setw(10) << statistics.clusters
      << "\n";
}

Outcome run(std::span<const std::string_view> list, const Streams& streams) {
  static constexpr OptionRule kRules[] = {{"--json", OptionRule::Kind::kFlag, {}}};
  const auto arguments = Arguments::parse(list, kRules);
  if (!arguments) return badArguments(arguments.error().message);
  if (!arguments->positional().empty()) return badArguments("models takes no names; it lists them all.");

  const bool asJson = arguments->has("--json");
  JsonWriter json;
  json.beginArray();
  if (!asJson) {
    streams.out << std::left << std::setw(22) << "name" << std::setw(28) << "title" << std::right << std::setw(10)
                << "triangles" << std::setw(12) << "parameters" << std::setw(12) << "base lines" << std::setw(14)
                << "in clusters" << std::setw(10) << "clusters" << "\n";
  }
  for (const BuiltInModel& builtIn : builtInModels()) {
    const auto model = makeModel(builtIn.define());
    if (!model) return badInput(model.error());
    printNotes(builtIn.name, *model, true, streams.err);
    if (asJson) {
      writeJson(*model, json);
    } else {
      writeTableRow(*model, streams.out);
    }
  }
  json.endArray();
  if (asJson) streams.out << json.text() << "\n";
  return std::nullopt;
}

}  // namespace

Command modelsCommand() { return {"models", "the built-in models", kHelp, run}; }

}  // namespace dimline
