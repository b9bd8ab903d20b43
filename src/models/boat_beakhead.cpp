#include <algorithm>
#include <cmath>

#include "models/boat_parts.h"

// The beakhead: a low spur before the stem, on a knee of timbers and between rails that draw together to the figurehead.

namespace dimline::boat {

namespace {

/// Between two points, hanging below the straight line between them.
std::vector<Vec3> sagging(const Vec3& from, const Vec3& to, double sagM, int steps) {
  std::vector<Vec3> way;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    way.push_back(glm::mix(from, to, t) - Vec3(0, sagM * 4 * t * (1 - t), 0));
  }
  return way;
}

/// The lion at the end, leaning forward. Scope: the beak's tip.
void drawFigurehead(const Ship& ship) {
  Builder& b = ship.b;
  b.material(ship.m.gilt);
  const auto ball = [&](const Vec3& middle, const Vec3& size, int segments) {
    b.push([&] {
      b.translate(middle - size * 0.5);
      b.scale(size);
      b.sphere({segments, 0.9});
    });
  };
  b.push([&] {
    b.rotate(Axis::kZ, 0.5);
    ball({-0.6, 0.05, 0}, {1.8, 0.56, 0.54}, 14);  // the body
    ball({0.12, 0.24, 0}, {0.7, 1.0, 0.84}, 14);   // the mane, in two
    ball({0.3, 0.4, 0}, {0.56, 0.84, 0.72}, 14);
    ball({0.56, 0.4, 0}, {0.44, 0.46, 0.42}, 12);  // the head
    ball({0.76, 0.32, 0}, {0.4, 0.24, 0.26}, 10);  // the muzzle
    ball({0.72, 0.17, 0}, {0.3, 0.1, 0.2}, 8);     // and its jaw
    for (const int side : kSides) {
      const Vec2 leg[] = {{0.14, 0}, {0.1, 0.7}, {0.15, 0.86}, {0.1, 1}};
      drawSpar(ship, {-0.05, -0.05, 0.24 * side}, {0.75, -0.22, 0.2 * side}, leg, 8);
    }
  });
}

}  // namespace

void buildBeakhead(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const double length = hull.length, beak = plan.beak;
  const double deckY = hull.side(1, hull.depth).y;
  const Vec3 tip(length + beak, deckY + 0.25 + 0.06 * beak, 0);

  // The knee: from the stem out to the tip, hollow below.
  Ring knee;
  const double kneeH = 0.5 * hull.depth;
  const Vec2 root(hull.stemX(kneeH), hull.side(1, kneeH).y);
  knee.push_back(root);
  constexpr int kSteps = 9;
  for (int i = 1; i < kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    // A curve that leaves the stem downwards and ahead and comes up to the tip.
    const Vec2 bend(length + 0.62 * beak, root.y + 0.30 * (tip.y - root.y));
    const Vec2 at = root * ((1 - t) * (1 - t)) + bend * (2 * t * (1 - t)) + Vec2(tip.x, tip.y - 0.5) * (t * t);
    knee.push_back(at);
  }
  knee.emplace_back(tip.x, tip.y - 0.5);
  knee.emplace_back(tip.x, tip.y);
  knee.emplace_back(length + 0.45 * beak, tip.y - 0.22);
  knee.emplace_back(length - 0.3, deckY + 0.1);
  b.push([&] {
    b.translate({0, 0, -0.17});
    b.scale({0, 0, 0.34});
    b.material(ship.m.darkOak);
    b.extrudePolygon(knee, Axis::kZ, 0.5);
  });

  const double rootX = length - 0.9;
  const auto bowAt = [&](double h, int side) { return mirrored(hull.sideAt(rootX, h), side); };
  Builder::SweepOptions options;
  options.bendRad = 0.6;
  for (const int side : kSides) {
    struct Rail {
      double h, drop, sag;
      MaterialId material;
    };
    const Rail rails[] = {{hull.depth + 0.95, -0.12, 0.10 * beak, ship.m.ochre},
                          {hull.depth + 0.2, 0.22, 0.07 * beak, ship.m.darkOak},
                          {hull.depth * 0.9, 0.46, 0.05 * beak, ship.m.ochre}};
    std::vector<std::vector<Vec3>> ways;
    for (const Rail& rail : rails) {
      const Vec3 from = bowAt(rail.h, side);
      ways.push_back(sagging(from, tip + Vec3(-0.15, -rail.drop, 0.16 * side), rail.sag, 12));
      b.material(rail.material);
      b.sweep(rectangleRing({-0.08, -0.11}, {0.08, 0.11}), ways.back(), options);
    }
    // Timbers that carry the rails.
    b.material(ship.m.darkOak);
    for (const std::size_t at : {2U, 4U, 6U, 8U, 10U}) {
      const Vec3 way[] = {ways[0][at] + Vec3(0, 0.08, 0), ways[1][at], ways[2][at] - Vec3(0, 0.08, 0)};
      Builder::SweepOptions upright;
      upright.up = {1, 0, 0};
      b.sweep(rectangleRing({-0.06, -0.09}, {0.06, 0.09}), way, upright);
    }
  }
  // The platform: a grating that narrows with the rails.
  const double broad = hull.sideAt(rootX, hull.depth).z;
  const auto halfAt = [&](double t) { return broad + (0.16 - broad) * t - 0.03; };
  const int bars = std::max(6, static_cast<int>(std::lround(beak / 0.3)));
  const auto platformY = [&](double t) {
    return glm::mix(deckY + 0.15, tip.y - 0.2, t) - 0.07 * beak * 4 * t * (1 - t);
  };
  const auto platformX = [&](double t) { return rootX + (tip.x - 0.15 - rootX) * t; };
  b.material(ship.m.deck);
  for (int i = 1; i < bars; ++i) {
    const double t = static_cast<double>(i) / bars;
    if (halfAt(t) < 0.25) break;
    b.box({platformX(t) - 0.06, platformY(t), -halfAt(t)}, {0.12, 0.07, 2 * halfAt(t)});
  }
  for (const double share : {-0.66, -0.33, 0.33, 0.66}) {
    std::vector<Vec3> way;
    for (int i = 0; i <= 6; ++i) {
      const double t = 0.9 * i / 6;
      way.emplace_back(platformX(t), platformY(t) + 0.06, halfAt(t) * share);
    }
    b.sweep(rectangleRing({-0.05, -0.05}, {0.05, 0.05}), way, options);
  }
  b.push([&] {
    b.translate(tip + Vec3(0.1, 0.1, 0));
    drawFigurehead(ship);
  });
  nameBetween(ship, "Beakhead", {length, tip.y - 0.9, -broad}, {tip.x, tip.y + 0.2, broad});
}

}  // namespace dimline::boat
