#include "math/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace dimline {

namespace {

/// Share of the viewport that the model may fill, per axis, when it is fitted: the rest is for lines, labels and air.
constexpr double kFitShare = 0.62;

/// m, and rad. Between these, a double's rounding leaves a picture of anything that people build; a wider or a narrower view of it is of rounding alone.
constexpr double kMostCoordinateM = 1e12;
constexpr double kLeastHeightM = 1e-9;
constexpr double kLeastFovRad = 1.745e-9;

struct Frame {
  Vec3 right, up, forward;
};

/// The greatest of its coordinates, whatever their signs.
double reach(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// An up that points along the view says nothing; then the world axis that is most at right angles to the view stands in.
Frame frameOf(const Camera& camera) {
  const Vec3 forward = glm::normalize(camera.target - camera.eye);
  const Vec3 up = camera.up / reach(camera.up);   // of any length, the square of which may be none
  Vec3 side = glm::cross(forward, up);
  if (!(glm::length(side) > 1e-9 * glm::length(up))) {
    side = glm::cross(forward, std::abs(forward.y) > 0.9 ? Vec3(0, 0, -1) : Vec3(0, 1, 0));
  }
  const Vec3 right = glm::normalize(side);
  return {right, glm::cross(right, forward), forward};
}

}  // namespace

Status validate(const Camera& camera) {
  if (!isFinite(camera.eye) || !isFinite(camera.target) || !isFinite(camera.up)) {
    return Error{"The camera's eye, target and up must be finite numbers."};
  }
  if (std::max(reach(camera.eye), reach(camera.target)) > kMostCoordinateM) {
    return Error{"The camera's eye and target must lie within 1e12 metres of the origin."};
  }
  // Compared with the coordinates' own size: nearer than that, the view direction is rounding noise.
  const double scale = std::max(glm::length(camera.eye), glm::length(camera.target));
  if (!(glm::length(camera.target - camera.eye) > 1e-9 * scale) || camera.target == camera.eye) {
    return Error{"The camera's eye and target are the same point; move one of them."};
  }
  if (camera.up == Vec3(0.0)) return Error{"The camera's up vector is zero; use [0, 1, 0]."};
  if (camera.orthoHeightM) {
    if (!std::isfinite(*camera.orthoHeightM) || *camera.orthoHeightM <= 0) {
      return Error{"The camera's orthoHeight must be a positive number of metres."};
    }
    if (*camera.orthoHeightM < kLeastHeightM || *camera.orthoHeightM > kMostCoordinateM) {
      return Error{"The camera's orthoHeight must lie between 1e-9 and 1e12 metres."};
    }
  } else if (!(camera.fovRad > 0 && camera.fovRad < 3.14159)) {
    return Error{"The camera's field of view must lie between 0 and 180 degrees."};
  } else if (camera.fovRad < kLeastFovRad) {
    return Error{"The camera's field of view must be at least 1e-7 degrees."};
  }
  return okStatus();
}

View::View(const Camera& camera, double widthPx, double heightPx, const Bounds& bounds)
    : camera_(camera), widthPx_(widthPx), heightPx_(heightPx) {
  const Frame frame = frameOf(camera);
  right_ = frame.right;
  up_ = frame.up;
  forward_ = frame.forward;

  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  if (bounds.empty()) {
    nearest = farthest = glm::length(camera.target - camera.eye);
  } else {
    for (int i = 0; i < 8; ++i) {
      const double d = depth(bounds.corner(i));
      nearest = std::min(nearest, d);
      farthest = std::max(farthest, d);
    }
  }
  // Dimension lines stand around the model: a model's size of room before and behind it is theirs, and costs little depth precision.
  const double room = std::max({bounds.diagonal(), 1e-6 * std::abs(farthest), 1e-9});
  if (camera.orthographic()) {
    // An orthographic eye is only a direction: nothing is ever behind it.
    nearM_ = nearest - room;
    farM_ = farthest + room;
  } else {
    farM_ = std::max(farthest + room, 1e-6);
    nearM_ = std::max(nearest - room, farM_ * kNearShare);
    if (farM_ <= nearM_) farM_ = nearM_ * 2;
  }

  view_ = glm::lookAtRH(camera.eye, camera.eye + forward_, up_);
  const double aspect = widthPx / heightPx;
  pixelM_ = (camera.orthographic() ? *camera.orthoHeightM : 2 * std::tan(camera.fovRad * 0.5)) / heightPx;
  if (camera.orthographic()) {
    const double h = *camera.orthoHeightM * 0.5;
    projection_ = glm::orthoRH_NO(-h * aspect, h * aspect, -h, h, nearM_, farM_);
  } else {
    projection_ = glm::perspectiveRH_NO(camera.fovRad, aspect, nearM_, farM_);
  }
  viewProjection_ = projection_ * view_;
  // Rows of the 3x4 map: x, y and w of clip space, with the viewport's scale and flip folded in.
  for (int c = 0; c < 4; ++c) {
    const Vec4 column = viewProjection_[c];
    worldToPixels_[c] = Vec3((column.x + column.w) * 0.5 * widthPx, (column.w - column.y) * 0.5 * heightPx, column.w);
  }
}

double View::windowDepth(const Vec3& p) const {
  const Vec4 clip = viewProjection_ * Vec4(p, 1.0);
  return 0.5 + 0.5 * clip.z / clip.w;
}

double View::depthFromWindow(double windowDepth) const {
  // Of the projection's rows for z and w only two columns count.
  const double ndc = 2 * windowDepth - 1;
  return (projection_[3][2] - ndc * projection_[3][3]) / (projection_[2][2] - ndc * projection_[2][3]);
}

Vec3 View::directionTo(const Vec3& p) const {
  if (orthographic()) return forward_;
  const Vec3 d = p - camera_.eye;
  const double length = glm::length(d);
  return length > 0 ? d / length : forward_;
}

View::Ray View::rayThrough(const Vec2& screenPx) const {
  const double x = 2 * screenPx.x / widthPx_ - 1;
  const double y = 1 - 2 * screenPx.y / heightPx_;
  const double aspect = widthPx_ / heightPx_;
  if (orthographic()) {
    const double h = *camera_.orthoHeightM * 0.5;
    return {camera_.eye + right_ * (x * h * aspect) + up_ * (y * h), forward_};
  }
  const double h = std::tan(camera_.fovRad * 0.5);
  return {camera_.eye, glm::normalize(forward_ + right_ * (x * h * aspect) + up_ * (y * h))};
}

double View::metresPerPixelAt(const Vec3& p) const {
  return orthographic() ? pixelM_ : pixelM_ * std::max(depth(p), nearM_);
}

double View::mostPixelsPerMetre(const Vec3& center, double radiusM) const {
  if (orthographic()) return 1 / pixelM_;
  // What moves sideways by a metre moves on screen by 1/depth; what comes nearer by a metre, by that times how far aside it lies (as the tangent).
  const double nearest = depth(center) - radiusM;
  if (nearest <= nearM_) return std::numeric_limits<double>::infinity();
  const Vec3 eyeToCenter = center - camera_.eye;
  const double aside = glm::length(eyeToCenter - forward_ * depth(center)) + radiusM;
  return std::hypot(1.0, aside / nearest) / (pixelM_ * nearest);
}

bool samePicture(const View& a, const View& b) {
  return a.viewProjection() == b.viewProjection() && a.widthPx() == b.widthPx() && a.heightPx() == b.heightPx();
}

double turnBetween(const View& a, const View& b) { return std::acos(std::clamp(glm::dot(a.forward(), b.forward()), -1.0, 1.0)); }

Camera threeQuarterView(const Bounds& bounds, double widthPx, double heightPx) {
  Camera camera;
  camera.target = bounds.empty() ? Vec3(0.0) : bounds.center();
  const double azimuthRad = 0.62;    // from the front (+z) towards the right (+x)
  const double elevationRad = 0.17;  // low enough to look at a building rather than onto it
  camera.eye = camera.target + Vec3(std::sin(azimuthRad) * std::cos(elevationRad), std::sin(elevationRad),
                                    std::cos(azimuthRad) * std::cos(elevationRad));
  return fitToView(camera, bounds, widthPx, heightPx);
}

Camera fitToView(const Camera& camera, const Bounds& bounds, double widthPx, double heightPx) {
  Camera fitted = camera;
  if (bounds.empty()) return fitted;
  const Frame frame = frameOf(camera);
  const Vec3 center = bounds.center();
  const double aspect = widthPx / heightPx;
  // A model that is a point has no size of its own; then the eye must still be far enough from it for a direction that validate() trusts.
  const double radius = std::max({bounds.diagonal() * 0.5, 1e-5 * glm::length(center), 1e-6});

  if (camera.orthographic()) {
    double height = 0;
    for (int i = 0; i < 8; ++i) {
      const Vec3 d = bounds.corner(i) - center;
      height = std::max({height, 2 * std::abs(glm::dot(d, frame.up)), 2 * std::abs(glm::dot(d, frame.right)) / aspect});
    }
    fitted.orthoHeightM = std::max(height, 1e-6) / kFitShare;
    fitted.eye = center - frame.forward * (4 * radius);
  } else {
    // Each corner bounds the distance from below: |across| <= share * tan(half angle) * (distance + depth of corner).
    const double tanY = std::tan(camera.fovRad * 0.5) * kFitShare;
    const double tanX = tanY * aspect;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
      const Vec3 d = bounds.corner(i) - center;
      const double along = glm::dot(d, frame.forward);
      distance = std::max({distance, std::abs(glm::dot(d, frame.up)) / tanY - along,
                           std::abs(glm::dot(d, frame.right)) / tanX - along});
    }
    fitted.eye = center - frame.forward * std::max(distance, radius * 1e-3);
  }
  fitted.target = center;
  return fitted;
}

}  // namespace dimline
