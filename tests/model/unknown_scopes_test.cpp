#include "model/unknown_scopes.h"

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// A width that is annotated with `scope`, a switch that adds a "Balcony", and a "Box" that is always there.
Model modelAbout(const std::string& scope) {
  ModelDefinition definition;
  definition.name = "box";
  definition.parameters.push_back({.name = "Width", .defaultValue = 2, .min = 1, .max = 4, .annotation = "@Handle(scope=" + scope + ", orient=right)"});
  definition.parameters.push_back({.name = "Balcony", .type = ParameterType::kBool});
  definition.build = [](const Values& values) {
    Scene scene;
    scene.scopes.push_back({"Box", 0, {.size = {values.at(0), 1, 1}}});
    if (values.at(1) != 0) scene.scopes.push_back({"Balcony", 0, {.size = {1, 1, 1}}});
    return scene;
  };
  return makeModel(std::move(definition)).value();
}

TEST_CASE("a scope that the model builds at some value is known") {
  CHECK(findUnknownScopes(modelAbout("Box")).empty());
  CHECK(findUnknownScopes(modelAbout("Balcony")).empty());
}

TEST_CASE("a scope that it never builds is told, with those that there are") {
  CHECK(findUnknownScopes(modelAbout("box")) ==
        std::vector<std::string>{"Width: the model has no scope named \"box\", so this gets no handle; it has Balcony and Box."});
  CHECK(findUnknownScopes(modelAbout("Model")) ==
        std::vector<std::string>{"Width: the model has no scope named \"Model\", which is for measures only, so this gets no handle; it has Balcony and Box."});
}

}  // namespace
}  // namespace dimline
