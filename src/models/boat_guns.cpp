#include <algorithm>
#include <cmath>

#include "models/boat_parts.h"

// Guns behind their ports. A port is a frame on the planking with a dark panel for the space behind it; its lid hangs
// from the upper edge, open when the gun is run out.

namespace dimline::boat {

namespace {

/// A gun's barrel along z, its muzzle outboard. The scope's origin is on the planking in the middle of the port.
PartId makeGun(const Ship& ship) {
  Builder& b = ship.b;
  return b.part(Vec3(0.0), [&] {
    b.material(ship.m.iron);
    const Vec2 barrel[] = {{0.2, 0},     {0.2, 0.3},   {0.165, 0.32}, {0.155, 0.75}, {0.17, 0.79}, {0.145, 0.83},
                           {0.13, 1.18}, {0.17, 1.27}, {0.17, 1.33},  {0.085, 1.35}, {0.085, 1.2}, {0, 1.19}};
    b.push([&] {
      b.rotate(Axis::kX, 1.5707963267948966);
      b.rotate(Axis::kY, 0.3);
      b.translate({0, -0.25, 0});
      b.lathe(barrel, {10, 0.5});
    });
  });
}

PartId makeFrame(const Ship& ship) {
  Builder& b = ship.b;
  const double half = kPortSize * 0.5, f = 0.1;
  return b.part({kPortSize, kPortSize, 0.12}, [&] {
    b.material(ship.m.ochre);
    b.push([&] {
      b.translate({0, 0, -0.15});
      b.scale({0, 0, 0.23});
      b.extrudePolygon(Polygon{rectangleRing({-half - f, -half - f}, {half + f, half + f}),
                               {rectangleRing({-half, -half}, {half, half})}});
    });
    b.material(ship.m.shadow);
    b.box({-half, -half, -0.15}, {2 * half, 2 * half, 0.18});
  });
}

/// The lid, closed: its hinge along x at the origin, hanging down in the plane z = 0.
PartId makeLid(const Ship& ship) {
  Builder& b = ship.b;
  const double half = kPortSize * 0.5 + 0.03;
  return b.part({2 * half, 2 * half, 0.08}, [&] {
    b.material(ship.m.oak);
    b.box({-half, -2 * half, 0}, {2 * half, 2 * half, 0.06});
    b.material(ship.m.red);
    b.box({-half + 0.04, -2 * half + 0.04, -0.02}, {2 * half - 0.08, 2 * half - 0.08, 0.03});
    b.material(ship.m.iron);
    for (const double x : {-0.22, 0.22}) b.box({x - 0.035, -1.7 * half, 0.05}, {0.07, 1.75 * half, 0.035});
  });
}

struct Parts {
  PartId gun, frame, lid;
};

void drawPort(const Ship& ship, const Parts& parts, double x, double h, int side, double lean) {
  Builder& b = ship.b;
  const bool out = ship.plan.gunsRunOut;
  b.push([&] {
    enterSide(ship, x, h, side);
    b.push([&] {
      b.rotate(Axis::kX, lean);
      b.place(parts.frame);
      b.translate({0, kPortSize * 0.5 + 0.04, 0.09});
      b.rotate(Axis::kX, out ? -1.75 : 0.0);
      b.place(parts.lid);
    });
    if (out) b.place(parts.gun);
  });
}

/// The angle by which the side leans inwards at x, upwards of h.
double leanAt(const HullForm& hull, double x, double h) {
  const Vec3 low = hull.sideAt(x, h - 0.3), high = hull.sideAt(x, h + 0.3);
  return -std::atan2(low.z - high.z, high.y - low.y);
}

}  // namespace

void buildGuns(const Ship& ship) {
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const Battery& battery = plan.battery;
  const Parts parts{makeGun(ship), makeFrame(ship), makeLid(ship)};
  const double middleH = battery.h + kPortSize * 0.5;
  const double end = battery.fromX + battery.bays * battery.spacing;
  // Every bay of a side is measured in one plane, whatever the planking does there.
  const double outZ = hull.beam * 0.5 + 0.1,
               inZ = std::min(hull.sideAt(battery.fromX, middleH).z, hull.sideAt(end, middleH).z);
  const double lowY = hull.sideAt(hull.length * 0.5, battery.h).y;
  const double highY = std::max(hull.sideAt(battery.fromX, battery.h).y, hull.sideAt(end, battery.h).y) + kPortSize;
  for (const int side : kSides) {
    for (int i = 0; i < battery.bays; ++i) {
      const double from = battery.fromX + i * battery.spacing, x = from + battery.spacing * 0.5;
      drawPort(ship, parts, x, middleH, side, leanAt(hull, x, middleH));
      nameBetween(ship, "GunBay", {from, lowY, inZ * side}, {from + battery.spacing, highY, outZ * side});
    }
    // Lighter guns in the waist, between the castles.
    const double fromX = plan.stern.front().toX + 1.2, toX = plan.forecastle.fromX - 1.0;
    const int count = static_cast<int>((toX - fromX) / 3.2);
    const double h = hull.depth + 0.52;
    for (int i = 0; i < count; ++i) {
      const double x = fromX + (toX - fromX) * (i + 0.5) / count;
      drawPort(ship, parts, x, h, side, leanAt(hull, x, h));
    }
  }
  const double half = hull.beam * 0.5;
  nameBetween(ship, "Battery", {battery.fromX, lowY, -half}, {end, highY, half});
}

}  // namespace dimline::boat
