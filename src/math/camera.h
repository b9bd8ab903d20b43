#pragma once

#include <optional>

#include "core/constants.h"
#include "core/result.h"
#include "math/geometry.h"

namespace dimline {

/// Where the viewer stands, as one entry of CAMS.json says it. Perspective unless `orthoHeightM` is set.
struct Camera {
  Vec3 eye{10, 8, 14};
  Vec3 target{0.0};
  Vec3 up{0, 1, 0};                    ///< need not be at right angles to the view, nor of unit length
  double fovRad = kDefaultFovRad;      ///< vertical field of view, (0, pi)
  std::optional<double> orthoHeightM;  ///< world height of the viewport when orthographic, > 0

  [[nodiscard]] bool orthographic() const { return orthoHeightM.has_value(); }
  bool operator==(const Camera&) const = default;
};

/// A readable error when a camera cannot be used: not finite, eye at the target, no height or angle, or so far away or seeing so little (1e12 m, 1e-9 m, 1e-7 degrees) that rounding
/// leaves nothing. An `up` along the view is not an error.
Status validate(const Camera& camera);

/// A camera bound to a viewport and to the depth range of one frame: everything that projects.
/// Clip space is OpenGL's (x right, y up, z from -1 near to 1 far); screen space is CSS pixels, y down.
class View {
 public:
  View() = default;
  /// `bounds`: what must lie between the near and the far plane where possible, with as much room again before and behind it; the near plane is
  /// never behind the eye, so parts of the model can be cut away or lie behind the viewer. `widthPx`, `heightPx` >= 1.
  View(const Camera& camera, double widthPx, double heightPx, const Bounds& bounds);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Mat4& viewMatrix() const { return view_; }
  [[nodiscard]] const Mat4& projectionMatrix() const { return projection_; }
  [[nodiscard]] const Mat4& viewProjection() const { return viewProjection_; }
  /// World to homogeneous pixels: (x, y, w) with screen = (x/w, y/w); w > 0 in front of the viewer. Row-vector free:
  /// multiply the column (p, 1). The z row is dropped, so three columns and a translation: a 3x4 map as glm::dmat4x3.
  [[nodiscard]] const glm::dmat4x3& worldToPixels() const { return worldToPixels_; }
  [[nodiscard]] double widthPx() const { return widthPx_; }
  [[nodiscard]] double heightPx() const { return heightPx_; }
  [[nodiscard]] Box2 viewport() const { return {Vec2(0.0), Vec2(widthPx_, heightPx_)}; }
  [[nodiscard]] double nearM() const { return nearM_; }
  [[nodiscard]] double farM() const { return farM_; }
  [[nodiscard]] bool orthographic() const { return camera_.orthographic(); }

  /// Orthonormal frame of the camera in the world; `forward` points from the eye into the picture.
  [[nodiscard]] const Vec3& right() const { return right_; }
  [[nodiscard]] const Vec3& up() const { return up_; }
  [[nodiscard]] const Vec3& forward() const { return forward_; }

  /// Depth of a point along `forward` from the eye (m).
  [[nodiscard]] double depth(const Vec3& p) const { return glm::dot(p - camera_.eye, forward_); }
  /// The same as a depth buffer holds it, 0 at the near plane to 1 at the far one: along a straight line on screen it grows evenly. Only meaningful in front of the eye.
  [[nodiscard]] double windowDepth(const Vec3& p) const;
  /// The depth (m) that has that window depth.
  [[nodiscard]] double depthFromWindow(double windowDepth) const;
  [[nodiscard]] bool inFrontOfNear(const Vec3& p) const { return depth(p) >= nearM_; }
  /// All of it.
  [[nodiscard]] bool inFrontOfNear(const Segment& s) const { return inFrontOfNear(s.start) && inFrontOfNear(s.end); }
  /// Unit direction from the viewer to a point (constant when orthographic).
  [[nodiscard]] Vec3 directionTo(const Vec3& p) const;

  /// Pixel position of a point. Only meaningful when the point lies in front of the eye.
  [[nodiscard]] Vec2 toScreen(const Vec3& p) const {
    const Vec3 h = worldToPixels_ * Vec4(p, 1.0);
    return Vec2(h.x, h.y) / h.z;
  }
  [[nodiscard]] Segment2 toScreen(const Segment& s) const { return {toScreen(s.start), toScreen(s.end)}; }

  /// The ray through a pixel: a point on it and its unit direction into the picture.
  struct Ray {
    Vec3 origin;
    Vec3 direction;
  };
  [[nodiscard]] Ray rayThrough(const Vec2& screenPx) const;

  /// World length of one pixel at a point's depth (m).
  [[nodiscard]] double metresPerPixelAt(const Vec3& p) const;
  /// No metre within a ball around a point looks longer than so many pixels, however it lies and wherever it is; infinite where the ball comes near the eye.
  [[nodiscard]] double mostPixelsPerMetre(const Vec3& center, double radiusM) const;

 private:
  Camera camera_;
  double widthPx_ = 1, heightPx_ = 1, nearM_ = 0.01, farM_ = 1;
  double pixelM_ = 1;   ///< world length of a pixel: anywhere when orthographic, else at a depth of 1 m
  Vec3 right_{1, 0, 0}, up_{0, 1, 0}, forward_{0, 0, -1};
  Mat4 view_{1.0}, projection_{1.0}, viewProjection_{1.0};
  glm::dmat4x3 worldToPixels_{1.0};
};

/// Whether both show the same part of the world in viewports of the same size. The matrices alone know of the viewport's shape only.
bool samePicture(const View& a, const View& b);

/// The angle (rad) between two views' directions.
double turnBetween(const View& a, const View& b);

/// The three-quarter view in which the page opens: from the front right, a little above, with the box of `bounds` filling
/// about 60 % of the viewport so that dimension lines have room.
Camera threeQuarterView(const Bounds& bounds, double widthPx, double heightPx);

/// The camera moved along its own view direction (and its target to the middle of `bounds`) until the box fills the
/// viewport as `threeQuarterView` has it. Keeps direction and field of view; scales an orthographic height.
Camera fitToView(const Camera& camera, const Bounds& bounds, double widthPx, double heightPx);

}  // namespace dimline
