#pragma once

#include <optional>

#include "math/camera.h"
#include "model/scene.h"

namespace dimline {

/// The nearest point in which a ray meets a scene's surface, at least `atLeastM` along it; nothing when it meets none.
/// Looks at every triangle whose mesh's sphere the ray meets: for single questions (what lies under the pointer), not
/// for many.
std::optional<Vec3> castRay(const Scene& scene, const View::Ray& ray, double atLeastM);

}  // namespace dimline
