#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "models/boat_parts.h"

// Masts, spars, sails and flags. The wind is from astern: sails belly forward, flags stream forward.

namespace dimline::boat {

namespace {

// --- Sails ---------------------------------------------------------------------------------------------------------------

void drawCross(const Ship& ship, const SailSurface& surface) {
  Builder& b = ship.b;
  b.material(ship.m.flagRed);
  const double height = surface.sail.yardY - surface.sail.footY, width = surface.sail.headWidth;
  const double arm = 0.3 * std::min(height, width);  // half the length of its arms, and a sixth of that their width
  const auto bar = [&](double halfAcrossM, double halfDownM, int columns, int rows) {
    std::vector<std::vector<Vec3>> grid;
    for (int i = 0; i <= rows; ++i) {
      std::vector<Vec3>& row = grid.emplace_back();
      const double down = 0.52 + halfDownM / height * (1 - 2.0 * i / rows);
      for (int j = 0; j <= columns; ++j) {
        // Broader at its ends, like the crosses on Portuguese sails.
        const double s = 2.0 * j / columns - 1, t = 1 - 2.0 * i / rows;
        const bool level = halfAcrossM > halfDownM;
        const double flare = 1 + 0.7 * power(std::abs(level ? s : t), 3.0);
        const double acrossM = halfAcrossM * s * (level ? 1 : flare);
        const double at = level ? 0.52 + halfDownM * flare / height * t : down;
        row.push_back(surface.at(-2 * acrossM / width, at) + Vec3(0.045, 0, 0));
      }
    }
    b.sheet(grid, 0.12);
  };
  bar(arm, arm / 6, 10, 2);
  bar(arm / 6, arm, 2, 10);
}

/// A sail is sewn of cloths side by side, which weather differently.
std::vector<MaterialId> clothMaterials(const Ship& ship, int count) {
  std::vector<MaterialId> materials;
  for (int j = 0; j < count; ++j) materials.push_back(j % 2 == 0 ? ship.m.canvas : ship.m.cloth);
  return materials;
}

void drawCloths(const Ship& ship, const SailSurface& surface, int cloths, int rowCount) {
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i <= rowCount; ++i) {
    std::vector<Vec3>& row = rows.emplace_back();
    const double down = 1 - static_cast<double>(i) / rowCount;
    for (int j = 0; j <= cloths; ++j) row.push_back(surface.at(1 - 2.0 * j / cloths, down));
  }
  const std::vector<MaterialId> materials = clothMaterials(ship, cloths);
  Builder::SkinOptions options;
  options.materials = materials;
  ship.b.sheet(rows, 0.03, options);
}

void drawSail(const Ship& ship, const SailSurface& surface, PartId reefPoint, std::span<const double> reefs, bool cross) {
  Builder& b = ship.b;
  const SquareSail& sail = surface.sail;
  const int cloths = std::clamp(static_cast<int>(std::lround(sail.footWidth / 1.05)), 8, 18);
  drawCloths(ship, surface, cloths, 8);

  // The bolt rope, down one leech, along the foot and up the other.
  b.material(ship.m.hemp);
  std::vector<Vec3> edge;
  for (int i = 0; i <= 8; ++i) edge.push_back(surface.at(-1, i / 8.0));
  for (int j = 1; j <= 14; ++j) edge.push_back(surface.at(-1 + j / 7.0, 1));
  for (int i = 1; i <= 8; ++i) edge.push_back(surface.at(1, 1 - i / 8.0));
  drawRope(ship, edge, 0.05, 3);

  // Reef points, which hang on both sides of the cloth at each seam.
  for (const double down : reefs) {
    for (int j = 1; j < cloths; ++j) {
      const double across = 2.0 * j / cloths - 1;
      const Vec3 here = surface.at(across, down), below = surface.at(across, down + 0.05);
      const Vec3 fall = glm::normalize(here - below), aside(0, 0, 1), out = glm::normalize(glm::cross(fall, aside));
      b.push([&] {
        enterFrame(b, here, {-out, fall, glm::cross(-out, fall)});
        b.place(reefPoint);
      });
    }
  }
  if (cross) drawCross(ship, surface);
}

/// A yard across the ship, with the sail's head laced to it.
void drawYard(const Ship& ship, double x, double y, double length, double radius) {
  const double r = radius;
  const Vec2 profile[] = {{0.4 * r, 0}, {0.62 * r, 0.12}, {0.9 * r, 0.3},   {r, 0.44},
                          {r, 0.56},    {0.9 * r, 0.7},   {0.62 * r, 0.88}, {0.4 * r, 1}};
  ship.b.material(ship.m.spar);
  drawSpar(ship, {x, y, -length * 0.5}, {x, y, length * 0.5}, profile, 10);
}

// --- Masts ---------------------------------------------------------------------------------------------------------------

/// The platform at a masthead, where shrouds are spread. Scope: the ship's.
void drawTop(const Ship& ship, const Vec3& at, double radius, bool railed) {
  Builder& b = ship.b;
  b.push([&] {
    b.translate(at);
    b.material(ship.m.darkOak);
    const double r = radius;
    const Vec2 bowl[] = {{0.45 * r, -0.35 * r}, {0.75 * r, -0.1}, {r, 0}, {r, 0.1}, {0, 0.1}};
    b.lathe(bowl, {16, 0.5});
    if (!railed) return;
    b.material(ship.m.ochre);
    std::vector<Vec3> hoop;
    for (int i = 0; i < 16; ++i) hoop.emplace_back(r * std::cos(kPi * 0.125 * i), 0.66, r * std::sin(kPi * 0.125 * i));
    Builder::SweepOptions options;
    options.closed = true;
    options.bendRad = 0.5;
    b.sweep(rectangleRing({-0.05, -0.05}, {0.05, 0.05}), hoop, options);
    const PartId post = b.part({0.08, 0.54, 0.08}, [&] { b.box({-0.035, 0, -0.035}, {0.07, 0.54, 0.07}); });
    for (int i = 0; i < 10; ++i) {
      b.push([&] {
        b.translate({r * 0.98 * std::cos(kPi * 0.2 * i), 0.1, r * 0.98 * std::sin(kPi * 0.2 * i)});
        b.place(post);
      });
    }
  });
}

/// The block that joins a mast to the one above it. `gap`: between the two middles.
void drawCap(const Ship& ship, const Vec3& at, double radius, double gap) {
  ship.b.material(ship.m.tar);
  ship.b.box(at + Vec3(-1.6 * radius, -0.14, -1.5 * radius), {3.0 * radius + gap, 0.28, 3 * radius});
}

/// A pole of a mast between two heights, tapered.
void drawPole(const Ship& ship, const Mast& mast, double x, double from, double to, double lowRadius, double highRadius,
              int segments) {
  const Vec2 profile[] = {
      {lowRadius, 0}, {lowRadius * 0.985, 0.3}, {(lowRadius + highRadius) * 0.49, 0.7}, {highRadius, 1}};
  ship.b.material(ship.m.spar);
  drawSpar(ship, {x, mast.deckY + from * mast.height, 0}, {x, mast.deckY + to * mast.height, 0}, profile, segments);
}

/// Iron hoops and rope wooldings, which keep a made mast together.
void drawWooldings(const Ship& ship, const Mast& mast, PartId hoop) {
  for (int i = 0; i < 5; ++i) {
    ship.b.push([&] {
      ship.b.translate({mast.x, mast.deckY + mast.height * (0.06 + 0.065 * i), 0});
      ship.b.place(hoop);
    });
  }
}

void drawPennant(const Ship& ship, const Vec3& head, double fly, MaterialId material) {
  std::vector<std::vector<Vec3>> rows;
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = static_cast<double>(i) / kSteps, half = 0.28 * (1 - 0.75 * s);
    const Vec3 middle =
        head + Vec3(fly * s, -0.4 - 0.14 * fly * s * s + 0.1 * std::sin(9 * s), 0.07 * fly * s * std::sin(8 * s));
    rows.push_back({middle + Vec3(0, half, 0), middle - Vec3(0, half, 0)});
  }
  ship.b.material(material);
  ship.b.sheet(rows, 0.025);
}

