#include "gpu/gpu_fields.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>

#include "support/allocation_count.h"
#include "support/gl_test_context.h"
#include "silhouette/coverage_mask.h"
#include "silhouette/cpu_fields.h"
#include "support/random.h"
#include "support/scenes.h"
#include "support/village.h"

using namespace dimline;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Fixture : test::GlTestContext {
  GpuScene scene{*gl};
  GpuFields fields = makeFields(*gl);

  static GpuFields makeFields(const GlContext& context) {
    Result<GpuFields> made = GpuFields::make(context);
    if (!made) FAIL(made.error().message);
    return std::move(made).value();
  }
  DistanceFields measure(const View& view, double ratio, FieldReduction reduction) {
    fields.setReduction(reduction);
    DistanceFields out;
    REQUIRE(fields.request(scene, view, ratio) != 0);
    REQUIRE(fields.finish(out));
    return out;
  }
};

/// Cameras all round the village: near and far, from above and from below, inside it, and orthographic ones.
std::vector<Camera> fiftyCameras(const Bounds& bounds) {
  test::Random random(2015);
  std::vector<Camera> cameras;
  for (int i = 0; i < 50; ++i) {
    const double distance = bounds.diagonal() * (i % 10 == 9 ? 0.1 : random.real(0.9, 4.0));
    Camera camera = test::orbitCamera(bounds.center(), distance, random.real(0, 360), random.real(-20, 80), random.real(25, 70));
    camera.target += random.point(Vec3(-2.0), Vec3(2.0));
    if (i % 5 == 4) camera.orthoHeightM = bounds.diagonal() * random.real(0.6, 2.0);
    cameras.push_back(camera);
  }
  return cameras;
}

/// The fields of what is left of the silhouette when everything less than 2 CSS px wide or high is taken away: the mask, four times as
/// fine, opened by a square of 2 px (worn down by it, then grown again).
DistanceFields fieldsOfWideParts(const Scene& scene, const View& view) {
  constexpr int kFine = 4;
  constexpr int kSquare = 2 * kFine;
  const int width = static_cast<int>(view.widthPx()) * kFine;
  const int height = static_cast<int>(view.heightPx()) * kFine;
  const CoverageMask mask = coverageMask(scene, View(view.camera(), width, height, scene.bounds));
  // Runs of at least kSquare are kept along rows, then squares are found as runs of such runs along columns.
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); };
  std::vector<int> runEndingAt(mask.pixels.size(), 0);
  std::vector<int> squareRows(mask.pixels.size(), 0);   // rows of full-width runs that end at this pixel
  CoverageMask opened = mask;
  std::fill(opened.pixels.begin(), opened.pixels.end(), std::uint8_t{0});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!mask.covered(x, y)) continue;
      runEndingAt[index(x, y)] = 1 + (x > 0 ? runEndingAt[index(x - 1, y)] : 0);
      if (runEndingAt[index(x, y)] >= kSquare) squareRows[index(x, y)] = 1 + (y > 0 ? squareRows[index(x, y - 1)] : 0);
      if (squareRows[index(x, y)] < kSquare) continue;
      for (int sy = y - kSquare + 1; sy <= y; ++sy) {
        for (int sx = x - kSquare + 1; sx <= x; ++sx) opened.pixels[index(sx, sy)] = 255;
      }
    }
  }
  DistanceFields fine;
  fieldsFromMask(opened, fine);
  DistanceFields fields;
  fields.reset(width / kFine, height / kFine);
  for (const ViewportEdge edge : kViewportEdges) {
    const std::span<float> values = fields[edge].edit();
    for (std::size_t i = 0; i < fine[edge].size(); ++i) values[i / kFine] = std::min(values[i / kFine], fine[edge].at(i) / kFine);
  }
  return fields;
}

