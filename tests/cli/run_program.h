#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace dimline::test {

/// What a run of the program left behind.
struct Run {
  int status = -1;  ///< exit status; -1 when it was ended by a signal
  std::string out;
  std::string err;
};

/// Runs the `dimline` that was built, and waits for it. No shell has a hand in the arguments. `environment`: variables to set, NAME and value.
Run runProgram(const std::vector<std::string>& arguments,
               const std::vector<std::pair<std::string, std::string>>& environment = {});

/// A folder of its own for one test case, removed with all that is in it.
class TemporaryFolder {
public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file in it and gives its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& content) const;
  /// The names of all that lies in a folder below it (or in itself), sorted.
  [[nodiscard]] std::vector<std::string> list(const std::string& below = "") const;

private:
  std::string path_;
};

/// The whole of a file; fails the test when there is none.
std::string contentOf(const std::string& path);

/// JSON text, which must be valid; no exceptions either way.
nlohmann::json parsed(const std::string& text);

}  // namespace dimline::test
