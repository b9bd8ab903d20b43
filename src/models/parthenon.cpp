#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/models.h"
#include "models/parthenon_parts.h"
#include "models/vocabulary.h"

// The temple of Athena on the Acropolis (447 to 432 BC), as it was new: a colonnade of fluted Doric columns all around, and within it the
// cella, with six smaller columns before each of its doors. The defaults are the building's measures.

namespace dimline {

namespace {

using namespace parthenon;

enum Index {
  kWidth, kLength, kStepHeight, kColumnHeight, kColumnSpacing, kColumnRadius, kCapitalHeight, kEntablatureHeight, kCorniceOverhang,
  kPedimentPitch, kParameterCount
};

// Sound together: capitals of the thickest columns (2.5 m wide) stand clear of each other at the closest spacing that rounding can give
// (3 m), and of the cella, which keeps 3.6 m from the edge of the narrowest stylobate.
std::vector<Parameter> parameters() {
  std::vector<Parameter> p(kParameterCount);
  p[kWidth] = lengthParameter("Width", "Width", {30.9, 24, 40, 0.1},
      {"Temple", "How wide the uppermost step is, on which the columns stand.",
       "@Handle(scope=Stylobate, type=linear-contour, orient=right, slip=scope, align=bottom, occlusion=false)"});
  p[kLength] = lengthParameter("Length", "Length", {69.5, 45, 90, 0.1},
      {"Temple", "How long the uppermost step is.",
       "@Handle(scope=Stylobate, type=linear-contour, orient=back, slip=scope, occlusion=false)"});
  p[kStepHeight] = lengthParameter("StepHeight", "Step height", {0.52, 0.3, 0.7, 0.02},
      {"Temple", "How high each of the three steps is; they were made for the temple's size, not for people.",
       "@Handle(scope=Step, type=linear-contour, orient=up, slip=scope, chained, min-length=14)"});
  p[kColumnHeight] = lengthParameter("ColumnHeight", "Column height", {10.4, 7, 13, 0.1},
      {"Columns", "How high the columns are, capitals included.",
       "@Handle(scope=Colonnade, type=linear-contour, orient=up, slip=scope)"});
  p[kColumnSpacing] = lengthParameter("ColumnSpacing", "Column spacing", {4.2, 3.4, 6, 0.05},
      {"Columns", "About how far apart the columns are, from axis to axis; each side takes as many as fit evenly.",
       "@Handle(scope=Intercolumniation, type=linear-contour, orient=right, slip=scope, chained, indirect)"});
  p[kColumnRadius] = lengthParameter("ColumnRadius", "Column radius", {0.95, 0.6, 1.15, 0.01},
      {"Columns", "Half the width of a column where it stands; it grows slimmer towards its capital.",
       "@Handle(scope=ColumnFoot, type=linear-center, orient=right, slip=scope, chained, min-length=14)"});
  p[kCapitalHeight] = lengthParameter("CapitalHeight", "Capital height", {0.86, 0.5, 1.1, 0.02},
      {"Columns", "How high the capital is: the round echinus and the square abacus on it.",
       "@Handle(scope=Capital, type=linear-contour, orient=up, slip=none, min-length=14)"});
  p[kEntablatureHeight] = lengthParameter("EntablatureHeight", "Entablature height", {3.3, 2.2, 4.2, 0.05},
      {"Entablature", "How high architrave, frieze and cornice are together.",
       "@Handle(scope=Entablature, type=linear-contour, orient=up, slip=scope)"});
  p[kCorniceOverhang] = lengthParameter("CorniceOverhang", "Cornice overhang", {0.8, 0.5, 1.4, 0.02},
      {"Entablature", "How far the cornice reaches out over the frieze.",
       "@Handle(scope=Geison, type=linear-center, orient=front, slip=scope, min-length=14)"});
  p[kPedimentPitch] = angleParameter("PedimentPitch", "Pediment pitch", {14, 10, 22, 0.5},
      {"Roof", "How steep the roof and its two pediments are.", "@Handle(scope=Pitch, type=angular, orient=front, slip=none)"});
  return p;
}

void drawSteps(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  const double widest = (kSteps - 1) * kTread;
  b.material(t.m.step);
  for (int i = 0; i < kSteps; ++i) {
    const double out = (kSteps - 1 - i) * kTread, low = i * p.stepHeight;
    b.box({-out, low, -out}, {p.width + 2 * out, p.stepHeight, p.length + 2 * out});
    nameBox(b, "Step", {-widest, low, -widest}, {p.width + widest, low + p.stepHeight, p.length + widest});
  }
  nameBox(b, "Stylobate", {0, p.stylobate() - p.stepHeight, 0}, {p.width, p.stylobate(), p.length});
}

// --- Columns -----------------------------------------------------------------------------------------------------------------

/// A ring of twenty flutes that meet in sharp edges, each hollowed out by two points.
///
///      '.      .'
///        '----'      depth
///
Ring fluted(double radius) {
  constexpr int kFlutes = 20;
  Ring ring;
  for (int i = 0; i < 3 * kFlutes; ++i) {
    const double angle = 2 * std::numbers::pi * i / (3 * kFlutes), r = radius * (i % 3 == 0 ? 1 : 0.952);
    ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return ring;
}

PartId makeColumn(const Parthenon& t, double radius, double height, double capital) {
  Builder& b = t.b;
  return b.part({2 * radius, height, 2 * radius}, [&] {
    b.material(t.m.marble);
    // Slimmer upwards, in a curve that swells a little (entasis).
    constexpr int kStages = 6;
    const double shaft = height - capital;
    std::vector<Vec3> axis;
    std::vector<double> widths;
    for (int i = 0; i <= kStages; ++i) {
      const double up = static_cast<double>(i) / kStages;
      axis.emplace_back(radius, shaft * up, radius);
      widths.push_back(1 - (1 - kUpperRadius) * up + 0.014 * std::sin(std::numbers::pi * up));
    }
    Builder::SweepOptions options;
    options.up = {0, 0, 1};
    options.creaseRad = 0.55;
    options.widths = widths;
    b.sweep(fluted(radius), axis, options);

    // Necking, three annulets, the cushion of the echinus.
    const double neck = kUpperRadius * radius, rim = 1.06 * radius, y = shaft - 0.04 * capital, c = capital;
    const std::array<Vec2, 10> profile{{{neck * 0.97, y}, {neck * 1.02, y + 0.05 * c}, {neck * 1.0, y + 0.1 * c}, {neck * 1.06, y + 0.12 * c},
                                        {neck * 1.04, y + 0.17 * c}, {neck * 1.12, y + 0.2 * c}, {0.6 * neck + 0.5 * rim, y + 0.36 * c},
                                        {rim * 0.99, y + 0.5 * c}, {rim, y + 0.55 * c}, {rim * 0.97, y + 0.6 * c}}};
    b.lathe(profile, {.segments = 24, .creaseRad = 0.5});
    const double half = 1.08 * radius;
    b.box({radius - half, shaft + 0.55 * c, radius - half}, {2 * half, 0.45 * c, 2 * half});
  });
}

void drawColonnade(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  const double inset = p.axisInset(), r = p.radius;
  const PartId column = makeColumn(t, r, p.columnHeight, p.capitalHeight);
  b.translate({0, p.stylobate(), 0});
  b.scale({p.width, p.columnHeight, p.length});
  nameBox(b, "Colonnade", {inset - r, 0, inset - r}, {p.width - inset + r, p.columnHeight, p.length - inset + r});
  b.faces(kSideFaces, [&](Face face) {
    const bool front = face == Face::kFront || face == Face::kBack;
    const int bays = front ? p.baysAcross : p.baysAlong;
    const double bay = front ? p.bayAcross() : p.bayAlong();
    for (int i = 0; i <= bays; ++i) {
      b.push([&] {
        b.translate({inset + i * bay, 0, -inset});
        nameBox(b, "ColumnFoot", {0, 0, -r}, {r, 0.3, r});
        if (i == bays) return;   // it is the first one of the next side
        nameBox(b, "Intercolumniation", {0, 0, -r}, {bay, p.columnHeight, r});
        if (i == 0) {
          const double half = 1.08 * r;
          nameBox(b, "Capital", {-half, p.columnHeight - p.capitalHeight, -half}, {half, p.columnHeight, half});
        }
        b.translate({-r, 0, -r});
        b.place(column);
      });
    }
  });
}

// --- The cella ---------------------------------------------------------------------------------------------------------------

/// A wall across the cella with a door in it. Scope: the wall, x across; z points out of the building.
void drawDoorWall(const Parthenon& t) {
  Builder& b = t.b;
  const double w = b.size().x, h = b.size().y, d = b.size().z, door = 0.24 * w, high = 0.78 * h;
  const double left = 0.5 * (w - door), right = left + door;
  b.material(t.m.wall);
  b.extrudePolygon(Ring{{0, 0}, {left, 0}, {left, high}, {right, high}, {right, 0}, {w, 0}, {w, h}, {0, h}});
  b.material(t.m.marble);
  b.push([&] {
    b.translate({0, 0, d - 0.05});
    b.scale(Axis::kZ, 0.2);
    b.extrudePolygon(Ring{{left - 0.45, 0}, {left, 0}, {left, high}, {right, high}, {right, 0}, {right + 0.45, 0}, {right + 0.45, high + 0.5},
                          {left - 0.45, high + 0.5}});
    b.box({left - 0.75, high + 0.5, 0}, {door + 1.5, 0.3, 0.4});
  });
  // Two leaves of bronze, each with three panels.
  for (const double x : {left, left + 0.5 * door}) {
    b.material(t.m.bronze);
    b.box({x + 0.02, 0, 0.45 * d}, {0.5 * door - 0.04, high, 0.12});
    b.material(t.m.gold);
    for (int i = 0; i < 3; ++i) b.box({x + 0.16 * door, (0.08 + 0.31 * i) * high, 0.45 * d + 0.1}, {0.18 * door, 0.22 * high, 0.07});
  }
}

void drawCella(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  constexpr double kFloor = 0.6, kWall = 1.1;
  constexpr int kPorchColumns = 6;
  const double inset = p.ambulatory(), w = p.width - 2 * inset, l = p.length - 2 * inset;
  const double top = p.columnHeight - kFloor, beam = 0.36 * p.entablature, r = 0.87 * std::min(p.radius, 0.06 * w);
  const double porch = 2 * r + 1.5, wall = porch + 2.6;   // from the platform's edge to the side walls' ends, and to the wall with the door
  b.translate({inset, p.stylobate(), inset});
  b.material(t.m.step);
  b.box({-0.4, 0, -0.4}, {w + 0.8, 0.5 * kFloor, l + 0.8});
  b.box({0, 0.5 * kFloor, 0}, {w, 0.5 * kFloor, l});
  b.translate({0, kFloor, 0});
  b.scale({w, top, l});

  b.material(t.m.wall);
  const double from = 0.25;
  for (const double x : {from, w - from - kWall}) {
    b.box({x, 0, porch}, {kWall, top, l - 2 * porch});
    b.box({x - 0.06, 0, porch - 0.06}, {kWall + 0.12, 0.9, l - 2 * porch + 0.12});   // the tall lowest course
  }
  b.material(t.m.marble);
  for (const double x : {from, w - from - kWall}) {
    for (const double z : {porch - 0.08, l - porch - 0.9}) {
      b.box({x - 0.08, 0, z}, {kWall + 0.16, top - beam, 0.98});
      b.box({x - 0.16, top - beam - 0.35, z - 0.08}, {kWall + 0.32, 0.35, 1.14});
    }
  }
  const PartId column = makeColumn(t, r, top - beam, 0.87 * p.capitalHeight);
  b.faces(std::array{Face::kFront, Face::kBack}, [&](Face) {
    b.push([&] {
      b.translate({from + 0.5 * kWall, 0, -wall - kWall});
      b.scale({w - 2 * from - kWall, top - beam, kWall});
      drawDoorWall(t);
    });
    const double bay = (w - 2 * from - 2.2 * r) / (kPorchColumns - 1);
    for (int i = 0; i < kPorchColumns; ++i) {
      b.push([&] {
        b.translate({from + 0.1 * r + i * bay, 0, -2.1 * r - 0.05});
        b.place(column);
      });
    }
  });
  // Beam and frieze run on around porches and walls: blue behind the procession, marble above and below.
  const auto ring = [&](double low, double high, double out, double depth) {
    b.push([&] {
      b.translate({from - out, top - beam + low * beam, from - 0.2 - out});
      b.scale({w - 2 * from + 2 * out, (high - low) * beam, l - 2 * from + 0.4 + 2 * out});
      const Vec3 n = b.size();
      b.extrudePolygon(Polygon{rectangleRing({0, 0}, {n.x, n.z}), {rectangleRing({depth, depth}, {n.x - depth, n.z - depth})}}, Axis::kY);
    });
  };
  ring(0, 0.5, 0, kWall);
  ring(0.86, 1, 0.08, kWall);
  b.material(t.m.blue);
  ring(0.5, 0.86, -0.05, kWall);
}

/// Slabs on beams between colonnade and cella, and over everything within.
void drawCeiling(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  const double edge = p.axisInset(), h = 0.41 * p.entablature;
  b.translate({edge, p.architrave(), edge});
  b.material(t.m.ceiling);
  b.box({0, 0.6 * h, 0}, {p.width - 2 * edge, 0.4 * h, p.length - 2 * edge});
  b.material(t.m.marble);
  const double span = p.ambulatory() - edge + 0.6;
  for (int i = 1; i < p.baysAlong; ++i) {
    for (const double x : {0.0, p.width - 2 * edge - span}) b.box({x, 0, i * p.bayAlong() - 0.3}, {span, 0.65 * h, 0.6});
  }
  for (int i = 1; i < p.baysAcross; ++i) {
    for (const double z : {0.0, p.length - 2 * edge - span}) b.box({i * p.bayAcross() - 0.3, 0, z}, {0.6, 0.65 * h, span});
  }
}

Scene build(const Values& values) {
  Plan plan;
  plan.width = values.at(kWidth);
  plan.length = values.at(kLength);
  plan.stepHeight = values.at(kStepHeight);
  plan.columnHeight = values.at(kColumnHeight);
  plan.radius = values.at(kColumnRadius);
  plan.capitalHeight = values.at(kCapitalHeight);
  plan.entablature = values.at(kEntablatureHeight);
  plan.overhang = values.at(kCorniceOverhang);
  plan.pitchRad = values.at(kPedimentPitch) * std::numbers::pi / 180;
  plan.baysAcross = repeatCount(plan.width - 2 * plan.axisInset(), values.at(kColumnSpacing));
  plan.baysAlong = repeatCount(plan.length - 2 * plan.axisInset(), values.at(kColumnSpacing));
  Builder b;
  const Palette palette(b);
  const Parthenon temple{b, plan, palette};
  b.translate({-0.5 * plan.width, 0, -0.5 * plan.length});
  b.scale({plan.width, 0, plan.length});
  drawSteps(temple);
  for (const auto draw : {drawColonnade, drawCella, drawCeiling, drawEntablature, drawRoof}) b.push([&] { draw(temple); });
  return b.finish();
}

}  // namespace

// Pentelic marble, which ripens to honey; blue and red, sparingly, where the painters put them.
parthenon::Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  marble = paint(b, 0xF0E6D2, 0.7F);
  shade = paint(b, 0xE2D5BC, 0.75F);
  step = paint(b, 0xE3D9C6, 0.8F, kStone);
  wall = paint(b, 0xE9DDC6, 0.8F, kStone);
  blue = paint(b, 0x4C6D8C, 0.8F);
  red = paint(b, 0xA9594A, 0.8F);
  tiles = paint(b, 0xE6DBC8, 0.75F);
  bronze = paint(b, 0x6B5236, 0.45F, kMetal);
  gold = paint(b, 0xC9A24A, 0.35F, kMetal);
  ceiling = paint(b, 0xC9BEA8, 0.85F);
}

ModelDefinition defineParthenon() { return {"parthenon", "Parthenon", parameters(), build}; }

}  // namespace dimline
