#include "placement/history.h"

#include <algorithm>

namespace dimline {

namespace {

/// px. What rounding alone may move.
constexpr double kStillPx = 0.01;

static_assert(kSingleStaysZooming >= kReturnFrames, "framesHeld() counts no further");
static_assert(kPatienceSmallViewportFrames >= kPatienceFrames, "what is better is counted no further");

}  // namespace

bool History::stays(const Identity& candidate, const Segment2& awayPx) const {
  const double mostPx = aged_ ? kLeapPx : kStillPx;
  const auto leaps = [&](const Vec2& was, const Vec2& is) { return glm::length(is - was) > mostPx; };
  return candidate == last_ && !(awayPx_ && (leaps(awayPx_->start, awayPx.start) || leaps(awayPx_->end, awayPx.end)));
}

double History::bonus(const Identity& candidate, const Segment2& awayPx) const {
  if (candidate == last_) return stays(candidate, awayPx) ? kScoreStay : 0.0;
  return leftLately(candidate) ? kScoreReturn : 0.0;
}

bool History::leftLately(const Identity& candidate) const {
  return std::ranges::any_of(left_, [&](const Left& left) { return left.framesAgo < kReturnFrames && left.identity == candidate; });
}

double History::relaxedOffsetM(double leastM, double stepM) const {
  if (stepM == 0) return std::max(offsetM_, leastM);
  const double comingNearerM = offsetM_ - stepM;
  return std::max({leastM, std::min(comingNearerM, leastM * kMostOffsetRatio), offsetM_ - kHurryFactor * stepM});
}

void History::age() {
  aged_ = true;
  dwellFrames_ = std::min(dwellFrames_ + 1, kDwellFrames);
  framesHeld_ = std::min(framesHeld_ + 1, kSingleStaysZooming);
  betterFrames_ = betterThere_ ? std::min(betterFrames_ + 1, kPatienceSmallViewportFrames) : 0;
  betterThere_ = false;
  for (Left& left : left_) left.framesAgo = std::min(left.framesAgo + 1, kReturnFrames);
}

void History::choose(const Identity& choice, double offsetM, const Segment2& awayPx) {
  wasHidden_ = shownAnew();
  awayPx_ = awayPx;
  aged_ = false;
  if (!any()) dwellFrames_ = 0;
  hidden_ = false;
  forWantOfRoom_ = false;
  offsetM_ = offsetM;
  if (choice == last_) return;
  framesHeld_ = 0;
  // What is gone back to is no longer left.
  for (Left& left : left_) {
    if (left.identity == choice) left = {};
  }
  if (any()) *std::ranges::max_element(left_, {}, &Left::framesAgo) = {last_, 0};
  last_ = choice;
}

void History::forgetOffset() {
  offsetM_ = -1;
  awayPx_.reset();
}

void History::choseNone(bool forWantOfRoom) {
  forWantOfRoom_ = forWantOfRoom;
  awayPx_.reset();
  if (!hidden_) dwellFrames_ = any() ? 0 : kDwellFrames;
  hidden_ = true;
  last_ = {.parameter = last_.parameter};
  offsetM_ = -1;
  left_.fill({});
}

}  // namespace dimline
