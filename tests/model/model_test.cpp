#include "model/model.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// A definition with one good parameter, for a test to spoil.
ModelDefinition box() {
  ModelDefinition definition;
  definition.name = "box";
  definition.title = "Box";
  definition.build = [](const Values&) { return Scene(); };
  Parameter p;
  p.name = "Width";
  p.unit = Unit::kMetre;
  p.defaultValue = 2;
  p.min = 1;
  p.max = 4;
  p.annotation = "@Handle(scope=Box, orient=right)";
  definition.parameters.push_back(p);
  return definition;
}

std::string errorOf(ModelDefinition definition) {
  auto model = makeModel(std::move(definition));
  return model.ok() ? "(no error)" : model.error().message;
}

TEST_CASE("annotations stand beside their parameters") {
  ModelDefinition definition = box();
  definition.parameters.insert(definition.parameters.begin(), definition.parameters[0]);
  definition.parameters[0].name = "Plain";
  definition.parameters[0].annotation = "";
  auto model = makeModel(definition);
  REQUIRE(model.ok());
  CHECK(model->diagnostics.empty());
  REQUIRE(model->annotations.size() == 2);
  CHECK_FALSE(model->annotations[0].has_value());
  REQUIRE(model->annotations[1].has_value());
  CHECK(model->annotations[1]->orient == Orient::kRight);
  CHECK(model->parameters()[1].name == "Width");
}

TEST_CASE("a broken annotation costs the handle, not the model") {
  ModelDefinition definition = box();
  definition.parameters[0].annotation = "@Handle(scope=Box";
  auto model = makeModel(definition);
  REQUIRE(model.ok());
  CHECK_FALSE(model->annotations[0].has_value());
  REQUIRE(model->diagnostics.size() == 1);
  CHECK(model->diagnostics[0].find("Width: line 1, column 18: ") == 0);
}

TEST_CASE("a warning keeps the handle and is told") {
  ModelDefinition definition = box();
  definition.parameters[0].annotation = "@Handle(scope=Box, orient=sideways)";
  auto model = makeModel(definition);
  REQUIRE(model.ok());
  CHECK(model->annotations[0].has_value());
  REQUIRE(model->diagnostics.size() == 1);
  CHECK(model->diagnostics[0].find("Width: line 1, column 27: orient cannot be \"sideways\"") == 0);
}

TEST_CASE("what is chained and makes no chain keeps its handle and is told of it") {
  ModelDefinition definition = box();
  definition.parameters[0].annotation = "@Handle(scope=Box, type=diametric, orient=up, chained)";
  const auto model = makeModel(definition);
  REQUIRE(model.ok());
  CHECK(model->annotations[0].has_value());
  REQUIRE(model->diagnostics.size() == 1);
  CHECK(model->diagnostics[0] == "Width: chained is for linear lines, so it is left out.");
}

TEST_CASE("a handle of the wrong kind for its parameter is left out and told") {
  const auto handleOf = [](ParameterType type, const std::string& words) {
    ModelDefinition definition = box();
    Parameter& p = definition.parameters[0];
    p.type = type;
    if (type == ParameterType::kBool) p.defaultValue = 1;
    p.choices = {"a", "b", "c"};
    p.annotation = "@Handle(scope=Box, " + words + ")";
    auto model = makeModel(definition);
    REQUIRE(model.ok());
    REQUIRE(model->diagnostics.size() == (model->annotations[0].has_value() ? 0U : 1U));
    return model->annotations[0].has_value();
  };
  CHECK(handleOf(ParameterType::kFloat, "type=linear-center"));
  CHECK(handleOf(ParameterType::kInt, "indirect"));
  CHECK_FALSE(handleOf(ParameterType::kAngle, "type=linear-contour"));
  CHECK(handleOf(ParameterType::kAngle, "type=linear-contour, indirect"));
  CHECK(handleOf(ParameterType::kAngle, "type=angular"));
  CHECK_FALSE(handleOf(ParameterType::kFloat, "type=angular"));
  CHECK(handleOf(ParameterType::kBool, "type=boolean"));
  CHECK_FALSE(handleOf(ParameterType::kFloat, "type=boolean"));
  CHECK_FALSE(handleOf(ParameterType::kBool, "type=radial"));
  CHECK(handleOf(ParameterType::kChoice, "type=range"));
  CHECK_FALSE(handleOf(ParameterType::kChoice, "type=linear-contour"));
}

