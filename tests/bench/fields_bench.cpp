// Times the per-frame work of src/silhouette over an orbit, and prints a table: medians in microseconds a frame.
//
//     cmake --build build/native --target fields_bench && build/native/tests/fields_bench

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "silhouette/cpu_fields.h"
#include "silhouette/slide.h"

namespace dimline {
namespace {

constexpr double kPi = 3.141592653589793;

/// A lathe: closed, radius over height from `profile`, with flutes all around.
Mesh columnMesh(int around, int flutes, const std::vector<Vec2>& profile) {
  Mesh mesh;
  const auto rings = static_cast<int>(profile.size());
  for (const Vec2& at : profile) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * kPi * i / around;
      const double r = at.x * (1 - 0.06 * std::abs(std::sin(angle * flutes * 0.5)));
      mesh.positions.emplace_back(r * std::cos(angle), at.y, r * std::sin(angle));
    }
  }
  const auto at = [&](int ring, int i) { return static_cast<std::uint32_t>(ring * around + (i + around) % around); };
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring, i + 1)});
      mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1)});
    }
  }
  for (int i = 1; i + 1 < around; ++i) {
    mesh.triangles.push_back({at(0, 0), at(0, i), at(0, i + 1)});
    mesh.triangles.push_back({at(rings - 1, 0), at(rings - 1, i + 1), at(rings - 1, i)});
  }
  return mesh;
}

Mesh boxMesh() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) != 0 ? 0.5F : -0.5F, (i & 2) != 0 ? 1 : 0, (i & 4) != 0 ? 0.5F : -0.5F);
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

struct Named {
  const char* name;
  Scene scene;
  std::size_t triangles = 0;
};

void place(Scene& scene, std::uint32_t mesh, const Vec3& at, const Vec3& scale) {
  Mat4 m(1.0);
  for (int i = 0; i < 3; ++i) m[i][i] = scale[i];
  m[3] = Vec4(at, 1);
  scene.instances.push_back({mesh, glm::mat4(m)});
}

void measureScene(Named& named) {
  named.triangles = 0;
  for (const Instance& instance : named.scene.instances) {
    const Mesh& mesh = named.scene.meshes[instance.mesh];
    named.triangles += mesh.triangles.size();
    for (const glm::vec3& p : mesh.positions) named.scene.bounds.add(Vec3(instance.transform * glm::vec4(p, 1)));
  }
}

/// A temple: 46 outer and 23 inner fluted columns, steps, entablature with its blocks, roof.
Named temple() {
  Named named{"temple, instances", {}};
  Scene& scene = named.scene;
  std::vector<Vec2> profile;
  for (int i = 0; i <= 6; ++i) profile.emplace_back(0.95 - 0.2 * i / 6.0 - 0.02 * i * (6 - i) / 9.0, 10.4 * i / 6.0);
  scene.meshes.push_back(columnMesh(120, 20, profile));
  scene.meshes.push_back(boxMesh());
  const auto column = [&](double x, double z) { place(scene, 0, {x, 1.5, z}, Vec3(1)); };
  for (int i = 0; i < 8; ++i) {
    for (const double z : {-34.0, 34.0}) column(-14.6 + 29.2 * i / 7, z);
  }
  for (int i = 1; i < 16; ++i) {
    for (const double x : {-14.6, 14.6}) column(x, -34 + 68.0 * i / 16);
  }
  for (int i = 0; i < 6; ++i) {
    for (const double z : {-28.0, 28.0}) column(-10 + 20.0 * i / 5, z);
  }
  for (int i = 0; i < 11; ++i) column(i % 2 == 0 ? -5 : 5, -15 + 3.0 * i);
  for (int i = 0; i < 3; ++i) place(scene, 1, {0, 0.5 * i, 0}, {33.0 - i, 0.5, 72.0 - i});
  place(scene, 1, {0, 11.9, 0}, {31, 2.5, 70});
  for (int i = 0; i < 48; ++i) {
    for (const double x : {-15.6, 15.6}) place(scene, 1, {x, 12.9, -34.5 + 69.0 * i / 47}, {0.3, 1.2, 0.8});
  }
  place(scene, 1, {0, 14.4, 0}, {33, 0.6, 72});
  Mesh roof;
  roof.positions = {{-16.5F, 15, -36}, {16.5F, 15, -36}, {0, 18.5F, -36},
                    {-16.5F, 15, 36},  {16.5F, 15, 36},  {0, 18.5F, 36}};
  roof.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}, {0, 1, 4}, {0, 4, 3}};
  scene.meshes.push_back(roof);
  place(scene, 2, Vec3(0), Vec3(1));
  measureScene(named);
  return named;
}

