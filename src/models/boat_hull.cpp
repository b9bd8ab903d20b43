#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "models/boat_parts.h"

// The hull: planks over frames up to the main deck, and the timbers that hold it together.

namespace dimline::boat {

namespace {

constexpr int kStations = 44;
constexpr int kBottomStrakes = 9;  // from the keel to the wale, close together where the bilge turns
constexpr int kTopStrakes = 7;     // from the wale to the main deck
constexpr int kDeckStrakes = 4;    // on each side

/// Stations from stern to stem, closer together where the bow turns in.
double station(int i) { return 1 - power(1 - static_cast<double>(i) / kStations, 1.5); }

/// Heights of the strakes' edges, from the keel to the main deck. One of them is the waterline.
std::vector<double> strakeHeights(const HullForm& hull) {
  std::vector<double> heights;
  for (int j = 0; j < kBottomStrakes; ++j)
    heights.push_back(hull.wale() * (1 - power(std::cos(kPi * 0.5 * j / kBottomStrakes), 0.8)));
  for (int j = 0; j <= kTopStrakes; ++j) heights.push_back(hull.wale() + (hull.depth - hull.wale()) * j / kTopStrakes);
  *std::min_element(heights.begin() + 1, heights.end() - 1, [&](double a, double b) {
    return std::abs(a - hull.draught) < std::abs(b - hull.draught);
  }) = hull.draught;
  return heights;
}

std::vector<HullLine> linesAt(const HullForm& hull, std::span<const double> heights) {
  std::vector<HullLine> lines;
  for (const double h : heights) lines.emplace_back(hull, h);
  return lines;
}

/// Planking and main deck in one: each rib runs up the starboard side, across the deck and down the port side.
void drawPlanking(const Ship& ship) {
  const HullForm& hull = ship.plan.hull;
  const std::vector<double> heights = strakeHeights(hull);
  const std::size_t strakes = heights.size();
  const std::vector<HullLine> lines = linesAt(hull, heights);
  std::vector<std::vector<Vec3>> ribs;
  for (int i = 0; i <= kStations; ++i) {
    const double u = station(i);
    std::vector<Vec3>& rib = ribs.emplace_back();
    for (const HullLine& line : lines) rib.push_back(line.side(u));
    const Vec3 edge = rib.back();
    for (int j = 1; j < 2 * kDeckStrakes; ++j) {
      const double across = 1 - static_cast<double>(j) / kDeckStrakes;
      rib.emplace_back(edge.x, edge.y + kCamber * edge.z * (1 - across * across), edge.z * across);
    }
    for (std::size_t j = strakes; j-- > 0;) rib.push_back(mirrored(rib[j], -1));
  }
  // Tallow and sulphur below the water, against the worm; tarred between the wales.
  std::vector<MaterialId> bands;
  for (std::size_t j = 0; j + 1 < strakes; ++j) {
    const double h = (heights[j] + heights[j + 1]) * 0.5;
    bands.push_back(h < hull.draught ? ship.m.tallow : ship.m.oak);
  }
  std::vector<MaterialId> materials = bands;
  materials.insert(materials.end(), 2 * kDeckStrakes, ship.m.deck);
  materials.insert(materials.end(), bands.rbegin(), bands.rend());
  materials.push_back(ship.m.tallow);
  Builder::SkinOptions options;
  options.materials = materials;
  ship.b.material(ship.m.oak);
  ship.b.loft(ribs, options);
}

/// Keel, stem and sternpost in one piece, standing out from the planking.
void drawBackbone(const Ship& ship) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const double thick = 0.4, in = 0.5;
  const double stemHead = hull.side(1, hull.depth).y + kBulwark + 0.25;
  Ring outline;
  const auto stern = [&](double h) { return Vec2(hull.sternX(h), hull.side(0, h).y); };
  outline.push_back(stern(hull.depth) + Vec2(0.1, 0));
  outline.push_back(stern(hull.depth) + Vec2(-0.3, 0));
  outline.push_back(stern(0) + Vec2(-0.3, -kKeel));
  const int steps = 14;
  outline.emplace_back(hull.stemX(0) - 0.3, -kKeel);
  // Outside the stem by the keel's depth; the direction turns from down to ahead.
  const auto stem = [&](double angle) {
    const double h = hull.depth * (1 - std::cos(angle));
    return Vec2(hull.stemX(h), hull.side(1, h).y);
  };
  for (int i = 1; i <= steps; ++i) {
    const double angle = kPi * 0.5 * i / steps;
    outline.push_back(stem(angle) + kKeel * Vec2(std::sin(angle), -std::cos(angle)));
  }
  outline.emplace_back(hull.length + kKeel, stemHead);
  outline.emplace_back(hull.length - 0.25, stemHead);
  for (int i = steps; i >= 1; --i) {
    const double angle = kPi * 0.5 * i / steps;
    outline.push_back(stem(angle) - in * Vec2(std::sin(angle), -std::cos(angle)));
  }
  outline.emplace_back(hull.stemX(0) - 0.5, 0.3);
  outline.push_back(stern(0) + Vec2(0.6, 0.3));
  b.push([&] {
    b.translate({0, 0, -thick * 0.5});
    b.scale({0, 0, thick});
    b.material(ship.m.darkOak);
    b.extrudePolygon(outline, Axis::kZ, 0.5);
  });
}

void drawRudder(const Ship& ship) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const auto stern = [&](double h, double aft) { return Vec2(hull.sternX(h) - aft, hull.side(0, h).y); };
  b.push([&] {
    b.translate({0, 0, -0.13});
    b.scale({0, 0, 0.26});
    b.material(ship.m.oak);
    const Ring blade{stern(0, 0.36) - Vec2(0, kKeel * 0.8), stern(hull.depth * 0.94, 0.36),
                     stern(hull.depth * 0.94, 0.75),        stern(hull.depth * 0.5, 1.2),
                     stern(hull.depth * 0.18, 1.75),        stern(0, 1.75) - Vec2(0, kKeel * 0.8)};
    b.extrudePolygon(blade);
    b.material(ship.m.iron);
    for (const double share : {0.1, 0.35, 0.6, 0.85}) {
      const Vec2 at = stern(hull.depth * share, 0);
      b.push([&] {
        b.translate({at.x, at.y, 0});
        b.rotate(Axis::kZ, std::atan(kSternRake));
        b.box({-1.1, -0.06, -0.04}, {1.2, 0.12, 0.34});
      });
    }
  });
}

