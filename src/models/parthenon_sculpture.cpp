#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/parthenon_parts.h"

// The gods in the pediments and the flowers on the roof's corners: no portraits, but what one sees of them from the ground.

namespace dimline::parthenon {

namespace {

/// A body drawn along a path as a folded cloth: a ring with as many folds as half its points, `widths` as it swells and narrows.
void drawBody(Builder& b, const Vec2& radius, std::span<const Vec3> path, std::span<const double> widths) {
  constexpr int kPoints = 12;
  Ring ring;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints, fold = i % 2 == 0 ? 1 : 0.86;
    ring.emplace_back(fold * radius.x * std::cos(angle), fold * radius.y * std::sin(angle));
  }
  Builder::SweepOptions options;
  options.up = {0, 0, 1};
  options.creaseRad = 0.4;
  options.bendRad = 1;
  options.widths = widths;
  b.sweep(ring, path, options);
}

void drawHead(Builder& b, const Vec3& middle, double diameter) {
  b.push([&] {
    b.translate(middle - Vec3(0.5, 0.5, 0.5) * diameter);
    b.scale({diameter, 1.15 * diameter, diameter});
    b.sphere({.segments = 8});
  });
}

void drawArm(Builder& b, double thick, std::initializer_list<Vec3> path) {
  const std::vector<Vec3> points(path);
  Builder::SweepOptions options;
  options.up = {0, 0, 1};
  b.sweep(ellipseRing({0, 0}, Vec2(thick), 5), points, options);
}

// Figures stand on y = 0 with their middle at x = z = 0, facing z, h high. They turn to the left.

void drawStanding(Builder& b, double h) {
  const std::array<Vec3, 6> path{Vec3(0.02, 0, 0) * h, Vec3(0.03, 0.3, 0) * h, Vec3(0.01, 0.53, 0) * h, Vec3(0, 0.66, 0) * h, Vec3(0, 0.78, 0) * h,
                                 Vec3(-0.01, 0.85, 0) * h};
  drawBody(b, Vec2(0.155, 0.1) * h, path, std::array{1.0, 0.8, 0.66, 0.76, 0.8, 0.3});
  drawHead(b, Vec3(-0.015, 0.915, 0.01) * h, 0.13 * h);
  drawArm(b, 0.032 * h, {Vec3(-0.1, 0.77, 0) * h, Vec3(-0.24, 0.68, 0.02) * h, Vec3(-0.3, 0.86, 0.02) * h});
  drawArm(b, 0.032 * h, {Vec3(0.1, 0.77, 0) * h, Vec3(0.19, 0.6, 0.02) * h, Vec3(0.12, 0.48, 0.06) * h});
}

void drawSeated(Builder& b, double h) {
  b.box({-0.08 * h, 0, -0.12 * h}, {0.36 * h, 0.36 * h, 0.24 * h});
  const std::array<Vec3, 5> path{Vec3(-0.26, 0, 0) * h, Vec3(-0.24, 0.4, 0) * h, Vec3(0.06, 0.5, 0) * h, Vec3(0.1, 0.76, 0) * h, Vec3(0.08, 0.85, 0) * h};
  drawBody(b, Vec2(0.15, 0.14) * h, path, std::array{0.7, 0.75, 1.0, 0.95, 0.35});
  drawHead(b, Vec3(0.07, 0.92, 0.01) * h, 0.16 * h);
  drawArm(b, 0.04 * h, {Vec3(0.0, 0.74, 0.06) * h, Vec3(-0.16, 0.58, 0.08) * h, Vec3(-0.34, 0.66, 0.06) * h});
}

void drawReclining(Builder& b, double h) {
  const std::array<Vec3, 5> path{Vec3(-1.1, 0.12, 0) * h, Vec3(-0.5, 0.42, 0) * h, Vec3(0.02, 0.2, 0) * h, Vec3(0.34, 0.56, 0) * h, Vec3(0.4, 0.72, 0) * h};
  drawBody(b, Vec2(0.19, 0.2) * h, path, std::array{0.45, 0.7, 1.0, 0.95, 0.4});
  drawHead(b, Vec3(0.42, 0.86, 0.01) * h, 0.25 * h);
  drawArm(b, 0.06 * h, {Vec3(0.4, 0.6, 0.08) * h, Vec3(0.56, 0.3, 0.1) * h, Vec3(0.6, 0.06, 0.1) * h});
}

}  // namespace

PartId makePedimentFigures(const Parthenon& t, double halfM, double riseM) {
  Builder& b = t.b;
  struct Figure {
    double place;   // share of the way from the ridge to the eave
    void (*draw)(Builder&, double);
    double height;  // share of what there is under the raking geison
  };
  constexpr std::array<Figure, 7> kFigures{{{0.07, drawStanding, 0.95}, {0.19, drawStanding, 0.9}, {0.28, drawStanding, 0.93}, {0.37, drawSeated, 0.84},
                                            {0.46, drawSeated, 0.86}, {0.59, drawReclining, 0.72}, {0.74, drawReclining, 0.62}}};
  return b.part(Vec3(0.0), [&] {
    b.material(t.m.marble);
    for (const Figure& f : kFigures) {
      const double h = f.height * (riseM * (1 - f.place) - 0.1);
      const PartId figure = b.part(Vec3(0.0), [&] { f.draw(b, h); });
      // One side's figures are the other's turned about: behind, they are as well made as in front.
      for (const double side : {-1.0, 1.0}) {
        b.push([&] {
          b.translate({side * f.place * halfM, 0, 0});
          if (side < 0) b.rotate(Axis::kY, std::numbers::pi);
          b.place(figure);
        });
      }
    }
  });
}

PartId makeAcroterion(const Parthenon& t, double widthM, double heightM) {
  Builder& b = t.b;
  const double depth = 0.1 * heightM, foot = 0.3 * heightM;
  return b.part(Vec3(0.0), [&] {
    b.material(t.m.marble);
    b.box({-0.3 * widthM, -0.12, -depth}, {0.6 * widthM, 0.2, 2 * depth});
    // Two volutes at the foot, from which seven leaves rise in a fan, the middle one highest.
    for (const double side : {-1.0, 1.0}) {
      b.push([&] {
        const double r = 0.13 * heightM;
        b.translate({side * 0.24 * widthM, 0.08 + r, -0.5 * depth});
        b.rotate(Axis::kX, std::numbers::pi / 2);
        b.translate({-r, 0, -r});
        b.scale({2 * r, depth, 2 * r});
        b.cylinder({.segments = 14});
      });
    }
    for (int i = -3; i <= 3; ++i) {
      const double length = (heightM - foot) * (1 - 0.075 * std::abs(i)), wide = 0.085 * widthM, thick = depth * (0.7 + 0.12 * (3 - std::abs(i)));
      b.push([&] {
        b.translate({0, foot, -0.5 * thick});
        b.rotate(Axis::kZ, -0.4 * i);
        b.scale(Axis::kZ, thick);
        b.extrudePolygon(Ring{{-0.4 * wide, -0.3 * foot}, {0.4 * wide, -0.3 * foot}, {wide, 0.62 * length}, {0.8 * wide, 0.88 * length}, {0, length},
                              {-0.8 * wide, 0.88 * length}, {-wide, 0.62 * length}},
                         Axis::kZ, 0.5);
      });
    }
  });
}

}  // namespace dimline::parthenon