void drawTruck(const Ship& ship, const Mast& mast, double x) {
  ship.b.push([&] {
    ship.b.translate({x, mast.truckY() - 0.16, 0});
    ship.b.material(ship.m.gilt);
    const Vec2 profile[] = {{0.06, 0}, {0.17, 0.05}, {0.17, 0.11}, {0.06, 0.16}};
    ship.b.lathe(profile, {10, 0.7});
  });
}

void nameMast(const Ship& ship, const Mast& mast, std::string_view name) {
  const double r = mast.radius;
  nameBetween(ship, name, {mast.x - r, mast.deckY, -r}, {mast.x + r, mast.truckY(), r});
}

void drawSquareMast(const Ship& ship, const Mast& mast, std::string_view name, PartId reefPoint, bool cross) {
  Builder& b = ship.b;
  const double r = mast.radius;
  const double xTop = mast.topmastX(), xGallant = mast.gallantX();
  drawPole(ship, mast, mast.x, -0.02, 0.50, r, 0.78 * r, 16);
  drawPole(ship, mast, xTop, 0.435, 0.775, 0.66 * r, 0.46 * r, 12);
  drawPole(ship, mast, xGallant, 0.735, 0.995, 0.38 * r, 0.2 * r, 10);
  b.material(ship.m.hemp);
  const PartId hoop = b.part(Vec3(0.0), [&] {
    const Vec2 band[] = {{r * 0.9, 0}, {r * 1.04, 0.02}, {r * 1.04, 0.26}, {r * 0.9, 0.28}};
    b.lathe(band, {16, 0.9});
  });
  drawWooldings(ship, mast, hoop);
  drawTop(ship, {mast.x + 0.4 * r, mast.topY(), 0}, mast.topRadius(), true);
  drawCap(ship, {mast.x, mast.deckY + 0.495 * mast.height, 0}, 0.8 * r, 1.55 * r);
  drawTop(ship, {xTop + 0.2 * r, mast.deckY + 0.745 * mast.height, 0}, mast.topRadius() * 0.5, false);
  drawCap(ship, {xTop, mast.deckY + 0.772 * mast.height, 0}, 0.5 * r, 1.0 * r);
  drawTruck(ship, mast, xGallant);

  for (std::size_t i = 0; i < mast.sails.size(); ++i) {
    drawYard(ship, mast.yardX(i), mast.sails[i].yardY, mast.sails[i].headWidth * 1.1, mast.yardRadius(i));
    const double reefs[] = {0.17, 0.31};
    const std::size_t bands = i == 0 ? 1 : i == 1 ? 2 : 0;
    drawSail(ship, mast.sailSurface(i), reefPoint, std::span(reefs, bands), cross && i == 0);
  }
  nameMast(ship, mast, name);
}

