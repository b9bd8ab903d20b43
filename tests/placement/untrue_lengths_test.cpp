#include "placement/untrue_lengths.h"

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// A width of 2 m, annotated with `rest`, of a box that is `lengthM` wide.
Model modelWith(double lengthM, const std::string& rest) {
  ModelDefinition definition;
  definition.name = "box";
  definition.parameters.push_back({.name = "Width", .unit = Unit::kMetre, .defaultValue = 2, .min = 1, .max = 4, .step = 0.01, .annotation = "@Handle(scope=Box, " + rest + ")"});
  definition.build = [lengthM](const Values&) {
    Scene scene;
    scene.scopes.push_back({"Box", 0, {.size = {lengthM, 1, 1}}});
    scene.bounds.add(Vec3(0.0));
    scene.bounds.add(Vec3(lengthM, 1, 1));
    return scene;
  };
  return makeModel(std::move(definition)).value();
}

TEST_CASE("a line that measures its parameter's value, to a hundredth, is true") {
  CHECK(findUntrueLengths(modelWith(2, "orient=right")).empty());
  CHECK(findUntrueLengths(modelWith(2.015, "orient=right")).empty());
}

TEST_CASE("one that measures something else is told, but not where the author says so") {
  CHECK(findUntrueLengths(modelWith(3, "orient=right")) ==
        std::vector<std::string>{"Width: the line on \"Box\" is 3.00 m long, but the value is 2.00 m; where that is meant, write indirect in the annotation, and a drag follows the value."});
  CHECK(findUntrueLengths(modelWith(2, "orient=up")).size() == 1);
  CHECK(findUntrueLengths(modelWith(3, "orient=right, indirect")).empty());
  CHECK(findUntrueLengths(modelWith(3, "type=boolean")).empty());
}

TEST_CASE("a scope that the model does not build has no length") {
  Model model = modelWith(3, "orient=right");
  model.annotations[0]->scope = "Balcony";
  CHECK(findUntrueLengths(model).empty());
}

}  // namespace
}  // namespace dimline
