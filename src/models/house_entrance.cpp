#include <algorithm>

#include "models/house_parts.h"

// Steps, landing, canopy or balcony before the door, and the terrace behind the house.

namespace dimline::house {

namespace {

constexpr double kStepRise = kPlinth / 3, kStepRun = 0.32;
constexpr double kSlab = 0.2;
constexpr double kRail = 1.0;

/// A platform as high as the ground floor with steps down its front. Scope: a facade's 2-D scope; its floor is the ground floor.
void drawPlatform(const House& house, double center, double width, double depth) {
  Builder& b = house.b;
  b.push([&] {
    b.translate({center - width * 0.5, -kPlinth, -0.05});
    b.scale({width, kPlinth, depth});
    b.material(house.m.paving);
    const double d = depth + 0.05;
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

/// Scope: the balcony's box, floor to handrail, z outwards from the wall.
void drawRailing(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y, d = b.size().z;
  b.material(house.m.darkMetal);
  const double post = 0.04;
  const PartId baluster = b.part({0.02, h - 0.12, 0.02}, [&] { b.box(); });
  auto side = [&](const Vec3& from, double length, bool alongX) {
    b.push([&] {
      b.translate(from);
      b.scale({alongX ? length : post, h, alongX ? post : length});
      b.box({0, h - 0.05, 0}, {b.size().x, 0.05, b.size().z});
      b.box({0, 0.06, 0}, {b.size().x, 0.03, b.size().z});
      b.repeat(alongX ? Axis::kX : Axis::kZ, 0.11, [&](int i, int) {
        if (i == 0) return;
        b.translate({alongX ? -0.01 : 0.01, 0.07, alongX ? 0.01 : -0.01});
        b.place(baluster);
      });
    });
  };
  side({0, 0, d - post}, w, true);
  side({0, 0, 0}, d - post, false);
  side({w - post, 0, 0}, d - post, false);
}

/// Scope: the front's 2-D scope.
void drawBalcony(const House& house) {
  Builder& b = house.b;
  const Entrance& e = house.plan.entrance;
  const double w = e.balconyWidth, d = e.balconyDepth;
  b.push([&] {
    b.translate({e.center - w * 0.5, house.plan.floorHeight - kSlab, 0});
    b.scale({w, kSlab + kRail, d});
    b.name("Balcony");
    if (!e.balcony) return;
    b.material(house.m.trim);
    b.box({0, 0, -0.05}, {w, kSlab - 0.02, d + 0.05});
    b.push([&] {
      b.translate({0.04, kSlab - 0.02, 0});
      b.scale({w - 0.08, kRail, d - 0.04});
      drawRailing(house);
    });
    const double post = 0.18, height = house.plan.floorHeight - kSlab;
    b.material(house.m.trim);
    for (const double x : {0.06, w - 0.06 - post}) b.box({x, -height, d - 0.06 - post}, {post, height, post});
  });
}

void drawCanopy(const House& house) {
  Builder& b = house.b;
  const Entrance& e = house.plan.entrance;
  const double w = e.doorWidth + 0.8, d = 0.95;
  b.push([&] {
    b.translate({e.center - w * 0.5, e.doorHeight + kSurround + 0.05, -0.05});
    b.material(house.m.trim);
    b.box({0, 0, 0}, {w, 0.1, d + 0.05});
  });
}

}  // namespace

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
