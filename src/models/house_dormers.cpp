#include <algorithm>
#include <cmath>

#include "models/house_parts.h"

// Windows in the roof: dormers above the front, flat ones in the slope behind. They stand over the facade's bays,
// evenly to both sides of the entrance, and only where the slope is high and wide enough.

namespace dimline::house {

namespace {

constexpr double kWindowW = 0.8, kWindowH = 0.9;
constexpr double kBodyW = 1.3;        // of the dormer, wall to wall
constexpr double kCheek = 1.22;       // from the roof's face to the dormer's eave, in front
constexpr double kBehindWall = 0.75;  // the dormer's front from the facade
constexpr double kDormerOver = 0.16;
constexpr double kDormerSlab = 0.11;
constexpr double kDormerPitch = 0.66;

struct Dormer {
  double frontZ, foot, eave, ridge, backZ;
};

/// Heights of a dormer in the front slope, or nothing when it would reach the ridge. Scope: the roof's base.
std::optional<Dormer> fitDormer(const Plan& plan, const Roof& roof) {
  Dormer d{};
  d.frontZ = plan.depth - kBehindWall;
  d.foot = roof.heightAt(plan.width * 0.5, d.frontZ);
  d.eave = d.foot + kCheek;
  d.ridge = d.eave + kBodyW * 0.5 * std::tan(kDormerPitch) + kDormerSlab / std::cos(kDormerPitch);
  const double slope = std::tan(plan.pitchRad);
  d.backZ = d.frontZ - (d.ridge - d.foot) / slope - 0.1;  // where the slope has swallowed the ridge
  if (roof.heightAt(plan.width * 0.5, d.backZ - kDormerOver) < d.ridge + 0.1) return {};
  return d;
}

/// The bays that carry a dormer: every second one from beside the entrance on, or wider apart when bays are narrow.
std::vector<double> dormerAxes(const Plan& plan) {
  const Facade& f = plan.front;
  const int step = 2 * std::max(1, static_cast<int>(std::ceil(3.4 / (2 * f.bayWidth))));
  std::vector<double> axes;
  for (int bay = 0; bay < f.bays; ++bay) {
    const int from = bay - f.bays / 2;
    if ((std::abs(from) + step / 2) % step == 0) axes.push_back(f.axisOf(bay));
  }
  return axes;
}

void drawDormer(const House& house, const Dormer& d, double axis) {
  Builder& b = house.b;
  const double left = axis - kBodyW * 0.5, bottom = d.foot - 0.35, wallH = d.eave - bottom;
  const double peak = wallH + kBodyW * 0.5 * std::tan(kDormerPitch);
  const Ring gable{{0, 0}, {kBodyW, 0}, {kBodyW, wallH}, {kBodyW * 0.5, peak}, {0, wallH}};
  const Vec2 window((kBodyW - kWindowW) * 0.5, 0.35 + 0.14);
  b.push([&] {
    // In one piece, with the window's opening running through it: a front wall of its own would show a joint.
    b.translate({left, bottom, d.backZ});
    b.scale({kBodyW, wallH, d.frontZ - d.backZ});
    b.material(house.m.plaster);
    b.extrudePolygon(Polygon{gable, {rectangleRing(window, window + Vec2(kWindowW, kWindowH))}});
    b.translate({window.x, window.y, b.size().z});
    b.scale({kWindowW, kWindowH, 0});
    drawGlazing(house, 2, 2);
    drawSurround(house, true);
  });
  b.push([&] {
    // The dormer's roof has its ridge along the house's z: its own x runs from the front inwards.
    b.setScope({b.scope().at(Vec3(0.0)), {-b.scope().axes[2], b.scope().axes[1], b.scope().axes[0]}, Vec3(0.0)});
    b.translate({-d.frontZ, d.eave, left});
    b.scale({d.frontZ - d.backZ, 0, kBodyW});
    RoofOptions options;
    options.pitchRad = kDormerPitch;
    options.overhangM = kDormerOver;
    options.thicknessM = kDormerSlab;
    options.edge = house.m.trim;
    options.underside = house.m.soffit;
    b.material(house.m.tiles);
    const Roof roof = b.roofGable(options);
    b.material(house.m.clay);
    const Vec3 path[] = {roof.ridges[0].start, roof.ridges[0].end};
    b.sweep(ellipseRing({0, 0}, {0.08, 0.06}, 8), path);
  });
}

/// A window that lies in the slope. Scope: its place in the slope's scope.
void drawSkylight(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y, bar = 0.07;
  b.push([&] {
    b.translate({0, 0, -0.03});
    b.scale(Axis::kZ, 0.1);
    b.material(house.m.darkMetal);
    b.extrudePolygon(Polygon{rectangleRing({0, 0}, {w, h}), {rectangleRing({bar, bar}, {w - bar, h - bar})}});
    b.material(house.m.glass);
    b.box({bar * 0.5, bar * 0.5, 0}, {w - bar, h - bar, 0.075});
  });
}

}  // namespace

void drawRoofWindows(const House& house, const Roof& roof, bool hip) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const std::vector<double> axes = dormerAxes(plan);
  if (const std::optional<Dormer> dormer = fitDormer(plan, roof)) {
    // The end slopes of a hip roof must stay clear of it: what swallows its ridge behind is the front slope.
    const double half = kBodyW * 0.5 + kDormerOver;
    const auto clear = [&](double axis) {
      return std::min(roof.heightAt(axis - half, dormer->backZ), roof.heightAt(axis + half, dormer->backZ)) >
             dormer->ridge;
    };
    std::vector<double> fitting;
    std::copy_if(axes.begin(), axes.end(), std::back_inserter(fitting), clear);
    const double middle = plan.front.axisOf(plan.front.bays / 2);
    if (fitting.empty() && clear(middle)) fitting.push_back(middle);
    for (const double axis : fitting) drawDormer(house, *dormer, axis);
  }
  const double w = 0.78, h = 1.18;
  b.slopes(roof, [&](int i) {
    const bool back = hip ? i == 2 : i == 1;
    const double start = (plan.overhang + 1.1) / std::cos(plan.pitchRad);
    if (!back || start + h > b.size().y - 0.9) return;
    for (const double axis : axes) {
      const double x = b.size().x * 0.5 - (plan.width * 0.5 - axis);
      // A hip comes in with the slope: by as much as the run on plan.
      const double hipIn = hip ? (start + h) * std::cos(plan.pitchRad) + 0.3 : 0;
      if (x - w * 0.5 < hipIn || x + w * 0.5 > b.size().x - hipIn) continue;
      b.push([&] {
        b.translate({x - w * 0.5, start, 0});
        b.scale({w, h, 0});
        drawSkylight(house);
      });
    }
  });
}

}  // namespace dimline::house
