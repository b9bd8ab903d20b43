#include <cmath>
#include <numbers>

#include "models/models.h"
#include "models/vocabulary.h"

// A sprung lever, such as stands at a sluice or a set of points: a bell crank on a pivot between two cheeks, held back by
// a coil spring that is hooked into its tail. It swings in the plane z = 0, to both sides of which it is the same; the
// pivot stands over the origin.
//
//             O  knob
//            /
//           /  arm
//   tail   /
//     o--=@   hub, on the pivot
//     |  / \   .
//     Z /   \  cheek
//     Z/_____\ .
//  ___o_______________  base plate, bolted down

namespace dimline {

namespace {

enum LeverParameter : std::size_t {
  kKnobDiameter,
  kLeverAngle,
  kArmLength,
  kBoltSpacing,
  kHubRadius,
  kSpringDiameter,
  kPlateThickness,
  kLeverParameterCount
};

// Fixed sizes (m).
constexpr double kBaseHeight = 0.05;
constexpr double kBaseMiddleX = -0.06;
constexpr double kBaseMargin = 0.08;  // from a bolt's middle to the plate's edge
constexpr int kBoltsInRow = 4;
constexpr double kPivotY = 0.62;
constexpr double kPlay = 0.015;  // between arm and cheeks
constexpr double kTailLength = 0.42;
constexpr double kTailRadius = 0.055;
constexpr double kTailRad = 110 * std::numbers::pi / 180;  // from the arm to the tail
constexpr Vec2 kAnchor{-0.42, 0.135};                      // the spring's lower end
constexpr double kHook = 0.06;                             // from either end of the spring to its coil
constexpr double kWire = 0.026;
constexpr int kTurns = 5, kPointsPerTurn = 10;

/// The lever in numbers.
struct Lever {
  explicit Lever(const Values& values)
      : knob(values.at(kKnobDiameter)),
        angleRad(values.at(kLeverAngle) * std::numbers::pi / 180),
        arm(values.at(kArmLength)),
        boltSpacing(values.at(kBoltSpacing)),
        hub(values.at(kHubRadius)),
        spring(values.at(kSpringDiameter)),
        plate(values.at(kPlateThickness)),
        halfStack(1.5 * plate + kPlay),
        boltRowZ(halfStack + 0.085),
        tailEnd(Vec2(0, kPivotY) + kTailLength * Vec2(std::cos(angleRad + kTailRad), std::sin(angleRad + kTailRad))) {}

