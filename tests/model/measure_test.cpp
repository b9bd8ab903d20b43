#include "math/camera.h"
#include "model/model.h"
#include "support/scenes.h"

#include <catch2/catch.hpp>

using namespace dimline;
using namespace dimline::test;

TEST_CASE("measures are behind the parameters, and have names of their own") {
  ModelDefinition definition = boxWithDoor();
  const auto measure = [&](const char* name, const char* annotation) {
    Measure m;
    m.shown = {.name = name, .title = name, .unit = Unit::kMetre, .annotation = annotation};
    definition.measures.push_back(m);
  };
  measure("Top", "@Handle(scope=Model, type=linear-contour, orient=up)");
  measure("Bad", "@Handle(scope=Box, type=boolean)");
  const Model model = makeModel(definition).value();
  REQUIRE(model.diagnostics.size() == 1);
  REQUIRE(model.diagnostics[0].find("Bad") != std::string::npos);
  const Values values(model.parameters());
  Scene scene = model.definition.build(values);
  REQUIRE(measuredValue(model, 0, values, scene) == Approx(scene.bounds.size().y));
  const std::size_t scopes = scene.scopes.size();
  addMeasureScopes(model, scene);
  REQUIRE(scene.scopes.size() == scopes + 1);
  REQUIRE(measuredValue(model, 0, values, scene) == Approx(scene.bounds.size().y));
  REQUIRE(withMeasures(model).parameters().size() == values.size() + 2);
  REQUIRE(withMeasures(model, values, scene).at(values.size()) == Approx(scene.bounds.size().y));

  measure("Top", "");
  REQUIRE_FALSE(makeModel(definition));
  definition.measures.pop_back();
  measure("Width", "");
  REQUIRE_FALSE(makeModel(definition));
}
