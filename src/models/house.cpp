#include "models/house_parts.h"
#include "models/models.h"
#include "models/vocabulary.h"

// A family house: a rectangular body of some storeys over a plinth, a regular row of windows on each side, the
// entrance in front. house_plan decides where everything is; the other house files draw it.

namespace dimline {

namespace {

using namespace house;

// Ranges are such that every value can be had whatever the others are: the highest sill and the highest window fit
// into the lowest storey (0.9 + 1.6 + 0.2 = 2.7), two of the widest windows into the shortest wall. So a direct
// dimension always shows its value.
std::vector<dimline::Parameter> houseParameters() {
  std::vector<dimline::Parameter> p(kParameterCount);

  p[kWidth] = lengthParameter("Width", "Width", {13.0, 7, 18, 0.1},
      {"Building", "How wide the house is, from wall to wall along the front.",
       "@Handle(scope=Footprint, type=linear-contour, orient=right, slip=scope, align=bottom, occlusion=false)"});
  p[kDepth] = lengthParameter("Depth", "Depth", {8.4, 6, 12, 0.1},
      {"Building", "How deep the house is, from its front wall to its back wall.",
       "@Handle(scope=Footprint, type=linear-contour, orient=back, slip=scope, align=bottom, occlusion=false)"});
  p[kFloors] = countParameter("Floors", "Number of floors", {2, 1, 4, 1}, "floor",
      {"Building", "How many storeys the house has below its roof.",
       "@Handle(scope=Storeys, type=linear-contour, orient=up, slip=scope, align=left, indirect)"});
  p[kFloorHeight] = lengthParameter("FloorHeight", "Floor height", {2.9, 2.7, 3.8, 0.05},
      {"Building", "How high each storey is, from one floor to the next.",
       "@Handle(scope=Storey, type=linear-contour, orient=up, slip=scope, align=left, chained)"});

  p[kRoofType] = choiceParameter("RoofType", "Roof type", 0, {"gable", "hip", "shed", "flat"},
      {"Roof", "The shape of the roof: two slopes, four, two at different heights, or none at all.",
       "@Handle(scope=Roof, type=range, orient=up, align=top)"});
  p[kRoofPitch] = angleParameter("RoofPitch", "Roof pitch", {36, 15, 50, 1},
      {"Roof", "How steep the roof is; a flat roof has no pitch.",
       "@Handle(scope=Pitch, type=angular, orient=front, slip=none)"});
  p[kRoofOverhang] = lengthParameter("RoofOverhang", "Roof overhang", {0.5, 0.2, 1.2, 0.05},
      {"Roof", "How far the roof reaches out over the walls.",
       "@Handle(scope=Overhang, type=linear-contour, orient=front, slip=scope)"});
  p[kChimneyHeight] = lengthParameter("ChimneyHeight", "Chimney height", {1.3, 0.6, 2.5, 0.05},
      {"Roof", "How far the chimney rises above the roof beside it.",
       "@Handle(scope=Chimney, type=linear-center, orient=up, slip=billboard)"});

  p[kWindowWidth] = lengthParameter("WindowWidth", "Window width", {1.0, 0.6, 2.0, 0.05},
      {"Windows", "How wide each window is.",
       "@Handle(scope=Window, type=linear-contour, orient=right, slip=scope, chained)"});
  p[kWindowHeight] = lengthParameter("WindowHeight", "Window height", {1.4, 0.8, 1.6, 0.05},
      {"Windows", "How high each window is.",
       "@Handle(scope=Window, type=linear-contour, orient=up, slip=scope, chained)"});
  p[kSillHeight] = lengthParameter("SillHeight", "Sill height", {0.85, 0.1, 0.9, 0.05},
      {"Windows", "How high the windows begin above the floor of their storey.",
       "@Handle(scope=Sill, type=linear-contour, orient=up, slip=scope, chained)"});
  p[kWindowSpacing] = lengthParameter("WindowSpacing", "Window spacing", {2.4, 1.2, 4.0, 0.05},
      {"Windows", "About how far apart the windows are; each wall takes as many as fit evenly.",
       "@Handle(scope=Bay, type=linear-contour, orient=right, slip=scope, chained, indirect)"});

  p[kDoorWidth] = lengthParameter("DoorWidth", "Door width", {1.3, 0.9, 2.2, 0.05},
      {"Entrance", "How wide the front door is; a wide one has two leaves.",
       "@Handle(scope=Door, type=linear-contour, orient=right, slip=scope)"});
  p[kBalcony] = switchParameter("Balcony", "Balcony", true,
      {"Entrance", "A balcony over the entrance; it needs a house with at least two floors.",
       "@Handle(scope=Balcony, type=boolean, orient=front)"});
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

ModelDefinition defineHouse() {
  std::vector<Measure> measures{
      lengthMeasure("OverallHeight", "Overall height", "How high the house is, up to its highest point.",
                    "@Handle(scope=Model, type=linear-contour, orient=up, slip=scope, align=right, occlusion=false)"),
      areaMeasure("GrossFloorArea", "Gross floor area", "The area of all storeys together, walls included.",
                  [](const Values& values, const Scene&) { return values.at(kWidth) * values.at(kDepth) * values.at(kFloors); })};
  return {"house", "Family house", houseParameters(), buildHouse, std::move(measures)};
}

}  // namespace dimline
