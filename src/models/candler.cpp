#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/builder.h"
#include "models/candler_parts.h"
#include "models/models.h"
#include "models/vocabulary.h"

// The Candler Building in Atlanta (1906): seventeen storeys of white Georgia marble, composed like a column. A base of granite
// shopfronts and an arcade, a shaft of equal office floors between quoined corners, a capital of arched windows, and a cornice
// that reaches far out over the street.
//
// All four fronts are made of the same storeys: a storey of a front is drawn once for each kind and length and then placed.

namespace dimline {

namespace {

using namespace candler;

enum Index { kFloorHeight, kWindowHeight, kWindowWidth, kCourseHeight, kCorniceOverhang, kCresting, kParameterCount };

// Sound together: the highest window leaves 0.35 m of wall above it in the lowest storey, the widest one 1.2 m between itself and
// the next, and the round head of the widest (1.5 m) is not higher than the lowest window.
std::vector<Parameter> parameters() {
  std::vector<Parameter> p(kParameterCount);
  p[kFloorHeight] = lengthParameter("FloorHeight", "Floor height", {3.7, 3.4, 4.2, 0.05},
      {"Building", "How high each of the sixteen upper storeys is, from floor to floor.",
       "@Handle(scope=Storey, type=linear-contour, orient=up, slip=scope, align=left, chained)"});
  p[kWindowHeight] = lengthParameter("WindowHeight", "Window height", {2.1, 1.6, 2.3, 0.05},
      {"Windows", "How high every window is; arched ones are measured to the crown.",
       "@Handle(scope=Window, type=linear-contour, orient=up, slip=scope, align=right, chained)"});
  p[kWindowWidth] = lengthParameter("WindowWidth", "Window width", {2.6, 1.8, 3.0, 0.05},
      {"Windows", "How wide every window is; the piers between them take the rest.",
       "@Handle(scope=FirstFloorWindow, type=linear-center, orient=right, slip=scope, chained)"});
  p[kCourseHeight] = lengthParameter("CourseHeight", "Course height", {0.37, 0.3, 0.8, 0.01},
      {"Masonry", "About how high the courses of the corner stones are; each storey takes a whole number of them.",
       "@Handle(scope=Course, type=linear-contour, orient=up, slip=scope, chained, indirect, min-length=14)"});
  p[kCorniceOverhang] = lengthParameter("CorniceOverhang", "Cornice overhang", {2.4, 1.3, 3.2, 0.05},
      {"Cornice", "How far the cornice at the top reaches out over the street.",
       "@Handle(scope=Cornice, type=linear-center, orient=front, slip=scope, align=top, chained)"});
  p[kCresting] = switchParameter("Cresting", "Cresting", true,
      {"Cornice", "A row of palmettes along the edge of the cornice.", "@Handle(scope=Cresting, type=boolean, orient=up, align=top)"});
  return p;
}

// --- Storeys ---------------------------------------------------------------------------------------------------------------

/// What fills the wall between two piers on one storey. A spandrel reaches from the head of the window below to the sill.
enum class Infill { kPlain, kPanelled, kArched };

/// The wall around a round head, from springing to the next floor, and an archivolt with its keystone. x = 0 is the jamb, y = 0 the sill.
void drawArchHead(const Candler& c) {
  Builder& b = c.b;
  constexpr int kSegments = 7;
  const double r = c.plan.windowWidth * 0.5, springing = c.plan.windowHeight - r, top = c.plan.floorHeight - kSill;
  const auto arc = [&](double radius, int i) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(i) / kSegments);
    return Vec2(r + radius * std::cos(angle), springing + radius * std::sin(angle));
  };
  Ring wall{{2 * r, top}, {0, top}};
  for (int i = 0; i <= kSegments; ++i) wall.push_back(arc(r, i));
  Ring archivolt;
  for (int i = 0; i <= kSegments; ++i) archivolt.push_back(arc(r + 0.24, i));
  for (int i = kSegments; i >= 0; --i) archivolt.push_back(arc(r, i));
  b.push([&] {
    b.translate({0, 0, -kWallDepth});
    b.scale(Axis::kZ, kWallDepth - 0.06);
    b.material(c.m.marble);
    b.extrudePolygon(wall, Axis::kZ, 0.6);
    b.translate({0, 0, kWallDepth - 0.16});
    b.scale(Axis::kZ, 0.22);
    b.material(c.m.carved);
    b.extrudePolygon(archivolt, Axis::kZ, 0.6);
    b.box({r - 0.16, springing + r - 0.05, 0}, {0.32, 0.42, 0.3});
  });
}

