#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/house_parts.h"
#include "models/vocabulary.h"

// The four roofs. The storeys' box ends at the eaves: a pitched roof's base lies higher by what the eave hangs down,
// so that the underside's outer edge is level with the box's top whatever pitch and overhang are.

namespace dimline::house {

namespace {

constexpr double kShedTop = 0.25;  // how far the upper slope of a shed reaches over the lower one
constexpr double kShedWall = 0.2;  // thickness of the wall between the two

/// The strips between the walls' faces and the roof's edge, one a side; z is outwards.
void nameOverhangs(const House& house, double low, double high) {
  Builder& b = house.b;
  const double o = house.plan.overhang;
  b.push([&] {
    b.translate({0, low, 0});
    b.scale(Axis::kY, high - low);
    b.faces(kSideFaces, [&](Face) {
      b.translate({-o, 0, 0});
      b.scale({b.size().x + 2 * o, b.size().y, o});
      b.name("Overhang");
    });
  });
}

/// The angle at the front eave, on the roof's right edge: x runs level from the eave towards the ridge, y up; the
/// angle opens from x towards y, about z.
void namePitch(const House& house, double eaveY, double runM) {
  Builder& b = house.b;
  const double o = house.plan.overhang;
  b.face(Face::kRight, [&] {
    b.translate({-o, eaveY, o});
    b.scale({runM, runM * std::tan(house.plan.pitchRad), 0});
    b.name("Pitch");
  });
}

RoofOptions optionsOf(const House& house) {
  RoofOptions o;
  o.pitchRad = house.plan.pitchRad;
  o.overhangM = house.plan.overhang;
  o.thicknessM = kRoofSlab;
  o.edge = house.m.trim;
  o.underside = house.m.soffit;
  return o;
}

/// Runs the body again in the scope as it looks from the other end of the house.
template <typename Body>
void fromBehind(Builder& b, Body&& body) {
  b.push([&] {
    b.rotate(Axis::kY, std::numbers::pi, {0.5, 0, 0.5});
    body();
  });
}

/// Just behind the ridge, where a stack needs to rise least; off the middle, but not beyond the ridge's ends.
Vec2 chimneyPlace(const Plan& plan, bool hip) {
  const Vec2 middle(plan.width * 0.5, plan.depth * 0.5);
  const double halfRidge = hip ? std::abs(plan.width - plan.depth) * 0.5 : plan.width * 0.5;
  if (hip && plan.width < plan.depth) return middle + Vec2(-0.66, -std::clamp(halfRidge - 0.3, 0.0, plan.depth * 0.22));
  return middle + Vec2(-std::clamp(halfRidge - 0.3, 0.0, plan.width * 0.22), -0.55);
}

void buildPitched(const House& house, bool hip) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  b.material(house.m.tiles);
  const Roof roof = hip ? b.roofHip(optionsOf(house)) : b.roofGable(optionsOf(house));
  const double edge = roof.eaves[0].start.y;
  nameBox(b, "Roof", roof.min, roof.max);
  nameOverhangs(house, roof.min.y, edge);
  namePitch(house, edge, (hip ? std::min(plan.width, plan.depth) : plan.depth) * 0.5 + plan.overhang);

  drawRidges(house, roof);
  drawRafters(house, roof, hip);
  if (!hip) drawPurlins(house, roof);
  drawRainwater(house, roof);
  drawChimney(house, roof, chimneyPlace(plan, hip));
  drawRoofWindows(house, roof, hip);
}

/// The wall between the two slopes of a shed, with a row of windows where it is high enough. Scope: the roof's base.
void drawClerestory(const House& house, double splitZ, double low, double visibleLow, double high) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const double x0 = kWallThickness, length = plan.width - 2 * kWallThickness, margin = 0.18;
  const double windowHeight = std::min(high - visibleLow - 2 * margin, 0.9);
  b.push([&] {
    b.translate({x0, low, splitZ - kShedWall});
    b.scale({length, high - low, kShedWall});
    Polygon wall{rectangleRing({0, 0}, {length, high - low}), {}};
    std::vector<Interval> windows;
    if (windowHeight >= 0.3) {
      const double width = std::min(1.1, plan.front.bayWidth - 0.4);
      for (int bay = 0; bay < plan.front.bays; ++bay)
        windows.push_back({plan.front.axisOf(bay) - x0 - width * 0.5, width});
    }
    const double sill = visibleLow - low + margin;
    for (const Interval& w : windows) {
      wall.holes.push_back(rectangleRing({w.start, sill}, {w.end(), sill + windowHeight}));
    }
    b.material(house.m.plaster);
    b.extrudePolygon(wall);
    b.translate({0, 0, kShedWall});
    for (const Interval& w : windows) {
      b.push([&] {
        b.translate({w.start, sill, 0});
        b.scale({w.length, windowHeight, 0});
        drawGlazing(house, 1, 1);
      });
    }
  });
}

