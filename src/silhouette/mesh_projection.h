#pragma once

#include <cstdint>

#include "math/camera.h"
#include "silhouette/edge_mesh.h"

namespace dimline {

/// The sides of what is shown that a point can lie beyond, as bits.
enum Beyond : std::uint8_t { kBeyondLeft = 1, kBeyondRight = 2, kBeyondTop = 4, kBeyondBottom = 8, kBeyondNear = 16 };

/// A vertex before the cut at the near plane.
struct ProjectedVertex {
  Vec3 pixel;               ///< homogeneous
  double beforeNear;        ///< m, how far it lies beyond the near plane, seen from the viewer
  std::uint8_t beyond = 0;  ///< Beyond
};

/// Where a part's box is seen, to within a hundredth of a pixel on the safe side.
struct BoxOnScreen {
  std::uint8_t allBeyond = 0;  ///< sides that all of it lies beyond: it is not seen
  std::uint8_t anyBeyond = 0;  ///< sides that some of it may lie beyond
  float left = 0, right = 0;   ///< px, around the box; valid unless anyBeyond has kBeyondNear
  float top = 0, bottom = 0;
};

/// From the frame of a mesh's instance (relative to the mesh's centre) to the screen.
class MeshProjection {
public:
  MeshProjection() = default;
  /// `toWorld`: from the mesh's frame relative to its centre. `widthPx`, `heightPx`: the viewport, perhaps rounded up.
  MeshProjection(const View& view, const Mat4& toWorld, double widthPx, double heightPx);

  /// The viewer in the mesh's frame, homogeneous, scaled so that its greatest component is 1. Its sign is arbitrary;
  /// zero when the instance is flattened so that there is no telling.
  [[nodiscard]] glm::vec4 viewer() const;

  [[nodiscard]] Vec2 toScreen(const glm::vec3& p) const {
    const Vec3 h = toPixels_[0] * static_cast<double>(p.x) + toPixels_[1] * static_cast<double>(p.y) +
                   toPixels_[2] * static_cast<double>(p.z) + toPixels_[3];
    return Vec2(h.x, h.y) * (1 / h.z);
  }
  [[nodiscard]] ProjectedVertex project(const Vec3& p) const;
  [[nodiscard]] BoxOnScreen look(const EdgeMesh::Part& part) const;

private:
  [[nodiscard]] BoxOnScreen lookAcrossNear(const EdgeMesh::Part& part) const;

  glm::dmat4x3 toPixels_{1.0};
  Vec4 beforeNear_{0.0};
  double widthPx_ = 1;
  double heightPx_ = 1;
};

}  // namespace dimline
