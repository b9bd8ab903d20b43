#include "silhouette/mesh_projection.h"

#include <cmath>

#include "silhouette/float4.h"

namespace dimline {

namespace {

/// px. Boxes are projected in floats; at 4K that is some 1e-3 px off.
constexpr float kMarginPx = 0.01F;

float least(Float4 a, Float4 b) {
  const Float4 v = min4(a, b);
  return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
}

float greatest(Float4 a, Float4 b) {
  const Float4 v = max4(a, b);
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}

}  // namespace

MeshProjection::MeshProjection(const View& view, const Mat4& toWorld, double widthPx, double heightPx)
    : toPixels_(view.worldToPixels() * toWorld), widthPx_(widthPx), heightPx_(heightPx) {
  const Vec3& forward = view.forward();
  const Vec4 nearPlane(forward, -glm::dot(forward, view.camera().eye) - view.nearM());
  beforeNear_ = nearPlane * toWorld;
}

glm::vec4 MeshProjection::viewer() const {
  // The one point that a 3x4 projection sends to (0, 0, 0), by cofactors: also right for parallel projection and for
  // flattened meshes.
  const auto& m = toPixels_;
  const auto minor = [&](int a, int b, int c) { return glm::dot(m[a], glm::cross(m[b], m[c])); };
  const Vec4 center(minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2));
  const double size = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z), std::abs(center.w)});
  return size > 0 ? glm::vec4(center / size) : glm::vec4(0.0F);
}

ProjectedVertex MeshProjection::project(const Vec3& p) const {
  ProjectedVertex v{toPixels_ * Vec4(p, 1.0), glm::dot(beforeNear_, Vec4(p, 1.0)), 0};
  // Each side is a plane through the viewer, so these tests hold behind the viewer as well.
  if (v.pixel.x < 0) v.beyond |= kBeyondLeft;
  if (v.pixel.x > widthPx_ * v.pixel.z) v.beyond |= kBeyondRight;
  if (v.pixel.y < 0) v.beyond |= kBeyondTop;
  if (v.pixel.y > heightPx_ * v.pixel.z) v.beyond |= kBeyondBottom;
  if (v.beforeNear < 0) v.beyond |= kBeyondNear;
  return v;
}

BoxOnScreen MeshProjection::look(const EdgeMesh::Part& part) const {
  const Vec3& half = part.halfSize;
  const double reach =
      std::abs(beforeNear_.x) * half.x + std::abs(beforeNear_.y) * half.y + std::abs(beforeNear_.z) * half.z;
  const double middle = glm::dot(beforeNear_, Vec4(part.center, 1.0));
  if (!(middle - reach >= 0)) return lookAcrossNear(part);

  // The box's corners in two lots of four: left and right, bottom and top in each, then back and front.
  const glm::vec3 center(toPixels_ * Vec4(part.center, 1.0));
  const glm::vec3 alongX(toPixels_[0] * half.x);
  const glm::vec3 alongY(toPixels_[1] * half.y);
  const glm::vec3 alongZ(toPixels_[2] * half.z);
  constexpr Float4 kSignX{-1, 1, -1, 1};
  constexpr Float4 kSignY{-1, -1, 1, 1};
  const auto ring = [&](int i) { return center[i] + kSignX * alongX[i] + kSignY * alongY[i]; };
  const Float4 x = ring(0);
  const Float4 y = ring(1);
  const Float4 w = ring(2);
  const Float4 backScale = 1.0F / (w - alongZ.z);
  const Float4 frontScale = 1.0F / (w + alongZ.z);
  const Float4 backX = (x - alongZ.x) * backScale;
  const Float4 frontX = (x + alongZ.x) * frontScale;
  const Float4 backY = (y - alongZ.y) * backScale;
  const Float4 frontY = (y + alongZ.y) * frontScale;

  BoxOnScreen box;
  box.left = least(backX, frontX) - kMarginPx;
  box.right = greatest(backX, frontX) + kMarginPx;
  box.top = least(backY, frontY) - kMarginPx;
  box.bottom = greatest(backY, frontY) + kMarginPx;
  const auto width = static_cast<float>(widthPx_);
  const auto height = static_cast<float>(heightPx_);
  box.allBeyond = static_cast<std::uint8_t>((box.right < 0 ? kBeyondLeft : 0) | (box.left > width ? kBeyondRight : 0) |
                                            (box.bottom < 0 ? kBeyondTop : 0) | (box.top > height ? kBeyondBottom : 0));
  // Written so that a coordinate that is no number counts as beyond.
  box.anyBeyond =
      static_cast<std::uint8_t>((box.left >= 0 ? 0 : kBeyondLeft) | (box.right <= width ? 0 : kBeyondRight) |
                                (box.top >= 0 ? 0 : kBeyondTop) | (box.bottom <= height ? 0 : kBeyondBottom));
  return box;
}

BoxOnScreen MeshProjection::lookAcrossNear(const EdgeMesh::Part& part) const {
  BoxOnScreen box;
  box.allBeyond = 0xFF;
  for (int i = 0; i < 8; ++i) {
    const Vec3 sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    const std::uint8_t corner = project(part.center + part.halfSize * sign).beyond;
    box.allBeyond &= corner;
    box.anyBeyond |= corner;
  }
  // The caller relies on this bit wherever there is no box on screen.
  box.anyBeyond |= kBeyondNear;
  return box;
}

}  // namespace dimline
