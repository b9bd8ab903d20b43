#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "models/models.h"
#include "models/mouldings.h"
#include "models/vocabulary.h"

// Three towers with one parameter, the floor area of all storeys together. The line that shows it measures the height, and
// how much floor a metre of height gives is what sets them apart: always as much, less and less, less by steps.
//
// A tower's form says how wide its square plan is at each height. From the area follows the height at which the form holds so much
// floor, from that the number of storeys; as they are whole, the plan is made a little larger or smaller until their areas add up.

namespace dimline {

namespace {

constexpr double kFloorHeight = 3.6;   // about (m): the storeys divide the height evenly

/// Width of the plan (m) at a height above the ground.
using Form = std::function<double(double)>;

struct Floor {
  double y, height, width;
};

/// Floor area (m2) that the form holds up to a height. A sum of thin slices: forms may have steps.
double heightFor(const Form& form, double areaM2) {
  constexpr double kSlice = 0.05;
  double area = 0;
  for (double y = 0;; y += kSlice) {
    const double width = form(y + 0.5 * kSlice), more = width * width / kFloorHeight * kSlice;
    if (area + more >= areaM2) return y + kSlice * (areaM2 - area) / more;
    area += more;
  }
}

std::vector<Floor> floorsFor(const Form& form, double areaM2) {
  const double height = heightFor(form, areaM2);
  const int count = std::max(1, static_cast<int>(std::lround(height / kFloorHeight)));
  std::vector<Floor> floors;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double y = height * i / count, width = form(height * (i + 0.5) / count);
    floors.push_back({y, height / count, width});
    sum += width * width;
  }
  const double fit = std::sqrt(areaM2 / sum);
  for (Floor& f : floors) f.width *= fit;
  return floors;
}

struct Look {
  std::uint32_t slab, fin, glass, crown;
  double finSpacing;
};

struct Palette {
  MaterialId slab, fin, glass, crown, paving, dark, leaves;
};

/// Scope: a storey's box. A slab all around, glass behind it, fins from slab to slab.
void drawFloor(Builder& b, const Palette& m, const Look& look) {
  const Vec3 n = b.size();
  constexpr double kSlab = 0.42, kBack = 0.28;
  nameBox(b, "FloorPlate", Vec3(0.0), n);
  b.material(m.slab);
  b.box({0, n.y - kSlab, 0}, {n.x, kSlab, n.z});
  b.material(m.glass);
  b.box({kBack, 0, kBack}, {n.x - 2 * kBack, n.y - kSlab, n.z - 2 * kBack});
  b.material(m.fin);
  b.faces(kSideFaces, [&](Face) {
    b.repeat(Axis::kX, look.finSpacing, [&](int i, int) {
      if (i > 0) b.box({-0.07, 0, -kBack - 0.02}, {0.14, n.y - kSlab, kBack + 0.1});
    });
  });
  // The corners are closed.
  for (const double x : {0.0, n.x - 0.5}) {
    for (const double z : {0.0, n.z - 0.5}) b.box({x, 0, z}, {0.5, n.y - kSlab, 0.5});
  }
}

/// Scope: the roof's square. Parapet, plant room, mast.
void drawCrown(Builder& b, const Palette& m) {
  const double w = b.size().x;
  b.material(m.crown);
  drawMoulding(b, {w, w}, {{-0.4, 0}, {0, 0}, {0, 0.9}, {0.06, 0.9}, {0.06, 1.05}, {-0.46, 1.05}, {-0.46, 0.9}, {-0.4, 0.9}});
  b.material(m.dark);
  b.box({0.25 * w, 0, 0.25 * w}, {0.5 * w, 2.6, 0.5 * w});
  b.material(m.slab);
  b.box({0.24 * w, 2.6, 0.24 * w}, {0.52 * w, 0.25, 0.52 * w});
}

/// A tree in a round tub. Scope: its middle is the origin.
PartId makeTree(Builder& b, const Palette& m) {
  return b.part(Vec3(0.0), [&] {
    b.material(m.slab);
    b.push([&] {
      b.translate({-0.75, 0, -0.75});
      b.scale({1.5, 0.55, 1.5});
      b.cylinder({.segments = 16});
    });
    b.material(m.dark);
    b.box({-0.07, 0.5, -0.07}, {0.14, 1.7, 0.14});
    b.material(m.leaves);
    b.translate({-1.1, 1.9, -1.1});
    b.scale({2.2, 2.5, 2.2});
    b.sphere({.segments = 12});
  });
}

/// Steps, paving, trees, and a canopy over the doors in front. Scope: the ground floor's square.
void drawForecourt(Builder& b, const Palette& m) {
  const double w = b.size().x, middle = 0.5 * w;
  b.material(m.paving);
  b.box({-5, -0.3, -5}, {w + 10, 0.15, w + 10});
  b.box({-4, -0.15, -4}, {w + 8, 0.15, w + 8});
  b.material(m.crown);
  b.box({middle - 4, 2.75, w - 0.3}, {8, 0.28, 3.2});
  for (const double x : {middle - 3.7, middle + 3.45}) b.box({x, 0, w + 2.4}, {0.25, 2.75, 0.25});
  // Doors: a frame with four leaves of glass.
  b.material(m.dark);
  for (int i = 0; i <= 4; ++i) b.box({middle - 2.5 + 1.22 * i, 0, w - 0.3}, {0.12, 2.75, 0.5});
  b.box({middle - 2.5, 2.2, w - 0.3}, {5, 0.12, 0.46});
  b.material(m.glass);
  b.box({middle - 2.45, 0, w - 0.3}, {4.9, 2.7, 0.4});
  const PartId tree = makeTree(b, m);
  for (const double side : {-1.0, 1.0}) {
    for (const double out : {6.0, 9.5}) {
      if (out > middle - 0.5) continue;   // a slender tower has a short front
      b.push([&] {
        b.translate({middle + side * out, 0, w + 2.2});
        b.place(tree);
      });
    }
  }
}

Scene build(const Form& form, const Look& look, double areaM2) {
  Builder b;
  using enum Material::Pattern;
  const Palette m{paint(b, look.slab, 0.7F), paint(b, look.fin, 0.5F), paint(b, look.glass, 0.06F, kGlass), paint(b, look.crown, 0.6F),
                  paint(b, 0xB9B3A9, 0.9F, kStone), paint(b, 0x6E7478, 0.6F, kMetal), paint(b, 0x6F8F5C, 0.9F, kLeaves)};
  const std::vector<Floor> floors = floorsFor(form, areaM2);
  const double base = floors.front().width, height = floors.back().y + floors.back().height;
  constexpr double kGround = 0.3;
  b.translate({-0.5 * base, kGround, -0.5 * base});
  b.scale({base, height, base});
  b.name("Tower");
  drawForecourt(b, m);
  // Storeys of one width are drawn once.
  double width = -1;
  PartId part = 0;
  for (const Floor& f : floors) {
    if (std::abs(f.width - width) > 1e-9) {
      width = f.width;
      part = b.part({f.width, f.height, f.width}, [&] { drawFloor(b, m, look); });
    }
    b.push([&] {
      b.translate({0.5 * (base - f.width), f.y, 0.5 * (base - f.width)});
      b.place(part);
    });
  }
  // Roofs: where the storey above stands back, and at the top.
  for (std::size_t i = 1; i < floors.size(); ++i) {
    const Floor &below = floors[i - 1], &above = floors[i];
    if (below.width - above.width < 2) continue;
    b.push([&] {
      b.translate({0.5 * (base - below.width), above.y, 0.5 * (base - below.width)});
      b.material(m.crown);
      drawMoulding(b, {below.width, below.width}, {{-0.3, 0}, {0, 0}, {0, 1.0}, {-0.3, 1.0}});
    });
  }
  b.push([&] {
    const double top = floors.back().width;
    b.translate({0.5 * (base - top), height, 0.5 * (base - top)});
    b.scale({top, 0, top});
    drawCrown(b, m);
  });
  return b.finish();
}

struct AreaRange {
  double value, min, max, step;
};

std::vector<Parameter> parameters(const AreaRange& range, std::string_view colour) {
  Parameter p = lengthParameter("FloorArea", "Total floor area", {range.value, range.min, range.max, range.step},
      {"Building", "The floor area of all storeys together; the tower grows until it holds so much.",
       "@Handle(scope=Tower, type=linear-contour, orient=up, slip=scope, indirect, skin=sphere, color=" + std::string(colour) + ")"});
  p.unit = Unit::kSquareMetre;
  return {p};
}

std::vector<Measure> towerMeasures() {
  return {lengthMeasure("Height", "Height", "How high the tower is, from the forecourt to its roof.",
                        "@Handle(scope=Tower, type=linear-contour, orient=up, slip=scope, occlusion=false)")};
}

}  // namespace

