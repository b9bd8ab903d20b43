#include <algorithm>
#include <cmath>

#include "models/house_parts.h"

// Walls and what fills their openings. A facade's scope is a face of the storeys' box (x right, y up, z outwards), so the same
// rules draw all four sides. Windows of one house are all alike: made once, placed often.

namespace dimline::house {

namespace {

constexpr double kFrameBar = 0.065;  // width of the window's outer frame
constexpr double kFrameDepth = 0.07;
constexpr double kGlass = 0.02;

/// A frame around w by h with a grid of panes, in the scope from z = 0 to its depth.
Polygon frameOutline(double w, double h, double bar, double inner, int columns, int rows) {
  Polygon frame{rectangleRing({0, 0}, {w, h}), {}};
  const double paneW = (w - 2 * bar - (columns - 1) * inner) / columns,
               paneH = (h - 2 * bar - (rows - 1) * inner) / rows;
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const Vec2 low(bar + c * (paneW + inner), bar + r * (paneH + inner));
      frame.holes.push_back(rectangleRing(low, low + Vec2(paneW, paneH)));
    }
  }
  return frame;
}

/// Frame and glass over the scope's x and y, kReveal behind z = 0.
void drawGlazing(const House& house, int columns, int rows) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y;
  b.push([&] {
    b.translate({0, 0, -kReveal - kFrameDepth});
    b.scale(Axis::kZ, kFrameDepth);
    b.material(house.m.frame);
    b.extrudePolygon(frameOutline(w, h, kFrameBar, 0.045, columns, rows));
    b.material(house.m.glass);
    b.box({kFrameBar * 0.5, kFrameBar * 0.5, (kFrameDepth - kGlass) * 0.5}, {w - kFrameBar, h - kFrameBar, kGlass});
  });
}

/// Trim on the wall around the scope's sides and top, and below when closed.
void drawSurround(const House& house, bool closed) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y, s = kSurround;
  b.push([&] {
    b.scale(Axis::kZ, 0.03);
    b.material(house.m.trim);
    if (closed) {
      b.extrudePolygon(Polygon{rectangleRing({-s, -s}, {w + s, h + s}), {rectangleRing({0, 0}, {w, h})}});
    } else {
      b.extrudePolygon(Ring{{-s, 0}, {0, 0}, {0, h}, {w, h}, {w, 0}, {w + s, 0}, {w + s, h + s}, {-s, h + s}});
    }
  });
}

PartId makeWindow(const House& house) {
  Builder& b = house.b;
  const double w = house.plan.windowWidth, h = house.plan.windowHeight;
  return b.part({w, h, 0}, [&] {
    b.push([&] {
      b.extrude(-kReveal);
      b.name("Window");
    });
    b.push([&] {
      b.translate({0, -house.plan.sillHeight, -kReveal});
      b.scale({w, house.plan.sillHeight, kReveal});
      b.name("Sill");
    });
    drawGlazing(house, w >= 0.8 ? 2 : 1, h >= 1.15 ? 2 : 1);
    drawSurround(house, false);
    b.material(house.m.stone);
    b.box({-0.13, -0.07, -kReveal}, {w + 0.26, 0.085, kReveal + 0.07});
  });
}

PartId makeShutter(const House& house) {
  Builder& b = house.b;
  const double w = house.plan.windowWidth * 0.5, h = house.plan.windowHeight;
  return b.part({w, h, 0.04}, [&] {
    b.material(house.m.shutter);
    b.box();
    for (const double y : {0.12, 0.5, 0.88}) b.box({0.03, y * h - 0.04, 0.04}, {w - 0.06, 0.08, 0.02});
  });
}

void drawDoor(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y;
  drawSurround(house, false);
  drawGlazing(house, w >= 1.6 ? 2 : 1, 1);
  b.push([&] {
    b.extrude(-kReveal);
    b.name("Door");
  });
  // One leaf, or two when the door is wide, in front of the glazing that remains visible above as a light.
  const double light = std::clamp(h - 2.05, 0.0, 0.4);
  const int leaves = w >= 1.6 ? 2 : 1;
  b.push([&] {
    b.translate({0.05, 0, -kReveal});
    b.scale({w - 0.1, h - light - 0.05, 0.05});
    b.repeat(Axis::kX, b.size().x / leaves, [&](int i, int) {
      b.material(house.m.door);
      b.offset(-0.004);
      b.box();
      const double lw = b.size().x;
      b.material(house.m.darkMetal);
      b.box({i == 0 && leaves == 2 ? lw - 0.1 : leaves == 2 ? 0.06 : lw - 0.14, 0.95, 0.05}, {0.04, 0.35, 0.05});
    });
  });
}