/// A mast with a lateen sail, whose yard slopes up and aft.
void drawLateenMast(const Ship& ship, const Mast& mast, std::string_view name) {
  Builder& b = ship.b;
  const double r = mast.radius;
  drawPole(ship, mast, mast.x, -0.03, 0.64, r, 0.72 * r, 14);
  drawPole(ship, mast, mast.x + 1.4 * r, 0.57, 0.995, 0.56 * r, 0.26 * r, 10);
  drawTop(ship, {mast.x + 0.4 * r, mast.deckY + 0.575 * mast.height, 0}, mast.topRadius() * 0.85, true);
  drawCap(ship, {mast.x, mast.deckY + 0.635 * mast.height, 0}, 0.75 * r, 1.4 * r);
  drawTruck(ship, mast, mast.x + 1.4 * r);

  // It crosses the mast under the top; its lower end must stay clear of the deck.
  const double length = mast.lateenYard, crossY = mast.deckY + 0.5 * mast.height, z = r + 0.2;
  const double below = 0.4 * length, room = 0.5 * mast.height - 1.9;
  const double slope = std::min(std::asin(std::clamp(room / below, 0.0, 1.0)), 0.86);
  const Vec3 way(-std::cos(slope), std::sin(slope), 0);
  const Vec3 tack = Vec3(mast.x, crossY, z) - way * below, peak = tack + way * length;
  const double yr = 0.08 + 0.007 * length;
  const Vec2 profile[] = {{0.45 * yr, 0},    {0.8 * yr, 0.15}, {yr, 0.4},
                          {0.85 * yr, 0.65}, {0.5 * yr, 0.88}, {0.25 * yr, 1}};
  b.material(ship.m.spar);
  drawSpar(ship, tack, peak, profile, 10);

  const Vec3 head = glm::mix(tack, peak, 0.97), foot = glm::mix(tack, peak, 0.03);
  const Vec3 clew(foot.x - 0.82 * (foot.x - head.x), std::max(foot.y, mast.deckY + 1.9) + 0.02 * length, z);
  constexpr int kCloths = 13, kRows = 9;
  const auto at = [&](double s, double t) {
    const Vec3 flat = foot + ((head - foot) * (1 - t) + (clew - foot) * t) * s;
    const double belly =
        0.035 * length * std::sin(kPi * std::min(s, 0.999) * 0.9) * std::sin(kPi * power(t, 0.9) * 0.92);
    return flat + Vec3(0.02, -0.1 * s, belly);
  };
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i <= kRows; ++i) {
    std::vector<Vec3>& row = rows.emplace_back();
    for (int j = 0; j <= kCloths; ++j)
      row.push_back(at(static_cast<double>(kCloths - j) / kCloths, 1 - static_cast<double>(i) / kRows));
  }
  const std::vector<MaterialId> materials = clothMaterials(ship, kCloths);
  Builder::SkinOptions options;
  options.materials = materials;
  b.sheet(rows, 0.03, options);
  b.material(ship.m.hemp);
  std::vector<Vec3> edge;
  for (int j = 1; j <= 10; ++j) edge.push_back(at(j / 10.0, 1));
  for (int i = 1; i <= 8; ++i) edge.push_back(at(1, 1 - i / 8.0));
  drawRope(ship, edge, 0.045, 3);
  // The sheet, from the clew to the rail.
  const Plan& plan = ship.plan;
  const double sheetX = std::max(clew.x - 1.5, plan.hull.sternX(plan.stern.back().h) + 0.2);
  const Vec3 rail = plan.hull.sideAt(sheetX, plan.railH(sheetX));
  drawRope(ship, clew, rail, 0.03);

  nameMast(ship, mast, name);
}

