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
/// The sanitizers look for what some settings show as well as many, at several times the cost.
constexpr std::size_t kSettings = 10;
#else
constexpr std::size_t kSettings = 2000;
#endif

/// How many random settings a model is tried in; DIMLINE_SETTINGS=50 in the environment asks for that many.
std::size_t randomSettings() {
  const char* asked = std::getenv("DIMLINE_SETTINGS");
  return asked ? static_cast<std::size_t>(std::atoi(asked)) : kSettings;
}

using Axes = std::array<Vec3, 3>;

/// Runs body(model) for every built-in model, with its name in failures.
template <typename Body>
void forEveryModel(Body&& body) {
  for (const BuiltInModel& built : builtInModels()) {
    INFO(built.name);
    body(findBuiltInModel(built.name).value());
  }
}

/// How far the model reaches along a scope's axes. Remembered by the axes, for the whole and for each mesh: scopes and instances are
/// many, and few of them are turned.
class Reach {
public:
  explicit Reach(const Scene& scene) : scene_(scene), ofMesh_(scene.meshes.size()) {}

  const Bounds& along(const Axes& axes) {
    if (const Bounds* known = find(whole_, axes)) return *known;
    Bounds bounds;
    for (const Instance& instance : scene_.instances) {
      const Mat4 place(instance.transform);
      const Axes local{axes[0] * Mat3(place), axes[1] * Mat3(place), axes[2] * Mat3(place)};
      const Bounds& reach = alongMesh(instance.mesh, local);
      const Vec3 at(glm::dot(axes[0], Vec3(place[3])), glm::dot(axes[1], Vec3(place[3])), glm::dot(axes[2], Vec3(place[3])));
      bounds.add(reach.min + at);
      bounds.add(reach.max + at);
    }
    return whole_.emplace_back(axes, bounds).second;
  }

private:
  using Known = std::deque<std::pair<Axes, Bounds>>;

  static const Bounds* find(const Known& known, const Axes& axes) {
    for (const auto& [of, bounds] : known) {
      if (of == axes) return &bounds;
    }
    return nullptr;
  }

  const Bounds& alongMesh(std::uint32_t mesh, const Axes& axes) {
    if (const Bounds* known = find(ofMesh_[mesh], axes)) return *known;
    Bounds bounds;
    for (const glm::vec3& p : scene_.meshes[mesh].positions)
      bounds.add({glm::dot(Vec3(p), axes[0]), glm::dot(Vec3(p), axes[1]), glm::dot(Vec3(p), axes[2])});
    return ofMesh_[mesh].emplace_back(axes, bounds).second;
  }

  const Scene& scene_;
  Known whole_;
  std::vector<Known> ofMesh_;
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

// The checks name the first thing that is wrong instead of asserting each: a model has thousands of things, in thousands of settings.

/// Closed parts, no flat triangles, finite places.
std::string soundnessDefect(const Scene& scene) {
  if (std::string defect = test::defectOf(scene); !defect.empty()) return defect;
  if (scene.bounds.empty()) return "there is nothing in the scene";
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.triangles.empty()) return "a mesh without triangles";
  }
  for (const Instance& instance : scene.instances) {
    if (instance.mesh >= scene.meshes.size()) return "an instance of a mesh that there is not";
    const Mat4 place(instance.transform);
    if (!(glm::determinant(Mat3(place)) > 0)) return "an instance that is turned inside out";
    if (!std::isfinite(place[3].x + place[3].y + place[3].z)) return "an instance at no place";
  }
  return {};
}

