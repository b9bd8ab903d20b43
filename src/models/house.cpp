#include "models/house_parts.h"
#include "models/models.h"

// A family house: a rectangular body of some storeys over a plinth, a regular row of windows on each side, the
// entrance in front. house_plan decides where everything is; the other house files draw it.

namespace dimline {

namespace {

using namespace house;

struct Range {
  double value, min, max, step;
};

dimline::Parameter length(std::string name, std::string title, const Range& range) {
  dimline::Parameter p;
  p.name = std::move(name);
  p.title = std::move(title);
  p.unit = Unit::kMetre;
  p.defaultValue = range.value;
  p.min = range.min;
  p.max = range.max;
  p.step = range.step;
  return p;
}

dimline::Parameter other(ParameterType type, Unit unit, std::string name, std::string title, const Range& range) {
  dimline::Parameter p = length(std::move(name), std::move(title), range);
  p.type = type;
  p.unit = unit;
  return p;
}

void describe(dimline::Parameter& p, std::string group, std::string help, std::string annotation) {
  p.group = std::move(group);
  p.help = std::move(help);
  p.annotation = std::move(annotation);
}

// Ranges are such that every value can be had whatever the others are: the highest sill and the highest window fit
// into the lowest storey (0.9 + 1.6 + 0.2 = 2.7), two of the widest windows into the shortest wall. So a direct
// dimension always shows its value.
std::vector<dimline::Parameter> houseParameters() {
  using enum ParameterType;
  std::vector<dimline::Parameter> p(kParameterCount);

  p[kWidth] = length("Width", "Width", {13.0, 7, 18, 0.1});
  describe(p[kWidth], "Building", "How wide the house is, from wall to wall along the front.",
           "@Handle(scope=Footprint, type=linear-contour, orient=right, slip=scope, align=bottom, occlusion=false)");
  p[kDepth] = length("Depth", "Depth", {8.4, 6, 12, 0.1});
  describe(p[kDepth], "Building", "How deep the house is, from its front wall to its back wall.",
           "@Handle(scope=Footprint, type=linear-contour, orient=back, slip=scope, align=bottom, occlusion=false)");
  p[kFloors] = other(kInt, Unit::kNone, "Floors", "Number of floors", {2, 1, 4, 1});
  p[kFloors].noun = "floor";
  describe(p[kFloors], "Building", "How many storeys the house has below its roof.",
           "@Handle(scope=Storeys, type=linear-contour, orient=up, slip=scope, align=left, indirect)");
  p[kFloorHeight] = length("FloorHeight", "Floor height", {2.9, 2.7, 3.8, 0.05});
  describe(p[kFloorHeight], "Building", "How high each storey is, from one floor to the next.",
           "@Handle(scope=Storey, type=linear-contour, orient=up, slip=scope, align=left, chained)");

  p[kRoofType] = other(kChoice, Unit::kNone, "RoofType", "Roof type", {0, 0, 3, 1});
  p[kRoofType].choices = {"gable", "hip", "shed", "flat"};
  describe(p[kRoofType], "Roof", "The shape of the roof: two slopes, four, two at different heights, or none at all.",
           "@Handle(scope=Roof, type=range, orient=up, align=top)");
  p[kRoofPitch] = other(kAngle, Unit::kDegree, "RoofPitch", "Roof pitch", {36, 15, 50, 1});
  describe(p[kRoofPitch], "Roof", "How steep the roof is; a flat roof has no pitch.",
           "@Handle(scope=Pitch, type=angular, orient=front, slip=none)");
  p[kRoofOverhang] = length("RoofOverhang", "Roof overhang", {0.5, 0.2, 1.2, 0.05});
  describe(p[kRoofOverhang], "Roof", "How far the roof reaches out over the walls.",
           "@Handle(scope=Overhang, type=linear-contour, orient=front, slip=scope)");
  p[kChimneyHeight] = length("ChimneyHeight", "Chimney height", {1.3, 0.6, 2.5, 0.05});
  describe(p[kChimneyHeight], "Roof", "How far the chimney rises above the roof beside it.",
           "@Handle(scope=Chimney, type=linear-center, orient=up, slip=billboard)");

  p[kWindowWidth] = length("WindowWidth", "Window width", {1.0, 0.6, 2.0, 0.05});
  describe(p[kWindowWidth], "Windows", "How wide each window is.",
           "@Handle(scope=Window, type=linear-contour, orient=right, slip=scope, chained)");
  p[kWindowHeight] = length("WindowHeight", "Window height", {1.4, 0.8, 1.6, 0.05});
  describe(p[kWindowHeight], "Windows", "How high each window is.",
           "@Handle(scope=Window, type=linear-contour, orient=up, slip=scope, chained)");
  p[kSillHeight] = length("SillHeight", "Sill height", {0.85, 0.1, 0.9, 0.05});
  describe(p[kSillHeight], "Windows", "How high the windows begin above the floor of their storey.",
           "@Handle(scope=Sill, type=linear-contour, orient=up, slip=scope, chained)");
  p[kWindowSpacing] = length("WindowSpacing", "Window spacing", {2.4, 1.2, 4.0, 0.05});
  describe(p[kWindowSpacing], "Windows", "About how far apart the windows are; each wall takes as many as fit evenly.",
           "@Handle(scope=Bay, type=linear-contour, orient=right, slip=scope, chained, indirect)");

  p[kDoorWidth] = length("DoorWidth", "Door width", {1.3, 0.9, 2.2, 0.05});
  describe(p[kDoorWidth], "Entrance", "How wide the front door is; a wide one has two leaves.",
           "@Handle(scope=Door, type=linear-contour, orient=right, slip=scope)");
  p[kBalcony] = other(kBool, Unit::kNone, "Balcony", "Balcony", {1, 0, 1, 1});
  describe(p[kBalcony], "Entrance", "A balcony over the entrance; it needs a house with at least two floors.",
           "@Handle(scope=Balcony, type=boolean, orient=front)");
  return p;
}

Scene buildHouse(const Values& values) {
  const Plan plan = planHouse(values);
  Builder b;
  const Palette palette(b);
  const House house{b, plan, palette};
  b.translate({-plan.width * 0.5, 0, -plan.depth * 0.5});
  b.scale({plan.width, kPlinth, plan.depth});
  b.name("Footprint");
  b.material(palette.plinth);
  b.box({0.03, 0, 0.03}, {plan.width - 0.06, kPlinth, plan.depth - 0.06});

  b.translate({0, kPlinth, 0});
  b.scale(Axis::kY, plan.wallHeight);
  b.name("Storeys");
  b.repeat(Axis::kY, plan.floorHeight, [&](int, int) { b.name("Storey"); });
  buildFacades(house);
  buildRoof(house);
  buildEntrance(house);
  return b.finish();
}

}  // namespace

ModelDefinition defineHouse() { return {"house", "Family house", houseParameters(), buildHouse}; }

}  // namespace dimline
