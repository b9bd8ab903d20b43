#include "cli/bench_command.h"

#include <ostream>

#include "cli/arguments.h"
#include "cli/bench_report.h"
#include "cli/load_model.h"
#include "core/text.h"
#include "models/models.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline bench MODEL|all [options]\n\n"
    "Measures how long it takes to place a model's dimension lines, beside what the paper reports and beside a\n"
    "straightforward version without distance fields; then how that grows with triangles, with base lines and with "
    "the\n"
    "viewport.\n\n"
    "  --frames N    frames of the orbit, 360 unless told\n"
    "  --gpu         also the distance fields from the GPU\n"
    "  --no-growth   leaves the growth tables out\n"
    "  --json        an array of objects in place of the tables, times in ms, null where it was not measured\n";

constexpr OptionRule kRules[] = {{"--frames", OptionRule::Kind::kValue, "N"},
                                 {"--gpu", OptionRule::Kind::kFlag, {}},
                                 {"--no-growth", OptionRule::Kind::kFlag, {}},
                                 {"--json", OptionRule::Kind::kFlag, {}}};

Outcome run(std::span<const std::string_view> list, const Streams& streams) {
  const auto arguments = Arguments::parse(list, kRules);
  if (!arguments) return badArguments(arguments.error().message);
  if (arguments->positional().size() != 1) return badArguments("Name one model, or all.");
  BenchPlan plan{.gpu = arguments->has("--gpu")};
  if (const auto text = arguments->value("--frames")) {
    const auto frames = parseDouble(trim(*text));
    if (!frames || !(*frames >= 1 && *frames <= 3600) || *frames != static_cast<int>(*frames)) {
      return badArguments("--frames takes a whole number from 1 to 3600, not " + inQuotes(*text) + ".");
    }
    plan.frames = static_cast<int>(*frames);
  }

  std::vector<std::string_view> names{arguments->positional()[0]};
  if (names[0] == "all") {
    names.clear();
    for (const BuiltInModel& model : builtInModels()) names.push_back(model.name);
  }
  std::vector<BenchResult> results;
  for (const std::string_view name : names) {
    const auto model = loadModel(name, streams.err);
    if (!model) return badInput(model.error());
    streams.err << "dimline: measuring " << name << "\n" << std::flush;
    auto result = benchModel(*model, plan);
    if (!result) return badInput(Error{result.error().message + " Or leave --gpu out."});
    results.push_back(std::move(result).value());
  }
  if (arguments->has("--json")) {
    JsonWriter json;
    writeBench(json, results);
    streams.out << json.text() << "\n";
    return std::nullopt;
  }
  printBench(results, streams.out);
  if (!arguments->has("--no-growth")) printGrowth(streams.out);
  return std::nullopt;
}

}  // namespace

Command benchCommand() { return {"bench", "how long placing the lines takes", kHelp, run}; }

}  // namespace dimline