/// Bowsprit, its spritsail, and the angle that it stands at.
void drawBowsprit(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const Vec3 foot = plan.bowspritFoot, tip = plan.bowspritTip, way = glm::normalize(tip - foot);
  const double r = 0.16 + 0.009 * plan.bowspritLength;
  const Vec2 profile[] = {{r, 0}, {r, 0.25}, {0.8 * r, 0.7}, {0.55 * r, 1}};
  b.material(ship.m.spar);
  drawSpar(ship, foot - way * 1.2, tip, profile, 14);
  // The lashing that holds it to the beakhead.
  b.material(ship.m.hemp);
  const Vec2 lashing[] = {{1.06 * r, 0}, {1.06 * r, 1}};
  for (const double at : {1.9, 2.5}) drawSpar(ship, foot + way * at, foot + way * (at + 0.35), lashing, 14);

  const Vec3 at = foot + way * (0.66 * plan.bowspritLength);
  const double width = plan.fore.sails[1].footWidth * 0.62;
  const double drop = std::clamp(0.28 * width, 1.5, at.y - plan.hull.depth * 0.75);
  const SquareSail sail{at.y - r - 0.2, at.y - r - 0.2 - drop, width, width * 0.96,
                        std::min(0.4 * drop, 0.45 * plan.fore.sails[0].belly)};
  drawYard(ship, at.x, sail.yardY + 0.05, width * 1.08, 0.05 + 0.009 * width);
  drawCloths(ship, {sail, at.x}, 10, 6);

  b.push([&] {
    const Vec3 up(-way.y, way.x, 0);
    enterFrame(b, foot - up * r - Vec3(0, 0, r), {way, up, {0, 0, 1}}, {plan.bowspritLength, 2 * r, 2 * r});
    b.name("Bowsprit");
  });
  // Level from the bowsprit's foot, opening upwards.
  nameBetween(ship, "Steeve", foot, {tip.x, tip.y, 0});
}

/// What the sails' parameters measure: the feet of the courses, the head of a topsail, and how far a course bellies.
void nameSails(const Ship& ship) {
  const auto across = [&](std::string_view name, const Mast& mast, double y, double width) {
    nameBetween(ship, name, {mast.x, y - 0.15, -width * 0.5}, {mast.x + 0.8, y + 0.15, width * 0.5});
  };
  const Mast &fore = ship.plan.fore, &main = ship.plan.main;
  across("ForeSailFoot", fore, fore.sails[0].footY, fore.sails[0].footWidth);
  across("MainSailFoot", main, main.sails[0].footY, main.sails[0].footWidth);
  across("TopsailHead", main, main.sails[1].yardY, main.sails[1].headWidth);
  const SquareSail& course = main.sails[0];
  const double yard = 0.06 + 0.0095 * course.headWidth, x = main.x + main.radius + yard * 1.3 + 0.08;
  nameBetween(ship, "MainSailBelly", {x, course.footY, -0.5 * course.footWidth},
              {x + course.belly, course.yardY, 0.5 * course.footWidth});
}

}  // namespace

void buildRig(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  b.material(ship.m.hemp);
  const PartId reefPoint = b.part(Vec3(0.0), [&] { b.box({-0.045, -0.5, -0.012}, {0.09, 0.5, 0.024}); });
  drawSquareMast(ship, plan.fore, "ForeMast", reefPoint, false);
  drawSquareMast(ship, plan.main, "MainMast", reefPoint, true);
  if (plan.mizzen) drawLateenMast(ship, *plan.mizzen, "MizzenMast");
  if (plan.bonaventure) drawLateenMast(ship, *plan.bonaventure, "BonaventureMast");
  drawBowsprit(ship);
  nameSails(ship);

  const auto truck = [](const Mast& mast, double shift) {
    return Vec3(mast.x + shift * mast.radius, mast.truckY(), 0);
  };
  drawPennant(ship, truck(plan.main, 2.55), 0.24 * plan.main.height, ship.m.flagRed);
  drawPennant(ship, truck(plan.fore, 2.55), 0.2 * plan.fore.height, ship.m.flagBlue);
  if (plan.mizzen) drawPennant(ship, truck(*plan.mizzen, 1.4), 0.2 * plan.mizzen->height, ship.m.flagRed);
  if (plan.bonaventure)
    drawPennant(ship, truck(*plan.bonaventure, 1.4), 0.2 * plan.bonaventure->height, ship.m.flagBlue);
}

}  // namespace dimline::boat
