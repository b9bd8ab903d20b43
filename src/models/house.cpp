#include "models/house_parts.h"
#include "models/models.h"

// A family house: a rectangular body of some storeys over a plinth, a regular row of windows on each side, the entrance in front. house_plan
// decides where everything is; the other house files draw it.

namespace dimline {

namespace {

using namespace house;

std::vector<dimline::Parameter> houseParameters() {
  using enum ParameterType;
  std::vector<dimline::Parameter> p(kParameterCount);
  p[kWidth] = {.name = "Width",
               .title = "Width",
               .help = "How wide the house is, from wall to wall along the front.",
               .group = "Building",
               .type = kFloat,
               .unit = Unit::kMetre,
               .defaultValue = 12.2,
               .min = 7,
               .max = 18,
               .step = 0.1,
               .choices = {},
               .annotation = "@Handle(scope=Footprint, type=linear-contour, orient=right, slip=scope, align=bottom)"};
  p[kDepth] = {.name = "Depth",
               .title = "Depth",
               .help = "How deep the house is, from its front wall to its back wall.",
               .group = "Building",
               .type = kFloat,
               .unit = Unit::kMetre,
               .defaultValue = 8.4,
               .min = 6,
               .max = 12,
               .step = 0.1,
               .choices = {},
               .annotation = "@Handle(scope=Footprint, type=linear-contour, orient=back, slip=scope, align=bottom)"};
  p[kFloors] = {
      .name = "Floors",
      .title = "Number of floors",
      .help = "How many storeys the house has below its roof.",
      .group = "Building",
      .type = kInt,
      .unit = Unit::kNone,
      .defaultValue = 2,
      .min = 1,
      .max = 4,
      .step = 1,
      .choices = {},
      .annotation = "@Handle(scope=Storeys, type=linear-contour, orient=up, slip=scope, align=left, indirect)"};
  p[kFloorHeight] = {
      .name = "FloorHeight",
      .title = "Floor height",
      .help = "How high each storey is, from one floor to the next.",
      .group = "Building",
      .type = kFloat,
      .unit = Unit::kMetre,
      .defaultValue = 2.9,
      .min = 2.7,
      .max = 3.8,
      .step = 0.05,
      .choices = {},
      .annotation = "@Handle(scope=Storey, type=linear-contour, orient=up, slip=scope, align=left, chained)"};
  p[kRoofType] = {.name = "RoofType",
                  .title = "Roof type",
                  .help = "The shape of the roof: two slopes, four, two at different heights, or none.",
                  .group = "Roof",
                  .type = kChoice,
                  .unit = Unit::kNone,
                  .defaultValue = 0,
                  .min = 0,
                  .max = 3,
                  .step = 1,
                  .choices = {"gable", "hip", "shed", "flat"},
                  .annotation = "@Handle(scope=Roof, type=range, orient=up, align=top)"};
  p[kRoofPitch] = {.name = "RoofPitch",
                   .title = "Roof pitch",
                   .help = "How steep the roof is; a flat roof has no pitch.",
                   .group = "Roof",
                   .type = kAngle,
                   .unit = Unit::kDegree,
                   .defaultValue = 36,
                   .min = 15,
                   .max = 50,
                   .step = 1,
                   .choices = {},
                   .annotation = "@Handle(scope=Pitch, type=angular, orient=front, slip=none)"};
  p[kRoofOverhang] = {.name = "RoofOverhang",
                      .title = "Roof overhang",
                      .help = "How far the roof reaches out over the walls.",
                      .group = "Roof",
                      .type = kFloat,
                      .unit = Unit::kMetre,
                      .defaultValue = 0.5,
                      .min = 0.2,
                      .max = 1.2,
                      .step = 0.05,
                      .choices = {},
                      .annotation = "@Handle(scope=Overhang, type=linear-contour, orient=front, slip=scope)"};
  p[kChimneyHeight] = {.name = "ChimneyHeight",
                       .title = "Chimney height",
                       .help = "How far the chimney rises above the roof beside it.",
                       .group = "Roof",
                       .type = kFloat,
                       .unit = Unit::kMetre,
                       .defaultValue = 1.3,
                       .min = 0.6,
                       .max = 2.5,
                       .step = 0.05,
                       .choices = {},
                       .annotation = "@Handle(scope=Chimney, type=linear-center, orient=up, slip=billboard)"};
  p[kWindowWidth] = {.name = "WindowWidth",
                     .title = "Window width",
                     .help = "How wide each window is.",
                     .group = "Windows",
                     .type = kFloat,
                     .unit = Unit::kMetre,
                     .defaultValue = 1.0,
                     .min = 0.6,
                     .max = 2.0,
                     .step = 0.05,
                     .choices = {},
                     .annotation = "@Handle(scope=Window, type=linear-contour, orient=right, slip=scope, chained)"};
  p[kWindowHeight] = {.name = "WindowHeight",
                      .title = "Window height",
                      .help = "How high each window is.",
                      .group = "Windows",
                      .type = kFloat,
                      .unit = Unit::kMetre,
                      .defaultValue = 1.4,
                      .min = 0.8,
                      .max = 1.6,
                      .step = 0.05,
                      .choices = {},
                      .annotation = "@Handle(scope=Window, type=linear-contour, orient=up, slip=scope, chained)"};
  p[kSillHeight] = {.name = "SillHeight",
                    .title = "Sill height",
                    .help = "How high the windows begin above the floor of their storey.",
                    .group = "Windows",
                    .type = kFloat,
                    .unit = Unit::kMetre,
                    .defaultValue = 0.85,
                    .min = 0.1,
                    .max = 0.9,
                    .step = 0.05,
                    .choices = {},
                    .annotation = "@Handle(scope=Sill, type=linear-contour, orient=up, slip=scope, chained)"};
  p[kWindowSpacing] = {
      .name = "WindowSpacing",
      .title = "Window spacing",
      .help = "About how far apart the windows are; the house takes as many as fit evenly.",
      .group = "Windows",
      .type = kFloat,
      .unit = Unit::kMetre,
      .defaultValue = 2.2,
      .min = 1.2,
      .max = 4.0,
      .step = 0.05,
      .choices = {},
      .annotation = "@Handle(scope=Bay, type=linear-contour, orient=right, slip=scope, chained, indirect)"};
  p[kDoorWidth] = {.name = "DoorWidth",
                   .title = "Door width",
                   .help = "How wide the front door is; a wide one has two leaves.",
                   .group = "Entrance",
                   .type = kFloat,
                   .unit = Unit::kMetre,
                   .defaultValue = 1.2,
                   .min = 0.9,
                   .max = 2.2,
                   .step = 0.05,
                   .choices = {},
                   .annotation = "@Handle(scope=Door, type=linear-contour, orient=right, slip=scope)"};
  p[kBalcony] = {.name = "Balcony",
                 .title = "Balcony",
                 .help = "A balcony over the entrance; it needs a house with at least two floors.",
                 .group = "Entrance",
                 .type = kBool,
                 .unit = Unit::kNone,
                 .defaultValue = 1,
                 .min = 0,
                 .max = 1,
                 .step = 1,
                 .choices = {},
                 .annotation = "@Handle(scope=Balcony, type=boolean, orient=front)"};
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
