#include <iterator>
#include <sstream>

#include <catch2/catch.hpp>

#include "cli/bench_measure.h"
#include "cli/bench_report.h"
#include "cli/bench_scenes.h"
#include "cli/bench_straightforward.h"
#include "cli/run_program.h"
#include "support/scenes.h"

namespace dimline::test {
namespace {

TEST_CASE("bench: the median") {
  CHECK_FALSE(median({}));
  CHECK(*median({3.0}) == 3.0);
  CHECK(*median({9.0, 1.0, 5.0}) == 5.0);
}

TEST_CASE("bench: the straightforward version finds the silhouette's end in the wedge") {
  // A box from x = -4 to 4, seen straight from the front.
  const auto model = makeModel(boxWithDoor());
  const Scene scene = model->definition.build(Values(model->parameters()));
  Camera camera;
  camera.eye = {0, 2.5, 40};
  camera.target = {0, 2.5, 0};
  camera.orthoHeightM = 20;
  const View view(camera, 1000, 1000, scene.bounds);
  Straightforward straightforward(*model, scene);
  const Segment left{{-4, 0, 3}, {-4, 5, 3}};
  const auto offset = [&](const Segment& base, const Vec3& across) {
    const auto slide = Slide::make(view, base, across);
    REQUIRE(slide);
    return straightforward.leastOffsetM(*slide, view);
  };
  CHECK(offset(left, {-1, 0, 0}) == Approx(0.0).margin(1e-6));
  CHECK(offset(left, {1, 0, 0}) == Approx(8.0));
  CHECK(offset({{-1, 0, 3}, {-1, 5, 3}}, {1, 0, 0}) == Approx(5.0));
  CHECK(offset({{-1, 6, 3}, {-1, 7, 3}}, {1, 0, 0}) == 0.0);  // nothing beside it
  const Straightforward::Frame frame = straightforward.place(view);
  CHECK(frame.candidates > 10);
  CHECK(frame.sumM > 0);
}

TEST_CASE("bench: the straightforward version looks at the object's planes too") {
  // Both ways on each plane of the prism around the box that the line is parallel to and that does not stand edge-on.
  const auto measuring = [](const char* slip) {
    return makeModel(test::measuring(
        {"@Handle(scope=Box, type=linear-contour, orient=up, slip=" + std::string(slip) + ")"}, [](const Values&) {
          return sceneOf({{"Box", boxAt({-4, 0, -3}, {8, 5, 6})}});
        }));
  };
  const auto candidates = [&](const char* slip) {
    const auto model = measuring(slip);
    const Scene scene = model->definition.build(Values(model->parameters()));
    const View view(orbitCamera({0, 2.5, 0}, 30, 30, 20), 1000, 1000, scene.bounds);
    return Straightforward(*model, scene).place(view).candidates;
  };
  CHECK(candidates("billboard") == 4 * 2);   // four base lines, the one plane
  CHECK(candidates("object") == 4 * 4 * 2);  // each on any of the four sides
}

TEST_CASE("bench: models of any size") {
  for (const std::size_t triangles : {1000U, 20000U}) {
    const auto model = makeModel(columnField(triangles));
    const Scene scene = model->definition.build(Values(model->parameters()));
    CHECK(static_cast<double>(scene.triangleCount()) == Approx(static_cast<double>(triangles)).epsilon(0.25));
    CHECK(statisticsOf(*model, scene).baseLines == 16);
    for (const Mesh& mesh : scene.meshes) {
      for (const auto& triangle : mesh.triangles) {
        const glm::vec3 middle =
            (mesh.positions[triangle[0]] + mesh.positions[triangle[1]] + mesh.positions[triangle[2]]) / 3.0F;
        const glm::vec3 normal = glm::cross(mesh.positions[triangle[1]] - mesh.positions[triangle[0]],
                                            mesh.positions[triangle[2]] - mesh.positions[triangle[0]]);
        CHECK(glm::dot(normal, middle - glm::vec3(0, 2.5F, 0)) > 0);  // outward
      }
    }
  }
  for (const bool chained : {false, true}) {
    const auto model = makeModel(windowWall(50, chained));
    const Scene scene = model->definition.build(Values(model->parameters()));
    const ModelStatistics statistics = statisticsOf(*model, scene);
    CHECK(statistics.baseLines == 400);
    CHECK((statistics.clusters > 0) == chained);
    for (const Scope& scope : scene.scopes) {
      CHECK(glm::dot(glm::cross(scope.box.axes[0], scope.box.axes[1]), scope.box.axes[2]) == Approx(1));
      CHECK(std::abs(scope.box.center().x) < 20.2);
      CHECK(std::abs(scope.box.center().z) < 20.2);
    }
  }
}

TEST_CASE("bench: every time is measured in both runs") {
  const auto model = makeModel(boxWithDoor());
  const auto result = benchModel(*model, {.frames = 8});
  REQUIRE(result.ok());
  CHECK(result->parameters == 5);
  CHECK(result->statistics.triangles == 24);
  for (const auto what : {&BenchTimes::preprocess, &BenchTimes::placer, &BenchTimes::cpuFields, &BenchTimes::visibility,
                          &BenchTimes::rebuild, &BenchTimes::straightforward}) {
    REQUIRE(steady(*result, what));
    CHECK(steady(*result, what)->ms > 0);
    CHECK(steady(*result, what)->noise >= 0);
  }
  CHECK_FALSE(steady(*result, &BenchTimes::gpuFields));
}

TEST_CASE("dimline bench prints tables, and the contract's JSON") {
  const Run table = runProgram({"bench", "house", "--frames", "2", "--no-growth"});
  REQUIRE(table.status == 0);
  CHECK(table.out.find("house") != std::string::npos);
  CHECK(table.out.find("Growth") == std::string::npos);

  auto models = parsed(runProgram({"models", "--json"}).out);
#ifdef __SANITIZE_ADDRESS__
  // The sanitizers look for what one model shows as well as all.
  const std::string measured = models[0]["name"];
  models.erase(models.begin() + 1, models.end());
#else
  const std::string measured = "all";
#endif
  const Run run = runProgram({"bench", measured, "--frames", "1", "--json"});
  REQUIRE(run.status == 0);
  const auto results = parsed(run.out);
  REQUIRE(results.size() == models.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    INFO(results[i].dump());
    CHECK(results[i]["model"] == models[i]["name"]);
    CHECK(results[i]["triangles"] == models[i]["triangles"]);
    CHECK(results[i]["baseLines"] == models[i]["baseLines"]);
    CHECK(results[i]["clustered"] == models[i]["clusteredBaseLines"]);
    CHECK(results[i]["clusters"] == models[i]["clusters"]);
    CHECK(results[i]["parameters"] == models[i]["parameters"].size());
    for (const char* key :
         {"preprocessMs", "placerMs", "cpuFieldsMs", "visibilityMs", "rebuildMs", "straightforwardMs"}) {
      INFO(key);
      REQUIRE(results[i][key].is_number());
      CHECK(results[i][key].get<double>() > 0);
    }
    CHECK(results[i]["gpuFieldsMs"].is_null());
  }
}

TEST_CASE("dimline bench measures the GPU's fields where it is asked to") {
  const auto measured = parsed(runProgram({"bench", "lever", "--gpu", "--frames", "2", "--json"}).out);
  REQUIRE(measured.size() == 1);
  REQUIRE(measured[0]["gpuFieldsMs"].is_number());
  CHECK(measured[0]["gpuFieldsMs"].get<double>() > 0);

  const Run without =
      runProgram({"bench", "lever", "--gpu", "--frames", "2"}, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}});
  CHECK(without.status == 1);
  CHECK(without.out.empty());
  CHECK(without.err.find("Or leave --gpu out.\n") != std::string::npos);
}