/// Wales, rails and mouldings along both sides.
void drawWales(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const Ring wale = rectangleRing({-0.2, -0.19}, {0.13, 0.19});
  const Ring moulding = rectangleRing({-0.15, -0.07}, {0.09, 0.07});
  const Ring rail = rectangleRing({-0.3, -0.06}, {0.14, 0.08});
  for (const int side : kSides) {
    b.material(ship.m.tar);
    for (const double h : {hull.wale() - 0.25, hull.wale() + 0.35, 0.86 * hull.depth})
      drawStrake(ship, wale, hull.sternX(h) + 0.03 * hull.length * (hull.depth - h) / hull.wale(), hull.length, h,
                 side);
    b.material(ship.m.ochre);
    drawStrake(ship, moulding, 0, hull.length, hull.depth + 0.06, side);
    // The rail along the waist, up to the castles.
    b.material(ship.m.darkOak);
    const double from = plan.stern.front().toX;
    drawStrake(ship, rail, from, plan.forecastle.fromX, hull.depth + kBulwark, side);
    drawStrake(ship, rail, plan.forecastle.toX - 0.4, hull.length, hull.depth + kBulwark, side);
  }
}

/// The sides above the main deck, all along the ship.
void drawBulwarks(const Ship& ship) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const double strakes[] = {hull.depth - 0.05, hull.depth + 0.5, hull.depth + kBulwark};
  const std::vector<HullLine> lines = linesAt(hull, strakes);
  for (const int side : kSides) {
    std::vector<std::vector<Vec3>> rows;
    for (int i = 0; i <= kStations; ++i) {
      std::vector<Vec3>& row = rows.emplace_back();
      const double u = std::min(station(i), 0.999);
      for (const HullLine& line : lines) row.push_back(mirrored(line.side(u), side));
      // Rows go forward. Their points must run to the right seen from outside when the next row is up: down to starboard.
      if (side > 0) std::reverse(row.begin(), row.end());
    }
    b.material(ship.m.oak);
    b.sheet(rows, kPlank);
  }
}

/// Keel blocks, and shores on both sides.
void drawBlocks(const Ship& ship) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  b.material(ship.m.darkOak);
  const int blocks = 7;
  for (int i = 0; i < blocks; ++i) {
    const double x = hull.length * (0.07 + 0.74 * i / (blocks - 1));
    b.box({x - 0.35, -kKeel - kBlocks, -0.9}, {0.7, kBlocks, 1.8});
  }
  b.material(ship.m.spar);
  for (const int side : kSides) {
    for (const double share : {0.2, 0.36, 0.52, 0.68, 0.8}) {
      const double x = hull.length * share;
      const Vec3 head = mirrored(hull.sideAt(x, hull.wale() * 0.62), side);
      const Vec3 foot(x, -kKeel - kBlocks, head.z + side * (0.25 * hull.depth + 0.6));
      const Vec2 profile[] = {{0.16, 0}, {0.13, 1}};
      drawSpar(ship, foot + Vec3(0, 0.12, 0), head, profile, 8);
      b.box({foot.x - 0.4, foot.y, foot.z - 0.3}, {0.8, 0.18, 0.6});
    }
  }
}

}  // namespace

void buildHull(const Ship& ship) {
  const HullForm& hull = ship.plan.hull;
  drawPlanking(ship);
  drawBackbone(ship);
  drawRudder(ship);
  drawWales(ship);
  drawBulwarks(ship);
  drawBlocks(ship);

  const double half = hull.beam * 0.5;
  nameBetween(ship, "Hull", {0, 0, -half}, {hull.length, hull.depth, half});
  nameBetween(ship, "Midship", {hull.length * 0.5 - 1, 0, -half}, {hull.length * 0.5 + 1, hull.depth, half});
  nameBetween(ship, "Waterline", {hull.length * 0.5 - 1, 0, -half}, {hull.length * 0.5 + 1, hull.draught, half});
  const double sternHalf = hull.side(0, hull.depth).z;
  nameBetween(ship, "Sheer", {0, hull.depth, -sternHalf}, {0.3, hull.depth + hull.sheer, sternHalf});
}

}  // namespace dimline::boat
