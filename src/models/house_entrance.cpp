#include <algorithm>
#include <cmath>

#include "models/house_parts.h"

// The door and what stands before it: landing and steps, a balcony on posts or a canopy; and the terrace behind the
// house. Scope of all but the door: a facade, its floor level with the ground floor.

namespace dimline::house {

namespace {

constexpr double kStepRise = kPlinth / 3, kStepRun = 0.32;
constexpr double kSlab = 0.2;  // a balcony's floor
constexpr double kRailHeight = 1.0;
constexpr double kPost = 0.2;

/// A platform as high as the ground floor with steps down its front.
void drawPlatform(const House& house, double center, double width, double depth) {
  Builder& b = house.b;
  const double d = depth + 0.05;  // it reaches under the wall's face, over the plinth that stands back
  b.push([&] {
    b.translate({center - width * 0.5, -kPlinth, -0.05});
    b.scale({width, kPlinth, 0});
    b.material(house.m.paving);
    b.extrudePolygon(Ring{{0, 0},
                          {d + 2 * kStepRun, 0},
                          {d + 2 * kStepRun, kStepRise},
                          {d + kStepRun, kStepRise},
                          {d + kStepRun, 2 * kStepRise},
                          {d, 2 * kStepRise},
                          {d, 3 * kStepRise},
                          {0, 3 * kStepRise}},
                     Axis::kX);
  });
}

/// Scope: the railing's box, floor to handrail; z outwards from the wall.
void drawRailing(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y, d = b.size().z, bar = 0.045;
  b.material(house.m.darkMetal);
  const PartId baluster = b.part({0.018, h - 0.13, 0.018}, [&] { b.box(); });
  const PartId post = b.part({bar + 0.01, h + 0.03, bar + 0.01}, [&] { b.box(); });
  // Three sides, each in a scope whose x runs along it.
  const auto side = [&](double length) {
    b.box({0, h - bar, 0}, {length, bar, bar});
    b.box({0, 0.08, 0.01}, {length, 0.025, bar - 0.02});
    b.scale({length, h, bar});
    b.repeat(Axis::kX, 0.115, [&](int i, int) {
      if (i == 0) return;
      b.translate({-0.009, 0.09, bar * 0.5 - 0.009});
      b.place(baluster);
    });
  };
  b.push([&] {
    b.translate({bar, 0, d - bar});
    side(w - 2 * bar);
  });
  for (const bool right : {false, true}) {
    b.push([&] {
      // x from the wall outwards.
      b.translate({right ? w : bar, 0, 0});
      b.rotate(Axis::kY, -1.5707963267948966);
      side(d - bar);
    });
    b.push([&] {
      b.translate({right ? w - bar - 0.005 : -0.005, 0, d - bar - 0.005});
      b.place(post);
    });
  }
}

void drawPost(const House& house, double height) {
  Builder& b = house.b;
  b.material(house.m.trim);
  b.box({0, 0, 0}, {kPost, height, kPost});
  b.material(house.m.stone);
  b.box({-0.04, 0, -0.04}, {kPost + 0.08, 0.14, kPost + 0.08});
  b.material(house.m.trim);
  b.box({-0.035, height - 0.1, -0.035}, {kPost + 0.07, 0.1, kPost + 0.07});
}

void drawBalcony(const House& house) {
  Builder& b = house.b;
  const Entrance& e = house.plan.entrance;
  const double w = e.balconyWidth, d = e.balconyDepth, below = house.plan.floorHeight - kSlab;
  b.push([&] {
    b.translate({e.center - w * 0.5, below, 0});
    b.scale({w, kSlab + kRailHeight, d});
    b.name("Balcony");
    if (!e.balcony) return;
    b.material(house.m.trim);
    b.box({0.03, 0, -0.05}, {w - 0.06, 0.1, d + 0.02});
    b.material(house.m.stone);
    b.box({0, 0.1, -0.05}, {w, kSlab - 0.12, d + 0.05});
    b.push([&] {
      b.translate({0.05, kSlab - 0.02, 0});
      b.scale({w - 0.1, kRailHeight, d - 0.05});
      drawRailing(house);
    });
    for (const double x : {0.1, w - 0.1 - kPost}) {
      b.push([&] {
        b.translate({x, -below, d - 0.1 - kPost});
        drawPost(house, below);
      });
    }
  });
}

/// A small gable on brackets over the door, or a flat slab where a window or the eaves leave no room for one.
void drawCanopy(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const Entrance& e = plan.entrance;
  const double w = e.canopyWidth, d = 0.85, bottom = e.doorHeight + kDoorSurround + 0.02;
  const double ceiling = plan.floors >= 2 ? plan.floorHeight + plan.sillHeight - 0.12 : plan.wallHeight;
  const double room = ceiling - bottom - 0.3;
  const double pitch = std::min(std::atan(room / (w * 0.5)), 0.55);
  b.push([&] {
    b.translate({e.center - w * 0.5, bottom, 0});
    b.scale({w, 0, d});
    b.material(house.m.timber);
    for (const double x : {0.02, w - 0.12}) {
      // A bracket: a strut from the wall to the beam it carries.
      b.box({x, -0.1, -0.05}, {0.1, 0.1, d + 0.02});
      b.box({x, -0.62, -0.05}, {0.1, 0.55, 0.13});
      const Vec3 strut[] = {{x + 0.05, -0.52, 0.03}, {x + 0.05, -0.07, d - 0.22}};
      b.sweep(rectangleRing({-0.035, -0.035}, {0.035, 0.035}), strut);
    }
    if (pitch < 0.25) {
      b.material(house.m.trim);
      b.box({-0.06, 0, -0.05}, {w + 0.12, 0.09, d + 0.11});
      b.material(house.m.metal);
      b.box({-0.08, 0.09, -0.05}, {w + 0.16, 0.02, d + 0.13});
      return;
    }
    // Ridge outwards: the roof's own x runs from the front to the wall. It ends inside the wall.
    const double over = 0.12;
    b.material(house.m.plaster);
    b.push([&] {
      b.translate({0, 0, d - 0.15});
      b.scale(Axis::kZ, 0.08);
      b.material(house.m.trim);
      b.extrudePolygon(Ring{{0.02, 0}, {w - 0.02, 0}, {w * 0.5, (w * 0.5 - 0.02) * std::tan(pitch)}});
    });
    b.setScope({b.scope().at({0, 0, 1}), {-b.scope().axes[2], b.scope().axes[1], b.scope().axes[0]}, Vec3(0.0)});
    b.scale({d, 0, w});
    RoofOptions options;
    options.pitchRad = pitch;
    options.overhangM = over;
    options.thicknessM = 0.09;
    options.edge = house.m.trim;
    options.underside = house.m.soffit;
    b.material(house.m.tiles);
    const Roof roof = b.roofGable(options);
    b.material(house.m.clay);
    const Vec3 path[] = {roof.ridges[0].start, roof.ridges[0].end};
    b.sweep(ellipseRing({0, 0}, {0.07, 0.05}, 8), path);
  });
}

/// A lantern on the wall. Scope: at its middle on the wall's face.
void drawLamp(const House& house) {
  Builder& b = house.b;
  b.material(house.m.darkMetal);
  b.box({-0.05, -0.1, 0}, {0.1, 0.2, 0.02});
  b.box({-0.015, 0.13, 0}, {0.03, 0.03, 0.13});
  b.push([&] {
    b.translate({-0.08, 0.1, 0.05});
    b.scale({0.16, 0.06, 0.16});
    b.cone(0.25, {6, 0.3});
  });
  b.material(house.m.lamp);
  b.push([&] {
    b.translate({-0.06, -0.1, 0.07});
    b.scale({0.12, 0.2, 0.12});
    b.cylinder({6, 0.3});
  });
}

/// One leaf with raised panels. Scope: the leaf's box.
void drawLeaf(const House& house, bool handleLeft) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y, t = b.size().z, stile = 0.11;
  b.material(house.m.door);
  b.box();
  b.push([&] {
    b.translate({stile, 0.18, t});
    b.scale({w - 2 * stile, h - 0.3, 0.015});
    const int columns = w >= 0.95 ? 2 : 1;
    b.split(Axis::kY, {floating(1.1), fixed(0.11), floating(1.6), fixed(0.11), floating(0.7)}, [&](int row) {
      if (row % 2 == 1) return;
      b.repeat(Axis::kX, b.size().x / columns, [&](int i, int n) {
        const double gap = n > 1 ? 0.05 : 0;
        b.box({i > 0 ? gap : 0, 0, 0}, {b.size().x - gap, b.size().y, b.size().z});
      });
    });
  });
  b.material(house.m.metal);
  b.push([&] {
    b.translate({handleLeft ? 0.05 : w - 0.05, 1.0, t});
    b.box({-0.02, -0.12, 0}, {0.04, 0.24, 0.012});
    const double along = handleLeft ? 0.13 : -0.13;
    const Vec3 path[] = {{0, 0.02, 0}, {0, 0.02, 0.06}, {along, 0.02, 0.06}};
    Builder::SweepOptions options;
    b.sweep(ellipseRing({0, 0}, {0.012, 0.012}, 6), path, options);
  });
}

}  // namespace

