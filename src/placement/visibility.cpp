#include "placement/visibility.h"

#include <algorithm>
#include <array>

#include "core/constants.h"

namespace dimline {

namespace {

/// Which sides of the view frustum a box's corners lie beyond: near, left, right, top, bottom, one bit each.
struct Beyond {
  unsigned all = 0x1F;   ///< those that all of them do
  unsigned any = 0;      ///< those that any does
};

Vec3 pixels(const View& view, const Vec3& v, double one) { return Vec3(view.worldToPixels() * Vec4(v, one)); }

/// Of a point, by its homogeneous pixels and its depth.
unsigned sidesBeyond(const View& view, const Vec3& h, double depth) {
  unsigned beyond = 0;
  if (!(depth >= view.nearM())) beyond |= 1U;
  if (h.x < 0) beyond |= 2U;
  if (h.x > view.widthPx() * h.z) beyond |= 4U;
  if (h.y < 0) beyond |= 8U;
  if (h.y > view.heightPx() * h.z) beyond |= 16U;
  return beyond;
}

Beyond sidesBeyond(const View& view, const Obb& box) {
  // Homogeneous pixels, and the depth, are linear in the world: what the box's sides add to its origin's gives all corners.
  std::array<Vec3, 3> side;
  std::array<double, 3> deeper;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 v = box.axes[static_cast<std::size_t>(axis)] * box.size[axis];
    side[static_cast<std::size_t>(axis)] = pixels(view, v, 0.0);
    deeper[static_cast<std::size_t>(axis)] = glm::dot(v, view.forward());
  }
  const Vec3 origin = pixels(view, box.origin, 1.0);
  const double originDepth = view.depth(box.origin);
  Beyond beyond;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 h = origin;
    double depth = originDepth;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1U) == 0) continue;
      h += side[axis];
      depth += deeper[axis];
    }
    const unsigned sides = sidesBeyond(view, h, depth);
    beyond.all &= sides;
    beyond.any |= sides;
  }
  return beyond;
}

}  // namespace

bool inView(const View& view, const Obb& box) {
  // Of most boxes the middle is in view, and then they are.
  const Vec3 middle = box.center();
  return sidesBeyond(view, pixels(view, middle, 1.0), view.depth(middle)) == 0 || sidesBeyond(view, box).all == 0;
}

bool wholeInView(const View& view, const Obb& box) { return sidesBeyond(view, box).any == 0; }

bool inPlainView(const View& view, const Obb& box, const Sight& sight, bool stays) {
  return sight.share() >= (stays ? kSeenShareToStayInPlainView : kSeenShareInPlainView) && wholeInView(view, box);
}

void Sight::age(int frames) {
  still_ = frames == 0;
  newFrames_ = frames;
  const int direction = frames_ > 0 ? 1 : -1;
  if (frames_ != 0) frames_ = std::clamp(frames_ + direction * frames, -kReturnFrames, kReturnFrames);
}

bool Sight::see(double share, SeenEdges edges) {
  edges_ = edges;
  const bool shown = frames_ > 0;
  if (still_ && share == share_) return shown;
  if (still_) age(kReturnFrames);
  share_ = share;
  const bool leftLately = frames_ < 0 && -frames_ < kReturnFrames;
  const bool enough = share >= (shown ? kSeenShareToKeep : leftLately ? kSeenShareToShowAgain : kSeenShareToShow);
  framesTooLittle_ = enough ? 0 : framesTooLittle_ + newFrames_;
  const bool stays = shown && (frames_ < kReturnFrames || framesTooLittle_ < kFramesToLoseSight);
  const bool seen = enough || stays;
  if (frames_ == 0 || seen != shown) frames_ = seen ? 1 : -1;
  return seen;
}

}  // namespace dimline