// Straight: 800 m2 in every storey, so steps of 800 are whole storeys.
ModelDefinition defineLinearTower() {
  const auto scene = [](const Values& values) {
    return build([](double) { return std::sqrt(800.0); }, {0xE7E0D6, 0xC24A3A, 0x40535F, 0xDDD5C9, 2.4}, values.at(0));
  };
  return {"floor-area-linear", "Floor area, straight tower", parameters({16000, 4000, 28000, 800}, "#c0392b"), scene, towerMeasures()};
}

// Tapered: the walls lean in, and the last storeys hold little.
ModelDefinition defineTaperedTower() {
  const auto scene = [](const Values& values) {
    return build([](double y) { return std::max(30.0 - 0.13 * y, 8.0); }, {0xE4E6DE, 0x3F7F5B, 0x3F5650, 0xD5DACF, 2.4}, values.at(0));
  };
  return {"floor-area-tapered", "Floor area, tapered tower", parameters({13000, 3000, 17500, 250}, "#2e8b57"), scene, towerMeasures()};
}

// Stepped: the plan shrinks by 7 m, and then less, with every sixth storey.
ModelDefinition defineSteppedTower() {
  const auto scene = [](const Values& values) {
    const Form form = [](double y) {
      constexpr double kWidths[] = {38, 31, 25, 20, 15};
      const auto tier = static_cast<std::size_t>(y / (6 * kFloorHeight));
      return kWidths[std::min<std::size_t>(tier, 4)];
    };
    return build(form, {0xDFE3E8, 0x3B6BA5, 0x3C4F63, 0xCFD6DE, 2.4}, values.at(0));
  };
  return {"floor-area-stepped", "Floor area, stepped tower", parameters({19000, 5000, 24000, 250}, "#2f6fb7"), scene, towerMeasures()};
}

}  // namespace dimline
