#include <algorithm>
#include <cmath>

#include "core/sort_keys.h"
#include "models/house_parts.h"

// Walls and what fills their openings. A facade's scope is a face of the storeys' box (x right, y up, z outwards), so
// the same rules draw all four sides. Windows of one house are all alike: made once, placed often.

namespace dimline::house {

namespace {

constexpr double kFrameBar = 0.06;  // width of a window's outer frame
constexpr double kMullion = 0.045;
constexpr double kFrameDepth = 0.07;
constexpr double kGlassDepth = 0.02;
constexpr double kRailBelow = 0.6;  // a sill lower than this gets a rail on upper floors

/// A frame around w by h with a grid of panes.
Polygon frameOutline(double w, double h, int columns, int rows) {
  Polygon frame{rectangleRing({0, 0}, {w, h}), {}};
  const double paneW = (w - 2 * kFrameBar - (columns - 1) * kMullion) / columns;
  const double paneH = (h - 2 * kFrameBar - (rows - 1) * kMullion) / rows;
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const Vec2 low(kFrameBar + c * (paneW + kMullion), kFrameBar + r * (paneH + kMullion));
      frame.holes.push_back(rectangleRing(low, low + Vec2(paneW, paneH)));
    }
  }
  return frame;
}

void drawSill(const House& house, double w) {
  house.b.material(house.m.stone);
  house.b.box({-0.13, -0.07, -kReveal}, {w + 0.26, 0.085, kReveal + 0.07});
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
    drawGlazing(house, w >= 1.5 ? 3 : w >= 0.8 ? 2 : 1, h >= 1.15 ? 2 : 1);
    drawSurround(house, false);
    drawSill(house, w);
  });
}

/// A leaf as wide as half a window: frame, boards and two battens.
PartId makeShutter(const House& house) {
  Builder& b = house.b;
  const double w = house.plan.windowWidth * 0.5, h = house.plan.windowHeight;
  return b.part({w, h, 0.035}, [&] {
    b.material(house.m.shutter);
    b.box();
    const double bar = 0.07;
    b.translate({0, 0, 0.035});
    b.scale(Axis::kZ, 0.018);
    Polygon frame{rectangleRing({0, 0}, {w, h}), {}};
    const double panel = (h - 3 * bar) * 0.5;
    for (const double y : {bar, 2 * bar + panel}) frame.holes.push_back(rectangleRing({bar, y}, {w - bar, y + panel}));
    b.extrudePolygon(frame);
  });
}

/// Bars across the lower part of a window that reaches far down: nobody should fall out of it.
PartId makeRail(const House& house) {
  Builder& b = house.b;
  const double w = house.plan.windowWidth, height = 0.95 - house.plan.sillHeight;
  return b.part({w, height, 0}, [&] {
    b.material(house.m.darkMetal);
    b.translate({0, 0.06, -0.05});
    b.scale({w, height - 0.06, 0.03});
    b.box({0, b.size().y - 0.035, 0}, {w, 0.035, 0.03});
    b.box({0, 0.03, 0}, {w, 0.02, 0.03});
    const PartId bar = b.part({0.016, b.size().y - 0.08, 0.016}, [&] { b.box(); });
    b.repeat(Axis::kX, 0.11, [&](int i, int) {
      if (i == 0) return;
      b.translate({-0.008, 0.045, 0.007});
      b.place(bar);
    });
  });
}

void drawWall(const House& house, const Facade& facade) {
  Builder& b = house.b;
  // Front and back run through; the sides stand between them.
  const bool side = facade.face == Face::kRight || facade.face == Face::kLeft;
  const double from = side ? kWallThickness : 0, to = facade.length - from;
  Polygon wall{{{from, 0}}, {}};
  // A door that stands on the wall's lower edge is a notch in the outline, everything else a hole.
  std::vector<SortKey> notches;
  for (std::uint32_t i = 0; i < facade.openings.size(); ++i) {
    const Opening& o = facade.openings[i];
    if (o.y <= 0) {
      notches.push_back({o.x, i});
    } else {
      wall.holes.push_back(rectangleRing({o.x, o.y}, {o.x + o.width, o.y + o.height}));
    }
  }
  sortKeys(notches);
  for (const SortKey& notch : notches) {
    const Opening& o = facade.openings[notch.index];
    for (const Vec2 corner :
         {Vec2(o.x, 0), Vec2(o.x, o.height), Vec2(o.x + o.width, o.height), Vec2(o.x + o.width, 0)}) {
      wall.outer.push_back(corner);
    }
  }
  wall.outer.emplace_back(to, 0);
  const Ring top = wallTop(house.plan, facade, from, to);
  wall.outer.insert(wall.outer.end(), top.begin(), top.end());
  b.push([&] {
    b.extrude(-kWallThickness);
    b.material(house.m.plaster);
    b.extrudePolygon(wall);
  });
}