/// The same triangles as one single mesh, as a file without instances has them.
Named merged(const Named& other) {
  Named named{"temple, one mesh", {}};
  Mesh all;
  for (const Instance& instance : other.scene.instances) {
    const Mesh& mesh = other.scene.meshes[instance.mesh];
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3& p : mesh.positions) all.positions.emplace_back(instance.transform * glm::vec4(p, 1));
    for (const auto& t : mesh.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  named.scene.meshes.push_back(std::move(all));
  place(named.scene, 0, Vec3(0), Vec3(1));
  measureScene(named);
  return named;
}

/// A facade of boxes: many small parts, none round.
Named tower() {
  Named named{"tower of boxes", {}};
  Scene& scene = named.scene;
  scene.meshes.push_back(boxMesh());
  place(scene, 0, Vec3(0), {20, 60, 20});
  for (int floor = 0; floor < 17; ++floor) {
    for (int i = 0; i < 16; ++i) {
      for (const double side : {-10.0, 10.0}) {
        place(scene, 0, {-9 + 1.2 * i, 2 + 3.4 * floor, side}, {0.9, 1.9, 0.2});
        place(scene, 0, {side, 2 + 3.4 * floor, -9 + 1.2 * i}, {0.2, 1.9, 0.9});
        place(scene, 0, {-9 + 1.2 * i, 1.9 + 3.4 * floor, side * 1.01}, {1.0, 0.1, 0.3});
      }
    }
  }
  measureScene(named);
  return named;
}

/// One closed body of as many triangles: nothing can be passed over.
Named body() {
  Named named{"one body", {}};
  std::vector<Vec2> profile;
  for (int i = 0; i <= 256; ++i) {
    const double angle = kPi * (i + 0.5) / 257;
    profile.emplace_back(3 * std::sin(angle), -5 * std::cos(angle));
  }
  named.scene.meshes.push_back(columnMesh(240, 12, profile));
  place(named.scene, 0, Vec3(0), Vec3(1));
  measureScene(named);
  return named;
}

using Clock = std::chrono::steady_clock;

template <typename Work>
double microseconds(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::vector<View> orbit(const Bounds& bounds, double closer) {
  std::vector<View> views;
  for (const double elevationRad : {0.17, 0.52, 1.05}) {
    for (int i = 0; i < 60; ++i) {
      const double azimuth = 2 * kPi * i / 60;
      Camera camera;
      camera.target = bounds.center();
      camera.eye = camera.target + Vec3(std::sin(azimuth) * std::cos(elevationRad), std::sin(elevationRad),
                                        std::cos(azimuth) * std::cos(elevationRad));
      camera = fitToView(camera, bounds, 1000, 1000);
      camera.eye = camera.target + (camera.eye - camera.target) * closer;
      views.emplace_back(camera, 1000, 1000, bounds);
    }
  }
  return views;
}

/// Base lines spread over the model, and ways to slide them.
std::vector<Slide> slidesOf(const View& view, const Bounds& bounds) {
  std::vector<Slide> slides;
  std::uint32_t state = 1;
  const auto random = [&] { return static_cast<double>((state = state * 1664525U + 1013904223U) >> 8) / 16777216.0; };
  for (int i = 0; i < 100; ++i) {
    const Vec3 start = bounds.min + bounds.size() * Vec3(random(), random(), random());
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 along(0.0);
      along[axis] = bounds.size()[axis] * (i % 4 == 0 ? 0.5 : 0.05);
      for (int other = 1; other < 3; ++other) {
        for (const double sign : {-1.0, 1.0}) {
          Vec3 across(0.0);
          across[(axis + other) % 3] = sign;
          if (const std::optional<Slide> slide = Slide::make(view, {start, start + along}, across))
            slides.push_back(*slide);
        }
      }
    }
  }
  return slides;
}

void measure(const Named& named, double closer, const char* how) {
  CpuFields producer;
  std::vector<double> prepare;
  std::vector<double> produce;
  std::vector<double> padding;
  std::vector<double> making;
  std::vector<double> sliding;
  std::vector<double> pulling;
  for (int i = 0; i < 3; ++i) prepare.push_back(microseconds([&] { producer.setScene(named.scene); }));
  DistanceFields fields;
  DistanceFields padded;
  double sum = 0;
  for (const View& view : orbit(named.scene.bounds, closer)) {
    producer.produce(view, fields);
    produce.push_back(microseconds([&] { producer.produce(view, fields); }));
    padding.push_back(microseconds([&] { pad(fields, 30, padded); }));
    std::vector<Slide> slides;
    const double makingUs = microseconds([&] { slides = slidesOf(view, named.scene.bounds); });
    making.push_back(makingUs * 1000 / static_cast<double>(slides.size()));
    const double slidingUs = microseconds([&] {
      for (const Slide& slide : slides) sum += std::min(1.0, leastClearingOffset(padded, slide));
    });
    sliding.push_back(slidingUs * 1000 / static_cast<double>(slides.size()));
    pulling.push_back(microseconds([&] {
                        for (int i = 0; i < 10; ++i) pullIn(padded, Segment2{{100.0 + i, 100}, {400, 600}}, 30);
                      }) *
                      100);
  }
  std::printf("%-20s %-8s %9zu %11.0f %10.1f %8.1f %11.0f %13.0f %10.0f%s\n", named.name, how, named.triangles,
              median(prepare), median(produce), median(padding), median(making), median(sliding), median(pulling),
              sum < 0 ? "!" : "");
}

}  // namespace
}  // namespace dimline

int main() {
  using namespace dimline;
  std::printf("1000x1000, medians over three orbits\n%-20s %-8s %9s %11s %10s %8s %11s %13s %10s\n", "scene", "view",
              "triangles", "prepare us", "produce us", "pad us", "slide ns", "4 queries ns", "pull ns");
  const Named instances = temple();
  const Named one = merged(instances);
  const Named boxes = tower();
  const Named single = body();
  for (const Named* named : {&instances, &one, &boxes, &single}) {
    measure(*named, 1.0, "fit");
    measure(*named, 0.35, "close");
  }
}
