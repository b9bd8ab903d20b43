#include "placement/foresight.h"

#include <algorithm>
#include <cmath>

#include "placement/labels.h"
#include "placement/on_screen.h"

namespace dimline {

namespace {

/// rad, and the logarithm of a ratio of sizes on screen. A view that moved by less since the last frame says nothing about where it is going.
constexpr double kLeastTurnRad = 1e-4;
constexpr double kLeastZoom = 1e-4;
/// Frames of the same movement. A slow one is followed less far; what it takes away is taken late as well.
constexpr int kMostFramesAhead = 200;

Mat3 axes(const View& view) { return {view.right(), view.up(), view.forward()}; }

/// By what the camera's distance, or the height that an orthographic one sees, was multiplied from one view to the next.
double zoomBetween(const Camera& before, const Camera& now) {
  if (now.orthoHeightM && before.orthoHeightM) return *now.orthoHeightM / *before.orthoHeightM;
  return glm::length(now.eye - now.target) / glm::length(before.eye - before.target);
}

/// The camera's movement from one view to the next, to be gone on with.
class Movement {
 public:
  Movement(const View& before, const View& now)
      : camera_(now.camera()), turn_(axes(now) * glm::transpose(axes(before))), shift_(now.camera().target - before.camera().target), turnRad_(turnBetween(before, now)),
        zoom_(zoomBetween(before.camera(), now.camera())) {}

  [[nodiscard]] bool turns() const { return turnRad_ >= kLeastTurnRad; }
  [[nodiscard]] bool zooms() const { return zooming() >= kLeastZoom; }   // false for a NaN too
  [[nodiscard]] bool nears() const { return zooms() && zoom_ < 1; }
  /// Until the view has turned by kForesightRad or its picture has grown, or shrunk, by kForesightZoom; one at least.
  [[nodiscard]] int framesAhead() const {
    int frames = kMostFramesAhead;
    if (turns()) frames = std::min(frames, static_cast<int>(kForesightRad / turnRad_));
    if (zooms()) frames = std::min(frames, static_cast<int>(kForesightZoom / zooming()));
    return std::max(frames, 1);
  }
  void goOn() {
    const Vec3 arm = turn_ * (camera_.eye - camera_.target);
    shift_ = turn_ * shift_;
    camera_.target += shift_;
    camera_.up = turn_ * camera_.up;
    if (zooms() && camera_.orthoHeightM) *camera_.orthoHeightM *= zoom_;
    camera_.eye = camera_.target + (zooms() && !camera_.orthoHeightM ? arm * zoom_ : arm);
  }
  /// When a look ahead of so many is due, in frames from now: in equal steps or, while the camera comes nearer or goes away, each twice as far ahead as the one before it.
  [[nodiscard]] int frameOf(int look, int looks) const {
    const int frames = framesAhead();
    const double share = zooms() ? std::exp2(look - looks) : static_cast<double>(look) / looks;
    return std::max(look, static_cast<int>(std::lround(frames * share)));
  }
  /// Whether what is there after so many frames has not been there for a moment only.
  [[nodiscard]] bool outlastsMoment(int frames) const { return zooms() && frames * zooming() > kBriefZoom; }
  [[nodiscard]] const Camera& camera() const { return camera_; }

 private:
  [[nodiscard]] double zooming() const { return std::abs(std::log(zoom_)); }

  Camera camera_;
  Mat3 turn_;
  Vec3 shift_;
  double turnRad_;
  double zoom_;
};

}  // namespace

void Foresight::begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM) {
  objectPlanes_ = objectPlanes;
  toleranceM_ = toleranceM;
  if (!before) lookCount_ = briefCount_ = 0;
  now_ = now;
  if (!before || samePicture(*before, now)) return;
  Movement movement(*before, now);
  const int looks = !movement.zooms() && !movement.turns() ? 0 : std::min(movement.zooms() ? kLooksAheadZooming : kLooksAheadTurning, movement.framesAhead());
  lookCount_ = static_cast<std::size_t>(looks);
  briefCount_ = 0;
  zooms_ = movement.zooms();
  nears_ = movement.nears();
  lossPrice_ = kScoreSoonGone * (movement.zooms() ? kSoonGoneZooming : 1.0);
  if (looks_.size() < lookCount_) looks_.resize(lookCount_);
  int frame = 0;
  for (int i = 1; i <= looks; ++i) {
    for (const int until = movement.frameOf(i, looks); frame < until; ++frame) movement.goOn();
    Look& look = looks_[static_cast<std::size_t>(i - 1)];
    look.view = View(movement.camera(), now.widthPx(), now.heightPx(), bounds);
    facePlanes(objectPlanes, look.view, look.objectUses);
    if (!movement.outlastsMoment(frame)) briefCount_ = static_cast<std::size_t>(i);
  }
}

