#include <array>
#include <cmath>
#include <numbers>

#include "models/candler_parts.h"
#include "models/mouldings.h"
#include "models/vocabulary.h"

// The street front of the Candler Building: rusticated granite, a shop in every bay, the portal in the middle of the front.

namespace dimline::candler {

namespace {

constexpr double kOpening = 3.0, kShopHead = 4.3, kPierWidth = kBay - kOpening;

/// Masonry from the plinth up to the lintel, as (outwards, up): courses with V-shaped joints, and a straight back.
Ring rusticated(double depth) {
  constexpr int kCourses = 6;
  const double h = kShopHead - kPlinth, course = h / kCourses, joint = 0.05;
  Ring section{{-depth, h}, {-depth, 0}};
  for (int i = 0; i < kCourses; ++i) {
    if (i > 0) section.emplace_back(0.1 - joint, i * course);
    section.emplace_back(0.1, i * course + (i > 0 ? joint : 0));
    section.emplace_back(0.1, (i + 1) * course - (i + 1 < kCourses ? joint : 0));
  }
  return section;
}

PartId makePier(const Candler& c, double width) {
  Builder& b = c.b;
  return b.part({width, 0, 0}, [&] {
    b.material(c.m.granite);
    b.extrudePolygon(rusticated(kWallDepth), Axis::kX);
  });
}

/// The joints run round a corner pier.
PartId makeCornerPier(const Candler& c) {
  Builder& b = c.b;
  return b.part({kCorner, 0, kCorner}, [&] {
    b.material(c.m.granite);
    drawMoulding(b, {kCorner, kCorner}, rusticated(0.4 * kCorner));
  });
}

/// Scope: an opening between two piers, x along the front, z outwards from the wall's face.
PartId makeShop(const Candler& c, bool awning) {
  Builder& b = c.b;
  return b.part({kOpening, kShopHead, 0}, [&] {
    const double w = kOpening;
    b.material(c.m.granite);
    b.box({0, kPlinth, -kReveal}, {w, 0.4, 0.34});                       // stall riser
    b.material(c.m.bronze);
    for (const double x : {0.0, 0.5 * w - 0.05, w - 0.1}) b.box({x, kPlinth + 0.4, -kReveal - 0.02}, {0.1, kShopHead - kPlinth - 0.4, 0.14});
    b.box({0.05, 3.1, -kReveal - 0.02}, {w - 0.1, 0.14, 0.18});          // transom
    b.box({0, kShopHead - 0.55, -kReveal - 0.02}, {w, 0.55, 0.2});       // sign board
    if (!awning) return;
    // Cloth on a frame, with a valance.
    b.material(c.m.awning);
    b.translate({0.06, 3.12, -0.1});
    b.scale(Axis::kX, w - 0.12);
    b.extrudePolygon(Ring{{0, 0.7}, {1.45, 0.02}, {1.45, -0.24}, {1.48, -0.24}, {1.48, 0.05}, {0, 0.76}}, Axis::kX);
  });
}

/// A Doric shaft that stands on the ground: base, body, capital.
PartId makePortalColumn(const Candler& c, double height) {
  Builder& b = c.b;
  return b.part({0.8, height, 0.8}, [&] {
    b.material(c.m.carved);
    b.box({0, 0, 0}, {0.8, 0.25, 0.8});
    const std::array<Vec2, 9> profile{{{0.38, 0.25}, {0.4, 0.33}, {0.33, 0.43}, {0.3, 0.46}, {0.29, 0.4 * height}, {0.25, height - 0.6},
                                       {0.28, height - 0.52}, {0.38, height - 0.28}, {0.38, height - 0.22}}};
    b.lathe(profile, {.segments = 16, .creaseRad = 0.5});
    b.box({0, height - 0.22, 0}, {0.8, 0.22, 0.8});
  });
}

/// Steps, bronze doors between two pairs of columns, and an entablature with a segmental pediment. Scope: as for a shop.
void drawPortal(const Candler& c) {
  Builder& b = c.b;
  const double w = kOpening, columnHeight = kShopHead - kPlinth;
  b.material(c.m.granite);
  b.push([&] {
    b.translate({-1.3, 0, -0.1});
    b.scale(Axis::kX, w + 2.6);
    const double r = kPlinth / 2;
    b.extrudePolygon(Ring{{0, 0}, {1.9, 0}, {1.9, r}, {1.5, r}, {1.5, kPlinth}, {0, kPlinth}}, Axis::kX);
  });
  b.material(c.m.bronze);
  for (const double x : {0.0, 0.5 * w - 0.07, w - 0.14}) b.box({x, kPlinth, -kReveal - 0.02}, {0.14, kShopHead - kPlinth, 0.2});
  for (const double x : {0.14, 0.5 * w + 0.07}) {
    b.box({x, kPlinth, -kReveal - 0.02}, {0.5 * w - 0.21, 0.9, 0.12});
    b.box({x, 2.75, -kReveal - 0.02}, {0.5 * w - 0.21, 0.2, 0.16});
    b.box({x + 0.5 * (0.5 * w - 0.21) - 0.04, 1.2, -kReveal - 0.02}, {0.08, 1.6, 0.1});
  }
  const PartId column = makePortalColumn(c, columnHeight);
  for (const double x : {-1.15, -0.2, w - 0.6, w + 0.35}) {
    b.push([&] {
      b.translate({x, kPlinth, 0.45});
      b.place(column);
    });
  }
  b.material(c.m.carved);
  b.push([&] {
    b.translate({-1.3, kShopHead, -0.1});
    b.scale(Axis::kX, w + 2.6);
    b.extrudePolygon(Ring{{0, 0}, {1.4, 0}, {1.4, 0.45}, {1.48, 0.5}, {1.48, 0.75}, {1.7, 0.95}, {1.7, 1.1}, {0, 1.1}}, Axis::kX);
    // The pediment's arc and its tympanum.
    b.translate({0.5 * (w + 2.6), 1.1, 0});
    b.scale({0, 0, 1.6});
    constexpr int kSteps = 14;
    const double half = 0.5 * w + 1.35, rise = 1.15, radius = (half * half + rise * rise) / (2 * rise), spread = std::asin(half / radius);
    Ring arc, field;
    for (int i = 0; i <= kSteps; ++i) {
      const double a = spread * (2.0 * i / kSteps - 1);
      arc.emplace_back(radius * std::sin(a), radius * std::cos(a) - radius + rise);
    }
    field = arc;
    for (int i = kSteps; i >= 0; --i) {
      const double a = spread * 0.93 * (2.0 * i / kSteps - 1);
      arc.emplace_back((radius - 0.26) * std::sin(a), std::max((radius - 0.26) * std::cos(a) - radius + rise, 0.0));
    }
    b.extrudePolygon(arc, Axis::kZ, 0.5);
    b.material(c.m.spandrel);
    b.scale(Axis::kZ, 1.3);
    for (Vec2& p : field) p = {p.x * 0.97, p.y * 0.9};
    b.extrudePolygon(field, Axis::kZ, 0.5);
    // A bronze clock in the middle.
    b.material(c.m.bronze);
    b.translate({0, 0.46, 1.25});
    b.rotate(Axis::kX, std::numbers::pi / 2);
    b.translate({-0.36, 0, -0.36});
    b.scale({0.72, 0.2, 0.72});
    b.cylinder({.segments = 20});
  });
}

}  // namespace

// White stone that goes a little warmer where it is carved; bronze and dark glass; copper gone green only at the very top.
Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  marble = paint(b, 0xE9E4DA, 0.75F);
  carved = paint(b, 0xF1EBDD, 0.7F);
  spandrel = paint(b, 0xCFC7B8, 0.8F);
  granite = paint(b, 0xB3ABA3, 0.85F, kStone);
  sash = paint(b, 0x3C4A45, 0.5F);
  glass = paint(b, 0x3B4F5C, 0.06F, kGlass);
  bronze = paint(b, 0x5A4A38, 0.45F, kMetal);
  awning = paint(b, 0x7A3B33, 0.9F, kFabric);
  copper = paint(b, 0x7FA08E, 0.6F);
  gravel = paint(b, 0xA39E96, 0.95F);
  brick = paint(b, 0xB39A82, 0.9F, kBrick);
  flag = paint(b, 0xB5483C, 0.9F, kFabric);
}