TEST_CASE("bench: a larger viewport is the same orbit in more pixels") {
  const Bounds bounds{Vec3(-1), Vec3(1)};
  const std::vector<View> small = benchViews(bounds, {.frames = 4, .sidePx = 250});
  const std::vector<View> large = benchViews(bounds, {.frames = 4, .sidePx = 2000});
  REQUIRE(small.size() == 4);
  REQUIRE(large.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(small[i].widthPx() == 250);
    CHECK(large[i].heightPx() == 2000);
    CHECK(small[i].camera() == large[i].camera());
    CHECK(small[i].forward().y == Approx(-0.5));   // 30 degrees
  }
}

TEST_CASE("bench: a model that the paper has too stands above the paper's figures, with the ratio of both") {
  BenchTimes times;
  times.placer = 0.25;
  times.cpuFields = 0.75;
  times.straightforward = 500;
  const BenchResult boat{
      .model = "boat",
      .parameters = 23,
      .statistics = {.triangles = 60000, .baseLines = 42, .clusteredBaseLines = 14, .clusters = 20},
      .runs = {times, times}};
  BenchResult other = boat;
  other.model = "shed";
  std::ostringstream out;
  printBench({boat, other}, out);
  std::vector<std::string> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  REQUIRE(lines.size() > 3);
  const auto words = [](const std::string& line) {
    std::istringstream text(line);
    return std::vector<std::string>(std::istream_iterator<std::string>(text), {});
  };
  const auto last = lines.end() - 1;
  CHECK(words(*(last - 2)) == std::vector<std::string>{"boat", "60000", "23", "42", "14", "20", "-", "0.250", "±0%", "0.750",
                                                       "±0%", "-", "-", "-", "500", "±0%", "500.0x"});
  // Its table 1: 58,214 triangles, 364 ms on the CPU and 3 on the GPU.
  CHECK(words(*(last - 1)) == std::vector<std::string>{"the", "paper", "58214", "23", "37", "36", "24", "2", "3", "-", "-",
                                                       "-", "-", "364", "121.3x"});
  CHECK(words(*last)[0] == "shed");
}

TEST_CASE("bench: the growth tables have a row for each size") {
  std::ostringstream out;
  printGrowth(out, {.triangles = {1000, 2000}, .baseLines = {16}, .sidesPx = {250, 300, 350}});
  const std::string text = out.str();
  const auto count = [&](const std::string& sought) {
    std::size_t found = 0;
    for (std::size_t at = text.find(sought); at != std::string::npos; at = text.find(sought, at + 1)) ++found;
    return found;
  };
  CHECK(count("Growth with") == 3);
  // Every time has its noise behind it: three in a row, four for base lines.
  CHECK(count("±") == 2 * 3 + 1 * 4 + 3 * 3);
  for (const char* size : {"\n            16 ", "\n           250 ", "\n           300 ", "\n           350 "}) CHECK(count(size) == 1);
}

TEST_CASE("dimline bench says what is wrong with its arguments") {
  CHECK(runProgram({"bench"}).status == 2);
  CHECK(runProgram({"bench", "house", "--frames", "0"}).status == 2);
  CHECK(runProgram({"bench", "nothing"}).status == 1);
}

}  // namespace
}  // namespace dimline::test
