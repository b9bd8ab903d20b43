#include <catch2/catch.hpp>

#include <limits>

#include <nlohmann/json.hpp>

#include "app/json.h"
#include "support/random.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

std::vector<Parameter> someParameters() {
  ModelDefinition definition;
  definition.name = "some";
  definition.build = [](const Values&) { return Scene{}; };
  definition.parameters = {
      {.name = "Width",
       .title = "Width",
       .help = "How wide.",
       .group = "Size",
       .unit = Unit::kMetre,
       .defaultValue = 8,
       .min = 1,
       .max = 20,
       .step = 0.1},
      {.name = "Floors", .type = ParameterType::kInt, .defaultValue = 2, .min = 1, .max = 6},
      {.name = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .defaultValue = 35, .min = 5, .max = 60},
      {.name = "Balcony", .type = ParameterType::kBool, .defaultValue = 1},
      {.name = "Roof",
       .type = ParameterType::kChoice,
       .choices = {"gable", "hip"},
       .annotation = "@Handle(scope=Roof, type=range)"}};
  return makeModel(std::move(definition)).value().definition.parameters;
}

std::string errorOf(const Result<std::vector<std::pair<std::size_t, double>>>& result) {
  return result ? "" : result.error().message;
}
std::string errorOf(const Result<Camera>& result) { return result ? "" : result.error().message; }

}  // namespace

TEST_CASE("scopes that are no more are left out of what is visible") {
  const Model model = makeModel(boxWithDoor()).value();
  Scene scene = model.definition.build(Values(model.parameters()));
  Layout layout;
  layout.visibleScopes = {0, scene.scopes.size()};
  JsonWriter json;
  writeFrame(json, model, scene, layout);
  CHECK(nlohmann::json::parse(json.text())["visible"].size() == 1);
}

TEST_CASE("JSON text is written with its commas, quotes and escapes") {
  JsonWriter json;
  json.beginObject();
  json.key("a").beginArray().value(1).value("x\"y\\z\n").null().beginObject().endObject().endArray();
  json.key("b").value(Vec2(1.5, -2)).key("c").value(true);
  json.endObject();
  REQUIRE(json.text() == R"({"a":[1,"x\"y\\z\u000a",null,{}],"b":[1.5,-2],"c":true})");
}

TEST_CASE("numbers come back as they were, in few digits where few do") {
  const auto written = [](double number) {
    JsonWriter json;
    json.value(number);
    return json.text();
  };
  REQUIRE(written(0.1) == "0.1");
  REQUIRE(written(-0.0) == "0");
  REQUIRE(written(1e300) == "1e+300");
  REQUIRE(written(std::numeric_limits<double>::infinity()) == "null");
  REQUIRE(written(std::numeric_limits<double>::quiet_NaN()) == "null");
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const double number = random.real(-1, 1) * random.scaled(1e-12, 1e12);
    REQUIRE(std::strtod(written(number).c_str(), nullptr) == number);
  }
}

TEST_CASE("broken UTF-8 becomes a replacement character") {
  JsonWriter json;
  json.value(std::string_view("a\xC3(\xE2\x82\xAC)\xFF"));
  REQUIRE(json.text() == "\"a\xEF\xBF\xBD(\xE2\x82\xAC)\xEF\xBF\xBD\"");
}

TEST_CASE("parameters are listed as getParameters() promises") {
  const auto parameters = someParameters();
  JsonWriter json;
  writeParameters(json, parameters, Values(parameters));
  const auto list = nlohmann::json::parse(json.text());
  REQUIRE(list.size() == 5);
  REQUIRE(list[0]["name"] == "Width");
  REQUIRE(list[0]["type"] == "float");
  REQUIRE(list[0]["unit"] == "m");
  REQUIRE(list[0]["value"] == 8);
  REQUIRE(list[0]["max"] == 20);
  REQUIRE(list[0]["step"] == 0.1);
  REQUIRE(list[0]["help"] == "How wide.");
  REQUIRE(list[0]["group"] == "Size");
  REQUIRE(list[0]["choices"].empty());
  REQUIRE(list[1]["type"] == "int");
  REQUIRE(list[2]["unit"] == "deg");
  REQUIRE(list[3]["value"] == true);
  REQUIRE(list[3]["default"] == true);
  REQUIRE(list[3]["min"].is_null());
  REQUIRE(list[4]["value"] == "gable");
  REQUIRE(list[4]["choices"] == nlohmann::json::array({"gable", "hip"}));
  REQUIRE(list[4]["annotation"] == "@Handle(scope=Roof, type=range)");
}

