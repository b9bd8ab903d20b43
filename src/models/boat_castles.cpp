#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "models/boat_parts.h"

// Forecastle and sterncastle: sides that go up in steps, decks, the bulkheads that close them, and what stands on deck.

namespace dimline::boat {

namespace {

constexpr double kHalfPi = 1.5707963267948966;

/// Between two strakes, from one end to the other, on one side. `fromStern`: begins at the transom, which leans.
struct Topside {
  double lowH, highH;
  bool fromStern;
  double fromX, toX;
};

void drawTopside(const Ship& ship, const Topside& part, std::span<const MaterialId> bands, int side) {
  const HullForm& hull = ship.plan.hull;
  const int rows = std::max(4, static_cast<int>(std::lround((part.toX - part.fromX) / 1.4)));
  const auto strips = static_cast<int>(bands.size());
  std::vector<HullLine> lines;
  for (int j = 0; j <= strips; ++j) lines.emplace_back(hull, part.lowH + (part.highH - part.lowH) * j / strips);
  std::vector<std::vector<Vec3>> grid;
  for (int i = 0; i <= rows; ++i) {
    std::vector<Vec3>& row = grid.emplace_back();
    for (const HullLine& line : lines) {
      const double from = part.fromStern ? line.sternX() : part.fromX;
      row.push_back(mirrored(line.sideAt(from + (part.toX - from) * i / rows), side));
    }
    if (side > 0) std::reverse(row.begin(), row.end());
  }
  std::vector<MaterialId> materials(bands.begin(), bands.end());
  if (side > 0) std::reverse(materials.begin(), materials.end());
  Builder::SkinOptions options;
  options.materials = materials;
  ship.b.sheet(grid, kPlank, options);
}

/// A deck between the sides, cambered.
void drawDeck(const Ship& ship, double fromX, double toX, double h) {
  const HullLine line(ship.plan.hull, h);
  constexpr int kAcross = 6;
  const int rows = std::max(3, static_cast<int>(std::lround((toX - fromX) / 1.6)));
  std::vector<std::vector<Vec3>> grid;
  for (int i = 0; i <= rows; ++i) {
    const Vec3 edge = line.sideAt(fromX + (toX - fromX) * i / rows);
    std::vector<Vec3>& row = grid.emplace_back();
    for (int j = 0; j <= kAcross; ++j) {
      const double across = 2.0 * j / kAcross - 1;
      row.emplace_back(edge.x, edge.y + kCamber * edge.z * (1 - across * across), (edge.z - 0.06) * across);
    }
  }
  ship.b.material(ship.m.deck);
  ship.b.sheet(grid, 0.12);
}

/// A part to place along railings: turned wood, as high as a railing below its handrail.
PartId makeBaluster(const Ship& ship) {
  return ship.b.part({0.2, 0.8, 0.2}, [&] {
    const Vec2 profile[] = {{0.07, 0}, {0.07, 0.1}, {0.035, 0.18}, {0.075, 0.38}, {0.03, 0.64}, {0.07, 0.8}};
    ship.b.lathe(profile, {8, 0.9});
  });
}

/// A railing across the deck's end at x.
void drawRailing(const Ship& ship, double x, double h, PartId baluster) {
  Builder& b = ship.b;
  const Vec3 edge = ship.plan.hull.sideAt(x, h + 0.5);
  const double y = ship.plan.hull.sideAt(x, h).y, half = edge.z - kPlank;
  b.push([&] {
    b.translate({x - 0.22, y + 0.05, -half});
    b.scale({0.2, 0.9, 2 * half});
    b.material(ship.m.darkOak);
    b.box({-0.03, 0, 0}, {0.26, 0.06, 2 * half});
    b.box({-0.04, 0.86, 0}, {0.28, 0.1, 2 * half});
    b.repeat(Axis::kZ, 0.46, [&](int, int) {
      b.translate({0, 0.06, b.size().z * 0.5 - 0.1});
      b.place(baluster);
    });
  });
}

/// A door with a low arch over it. Scope: its middle on the bulkhead's face, on deck, z outwards.
void drawDoor(const Ship& ship) {
  Builder& b = ship.b;
  const double w = 0.42, h = 1.45;
  Ring outline{{-w, 0}, {w, 0}, {w, h}};
  for (const double angle : {0.5, 1.07, 1.57, 2.07, 2.64})
    outline.emplace_back(w * std::cos(angle), h + 0.16 * std::sin(angle));
  outline.emplace_back(-w, h);
  b.push([&] {
    b.scale(Axis::kZ, 0.05);
    b.material(ship.m.ochre);
    b.extrudePolygon(offset(outline, 0.1));
    b.scale(Axis::kZ, 0.08);
    b.material(ship.m.darkOak);
    b.extrudePolygon(outline);
  });
  b.material(ship.m.iron);
  for (const double y : {0.35, 1.1}) b.box({-w, y, 0.07}, {1.5 * w, 0.07, 0.03});
}

/// The wall that closes a castle at x, between two decks. `ahead`: it looks forward, else aft.
void drawBulkhead(const Ship& ship, double x, double lowH, double highH, bool ahead, PartId window) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  constexpr double kThick = 0.12;
  constexpr int kSteps = 3;
  Ring outline;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3 p = hull.sideAt(x, lowH + (highH - lowH) * i / kSteps);
    outline.emplace_back(p.z - 0.08, p.y);
  }
  for (std::size_t i = outline.size(); i-- > 0;) outline.emplace_back(-outline[i].x, outline[i].y);
  b.push([&] {
    b.translate({ahead ? x - kThick : x, 0, 0});
    b.scale({kThick, 0, 0});
    b.material(ship.m.oak);
    b.extrudePolygon(outline, Axis::kX);
  });
  const double floor = outline.front().y, height = outline[kSteps].y - floor;
  const double half = std::min(outline[0].x, outline[kSteps].x);
  b.push([&] {
    // Seen from outside: x to the right, y up.
    b.translate({x, floor, 0});
    b.rotate(Axis::kY, ahead ? kHalfPi : -kHalfPi);
    b.material(ship.m.ochre);
    b.box({-half, height - 0.26, 0}, {2 * half, 0.18, 0.06});
    const double doorX = half > 2.2 ? half * 0.5 : 0.0;
    for (const double at : doorX > 0 ? std::vector{-doorX, doorX} : std::vector{0.0}) {
      b.push([&] {
        b.translate({at, 0.16, 0});
        drawDoor(ship);
      });
    }
    if (doorX <= 0) return;
    for (const double at : {-0.75, 0.05}) {
      b.push([&] {
        b.translate({at, height * 0.42, 0});
        b.place(window);
      });
    }
  });
}

