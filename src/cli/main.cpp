#include <iostream>
#include <string_view>
#include <vector>

#include "cli/program.h"

int main(int argc, char** argv) {
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
