#include "models/models.h"

#include <set>

#include <catch2/catch.hpp>

namespace dimline {
namespace {

TEST_CASE("every built-in model loads without a complaint, under its own name") {
  std::set<std::string_view> names;
  for (const BuiltInModel& built : builtInModels()) {
    INFO(built.name);
    const Result<Model> model = findBuiltInModel(built.name);
    REQUIRE(model.ok());
    CHECK(model->definition.name == built.name);
    CHECK(!model->definition.title.empty());
    CHECK(model->diagnostics.empty());
    CHECK(names.insert(built.name).second);
    const Scene scene = model->definition.build(Values(model->parameters()));
    CHECK(scene.triangleCount() > 0);
    CHECK(!scene.scopes.empty());
  }
  CHECK(!names.empty());
}

TEST_CASE("an unknown model's error names it and the models there are") {
  const Result<Model> model = findBuiltInModel("hosue");
  REQUIRE(!model.ok());
  CHECK(model.error().message == "There is no built-in model \"hosue\"; there is house.");
}

}  // namespace
}  // namespace dimline
