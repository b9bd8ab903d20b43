#include <algorithm>
#include <cmath>

#include "models/house_parts.h"

// The roof and what is fixed to it. The storeys' box ends at the eaves: the roof's base lies higher by what the eave hangs down, so that the
// underside's outer edge is level with the box's top whatever pitch and overhang are.

namespace dimline::house {

namespace {

constexpr double kSlab = 0.22;     // thickness of a pitched roof
constexpr double kShedTop = 0.25;  // how far the upper roof of a shed reaches over the lower one
constexpr double kShedWall = 0.2;

Obb boxAround(const Builder& b, const Vec3& min, const Vec3& max) {
  Obb box = b.scope();
  box.origin = box.origin + box.axes[0] * min.x + box.axes[1] * min.y + box.axes[2] * min.z;
  box.size = max - min;
  return box;
}

void nameBox(Builder& b, std::string_view name, const Vec3& min, const Vec3& max) {
  b.push([&] {
    b.setScope(boxAround(b, min, max));
    b.name(name);
  });
}

/// The strips between the wall's faces and the roof's edge, one a side that has one; z is outwards. Scope: the roof's base.
void nameOverhangs(const House& house, std::span<const Face> sides, double low, double high) {
  Builder& b = house.b;
  const double o = house.plan.overhang;
  b.push([&] {
    b.translate({0, low, 0});
    b.scale(Axis::kY, high - low);
    b.faces(sides, [&](Face) {
      b.translate({-o, 0, 0});
      b.scale({b.size().x + 2 * o, b.size().y, o});
      b.name("Overhang");
    });
  });
}

/// The angle at the front eave, seen from the right and from the left: x runs level from the eave towards the ridge, y up, and the angle opens about z.
void namePitch(const House& house, double eaveY, double runM) {
  Builder& b = house.b;
  const double o = house.plan.overhang, rise = runM * std::tan(house.plan.pitchRad);
  b.face(Face::kRight, [&] {
    b.translate({-o, eaveY, o});
    b.scale({runM, rise, 0});
    b.name("Pitch");
  });
}

void drawRidges(const House& house, const Roof& roof) {
  Builder& b = house.b;
  b.material(house.m.clay);
  const Ring section = ellipseRing({0, 0.0}, {0.11, 0.09}, 10);
  for (const Segment& s : roof.ridges) {
    const Vec3 path[] = {s.start, s.end};
    b.sweep(section, path);
  }
}

void drawGutters(const House& house, const Roof& roof) {
  Builder& b = house.b;
  b.material(house.m.metal);
  const Ring section{{-0.07, 0}, {-0.05, -0.055}, {0, -0.075}, {0.05, -0.055},   {0.07, 0},
                     {0.06, 0},  {0.042, -0.046}, {0, -0.063}, {-0.042, -0.046}, {-0.06, 0}};
  for (const Segment& e : roof.eaves) {
    const Vec3 way = glm::normalize(e.end - e.start), out = glm::normalize(glm::cross(way, Vec3(0, 1, 0)));
    const Vec3 shift = out * 0.075 + Vec3(0, -0.02, 0);
    const Vec3 path[] = {e.start + shift, e.end + shift};
    b.sweep(section, path);
  }
}

/// Scope: the roof's base. `at` is the middle of the stack on plan.
void drawChimney(const House& house, const Vec2& at, double low, double contact) {
  Builder& b = house.b;
  const Vec2 size(0.72, 0.5);
  const double h = house.plan.chimneyHeight, top = contact + h;
  b.push([&] {
    b.translate({at.x - size.x * 0.5, contact, at.y - size.y * 0.5});
    b.scale({size.x, h, size.y});
    b.name("Chimney");
    b.translate({0, low - contact, 0});
    b.material(house.m.brick);
    b.box({0, 0, 0}, {size.x, top - low - 0.08, size.y});
    b.material(house.m.stone);
    b.box({-0.05, top - low - 0.08, -0.05}, {size.x + 0.1, 0.08, size.y + 0.1});
  });
}

/// The highest and the lowest point of the roof's outer faces under a rectangle.
std::pair<double, double> heightsAround(const Roof& roof, const Vec2& at, const Vec2& half) {
  double low = 1e9, high = -1e9;
  for (const double x : {at.x - half.x, at.x + half.x}) {
    for (const double z : {at.y - half.y, at.y + half.y}) {
      low = std::min(low, roof.heightAt(x, z));
      high = std::max(high, roof.heightAt(x, z));
    }
  }
  return {low, high};
}

void addChimney(const House& house, const Roof& roof, const Vec2& at) {
  const auto [low, high] = heightsAround(roof, at, {0.36, 0.25});
  drawChimney(house, at, low - 0.4, high);
}

RoofOptions optionsOf(const House& house) {
  RoofOptions o;
  o.pitchRad = house.plan.pitchRad;
  o.overhangM = house.plan.overhang;
  o.thicknessM = kSlab;
  o.edge = house.m.trim;
  o.underside = house.m.soffit;
  return o;
}

void buildPitched(const House& house, bool hip) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const RoofOptions options = optionsOf(house);
  b.material(house.m.tiles);
  const Roof roof = hip ? b.roofHip(options) : b.roofGable(options);
  nameBox(b, "Roof", roof.min, roof.max);
  const double low = roof.min.y, edge = roof.eaves[0].start.y;
  nameOverhangs(house, kSideFaces, low, edge);
  const double run = (hip ? std::min(plan.width, plan.depth) : plan.depth) * 0.5 + plan.overhang;
  namePitch(house, edge, run);
  drawRidges(house, roof);
  drawGutters(house, roof);