/// Scope: a storey's stretch of wall between two corners, in the plane of the wall's face. What lies behind the piers' faces runs through
/// behind the piers.
void drawStorey(const Candler& c, Infill infill, PartId archHead, int bays) {
  Builder& b = c.b;
  const double w = c.plan.windowWidth, h = c.plan.windowHeight, below = c.plan.spandrelHeight(), length = bays * kBay;
  b.translate({0, kSill, -kReveal});
  // Meeting rails of the sashes; under an arch the bar is where it springs.
  const double rail = infill == Infill::kArched ? h - 0.5 * w : 0.5 * h;
  b.material(c.m.sash);
  b.box({0, rail - 0.04, -0.02}, {length, 0.08, 0.07});
  b.material(c.m.spandrel);
  b.box({0, -below, kReveal - kWallDepth}, {length, below - 0.07, kWallDepth - 0.2});
  for (int i = 0; i < bays; ++i) {
    b.push([&] {
      b.translate({(i + 0.5) * kBay - 0.5 * w, 0, 0});
      b.scale({w, h, kReveal});
      b.name("Window");
      // Two windows side by side, each a pair of sashes.
      b.material(c.m.sash);
      b.box({0.5 * w - 0.08, 0, -0.02}, {0.16, h, 0.11});
      b.material(c.m.carved);
      b.box({-0.12, -0.14, 0}, {w + 0.24, 0.14, kReveal + 0.1});
      if (infill != Infill::kPlain) {
        b.material(c.m.marble);
        b.box({0.28, 0.2 - below, kReveal - 0.22}, {w - 0.56, below - 0.54, 0.09});
      }
      if (infill == Infill::kArched) {
        b.translate({0, 0, kReveal});
        b.place(archHead);
      }
    });
  }
}

void placeStoreys(const Candler& c) {
  Builder& b = c.b;
  const PartId archHead = b.part(Vec3(0.0), [&] { drawArchHead(c); });
  std::array<std::array<PartId, 2>, 3> parts{};
  for (const Infill infill : {Infill::kPlain, Infill::kPanelled, Infill::kArched}) {
    for (const bool side : {false, true}) {
      const int bays = side ? kSideBays : kFrontBays;
      parts[static_cast<std::size_t>(infill)][side] =
          b.part({bays * kBay, c.plan.floorHeight, 0}, [&] { drawStorey(c, infill, archHead, bays); });
    }
  }
  for (int s = 0; s < kUpperStoreys; ++s) {
    // No panel where a band course hides half of the spandrel; arches end the base and the capital.
    const bool arched = s == kBaseStoreys - 1 || s == kUpperStoreys - 2;
    const bool banded = s == 0 || s == kBaseStoreys || s == kUpperStoreys - 1;
    const Infill infill = arched ? Infill::kArched : banded ? Infill::kPlain : Infill::kPanelled;
    b.faces(kSideFaces, [&](Face face) {
      const bool side = face == Face::kLeft || face == Face::kRight;
      b.translate({kCorner, c.plan.floorAt(s), 0});
      b.place(parts[static_cast<std::size_t>(infill)][side]);
      if (s > 0) return;
      for (int i = 0; i < (side ? kSideBays : kFrontBays); ++i) {
        b.push([&] {
          b.translate({(i + 0.5) * kBay - 0.5 * c.plan.windowWidth, kSill, -kReveal});
          b.scale({c.plan.windowWidth, c.plan.windowHeight, kReveal});
          b.name("FirstFloorWindow");
        });
      }
    });
  }
}

