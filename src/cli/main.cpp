#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string_view>
#include <vector>

#include "cli/program.h"

namespace {

/// Nothing can be freed, and nothing is half written: output files are put in their places when they are whole.
[[noreturn]] void endForWantOfMemory() {
  std::fputs("dimline: There is not enough memory for this.\n", stderr);
  std::_Exit(static_cast<int>(dimline::ExitStatus::kBadInput));
}

}  // namespace

int main(int argc, char** argv) {
  std::set_new_handler(endForWantOfMemory);
  const std::vector<std::string_view> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  const dimline::ExitStatus status = dimline::runProgram(arguments, {std::cout, std::cerr});
  // A full disk or a closed pipe shows only here.
  std::cout.flush();
  if (!std::cout && status == dimline::ExitStatus::kDone) {
    std::cerr << "dimline: Cannot write to standard output.\n";
    return static_cast<int>(dimline::ExitStatus::kBadInput);
  }
  return static_cast<int>(status);
}