  // Beside the ridge, where a stack needs to be least tall.
  const Segment& ridge = roof.ridges[0];
  const bool alongX = !hip || plan.width >= plan.depth;
  const double reach = std::abs(plan.width - plan.depth) * 0.5 - 0.3;
  const double aside =
      hip ? std::max(std::min((alongX ? plan.width : plan.depth) * 0.22, reach), 0.0) : plan.width * 0.22;
  const Vec2 middle((ridge.start.x + ridge.end.x) * 0.5, (ridge.start.z + ridge.end.z) * 0.5);
  addChimney(house, roof,
             alongX ? Vec2(plan.width * 0.5 - aside, plan.depth * 0.5 - 0.55)
                    : Vec2(plan.width * 0.5 - 0.66, plan.depth * 0.5 - aside));
  (void)middle;
}

void buildShed(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  const double split = plan.depth * kShedSplit, slope = std::tan(plan.pitchRad);
  RoofOptions options = optionsOf(house);
  b.material(house.m.tiles);
  options.topOverhangM = 0;
  Roof lower, upper;
  b.push([&] {
    b.translate({0, 0, plan.depth - split});
    b.scale(Axis::kZ, split);
    lower = b.roofShed(options);
    drawGutters(house, lower);
  });
  options.topOverhangM = kShedTop;
  b.push([&] {
    b.rotate(Axis::kY, 3.14159265358979323846, {0.5, 0, 0.5});
    b.translate({0, 0, split});
    b.scale(Axis::kZ, plan.depth - split);
    upper = b.roofShed(options);
    drawGutters(house, upper);
    addChimney(house, upper, {plan.width * 0.72, kShedWall + 0.27});
  });
  // The wall between the roofs.
  b.material(house.m.plaster);
  b.box({kWallThickness, split * slope - 0.3, plan.depth - split - kShedWall},
        {plan.width - 2 * kWallThickness, (plan.depth - 2 * split) * slope + 0.3 + 0.03, kShedWall});

  const double low = lower.min.y, edge = lower.eaves[0].start.y;
  nameBox(b, "Roof", {-plan.overhang, low, -plan.overhang},
          {plan.width + plan.overhang, upper.max.y, plan.depth + plan.overhang});
  nameOverhangs(house, kSideFaces, low, edge);
  namePitch(house, edge, split + plan.overhang);
}

void buildFlat(const House& house) {
  Builder& b = house.b;
  const Plan& plan = house.plan;
  FlatRoofOptions options;
  options.overhangM = plan.overhang;
  options.thicknessM = 0.22;
  options.parapetHeightM = 0.2;
  options.parapetWidthM = 0.22;
  options.edge = house.m.trim;
  options.underside = house.m.soffit;
  b.material(house.m.gravel);
  const Roof roof = b.roofFlat(options);
  nameBox(b, "Roof", roof.min, roof.max);
  nameOverhangs(house, kSideFaces, roof.min.y, roof.max.y);
  addChimney(house, roof, {plan.width * 0.28, plan.depth * 0.36});
}

}  // namespace

void buildRoof(const House& house) {
  Builder& b = house.b;
  b.push([&] {
    b.translate({0, house.plan.wallHeight + house.plan.kneeHeight, 0});
    b.scale(Axis::kY, 0);
    switch (house.plan.roof) {
      case RoofType::kGable:
        buildPitched(house, false);
        break;
      case RoofType::kHip:
        buildPitched(house, true);
        break;
      case RoofType::kShed:
        buildShed(house);
        break;
      case RoofType::kFlat:
        buildFlat(house);
        break;
    }
  });
}

}  // namespace dimline::house
