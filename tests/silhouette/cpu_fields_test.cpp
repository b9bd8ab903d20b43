#include "silhouette/cpu_fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "silhouette/coverage_mask.h"
#include "silhouette/scene_shapes.h"
#include "silhouette/slide.h"
#include "support/allocation_count.h"
#include "support/random.h"

namespace dimline {
namespace {

using test::Random;

DistanceFields produced(const Scene& scene, const View& view) {
  CpuFields producer;
  producer.setScene(scene);
  DistanceFields fields;
  producer.produce(view, fields);
  return fields;
}

Camera frontCamera(double heightM) {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = heightM;
  return camera;
}

// --- By hand
// ----------------------------------------------------------------------------------------------------------

TEST_CASE("an empty scene has empty fields") {
  const Scene scene;
  Camera camera;
  const DistanceFields fields = produced(scene, View(camera, 300, 200, scene.bounds));
  REQUIRE(fields.widthPx == 300);
  REQUIRE(fields.heightPx == 200);
  for (const ViewportEdge edge : kViewportEdges) REQUIRE(fields[edge].least(1) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kLeft].size() == 200);
  REQUIRE(fields[ViewportEdge::kTop].size() == 300);
}

TEST_CASE("a box seen from the front, by hand") {
  Scene scene;
  test::add(scene, test::boxMesh(), test::placed({0.025, 0, 0}, {0, 1, 0}, 0, Vec3(1.0)));
  // 10 px a metre; x from 10.25 to 30.25 and y from 10 to 30.
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 40, scene.bounds));
  REQUIRE(fields[ViewportEdge::kLeft].at(20) == Approx(10.25).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kRight].at(20) == Approx(9.75).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kTop].at(20) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kBottom].at(20) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kTop].at(10) == Approx(10).margin(1e-4));  // its strip from 10.25 on
  REQUIRE(fields[ViewportEdge::kTop].at(9) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kTop].at(31) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kLeft].at(8) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kLeft].at(31) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kLeft].least(1) == fields[ViewportEdge::kLeft].at(20));
}

TEST_CASE("a slanted edge gives each strip its extreme over the whole strip") {
  Scene scene;
  // A triangle with corners at (4, 4), (36, 4), (4, 12) px: the slanted side falls 1 px in 4.
  Mesh mesh;
  mesh.positions = {{-1.6F, 1.6F, 0}, {1.6F, 1.6F, 0}, {-1.6F, 0.8F, 0}};
  mesh.triangles = {{0, 2, 1}};
  test::add(scene, mesh);
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 40, scene.bounds));
  REQUIRE(fields[ViewportEdge::kRight].at(4) == Approx(4).margin(1e-3));
  REQUIRE(fields[ViewportEdge::kRight].at(5) == Approx(8).margin(1e-3));  // at the strip's top
  REQUIRE(fields[ViewportEdge::kRight].at(11) == Approx(32).margin(1e-3));
  REQUIRE(fields[ViewportEdge::kBottom].at(4) == Approx(28).margin(1e-3));
  REQUIRE(fields[ViewportEdge::kBottom].at(8) == Approx(29).margin(1e-3));  // at the strip's left
  REQUIRE(fields[ViewportEdge::kLeft].at(8) == Approx(4).margin(1e-3));
}

TEST_CASE("a wire thinner than a pixel is seen") {
  Scene scene;
  test::add(scene, test::boxMesh(), test::placed({0.012, 0, 0}, {0, 1, 0}, 0, {0.001, 1, 0.001}));
  const View view(frontCamera(4), 40, 40, scene.bounds);
  const DistanceFields fields = produced(scene, view);
  REQUIRE(fields[ViewportEdge::kLeft].at(20) == Approx(20.11).margin(1e-3));
  REQUIRE(fields[ViewportEdge::kRight].at(20) == Approx(19.87).margin(1e-3));
  REQUIRE(fields[ViewportEdge::kTop].at(20) == Approx(10).margin(1e-3));
  DistanceFields fromMask;
  fieldsFromMask(coverageMask(scene, view), fromMask);
  REQUIRE(fromMask[ViewportEdge::kLeft].at(20) == kNoSilhouette);  // it falls between the pixels' centres
}