// --- Piers and corners -----------------------------------------------------------------------------------------------------

/// Piers between the windows of all storeys; those between two bays carry a pilaster on shaft and capital.
void drawPiers(const Candler& c) {
  Builder& b = c.b;
  const Plan& p = c.plan;
  const double pier = kBay - p.windowWidth, height = p.top() - kGround;
  const double shaft = p.floorAt(kBaseStoreys), capital = p.floorAt(kUpperStoreys - 3), attic = p.floorAt(kUpperStoreys - 1);
  b.material(c.m.marble);
  const PartId whole = b.part({pier, height, kWallDepth}, [&] { b.box(); });
  const PartId half = b.part({0.5 * pier, height, kWallDepth}, [&] { b.box(); });
  const double w = 0.8;
  // In two stages: along the shaft, and over the band under the capital.
  const PartId pilaster = b.part({w, p.top() - shaft, 0.3}, [&] {
    const auto stage = [&](double from, double to) {
      b.material(c.m.marble);
      b.box({0, from, -0.05}, {w, to - from, 0.21});
      b.material(c.m.carved);
      b.box({-0.08, from, -0.05}, {w + 0.16, 0.5, 0.27});
      // Capital: a block that steps out, and an abacus.
      b.box({-0.05, to - 1.15, -0.05}, {w + 0.1, 0.1, 0.26});
      b.push([&] {
        b.translate({0, to - 0.85, 0});
        b.scale(Axis::kX, w);
        b.extrudePolygon(Ring{{-0.05, 0}, {0.18, 0}, {0.22, 0.2}, {0.34, 0.38}, {0.36, 0.6}, {-0.05, 0.6}}, Axis::kX, 0.9);
      });
      b.box({-0.1, to - 0.25, -0.05}, {w + 0.2, 0.25, 0.45});
    };
    stage(0.25, capital - shaft);
    stage(capital - shaft + 0.45, attic - shaft);
    // A roundel on the attic's pier.
    b.push([&] {
      b.translate({0.5 * w, attic - shaft + 0.5 * p.floorHeight + 0.1, -0.05});
      b.rotate(Axis::kX, std::numbers::pi / 2);
      b.translate({-0.45, 0, -0.45});
      b.scale({0.9, 0.2, 0.9});
      b.lathe(std::array<Vec2, 4>{{{0.45, 0}, {0.42, 0.2}, {0.3, 0.12}, {0, 0.2}}}, {.segments = 12, .creaseRad = 0.5});
    });
  });
  b.faces(kSideFaces, [&](Face face) {
    const int bays = face == Face::kFront || face == Face::kBack ? kFrontBays : kSideBays;
    for (int i = 0; i <= bays; ++i) {
      b.push([&] {
        const double axis = kCorner + i * kBay;
        const bool last = i == bays, end = i == 0 || last;
        b.translate({end && !last ? axis : axis - 0.5 * pier, kGround, -kWallDepth});
        b.place(end ? half : whole);
      });
      if (i == 0 || i == bays) continue;
      b.push([&] {
        b.translate({kCorner + i * kBay - 0.5 * w, shaft, 0});
        b.place(pilaster);
      });
    }
  });
}

