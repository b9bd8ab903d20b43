#include "placement/visibility.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace dimline {

bool inView(const View& view, const Obb& box) {
  unsigned beyondAll = 0x1F;   // one bit a side: near, left, right, top, bottom
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = box.corner(i);
    const Vec3 h = view.worldToPixels() * Vec4(corner, 1.0);
    unsigned beyond = 0;
    if (!view.inFrontOfNear(corner)) beyond |= 1U;
    if (h.x < 0) beyond |= 2U;
    if (h.x > view.widthPx() * h.z) beyond |= 4U;
    if (h.y < 0) beyond |= 8U;
    if (h.y > view.heightPx() * h.z) beyond |= 16U;
    beyondAll &= beyond;
  }
  return beyondAll == 0;
}

void Sight::age(int frames) {
  still_ = frames == 0;
  recent_ *= std::pow(kSightFading, frames);
  const int direction = frames_ > 0 ? 1 : -1;
  if (frames_ != 0) frames_ = std::clamp(frames_ + direction * frames, -kReturnFrames, kReturnFrames);
}

double Sight::leastShare() const {
  if (frames_ > 0) return frames_ < kReturnFrames ? 0.0 : kSeenShareToKeep;
  return frames_ < 0 && -frames_ < kReturnFrames ? kSeenShareToShowAgain : kSeenShareToShow;
}

bool Sight::see(double share) {
  if (still_ && share == share_) return frames_ > 0;
  if (still_) age(kReturnFrames);
  share_ = share;
  recent_ = std::max(share, recent_);
  const bool seen = (frames_ > 0 ? recent_ : share) >= leastShare();
  if (frames_ == 0 || seen != (frames_ > 0)) frames_ = seen ? 1 : -1;
  return seen;
}

}  // namespace dimline