/// One scope for each window's bay. From the middle of one pier to the middle of the next rather than from axis to axis: then the extension lines pass between
/// the windows, and do not cross the dimensions of their widths.
void nameBays(const House& house, const Facade& facade) {
  Builder& b = house.b;
  for (int floor = 0; floor < house.plan.floors; ++floor) {
    for (int i = 0; i < facade.bays; ++i) {
      b.push([&] {
        b.translate({facade.axisOf(i) - 0.5 * facade.bayWidth, floor * house.plan.floorHeight + house.plan.sillHeight, -kReveal});
        b.scale({facade.bayWidth, house.plan.windowHeight, kReveal});
        b.name("Bay");
      });
    }
  }
}

/// A band of stone under each upper floor, all around.
void drawStringCourses(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, d = b.size().z, out = 0.035;
  b.material(house.m.trim);
  for (int floor = 1; floor < house.plan.floors; ++floor) {
    b.push([&] {
      b.translate({0, floor * house.plan.floorHeight - 0.17, 0});
      b.scale(Axis::kY, 0.13);
      b.extrudePolygon(
          Polygon{rectangleRing({-out, -out}, {w + out, d + out}), {rectangleRing({0.01, 0.01}, {w - 0.01, d - 0.01})}},
          Axis::kY);
    });
  }
}

/// Broad flat pilasters round the corners, which also cover where the walls meet.
void drawCorners(const House& house) {
  Builder& b = house.b;
  const double w = b.size().x, d = b.size().z, broad = 0.42, out = 0.03, in = -0.02;
  b.push([&] {
    // Under a pitched roof they end where its underside passes over their outer faces.
    b.scale(Axis::kY, house.plan.wallHeight + house.plan.kneeHeight - 0.04);
    b.material(house.m.trim);
    const auto corner = [&](double x, double towardsX, double z, double towardsZ) {
      const double xo = x - out * towardsX, xi = x - in * towardsX, zo = z - out * towardsZ, zi = z - in * towardsZ;
      const double xe = x + broad * towardsX, ze = z + broad * towardsZ;
      b.extrudePolygon(Ring{{xe, zi}, {xe, zo}, {xo, zo}, {xo, ze}, {xi, ze}, {xi, zi}}, Axis::kY);
    };
    corner(0, 1, 0, 1);
    corner(w, -1, 0, 1);
    corner(w, -1, d, -1);
    corner(0, 1, d, -1);
  });
}

struct WindowKit {
  PartId window, shutter, rail;
  bool rails;
};

void fillOpening(const House& house, const WindowKit& kit, const Opening& o) {
  Builder& b = house.b;
  switch (o.kind) {
    case Opening::Kind::kWindow:
      b.place(kit.window);
      if (kit.rails && o.floor > 0) b.place(kit.rail);
      if (o.shutters) {
        b.translate({-kSurround - 0.01 - o.width * 0.5, 0, 0.01});
        b.place(kit.shutter);
        b.translate({o.width * 1.5 + 2 * kSurround + 0.02, 0, 0});
        b.place(kit.shutter);
      }
      break;
    case Opening::Kind::kAttic:
      drawGlazing(house, 2, 2);
      drawSurround(house, false);
      drawSill(house, o.width);
      break;
    case Opening::Kind::kDoor:
      drawDoor(house);
      break;
    case Opening::Kind::kBalconyDoor:
    case Opening::Kind::kTerraceDoor:
      drawGlazing(house, o.width >= 1.9 ? 3 : 2, 3);
      drawSurround(house, false);
      break;
  }
}

}  // namespace

void drawGlazing(const House& house, int columns, int rows) {
  Builder& b = house.b;
  const double w = b.size().x, h = b.size().y;
  b.push([&] {
    b.translate({0, 0, -kReveal - kFrameDepth});
    b.scale(Axis::kZ, kFrameDepth);
    b.material(house.m.frame);
    b.extrudePolygon(frameOutline(w, h, columns, rows));
    b.material(house.m.glass);
    const double in = kFrameBar * 0.5;  // the glass is let into the frame
    b.box({in, in, (kFrameDepth - kGlassDepth) * 0.5}, {w - 2 * in, h - 2 * in, kGlassDepth});
  });
}

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

void buildFacades(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const WindowKit kit{makeWindow(house), makeShutter(house), makeRail(house), plan.sillHeight < kRailBelow};
  for (const Facade* f : {&plan.front, &plan.right, &plan.back, &plan.left}) {
    b.face(f->face, [&] {
      drawWall(house, *f);
      nameBays(house, *f);
      for (const Opening& o : f->openings) {
        b.push([&] {
          b.translate({o.x, o.y, 0});
          b.scale({o.width, o.height, 0});
          fillOpening(house, kit, o);
        });
      }
    });
  }
  drawStringCourses(house);
  drawCorners(house);
}

}  // namespace dimline::house