void buildShed(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const double split = plan.depth * kShedSplit, slope = std::tan(plan.pitchRad);
  const double splitZ = plan.depth - split;
  RoofOptions options = optionsOf(house);
  Roof lower, upper;
  b.push([&] {
    b.translate({0, 0, splitZ});
    b.scale(Axis::kZ, split);
    options.topOverhangM = 0;
    b.material(house.m.tiles);
    lower = b.roofShed(options);
    drawRafters(house, lower, false);
    drawRainwater(house, lower);
  });
  fromBehind(b, [&] {
    b.scale(Axis::kZ, plan.depth);
    b.translate({0, 0, split});
    b.scale(Axis::kZ, splitZ);
    options.topOverhangM = kShedTop;
    b.material(house.m.tiles);
    upper = b.roofShed(options);
    drawRafters(house, upper, false);
    drawRainwater(house, upper);
    drawChimney(house, upper, {plan.width * 0.72, kShedWall + 0.27});
  });
  drawClerestory(house, splitZ, split * slope - 0.2, lower.heightAt(0, 0), splitZ * slope + 0.03);

  const double edge = lower.eaves[0].start.y;
  nameBox(b, "Roof", {-plan.overhang, lower.min.y, -plan.overhang},
          {plan.width + plan.overhang, upper.max.y, plan.depth + plan.overhang});
  nameOverhangs(house, lower.min.y, edge);
  namePitch(house, edge, split + plan.overhang);
}

void buildFlat(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  FlatRoofOptions options;
  options.overhangM = plan.overhang;
  options.thicknessM = 0.22;
  options.parapetHeightM = 0.22;
  options.parapetWidthM = 0.22;
  options.edge = house.m.trim;
  options.underside = house.m.soffit;
  b.material(house.m.gravel);
  const Roof roof = b.roofFlat(options);
  nameBox(b, "Roof", roof.min, roof.max);
  nameOverhangs(house, roof.min.y, roof.max.y);
  drawChimney(house, roof, {plan.width * 0.28, plan.depth * 0.36});

  // Metal coping on the parapet.
  const double w = plan.width, d = plan.depth, o = plan.overhang, in = o - options.parapetWidthM - 0.03;
  b.push([&] {
    b.translate({0, roof.max.y, 0});
    b.scale(Axis::kY, 0.03);
    b.material(house.m.metal);
    b.extrudePolygon(Polygon{rectangleRing({-o - 0.03, -o - 0.03}, {w + o + 0.03, d + o + 0.03}),
                             {rectangleRing({-in, -in}, {w + in, d + in})}},
                     Axis::kY);
  });
}

}  // namespace

void buildRoof(const House& house) {
  Builder& b = house.b;
  b.push([&] {
    b.translate({0, house.plan.wallHeight + house.plan.kneeHeight, 0});
    b.scale(Axis::kY, 0);
    switch (house.plan.roof) {
      case RoofType::kGable:
        buildPitched(house, false);
        break;
      case RoofType::kHip:
        buildPitched(house, true);
        break;
      case RoofType::kShed:
        buildShed(house);
        break;
      case RoofType::kFlat:
        buildFlat(house);
        break;
    }
  });
}

}  // namespace dimline::house
