#include "render/light_view.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace dimline {

namespace {

constexpr double kBorderTexels = 3.0;

}  // namespace

LightView fitLightView(const Bounds& bounds, const Vec3& towardsLight, int texels) {
  const Vec3 center = bounds.center();
  const Vec3 up = std::abs(towardsLight.y) > 0.99 ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
  const Mat4 view = glm::lookAtRH(center + towardsLight, center, up);
  Bounds seen;
  for (int i = 0; i < 8; ++i) seen.add(Vec3(view * Vec4(bounds.corner(i), 1.0)));
  const Vec3 margin = seen.size() * (kBorderTexels / (texels - 2 * kBorderTexels)) + 1e-6 * bounds.diagonal() + 1e-9;
  const Vec3 low = seen.min - margin;
  const Vec3 high = seen.max + margin;
  LightView result;
  result.worldToClip = glm::orthoRH_NO(low.x, high.x, low.y, high.y, -high.z, -low.z) * view;
  result.worldToUnit = glm::translate(Mat4(1.0), Vec3(0.5)) * glm::scale(Mat4(1.0), Vec3(0.5)) * result.worldToClip;
  result.unitsPerM = {1.0 / (high.x - low.x), 1.0 / (high.y - low.y)};
  result.texelM = std::max(high.x - low.x, high.y - low.y) / texels;
  result.depthRangeM = high.z - low.z;
  return result;
}

}  // namespace dimline
