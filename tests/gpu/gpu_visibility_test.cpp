#include "gpu/gpu_visibility.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/constants.h"
#include "support/gl_test_context.h"
#include "support/random.h"
#include "support/scenes.h"
#include "support/village.h"

using namespace dimline;

namespace {

struct Fixture : test::GlTestContext {
  GpuScene scene{*gl};
  GpuVisibility visibility = make(*gl);

  static GpuVisibility make(const GlContext& context) {
    Result<GpuVisibility> made = GpuVisibility::make(context);
    if (!made) FAIL(made.error().message);
    return std::move(made).value();
  }
  void set(const Scene& next) {
    scene.upload(next);
    visibility.setScene(next);
  }
  ScopeVisibility measureAll(const View& view) {
    ScopeVisibility out;
    REQUIRE(visibility.request(scene, view) != 0);
    REQUIRE(visibility.finish(out));
    REQUIRE(glGetError() == GL_NO_ERROR);
    return out;
  }
  std::vector<float> measure(const View& view) { return measureAll(view).seenShare; }
};

ScopeVisibility measureOnCpu(const Scene& scene, const View& view) {
  ScopeVisibility out;
  CpuVisibility().measure(scene, view, out);
  return out;
}

/// How many of a box's edges one answer has seen and the other has not.
std::size_t edgesApart(SeenEdges a, SeenEdges b) {
  std::size_t apart = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int number = 0; number < 4; ++number) apart += a.has(axis, number) != b.has(axis, number) ? 1 : 0;
  }
  return apart;
}

/// The village, and boxes of every size in, on, before and behind its houses, turned any way.
Scene villageWithScopes(int count) {
  Scene scene = test::villageScene();
  test::Random random(2010);
  const Vec3 extent = scene.bounds.max - scene.bounds.min;
  for (int i = 0; i < count; ++i) {
    Obb box;
    box.origin = scene.bounds.min + extent * random.point(Vec3(-0.1), Vec3(1.0));
    const double turn = random.real(0, 6.28);
    box.axes = {Vec3(std::cos(turn), 0, std::sin(turn)), Vec3(0, 1, 0), Vec3(-std::sin(turn), 0, std::cos(turn))};
    // From a nail's head to a whole house, some flat.
    const double size = std::exp(random.real(std::log(0.01), std::log(0.5 * scene.bounds.diagonal())));
    box.size = Vec3(size * random.real(0.2, 1), size * random.real(0.2, 1), i % 7 == 0 ? 0.0 : size * random.real(0.2, 1));
    scene.scopes.push_back({"Scope", static_cast<std::uint32_t>(i), box});
  }
  finish(scene);
  return scene;
}

/// Cameras all round: near and far, in the scene, from above and below, orthographic ones.
std::vector<Camera> cameras(const Bounds& bounds, int count) {
  test::Random random(7);
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const double distance = bounds.diagonal() * (i % 8 == 7 ? 0.15 : random.real(0.8, 4.0));
    Camera camera = test::orbitCamera(bounds.center(), distance, random.real(0, 360), random.real(-20, 85), random.real(20, 90));
    camera.target += random.point(Vec3(-2.0), Vec3(2.0));
    if (i % 4 == 3) camera.orthoHeightM = bounds.diagonal() * random.real(0.4, 2.0);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace

TEST_CASE("the GPU sees of each scope what the CPU sees, from everywhere") {
  Fixture fixture;
  const Scene scene = villageWithScopes(150);
  fixture.set(scene);
  std::size_t compared = 0, apart = 0, decidedOtherwise = 0, seen = 0, hidden = 0, edges = 0, edgesHidden = 0;
  double sum = 0;
  for (const Camera& camera : cameras(scene.bounds, 60)) {
    for (const auto& [width, height] : {std::pair{1000, 1000}, {1400, 700}, {300, 200}}) {
      const View view(camera, width, height, scene.bounds);
      const ScopeVisibility onCpu = measureOnCpu(scene, view);
      const ScopeVisibility onGpu = fixture.measureAll(view);
      const std::vector<float>& cpu = onCpu.seenShare;
      const std::vector<float>& gpu = onGpu.seenShare;
      REQUIRE(gpu.size() == cpu.size());
      REQUIRE(onGpu.seenEdges.size() == cpu.size());
      for (std::size_t i = 0; i < cpu.size(); ++i) {
        const double difference = std::abs(static_cast<double>(gpu[i] - cpu[i]));
        ++compared;
        edges += edgesApart(onCpu.seenEdges[i], onGpu.seenEdges[i]);
        edgesHidden += edgesApart(onCpu.seenEdges[i], SeenEdges::all());
        sum += difference;
        apart += difference > 0.1 ? 1 : 0;
        // Shown by the one and not even kept by the other: only that would be seen.
        const auto [low, high] = std::minmax(cpu[i], gpu[i]);
        decidedOtherwise += static_cast<double>(low) < kSeenShareToKeep && static_cast<double>(high) >= kSeenShareToShow ? 1 : 0;
        (static_cast<double>(cpu[i]) >= kSeenShareToShow ? seen : hidden) += 1;
      }
    }
  }
  INFO(compared << " compared, " << apart << " apart by more than 0.1, " << decidedOtherwise << " decided otherwise, mean difference "
                << sum / static_cast<double>(compared) << "; " << seen << " seen, " << hidden << " hidden; " << edges << " edges apart, "
                << edgesHidden << " hidden");
  CHECK(seen > compared / 10);
  CHECK(hidden > compared / 10);
  CHECK(edgesHidden > SeenEdges::kCount * compared / 10);
  CHECK(edgesHidden < 9 * SeenEdges::kCount * compared / 10);
  CHECK(static_cast<double>(edges) < 0.001 * SeenEdges::kCount * static_cast<double>(compared));
  CHECK(sum / static_cast<double>(compared) < 0.001);
  CHECK(static_cast<double>(apart) < 0.001 * static_cast<double>(compared));
  CHECK(static_cast<double>(decidedOtherwise) < 0.0005 * static_cast<double>(compared));
}

TEST_CASE("a wall hides what is behind it, on the GPU too") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-5, 0, -0.3}, {10, 6, 0.3}));
  scene.scopes.push_back({"Before", 0, test::boxAt({-1, 1, 1}, {2, 2, 1})});
  scene.scopes.push_back({"Behind", 0, test::boxAt({-1, 1, -3}, {2, 2, 1})});
  scene.scopes.push_back({"InFace", 0, test::boxAt({-1, 1, -0.2}, {1, 1, 0.2})});
  scene.scopes.push_back({"Tiny", 0, test::boxAt({2, 3, 0.1}, {1e-4, 1e-4, 1e-4})});
  scene.scopes.push_back({"BehindTheViewer", 0, test::boxAt({0, 1, 60}, {2, 2, 2})});
  scene.scopes.push_back({"HalfBehind", 0, test::boxAt({4.75, 1, -2.5}, {0.5, 0.5, 0.5})});
  finish(scene);
  fixture.set(scene);
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.eye = {0, 3, 40};
    camera.target = {0, 3, 0};
    if (orthographic) camera.orthoHeightM = 20;
    const std::vector<float> seen = fixture.measure(View(camera, 1000, 1000, scene.bounds));
    INFO((orthographic ? "orthographic" : "perspective"));
    CHECK(seen[0] == 1.0F);
    CHECK(seen[1] == 0.0F);
    CHECK(seen[2] == 1.0F);
    CHECK(seen[3] == 1.0F);
    CHECK(seen[4] == 0.0F);
    CHECK(seen[5] == Approx(orthographic ? 0.5 : 0.0).margin(0.06));
  }
}