TEST_CASE("a face that fills the viewport leaves no room on any side") {
  Scene scene;
  test::add(scene, test::boxMesh(), test::placed({0, 0, 0}, {0, 1, 0}, 0.3, {50, 50, 1}));
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 30, scene.bounds));
  for (const ViewportEdge edge : kViewportEdges) REQUIRE(std::ranges::max(fields[edge].values()) == 0);
}

TEST_CASE("the inside of a box leaves no room on any side") {
  Scene scene;
  test::add(scene, test::boxMesh());
  Camera camera;
  camera.eye = {0.1, 0.2, 0.3};
  camera.target = {3, 1, -2};
  const DistanceFields fields = produced(scene, View(camera, 200, 150, scene.bounds));
  for (const ViewportEdge edge : kViewportEdges) REQUIRE(std::ranges::max(fields[edge].values()) == 0);
}

TEST_CASE("a part that leaves the viewport touches its side there and nowhere else") {
  Scene scene;
  // x from 30 to 50 px where the viewport ends at 40, y from 10 to 30.
  test::add(scene, test::boxMesh(), test::placed({2, 0, 0}, {0, 1, 0}, 0, Vec3(1.0)));
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 40, scene.bounds));
  for (std::size_t i = 10; i < 30; ++i) {
    REQUIRE(fields[ViewportEdge::kRight].at(i) == 0);
    REQUIRE(fields[ViewportEdge::kLeft].at(i) == Approx(30).margin(1e-4));
  }
  REQUIRE(fields[ViewportEdge::kRight].at(8) == kNoSilhouette);
  REQUIRE(fields[ViewportEdge::kTop].at(35) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kTop].at(39) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kTop].at(28) == kNoSilhouette);
}

TEST_CASE("what lies behind the viewer or beside the viewport is not seen") {
  Scene scene;
  test::add(scene, test::boxMesh(), test::placed({0, 0, 30}, {0, 1, 0}, 0, Vec3(1.0)));
  test::add(scene, test::boxMesh(), test::placed({100, 0, 0}, {0, 1, 0}, 0, Vec3(1.0)));
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.target = {0, 0, 0};
  const DistanceFields fields = produced(scene, View(camera, 200, 150, scene.bounds));
  for (const ViewportEdge edge : kViewportEdges) REQUIRE(fields[edge].least(1) == kNoSilhouette);
}

TEST_CASE("a mesh flattened to nothing is seen as the sheet that it is") {
  Scene scene;
  test::add(scene, test::boxMesh(), test::placed({0, 0, 0}, {0, 1, 0}, 0, {1, 1, 0}));
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 40, scene.bounds));
  REQUIRE(fields[ViewportEdge::kLeft].at(20) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kBottom].at(20) == Approx(10).margin(1e-4));
}

TEST_CASE("an instance without a place is not seen, and spoils nothing") {
  Scene scene;
  test::add(scene, test::boxMesh());
  glm::mat4 nowhere(1.0F);
  nowhere[3][0] = std::nanf("");
  scene.instances.push_back({0, nowhere});
  nowhere[3][0] = HUGE_VALF;
  scene.instances.push_back({0, nowhere});
  const DistanceFields fields = produced(scene, View(frontCamera(4), 40, 40, scene.bounds));
  REQUIRE(fields[ViewportEdge::kLeft].at(20) == Approx(10).margin(1e-4));
  REQUIRE(fields[ViewportEdge::kTop].at(5) == kNoSilhouette);
}

// --- Against the mask
// -------------------------------------------------------------------------------------------------

Mesh randomMesh(Random& random) {
  Mesh mesh;
  switch (random.whole(0, 3)) {
    case 0:
      mesh = test::boxMesh();
      break;
    case 1:
      mesh = test::sphereMesh(random.whole(3, 14), random.whole(3, 20));
      break;
    case 2:
      mesh = test::sheetMesh(random.whole(1, 6), random.real(0, 0.5));
      break;
    default:
      mesh = test::sheetMesh(1, 0);
      break;
  }
  return random.chance(0.2) ? test::split(mesh) : mesh;
}

