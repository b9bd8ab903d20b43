#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"

namespace dimline {

/// What the program's exit status says.
enum class ExitStatus : int {
  kDone = 0,
  kBadInput = 1,     ///< the command line is understood, but what it names cannot be used: a model, a value, a file
  kBadArguments = 2  ///< the command line itself is wrong
};

/// Where a command writes: results to `out`, errors and notes to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
};

/// Why a command stopped, and which exit status that is. One sentence for a person.
struct Failure {
  ExitStatus status = ExitStatus::kBadInput;
  std::string message;
};

/// What a command gives back: nothing, or why not.
using Outcome = std::optional<Failure>;
inline Failure badInput(const Error& error) { return {ExitStatus::kBadInput, error.message}; }
inline Failure badArguments(std::string message) { return {ExitStatus::kBadArguments, std::move(message)}; }

/// One command of the program. `arguments` are those after its name.
struct Command {
  std::string_view name;
  std::string_view summary;  ///< half a line for the list of commands
  std::string_view help;     ///< the whole text that --help shows
  Outcome (*run)(std::span<const std::string_view> arguments, const Streams& streams);
};

/// The commands, in the order in which the help lists them.
std::span<const Command> commands();

/// The whole program: `arguments` are those after its own name.
ExitStatus runProgram(std::span<const std::string_view> arguments, const Streams& streams);

}  // namespace dimline