/// The first look ahead at which something is lost; as many as there are when at none.
template <typename Lost>
std::size_t Foresight::firstLook(Lost lost) const {
  std::size_t look = 0;
  while (look < lookCount_ && !lost(looks_[look])) ++look;
  return look;
}

/// The first look at which nothing of a base line is left in the picture, or it is shorter there than `leastPx`.
std::size_t Foresight::firstLookWithout(const Segment& base, double leastPx) const {
  return firstLook([&](const Look& look) {
    if (!look.view.inFrontOfNear(base)) return true;
    const Segment2 screen = look.view.toScreen(base);
    return !meets(screen, look.view.viewport()) || screen.length() < leastPx;
  });
}

Foresight::Prospect Foresight::prospect(const Place& place) {
  if (lookCount_ == 0) return {.price = turnedAway(place.base, now_, kTurnedAwaySin) ? kScoreSoonGone * kTurnedAwayShare : 0.0};
  const std::size_t cramped = firstLook([&](const Look& look) { return !hasRoom(look, place); });
  const std::size_t gone = place.leastPx > 0 ? firstLookWithout(place.base.segment, place.leastPx) : lookCount_;
  const std::size_t lost = std::min(cramped, gone);
  const std::size_t turned = firstLook([&](const Look& look) { return turnedAway(place.base, look.view, kTurnedAwaySin); });
  const bool brief = std::min(cramped, turned) < briefCount_;
  return {.price = lossPrice_ * std::max(shareLeft(lost), kTurnedAwayShare * shareLeft(turned)),
          .brief = brief,
          .passing = !zooms() && lost == 0,
          .goneSoon = isLostAtOneOf(kLooksAtLastMomentsAnew, gone),
          .outInVain = zooms() ? isLostAtOneOf(kLooksAtLastMomentsComingOut, cramped) : brief,
          .lastMoments = isLostAtOneOf(kLooksAtLastMoments, cramped)};
}

/// Whether the plane has room for the line then, and the viewport for it and its label. handleSpacing is less in the world when the camera has come nearer, so the line will lie nearer to the model by that.
bool Foresight::hasRoom(const Look& look, const Place& place) {
  const Vec3 middle = place.line.middle();
  const double nearerM = std::clamp((now_.metresPerPixelAt(middle) - look.view.metresPerPixelAt(middle)) * kHandleSpacingPx, 0.0, place.offsetM);
  const Vec3 move = place.plane.across * (-place.direction * nearerM);
  const auto screen = onScreen(Segment{place.line.start + move, place.line.end + move}, look.view);
  if (!screen) return false;
  if (place.textSize.x > 0 && !labelFits(*screen, place.textSize, screen->middle() - look.view.toScreen(place.base.segment.middle()), look.view.viewport())) return false;
  slipPlanes(place.base, place.slip, look.view, {objectPlanes_, look.objectUses, toleranceM_}, planes_);
  const auto then = std::ranges::find(planes_, place.plane.number, &SlipPlane::number);
  if (then == planes_.end()) return false;
  const double offsetM = place.direction * (place.offsetM - nearerM);
  return then->lowM <= offsetM && offsetM <= then->highM;
}

Foresight::Prospect Foresight::prospectInside(const Segment& base, double leastPx) const {
  const std::size_t gone = firstLookWithout(base, leastPx);
  return {.price = lossPrice_ * shareLeft(gone),
          .goneSoon = isLostAtOneOf(kLooksAtLastMomentsAnew, gone),
          .lastMoments = isLostAtOneOf(kLooksAtLastMomentsInside, firstLookWithout(base, 0))};
}

}  // namespace dimline
