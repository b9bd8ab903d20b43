#pragma once

#include <optional>

#include "math/camera.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// A base line moved over a plane, parallel to itself in the world, as it is seen on screen (paper 4.1, figures 9 and
/// 10). The point start + u (end - start) + t across of the world, u in [0, 1] along the line and t in metres along
/// the unit vector `across`, appears at a pixel q by a homography. Its inverse is three linear forms in q = (x, y, 1):
///
///     u(q) = (uForm . q) / (wForm . q)
///     t(q) = (tForm . q) / (wForm . q)
///
/// where wForm . q > 0, which is in front of the viewer and before the plane's horizon.
class Slide {
public:
  /// Nothing when the plane is seen so nearly edge-on that the homography cannot be inverted, or when an end of the
  /// base line is not in front of the near plane. `across` is a unit vector not parallel to the line.
  static std::optional<Slide> make(const View& view, const Segment& base, const Vec3& across);

  [[nodiscard]] const Segment& base() const { return base_; }
  [[nodiscard]] const Vec3& across() const { return across_; }
  [[nodiscard]] const Vec3& uForm() const { return uForm_; }
  [[nodiscard]] const Vec3& tForm() const { return tForm_; }
  /// The forms are scaled so that wForm . q >= 1 on the base line: it is the depth of the base line's farther end
  /// over the depth at q.
  [[nodiscard]] const Vec3& wForm() const { return wForm_; }
  /// The other way round: (u, t) appears at the homogeneous pixel origin + u perU + t perT, whose last component is >
  /// 0 in front of the viewer.
  [[nodiscard]] const Vec3& originPixel() const { return originPixel_; }
  [[nodiscard]] const Vec3& pixelPerU() const { return pixelPerU_; }
  [[nodiscard]] const Vec3& pixelPerT() const { return pixelPerT_; }

  /// The homogeneous pixel at which the line's middle appears at offset t (m).
  [[nodiscard]] Vec3 middlePixel(double tM) const { return originPixel_ + pixelPerU_ * 0.5 + pixelPerT_ * tM; }

  /// The line at offset t (m), in the world.
  [[nodiscard]] Segment at(double tM) const { return {base_.start + across_ * tM, base_.end + across_ * tM}; }

private:
  Segment base_;
  Vec3 across_{0.0};
  Vec3 uForm_{0.0}, tForm_{0.0}, wForm_{0.0};
  Vec3 originPixel_{0.0}, pixelPerU_{0.0}, pixelPerT_{0.0};
};

/// The least offset t >= 0 (m) from which on the slid line lies between one viewport edge and that edge's field all
/// along: the greatest t(q) over what the field blocks inside the wedge between the two extension lines (0 when it
/// blocks nothing there). Infinite when the field gives no place: a strip of value <= 0 meets its viewport edge
/// inside the wedge, or the plane is blocked as far as its horizon. Bounds t on the boxes of the min/max tree and
/// descends only where more can be found. `uselessAboveM`: the caller has no use for offsets above this; where the
/// true one is greater, any value greater than this, infinity included, may be returned in its place. Allocates
/// nothing. The field's tree must be up to date.
double leastClearingOffset(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields,
                           const Slide& slide, double uselessAboveM = std::numeric_limits<double>::infinity());

/// The least over the four fields: from there on the line is outside (paper 4.1). Infinite when there is no place.
/// Above `uselessAboveM` any greater value may be returned, as above.
double leastClearingOffset(const DistanceFields& fields, const Slide& slide,
                           double uselessAboveM = std::numeric_limits<double>::infinity());

}  // namespace dimline
