#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/house_parts.h"

// What is fixed to a roof. Scope: the roof's base, in which Roof gives its edges.

namespace dimline::house {

namespace {

/// How far down the slope the underside's outer edge lies from the upper one, which is where a slope's scope begins.
double undersideStart(const Plan& plan) { return -kRoofSlab * std::tan(plan.pitchRad); }

/// A half-round trough, open above.
Ring gutterSection() {
  return {{-0.07, 0}, {-0.05, -0.055}, {0, -0.078}, {0.05, -0.055},  {0.07, 0},
          {0.058, 0}, {0.04, -0.046},  {0, -0.066}, {-0.04, -0.046}, {-0.058, 0}};
}

constexpr double kGutterOut = 0.075;  // the gutter's middle from the fascia

void drawDownpipe(const House& house, const Segment& eave, double x) {
  Builder& b = house.b;
  const double top = eave.start.y - 0.08, out = eave.start.z + kGutterOut;
  const double wall = b.size().z + 0.075, ground = -(kPlinth + house.plan.wallHeight + house.plan.kneeHeight);
  const double bend = top - 0.12, neck = bend - std::max((out - wall) * 0.6, 0.05);
  const Vec3 path[] = {
      {x, top, out}, {x, bend, out}, {x, neck, wall}, {x, ground + 0.22, wall}, {x, ground + 0.08, wall + 0.1}};
  Builder::SweepOptions options;
  options.up = {1, 0, 0};
  b.sweep(ellipseRing({0, 0}, {0.042, 0.042}, 8), path, options);
}

}  // namespace

void drawRidges(const House& house, const Roof& roof) {
  Builder& b = house.b;
  b.material(house.m.clay);
  const Ring section = ellipseRing({0, 0}, {0.12, 0.085}, 10);
  for (const Segment& s : roof.ridges) {
    const Vec3 path[] = {s.start, s.end};
    b.sweep(section, path);
  }
}

void drawRainwater(const House& house, const Roof& roof) {
  Builder& b = house.b;
  b.material(house.m.metal);
  const Vec3 down(0, -0.02, 0);
  if (roof.eaves.size() == 4) {
    // Round the corners in one piece.
    std::vector<Vec3> path;
    for (const Segment& e : roof.eaves) {
      const Vec3 way = glm::normalize(e.end - e.start), out = glm::cross(way, Vec3(0, 1, 0));
      path.push_back(e.start + (out - way) * kGutterOut + down);
    }
    Builder::SweepOptions options;
    options.closed = true;
    b.sweep(gutterSection(), path, options);
  } else {
    for (const Segment& e : roof.eaves) {
      const Vec3 out = glm::cross(glm::normalize(e.end - e.start), Vec3(0, 1, 0)) * kGutterOut + down;
      const Vec3 path[] = {e.start + out, e.end + out};
      b.sweep(gutterSection(), path);
    }
  }
  const auto pipes = [&] {
    for (const double x : {0.14, b.size().x - 0.14}) drawDownpipe(house, roof.eaves[0], x);
  };
  pipes();
  if (roof.eaves.size() > 1) {
    b.push([&] {
      b.rotate(Axis::kY, std::numbers::pi, {0.5, 0, 0.5});
      pipes();
    });
  }
}

void drawRafters(const House& house, const Roof& roof, bool hip) {
  Builder& b = house.b;
  const double tip = undersideStart(house.plan) + 0.05, length = house.plan.overhang / std::cos(house.plan.pitchRad);
  const double z = -kRoofSlab, deep = z - 0.15;
  b.material(house.m.timber);
  const PartId rafter = b.part({0.09, 0, 0}, [&] {
    // Seen from the side, in (z, y): the tail is cut back so that it stays slender at the tip.
    b.extrudePolygon(Ring{{z, tip},
                          {z - 0.06, tip},
                          {deep, tip + std::min(0.16, length * 0.5)},
                          {deep, tip + length},
                          {z, tip + length}},
                     Axis::kX);
  });
  b.slopes(roof, [&](int) {
    const double keep = hip ? house.plan.overhang + 0.1 : 0.12, run = b.size().x - 2 * keep;
    const int gaps = repeatCount(run, 0.72);
    b.translate({keep - 0.045, 0, 0});
    for (int i = 0; i <= gaps; ++i) {
      b.place(rafter);
      b.translate({run / gaps, 0, 0});
    }
  });
}

void drawPurlins(const House& house, const Roof& roof) {
  Builder& b = house.b;
  const double w = b.size().x, d = b.size().z, reach = house.plan.overhang - 0.1;
  const double drop = kRoofSlab / std::cos(house.plan.pitchRad);
  b.material(house.m.timber);
  for (const double z : {d * 0.25, d * 0.5, d * 0.75}) {
    const double top = roof.heightAt(w * 0.5, z) - drop + (z == d * 0.5 ? -0.02 : 0.04);
    for (const double x : {-reach, w}) b.box({x, top - 0.2, z - 0.07}, {reach, 0.2, 0.14});
  }
}

void drawChimney(const House& house, const Roof& roof, const Vec2& at) {
  Builder& b = house.b;
  const double w = 0.74, d = 0.52, height = house.plan.chimneyHeight;
  double low = roof.heightAt(at.x, at.y), contact = low;
  for (const double x : {at.x - w * 0.5, at.x + w * 0.5}) {
    for (const double z : {at.y - d * 0.5, at.y + d * 0.5}) {
      low = std::min(low, roof.heightAt(x, z));
      contact = std::max(contact, roof.heightAt(x, z));
    }
  }
  b.push([&] {
    b.translate({at.x - w * 0.5, contact, at.y - d * 0.5});
    b.scale({w, height, d});
    b.name("Chimney");
    const double pot = 0.26, slab = 0.07, stack = height - pot - slab, foot = contact - low + kRoofSlab * 0.5;
    b.material(house.m.brick);
    b.box({0, -foot, 0}, {w, foot + stack, d});
    b.box({-0.04, stack - 0.16, -0.04}, {w + 0.08, 0.1, d + 0.08});
    b.material(house.m.stone);
    b.box({-0.06, stack, -0.06}, {w + 0.12, slab, d + 0.12});
    b.material(house.m.clay);
    const Vec2 profile[] = {{0.115, 0},   {0.095, pot - 0.05}, {0.125, pot - 0.05},
                            {0.125, pot}, {0.08, pot},         {0.08, 0.1}};
    for (const double x : {w * 0.27, w * 0.73}) {
      b.push([&] {
        b.translate({x, stack + slab, d * 0.5});
        b.scale(Vec3(0.0));
        b.lathe(profile, {12, 0.7});
      });
    }
  });
}

}  // namespace dimline::house