TEST_CASE("switches, choices and counts get the range they can only have") {
  ModelDefinition definition = box();
  Parameter p;
  p.name = "Balcony";
  p.type = ParameterType::kBool;
  p.max = 7;
  definition.parameters.push_back(p);
  p.name = "Roof";
  p.type = ParameterType::kChoice;
  p.choices = {"gable", "hip", "shed"};
  definition.parameters.push_back(p);
  p.name = "Floors";
  p.type = ParameterType::kInt;
  definition.parameters.push_back(p);
  auto model = makeModel(definition);
  REQUIRE(model.ok());
  CHECK(model->parameters()[1].max == 1);
  CHECK(model->parameters()[2].max == 2);
  CHECK(model->parameters()[3].max == 7);
  CHECK(model->parameters()[3].step == 1);
}

TEST_CASE("an unusable definition says why") {
  const auto spoilt = [](auto spoil) {
    ModelDefinition definition = box();
    spoil(definition.parameters[0]);
    return errorOf(definition);
  };
  const std::string start = "In the model \"box\": ";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(spoilt([](Parameter& p) { p.min = 5; }) ==
        start + "Width's range is empty: its least value, 5.000, is above its greatest, 4.000.");
  CHECK(spoilt([&](Parameter& p) { p.max = nan; }) == start + "Width's range must have finite limits.");
  CHECK(spoilt([](Parameter& p) { p.min = -std::numeric_limits<double>::infinity(); }) ==
        start + "Width's range must have finite limits.");
  CHECK(spoilt([](Parameter& p) { p.defaultValue = 4.5; }) ==
        start + "Width's default, 4.500, lies outside its range, 1.000 to 4.000.");
  CHECK(spoilt([&](Parameter& p) { p.defaultValue = nan; }).find(start + "Width's default, nan, lies outside") == 0);
  CHECK(spoilt([](Parameter& p) { p.step = -1; }) ==
        start + "Width's step must be 0 (any value) or a positive number.");
  CHECK(spoilt([](Parameter& p) { p.name = " "; }) == start + "parameter 1 has no name.");
  CHECK(spoilt([](Parameter& p) { p.name = "A=B"; }) ==
        start + "the name \"A=B\" has a blank at an end or an = in it, so nobody could set it by name.");
  CHECK(spoilt([](Parameter& p) { p.name = "A "; }).find("the name \"A \" has a blank") != std::string::npos);
  CHECK(spoilt([](Parameter& p) { p.measure = true; }) == start + "Width is a measure; it belongs among the model's measures.");
  CHECK(spoilt([](Parameter& p) { p.type = ParameterType::kChoice; }) ==
        start + "Width is a choice without names to choose from.");
  CHECK(spoilt([](Parameter& p) {
          p.type = ParameterType::kChoice;
          p.choices = {"a", "b", "a", "c"};
        }) == start + "Width has two choices named \"a\".");
  CHECK(spoilt([](Parameter& p) {
          p.type = ParameterType::kInt;
          p.min = 0.5;
        }) == start + "Width takes whole numbers only: its limits, default and step must be whole too.");

  ModelDefinition twice = box();
  twice.parameters.push_back(twice.parameters[0]);
  CHECK(errorOf(twice) == start + "two parameters are named \"Width\".");
  ModelDefinition nothing = box();
  nothing.build = nullptr;
  CHECK(errorOf(nothing) == "The model \"box\" has no rule that builds it.");
}

}  // namespace
}  // namespace dimline
