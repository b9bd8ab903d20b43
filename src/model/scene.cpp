#include "model/scene.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string_view>
#include <unordered_map>

namespace dimline {

std::size_t Scene::triangleCount() const {
  std::size_t count = 0;
  for (const Instance& instance : instances) count += meshes[instance.mesh].triangles.size();
  return count;
}

namespace {

bool hasFiniteBox(const Scope& scope) {
  const Obb& box = scope.box;
  return isFinite(box.origin) && isFinite(box.size) && std::ranges::all_of(box.axes, [](const Vec3& axis) { return isFinite(axis); });
}

}  // namespace

void finish(Scene& scene) {
  // In float and only then widened: what is drawn and projected are these very floats.
  glm::vec3 min(std::numeric_limits<float>::infinity());
  glm::vec3 max(-std::numeric_limits<float>::infinity());
  for (const Instance& instance : scene.instances) {
    for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
      const glm::vec3 world(instance.transform * glm::vec4(position, 1.0F));
      min = glm::min(min, world);
      max = glm::max(max, world);
    }
  }
  scene.bounds = Bounds();
  if (min.x <= max.x) scene.bounds = Bounds{Vec3(min), Vec3(max)};

  std::erase_if(scene.scopes, std::not_fn(hasFiniteBox));
  std::unordered_map<std::string_view, std::uint32_t> counts;
  for (Scope& scope : scene.scopes) scope.index = counts[scope.name]++;
}

}  // namespace dimline