void drawDoor(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y;
  b.push([&] {
    b.extrude(-kReveal);
    b.name("Door");
  });
  // The glazing is seen above the leaves, as a light.
  const double light = std::clamp(h - 2.02, 0.0, 0.45);
  const int leaves = w >= 1.6 ? 2 : 1;
  drawGlazing(house, light > 0.2 ? 2 * leaves : 1, 1);
  b.push([&] {
    b.translate({0.06, 0.02, -kReveal - 0.01});
    b.scale({w - 0.12, h - light - 0.08, 0.045});
    b.repeat(Axis::kX, b.size().x / leaves, [&](int i, int n) {
      b.push([&] {
        if (n > 1) {
          b.translate({i == 0 ? 0 : 0.004, 0, 0});
          b.scale(Axis::kX, b.size().x - 0.004);
        }
        drawLeaf(house, n > 1 && i == 1);
      });
    });
    if (light > 0.2) {
      b.material(house.m.frame);
      b.box({-0.06, b.size().y, -0.04}, {w, 0.07, 0.07});
    }
  });
  b.material(house.m.stone);
  b.box({0, 0, -kReveal - 0.05}, {w, 0.02, kReveal + 0.05});

  // Stone around the door: broader than around windows, with a cornice.
  const double s = kDoorSurround - 0.05;
  b.push([&] {
    b.scale(Axis::kZ, 0.045);
    b.extrudePolygon(Ring{{-s, 0}, {0, 0}, {0, h}, {w, h}, {w, 0}, {w + s, 0}, {w + s, h + s}, {-s, h + s}});
    b.box({-s - 0.05, h + s, 0}, {w + 2 * s + 0.1, 0.05, 0.1});
  });
  if (!house.plan.entrance.lamps) return;
  for (const double x : {-0.37, w + 0.37}) {
    b.push([&] {
      b.translate({x, std::min(1.75, h - 0.3), 0});
      drawLamp(house);
    });
  }
}

void buildEntrance(const House& house) {
  Builder& b = house.b;
  const Entrance& e = house.plan.entrance;
  b.face(Face::kFront, [&] {
    drawPlatform(house, e.center, e.landingWidth, e.landingDepth);
    if (house.plan.floors >= 2) drawBalcony(house);
    if (!e.balcony) drawCanopy(house);
  });
  b.face(Face::kBack, [&] {
    for (const Opening& o : house.plan.back.openings) {
      if (o.kind == Opening::Kind::kTerraceDoor) drawPlatform(house, o.x + o.width * 0.5, o.width + 2.2, 2.4);
    }
  });
}

}  // namespace dimline::house