/// Whether everything that `inner` blocks lies within 1 px of something that `outer` blocks; otherwise where not.
std::string firstGap(const DistanceFields& inner, const DistanceFields& outer) {
  for (const ViewportEdge edge : kViewportEdges) {
    const std::size_t size = inner[edge].size();
    for (std::size_t i = 0; i < size; ++i) {
      float nearest = kNoSilhouette;
      for (std::size_t j = i > 0 ? i - 1 : 0; j < std::min(size, i + 2); ++j) nearest = std::min(nearest, outer[edge].at(j));
      if (inner[edge].at(i) == kNoSilhouette || nearest <= inner[edge].at(i) + 1.0F + 1e-3F) continue;
      std::ostringstream text;
      text << "edge " << static_cast<int>(edge) << " strip " << i << ": " << inner[edge].at(i) << " against " << nearest;
      return text.str();
    }
  }
  return {};
}

}  // namespace

TEST_CASE("a box seen straight on gives its exact fields, at any pixel ratio and by both reductions") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-20, -10, -5}, {40, 20, 10}));
  finish(scene);
  fixture.scene.upload(scene);
  Camera camera;
  camera.eye = {0, 0, 50};
  camera.orthoHeightM = 60;   // one metre a pixel
  const View view(camera, 100, 60, scene.bounds);
  for (const double ratio : {1.0, 1.5, 2.0, 3.0}) {
    for (const FieldReduction reduction : {FieldReduction::kOnGpu, FieldReduction::kOnCpu}) {
      const DistanceFields fields = fixture.measure(view, ratio, reduction);
      REQUIRE(fields.widthPx == 100);
      REQUIRE(fields.heightPx == 60);
      for (std::size_t row = 0; row < 60; ++row) {
        const float expected = row >= 20 && row < 40 ? 30.0F : kNoSilhouette;
        REQUIRE(fields[ViewportEdge::kLeft].at(row) == expected);
        REQUIRE(fields[ViewportEdge::kRight].at(row) == expected);
      }
      for (std::size_t column = 0; column < 100; ++column) {
        const float expected = column >= 30 && column < 70 ? 20.0F : kNoSilhouette;
        REQUIRE(fields[ViewportEdge::kTop].at(column) == expected);
        REQUIRE(fields[ViewportEdge::kBottom].at(column) == expected);
      }
      REQUIRE(fields[ViewportEdge::kLeft].min(0, 59) == 30.0F);
    }
  }
}

TEST_CASE("GPU fields agree with CPU fields on fifty cameras at pixel ratios 1, 1.5 and 3, by both reductions") {
  Fixture fixture;
  const Scene scene = test::villageScene();
  fixture.scene.upload(scene);
  CpuFields cpu;
  cpu.setScene(scene);
  int touched = 0;
  for (const Camera& camera : fiftyCameras(scene.bounds)) {
    const View view(camera, 320, 240, scene.bounds);
    DistanceFields exact;
    cpu.produce(view, exact);
    const DistanceFields wide = fieldsOfWideParts(scene, view);
    if (exact[ViewportEdge::kLeft].min(0, 239) < kNoSilhouette) ++touched;
    for (const double ratio : {1.0, 1.5, 3.0}) {
      const DistanceFields onGpu = fixture.measure(view, ratio, FieldReduction::kOnGpu);
      const DistanceFields onCpu = fixture.measure(view, ratio, FieldReduction::kOnCpu);
      INFO("azimuth " << std::atan2(camera.eye.x, camera.eye.z) * 180 / kPi << ", height " << camera.eye.y << ", ratio " << ratio);
      for (const ViewportEdge edge : kViewportEdges) {
        REQUIRE(std::ranges::equal(onGpu[edge].values(), onCpu[edge].values()));
      }
      // The CPU's fields are never farther than the GPU's, and the GPU misses nothing that is 2 px wide.
      REQUIRE(firstGap(onGpu, exact) == "");
      REQUIRE(firstGap(wide, onGpu) == "");
    }
  }
  REQUIRE(touched >= 45);
}

TEST_CASE("a warmed-up request and its answer allocate nothing") {
  Fixture fixture;
  const Scene scene = test::villageScene();
  fixture.scene.upload(scene);
  const std::vector<Camera> cameras = fiftyCameras(scene.bounds);
  DistanceFields fields;
  for (const FieldReduction reduction : {FieldReduction::kOnGpu, FieldReduction::kOnCpu}) {
    fixture.fields.setReduction(reduction);
    const auto allocated = [&] {
      const std::size_t before = test::allocationCount();
      for (const Camera& camera : cameras) {
        REQUIRE(fixture.fields.request(fixture.scene, View(camera, 320, 240, scene.bounds), 1.0) != 0);
        REQUIRE(fixture.fields.finish(fields));
      }
      return test::allocationCount() - before;
    };
    (void)allocated();
    CHECK(allocated() == 0);
  }
}

