#include <catch2/catch.hpp>

#include "cli/model_statistics.h"
#include "models/models.h"

namespace dimline {
namespace {

/// Table 1 of the paper. Polygons are triangles here.
struct PaperModel {
  std::string_view name;
  std::size_t parameters, triangles, baseLines, clusteredBaseLines, clusters;
};
constexpr PaperModel kPaperModels[] = {
    {"single-tree", 6, 5610, 15, 0, 0},
    {"helix-house", 13, 1495, 210, 80, 22},
    {"lever", 7, 1178, 45, 36, 10},
    {"omni-tree", 18, 29767, 75, 0, 0},
    {"parthenon", 10, 132263, 266, 240, 32},
    {"candler", 6, 45366, 2260, 2260, 47},
};

TEST_CASE("a model of the paper's is about as large as there") {
  for (const PaperModel& paper : kPaperModels) {
    INFO(paper.name);
    const Result<Model> model = findBuiltInModel(paper.name);
    REQUIRE(model.ok());
    CHECK(model->parameters().size() == paper.parameters);
    const ModelStatistics own = statisticsOf(*model, model->definition.build(Values(model->parameters())));
    CHECK(static_cast<double>(own.triangles) == Approx(static_cast<double>(paper.triangles)).epsilon(0.10));
    CHECK(static_cast<double>(own.baseLines) == Approx(static_cast<double>(paper.baseLines)).epsilon(0.15));
    // The paper says how many it has, not how it counts them: near is enough.
    CHECK(static_cast<double>(own.clusteredBaseLines) == Approx(static_cast<double>(paper.clusteredBaseLines)).epsilon(0.15));
    CHECK(static_cast<double>(own.clusters) == Approx(static_cast<double>(paper.clusters)).epsilon(0.30));
  }
}

}  // namespace
}  // namespace dimline
