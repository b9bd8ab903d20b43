#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>

#include <catch2/catch.hpp>

#include "models/models.h"
#include "support/mesh_checks.h"
#include "support/model_settings.h"

// What holds for every built-in model in every setting. What one model alone promises stands in its own test.

namespace dimline {
namespace {

#ifdef __SANITIZE_ADDRESS__
/// The sanitizers look for what one setting shows as well as many, at several times the cost.
constexpr std::size_t kSettingsShare = 6;
#else
constexpr std::size_t kSettingsShare = 1;
#endif

/// How many random settings a model is tried in. The more it holds, the fewer, so that the slowest take a few seconds too;
/// DIMLINE_SETTINGS=2000 in the environment asks for that many of each.
std::size_t randomSettings(const Model& model) {
  if (const char* asked = std::getenv("DIMLINE_SETTINGS")) return static_cast<std::size_t>(std::atoi(asked));
  const Scene scene = model.definition.build(Values(model.parameters()));
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) triangles += mesh.triangles.size();
  return std::clamp<std::size_t>(1'500'000 / std::max<std::size_t>(triangles, 1), 30, 500) / kSettingsShare;
}

/// Runs body(model) for every built-in model, with its name in failures.
template <typename Body>
void forEveryModel(Body&& body) {
  for (const BuiltInModel& built : builtInModels()) {
    INFO(built.name);
    body(findBuiltInModel(built.name).value());
  }
}

/// Runs body(values, scene) for the model in many settings.
template <typename Body>
void inManySettings(const Model& model, Body&& body) {
  for (const Values& values : test::manySettings(model.parameters(), randomSettings(model))) {
    INFO(test::text(model.parameters(), values));
    body(values, model.definition.build(values));
  }
}

/// How far the model reaches along a scope's axes. Remembered by the axes: scopes are many, and few of them are turned.
class Reach {
public:
  explicit Reach(const Scene& scene) : scene_(scene) {}

  const Bounds& along(const std::array<Vec3, 3>& axes) {
    for (const auto& [known, bounds] : found_) {
      if (known == axes) return bounds;
    }
    Bounds bounds;
    for (const Instance& instance : scene_.instances) {
      for (const glm::vec3& local : scene_.meshes[instance.mesh].positions) {
        const Vec3 p(instance.transform * glm::vec4(local, 1.0F));
        bounds.add({glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2])});
      }
    }
    return found_.emplace_back(axes, bounds).second;
  }

private:
  const Scene& scene_;
  std::deque<std::pair<std::array<Vec3, 3>, Bounds>> found_;
};

/// What a direct dimension line of that kind measures on a scope: every way in which it can be drawn there.
std::vector<double> measuredBy(const Annotation& a, const Obb& box) {
  const int axis = axisOf(a.orient).axis;
  const double across[2] = {box.size[(axis + 1) % 3], box.size[(axis + 2) % 3]};
  switch (a.type) {
    case HandleType::kLinearContour:
    case HandleType::kLinearCenter: return {box.size[axis]};
    case HandleType::kDiametric: return {across[0], across[1]};
    case HandleType::kRadial: return {across[0] * 0.5, across[1] * 0.5};
    case HandleType::kSphericalDiametric: return {box.size.x, box.size.y, box.size.z};
    case HandleType::kSphericalRadial: return {box.size.x * 0.5, box.size.y * 0.5, box.size.z * 0.5};
    default: return {};
  }
}

TEST_CASE("every parameter of every model can be understood and dragged") {
  forEveryModel([](const Model& model) {
    CHECK(model.diagnostics.empty());
    for (std::size_t i = 0; i < model.parameters().size(); ++i) {
      const Parameter& p = model.parameters()[i];
      INFO(p.name);
      CHECK(!p.title.empty());
      CHECK(!p.group.empty());
      REQUIRE(!p.help.empty());
      CHECK(p.help.back() == '.');
      CHECK(p.step > 0);
      CHECK(p.min < p.max);
      CHECK(snapValue(p, p.defaultValue) == Approx(p.defaultValue));
      CHECK((p.type == ParameterType::kFloat ? p.unit == Unit::kMetre || p.unit == Unit::kSquareMetre
                                             : p.unit == (p.type == ParameterType::kAngle ? Unit::kDegree : Unit::kNone)));
      CHECK((p.type != ParameterType::kInt || !p.noun.empty()));
      CHECK(model.annotations[i].has_value());
    }
  });
}

TEST_CASE("every model is sound in every setting: closed parts, no flat triangles, finite places") {
  forEveryModel([](const Model& model) {
    inManySettings(model, [](const Values&, const Scene& scene) {
      CHECK(test::defectOf(scene) == "");
      REQUIRE(!scene.bounds.empty());
      for (const Instance& instance : scene.instances) {
        REQUIRE(instance.mesh < scene.meshes.size());
        const Mat4 place(instance.transform);
        CHECK(glm::determinant(Mat3(place)) > 0);
        CHECK(std::isfinite(place[3].x + place[3].y + place[3].z));
      }
      for (const Mesh& mesh : scene.meshes) CHECK(!mesh.triangles.empty());
    });
  });
}

