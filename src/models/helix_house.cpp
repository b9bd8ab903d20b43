#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/models.h"
#include "models/vocabulary.h"

// A tower of flats in which each floor is turned a little against the one below: slabs and glazing about a core that stands still, over an open
// ground floor on columns. The core's axis is the origin's vertical. Level k is the slab at the foot of storey k; the last one is the roof.
//
//      .--. core, with the stairs' head
//   ===+==+=======  level N, the roof
//    |  ||     |
//   =============== level 1, turned by the twist against level 0
//    |  ||     |    storey 0, its glass set back behind a balcony all around
//   =============== level 0
//    I  ||  I  I    columns
//  __I__||__I__I__  plaza

namespace dimline {

namespace {

enum HelixParameter : std::size_t {
  kFloors,
  kFloorHeight,
  kTwist,
  kWidth,
  kDepth,
  kSlabThickness,
  kGroundHeight,
  kColumnSpacing,
  kColumnDiameter,
  kCoreWidth,
  kStairHeadHeight,
  kFacade,
  kRoofGarden,
  kHelixParameterCount
};

enum class Facade { kGlass, kLouvres, kPanels };

// Fixed sizes (m).
constexpr double kPlaza = 0.15;         // height of the paving that the columns stand on
constexpr double kPlazaMargin = 1.6;    // how far it reaches beyond the lowest slab
constexpr double kColumnInset = 0.6;    // from the slab's edge to a column's middle
constexpr double kSetback = 1.1;        // from the slab's edge to the glass
constexpr double kCornerRound = 0.7;
constexpr double kRailHeight = 1.0, kRailInset = 0.32;  // so far in that its corners stay on the slab's round ones

struct Helix {
  explicit Helix(const Values& values)
      : floors(static_cast<int>(values.at(kFloors))),
        floorHeight(values.at(kFloorHeight)),
        twistRad(values.at(kTwist) * std::numbers::pi / 180),
        width(values.at(kWidth)),
        depth(values.at(kDepth)),
        slab(values.at(kSlabThickness)),
        groundHeight(values.at(kGroundHeight)),
        columnSpacing(values.at(kColumnSpacing)),
        columnDiameter(values.at(kColumnDiameter)),
        core(values.at(kCoreWidth)),
        stairHead(values.at(kStairHeadHeight)),
        facade(static_cast<Facade>(values.at(kFacade))),
        roofGarden(values.at(kRoofGarden) != 0) {}

  /// The underside of a level's slab.
  [[nodiscard]] double levelY(int level) const { return kPlaza + groundHeight + level * floorHeight; }
  [[nodiscard]] double roofY() const { return levelY(floors) + slab; }