Scene randomScene(Random& random, double sizeM) {
  Scene scene;
  const int count = random.whole(1, 8);
  for (int i = 0; i < count; ++i) {
    Vec3 scale = Vec3(random.scaled(0.05, 0.7), random.scaled(0.05, 0.7), random.scaled(0.05, 0.7)) * sizeM;
    if (random.chance(0.25)) scale[random.whole(0, 2)] *= 0.01;
    const bool straight = random.chance(0.3);
    const glm::mat4 transform =
        test::placed(random.point(Vec3(-sizeM), Vec3(sizeM)) * 0.7, straight ? Vec3(0, 1, 0) : random.direction(),
                     straight ? 0 : random.real(0, 6.3), scale);
    if (i > 0 && random.chance(0.3)) {  // an instance of a mesh that is there already
      const auto mesh = static_cast<std::uint32_t>(random.whole(0, static_cast<int>(scene.meshes.size()) - 1));
      scene.instances.push_back({mesh, transform});
      for (const glm::vec3& p : scene.meshes[mesh].positions) scene.bounds.add(Vec3(transform * glm::vec4(p, 1)));
    } else {
      test::add(scene, randomMesh(random), transform);
    }
  }
  return scene;
}

Camera randomCamera(Random& random, double sizeM) {
  Camera camera;
  camera.target = random.point(Vec3(-sizeM), Vec3(sizeM)) * 0.5;
  camera.fovRad = random.scaled(0.2, 100) * 0.017453292519943295;
  const double fits = sizeM / std::tan(camera.fovRad / 2);
  const Vec3 way = random.chance(0.15) ? Vec3(random.whole(0, 1) * 2.0 - 1, 0, 0) : random.direction();
  switch (random.whole(0, 4)) {
    case 0:
      camera.eye = camera.target + way * (sizeM * random.real(0.01, 1));
      break;  // in the midst
    case 1:
      camera.eye = camera.target + way * (fits * random.real(0.2, 0.8));
      break;  // too close to see all
    case 2:
      camera.orthoHeightM = sizeM * random.scaled(0.5, 5);
      camera.eye = camera.target + way * sizeM;
      break;
    default:
      camera.eye = camera.target + way * (fits * random.real(1, 3));
      break;
  }
  if (glm::length(camera.eye - camera.target) < 1e-3 * sizeM) camera.eye = camera.target + Vec3(0, 0, sizeM);
  return camera;
}

/// The model's triangles on screen, cut at the near plane: convex polygons.
std::vector<std::vector<Vec2>> screenPolygons(const Scene& scene, const View& view) {
  std::vector<std::vector<Vec2>> polygons;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const auto& triangle : mesh.triangles) {
      std::vector<Vec2> polygon;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a(Mat4(instance.transform) * Vec4(Vec3(mesh.positions[triangle[i]]), 1));
        const Vec3 b(Mat4(instance.transform) * Vec4(Vec3(mesh.positions[triangle[(i + 1) % 3]]), 1));
        const double da = view.depth(a) - view.nearM();
        const double db = view.depth(b) - view.nearM();
        if (da >= 0) polygon.push_back(view.toScreen(a));
        if ((da >= 0) != (db >= 0)) polygon.push_back(view.toScreen(a + (b - a) * (da / (da - db))));
      }
      if (polygon.size() >= 3) polygons.push_back(polygon);
    }
  }
  return polygons;
}

bool contains(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Vec2 to = p - polygon[i];
    const double turn = side.x * to.y - side.y * to.x;
    left = left || turn < 0;
    right = right || turn > 0;
  }
  return left != right;
}

/// How far a segment on screen is from what the polygons cover.
double distanceFrom(const std::vector<std::vector<Vec2>>& polygons, const Segment2& segment) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& polygon : polygons) {
    if (contains(polygon, segment.start)) return 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      least = std::min(least, distanceBetween(segment, Segment2{polygon[i], polygon[(i + 1) % polygon.size()]}));
    }
  }
  return least;
}

/// The cross-section of a strip at the field's value.
Segment2 crossSection(const DistanceFields& fields, ViewportEdge edge, std::size_t strip) {
  const double value = fields[edge].at(strip);
  const double low = static_cast<double>(strip);
  switch (edge) {
    case ViewportEdge::kLeft:
      return {{value, low}, {value, low + 1}};
    case ViewportEdge::kRight:
      return {{fields.widthPx - value, low}, {fields.widthPx - value, low + 1}};
    case ViewportEdge::kTop:
      return {{low, value}, {low + 1, value}};
    case ViewportEdge::kBottom:
      return {{low, fields.heightPx - value}, {low + 1, fields.heightPx - value}};
  }
  return {};
}

