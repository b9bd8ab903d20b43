#include <algorithm>
#include <cmath>

#include "models/boat_parts.h"

// The stern seen from aft: the transom with the cabins' windows, the gallery, taffrail, lanterns and the ensign.

namespace dimline::boat {

namespace {

/// The transom's own coordinates: x to starboard from the middle, y up along its lean from the main deck, z outwards.
struct Transom {
  const HullForm& hull;

  [[nodiscard]] static double slope() { return std::sqrt(1 + kSternRake * kSternRake); }
  [[nodiscard]] double y(double h) const { return (hull.side(0, h).y - hull.side(0, hull.depth).y) * slope(); }
  [[nodiscard]] double half(double h) const { return hull.side(0, h).z; }

  void enter(Builder& b) const {
    const Vec3 starboard(0, 0, 1), up = glm::normalize(Vec3(-kSternRake, 1, 0));
    enterFrame(b, {0, hull.side(0, hull.depth).y, 0}, {starboard, up, glm::cross(starboard, up)});
  }
};

double topH(const Plan& plan) { return plan.stern.back().h + kBulwark; }

/// The transom's planks, from the tuck up to the taffrail's curve.
void drawPanel(const Ship& ship, const Transom& t) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const double low = hull.tuck(), main = hull.depth, top = topH(ship.plan);
  const auto outline = [&](double fromH, double toH, bool arched) {
    constexpr int kSteps = 7;
    Ring ring;
    for (int i = 0; i <= kSteps; ++i) {
      const double h = fromH + (toH - fromH) * i / kSteps;
      if (t.half(h) > 0.02) ring.emplace_back(t.half(h) + 0.03, t.y(h));
    }
    const double half = t.half(toH), y = t.y(toH);
    if (arched) {
      for (int i = 1; i < 10; ++i) {
        const double across = 1 - 0.2 * i, bow = 1 - across * across;
        ring.emplace_back(half * across, y + 0.95 * bow * bow + 0.12);
      }
    }
    for (int i = kSteps; i >= 0; --i) {
      const double h = fromH + (toH - fromH) * i / kSteps;
      if (t.half(h) > 0.02) ring.emplace_back(-t.half(h) - 0.03, t.y(h));
    }
    return ring;
  };
  b.push([&] {
    b.translate({0, 0, -0.1});
    b.scale({0, 0, 0.16});
    b.material(ship.m.oak);
    b.extrudePolygon(outline(low, main, false));
    b.material(ship.m.red);
    b.extrudePolygon(outline(main, top, true));
  });
}

/// A cabin window: a gilt frame, leaded bars, glass behind them. Scope of the part: the opening.
PartId makeCabinWindow(const Ship& ship, double width, double height) {
  Builder& b = ship.b;
  return b.part({width, height, 0.12}, [&] {
    const double f = 0.09;
    b.material(ship.m.glass);
    b.box({0, 0, 0}, {width, height, 0.03});
    b.material(ship.m.gilt);
    b.extrudePolygon(
        Polygon{rectangleRing({-f, -f}, {width + f, height + f}), {rectangleRing({0, 0}, {width, height})}});
    b.box({-f - 0.05, -f - 0.08, 0}, {width + 2 * f + 0.1, 0.08, 0.18});
    b.box({-f - 0.05, height + f, 0}, {width + 2 * f + 0.1, 0.08, 0.2});
    b.material(ship.m.darkOak);
    for (int i = 1; i < 3; ++i) b.box({width * i / 3 - 0.014, 0, 0.03}, {0.028, height, 0.03});
    for (int i = 1; i < 4; ++i) b.box({0, height * i / 4 - 0.014, 0.03}, {width, 0.028, 0.03});
  });
}

void drawWindows(const Ship& ship, const Transom& t) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const double dh = plan.sternDeckHeight, height = dh - 1.05, width = 0.62;
  const PartId window = makeCabinWindow(ship, width, height);
  for (std::size_t i = 0; i < plan.stern.size(); ++i) {
    const double floor = plan.hull.depth + static_cast<double>(i) * dh, sill = floor + 0.68;
    const double half = std::min(t.half(sill), t.half(sill + height)) - 0.35;
    b.push([&] {
      b.translate({-half, t.y(sill), 0.06});
      b.scale({2 * half, height, 0});
      b.repeat(Axis::kX, 1.2, [&](int, int) {
        b.translate({(b.size().x - width) * 0.5, 0, 0});
        b.place(window);
      });
    });
    // The string at the cabin's floor, and the carved frieze under the windows.
    const double y = t.y(floor), at = t.half(floor) + 0.1;
    b.material(ship.m.gilt);
    b.box({-at, y - 0.1, 0}, {2 * at, 0.2, 0.17});
    b.material(ship.m.green);
    const double friezeHalf = t.half(floor + 0.4) - 0.05;
    b.box({-friezeHalf, y + 0.14, 0}, {2 * friezeHalf, 0.28, 0.09});
  }
}

