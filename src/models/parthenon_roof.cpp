#include <array>
#include <cmath>
#include <numbers>

#include "models/parthenon_parts.h"
#include "models/vocabulary.h"

// Marble tiles on two slopes. The eaves are the geison's upper outer edges; x is counted from the ridge.

namespace dimline::parthenon {

namespace {

constexpr double kSlab = 0.25;     // roof, upright (m)
constexpr double kRaking = 0.42;   // height of the raking geison, upright

struct RoofPlan {
  double half, rise, length;       ///< from eave to ridge, level and upright; from gable to gable
};

/// A row of cover tiles from eave to ridge, each lying on the next lower one, with an antefix before the lowest. Scope: x along the eave,
/// y up the slope, z outwards.
PartId makeTileRow(const Parthenon& t, double slopeM) {
  Builder& b = t.b;
  return b.part({0, slopeM, 0}, [&] {
    b.material(t.m.tiles);
    b.repeat(Axis::kY, 1.9, [&](int, int) {
      const double length = b.size().y;
      b.rotate(Axis::kX, -0.035);
      b.translate({0, -0.06, 0.045});
      b.scale(Axis::kY, length + 0.05);
      b.extrudePolygon(Ring{{-0.15, -0.06}, {0.15, -0.06}, {0.12, 0.06}, {0, 0.13}, {-0.12, 0.06}}, Axis::kY);
    });
    // It stands upright, whatever the pitch.
    b.material(t.m.marble);
    b.rotate(Axis::kX, std::numbers::pi / 2 - t.plan.pitchRad);
    b.translate({0, -0.02, -0.02});
    b.scale(Axis::kZ, 0.1);
    b.extrudePolygon(Ring{{-0.17, 0}, {0.17, 0}, {0.2, 0.24}, {0.12, 0.4}, {0, 0.48}, {-0.12, 0.4}, {-0.2, 0.24}});
  });
}

/// What both gables have.
struct Ornament {
  PartId figures, ridgeFlower, cornerFlower;
};

/// Scope: a gable, x = 0 below the ridge, y = 0 on the geison, z = 0 the roof's edge and pointing out.
void drawPediment(const Parthenon& t, const RoofPlan& roof, const Ornament& ornament) {
  Builder& b = t.b;
  const double out = t.plan.overhang, slope = roof.rise / roof.half;
  // Tympanum, on the frieze's plane.
  b.push([&] {
    b.translate({0, 0, -out - 0.6});
    b.scale(Axis::kZ, 0.5);
    b.material(t.m.blue);
    const double half = roof.half - 0.3;
    b.extrudePolygon(Ring{{-half, 0}, {half, 0}, {0, half * slope}});
  });
  b.push([&] {
    b.translate({0, 0, -out - 0.2});
    b.scale(Axis::kZ, out + 0.12);
    b.material(t.m.marble);
    const double inner = roof.half - kRaking / slope;
    b.extrudePolygon(Ring{{-roof.half + 0.02, 0}, {-inner, 0}, {0, roof.rise - kRaking}, {inner, 0}, {roof.half - 0.02, 0}, {0, roof.rise}});
  });
  // The sima, a gutter's edge along the gable.
  b.push([&] {
    b.translate({0, kSlab - 0.04, -0.42});
    b.scale(Axis::kZ, 0.45);
    b.material(t.m.shade);
    b.extrudePolygon(Ring{{-roof.half, 0}, {0, roof.rise}, {roof.half, 0}, {roof.half + 0.06, 0.3}, {0, roof.rise + 0.32}, {-roof.half - 0.06, 0.3}});
  });
  b.push([&] {
    b.translate({0, 0, -0.5 * out - 0.1});
    b.place(ornament.figures);
  });
  const auto flower = [&](PartId part, double x) {
    b.push([&] {
      b.translate({x, (roof.half - std::abs(x)) * slope + kSlab + 0.25, -0.3});
      b.place(part);
    });
  };
  flower(ornament.ridgeFlower, 0);
  for (const double side : {-1.0, 1.0}) flower(ornament.cornerFlower, side * (roof.half - 0.7));
}

}  // namespace

void drawRoof(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  const double edge = p.faceInset() - p.overhang;
  RoofPlan roof{};
  roof.half = 0.5 * p.width - edge;
  roof.rise = roof.half * std::tan(p.pitchRad);
  roof.length = p.length - 2 * edge;
  b.translate({edge, p.roof(), edge});
  b.scale({2 * roof.half, roof.rise, roof.length});
  b.push([&] {
    b.translate({roof.half, 0, 0});
    b.material(t.m.tiles);
    b.extrudePolygon(Ring{{-roof.half, 0}, {0, roof.rise}, {roof.half, 0}, {roof.half, kSlab}, {0, roof.rise + kSlab}, {-roof.half, kSlab}});
    b.push([&] {
      b.translate({0, roof.rise + kSlab, 0.4});
      b.scale(Axis::kZ, roof.length - 0.8);
      b.extrudePolygon(Ring{{-0.28, -0.12}, {0.28, -0.12}, {0.22, 0.12}, {0, 0.24}, {-0.22, 0.12}});
    });
  });
  const Ornament ornament{makePedimentFigures(t, roof.half, roof.rise - kRaking), makeAcroterion(t, 2.5, 2.7), makeAcroterion(t, 1.4, 1.6)};
  b.faces(std::array{Face::kFront, Face::kBack}, [&](Face) {
    b.translate({roof.half, 0, 0});
    drawPediment(t, roof, ornament);
  });
  const PartId row = makeTileRow(t, roof.half / std::cos(p.pitchRad) - 0.15);
  b.faces(std::array{Face::kLeft, Face::kRight}, [&](Face) {
    b.translate({0.4, kSlab, 0});
    b.scale(Axis::kX, b.size().x - 0.8);
    b.rotate(Axis::kX, p.pitchRad - std::numbers::pi / 2);
    b.repeat(Axis::kX, 0.95, [&](int, int) {
      b.translate({0.5 * b.size().x, 0, 0});
      b.place(row);
    });
  });
  b.face(Face::kFront, [&] {
    b.scale({roof.half, roof.rise, 0});
    b.name("Pitch");
  });
}

}  // namespace dimline::parthenon