TEST_CASE("values are read by name, clamped, and all or none") {
  const auto parameters = someParameters();
  const auto changes = readValues(parameters, R"({"Roof": "hip", "Width": 99, "Balcony": false})");
  REQUIRE(changes);
  REQUIRE(changes->size() == 3);
  for (const auto& [index, value] : *changes) {
    REQUIRE(value == (index == 0 ? 20 : index == 3 ? 0 : 1));
  }
  REQUIRE(readValues(parameters, "{}")->empty());
}

TEST_CASE("what cannot be read is said by name") {
  const auto parameters = someParameters();
  REQUIRE(errorOf(readValues(parameters, R"({"Widht": 9})")).find("Widht") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, R"({"Width": "9"})")).find("Width takes a number") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, R"({"Width": 8, "Balcony": 1})")).find("Balcony is a switch") !=
          std::string::npos);
  REQUIRE(errorOf(readValues(parameters, R"({"Roof": "dome"})")).find("gable or hip") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, R"({"Roof": 1})")).find("Roof is a choice") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, R"({"Width": 1e999})")).find("Width") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, "[1]")).find("object") != std::string::npos);
  REQUIRE(errorOf(readValues(parameters, "{")).find("JSON") != std::string::npos);
  REQUIRE_FALSE(readValue(parameters[0], "NaN"));
  REQUIRE_FALSE(readValue(parameters[0], ""));
  REQUIRE(*readValue(parameters[0], "4.25") == 4.25);
}

TEST_CASE("a camera written is the camera read") {
  Camera camera = orbitCamera({1, 2, 3}, 10, 20, 30, 40);
  for (const bool orthographic : {false, true}) {
    if (orthographic) camera.orthoHeightM = 7.25;
    JsonWriter json;
    writeCamera(json, camera);
    const auto back = readCamera(json.text());
    REQUIRE(back);
    REQUIRE(back->eye == camera.eye);
    REQUIRE(back->target == camera.target);
    REQUIRE(back->up == camera.up);
    REQUIRE(back->orthoHeightM == camera.orthoHeightM);
    if (!orthographic) REQUIRE(back->fovRad == Approx(camera.fovRad));
  }
}

TEST_CASE("a camera without up and angle gets the page's") {
  const auto camera = readCamera(R"({"eye": [0, 0, 10], "target": [0, 0, 0]})");
  REQUIRE(camera);
  REQUIRE(camera->up == Vec3(0, 1, 0));
  REQUIRE(camera->fovRad == kDefaultFovRad);
}

TEST_CASE("a camera that is none is said to be none, field by field") {
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0], "target": [0, 0, 0]})")).find("eye must be a list of three") !=
          std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, "1"], "target": [0, 0, 0]})")).find("eye") != std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"target": [0, 0, 0]})")).find("eye is missing") != std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1]})")).find("target is missing") != std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1], "target": [0, 0, 1]})")).find("same point") != std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1], "target": [0, 0, 0], "fov": 45})")).find("fov") !=
          std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1], "target": [0, 0, 0], "fovDeg": 45, "orthoHeight": 3})"))
              .find("not both") != std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1], "target": [0, 0, 0], "fovDeg": 190})")).find("180") !=
          std::string::npos);
  REQUIRE(errorOf(readCamera(R"({"eye": [0, 0, 1], "target": [0, 0, 0], "orthoHeight": -1})")).find("orthoHeight") !=
          std::string::npos);
  REQUIRE(errorOf(readCamera("7")).find("object") != std::string::npos);
}

TEST_CASE("a list of cameras says which of them is wrong") {
  REQUIRE(
      readCameras(R"([{"eye": [0, 0, 1], "target": [0, 0, 0]}, {"eye": [0, 0, 2], "target": [0, 0, 0]}])")->size() ==
      2);
  const auto broken = readCameras(R"([{"eye": [0, 0, 1], "target": [0, 0, 0]}, {"eye": 3}])");
  REQUIRE_FALSE(broken);
  REQUIRE(broken.error().message.find("Camera 1") != std::string::npos);
  REQUIRE_FALSE(readCameras(R"({"eye": [0, 0, 1]})"));
}
