#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "models/boat_parts.h"
#include "models/vocabulary.h"

namespace dimline::boat {

// Oak, tarred below the rails; the upper works in the dull red, green and ochre that ships were painted with, and a
// little gilt where the light catches it. The sails are the brightest thing.
Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  tallow = paint(b, 0xCBBE9F, 0.85F, kPlanks);
  oak = paint(b, 0x9A6B42, 0.75F, kPlanks);
  darkOak = paint(b, 0x6B4A30, 0.75F, kPlanks);
  tar = paint(b, 0x3A2E26, 0.7F);
  deck = paint(b, 0xC9A97C, 0.8F, kPlanks);
  ochre = paint(b, 0xC8973F, 0.7F);
  red = paint(b, 0x8E3B2E, 0.7F, kPlanks);
  green = paint(b, 0x47624F, 0.7F, kPlanks);
  gilt = paint(b, 0xD9AF55, 0.35F, kMetal);
  glass = paint(b, 0x4A5F66, 0.08F, kGlass);
  iron = paint(b, 0x33363A, 0.45F, kMetal);
  spar = paint(b, 0xB98A55, 0.7F);
  canvas = paint(b, 0xFAF3E2, 0.9F, kFabric);
  cloth = paint(b, 0xF4EBD7, 0.9F, kFabric);
  hemp = paint(b, 0x9C8358, 0.9F);
  tarredRope = paint(b, 0x3B322A, 0.85F);
  flagRed = paint(b, 0xB23A34, 0.85F, kFabric);
  flagWhite = paint(b, 0xF0EADC, 0.85F, kFabric);
  flagBlue = paint(b, 0x35507A, 0.85F, kFabric);
  shadow = paint(b, 0x231C18, 0.95F);
  light = paint(b, 0xFFE9B8, 0.3F);
}

Vec3 mirrored(const Vec3& p, int side) { return {p.x, p.y, p.z * side}; }

void enterFrame(Builder& b, const Vec3& origin, const std::array<Vec3, 3>& axes, const Vec3& size) {
  const Obb s = b.scope();
  const auto turned = [&](const Vec3& d) { return s.axes[0] * d.x + s.axes[1] * d.y + s.axes[2] * d.z; };
  b.translate(origin);
  b.setScope({b.scope().origin, {turned(axes[0]), turned(axes[1]), turned(axes[2])}, size});
}

void drawStrake(const Ship& ship, const Ring& section, double fromX, double toX, double h, int side) {
  const HullLine line(ship.plan.hull, h);
  const double from = line.uAt(fromX), to = std::min(line.uAt(toX), 0.999);
  // Closer together towards the bow, where the side turns in.
  const int steps = std::max(4, static_cast<int>(std::ceil((to - from) * 24)));
  const auto curve = [](double u) { return 1 - power(1 - u, 1 / 1.5); };
  const double first = curve(from), last = curve(to);
  std::vector<Vec3> way;
  for (int i = 0; i <= steps; ++i) {
    const double w = first + (last - first) * i / steps;
    const double u = i == 0 ? from : i == steps ? to : 1 - (1 - w) * std::sqrt(1 - w);   // to the power of 3/2
    way.push_back(mirrored(line.side(u), side));
  }
  // To the right of the way is outboard on the starboard side; on the port side the way runs aft.
  if (side < 0) std::reverse(way.begin(), way.end());
  Builder::SweepOptions options;
  options.bendRad = 0.6;
  ship.b.sweep(section, way, options);
}

void drawSpar(const Ship& ship, const Vec3& from, const Vec3& to, std::span<const Vec2> profile, int segments) {
  Builder& b = ship.b;
  const double length = glm::length(to - from);
  const Vec3 up = (to - from) / length;
  const Vec3 aside = glm::normalize(glm::cross(std::abs(up.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), up));
  std::vector<Vec2> scaled(profile.begin(), profile.end());
  for (Vec2& p : scaled) p.y *= length;
  b.push([&] {
    enterFrame(b, from, {aside, up, glm::cross(aside, up)});
    b.lathe(scaled, {segments, 0.7});
  });
}

void drawRope(const Ship& ship, std::span<const Vec3> way, double radiusM, int sides) {
  const Vec3 d = way[1] - way[0];
  Builder::SweepOptions options;
  options.up = std::abs(d.y) > 0.7 * glm::length(d) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  options.creaseRad = 2.2;
  options.bendRad = 0.6;
  ship.b.sweep(ellipseRing({0, 0}, {radiusM, radiusM}, sides), way, options);
}

void drawRope(const Ship& ship, const Vec3& from, const Vec3& to, double radiusM, int sides) {
  const Vec3 way[] = {from, to};
  drawRope(ship, way, radiusM, sides);
}

void drawSlackRope(const Ship& ship, const Vec3& from, const Vec3& to, double sagM, double radiusM) {
  constexpr int kSteps = 6;
  std::vector<Vec3> way;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    way.push_back(glm::mix(from, to, t) - Vec3(0, sagM * 4 * t * (1 - t), 0));
  }
  drawRope(ship, way, radiusM);
}

void enterSide(const Ship& ship, double x, double h, int side) {
  const HullLine line(ship.plan.hull, h);
  const double reach = 0.3;
  const Vec3 along = line.sideAt(x + reach) - line.sideAt(x - reach);
  const Vec3 ahead = glm::normalize(mirrored({along.x, 0, along.z}, side));
  const Vec3 out = glm::cross(ahead, Vec3(0, 1, 0)) * static_cast<double>(side);
  // Right-handed with z outboard: x runs to the right seen from outside, forward on the starboard side.
  enterFrame(ship.b, mirrored(line.sideAt(x), side), {ahead * static_cast<double>(side), {0, 1, 0}, out});
}

void nameBetween(const Ship& ship, std::string_view name, const Vec3& a, const Vec3& b) {
  nameBox(ship.b, name, glm::min(a, b), glm::max(a, b));
}

}  // namespace dimline::boat