/// The corner piers, and the courses of stones that clasp them.
void drawCorners(const Candler& c) {
  Builder& b = c.b;
  const Plan& p = c.plan;
  constexpr double kProud = 0.09, kLong = 2.05, kShort = 1.4, kJoint = 0.035;
  const int courses = repeatCount(p.floorHeight, p.courseHeight);
  const double course = p.floorHeight / courses;
  b.material(c.m.carved);
  std::array<PartId, 2> stones{};
  for (const std::size_t first : {0U, 1U}) {
    stones[first] = b.part({kCorner, p.floorHeight, kCorner}, [&] {
      for (int i = 0; i < courses; ++i) {
        const bool longX = (static_cast<std::size_t>(i) + first) % 2 == 0;
        b.box({-kProud, i * course + 0.5 * kJoint, -kProud},
              {kProud + (longX ? kLong : kShort), course - kJoint, kProud + (longX ? kShort : kLong)});
      }
    });
  }
  b.material(c.m.marble);
  const PartId pier = b.part({kCorner, p.top() - kGround, kCorner}, [&] { b.box(); });
  // A quarter turn swaps the stone's legs; every other corner starts with the other stone, so that a front is symmetrical.
  std::size_t corner = 0;
  b.faces(kSideFaces, [&](Face) {
    b.translate({0, kGround, 0});
    b.rotate(Axis::kY, std::numbers::pi / 2);   // x into the building, z along the front
    b.place(pier);
    for (int s = 0; s < kUpperStoreys; ++s) {
      b.push([&] {
        b.translate({0, s * p.floorHeight, 0});
        b.place(stones[(corner + static_cast<std::size_t>(courses % 2 * s)) % 2]);
      });
    }
    ++corner;
  });
  b.push([&] {
    b.translate({-kProud, kGround, -kProud});
    b.scale({p.width() + 2 * kProud, p.floorHeight, p.depth() + 2 * kProud});
    for (int s = 0; s < kUpperStoreys; ++s) {
      b.repeat(Axis::kY, course, [&](int, int) { b.name("Course"); });
      b.translate({0, p.floorHeight, 0});
    }
  });
}

void drawBands(const Candler& c) {
  const double shaft = c.plan.floorAt(kBaseStoreys), capital = c.plan.floorAt(kUpperStoreys - 3), attic = c.plan.floorAt(kUpperStoreys - 1);
  // Heavy over the arcade, light under the capital, and a small cornice under the attic.
  drawBand(c, shaft, c.m.carved, {{-0.3, -0.3}, {0.12, -0.3}, {0.16, -0.1}, {0.36, 0.1}, {0.4, 0.1}, {0.4, 0.24}, {0.1, 0.3}, {-0.3, 0.3}});
  drawBand(c, capital, c.m.carved, {{-0.3, 0}, {0.2, 0}, {0.34, 0.2}, {0.42, 0.2}, {0.42, 0.36}, {0.1, 0.48}, {-0.3, 0.48}});
  drawBand(c, attic, c.m.carved, {{-0.3, 0}, {0.2, 0}, {0.24, 0.14}, {0.5, 0.3}, {0.56, 0.3}, {0.56, 0.44}, {0.1, 0.56}, {-0.3, 0.56}});
}

Scene build(const Values& values) {
  Plan plan;
  plan.floorHeight = values.at(kFloorHeight);
  plan.windowHeight = values.at(kWindowHeight);
  plan.windowWidth = values.at(kWindowWidth);
  plan.courseHeight = values.at(kCourseHeight);
  plan.overhang = values.at(kCorniceOverhang);
  plan.cresting = values.at(kCresting) != 0;
  Builder b;
  const Palette palette(b);
  const Candler c{b, plan, palette};
  b.translate({-0.5 * plan.width(), 0, -0.5 * plan.depth()});
  b.scale({plan.width(), plan.top(), plan.depth()});
  b.push([&] {
    b.translate({0, kGround, 0});
    b.scale(Axis::kY, kUpperStoreys * plan.floorHeight);
    b.repeat(Axis::kY, plan.floorHeight, [&](int, int) { b.name("Storey"); });
  });
  // The rooms: one block of dark glass, seen through every window.
  b.material(palette.glass);
  b.box({kReveal, kPlinth, kReveal}, {plan.width() - 2 * kReveal, plan.top() - kPlinth, plan.depth() - 2 * kReveal});
  drawGroundFloor(c);
  placeStoreys(c);
  drawPiers(c);
  drawCorners(c);
  drawBands(c);
  drawCornice(c);
  drawRoof(c);
  return b.finish();
}

}  // namespace

ModelDefinition defineCandler() {
  return {"candler", "Candler Building", parameters(), build,
          {lengthMeasure("OverallHeight", "Overall height", "How high the building is, up to its highest point.",
                         "@Handle(scope=Model, type=linear-contour, orient=up, slip=scope, align=right, occlusion=false)")}};
}

}  // namespace dimline
