#include <array>
#include <cmath>
#include <numbers>

#include "models/candler_parts.h"
#include "models/mouldings.h"

// The top of the Candler Building. Heights are counted from the top of the last storey.
//
//            antefix  .
//                  |\ |        <- overhang
//      parapet     | \|
//        |   ______|__/  cymatium
//        |        |___|  corona
//        |   |~~~\       modillion
//        |   |#          dentils
//        |  _|  ovolo
//        | |   frieze
//        | |_  architrave

namespace dimline::candler {

namespace {

constexpr double kFriezeBottom = 0.5, kDentils = 1.5, kModillions = 2.0, kSoffit = 2.8, kCyma = 3.2;
constexpr double kDentilBack = 0.2, kModillionBack = 0.5;

/// Some teeth of the row, over that length.
constexpr int kTeeth = 7;
PartId makeDentils(const Candler& c, double length) {
  Builder& b = c.b;
  return b.part({length, kModillions - kDentils - 0.16, 0.2}, [&] {
    b.material(c.m.carved);
    b.repeat(Axis::kX, length / kTeeth, [&](int, int) { b.box({0.1, 0, 0}, {b.size().x - 0.2, b.size().y, 0.2}); });
  });
}

/// A scrolled bracket: a console whose lower edge rises in a double curve towards its tip, under a flat abacus.
PartId makeModillion(const Candler& c, double length) {
  Builder& b = c.b;
  return b.part({0.5, kSoffit - kModillions, length}, [&] {
    b.material(c.m.carved);
    const double h = b.size().y - 0.12;
    Ring side{{-0.05, h}, {-0.05, 0.06}, {0.06 * length, 0}, {0.2 * length, 0.01}, {0.34 * length, 0.1}};
    for (const Vec2& p : {Vec2(0.5, 0.3), Vec2(0.66, 0.45), Vec2(0.8, 0.48), Vec2(0.92, 0.46), Vec2(0.99, 0.56), Vec2(1, 0.72)}) {
      side.emplace_back(p.x * length, p.y * h);
    }
    side.emplace_back(0.97 * length, h);
    b.translate({0.06, 0, 0});
    b.scale(Axis::kX, 0.38);
    b.extrudePolygon(side, Axis::kX, 0.9);
    b.box({-0.06, h, -0.05}, {0.5, 0.12, length + 0.1});
  });
}

/// A palmette.
PartId makeAntefix(const Candler& c) {
  Builder& b = c.b;
  return b.part({0.9, 0.95, 0.14}, [&] {
    b.material(c.m.copper);
    b.translate({0.45, 0, 0});
    b.extrudePolygon(palmette(0.9, 0.95));
  });
}

void drawCresting(const Candler& c) {
  Builder& b = c.b;
  const double out = c.plan.overhang - 0.24;
  const PartId antefix = makeAntefix(c);
  b.faces(kSideFaces, [&](Face) {
    b.translate({-out, 0, out - 0.07});
    b.scale(Axis::kX, b.size().x + 2 * out);
    b.repeat(Axis::kX, kBay / 3, [&](int, int) {
      b.translate({0.5 * b.size().x - 0.45, 0, 0});
      b.place(antefix);
    });
  });
}

}  // namespace

void drawBand(const Candler& c, double heightM, MaterialId material, const Ring& section) {
  Builder& b = c.b;
  b.push([&] {
    b.translate({0, heightM, 0});
    b.material(material);
    drawMoulding(b, {c.plan.width(), c.plan.depth()}, section);
  });
}

void drawCornice(const Candler& c) {
  Builder& b = c.b;
  const double top = c.plan.top(), over = c.plan.overhang;
  // Architrave, which closes the wall above the last windows, and frieze.
  const double head = -(c.plan.floorHeight - kSill - c.plan.windowHeight);
  drawBand(c, top, c.m.marble,
           {{-kWallDepth, head}, {0.06, head}, {0.06, 0.2}, {0.14, 0.2}, {0.22, 0.42}, {0.22, kFriezeBottom}, {0.03, kFriezeBottom},
            {0.03, kDentils - 0.25}, {0.1, kDentils - 0.25}, {kDentilBack, kDentils}, {-kWallDepth, kDentils}});
  const double corona = over - 0.4;
  Ring cornice{{-0.4, kDentils}, {kDentilBack, kDentils}, {kDentilBack, kModillions - 0.16}, {0.46, kModillions - 0.14}, {kModillionBack, kModillions},
               {kModillionBack, kSoffit}, {corona - 0.1, kSoffit}, {corona - 0.1, kSoffit - 0.06}, {corona, kSoffit - 0.06}, {corona, kCyma - 0.08},
               {corona + 0.06, kCyma - 0.08}};
  addCyma(cornice, {corona + 0.06, kCyma}, {over - 0.02, kEntablature - 0.2});
  cornice.insert(cornice.end(), {{over, kEntablature - 0.18}, {over, kEntablature - 0.06}, {-0.4, kEntablature}});
  drawBand(c, top, c.m.carved, cornice);

  const PartId modillion = makeModillion(c, corona - 0.14 - kModillionBack);
  b.faces(kSideFaces, [&](Face) {
    b.translate({0, top, 0});
    const double length = b.size().x;
    b.push([&] {
      b.translate({-kDentilBack, kDentils, kDentilBack});
      b.scale(Axis::kX, length + 2 * kDentilBack);
      PartId dentils = 0;
      b.repeat(Axis::kX, 0.5 * kTeeth, [&](int i, int) {
        if (i == 0) dentils = makeDentils(c, b.size().x);
        b.place(dentils);
      });
    });
    b.push([&] {
      b.translate({-kModillionBack, kModillions, kModillionBack});
      b.scale(Axis::kX, length + 2 * kModillionBack);
      b.repeat(Axis::kX, kBay / 3, [&](int, int) {
        b.translate({0.5 * b.size().x - 0.25, 0, 0});
        b.place(modillion);
      });
    });
    // Measured where it turns the corner to the right: there it stands out against the sky from every side.
    b.push([&] {
      b.translate({length, kDentils, 0});
      b.scale({over, kEntablature - kDentils, over});
      b.name("Cornice");
    });
  });
  b.push([&] {
    b.translate({-over, top + kEntablature - 0.12, -over});
    b.scale({c.plan.width() + 2 * over, 1.07, c.plan.depth() + 2 * over});
    b.name("Cresting");
  });
  if (c.plan.cresting) {
    b.push([&] {
      b.translate({0, top + kEntablature - 0.1, 0});
      drawCresting(c);
    });
  }
}

void drawRoof(const Candler& c) {
  Builder& b = c.b;
  const double w = c.plan.width(), d = c.plan.depth(), edge = c.plan.top() + kEntablature - 0.2;
  drawBand(c, edge, c.m.marble, {{-0.65, 0}, {-0.15, 0}, {-0.15, 1.25}, {-0.08, 1.25}, {-0.08, 1.45}, {-0.72, 1.45}, {-0.72, 1.25}, {-0.65, 1.25}});
  b.material(c.m.gravel);
  b.box({0.4, edge - 1.2, 0.4}, {w - 0.8, 1.4, d - 0.8});

  b.push([&] {
    b.translate({0, edge + 0.2, 0});
    // Lift house with its own little cornice, and a skylight over the stair.
    b.push([&] {
      b.translate({0.5 * w - 5, 0, 0.5 * d - 8});
      b.scale({10, 4.2, 7});
      b.material(c.m.brick);
      b.box();
      b.material(c.m.carved);
      b.box({-0.25, 4.2, -0.25}, {10.5, 0.35, 7.5});
      b.material(c.m.glass);
      for (int i = 0; i < 3; ++i) b.box({1.2 + 2.9 * i, 1.3, 6.9}, {1.8, 1.7, 0.15});
      // Flagstaff and flag.
      b.material(c.m.bronze);
      b.push([&] {
        b.translate({4.88, 4.5, 3.38});
        b.scale({0.24, 7, 0.24});
        b.cone(0.4, {.segments = 10});
      });
      b.push([&] {
        b.translate({4.85, 11.4, 3.35});
        b.scale({0.3, 0.3, 0.3});
        b.sphere({.segments = 10});
      });
      b.material(c.m.flag);
      b.push([&] {
        b.translate({5.04, 9.6, 3.5});
        b.scale({0, 1.7, 0});
        // Cloth in the wind: a thin wavy sheet.
        Ring cloth;
        constexpr int kSteps = 8;
        for (int side = 0; side < 2; ++side) {
          for (int i = 0; i <= kSteps; ++i) {
            const double t = static_cast<double>(side == 0 ? i : kSteps - i) / kSteps;
            cloth.emplace_back(2.9 * t, 0.24 * t * std::sin(7 * t) + (side == 0 ? -0.02 : 0.02));
          }
        }
        b.extrudePolygon(cloth, Axis::kY, 1.0);
      });
    });
    b.push([&] {
      b.translate({0.5 * w - 3, 0, 0.5 * d + 3.5});
      b.scale({6, 0.9, 4});
      b.material(c.m.marble);
      b.box();
      b.material(c.m.glass);
      b.translate({0.2, 0.9, 0.2});
      b.scale({5.6, 0, 3.6});
      RoofOptions roof;
      roof.pitchRad = 0.5;
      roof.thicknessM = 0.08;
      b.roofHip(roof);
    });
  });
}

}  // namespace dimline::candler