TEST_CASE("a viewer within a scope, and a scope that reaches behind the viewer") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-1, 0, -12}, {2, 2, 1}));
  scene.scopes.push_back({"Around", 0, test::boxAt({-2, -2, -4}, {4, 6, 8})});
  scene.scopes.push_back({"Floor", 0, test::boxAt({-3, -1.2, -20}, {6, 0.2, 40})});
  finish(scene);
  fixture.set(scene);
  Camera camera;
  camera.eye = {0, 1, 0};
  camera.target = {0, 1, -10};
  const View view(camera, 800, 600, scene.bounds);
  const std::vector<float> cpu = measureOnCpu(scene, view).seenShare;
  const std::vector<float> gpu = fixture.measure(view);
  CHECK(gpu[0] == cpu[0]);
  CHECK(gpu[1] == Approx(cpu[1]).margin(0.02));
  CHECK(cpu[1] > 0.5F);
}

TEST_CASE("scopes by the thousand stand in several columns, each with its own answer") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-60, -60, 0}, {120, 120, 1}));
  // Every third one hidden behind the wall.
  for (int i = 0; i < 2600; ++i) {
    const Vec3 at(-50 + i % 51 * 2, -50 + i / 51 * 2, i % 3 == 0 ? -20 : 5);
    scene.scopes.push_back({"Scope", static_cast<std::uint32_t>(i), test::boxAt(at, {1, 1, 1})});
  }
  finish(scene);
  fixture.set(scene);
  Camera camera;
  camera.eye = {0, 0, 200};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = 130;
  const std::vector<float> seen = fixture.measure(View(camera, 1000, 1000, scene.bounds));
  REQUIRE(seen.size() == 2600);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) wrong += seen[i] == (i % 3 == 0 ? 0.0F : 1.0F) ? 0 : 1;
  CHECK(wrong == 0);
}

TEST_CASE("answers come in the order of the requests, and none for other scopes") {
  Fixture fixture;
  const Scene scene = villageWithScopes(20);
  fixture.set(scene);
  const std::vector<Camera> views = cameras(scene.bounds, 3);
  ScopeVisibility out;
  CHECK_FALSE(fixture.visibility.poll(out));
  std::uint64_t last = 0;
  for (const Camera& camera : views) {
    const std::uint64_t number = fixture.visibility.request(fixture.scene, View(camera, 400, 300, scene.bounds));
    CHECK(number > last);
    last = number;
  }
  CHECK(fixture.visibility.request(fixture.scene, View(views[0], 400, 300, scene.bounds)) == 0);   // three under way
  CHECK(fixture.visibility.finish(out) == last);
  CHECK_FALSE(fixture.visibility.finish(out));   // the older ones went with it

  REQUIRE(fixture.visibility.request(fixture.scene, View(views[0], 400, 300, scene.bounds)) != 0);
  fixture.set(villageWithScopes(30));
  CHECK_FALSE(fixture.visibility.finish(out));
  fixture.set(Scene{});
  CHECK(fixture.visibility.request(fixture.scene, View(views[0], 400, 300, scene.bounds)) == 0);
}