TEST_CASE("scopes are boxes within the model, in every setting of every model") {
  forEveryModel([](const Model& model) {
    // An angle's scope is the frame that it opens in, and may reach into the open with it.
    const auto isFrame = [&](const Scope& s) {
      return std::any_of(model.annotations.begin(), model.annotations.end(),
                         [&](const auto& a) { return a && a->type == HandleType::kAngular && a->scope == s.name; });
    };
    inManySettings(model, [&](const Values&, const Scene& scene) {
      Reach reachOf(scene);
      for (const Scope& s : scene.scopes) {
        INFO(s.name << " " << s.index);
        if (!isFrame(s)) {
          const Bounds& reach = reachOf.along(s.box.axes);
          // The share is for scopes of what this setting leaves out, like a balcony.
          const double slackM = 0.03 * scene.bounds.diagonal();
          for (int k = 0; k < 3; ++k) {
            const double from = glm::dot(s.box.origin, s.box.axes[static_cast<std::size_t>(k)]);
            CHECK(from > reach.min[k] - slackM);
            CHECK(from + s.box.size[k] < reach.max[k] + slackM);
          }
        }
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(s.box.size[static_cast<int>(k)] >= 0);
          CHECK(glm::length(glm::cross(s.box.axes[k], s.box.axes[(k + 1) % 3]) - s.box.axes[(k + 2) % 3]) < 1e-9);
        }
      }
    });
  });
}

TEST_CASE("every annotation finds its scopes in some setting, and a direct one its value in their extent") {
  forEveryModel([](const Model& model) {
    std::vector<std::size_t> found(model.parameters().size(), 0);
    inManySettings(model, [&](const Values& values, const Scene& scene) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!model.annotations[i]) continue;
        const Annotation& a = *model.annotations[i];
        INFO(model.parameters()[i].name);
        for (const Scope& s : scene.scopes) {
          if (s.name != a.scope) continue;
          ++found[i];
          if (a.indirect) continue;
          for (const double length : measuredBy(a, s.box)) CHECK(length == Approx(values.at(i)).epsilon(0).margin(1e-6));
        }
      }
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO(model.parameters()[i].name);
      CHECK(found[i] > 0);
    }
  });
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST_CASE("the same values give the same bytes") {
  forEveryModel([](const Model& model) {
    test::Random random(11);
    for (int i = 0; i < 10; ++i) {
      const Values values = test::anySetting(model.parameters(), random);
      INFO(test::text(model.parameters(), values));
      const Scene one = model.definition.build(values), two = model.definition.build(values);
      REQUIRE(one.meshes.size() == two.meshes.size());
      for (std::size_t k = 0; k < one.meshes.size(); ++k) {
        const Mesh &a = one.meshes[k], &b = two.meshes[k];
        CHECK(sameBytes(a.positions, b.positions));
        CHECK(sameBytes(a.triangles, b.triangles));
        CHECK(sameBytes(a.materials, b.materials));
        CHECK(sameBytes(a.normals, b.normals));
        CHECK(sameBytes(a.uvs, b.uvs));
      }
      CHECK(sameBytes(one.instances, two.instances));
      REQUIRE(one.scopes.size() == two.scopes.size());
      for (std::size_t k = 0; k < one.scopes.size(); ++k) {
        CHECK(one.scopes[k].name == two.scopes[k].name);
        CHECK(std::memcmp(&one.scopes[k].box, &two.scopes[k].box, sizeof(Obb)) == 0);
      }
    }
  });
}

TEST_CASE("what a parameter changes shows: each one makes another scene in some setting") {
  forEveryModel([](const Model& model) {
    const auto positionsOf = [&](const Values& values) {
      const Scene scene = model.definition.build(values);
      std::vector<glm::vec3> all;
      for (const Instance& instance : scene.instances) {
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions) all.emplace_back(instance.transform * glm::vec4(p, 1.0F));
      }
      return all;
    };
    for (std::size_t i = 0; i < model.parameters().size(); ++i) {
      const Parameter& p = model.parameters()[i];
      INFO(p.name);
      bool changes = false;
      test::Random random(3);
      for (int k = 0; k < 20 && !changes; ++k) {
        Values low = k == 0 ? Values(model.parameters()) : test::anySetting(model.parameters(), random), high = low;
        low.set(i, p.min);
        high.set(i, p.max);
        changes = positionsOf(low) != positionsOf(high);
      }
      CHECK(changes);
    }
  });
}

}  // namespace
}  // namespace dimline
