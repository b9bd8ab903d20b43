#include "placement/history.h"

#include <algorithm>

namespace dimline {

double History::bonus(const Identity& candidate) const {
  if (candidate == last_) return kScoreStay;
  const auto lately = [&](const Left& left) { return left.framesAgo < kReturnFrames && left.identity == candidate; };
  return std::ranges::any_of(left_, lately) ? kScoreReturn : 0.0;
}

double History::relaxedOffsetM(double leastM, double stepM) const {
  return std::clamp(offsetM_ - stepM, leastM, leastM * kMostOffsetRatio);
}

void History::age() {
  for (Left& left : left_) left.framesAgo = std::min(left.framesAgo + 1, kReturnFrames);
}

void History::choose(const Identity& choice, double offsetM) {
  offsetM_ = offsetM;
  if (choice == last_) return;
  const Identity none{.parameter = last_.parameter};
  if (last_ != none) *std::ranges::max_element(left_, {}, &Left::framesAgo) = {last_, 0};
  last_ = choice;
}

void History::choseNone() {
  last_ = {.parameter = last_.parameter};
  offsetM_ = -1;
  left_.fill({});
}

}  // namespace dimline
