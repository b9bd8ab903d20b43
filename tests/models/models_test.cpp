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
  const std::string& message = model.error().message;
  CHECK(message.find("There is no built-in model \"hosue\"; there is house") == 0);
  for (const BuiltInModel& built : builtInModels()) {
    INFO(built.name);
    CHECK(message.find(built.name, message.find(';')) != std::string::npos);
  }
}

}  // namespace
}  // namespace dimline