TEST_CASE("no field is farther from its edge than a mask of the same picture, nor nearer than the model comes") {
  Random random(21);
  int covered = 0;
  int reached = 0;
  for (int round = 0; round < 1200; ++round) {
    const double sizeM = random.scaled(0.1, 1000);
    const Scene scene = randomScene(random, sizeM);
    const Camera camera = randomCamera(random, sizeM);
    const View view(camera, random.whole(60, 200), random.whole(60, 160), scene.bounds);
    const DistanceFields fields = produced(scene, view);
    const std::vector<std::vector<Vec2>> polygons = screenPolygons(scene, view);
    DistanceFields fromMask;
    fieldsFromMask(coverageMask(scene, view), fromMask);
    for (const ViewportEdge edge : kViewportEdges) {
      for (std::size_t strip = 0; strip < fields[edge].size(); ++strip) {
        const float got = fields[edge].at(strip);
        const float expected = fromMask[edge].at(strip);
        INFO("round " << round << " edge " << static_cast<int>(edge) << " strip " << strip << ": exact " << got
                      << ", mask " << expected);
        if (expected != kNoSilhouette) {
          // A pixel is covered when its centre is, half a pixel beyond the side that the mask's field tells.
          REQUIRE(got <= expected + 0.5F + 1e-3F);
          ++covered;
        }
        if (got == kNoSilhouette) continue;
        REQUIRE(got >= 0);
        REQUIRE(got <= fields.extentPx(edge));
        if (!random.chance(0.1)) continue;
        REQUIRE(distanceFrom(polygons, crossSection(fields, edge, strip)) < 0.01);
        ++reached;
      }
    }
  }
  REQUIRE(covered > 100000);
  REQUIRE(reached > 10000);
}

TEST_CASE("fields of solid things agree with a mask's to within a pixel") {
  Random random(22);
  int strips = 0;
  int apart = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene;
    for (int i = 0; i < 3; ++i) {
      const glm::mat4 transform = test::placed(random.point(Vec3(-1.0), Vec3(1.0)), random.direction(),
                                               random.real(0, 6.3), random.point(Vec3(0.4), Vec3(0.8)));
      test::add(scene, random.chance(0.5) ? test::boxMesh() : test::sphereMesh(20, 30), transform);
    }
    Camera camera;
    camera.eye = random.direction() * 12.0;
    const View view(camera, 400, 300, scene.bounds);
    const DistanceFields fields = produced(scene, view);
    DistanceFields fromMask;
    fieldsFromMask(coverageMask(scene, view), fromMask);
    for (const ViewportEdge edge : kViewportEdges) {
      const DistanceField& masked = fromMask[edge];
      for (std::size_t i = 1; i + 1 < masked.size(); ++i) {
        if (masked.at(i) == kNoSilhouette) continue;
        ++strips;
        // An extreme may lie at the very border of its strip: it shows in a neighbour's pixel.
        const float around = masked.min(i - 1, i + 1);
        if (!(fields[edge].at(i) >= around - 1) || !(fields[edge].at(i) <= masked.at(i) + 1)) ++apart;
      }
    }
  }
  REQUIRE(strips > 20000);
  // Left are the tips of corners, which are thinner than two pixels.
  REQUIRE(apart < strips / 200);
}

TEST_CASE("a far viewer with a long lens keeps the fields to a tenth of a pixel") {
  // The same thing on screen, nearly: in parallel projection and through 0.2 degrees from far away.
  Scene scene;
  test::add(scene, test::sphereMesh(40, 60), test::placed({300, 50, -200}, {0, 1, 0}, 0.4, {3, 2, 3}));
  Camera far;
  far.target = {300, 50, -200};
  const Vec3 way = glm::normalize(Vec3(1, 0.4, 2));
  far.fovRad = 0.2 * 0.017453292519943295;
  const double distance = 5 / std::tan(far.fovRad / 2);
  far.eye = far.target + way * distance;
  Camera parallel = far;
  parallel.orthoHeightM = 10;
  const DistanceFields a = produced(scene, View(far, 1000, 1000, scene.bounds));
  const DistanceFields b = produced(scene, View(parallel, 1000, 1000, scene.bounds));
  for (const ViewportEdge edge : kViewportEdges) {
    const auto first = static_cast<std::size_t>(500 - 100);
    for (std::size_t strip = first; strip < 600; ++strip)
      REQUIRE(std::abs(a[edge].at(strip) - b[edge].at(strip)) < 0.1F + 300 * 3 / distance);
  }
}

