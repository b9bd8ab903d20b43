#include "silhouette/gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dimline {

namespace {

/// Steps (px) in which gaps are looked for, and at how many on end there must be room. Fewer: lines come and go where a
/// gap opens. More: lines are on the model though there is room beside what they measure.
constexpr double kGapStepPx = 4.0;
constexpr int kLeastGapSteps = 3;
/// Halvings of a step in which a gap begins: to a small part of a pixel.
constexpr int kGapHalvings = 6;

/// The slid line on screen; nothing when an end of it is not in front of the viewer.
std::optional<Segment2> screenAt(const Slide& slide, double tM) {
  const Vec3 start = slide.originPixel() + slide.pixelPerT() * tM;
  const Vec3 end = start + slide.pixelPerU();
  if (!(start.z > 0) || !(end.z > 0)) return std::nullopt;
  return Segment2{Vec2(start) / start.z, Vec2(end) / end.z};
}

/// The way of the slid line's middle on screen, from an offset on: that point appears at a homogeneous pixel that is
/// linear in the offset, and so at a distance from where it began that is a fraction of two linear forms.
class WayOnScreen {
public:
  WayOnScreen(const Slide& slide, double fromM) : fromM_(fromM) {
    const Vec3 middle = slide.middlePixel(fromM);
    depth_ = middle.z;
    depthPerM_ = slide.pixelPerT().z;
    pixelsPerM_ = Vec2(slide.pixelPerT()) - Vec2(middle) / middle.z * depthPerM_;
  }
  [[nodiscard]] bool alongX() const { return std::abs(pixelsPerM_.x) > std::abs(pixelsPerM_.y); }
  /// The offset at which it has gone so many pixels; infinite when it never has.
  [[nodiscard]] double offsetAfter(double px) const {
    const double perM = glm::length(pixelsPerM_) - px * depthPerM_;
    return perM > 0 ? fromM_ + px * depth_ / perM : std::numeric_limits<double>::infinity();
  }

private:
  double fromM_, depth_, depthPerM_;
  Vec2 pixelsPerM_;
};

}  // namespace

std::optional<Gap> nearestGap(const DistanceFields& fields, const Slide& slide, double lowM, double mostM) {
  if (!(lowM <= mostM) || !std::isfinite(mostM) || !screenAt(slide, lowM)) return std::nullopt;
  const WayOnScreen way(slide, lowM);
  const std::array<ViewportEdge, 2> edges{way.alongX() ? ViewportEdge::kTop : ViewportEdge::kLeft,
                                          way.alongX() ? ViewportEdge::kBottom : ViewportEdge::kRight};
  const Box2 viewport{Vec2(0.0), Vec2(fields.widthPx, fields.heightPx)};
  const auto isClear = [&](double tM) {
    const auto line = screenAt(slide, tM);
    if (!line || !viewport.contains(line->middle())) return false;
    // Of most lines the middle tells at once.
    return std::ranges::any_of(edges, [&](ViewportEdge edge) {
      return !isBlocked(fields, edge, line->middle()) && clears(fields, edge, *line);
    });
  };
  // The steps do not depend on how far they lead, so that a gap begins at the same offset for whoever may go further.
  int clearSteps = 0;
  Gap gap{};
  double beforeM = lowM;
  double tM = lowM;
  const double mostPx = 2.0 * (fields.widthPx + fields.heightPx);
  for (double px = 0; tM <= mostM && px <= mostPx; px += kGapStepPx, tM = way.offsetAfter(px)) {
    if (isClear(tM)) {
      gap.toM = tM;
      if (++clearSteps == 1) {
        gap.fromM = tM;
        for (int i = 0; i < kGapHalvings; ++i) {
          const double middleM = 0.5 * (beforeM + gap.fromM);
          (isClear(middleM) ? gap.fromM : beforeM) = middleM;
        }
      }
    } else {
      if (clearSteps >= kLeastGapSteps) break;
      clearSteps = 0;
    }
    beforeM = tM;
  }
  return clearSteps >= kLeastGapSteps ? std::optional(gap) : std::nullopt;
}

}  // namespace dimline
