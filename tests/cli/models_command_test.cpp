#include <algorithm>

#include <catch2/catch.hpp>

#include "cli/run_program.h"

namespace dimline::test {
namespace {

using nlohmann::json;

TEST_CASE("dimline models lists the models for people") {
  const Run run = runProgram({"models"});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(run.out.find("house") != std::string::npos);
  CHECK(run.out.find("triangles") != std::string::npos);
}

TEST_CASE("dimline models --json gives each model's sizes and parameters") {
  const Run run = runProgram({"models", "--json"});
  REQUIRE(run.status == 0);
  CHECK(run.err.empty());
  const json models = parsed(run.out);
  REQUIRE(models.is_array());
  REQUIRE(!models.empty());
  for (const json& model : models) {
    INFO(model["name"].dump());
    CHECK(model["name"].is_string());
    CHECK(model["title"].is_string());
    CHECK(model["triangles"].get<int>() > 0);
    CHECK(model["baseLines"].get<int>() > 0);
    CHECK(model["clusteredBaseLines"].get<int>() <= model["baseLines"].get<int>());
    CHECK((model["clusters"].get<int>() == 0) == (model["clusteredBaseLines"].get<int>() == 0));
    REQUIRE(!model["parameters"].empty());
    for (const json& parameter : model["parameters"]) {
      INFO(parameter.dump());
      for (const char* key : {"name", "title", "help", "type", "value", "default", "min", "max", "step", "unit",
                              "choices", "group", "annotation"}) {
        CHECK(parameter.contains(key));
      }
      const std::string type = parameter["type"];
      CHECK((type == "float" || type == "int" || type == "angle" || type == "bool" || type == "choice"));
      CHECK(parameter["value"] == parameter["default"]);
      if (type == "float" || type == "int" || type == "angle") {
        CHECK(parameter["min"].get<double>() <= parameter["value"].get<double>());
        CHECK(parameter["value"].get<double>() <= parameter["max"].get<double>());
      } else if (type == "choice") {
        const json& choices = parameter["choices"];
        CHECK(std::find(choices.begin(), choices.end(), parameter["value"]) != choices.end());
      } else {
        CHECK(parameter["value"].is_boolean());
      }
    }
  }
  CHECK(models[0]["name"] == "house");
}

TEST_CASE("help is there for the program and for each command") {
  const Run all = runProgram({"--help"});
  CHECK(all.status == 0);
  CHECK(all.err.empty());
  for (const char* command : {"models", "layout"}) {
    CHECK(all.out.find(std::string("\n  ") + command + " ") != std::string::npos);
    const Run one = runProgram({command, "--help"});
    CHECK(one.status == 0);
    CHECK(one.out.find(std::string("Usage: dimline ") + command) == 0);
    CHECK(runProgram({"help", command}).out == one.out);
  }
  const Run version = runProgram({"--version"});
  CHECK(version.status == 0);
  CHECK(version.out.find("dimline ") == 0);
}

TEST_CASE("a command line that is wrong gives status 2 and says how it would be right") {
  const Run nothing = runProgram({});
  CHECK(nothing.status == 2);
  CHECK(nothing.err.find("Usage: dimline COMMAND") != std::string::npos);

  const Run unknown = runProgram({"layuot"});
  CHECK(unknown.status == 2);
  CHECK(unknown.err.find("dimline: There is no command \"layuot\"; there are models") == 0);

  const Run option = runProgram({"models", "--jsno"});
  CHECK(option.status == 2);
  CHECK(option.err ==
        "dimline models: There is no option \"--jsno\"; this command has --json.\nTry dimline models --help.\n");

  CHECK(runProgram({"models", "house"}).status == 2);
  CHECK(runProgram({"models", "--json=yes"}).status == 2);
}

}  // namespace
}  // namespace dimline::test