/// A small window: frame, bars and glass. Its scope's x and y are the opening's, z outwards.
PartId makeWindow(const Ship& ship, double width, double height) {
  Builder& b = ship.b;
  return b.part({width, height, 0.06}, [&] {
    const double f = 0.07;
    b.material(ship.m.glass);
    b.box({0, 0, 0}, {width, height, 0.02});
    b.material(ship.m.ochre);
    b.scale({width, height, 0.06});
    b.extrudePolygon(
        Polygon{rectangleRing({-f, -f}, {width + f, height + f}), {rectangleRing({0, 0}, {width, height})}});
    b.material(ship.m.darkOak);
    b.box({width * 0.5 - 0.015, 0, 0.02}, {0.03, height, 0.02});
    b.box({0, height * 0.5 - 0.015, 0.02}, {width, 0.03, 0.02});
  });
}

/// Steps up to a castle's deck at x, from the deck before it.
void drawLadder(const Ship& ship, double x, double lowH, double highH, double towards, double z) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const double low = hull.sideAt(x, lowH).y + 0.1, rise = hull.sideAt(x, highH).y + 0.1 - low, run = rise * 0.55;
  b.material(ship.m.darkOak);
  const Ring string = rectangleRing({-0.03, -0.11}, {0.03, 0.11});
  for (const double at : {z - 0.38, z + 0.38}) {
    const Vec3 way[] = {{x + towards * run, low, at}, {x + towards * 0.05, low + rise, at}};
    Builder::SweepOptions options;
    options.up = {towards, 0, 0};
    b.sweep(string, way, options);
  }
  const int steps = std::max(3, static_cast<int>(std::lround(rise / 0.3)));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    b.box({x + towards * run * (1 - t) - 0.13, low + rise * t - 0.02, z - 0.38}, {0.26, 0.04, 0.76});
  }
}