void drawGroundFloor(const Candler& c) {
  Builder& b = c.b;
  const double w = c.plan.width(), d = c.plan.depth();
  b.material(c.m.granite);
  b.box({-0.2, 0, -0.2}, {w + 0.4, kPlinth, d + 0.4});
  const PartId pier = makePier(c, kPierWidth), halfPier = makePier(c, 0.5 * kPierWidth), corner = makeCornerPier(c);
  const std::array<PartId, 2> shops{makeShop(c, false), makeShop(c, true)};
  b.faces(kSideFaces, [&](Face face) {
    const int bays = face == Face::kFront || face == Face::kBack ? kFrontBays : kSideBays;
    for (int i = 0; i <= bays; ++i) {
      b.push([&] {
        const double axis = kCorner + i * kBay;
        b.translate({i == 0 ? axis : axis - 0.5 * kPierWidth, kPlinth, 0});
        b.place(i == 0 || i == bays ? halfPier : pier);
      });
      if (i == bays) continue;
      b.push([&] {
        b.translate({kCorner + (i + 0.5) * kBay - 0.5 * kOpening, 0, 0});
        if (face == Face::kFront && i == kFrontBays / 2) {
          drawPortal(c);
        } else {
          b.place(shops[(i + bays) % 2]);
        }
      });
    }
    b.push([&] {
      b.translate({0, kPlinth, -kCorner});
      b.place(corner);
    });
  });
  // Lintel and the band under the first floor.
  drawBand(c, kShopHead, c.m.granite, {{-kWallDepth, 0}, {0.06, 0}, {0.06, 0.75}, {-kWallDepth, 0.75}});
  drawBand(c, kShopHead + 0.75, c.m.carved,
           {{-kWallDepth, 0}, {0.12, 0}, {0.16, 0.14}, {0.34, 0.34}, {0.42, 0.34}, {0.42, 0.52}, {0.12, 0.65}, {-kWallDepth, 0.65}});
}

}  // namespace dimline::candler
