#include "cli/models_command.h"

#include <iomanip>
#include <ostream>
#include <set>

#include "app/json.h"
#include "cli/arguments.h"
#include "models/models.h"
#include "placement/base_lines.h"
#include "placement/chains.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline models [--json]\n\n"
    "Lists the built-in models, with their sizes at the default values.\n\n"
    "  --json    an array of objects: name, title, triangles, baseLines, clusteredBaseLines, clusters\n"
    "            and parameters\n";

struct ModelStatistics {
  std::size_t triangles = 0;
  std::size_t baseLines = 0;           ///< of all parameters with a dimension line, seen or not
  std::size_t clusteredBaseLines = 0;  ///< those of them that belong to a cluster
  std::size_t clusters = 0;
};

ModelStatistics statisticsOf(const Model& model) {
  const Scene scene = model.definition.build(Values(model.parameters()));
  // How many base lines a scope has does not depend on the camera.
  const View view(threeQuarterView(scene.bounds, 1000, 1000), 1000, 1000, scene.bounds);
  ModelStatistics statistics;
  statistics.triangles = scene.triangleCount();
  for (const auto& annotation : model.annotations) {
    if (!annotation || !isLine(annotation->type)) continue;
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < scene.scopes.size(); ++i) {
      if (scene.scopes[i].name != annotation->scope) continue;
      measured.push_back(i);
      statistics.baseLines += baseLines(*annotation, scene.scopes[i].box, view).size();
    }
    if (!annotation->chained) continue;
    const auto clusters = clusterBaseLines(*annotation, scene.scopes, measured, scene.bounds.diagonal());
    statistics.clusters += clusters.size();
    // A base line is in a cluster for each of its planes, and counts once.
    std::set<std::array<double, 7>> lines;
    for (const Cluster& cluster : clusters) {
      for (const ChainMember& member : cluster.members) {
        const auto& [start, end] = member.segment;
        lines.insert({static_cast<double>(member.scope), start.x, start.y, start.z, end.x, end.y, end.z});
      }
    }
    statistics.clusteredBaseLines += lines.size();
  }
  return statistics;
}

void writeJson(const Model& model, JsonWriter& json) {
  const ModelStatistics statistics = statisticsOf(model);
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
  const ModelStatistics statistics = statisticsOf(model);
  out << std::left << std::setw(16) << model.definition.name << std::setw(28) << model.definition.title << std::right
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
    streams.out << std::left << std::setw(16) << "name" << std::setw(28) << "title" << std::right << std::setw(10)
                << "triangles" << std::setw(12) << "parameters" << std::setw(12) << "base lines" << std::setw(14)
                << "in clusters" << std::setw(10) << "clusters" << "\n";
  }
  for (const BuiltInModel& builtIn : builtInModels()) {
    const auto model = makeModel(builtIn.define());
    if (!model) return badInput(model.error());
    for (const std::string& diagnostic : model->diagnostics) {
      streams.err << "dimline: note: " << builtIn.name << ": " << diagnostic << "\n";
    }
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
