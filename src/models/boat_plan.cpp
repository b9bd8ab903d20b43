#include "models/boat_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/power.h"

namespace dimline::boat {

namespace {

constexpr double kMidship = 0.54;   // where along u the hull is broadest
constexpr double kForefoot = 0.84;  // where the keel ends and the stem begins, as a share of the length

double mix(double a, double b, double t) { return a + (b - a) * t; }

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Sails from the deck up: where yards and feet are, as shares of the mast's height.
std::vector<SquareSail> squareSails(const Mast& mast, double width, double topsail, double belly) {
  std::vector<SquareSail> sails(3);
  const double y = mast.deckY, h = mast.height;
  const double courseHead = mix(width, topsail, 0.3);
  sails[0] = {y + 0.40 * h, y + 0.08 * h + 1.6, courseHead, width, belly, 0.05 * h * 0.4};
  sails[1] = {y + 0.70 * h, y + 0.435 * h, topsail, courseHead * 0.96, belly * 0.85, 0.015 * h + 0.95};
  sails[2] = {y + 0.895 * h,  y + 0.725 * h, topsail * mix(topsail / width, 1, 0.4),
              topsail * 0.95, belly * 0.55,  0.02 * h + 0.25};
  return sails;
}

Mast lateenMast(const Plan& plan, double x, double height, double yard, int shrouds) {
  Mast mast;
  mast.x = x;
  mast.height = height;
  mast.lateenYard = yard;
  mast.shrouds = shrouds;
  mast.radius = 0.007 * height + 0.11;
  mast.deckY = plan.hull.sideAt(x, plan.deckH(x)).y;
  mast.channelH = plan.deckH(x) + 0.35;
  return mast;
}

Mast squareMast(const Plan& plan, double x, double height, int shrouds) {
  Mast mast = lateenMast(plan, x, height, 0, shrouds);
  mast.radius = 0.0085 * height + 0.1;
  mast.channelH = plan.hull.depth + 0.55;
  return mast;
}

/// How much of the sheer there is at a height: all of it at the main deck.
double sheerAt(const HullForm& hull, double h) {
  return hull.sheer * power(std::clamp(h / hull.depth, 0.0, 1.0), 1.2);
}

/// How far the hull's lines have risen at u, from amidships to both ends.
double riseOf(double sheer, double u) {
  const double out = (u - 0.5) / 0.5;
  return sheer * out * out * (out > 0 ? 0.8 : 1.0);
}

double riseAtStern(const HullForm& hull, double h) { return riseOf(sheerAt(hull, h), 0); }

}  // namespace

double HullForm::midship(double h) const {
  const double half = beam * 0.5, w = wale();
  if (h < w) return half * power(1 - power(1 - std::max(h, 0.0) / w, 2.5), 1 / 2.5);
  // Tumblehome: the sides lean inwards above the wale, most of it in the middle of their height.
  return half * (1 - 0.42 * (1 - power(std::numbers::e, -power((h - w) / (0.95 * depth), 1.6))));
}

double HullForm::sternX(double h) const { return kSternRake * (depth + riseAtStern(*this, depth) - h - riseAtStern(*this, h)); }

double HullForm::stemX(double h) const {
  const double t = 1 - std::clamp(h / depth, 0.0, 1.0);
  return length * mix(kForefoot, 1, std::sqrt(std::max(1 - t * t, 0.0)));
}

Vec3 HullForm::side(double u, double h) const { return HullLine(*this, h).side(u); }

double HullForm::uAt(double x, double h) const { return HullLine(*this, h).uAt(x); }

Vec3 HullForm::sideAt(double x, double h) const { return HullLine(*this, h).sideAt(x); }

HullLine::HullLine(const HullForm& hull, double h)
    : h_(h),
      sheerThere_(sheerAt(hull, h)),
      sternX_(hull.sternX(h)),
      stemX_(hull.stemX(h)),
      broadest_(hull.midship(h)),
      transom_(broadest_ * 0.7 * std::sqrt(smoothStep(hull.tuck(), 0.95 * hull.depth, h))) {
  const double level = std::clamp(h / hull.depth, 0.0, 1.0);
  runPower_ = mix(1.7, 2.3, level);
  runFullness_ = mix(1.35, 1, level);
  entrancePower_ = mix(1.6, 2.7, power(level, 0.8));
  entranceFullness_ = mix(1.1, 0.6, level);
}

double HullLine::uAt(double x) const { return std::clamp((x - sternX_) / (stemX_ - sternX_), 0.0, 1.0); }

Vec3 HullLine::side(double u) const {
  double z = 0;
  if (u < kMidship) {
    const double s = (kMidship - u) / kMidship;
    z = transom_ + (broadest_ - transom_) * power(1 - power(s, runPower_), runFullness_);
  } else {
    const double s = (u - kMidship) / (1 - kMidship);
    z = broadest_ * power(1 - power(s, entrancePower_), entranceFullness_);
  }
  return {mix(sternX_, stemX_, u), h_ + riseOf(sheerThere_, u), z};
}

double Plan::railH(double x) const { return deckH(x) + kBulwark; }

double Plan::deckH(double x) const {
  double h = hull.depth;
  for (const Deck& deck : stern) {
    if (x < deck.toX) h = std::max(h, deck.h);
  }
  return x > forecastle.fromX && x < forecastle.toX ? std::max(h, forecastle.h) : h;
}

Vec3 SailSurface::at(double across, double down) const {
  const double width = sail.headWidth + (sail.footWidth - sail.headWidth) * down;
  const double hollow = 1 - 0.05 * std::sin(kPi * down);  // the leeches are drawn in
  const double round = std::cos(kPi / 2 * across * 0.96);
  const double fill = std::sin(kPi * power(down, 0.85) * 0.86);
  const double height = sail.yardY - sail.footY;
  const double roach = sail.roach * std::cos(kPi / 2 * across) * down * down;  // and the foot upwards
  return {x + sail.belly * round * fill, sail.yardY - 0.12 - (height - 0.12) * down + roach, width * 0.5 * across * hollow};
}

Segment stayBefore(const SailSurface& sail, const Vec3& head, Vec3 end) {
  for (int i = 1; i <= 20; ++i) {
    const Vec3 cloth = sail.at(0, i / 20.0) + Vec3(kStayClearM, 0, 0);
    if (cloth.y >= head.y || cloth.x >= end.x) continue;
    // The straight line from the head that touches the cloth there.
    end.y = std::max(end.y, head.y - (head.y - cloth.y) * (end.x - head.x) / (cloth.x - head.x));
  }
  return {head, end};
}

double Mast::yardX(std::size_t i) const {
  const double masts[] = {x, topmastX(), gallantX()}, radii[] = {radius, 0.6 * radius, 0.36 * radius};
  return masts[i] + radii[i] + yardRadius(i) + 0.08;
}

Plan planBoat(const Values& values) {
  Plan plan;
  HullForm& hull = plan.hull;
  hull = {values.at(kLength), values.at(kBeam), values.at(kDepth), values.at(kSheer), values.at(kDraught)};
  plan.beak = values.at(kBeakLength);
  const double length = hull.length;

  plan.forecastle = {hull.depth + values.at(kForecastleHeight), length - values.at(kForecastleLength), length - 1.1};
  plan.sternDeckHeight = values.at(kSternDeckHeight);
  const double reach[] = {0.40, 0.275, 0.15};
  for (int i = 0; i < static_cast<int>(values.at(kSternDecks)); ++i) {
    plan.stern.push_back({hull.depth + (i + 1) * plan.sternDeckHeight, 0, reach[i] * length});
    plan.stern.back().fromX = hull.sternX(plan.stern.back().h);
  }
  plan.gallery = values.at(kGalleryDepth);

  const double topsail = values.at(kTopsailWidth), belly = values.at(kSailBelly);
  const double foreWidth = values.at(kForeSailWidth), mainWidth = values.at(kMainSailWidth);
  plan.fore = squareMast(plan, length - 0.56 * values.at(kForecastleLength), values.at(kForeMastHeight), 5);
  plan.fore.sails = squareSails(plan.fore, foreWidth, topsail * foreWidth / mainWidth, belly * 0.9);
  plan.main = squareMast(plan, 0.515 * length, values.at(kMainMastHeight), 6);
  plan.main.sails = squareSails(plan.main, mainWidth, topsail, belly);
  if (length >= kMizzenFromLength) {
    const double height = values.at(kMizzenMastHeight);
    plan.mizzen = lateenMast(plan, 0.235 * length, height, 0.88 * height, 4);
  }
  if (length >= kBonaventureFromLength) {
    const double height = values.at(kBonaventureMastHeight);
    plan.bonaventure = lateenMast(plan, 0.075 * length, height, 0.88 * height, 3);
  }

  plan.bowspritLength = values.at(kBowspritLength);
  plan.steeveRad = values.at(kBowspritSteeve) * kPi / 180;
  plan.bowspritFoot = {length - 1.1, hull.side(1, hull.depth).y + 0.75, 0};
  plan.bowspritTip =
      plan.bowspritFoot + Vec3(std::cos(plan.steeveRad), std::sin(plan.steeveRad), 0) * plan.bowspritLength;

  Battery& battery = plan.battery;
  battery.fromX = 0.15 * length;
  const double run = 0.69 * length;
  battery.bays = repeatCount(run, values.at(kGunPortSpacing));
  battery.spacing = run / battery.bays;
  battery.h = 0.64 * hull.depth;
  plan.gunsRunOut = values.at(kGunsRunOut) != 0;
  return plan;
}

}  // namespace dimline::boat
