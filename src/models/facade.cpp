#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "models/models.h"
#include "models/mouldings.h"
#include "models/vocabulary.h"

// One street front with a grid of windows. All sit on sills of one height and are equally high; each is as wide as its own chance makes
// it, so the width that is asked for is their average, and no single one shows it.

namespace dimline {

namespace {

enum Index { kSillHeight, kWindowWidth, kWindowHeight, kParameterCount };

constexpr int kStoreys = 4, kBays = 5;
constexpr double kPlinth = 0.6, kStorey = 3.5, kBay = 3.2, kMargin = 0.7, kDepth = 6, kWall = 0.42, kReveal = 0.2, kSurround = 0.14;
constexpr double kWidth = kBays * kBay + 2 * kMargin, kTop = kPlinth + kStoreys * kStorey;

// Sound together: the highest sill and window leave 0.3 m in a storey, the widest window (1.7 m times 1.53) 0.6 m to one as wide.
std::vector<Parameter> parameters() {
  std::vector<Parameter> p(kParameterCount);
  p[kSillHeight] = lengthParameter("SillHeight", "Windowsill height", {0.9, 0.3, 1.2, 0.05},
      {"Windows", "How high the windows begin above the floor of their storey.",
       "@Handle(scope=Sill, type=linear-contour, orient=up, slip=scope, align=right, chained)"});
  p[kWindowWidth] = lengthParameter("WindowWidth", "Average window width", {1.3, 0.8, 1.7, 0.05},
      {"Windows", "How wide the windows are on average; each one is this times a random number of its own.",
       "@Handle(scope=Window, type=linear-contour, orient=right, slip=scope, align=top, chained, indirect)"});
  p[kWindowHeight] = lengthParameter("WindowHeight", "Window height", {1.7, 1.0, 2.0, 0.05},
      {"Windows", "How high every window is.",
       "@Handle(scope=Window, type=linear-contour, orient=up, slip=scope, align=right, chained)"});
  return p;
}

using Grid = std::array<std::array<double, kBays>, kStoreys>;

/// By what each window's width is multiplied: always the same for the same window, 0.6 to 1.5 before all are brought to an average of 1.
Grid widthFactors() {
  Grid factors;
  double sum = 0;
  std::uint32_t seed = 11;
  for (auto& storey : factors) {
    for (double& factor : storey) {
      std::uint32_t h = seed++ * 2654435761U;
      h = (h ^ (h >> 15)) * 2246822519U;
      h ^= h >> 13;
      factor = 0.6 + 0.9 * static_cast<double>(h % 1000) / 999;
      sum += factor;
    }
  }
  for (auto& storey : factors) {
    for (double& factor : storey) factor *= kStoreys * kBays / sum;
  }
  return factors;
}

struct Palette {
  explicit Palette(Builder& b);
  MaterialId plaster, band, stone, frame, glass, iron, tiles, side, box, leaves, blossom, curtain;
};

Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  plaster = paint(b, 0xD9A98C, 0.9F, kPlaster);
  band = paint(b, 0xEFE4D4, 0.8F);
  stone = paint(b, 0xB5ABA0, 0.85F, kStone);
  frame = paint(b, 0x3F5A55, 0.5F);
  glass = paint(b, 0x3E5562, 0.06F, kGlass);
  iron = paint(b, 0x33383B, 0.5F, kMetal);
  tiles = paint(b, 0x8F5542, 0.8F, kRoofTiles);
  side = paint(b, 0xC9BBA9, 0.9F, kBrick);
  box = paint(b, 0x9A5B45, 0.85F);
  leaves = paint(b, 0x5E7F4F, 0.9F, kLeaves);
  blossom = paint(b, 0xC4474B, 0.8F);
  curtain = paint(b, 0xE9E2D3, 0.9F, kFabric);
}

/// Scope: the opening, z = 0 the wall's face. Leaves of at most 0.9 m, each with a bar.
void drawWindow(Builder& b, const Palette& m) {
  const double w = b.size().x, h = b.size().y, bar = 0.06;
  const int leaves = std::max(1, static_cast<int>(std::ceil(w / 0.9 - 1e-9)));
  const double pane = (w - bar * (leaves + 1)) / leaves, transom = 0.68 * h;
  b.push([&] {
    b.translate({0, 0, -kReveal - 0.08});
    b.scale(Axis::kZ, 0.08);
    Polygon frame{rectangleRing({0, 0}, {w, h}), {}};
    for (int i = 0; i < leaves; ++i) {
      const double x = bar + i * (pane + bar);
      frame.holes.push_back(rectangleRing({x, bar}, {x + pane, transom}));
      frame.holes.push_back(rectangleRing({x, transom + bar}, {x + pane, h - bar}));
    }
    b.material(m.frame);
    b.extrudePolygon(frame);
    b.material(m.glass);
    b.box({0.03, 0.03, 0.02}, {w - 0.06, h - 0.06, 0.02});
  });
  // Surround with a keystone, and the sill.
  const double s = kSurround;
  b.material(m.band);
  b.push([&] {
    b.translate({0, 0, -0.02});
    b.scale(Axis::kZ, 0.07);
    b.extrudePolygon(Ring{{-s, 0}, {0, 0}, {0, h}, {w, h}, {w, 0}, {w + s, 0}, {w + s, h + s}, {-s, h + s}});
    b.box({0.5 * w - 0.11, h - 0.02, 0}, {0.22, s + 0.08, 0.11});
  });
  b.box({-s - 0.06, -0.1, -kReveal}, {w + 2 * s + 0.12, 0.1, kReveal + 0.12});
}

/// A box of geraniums on the sill. Scope: as for a window.
void drawFlowers(Builder& b, const Palette& m) {
  const double w = b.size().x - 0.1;
  b.translate({0.05, 0, 0});
  b.material(m.box);
  b.box({0, 0, -0.12}, {w, 0.18, 0.22});
  b.material(m.leaves);
  b.translate({0.02, 0.1, -0.1});
  b.scale({w - 0.04, 0, 0.2});
  b.repeat(Axis::kX, 0.22, [&](int i, int) {
    b.scale({b.size().x * 1.15, 0.22 + 0.05 * (i % 3), 0.24});
    b.material(m.leaves);
    b.sphere({.segments = 8});
    b.material(m.blossom);
    b.translate({0.5 * b.size().x - 0.05, 0.72 * b.size().y, 0.03 + 0.08 * (i % 2)});
    b.scale({0.12, 0.12, 0.12});
    b.sphere({.segments = 8});
  });
}

/// A railing before a low window, so that nobody falls out. Scope: as for a window; the bars end 1.0 m above the floor.
void drawRailing(Builder& b, const Palette& m, double sill) {
  const double w = b.size().x, h = 1.0 - sill;
  b.material(m.iron);
  b.translate({0, 0, -0.05});
  b.box({0, h - 0.04, 0}, {w, 0.04, 0.04});
  b.box({0, 0.06, 0.005}, {w, 0.03, 0.03});
  b.scale({w, h, 0});
  b.repeat(Axis::kX, 0.12, [&](int i, int) {
    if (i > 0) b.box({-0.009, 0.07, 0.011}, {0.018, h - 0.09, 0.018});
  });
}

void drawFront(Builder& b, const Palette& m, const Values& values) {
  const double sill = values.at(kSillHeight), height = values.at(kWindowHeight);
  const Grid factors = widthFactors();
  for (int s = 0; s < kStoreys; ++s) {
    b.push([&] {
      b.translate({0, kPlinth + s * kStorey, 0});
      b.scale({kWidth, kStorey, 0});
      Polygon wall{rectangleRing({0, 0}, {kWidth, kStorey}), {}};
      for (int i = 0; i < kBays; ++i) {
        const double width = values.at(kWindowWidth) * factors[static_cast<std::size_t>(s)][static_cast<std::size_t>(i)], x = kMargin + (i + 0.5) * kBay - 0.5 * width;
        wall.holes.push_back(rectangleRing({x, sill}, {x + width, sill + height}));
        nameBox(b, "Window", {x, sill, -kReveal}, {x + width, sill + height, 0});
        nameBox(b, "Sill", {x, 0, -kReveal}, {x + width, sill, 0});
        b.push([&] {
          b.translate({x, sill, 0});
          b.scale({width, height, 0});
          b.push([&] { drawWindow(b, m); });
          if (s > 0 && sill < 0.7) {
            drawRailing(b, m, sill);
          } else if ((s * 3 + i * 2) % 4 == 1) {
            drawFlowers(b, m);
          }
        });
      }
      b.material(s == 0 ? m.stone : m.plaster);
      b.extrude(-kWall);
      b.extrudePolygon(wall);
    });
  }
  // A band under each storey, and the cornice.
  b.material(m.band);
  for (int s = 1; s < kStoreys; ++s) {
    b.push([&] {
      b.translate({0, kPlinth + s * kStorey - 0.12, -0.05});
      b.scale({kWidth, 0, 0});
      b.extrudePolygon(Ring{{0, 0}, {0.11, 0}, {0.16, 0.08}, {0.16, 0.18}, {0, 0.22}}, Axis::kX);
    });
  }
  b.push([&] {
    b.translate({-0.1, kTop - 0.15, -0.1});
    b.scale({kWidth + 0.2, 0, 0});
    Ring cornice{{0, 0}, {0.16, 0}, {0.2, 0.15}, {0.42, 0.15}, {0.42, 0.3}};
    addCyma(cornice, {0.45, 0.3}, {0.68, 0.56});
    cornice.insert(cornice.end(), {{0.68, 0.62}, {0, 0.62}});
    b.extrudePolygon(cornice, Axis::kX, 0.5);
    b.translate({0, -0.02, 0.15});
    b.repeat(Axis::kX, 0.5, [&](int, int) { b.box({0.5 * b.size().x - 0.09, 0, 0}, {0.18, 0.19, 0.2}); });
  });
}

/// Gables and a roof whose ridge runs along the street, with a stack of chimneys at each end.
void drawRoof(Builder& b, const Palette& m) {
  constexpr double kEave = kTop + 0.3, kRise = 2.1, kMiddle = 0.5 * kDepth;
  b.push([&] {
    b.translate({0, kEave, 0});
    b.scale(Axis::kX, kWidth);
    b.material(m.side);
    b.extrudePolygon(Ring{{0, 0}, {kDepth - 0.1, 0}, {kMiddle, kRise}}, Axis::kX);
    b.translate({-0.15, 0, 0});
    b.scale(Axis::kX, kWidth + 0.3);
    b.material(m.tiles);
    b.extrudePolygon(Ring{{-0.35, 0}, {kMiddle, kRise}, {kDepth + 0.35, 0}, {kDepth + 0.35, 0.16}, {kMiddle, kRise + 0.2}, {-0.35, 0.16}}, Axis::kX);
  });
  for (const double x : {1.6, kWidth - 2.8}) {
    b.material(m.side);
    b.box({x, kEave + 0.8, kMiddle - 1.2}, {1.2, 2.7, 0.7});
    b.box({x - 0.08, kEave + 3.5, kMiddle - 1.28}, {1.36, 0.16, 0.86});
    b.material(m.box);
    for (const double pot : {0.18, 0.68}) {
      b.push([&] {
        b.translate({x + pot, kEave + 3.66, kMiddle - 1.02});
        b.scale({0.34, 0.5, 0.34});
        b.cone(0.8, {.segments = 12});
      });
    }
  }
}

Scene build(const Values& values) {
  Builder b;
  const Palette m(b);
  b.translate({-0.5 * kWidth, 0, -0.5 * kDepth});
  b.scale({kWidth, kTop, kDepth});
  b.material(m.stone);
  b.box({-0.06, 0, 0}, {kWidth + 0.12, kPlinth, kDepth + 0.08});
  // The house behind it: party walls, and rooms that are dark behind their curtains.
  b.push([&] {
    b.translate({0, kPlinth, 0});
    b.scale(Axis::kY, kTop - kPlinth + 0.3);
    b.material(m.side);
    constexpr double kRooms = kDepth - kWall - 0.5, kFront = kDepth - kWall;
    b.extrudePolygon(Ring{{0, 0}, {kWidth, 0}, {kWidth, kFront}, {kWidth - 0.3, kFront}, {kWidth - 0.3, kRooms}, {0.3, kRooms}, {0.3, kFront}, {0, kFront}},
                     Axis::kY);
  });
  drawRoof(b, m);
  b.face(Face::kFront, [&] { drawFront(b, m, values); });
  return b.finish();
}

}  // namespace

ModelDefinition defineFacade() { return {"facade", "Facade", parameters(), build}; }

}  // namespace dimline