  int floors;
  double floorHeight, twistRad, width, depth, slab, groundHeight, columnSpacing, columnDiameter, core, stairHead;
  Facade facade;
  bool roofGarden;
};

struct Palette {
  explicit Palette(Builder& b)
      : concrete(paint(b, 0xEDEAE3, 0.85F)),
        paving(paint(b, 0xC4BCB0, 0.9F, Material::Pattern::kStone)),
        glass(paint(b, 0x4A636C, 0.06F, Material::Pattern::kGlass)),
        rail(paint(b, 0xD5DFDD, 0.25F)),
        mullion(paint(b, 0x3A4247, 0.45F, Material::Pattern::kMetal)),
        core(paint(b, 0xB4694A, 0.85F, Material::Pattern::kPlaster)),
        timber(paint(b, 0xA57B52, 0.75F, Material::Pattern::kPlanks)),
        green(paint(b, 0x6E8F55, 0.95F, Material::Pattern::kLeaves)) {}
  MaterialId concrete, paving, glass, rail, mullion, core, timber, green;
};

struct House {
  Builder& b;
  const Helix& helix;
  const Palette& m;
};

/// A rectangle about the origin with round corners, by its half sizes in x and z.
Ring roundedRing(const Vec2& half, double round, int steps) {
  Ring ring;
  for (int corner = 0; corner < 4; ++corner) {
    const double from = corner * 0.5 * std::numbers::pi;
    const Vec2 middle((corner == 0 || corner == 3 ? 1 : -1) * (half.x - round), (corner < 2 ? 1 : -1) * (half.y - round));
    for (int i = 0; i <= steps; ++i) {
      const double a = from + 0.5 * std::numbers::pi * i / steps;
      ring.push_back(middle + round * Vec2(std::cos(a), std::sin(a)));
    }
  }
  return ring;
}

/// A prism over a ring about the axis, between two heights.
void drawPrism(Builder& b, const Polygon& polygon, double fromY, double toY, double creaseRad = 0) {
  b.push([&] {
    b.translate({0, fromY, 0});
    b.scale({0, toY - fromY, 0});
    b.extrudePolygon(polygon, Axis::kY, creaseRad);
  });
}

/// A glass balustrade along the slab's edge. Scope: about the axis, on the slab.
void drawBalustrade(Builder& b, const Vec2& half) {
  drawPrism(b, Polygon{rectangleRing(-half + kRailInset, half - kRailInset), {rectangleRing(-half + kRailInset + 0.04, half - kRailInset - 0.04)}}, 0, kRailHeight);
}

/// An upright member with its middle at (x, z).
void drawPost(Builder& b, const Vec2& at, double thick, double fromY, double toY) {
  b.box({at.x - 0.5 * thick, fromY, at.y - 0.5 * thick}, {thick, toY - fromY, thick});
}

// --- Ground floor -------------------------------------------------------------------------------------------------------

/// Columns along the edges of the lowest slab, as far apart as fits evenly; a side's bays are named in a scope that runs along it.
void drawColonnade(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  b.material(house.m.concrete);
  const PartId column = b.part(Vec3(0.0), [&] {
    const double r = 0.5 * h.columnDiameter;
    nameBox(b, "Column", {-r, 0, -r}, {r, h.groundHeight, r});
    drawPrism(b, Polygon{ellipseRing({0, 0}, Vec2(r), 8), {}}, 0, h.groundHeight, 0.9);
  });
  b.push([&] {
    b.translate({-0.5 * h.width + kColumnInset, kPlaza, -0.5 * h.depth + kColumnInset});
    b.scale({h.width - 2 * kColumnInset, h.groundHeight, h.depth - 2 * kColumnInset});
    b.name("GroundFloor");
    b.faces(kSideFaces, [&](Face) {
      // Each side has the column at its left end; the one at its right end is the next side's.
      b.repeat(Axis::kX, h.columnSpacing, [&](int, int) {
        b.place(column);
        nameBox(b, "ColumnBay", {0, 0, -0.5 * h.columnDiameter}, {b.size().x, h.groundHeight, 0});
      });
    });
  });
}

// --- Storeys ------------------------------------------------------------------------------------------------------------

/// What stands before the glass of one storey, from a floor's top to the ceiling. Scope: about the axis.
void drawScreen(const House& house, const Vec2& half, double height) {
  Builder& b = house.b;
  switch (house.helix.facade) {
    case Facade::kGlass:
      b.material(house.m.mullion);
      for (const double x : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) drawPost(b, half * Vec2(x, z), 0.12, 0, height);
      }
      break;
    case Facade::kLouvres: {
      b.material(house.m.timber);
      const int blades = 4;
      for (int i = 0; i < blades; ++i) {
        const double y = height * (0.42 + 0.5 * i / (blades - 1));
        drawPrism(b, Polygon{rectangleRing(-half - 0.22, half + 0.22), {rectangleRing(-half - 0.06, half + 0.06)}}, y, y + 0.07);
      }
      break;
    }
    case Facade::kPanels:
      b.material(house.m.timber);
      for (const double side : {-1.0, 1.0}) {
        // Two on the long sides, beside the middle; one on each of the short ones.
        for (const double x : {-0.62, 0.62}) b.box({half.x * x - 0.2 * half.x, 0, side * half.y - 0.05}, {0.4 * half.x, height, 0.1});
        b.box({side * half.x - 0.05, 0, -0.3 * half.y}, {0.1, height, 0.6 * half.y});
      }
      break;
  }
}

/// One storey over its slab, made once and turned into place.
PartId makeStorey(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  return b.part(Vec3(0.0), [&] {
    const Vec2 half(0.5 * h.width, 0.5 * h.depth), glass = half - kSetback;
    b.push([&] {
      b.translate({0, h.slab, 0});
      const double height = h.floorHeight - h.slab;
      b.material(house.m.glass);
      b.box({-glass.x, 0, -glass.y}, {2 * glass.x, height, 2 * glass.y});
      drawScreen(house, glass, height);
      b.material(house.m.rail);
      drawBalustrade(b, half);
    });
  });
}

PartId makeSlab(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  const Vec3 half(0.5 * h.width, 0, 0.5 * h.depth);
  return b.part(Vec3(0.0), [&] {
    nameBox(b, "Floor", -half, half + Vec3(0, h.slab, 0));
    b.material(house.m.concrete);
    drawPrism(b, Polygon{roundedRing({half.x, half.z}, kCornerRound, 2), {}}, 0, h.slab, 0.9);
  });
}

void drawTower(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  const PartId storey = makeStorey(house), slab = makeSlab(house);
  const double halfCore = 0.5 * h.core;
  for (int level = 0; level <= h.floors; ++level) {
    b.push([&] {
      b.translate({0, h.levelY(level), 0});
      // Heights are counted along the core, which is not turned.
      if (level < h.floors) nameBox(b, "Storey", {-halfCore, 0, -halfCore}, {halfCore, h.floorHeight, halfCore});
      b.rotate(Axis::kY, level * h.twistRad);
      b.place(slab);
      if (level < h.floors) b.place(storey);
      if (level == h.floors / 2 && level < h.floors) {
        const Vec2 half = Vec2(0.5 * h.width, 0.5 * h.depth) - kSetback;
        nameBox(b, "Facade", {-half.x, h.slab, -half.y}, {half.x, h.floorHeight, half.y});
      }
    });
  }
  nameBox(b, "Storeys", {-halfCore, h.levelY(0), -halfCore}, {halfCore, h.levelY(h.floors), halfCore});
}

// --- Core and roof ------------------------------------------------------------------------------------------------------

/// The core shows on the ground floor and, as the head of its stairs, on the roof.
void drawCore(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  const double half = 0.5 * h.core, roof = h.roofY();
  b.material(house.m.core);
  b.box({-half, kPlaza, -half}, {h.core, h.groundHeight + 0.5 * h.slab, h.core});
  b.box({-half, roof - 0.05, -half}, {h.core, h.stairHead + 0.05 - 0.12, h.core});
  nameBox(b, "StairHead", {-half, roof, -half}, {half, roof + h.stairHead, half});
  b.material(house.m.concrete);
  b.box({-half - 0.15, roof + h.stairHead - 0.12, -half - 0.15}, {h.core + 0.3, 0.12, h.core + 0.3});
  b.material(house.m.mullion);
  const double door = std::min(1.0, 0.5 * h.core);
  b.box({-0.5 * door, roof - 0.05, half - 0.05}, {door, 2.1, 0.08});
  b.box({-0.5 * door, kPlaza, half - 0.05}, {door, 2.2, 0.08});
}

/// Balustrade, planters and a pergola on the last level. Scope: about the axis, on the roof, turned with it.
void drawRoof(const House& house) {
  Builder& b = house.b;
  const Helix& h = house.helix;
  const Vec2 half = Vec2(0.5 * h.width, 0.5 * h.depth);
  b.material(house.m.rail);
  drawBalustrade(b, half);
  // Between the stairs' head and the balustrade, on either side.
  const double height = 2.3, in = 0.55, free = half.x - in - 0.72 * h.core, wide = std::max(free, 0.8);
  nameBox(b, "RoofGarden", {-half.x + in, 0, -half.y + in}, {half.x - in, height, half.y - in});
  if (!h.roofGarden) return;
  const double x0 = -half.x + in, x1 = x0 + wide, z = half.y - in;
  b.material(house.m.timber);
  for (const double x : {x0 + 0.08, x1 - 0.08}) {
    for (const double side : {-1.0, 1.0}) drawPost(b, {x, side * (z - 0.35)}, 0.12, 0, height - 0.1);
    b.box({x - 0.06, height - 0.2, -z}, {0.12, 0.14, 2 * z});
  }
  const int rafters = repeatCount(2 * z, 1.5);
  for (int i = 0; i <= rafters; ++i) b.box({x0, height - 0.06, -z + (2 * z - 0.08) * i / rafters}, {wide, 0.06, 0.08});
  for (const double side : {-1.0, 1.0}) {
    b.material(house.m.timber);
    b.box({half.x - in - 0.8, 0, side > 0 ? 0.15 : -z}, {0.8, 0.5, z - 0.15});
    b.material(house.m.green);
    b.box({half.x - in - 0.74, 0.5, side > 0 ? 0.21 : -z + 0.06}, {0.68, 0.32, z - 0.27});
  }
}

// Ranges are such that the core always fits behind the glass (4 m into 9 m less twice 1.1 m), and beside it the pergola.
std::vector<Parameter> helixParameters() {
  std::vector<Parameter> p(kHelixParameterCount);
  p[kFloors] = countParameter("Floors", "Number of floors", {7, 2, 16, 1}, "floor",
      {"Tower", "How many floors of flats there are over the open ground floor.",
       "@Handle(scope=Storeys, type=linear-contour, orient=up, slip=scope, align=left, occlusion=false, indirect)"});
  p[kFloorHeight] = lengthParameter("FloorHeight", "Floor height", {3.2, 2.8, 4, 0.05},
      {"Tower", "How high each floor is, from one slab to the next.",
       "@Handle(scope=Storey, type=linear-contour, orient=up, slip=scope, align=left, occlusion=false, chained)"});
  p[kTwist] = angleParameter("TwistPerFloor", "Twist per floor", {10, 0, 20, 1},
      {"Tower", "How far each floor is turned against the one below it.",
       "@Handle(scope=Twist, type=angular, orient=up, slip=none)"});
  p[kWidth] = lengthParameter("Width", "Floor width", {12, 9.5, 16, 0.1},
      {"Floors", "How wide each floor is, from edge to edge of its slab.",
       "@Handle(scope=Floor, type=linear-contour, orient=right, slip=scope, align=bottom, min-length=90)"});
  p[kDepth] = lengthParameter("Depth", "Floor depth", {10, 9, 14, 0.1},
      {"Floors", "How deep each floor is, from edge to edge of its slab.",
       "@Handle(scope=Floor, type=linear-contour, orient=back, slip=scope, align=bottom, min-length=90)"});
  p[kSlabThickness] = lengthParameter("SlabThickness", "Slab thickness", {0.45, 0.25, 0.7, 0.05},
      {"Floors", "How thick the concrete of each floor is.",
       "@Handle(scope=Floor, type=linear-contour, orient=up, slip=scope)"});
  p[kGroundHeight] = lengthParameter("GroundHeight", "Ground floor height", {3.8, 3, 6, 0.1},
      {"Ground floor", "How high the columns lift the tower above its plaza.",
       "@Handle(scope=GroundFloor, type=linear-contour, orient=up, slip=scope, align=right)"});
  p[kColumnSpacing] = lengthParameter("ColumnSpacing", "Column spacing", {3.4, 2, 5, 0.1},
      {"Ground floor", "About how far apart the columns are; each side takes as many as fit evenly.",
       "@Handle(scope=ColumnBay, type=linear-contour, orient=right, slip=scope, chained, indirect)"});
  p[kColumnDiameter] = lengthParameter("ColumnDiameter", "Column diameter", {0.45, 0.3, 0.9, 0.05},
      {"Ground floor", "How thick the columns are.",
       "@Handle(scope=Column, type=diametric, orient=up, slip=billboard)"});
  p[kCoreWidth] = lengthParameter("CoreWidth", "Core width", {3.2, 2.4, 4, 0.1},
      {"Core", "How wide the core with stairs and lift is; it stands still while the floors turn.",
       "@Handle(scope=StairHead, type=linear-contour, orient=right, slip=scope)"});
  p[kStairHeadHeight] = lengthParameter("StairHeadHeight", "Stair head height", {2.8, 2.4, 5, 0.1},
      {"Core", "How far the core rises above the roof.",
       "@Handle(scope=StairHead, type=linear-center, orient=up, slip=billboard)"});
  p[kFacade] = choiceParameter("Facade", "Facade", 0, {"glass", "louvres", "panels"},
      {"Floors", "What the outer walls are: glass alone, glass behind timber louvres, or glass between timber panels.",
       "@Handle(scope=Facade, type=range, orient=right)"});
  p[kRoofGarden] = switchParameter("RoofGarden", "Roof garden", true,
      {"Core", "Planters and a pergola on the roof.",
       "@Handle(scope=RoofGarden, type=boolean, orient=up)"});
  return p;
}

/// The twist opens from the front of one floor towards that of the next. It is shown on the roof, and on the plaza for who looks from low down.
void nameTwist(const House& house) {
  const double reach = 0.45 * house.helix.depth;
  nameBox(house.b, "Twist", {0, 0, 0}, {reach, 0, reach});
}

Scene buildHelixHouse(const Values& values) {
  const Helix helix(values);
  Builder b;
  const Palette m(b);
  const House house{b, helix, m};
  const double x = 0.5 * helix.width + kPlazaMargin, z = 0.5 * helix.depth + kPlazaMargin;
  b.material(m.paving);
  b.box({-x, 0, -z}, {2 * x, kPlaza, 2 * z});
  b.push([&] {
    b.translate({0, kPlaza, 0});
    nameTwist(house);
  });
  drawColonnade(house);
  drawTower(house);
  drawCore(house);
  b.push([&] {
    b.translate({0, helix.roofY(), 0});
    b.rotate(Axis::kY, (helix.floors - 1) * helix.twistRad);
    nameTwist(house);
    b.rotate(Axis::kY, helix.twistRad);
    drawRoof(house);
  });
  return b.finish();
}

}  // namespace

ModelDefinition defineHelixHouse() {
  return {"helix-house", "Helix house", helixParameters(), buildHelixHouse,
          {lengthMeasure("OverallHeight", "Overall height", "How high the building is, up to its highest point.",
                         "@Handle(scope=Model, type=linear-contour, orient=up, slip=scope, align=right, occlusion=false)")}};
}

}  // namespace dimline
