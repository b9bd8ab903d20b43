#include "models/boat_parts.h"
#include "models/models.h"
#include "models/vocabulary.h"

// A galleon of the years around 1600, hauled out on blocks with her sails set: the great war and merchant ship with a
// low beakhead, a high stern and two to four masts. boat_plan decides where everything is; the other boat files draw it.

namespace dimline {

namespace {

using namespace boat;

std::vector<dimline::Parameter> boatParameters() {
  std::vector<dimline::Parameter> p(kParameterCount);

  p[kLength] = lengthParameter(
      "Length", "Length", {38, 26, 54, 0.5},
      {"Hull", "How long the hull is, from the stern to the stem; a longer ship carries more masts and guns.",
       "@Handle(scope=Hull, type=linear-contour, orient=right, slip=scope, align=bottom, chained, occlusion=false)"});
  p[kBeam] = lengthParameter(
      "Beam", "Beam", {10, 7, 13, 0.1},
      {"Hull", "How broad the hull is where it is broadest, at the wale amidships.",
       "@Handle(scope=Midship, type=linear-center, orient=front, slip=scope, chained, occlusion=false)"});
  p[kDepth] =
      lengthParameter("Depth", "Depth of hull", {6.4, 4.8, 8, 0.1},
                      {"Hull", "How deep the hull is amidships, from the main deck down to the keel.",
                       "@Handle(scope=Midship, type=linear-center, orient=up, slip=scope, chained, occlusion=false)"});
  p[kDraught] =
      lengthParameter("Draught", "Draught", {3, 2.2, 4, 0.05},
                      {"Hull", "How deep she floats: up to the waterline the hull is payed with white tallow.",
                       "@Handle(scope=Waterline, type=linear-center, orient=up, slip=scope, occlusion=false)"});
  p[kSheer] = lengthParameter("Sheer", "Sheer", {1.3, 0.4, 2.2, 0.05},
                              {"Hull", "How far the main deck rises from amidships to the stern.",
                               "@Handle(scope=Sheer, type=linear-center, orient=up, slip=scope, occlusion=false, min-length=24)"});
  p[kBeakLength] =
      lengthParameter("BeakLength", "Length of beakhead", {5, 2.5, 7, 0.1},
                      {"Hull", "How far the beakhead, the spur under the bowsprit, reaches out before the stem.",
                       "@Handle(scope=Beakhead, type=linear-center, orient=right, slip=scope)"});

  p[kGunPortSpacing] =
      lengthParameter("GunPortSpacing", "Gun port spacing", {2.8, 2.2, 4.5, 0.05},
                      {"Guns", "About how far apart the gun ports are; each side takes as many as fit evenly.",
                       "@Handle(scope=GunBay, type=linear-center, orient=right, slip=scope, indirect)"});
  p[kGunsRunOut] = switchParameter("GunsRunOut", "Guns run out", true,
                                   {"Guns", "Whether the ports are open and the guns run out, or the lids shut.",
                                    "@Handle(scope=Battery, type=boolean, orient=down)"});

  p[kForecastleLength] = lengthParameter("ForecastleLength", "Length of forecastle", {7.5, 5, 10, 0.1},
                                         {"Castles", "How long the forecastle is, the raised deck at the bow.",
                                          "@Handle(scope=Forecastle, type=linear-center, orient=left, slip=scope)"});
  p[kForecastleHeight] = lengthParameter("ForecastleHeight", "Height of forecastle", {2.2, 1.8, 3.2, 0.05},
                                         {"Castles", "How high the forecastle's deck lies above the main deck.",
                                          "@Handle(scope=Forecastle, type=linear-center, orient=up, slip=scope, min-length=28)"});
  p[kSternDecks] = countParameter(
      "SternDecks", "Decks of the sterncastle", {3, 1, 3, 1}, "deck",
      {"Castles", "How many decks the sterncastle has above the main deck: half deck, quarterdeck and poop.",
       "@Handle(scope=Sterncastle, type=linear-center, orient=up, slip=scope, indirect, occlusion=false)"});
  p[kSternDeckHeight] = lengthParameter(
      "SternDeckHeight", "Height between stern decks", {2.1, 1.8, 2.6, 0.05},
      {"Castles", "How high each deck of the sterncastle lies above the one below it.",
       "@Handle(scope=SternDeck, type=linear-center, orient=up, slip=scope, chained, occlusion=false, min-length=28)"});
  p[kGalleryDepth] =
      lengthParameter("GalleryDepth", "Depth of gallery", {1.2, 0.6, 2, 0.05},
                      {"Castles", "How far the gallery, the walk outside the great cabin, reaches out over the stern.",
                       "@Handle(scope=Gallery, type=linear-center, orient=left, slip=scope)"});

  p[kForeMastHeight] = lengthParameter(
      "ForeMastHeight", "Height of foremast", {27, 14, 36, 0.5},
      {"Masts", "How high the foremast rises above the deck that it stands on, up to its truck.",
       "@Handle(scope=ForeMast, type=linear-center, orient=up, slip=object, chained, occlusion=false)"});
  p[kMainMastHeight] = lengthParameter(
      "MainMastHeight", "Height of mainmast", {34, 18, 44, 0.5},
      {"Masts", "How high the mainmast rises above the main deck, up to its truck.",
       "@Handle(scope=MainMast, type=linear-center, orient=up, slip=object, chained, occlusion=false)"});
  p[kMizzenMastHeight] = lengthParameter(
      "MizzenMastHeight", "Height of mizzenmast", {19, 12, 28, 0.5},
      {"Masts", "How high the mizzenmast rises above its deck; ships shorter than 30 m have none.",
       "@Handle(scope=MizzenMast, type=linear-center, orient=up, slip=object, chained, occlusion=false)"});
  p[kBonaventureMastHeight] = lengthParameter(
      "BonaventureMastHeight", "Height of bonaventure mast", {14, 9, 20, 0.5},
      {"Masts",
       "How high the bonaventure mast rises above its deck, the small fourth mast at the stern of ships of 44 m and "
       "longer.",
       "@Handle(scope=BonaventureMast, type=linear-center, orient=up, slip=object, chained, occlusion=false)"});
  p[kBowspritLength] =
      lengthParameter("BowspritLength", "Length of bowsprit", {14, 8, 20, 0.5},
                      {"Masts", "How long the bowsprit is, the spar that slants out over the bow.",
                       "@Handle(scope=Bowsprit, type=linear-center, orient=right, slip=billboard, occlusion=false)"});
  p[kBowspritSteeve] = angleParameter("BowspritSteeve", "Steeve of bowsprit", {30, 15, 45, 1},
                                      {"Masts", "The angle at which the bowsprit rises from the level.",
                                       "@Handle(scope=Steeve, type=angular, orient=front, slip=none)"});

  p[kForeSailWidth] =
      lengthParameter("ForeSailWidth", "Width of fore course", {15.5, 10, 20, 0.25},
                      {"Sails", "How wide the lowest sail of the foremast is at its foot; those above it follow.",
                       "@Handle(scope=ForeSailFoot, type=linear-center, orient=front, slip=scope, align=top, chained, "
                       "occlusion=false)"});
  p[kMainSailWidth] =
      lengthParameter("MainSailWidth", "Width of main course", {19, 12, 24, 0.25},
                      {"Sails", "How wide the lowest sail of the mainmast is at its foot; those above it follow.",
                       "@Handle(scope=MainSailFoot, type=linear-center, orient=front, slip=scope, align=top, chained, "
                       "occlusion=false)"});
  p[kTopsailWidth] = lengthParameter(
      "TopsailWidth", "Width of main topsail", {9.5, 6, 12, 0.25},
      {"Sails", "How wide the main topsail is at its head; the sails taper towards it from the courses.",
       "@Handle(scope=TopsailHead, type=linear-center, orient=front, slip=scope, align=top, occlusion=false)"});
  p[kSailBelly] =
      lengthParameter("SailBelly", "Belly of main course", {1.9, 0.4, 3, 0.05},
                      {"Sails", "How far the wind fills the main course forward of its yard; the other sails follow.",
                       "@Handle(scope=MainSailBelly, type=linear-center, orient=right, slip=scope, occlusion=false, min-length=28)"});
  return p;
}

/// About so many are in the hull, castles and ropes themselves; guns, blocks and the like are placed.
constexpr std::size_t kTrianglesAtDefaults = 36'000;

Scene buildBoat(const Values& values) {
  const Plan plan = planBoat(values);
  Builder b;
  b.reserve(kTrianglesAtDefaults);
  const Palette palette(b);
  const Ship ship{b, plan, palette};
  b.translate({-plan.hull.length * 0.5, kBlocks + kKeel, 0});
  buildHull(ship);
  buildGuns(ship);
  buildCastles(ship);
  buildStern(ship);
  buildBeakhead(ship);
  buildRig(ship);
  buildRopes(ship);
  return b.finish();
}

}  // namespace

ModelDefinition defineBoat() {
  return {"boat", "Galleon", boatParameters(), buildBoat,
          {lengthMeasure("OverallLength", "Length overall", "How long the ship is, from the end of the bowsprit to the stern.",
                         "@Handle(scope=Model, type=linear-contour, orient=front, slip=scope, align=bottom, occlusion=false)"),
           lengthMeasure("OverallHeight", "Overall height", "How high the ship is, from the keel to the top of the mainmast.",
                         "@Handle(scope=Model, type=linear-contour, orient=up, slip=scope, occlusion=false)")}};
}

}  // namespace dimline