  double knob, angleRad, arm, boltSpacing, hub, spring, plate;
  double halfStack;  ///< from the middle to the outer face of a cheek
  double boltRowZ;
  Vec2 tailEnd;
};

struct Palette {
  explicit Palette(Builder& b)
      : casting(paint(b, 0x4E5F68, 0.55F)),
        enamel(paint(b, 0xA93A2C, 0.35F)),
        steel(paint(b, 0xC3C7C8, 0.3F, Material::Pattern::kMetal)),
        bolt(paint(b, 0x83898C, 0.4F, Material::Pattern::kMetal)),
        knob(paint(b, 0x1F2226, 0.2F)) {}
  MaterialId casting, enamel, steel, bolt, knob;
};

/// Adds a circle's points from one angle to another, both ends included.
void addArc(Ring& ring, const Vec2& center, double radius, double fromRad, double toRad, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double a = fromRad + (toRad - fromRad) * i / steps;
    ring.push_back(center + radius * Vec2(std::cos(a), std::sin(a)));
  }
}

/// A frame in the plane of the swing: y along a direction there, z to the front.
Obb frameAlong(const Vec2& origin, const Vec2& way) { return {Vec3(origin, 0), {Vec3(way.y, -way.x, 0), Vec3(way, 0), Vec3(0, 0, 1)}, Vec3(0.0)}; }

/// A hexagon across z, from the scope's origin outwards.
void drawHexagon(Builder& b, double radius, double height) {
  b.push([&] {
    b.scale({0, 0, height});
    b.extrudePolygon(ellipseRing({0, 0}, {radius, radius}, 6));
  });
}

/// A disc across z, likewise.
void drawDisc(Builder& b, double radius, double height, int sides) {
  b.push([&] {
    b.scale({0, 0, height});
    b.extrudePolygon(ellipseRing({0, 0}, {radius, radius}, sides), Axis::kZ, 1.0);
  });
}

/// Runs body() in front, z outwards from the middle, and again behind.
template <typename Body>
void onBothSides(Builder& b, Body&& body) {
  b.push(body);
  b.push([&] {
    b.rotate(Axis::kY, std::numbers::pi);
    body();
  });
}

// --- Base and bracket ---------------------------------------------------------------------------------------------------

void drawBase(Builder& b, const Lever& lever, const Palette& m) {
  const double halfX = 0.5 * (kBoltsInRow - 1) * lever.boltSpacing, x = halfX + kBaseMargin, z = lever.boltRowZ + kBaseMargin, round = 0.05;
  b.push([&] {
    b.translate({kBaseMiddleX, 0, 0});
    b.push([&] {
      b.scale({0, kBaseHeight, 0});
      Ring outline;
      for (int corner = 0; corner < 4; ++corner) {
        const double from = corner * 0.5 * std::numbers::pi, sx = corner == 0 || corner == 3 ? 1 : -1, sz = corner < 2 ? 1 : -1;
        addArc(outline, {sx * (x - round), sz * (z - round)}, round, from, from + 0.5 * std::numbers::pi, 2);
      }
      b.material(m.casting);
      b.extrudePolygon(outline, Axis::kY, 1.0);
    });
    b.material(m.bolt);
    const PartId bolt = b.part(Vec3(0.0), [&] {
      b.rotate(Axis::kX, -0.5 * std::numbers::pi);
      drawHexagon(b, 0.034, 0.032);
    });
    b.translate({-halfX, kBaseHeight, 0});
    for (const double row : {-lever.boltRowZ, lever.boltRowZ}) {
      for (int i = 0; i < kBoltsInRow; ++i) {
        b.push([&] {
          b.translate({i * lever.boltSpacing, 0, row});
          b.place(bolt);
          if (i + 1 < kBoltsInRow) nameBox(b, "BoltGap", {0, 0, -0.034}, {lever.boltSpacing, 0.032, 0.034});
        });
      }
    }
  });
}

/// Two cheeks on a sole, round about the pivot, and the pivot's nuts.
void drawBracket(Builder& b, const Lever& lever, const Palette& m) {
  b.material(m.casting);
  const double sole = kBaseHeight + 0.028, foot = 0.2;
  b.box({-foot - 0.05, kBaseHeight - 0.005, -lever.halfStack - 0.035}, {2 * foot + 0.1, sole - kBaseHeight + 0.005, 2 * lever.halfStack + 0.07});
  // From the foot's corner the outline runs along a tangent to the round head.
  const Vec2 corner(foot, sole + 0.03 - kPivotY);
  const double touchRad = std::atan2(corner.y, corner.x) + std::acos(lever.hub / glm::length(corner));
  Ring outline{{-foot, sole - 0.01}, {foot, sole - 0.01}, {foot, sole + 0.03}};
  addArc(outline, {0, kPivotY}, lever.hub, touchRad, std::numbers::pi - touchRad, 8);
  outline.emplace_back(-foot, sole + 0.03);
  const Ring window{{-0.095, 0.16}, {0.095, 0.16}, {0.068, 0.36}, {-0.068, 0.36}};
  onBothSides(b, [&] {
    b.translate({0, 0, 0.5 * lever.plate + kPlay});
    b.scale({0, 0, lever.plate});
    b.material(m.casting);
    b.extrudePolygon(Polygon{outline, {window}}, Axis::kZ, 0.6);
    b.translate({0, kPivotY, lever.plate});
    b.material(m.steel);
    drawDisc(b, 0.066, 0.014, 12);
    b.translate({0, 0, 0.014});
    b.material(m.bolt);
    drawHexagon(b, 0.045, 0.034);
  });

  const Vec3 pivot(0, kPivotY, 0), reach(lever.hub, lever.hub, lever.halfStack), half(lever.hub, lever.hub, 0.5 * lever.plate);
  nameBox(b, "Hub", pivot - reach, pivot + reach);
  for (const double side : {-1.0, 0.0, 1.0}) {
    const Vec3 middle = pivot + Vec3(0, 0, side * (lever.plate + kPlay));
    nameBox(b, "Plate", middle - half, middle + half);
  }
}

// --- Lever --------------------------------------------------------------------------------------------------------------

/// Arm and tail as one plate, in the frame of the arm: an eye about the pivot, drawn out along tangents to the round end
/// of the arm and to that of the tail, with a fillet in the corner between the two.
Ring crankOutline(const Lever& lever, double armEnd, double armRadius) {
  const double armRad = 0.5 * std::numbers::pi, tailRad = armRad + kTailRad;
  const double armTouch = std::acos((lever.hub - armRadius) / armEnd), tailTouch = std::acos((lever.hub - kTailRadius) / kTailLength);
  const auto direction = [](double angleRad) { return Vec2(std::cos(angleRad), std::sin(angleRad)); };
  Ring ring;
  addArc(ring, {0, armEnd}, armRadius, armRad - armTouch, armRad + armTouch, 3);

  // The two inner tangents, at right angles to their directions of touch, meet before they reach the eye.
  const double left = armRad + armTouch, right = tailRad - tailTouch, middle = 0.5 * (left + right);
  const Vec2 corner = direction(middle) * (lever.hub / std::cos(0.5 * (left - right)));
  const double fillet = 0.13;
  const Vec2 from = corner + direction(left - 0.5 * std::numbers::pi) * fillet, to = corner + direction(right + 0.5 * std::numbers::pi) * fillet;
  for (const double t : {0.0, 0.33, 0.67, 1.0}) ring.push_back(from * ((1 - t) * (1 - t)) + corner * (2 * t * (1 - t)) + to * (t * t));

  addArc(ring, direction(tailRad) * kTailLength, kTailRadius, tailRad - tailTouch, tailRad + tailTouch, 3);
  addArc(ring, {0, 0}, lever.hub, tailRad + tailTouch, 2 * std::numbers::pi + armRad - armTouch, 4);
  return ring;
}

/// Scope: a frame on the pivot, y along the arm.
void drawArm(Builder& b, const Lever& lever, const Palette& m) {
  const double plateEnd = 0.5 * lever.arm, ferrule = 0.05, radius = 0.5 * lever.knob;
  nameBox(b, "Arm", {-0.05, 0, -0.5 * lever.plate}, {0.05, lever.arm, 0.5 * lever.plate});
  b.push([&] {
    b.translate({0, 0, -0.5 * lever.plate});
    b.scale({0, 0, lever.plate});
    b.material(m.enamel);
    b.extrudePolygon(crankOutline(lever, plateEnd, 0.042), Axis::kZ, 0.7);
  });
  b.material(m.steel);
  const Vec2 rod[] = {{ferrule, plateEnd - 0.02},        {ferrule, plateEnd + 0.055},       {0.028, plateEnd + 0.085},
                      {0.024, plateEnd + 0.5 * (lever.arm - plateEnd)}, {0.03, lever.arm - radius * 0.95}};
  b.push([&] {
    b.scale(Vec3(0.0));
    b.lathe(rod, {8, 0.8});
  });
  b.push([&] {
    b.translate(Vec3(0, lever.arm, 0) - radius);
    b.scale(Vec3(lever.knob));
    b.material(m.knob);
    b.sphere({14, 0.7});
  });
}

/// Hooks and coil, from the anchor to the tail's end. Scope: a frame on the anchor, y along the spring.
void drawSpring(Builder& b, const Lever& lever, const Palette& m) {
  const double length = glm::length(lever.tailEnd - kAnchor), radius = 0.5 * (lever.spring - kWire), coil = length - 2 * kHook;
  std::vector<Vec3> path{{0, 0, 0}, {0, kHook - 0.03, 0}};
  for (int i = 0; i <= kTurns * kPointsPerTurn; ++i) {
    const double turned = 2 * std::numbers::pi * i / kPointsPerTurn;
    path.emplace_back(radius * std::cos(turned), kHook + 0.5 * kWire + (coil - kWire) * i / (kTurns * kPointsPerTurn), radius * std::sin(turned));
  }
  path.emplace_back(0, length - kHook + 0.03, 0);
  path.emplace_back(0, length, 0);
  Builder::SweepOptions options;
  options.up = {0, 0, 1};
  options.creaseRad = 1.7;
  options.bendRad = 0.8;
  b.material(m.steel);
  b.sweep(ellipseRing({0, 0}, Vec2(0.5 * kWire), 4), path, options);
  nameBox(b, "Spring", {-0.5 * lever.spring, kHook, -0.5 * lever.spring}, {0.5 * lever.spring, length - kHook, 0.5 * lever.spring});
}

/// The lug that holds the spring down, and the pins at both of its ends.
void drawAnchorage(Builder& b, const Lever& lever, const Palette& m) {
  const double half = 0.02;
  Ring lug{{kAnchor.x - 0.065, kBaseHeight - 0.005}, {kAnchor.x + 0.065, kBaseHeight - 0.005}};
  addArc(lug, kAnchor, 0.045, 0.1, std::numbers::pi - 0.1, 3);
  b.push([&] {
    b.translate({0, 0, -half});
    b.scale({0, 0, 2 * half});
    b.material(m.casting);
    b.extrudePolygon(lug, Axis::kZ, 0.9);
  });
  b.material(m.bolt);
  const auto pin = [&](const Vec2& at, double halfLength) {
    b.push([&] {
      b.translate(Vec3(at, -halfLength));
      drawHexagon(b, 0.026, 2 * halfLength);
    });
  };
  pin(kAnchor, half + 0.015);
  pin(lever.tailEnd, 0.5 * lever.plate + 0.015);
}

// Ranges are such that nothing touches what it should not: the tail at its lowest leaves the coil more than its wires, the
// widest coil stays clear of the cheeks, and the shortest base still carries the spring's anchor.
std::vector<Parameter> leverParameters() {
  std::vector<Parameter> p(kLeverParameterCount);
  p[kKnobDiameter] = lengthParameter("KnobDiameter", "Knob diameter", {0.17, 0.12, 0.26, 0.01},
      {"Lever", "How thick the ball is that the hand takes hold of.",
       "@Handle(scope=Knob, type=spherical-diametric, orient=vertical, slip=billboard)"});
  p[kLeverAngle] = angleParameter("LeverAngle", "Lever angle", {58, 30, 100, 1},
      {"Lever", "How far the arm is raised from the level; the spring follows.",
       "@Handle(scope=Swing, type=angular, orient=front, slip=none)"});
  p[kArmLength] = lengthParameter("ArmLength", "Arm length", {0.95, 0.7, 1.3, 0.05},
      {"Lever", "From the pivot to the middle of the knob: a longer arm needs less force.",
       "@Handle(scope=Arm, type=linear-center, orient=up, slip=billboard)"});
  p[kBoltSpacing] = lengthParameter("BoltSpacing", "Bolt spacing", {0.3, 0.26, 0.42, 0.01},
      {"Base", "From one bolt of the base plate to the next; the plate is as long as its bolts need.",
       "@Handle(scope=BoltGap, type=linear-contour, orient=right, slip=scope, chained)"});
  p[kHubRadius] = lengthParameter("HubRadius", "Hub radius", {0.11, 0.09, 0.15, 0.01},
      {"Bracket", "How far cheeks and arm reach around the pivot.",
       "@Handle(scope=Hub, type=radial, orient=front, slip=billboard, align=right)"});
  p[kSpringDiameter] = lengthParameter("SpringDiameter", "Spring diameter", {0.16, 0.1, 0.22, 0.01},
      {"Spring", "How wide the coil is, measured over its wire.",
       "@Handle(scope=Spring, type=diametric, orient=up, slip=billboard)"});
  p[kPlateThickness] = lengthParameter("PlateThickness", "Plate thickness", {0.06, 0.03, 0.08, 0.005},
      {"Bracket", "The thickness of the plate that the two cheeks and the arm are cut from.",
       "@Handle(scope=Plate, type=linear-contour, orient=front, slip=scope, chained)"});
  return p;
}

Scene buildLever(const Values& values) {
  const Lever lever(values);
  Builder b;
  const Palette m(b);
  drawBase(b, lever, m);
  drawBracket(b, lever, m);
  drawAnchorage(b, lever, m);
  // The angle opens from the level towards the arm, in front of the nuts.
  const double swing = 0.7 * lever.arm, front = lever.halfStack + 0.05;
  nameBox(b, "Swing", {0, kPivotY, front}, {swing, kPivotY + swing, front});
  const Vec3 knob(lever.arm * std::cos(lever.angleRad), kPivotY + lever.arm * std::sin(lever.angleRad), 0), knobHalf(0.5 * lever.knob);
  nameBox(b, "Knob", knob - knobHalf, knob + knobHalf);
  b.push([&] {
    b.setScope(frameAlong({0, kPivotY}, {std::cos(lever.angleRad), std::sin(lever.angleRad)}));
    drawArm(b, lever, m);
  });
  b.push([&] {
    b.setScope(frameAlong(kAnchor, glm::normalize(lever.tailEnd - kAnchor)));
    drawSpring(b, lever, m);
  });
  return b.finish();
}

}  // namespace

ModelDefinition defineLever() { return {"lever", "Sprung lever", leverParameters(), buildLever}; }

}  // namespace dimline