void drawWall(const House& house, const Facade& facade) {
  Builder& b = house.b;
  // Front and back run through; the sides stand between them.
  const bool side = facade.face == Face::kRight || facade.face == Face::kLeft;
  const double from = side ? kWallThickness : 0, to = facade.length - from;
  Polygon wall;
  wall.outer = {{from, 0}, {to, 0}};
  const Ring top = wallTop(house.plan, facade, from, to);
  wall.outer.insert(wall.outer.end(), top.begin(), top.end());
  for (const Opening& o : facade.openings) {
    const double bottom = std::max(o.y, 0.0);
    // A door on the ground floor starts on the wall's lower edge: a notch rather than a hole is what the outline needs there.
    if (bottom <= 0) continue;
    wall.holes.push_back(rectangleRing({o.x, bottom}, {o.x + o.width, o.y + o.height}));
  }
  std::vector<Opening> notches;
  std::copy_if(facade.openings.begin(), facade.openings.end(), std::back_inserter(notches),
               [](const Opening& o) { return o.y <= 0; });
  std::sort(notches.begin(), notches.end(), [](const Opening& a, const Opening& c) { return a.x < c.x; });
  auto at = wall.outer.begin() + 1;
  for (const Opening& o : notches) {
    const Vec2 notch[] = {{o.x, 0}, {o.x, o.height}, {o.x + o.width, o.height}, {o.x + o.width, 0}};
    at = wall.outer.insert(at, std::begin(notch), std::end(notch)) + 4;
  }
  b.push([&] {
    b.extrude(-kWallThickness);
    b.material(house.m.plaster);
    b.extrudePolygon(wall);
  });
}

}  // namespace

Ring wallTop(const Plan& plan, const Facade& facade, double fromX, double toX) {
  const double bury = 0.03;  // into the roof's slab, so that no gap shows
  const double base = plan.wallHeight + plan.kneeHeight, slope = std::tan(plan.pitchRad), d = facade.length;
  const bool side = facade.face == Face::kRight || facade.face == Face::kLeft;
  if (plan.roof == RoofType::kGable && side) {
    return {{toX, base + (d - toX) * slope + bury},
            {d * 0.5, base + d * 0.5 * slope + bury},
            {fromX, base + fromX * slope + bury}};
  }
  if (plan.roof == RoofType::kShed && side) {
    // Seen from the right the front is to the left.
    const double run = d * kShedSplit;
    Ring top{{d - fromX, base + fromX * slope + bury},
             {run, base + (d - run) * slope + bury},
             {run, base + run * slope + bury},
             {fromX, base + fromX * slope + bury}};
    if (facade.face == Face::kLeft) {
      std::reverse(top.begin(), top.end());
      for (Vec2& p : top) p.x = d - p.x;
    }
    return top;
  }
  return {{toX, base + bury}, {fromX, base + bury}};
}

void buildFacades(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const PartId window = makeWindow(house), shutter = makeShutter(house);
  for (const Facade* f : {&plan.front, &plan.right, &plan.back, &plan.left}) {
    const bool shutters = f->bayWidth * 0.5 >= plan.windowWidth + kSurround + 0.03;
    b.face(f->face, [&] {
      drawWall(house, *f);
      for (int floor = 0; floor < plan.floors; ++floor) {
        for (int bay = 0; bay < f->bays; ++bay) {
          b.push([&] {
            const bool last = bay + 1 == f->bays;
            if (last && f->bays > 1) return;
            const double start = last ? kCornerMargin : f->axisOf(bay);
            b.translate({start, floor * plan.floorHeight + plan.sillHeight, -kReveal});
            b.scale({f->bayWidth, plan.windowHeight, kReveal});
            b.name("Bay");
          });
        }
      }
      for (const Opening& o : f->openings) {
        b.push([&] {
          b.translate({o.x, o.y, 0});
          b.scale({o.width, o.height, 0});
          switch (o.kind) {
            case Opening::Kind::kWindow:
              b.place(window);
              if (shutters) {
                b.translate({-kSurround - 0.01 - o.width * 0.5, 0, 0.01});
                b.place(shutter);
                b.translate({o.width * 1.5 + 2 * kSurround + 0.02, 0, 0});
                b.place(shutter);
              }
              break;
            case Opening::Kind::kDoor:
              drawDoor(house);
              break;
            case Opening::Kind::kBalconyDoor:
            case Opening::Kind::kTerraceDoor:
              drawGlazing(house, 2, 1);
              drawSurround(house, false);
              break;
          }
        });
      }
    });
  }
}

}  // namespace dimline::house
