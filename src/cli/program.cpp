#include "cli/program.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <vector>

#include "cli/audit_command.h"
#include "cli/bench_command.h"
#include "cli/export_command.h"
#include "cli/layout_command.h"
#include "cli/models_command.h"
#include "core/text.h"
#include "core/version.h"

namespace dimline {

namespace {

const std::array kCommands = {modelsCommand(), layoutCommand(), auditCommand(), benchCommand(), exportCommand()};

void printHelp(std::ostream& out) {
  out << "dimline: dimension lines for parametric 3D models.\n\n"
         "Usage: dimline COMMAND [arguments]\n\n";
  for (const Command& command : commands()) {
    out << "  " << command.name << std::string(10 - std::min<std::size_t>(command.name.size(), 9), ' ')
        << command.summary << "\n";
  }
  out << "\ndimline COMMAND --help says more. dimline --version prints the version.\n"
         "The exit status is 2 for a command line that is wrong, 1 for input that cannot be used.\n";
}

const Command* findCommand(std::string_view name) {
  const auto all = commands();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Command& command) { return command.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool isHelp(std::string_view argument) { return argument == "--help" || argument == "-h"; }

ExitStatus unknownCommand(std::string_view name, std::ostream& err) {
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  err << "dimline: There is no command " << inQuotes(name) << "; there are " << joined(names) << ".\n";
  return ExitStatus::kBadArguments;
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

ExitStatus runProgram(std::span<const std::string_view> arguments, const Streams& streams) {
  if (arguments.empty()) {
    printHelp(streams.err);
    return ExitStatus::kBadArguments;
  }
  const std::string_view first = arguments[0];
  const auto rest = arguments.subspan(1);
  if (first == "--version") {
    streams.out << "dimline " << kVersion << "\n";
    return ExitStatus::kDone;
  }
  if (isHelp(first) || (first == "help" && rest.empty())) {
    printHelp(streams.out);
    return ExitStatus::kDone;
  }
  const std::string_view name = first == "help" ? rest[0] : first;
  const Command* command = findCommand(name);
  if (command == nullptr) return unknownCommand(name, streams.err);
  if (first == "help" || std::any_of(rest.begin(), rest.end(), isHelp)) {
    streams.out << command->help;
    return ExitStatus::kDone;
  }

  const Outcome outcome = command->run(rest, streams);
  if (!outcome) return ExitStatus::kDone;
  streams.err << "dimline " << command->name << ": " << outcome->message << "\n";
  if (outcome->status == ExitStatus::kBadArguments) streams.err << "Try dimline " << command->name << " --help.\n";
  return outcome->status;
}

}  // namespace dimline
