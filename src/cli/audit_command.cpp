#include "cli/audit_command.h"

#include <ostream>

#include "cli/arguments.h"
#include "cli/audit_report.h"
#include "cli/given_values.h"
#include "cli/load_model.h"
#include "cli/output_file.h"
#include "cli/size_text.h"
#include "core/text.h"
#include "models/models.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline audit MODEL|all [options]\n\n"
    "Places a model's dimension lines along three orbits (elevation 10, 30 and 60 degrees) and measures how well they\n"
    "keep the principles of dimensioning: from the pixels that the model covers and the layouts alone. Beside each\n"
    "figure stands what lines that stay fixed in the world come to, and the aim.\n\n"
    "  --set NAME=VALUE  a parameter's value, in its own unit; repeatable\n"
    "  --size WxH        the orbits' viewport in pixels, 1000x1000 unless told\n"
    "  --step DEG        the orbits' step, 1 unless told; the rows that compare frames mean 1\n"
    "  --every N         holds one of N frames against its pixels; all are placed and compared. Unless told, each\n"
    "                    in the orbits, one of 15 at extremes, one of 12 in flights\n"
    "  --rests DEG       also the orbits, and the flights, with a rest after each turn by so much, where the lines settle\n"
    "                    as they do when a hand lets go of the camera: measures these pictures alone\n"
    "  --extremes        also the orbits at each parameter's least and greatest value\n"
    "  --flights N       also N random flights: round the model, into it and back; all kinds of lens and viewport\n"
    "  --worst K         lists the K gravest cases under each row that misses its aim\n"
    "  --svg FOLDER      with --worst: also writes the drawings of those cases, FOLDER/orbits-flicker-1.svg and so on;\n"
    "                    of all models each in a folder of its name\n"
    "  --json            an array of objects in place of the tables\n";

constexpr OptionRule kRules[] = {kSetRule,
                                 {"--size", OptionRule::Kind::kValue, "WxH"},
                                 {"--step", OptionRule::Kind::kValue, "DEG"},
                                 {"--every", OptionRule::Kind::kValue, "N"},
                                 {"--rests", OptionRule::Kind::kValue, "DEG"},
                                 {"--extremes", OptionRule::Kind::kFlag, {}},
                                 {"--flights", OptionRule::Kind::kValue, "N"},
                                 {"--worst", OptionRule::Kind::kValue, "K"},
                                 {"--svg", OptionRule::Kind::kValue, "FOLDER"},
                                 {"--json", OptionRule::Kind::kFlag, {}}};

struct AuditOptions {
  std::string_view model;
  Assignments assignments;
  AuditPlan plan;
  std::size_t worst = 0;
  std::optional<std::string> svgFolder;
  bool json = false;
};

/// Degrees up to `most`, when the option is there.
Status readDegrees(const Arguments& arguments, std::string_view option, int most, std::optional<double>& degrees) {
  const auto text = arguments.value(option);
  if (!text) return okStatus();
  degrees = parseDouble(trim(*text));
  if (degrees && *degrees >= 0.05 && *degrees <= most) return okStatus();
  return Error{std::string(option) + " takes degrees from 0.05 to " + std::to_string(most) + ", not " + inQuotes(*text) + "."};
}

/// A whole number in a range, when the option is there.
Status readCount(const Arguments& arguments, std::string_view option, int least, int most, std::optional<int>& count) {
  const auto text = arguments.value(option);
  if (!text) return okStatus();
  const auto number = parseDouble(trim(*text));
  if (!number || *number < least || *number > most || *number != static_cast<int>(*number)) {
    return Error{std::string(option) + " takes a whole number from " + std::to_string(least) + " to " +
                 std::to_string(most) + ", not " + inQuotes(*text) + "."};
  }
  count = static_cast<int>(*number);
  return okStatus();
}

