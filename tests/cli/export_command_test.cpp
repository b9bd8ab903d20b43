#include <algorithm>

#include <catch2/catch.hpp>

#include "cli/run_program.h"

namespace dimline::test {
namespace {

using nlohmann::json;

json layoutOfModel(const std::string& model, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"layout", model, "-o", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = runProgram(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return parsed(run.out);
}

TEST_CASE("an exported model, read again, has the size that was asked for") {
  const TemporaryFolder folder;
  for (const char* model : {"house", "lever"}) {
    INFO(model);
    const std::string glb = folder / (std::string(model) + ".glb");
    const std::vector<std::string> wide = std::string(model) == "house" ? std::vector<std::string>{"--set", "Width=14"} : std::vector<std::string>{};
    std::vector<std::string> arguments = {"export", model, "-o", glb};
    arguments.insert(arguments.end(), wide.begin(), wide.end());
    const Run run = runProgram(arguments);
    INFO(run.err);
    REQUIRE(run.status == 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
    const json exported = layoutOfModel(glb), asked = layoutOfModel(model, wide);
    for (const char* end : {"min", "max"}) {
      for (std::size_t i = 0; i < 3; ++i) CHECK(exported["bounds"][end][i].get<double>() == Approx(asked["bounds"][end][i].get<double>()).margin(1e-4));
    }
  }
  CHECK(folder.list() == std::vector<std::string>{"house.glb", "lever.glb"});
}

TEST_CASE("to standard output goes the same as to a file") {
  const TemporaryFolder folder;
  REQUIRE(runProgram({"export", "facade", "-o", folder / "facade.glb"}).status == 0);
  const Run run = runProgram({"export", "facade", "-o", "-"});
  CHECK(run.status == 0);
  CHECK(run.out == contentOf(folder / "facade.glb"));
  CHECK(run.out.starts_with("glTF"));
}

TEST_CASE("the help says what an exported file goes without") {
  const Run help = runProgram({"export", "--help"});
  CHECK(help.status == 0);
  for (const std::string_view lost : {"parameters", "scopes", "patterns"}) CHECK(help.out.find(lost) != std::string::npos);
}

TEST_CASE("what cannot be exported gets a sentence, and leaves no file") {
  struct Case {
    std::vector<std::string> arguments;
    int status;
    std::string said;
  };
  const TemporaryFolder folder;
  const std::string out = folder / "out.glb";
  const Case cases[] = {{{"-o", out}, 2, "Name a model"},
                        {{"house"}, 2, "-o is missing"},
                        {{"house", "-o", ""}, 2, "-o needs a path"},
                        {{"house", "-o", folder / "out.gltf"}, 2, "ends in .glb"},
                        {{"house", "-o", folder / ".glb/house"}, 2, "ends in .glb"},
                        {{"house", "lever", "-o", out}, 2, "One model at a time"},
                        {{"house", "--set", "Width", "-o", out}, 2, "--set takes NAME=VALUE"},
                        {{"house", "--size", "3x4", "-o", out}, 2, "--size"},
                        {{"castle", "-o", out}, 1, "castle"},
                        {{"house", "--set", "Moat=3", "-o", out}, 1, "Moat"},
                        {{"house", "--set", "Width=900", "-o", out}, 1, "Width"},
                        {{"house", "-o", folder / "no/such/out.glb"}, 1, "out.glb"}};
  for (const Case& one : cases) {
    std::vector<std::string> arguments = one.arguments;
    arguments.insert(arguments.begin(), "export");
    const Run run = runProgram(arguments);
    INFO(one.said << ": " << run.err);
    CHECK(run.status == one.status);
    CHECK(run.out.empty());
    CHECK(run.err.starts_with("dimline export: "));
    CHECK(run.err.find(one.said) != std::string::npos);
    CHECK(folder.list().empty());
  }
}

}  // namespace
}  // namespace dimline::test