/// A hatch closed by a grating. Scope: its floor's middle.
void drawHatch(const Ship& ship, double lengthM, double widthM) {
  Builder& b = ship.b;
  const double rim = 0.15, innerLength = lengthM - 2 * rim, innerWidth = widthM - 2 * rim;
  b.push([&] {
    b.translate({-lengthM * 0.5, 0, -widthM * 0.5});
    b.scale({lengthM, 0.3, widthM});
    b.material(ship.m.darkOak);
    b.extrudePolygon(
        Polygon{rectangleRing({0, 0}, {lengthM, widthM}), {rectangleRing({rim, rim}, {lengthM - rim, widthM - rim})}},
        Axis::kY);
    b.material(ship.m.shadow);
    b.box({rim, 0, rim}, {innerLength, 0.12, innerWidth});
    b.material(ship.m.deck);
    b.translate({rim, 0.16, rim});
    b.scale({innerLength, 0.1, innerWidth});
    b.repeat(Axis::kX, 0.3, [&](int i, int) {
      if (i > 0) b.box({-0.05, 0.02, 0}, {0.1, 0.08, innerWidth});
    });
    b.repeat(Axis::kZ, 0.3, [&](int i, int) {
      if (i > 0) b.box({0, 0, -0.05}, {innerLength, 0.07, 0.1});
    });
  });
}

/// The ship's boat, keel down on two chocks. Scope: the middle between these, on what they stand on.
void drawShipsBoat(const Ship& ship, double lengthM) {
  Builder& b = ship.b;
  constexpr double kBeam = 1.7, kDepth = 0.8, kKeelY = 0.2;
  constexpr int kRibs = 12, kGirth = 6;
  std::vector<std::vector<Vec3>> ribs;
  for (int i = 0; i <= kRibs; ++i) {
    const double out = 2.0 * i / kRibs - 1;  // from the stern, which is cut off square, to the bow
    const double full = std::sqrt(std::max(0.0, 1 - power(std::abs(out), 2.4)));
    const double half = std::max((out < 0 ? std::max(full, 0.45) : full) * kBeam * 0.5, 0.12);
    std::vector<Vec3>& rib = ribs.emplace_back();
    for (int j = kGirth; j >= -kGirth; --j) {
      const double angle = kHalfPi * j / kGirth;
      rib.emplace_back(lengthM * 0.5 * out, kKeelY + kDepth * (1 - std::cos(angle)) + 0.25 * out * out,
                       half * std::sin(angle));
    }
  }
  b.material(ship.m.oak);
  b.sheet(ribs, 0.06);
  b.material(ship.m.darkOak);
  for (const double share : {-0.25, -0.05, 0.15})
    b.box({lengthM * share - 0.12, kKeelY + kDepth * 0.75, -kBeam * 0.4}, {0.24, 0.06, kBeam * 0.8});
  for (const double share : {-0.25, 0.22}) b.box({lengthM * share - 0.1, -0.02, -0.6}, {0.2, 0.4, 1.2});
}

/// The main hatch between mainmast and forecastle, and the boat that is carried on it, where there is room for them.
void drawWaist(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const double from = plan.main.x + 1.6, to = plan.forecastle.fromX - 1.6;
  if (to - from < 2.5) return;
  const double middle = (from + to) * 0.5, length = std::min(to - from, 6.8);
  const Vec3 edge = plan.hull.sideAt(middle, plan.hull.depth);
  b.push([&] {
    b.translate({middle, edge.y + kCamber * edge.z * 0.8, 0});
    drawHatch(ship, length, 2.6);
    b.translate({0, 0.3, 0});
    drawShipsBoat(ship, length - 0.6);
  });
}

void drawCapstan(const Ship& ship, double x, double h) {
  Builder& b = ship.b;
  const Vec3 edge = ship.plan.hull.sideAt(x, h);
  b.push([&] {
    b.translate({x, edge.y + kCamber * edge.z, 0});
    b.material(ship.m.darkOak);
    const Vec2 profile[] = {{0.5, 0}, {0.5, 0.12}, {0.3, 0.2}, {0.24, 0.75}, {0.4, 0.85}, {0.4, 1.1}, {0.1, 1.16}};
    b.lathe(profile, {12, 0.7});
    b.material(ship.m.spar);
    for (int i = 0; i < 3; ++i) {
      const double angle = kHalfPi * 2 * i / 3;
      const Vec3 d(std::cos(angle), 0, std::sin(angle));
      const Vec2 bar[] = {{0.04, 0}, {0.05, 0.5}, {0.04, 1}};
      drawSpar(ship, d * -1.3 + Vec3(0, 0.98, 0), d * 1.3 + Vec3(0, 0.98, 0), bar, 6);
    }
  });
}