/// A walk outside the great cabin's windows, on brackets.
void drawGallery(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const double h = hull.depth + (plan.stern.size() > 1 ? plan.sternDeckHeight : 0.0) + 0.12;
  const Vec3 corner = hull.side(0, h);
  const double half = corner.z + 0.35, x = corner.x - plan.gallery, y = corner.y, rail = 0.94;
  b.material(ship.m.darkOak);
  b.box({x, y - 0.12, -half}, {plan.gallery + 0.12, 0.12, 2 * half});
  b.material(ship.m.gilt);
  b.box({x - 0.05, y - 0.2, -half - 0.05}, {plan.gallery + 0.05, 0.14, 2 * half + 0.1});
  b.material(ship.m.ochre);
  const PartId baluster = b.part({0.16, 0.78, 0.16}, [&] {
    const Vec2 profile[] = {{0.06, 0}, {0.06, 0.1}, {0.03, 0.18}, {0.07, 0.36}, {0.03, 0.62}, {0.06, 0.78}};
    b.lathe(profile, {8, 0.9});
  });
  b.push([&] {
    b.translate({x, y, -half});
    b.scale({0.16, rail, 2 * half});
    b.repeat(Axis::kZ, 0.36, [&](int, int) {
      b.translate({0, 0.02, b.size().z * 0.5 - 0.08});
      b.place(baluster);
    });
    b.material(ship.m.darkOak);
    b.box({-0.04, 0.8, -0.04}, {0.24, 0.11, 2 * half + 0.08});
    b.material(ship.m.ochre);
    for (const double z : {0.02, 2 * half - 0.18}) {
      b.push([&] {
        b.translate({0.2, 0.02, z});
        b.scale({plan.gallery - 0.2, rail, 0.16});
        b.repeat(Axis::kX, 0.36, [&](int, int) {
          b.translate({b.size().x * 0.5 - 0.08, 0, 0});
          b.place(baluster);
        });
      });
      b.push([&] {
        b.material(ship.m.darkOak);
        b.box({0.1, 0.8, z - 0.04}, {plan.gallery + 0.1, 0.11, 0.24});
      });
    }
  });
  // Brackets: scrolls from the transom out to the gallery's edge.
  b.material(ship.m.gilt);
  const int count = repeatCount(2 * half, 1.15);
  for (int i = 0; i < count; ++i) {
    const double z = -half + 2 * half * (i + 0.5) / count, drop = 0.45 + 0.3 * plan.gallery, g = plan.gallery;
    b.push([&] {
      b.translate({corner.x, y - 0.18, z - 0.08});
      b.scale({0, 0, 0.16});
      b.extrudePolygon(Ring{{0.12 + 0.2 * drop, -drop},
                            {0.2, 0},
                            {-g + 0.08, 0},
                            {-g + 0.08, -0.14},
                            {-g * 0.72, -0.22},
                            {-g * 0.4, -0.24 * drop - 0.1},
                            {-g * 0.14, -0.62 * drop},
                            {-0.02 + 0.1 * drop, -drop}},
                       Axis::kZ, 0.7);
    });
  }
  nameBetween(ship, "Gallery", {x, y - 0.12, -half}, {corner.x, y + rail, half});
}

/// A lantern on its bracket. Scope: the foot of its post.
void drawLantern(const Ship& ship, double scale) {
  Builder& b = ship.b;
  const auto scaled = [&](std::initializer_list<Vec2> profile) {
    std::vector<Vec2> result;
    for (const Vec2& p : profile) result.push_back(p * scale);
    return result;
  };
  b.material(ship.m.gilt);
  b.lathe(scaled({{0.05, 0}, {0.05, 0.5}, {0.2, 0.62}, {0.3, 0.7}, {0.3, 0.76}}), {8, 0.6});
  b.material(ship.m.light);
  b.lathe(scaled({{0.26, 0.74}, {0.36, 1.35}}), {8, 0.6});
  b.material(ship.m.gilt);
  b.lathe(scaled({{0.4, 1.33}, {0.4, 1.4}, {0.28, 1.52}, {0.12, 1.66}, {0.05, 1.74}, {0.08, 1.82}, {0, 1.95}}),
          {8, 0.6});
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.785398163397448 * i;
    const Vec3 d(std::cos(angle), 0, std::sin(angle));
    const Vec2 bar[] = {{0.022 * scale, 0}, {0.022 * scale, 1}};
    drawSpar(ship, (d * 0.29 + Vec3(0, 0.74, 0)) * scale, (d * 0.385 + Vec3(0, 1.35, 0)) * scale, bar, 4);
  }
}