TEST_CASE("a face turned away from the viewer covers what is behind it all the same") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-1, -1, -1}, {2, 2, 2}));
  for (Mesh& mesh : scene.meshes) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  finish(scene);
  fixture.scene.upload(scene);
  Camera camera;
  camera.eye = {0, 0, 9};
  camera.orthoHeightM = 4;
  const DistanceFields fields = fixture.measure(View(camera, 40, 40, scene.bounds), 1, FieldReduction::kOnGpu);
  CHECK(fields[ViewportEdge::kLeft].at(20) == 10.0F);
}

TEST_CASE("an empty scene gives empty fields") {
  Fixture fixture;
  Scene scene;
  finish(scene);
  fixture.scene.upload(scene);
  for (const FieldReduction reduction : {FieldReduction::kOnGpu, FieldReduction::kOnCpu}) {
    const DistanceFields fields = fixture.measure(View({}, 30, 20, scene.bounds), 2, reduction);
    REQUIRE(fields.widthPx == 30);
    for (const ViewportEdge edge : kViewportEdges) {
      for (const float value : fields[edge].values()) REQUIRE(value == kNoSilhouette);
    }
  }
}

TEST_CASE("requests are answered in order, the newest one counts, and no more than three are under way") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-20, -10, -5}, {40, 20, 10}));
  finish(scene);
  fixture.scene.upload(scene);
  Camera camera;
  camera.eye = {0, 0, 50};
  camera.orthoHeightM = 60;
  DistanceFields fields;
  CHECK_FALSE(fixture.fields.poll(fields));
  CHECK_FALSE(fixture.fields.finish(fields));
  for (std::uint64_t number = 1; number <= kInFlight; ++number) {
    camera.orthoHeightM = 60.0 * static_cast<double>(number);
    CHECK(fixture.fields.request(fixture.scene, View(camera, 100, 60, scene.bounds), 1) == number);
  }
  CHECK(fixture.fields.request(fixture.scene, View(camera, 100, 60, scene.bounds), 1) == 0);

  std::optional<std::uint64_t> arrived;
  while (!arrived || *arrived < kInFlight) {
    if (const auto number = fixture.fields.poll(fields)) {
      CHECK((!arrived || *number > *arrived));
      arrived = number;
    }
  }
  // At 180 m for 60 px, 40 m are 13 1/3 px; pixels are covered where their centres are.
  CHECK(fields[ViewportEdge::kLeft].at(30) == Approx(43).margin(0.5));
  CHECK_FALSE(fixture.fields.poll(fields));
  CHECK(fixture.fields.request(fixture.scene, View(camera, 100, 60, scene.bounds), 1) == kInFlight + 1);
}

TEST_CASE("a viewport larger than the driver's largest texture is measured more coarsely") {
  Fixture fixture;
  Scene scene;
  test::addBox(scene, test::boxAt({-20, -10, -5}, {40, 20, 10}));
  finish(scene);
  fixture.scene.upload(scene);
  Camera camera;
  camera.eye = {0, 0, 50};
  camera.orthoHeightM = 20;
  const double widthPx = fixture.gl->maxTextureSize() * 2.0;
  const DistanceFields fields = fixture.measure(View(camera, widthPx, 2, scene.bounds), 1, FieldReduction::kOnGpu);
  CHECK(fields.widthPx == static_cast<int>(widthPx));
  // At a tenth of a pixel a metre the box is 4 px wide and as high as the viewport.
  CHECK(fields[ViewportEdge::kTop].min(0, static_cast<std::size_t>(widthPx) - 1) == 0.0F);
  CHECK(fields[ViewportEdge::kLeft].at(0) == Approx(widthPx / 2 - 2).margin(2));
}