/// The sides of a castle with their rails and mouldings, between the rail below and the one above.
void drawCastleSides(const Ship& ship, const Topside& part, MaterialId paint, PartId window) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const MaterialId bands[] = {ship.m.oak, paint, paint, ship.m.oak};
  const Ring rail = rectangleRing({-0.3, -0.06}, {0.14, 0.08});
  const Ring moulding = rectangleRing({-0.1, -0.06}, {0.08, 0.06});
  for (const int side : kSides) {
    drawTopside(ship, part, bands, side);
    const auto from = [&](double h) { return part.fromStern ? hull.sternX(h) : part.fromX; };
    b.material(ship.m.darkOak);
    drawStrake(ship, rail, from(part.highH), part.toX + 0.1, part.highH, side);
    b.material(ship.m.ochre);
    for (const double share : {0.25, 0.75}) {
      const double h = part.lowH + (part.highH - part.lowH) * share;
      drawStrake(ship, moulding, from(h), part.toX, h, side);
    }
    // Small lights between the mouldings.
    const double lengthM = part.toX - part.fromX, h = part.lowH + (part.highH - part.lowH) * 0.5 - 0.28;
    const int count = static_cast<int>((lengthM - 1) / 1.9);
    for (int i = 0; i < count; ++i) {
      b.push([&] {
        enterSide(ship, part.fromX + lengthM * (i + 0.6) / (count + 0.2), h, side);
        b.translate({-0.27, 0, 0.02});
        b.place(window);
      });
    }
  }
}

}  // namespace

void buildCastles(const Ship& ship) {
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const PartId baluster = [&] {
    ship.b.material(ship.m.ochre);
    return makeBaluster(ship);
  }();
  const PartId window = makeWindow(ship, 0.54, 0.56);
  const PartId bulkheadWindow = makeWindow(ship, 0.7, 0.7);

  const MaterialId paints[] = {ship.m.red, ship.m.green, ship.m.red};
  double below = hull.depth;
  for (std::size_t i = 0; i < plan.stern.size(); ++i) {
    const Deck& deck = plan.stern[i];
    const Topside part{below + kBulwark, deck.h + kBulwark, true, 0, deck.toX};
    drawCastleSides(ship, part, paints[i], window);
    drawDeck(ship, hull.sternX(deck.h) + 0.02, deck.toX, deck.h);
    drawBulkhead(ship, deck.toX - 0.1, below, deck.h, true, bulkheadWindow);
    drawRailing(ship, deck.toX, deck.h, baluster);
    const double z = hull.sideAt(deck.toX, deck.h).z * 0.72;
    drawLadder(ship, deck.toX, below, deck.h, 1, z);
    drawLadder(ship, deck.toX, below, deck.h, 1, -z);
    below = deck.h;
  }
  const double cabin = hull.length * 0.05;
  for (std::size_t i = 0; i < plan.stern.size(); ++i) {
    const double h = plan.stern[i].h, y = hull.side(0, h).y;
    const double half = hull.side(0, h).z;
    nameBetween(ship, "SternDeck", {hull.sternX(hull.depth), y - plan.sternDeckHeight, -half}, {cabin, y, half});
  }
  const double top = plan.stern.back().h, half = hull.side(0, hull.depth).z;
  nameBetween(ship, "Sterncastle", {0, hull.side(0, hull.depth).y, -half}, {cabin, hull.side(0, top).y, half});

  const Deck& fore = plan.forecastle;
  drawCastleSides(ship, {hull.depth + kBulwark, fore.h + kBulwark, false, fore.fromX, fore.toX}, ship.m.green, window);
  drawDeck(ship, fore.fromX, fore.toX, fore.h);
  drawBulkhead(ship, fore.fromX + 0.1, hull.depth, fore.h, false, bulkheadWindow);
  drawBulkhead(ship, fore.toX, hull.depth, fore.h + kBulwark, true, bulkheadWindow);
  drawRailing(ship, fore.fromX + 0.24, fore.h, baluster);
  const double z = hull.sideAt(fore.fromX, fore.h).z * 0.6;
  drawLadder(ship, fore.fromX, hull.depth, fore.h, -1, z);
  drawLadder(ship, fore.fromX, hull.depth, fore.h, -1, -z);
  const Vec3 low = hull.sideAt(fore.fromX, hull.depth);
  nameBetween(ship, "Forecastle", {fore.fromX, low.y, -low.z}, {hull.length, low.y + fore.h - hull.depth, low.z});

  drawWaist(ship);
  drawCapstan(ship, plan.stern.front().toX * 0.88, plan.stern.front().h);
}

}  // namespace dimline::boat