void drawTaffrail(const Ship& ship, const Transom& t) {
  Builder& b = ship.b;
  const double top = topH(ship.plan), half = t.half(top), y = t.y(top);
  // A moulding along the arch, and carving under it: a shield between two scrolls.
  std::vector<Vec3> arch;
  for (int i = 0; i <= 20; ++i) {
    const double across = 1 - 0.1 * i, bow = 1 - across * across;
    arch.emplace_back(half * across, y + 0.95 * bow * bow + 0.12, -0.02);
  }
  Builder::SweepOptions options;
  options.up = {0, 0, 1};
  options.bendRad = 0.5;
  b.material(ship.m.gilt);
  b.sweep(ellipseRing({0, 0}, {0.11, 0.17}, 8), arch, options);
  b.push([&] {
    b.translate({0, y - 0.42, 0});
    b.scale({0, 0, 0.16});
    b.extrudePolygon(Ring{{0, -0.1},
                          {0.3, 0.12},
                          {0.42, 0.5},
                          {0.42, 1.0},
                          {0.2, 0.94},
                          {0, 1.02},
                          {-0.2, 0.94},
                          {-0.42, 1.0},
                          {-0.42, 0.5},
                          {-0.3, 0.12}});
    b.material(ship.m.flagRed);
    b.scale({0, 0, 0.2});
    b.extrudePolygon(
        Ring{{0, 0.05}, {0.22, 0.2}, {0.32, 0.52}, {0.32, 0.88}, {0, 0.9}, {-0.32, 0.88}, {-0.32, 0.52}, {-0.22, 0.2}});
  });
  b.material(ship.m.gilt);
  for (const int side : kSides) {
    const double reach = std::max(half - 0.95, 0.25);
    std::vector<Vec3> scroll;
    for (int i = 0; i <= 16; ++i) {
      const double s = i / 16.0, angle = 7.6 * s * s;
      const double radius = 0.30 * (1 - 0.72 * s);
      scroll.emplace_back(side * (0.55 + reach * std::min(1.0, 1.6 * s) - radius * std::sin(angle)),
                          y + 0.05 + 0.1 * (1 - s) - 0.25 * s + radius * std::cos(angle), 0.1);
    }
    b.sweep(ellipseRing({0, 0}, {0.06, 0.06}, 6), scroll, options);
  }
}

}  // namespace

void buildStern(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const Transom transom{plan.hull};
  b.push([&] {
    transom.enter(b);
    drawPanel(ship, transom);
    drawWindows(ship, transom);
    drawTaffrail(ship, transom);
  });
  drawGallery(ship);
  const double top = topH(plan);
  const Vec3 corner = plan.hull.side(0, top);
  for (const double z : {-0.8, 0.0, 0.8}) {
    b.push([&] {
      b.translate({corner.x - 0.05, corner.y + (z == 0 ? 1.05 : 0.3), corner.z * z});
      drawLantern(ship, z == 0 ? 0.95 : 0.7);
    });
  }
  // The ensign's staff leans aft with the transom.
  const Vec3 foot(corner.x + 0.55, corner.y - kBulwark, 0), head = foot + Vec3(-0.9, 5.6, 0);
  const Vec2 staff[] = {{0.09, 0}, {0.06, 0.98}, {0.1, 0.985}, {0.1, 0.995}, {0, 1}};
  b.material(ship.m.spar);
  drawSpar(ship, foot, head, staff, 8);
  const MaterialId stripes[] = {ship.m.flagBlue, ship.m.flagWhite, ship.m.flagRed};
  std::vector<std::vector<Vec3>> rows;
  const double fly = 3.6, hoist = 2.1;
  for (int i = 0; i <= 12; ++i) {
    const double s = i / 12.0;
    std::vector<Vec3>& row = rows.emplace_back();
    for (int j = 3; j >= 0; --j) {
      const Vec3 at = glm::mix(head, foot, 0.03 + hoist / 5.7 * (1 - j / 3.0));
      row.push_back(at + Vec3(fly * s, -0.35 * s * s, 0.28 * s * std::sin(5.5 * s + 0.5 * j)));
    }
  }
  Builder::SkinOptions options;
  options.materials = stripes;
  for (auto& row : rows) std::reverse(row.begin(), row.end());
  b.sheet(rows, 0.03, options);
}

}  // namespace dimline::boat