/// Scopes are boxes within the model.
std::string scopeDefect(const Model& model, const Scene& scene) {
  // An angle's scope is the frame that it opens in, and may reach into the open with it.
  const auto isFrame = [&](const Scope& s) {
    return std::any_of(model.annotations.begin(), model.annotations.end(),
                       [&](const auto& a) { return a && a->type == HandleType::kAngular && a->scope == s.name; });
  };
  // The share is for scopes of what this setting leaves out, like a balcony.
  const double slackM = 0.03 * scene.bounds.diagonal();
  Reach reachOf(scene);
  for (const Scope& s : scene.scopes) {
    const std::string which = "scope " + s.name + " " + std::to_string(s.index);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(s.box.size[static_cast<int>(k)] >= 0)) return which + " has a size below nothing";
      const Vec3 across = glm::cross(s.box.axes[k], s.box.axes[(k + 1) % 3]);
      if (!(glm::length(across - s.box.axes[(k + 2) % 3]) < 1e-9)) return which + " has axes that are not square to each other";
    }
    if (isFrame(s)) continue;
    const Bounds& reach = reachOf.along(s.box.axes);
    for (int k = 0; k < 3; ++k) {
      const double from = glm::dot(s.box.origin, s.box.axes[static_cast<std::size_t>(k)]);
      if (!(from > reach.min[k] - slackM && from + s.box.size[k] < reach.max[k] + slackM)) return which + " reaches out of the model";
    }
  }
  return {};
}

/// A direct line's value is its scope's extent. Counts the scopes that each parameter's annotation finds.
std::string annotationDefect(const Model& model, const Values& values, const Scene& scene, std::vector<std::size_t>& found) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!model.annotations[i]) continue;
    const Annotation& a = *model.annotations[i];
    for (const Scope& s : scene.scopes) {
      if (s.name != a.scope) continue;
      ++found[i];
      if (a.indirect) continue;
      for (const double length : measuredBy(a, s.box)) {
        if (!(std::abs(length - values.at(i)) < 1e-6))
          return model.parameters()[i].name + " is " + std::to_string(values.at(i)) + ", its scope's extent " + std::to_string(length);
      }
    }
  }
  return {};
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool sameBytes(const Mesh& a, const Mesh& b) {
  return sameBytes(a.positions, b.positions) && sameBytes(a.triangles, b.triangles) && sameBytes(a.materials, b.materials) &&
         sameBytes(a.normals, b.normals) && sameBytes(a.uvs, b.uvs);
}

/// But for the scopes.
bool sameShapes(const Scene& a, const Scene& b) {
  return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                    [](const Mesh& one, const Mesh& two) { return sameBytes(one, two); }) &&
         sameBytes(a.instances, b.instances);
}

bool sameBytes(const Scene& a, const Scene& b) {
  return sameShapes(a, b) &&
         std::equal(a.scopes.begin(), a.scopes.end(), b.scopes.begin(), b.scopes.end(), [](const Scope& one, const Scope& two) {
           return one.name == two.name && std::memcmp(&one.box, &two.box, sizeof(Obb)) == 0;
         });
}

TEST_CASE("in every setting each model is sound, its scopes enclose what they name, lines show values, and twice gives the same bytes") {
  forEveryModel([](const Model& model) {
    std::vector<std::size_t> found(model.parameters().size(), 0);
    for (const Values& values : test::manySettings(model.parameters(), randomSettings())) {
      INFO(test::text(model.parameters(), values));
      const Scene scene = model.definition.build(values);
      CHECK(soundnessDefect(scene) == "");
      CHECK(scopeDefect(model, scene) == "");
      CHECK(annotationDefect(model, values, scene, found) == "");
      CHECK(sameBytes(scene, model.definition.build(values)));
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO(model.parameters()[i].name);
      CHECK(found[i] > 0);
    }
  });
}

TEST_CASE("what a parameter changes shows: each one makes another scene in some setting") {
  forEveryModel([](const Model& model) {
    for (std::size_t i = 0; i < model.parameters().size(); ++i) {
      const Parameter& p = model.parameters()[i];
      INFO(p.name);
      bool changes = false;
      test::Random random(3);
      for (int k = 0; k < 20 && !changes; ++k) {
        Values low = k == 0 ? Values(model.parameters()) : test::anySetting(model.parameters(), random), high = low;
        low.set(i, p.min);
        high.set(i, p.max);
        changes = !sameShapes(model.definition.build(low), model.definition.build(high));
      }
      CHECK(changes);
    }
  });
}

}  // namespace
}  // namespace dimline