bool sameFields(const DistanceFields& a, const DistanceFields& b, float tolerance) {
  for (const ViewportEdge edge : kViewportEdges) {
    for (std::size_t strip = 0; strip < a[edge].size(); ++strip) {
      const float one = a[edge].at(strip);
      const float other = b[edge].at(strip);
      if (one != other && !(std::abs(one - other) <= tolerance)) return false;
    }
  }
  return true;
}

TEST_CASE("the fields of a scene are the least of its parts', to the bit, and in any order") {
  // Passing over parts that can change nothing is exact.
  Random random(23);
  for (int round = 0; round < 150; ++round) {
    Scene scene = randomScene(random, 1.0);
    for (int more = 0; more < 40; ++more) {
      const Vec3 at = random.point(Vec3(-0.7), Vec3(0.7));
      const Vec3 size = random.point(Vec3(0.01), Vec3(0.1));
      test::add(scene, test::boxMesh(), test::placed(at, random.direction(), random.real(0, 6), size));
    }
    const View view(randomCamera(random, 1.0), 150, 120, scene.bounds);
    const DistanceFields fields = produced(scene, view);
    Scene reversed = scene;
    std::reverse(reversed.instances.begin(), reversed.instances.end());
    REQUIRE(sameFields(produced(reversed, view), fields, 0));

    DistanceFields least;
    least.reset(fields.widthPx, fields.heightPx);
    Scene alone = scene;
    for (const Instance& instance : scene.instances) {
      alone.instances = {instance};
      const DistanceFields one = produced(alone, view);
      for (const ViewportEdge edge : kViewportEdges) {
        const std::span<float> values = least[edge].edit();
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::min(values[i], one[edge].at(i));
      }
    }
    INFO("round " << round);
    REQUIRE(sameFields(least, fields, 0));
  }
}

TEST_CASE("how a model is gathered into meshes changes no field") {
  Random random(25);
  for (int round = 0; round < 100; ++round) {
    const Scene scene = randomScene(random, 1.0);
    const View view(randomCamera(random, 1.0), 150, 120, scene.bounds);
    const DistanceFields fields = produced(scene, view);
    Scene apart = scene;
    for (Mesh& mesh : apart.meshes) mesh = test::split(mesh);
    INFO("round " << round);
    REQUIRE(sameFields(produced(apart, view), fields, 1e-3F));
  }
}

TEST_CASE("a frame allocates nothing after the first") {
  Random random(24);
  const Scene scene = randomScene(random, 1.0);
  CpuFields producer;
  producer.setScene(scene);
  DistanceFields fields;
  DistanceFields padded;
  std::vector<View> views;
  for (int i = 0; i < 20; ++i) views.emplace_back(randomCamera(random, 1.0), 640, 480, scene.bounds);
  const auto frame = [&](const View& view) {
    producer.produce(view, fields);
    pad(fields, 30, padded);
    pullIn(padded, Segment2{{100, 100}, {300, 200}}, 4);
    pullIn(padded, Box2{{100, 100}, {300, 200}}, 4);
    const std::optional<Slide> slide =
        Slide::make(view, {view.camera().target, view.camera().target + view.right()}, view.up());
    return slide ? leastClearingOffset(padded, *slide) : 0.0;
  };
  frame(views[0]);
  const std::size_t before = test::allocationCount();
  double sum = 0;
  for (const View& view : views) sum += std::min(frame(view), 1.0);
  REQUIRE(test::allocationCount() == before);
  REQUIRE(sum >= 0);
  const std::vector<int> something(10);
  REQUIRE(test::allocationCount() == before + 1);  // and it would have been noticed
}

}  // namespace
}  // namespace dimline