Status readSize(std::string_view text, AuditPlan& plan) {
  constexpr int kMostPx = 8192;
  const auto size = parseSize(text, kMostPx);
  if (!size) return size.error();
  plan.widthPx = size->widthPx;
  plan.heightPx = size->heightPx;
  return okStatus();
}

Result<AuditOptions> parseOptions(std::span<const std::string_view> list) {
  const auto arguments = Arguments::parse(list, kRules);
  if (!arguments) return arguments.error();
  if (arguments->positional().size() != 1) return Error{"Name one model, or all."};
  AuditOptions options;
  options.model = arguments->positional()[0];
  options.json = arguments->has("--json");
  options.plan.extremes = arguments->has("--extremes");
  auto assignments = assignmentsOf(*arguments);
  if (!assignments) return assignments.error();
  options.assignments = std::move(assignments).value();
  if (const auto size = arguments->value("--size")) {
    if (Status status = readSize(*size, options.plan); !status) return status.error();
  }
  std::optional<double> stepDeg;
  if (Status status = readDegrees(*arguments, "--step", 90, stepDeg); !status) return status.error();
  options.plan.stepDeg = stepDeg.value_or(options.plan.stepDeg);
  if (Status status = readDegrees(*arguments, "--rests", 360, options.plan.restDeg); !status) return status.error();
  std::optional<int> flights;
  std::optional<int> worst;
  if (Status status = readCount(*arguments, "--every", 1, 1000, options.plan.every); !status) return status.error();
  if (Status status = readCount(*arguments, "--flights", 0, 10000, flights); !status) return status.error();
  if (Status status = readCount(*arguments, "--worst", 0, 1000, worst); !status) return status.error();
  options.plan.flights = flights.value_or(0);
  options.worst = static_cast<std::size_t>(worst.value_or(0));
  if (const auto folder = arguments->value("--svg")) {
    if (folder->empty() || options.worst == 0)
      return Error{"--svg takes a folder, and needs --worst K to know what to draw."};
    options.svgFolder = std::string(*folder);
  }
  return options;
}

Outcome auditOne(std::string_view name, const AuditOptions& options, JsonWriter& json, const Streams& streams) {
  const auto model = loadModel(name, streams.err);
  if (!model) return badInput(model.error());
  const auto values = valuesOf(*model, options.assignments);
  if (!values) return badInput(values.error());
  std::optional<std::string> folder = options.svgFolder;
  if (folder && options.model == "all") *folder += "/" + std::string(name);
  if (folder) {   // before the minutes that the audit may take
    if (Status status = makeFolder(*folder); !status) return badInput(status.error());
  }
  const std::vector<AuditPart> parts = auditModel(*model, *values, options.plan, streams.err);
  if (folder) {
    if (Status status = drawWorst(*model, parts, options.worst, *folder); !status) return badInput(status.error());
  }
  if (options.json) {
    writeAudit(json, *model, parts, options.worst);
  } else {
    for (const AuditPart& part : parts) {
      printAudit(*model, part, options.worst, streams.out);
      streams.out << "\n" << std::flush;
    }
  }
  return std::nullopt;
}

Outcome run(std::span<const std::string_view> list, const Streams& streams) {
  const auto options = parseOptions(list);
  if (!options) return badArguments(options.error().message);
  std::vector<std::string_view> names{options->model};
  if (options->model == "all") {
    if (!options->assignments.empty()) return badArguments("--set is for one model at a time.");
    names.clear();
    for (const BuiltInModel& model : builtInModels()) names.push_back(model.name);
  }
  JsonWriter json;
  json.beginArray();
  for (const std::string_view name : names) {
    if (Outcome outcome = auditOne(name, *options, json, streams)) return outcome;
  }
  json.endArray();
  if (options->json) streams.out << json.text() << "\n";
  return std::nullopt;
}

}  // namespace

Command auditCommand() { return {"audit", "how well the principles of dimensioning are kept, measured", kHelp, run}; }

}  // namespace dimline
