#include "models/house_plan.h"

#include <algorithm>
#include <cmath>

namespace dimline::house {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLintel = 0.3;         // wall above a door, at least
constexpr double kDoorClearance = 0.3;  // wall between a door and its neighbours
constexpr double kBalconyReach = 1.35;

Facade makeFacade(const Plan& plan, Face face, double length, double spacing) {
  Facade f;
  f.face = face;
  f.length = length;
  const double usable = length - 2 * kCornerMargin;
  const int most = std::max(1, static_cast<int>(std::floor(usable / (plan.windowWidth + kMinPier))));
  f.bays = std::min(repeatCount(usable, spacing), most);
  f.bayWidth = usable / f.bays;
  for (int floor = 0; floor < plan.floors; ++floor) {
    for (int bay = 0; bay < f.bays; ++bay) {
      f.openings.push_back({Opening::Kind::kWindow, floor, bay, f.axisOf(bay) - plan.windowWidth * 0.5,
                            floor * plan.floorHeight + plan.sillHeight, plan.windowWidth, plan.windowHeight});
    }
  }
  return f;
}

/// Puts a door in and takes out the windows of its storey that would come too near, and the one of its own bay.
void insertDoor(Facade& f, const Opening& door) {
  std::erase_if(f.openings, [&](const Opening& o) {
    return o.floor == door.floor && (o.bay == door.bay || (o.x < door.x + door.width + kDoorClearance &&
                                                           door.x < o.x + o.width + kDoorClearance));
  });
  f.openings.push_back(door);
}

/// The head of doors: level with the windows' where that is high enough to walk through.
double doorHead(const Plan& plan) {
  return std::clamp(plan.sillHeight + plan.windowHeight, 2.1, plan.floorHeight - kLintel);
}

/// Wall that a window needs beside it: its trim, or a leaf of its shutters.
double besideWindow(const Plan& plan, bool shutters) {
  return kSurround + (shutters ? plan.windowWidth * 0.5 + 0.03 : 0.01);
}

/// Half the balcony's width: enough for the door below, and such that its ends meet the wall between two windows.
double balconyHalfWidth(const Plan& plan, const Facade& f, double center, double doorWidth, double balconyDoorWidth) {
  const double need = std::max(doorWidth * 0.5 + 0.55, 1.2);
  const double room = std::min(center, f.length - center) - 0.3;
  const double beside = plan.windowWidth * 0.5 + besideWindow(plan, f.shutters) + 0.04;
  for (int bay = 0; bay < f.bays; ++bay) {
    const double low = bay == 0 ? balconyDoorWidth * 0.5 + 0.3 : bay * f.bayWidth + beside;
    const double high = (bay + 1) * f.bayWidth - beside;
    if (high >= need || (bay + 0.5) * f.bayWidth >= need)
      return std::min(low > high ? (low + high) * 0.5 : std::clamp(need, low, high), room);
  }
  return std::min(need, room);
}

/// Shutters go to every window of a facade whose bays are wide enough, except beside a door that leaves no room for
/// them.
void planShutters(const Plan& plan, Facade& f) {
  const double leaf = besideWindow(plan, true);
  for (Opening& o : f.openings) {
    o.shutters = f.shutters && o.kind == Opening::Kind::kWindow;
    for (const Opening& door : f.openings) {
      if (door.kind == Opening::Kind::kWindow || door.floor != o.floor || door.kind == Opening::Kind::kAttic) continue;
      const double gap = std::max(door.x - o.endX(), o.x - door.endX());
      const double surround = door.kind == Opening::Kind::kDoor ? kDoorSurround : kSurround;
      if (gap < leaf + surround + 0.02) o.shutters = false;
    }
  }
}

/// How far wall without a window, and without its trim and shutters, reaches to both sides of the door's middle.
double wallBesideDoor(const Plan& plan) {
  const double center = plan.entrance.center;
  double reach = std::min(center, plan.front.length - center) - 0.25;
  for (const Opening& o : plan.front.openings) {
    if (o.floor != 0 || o.kind != Opening::Kind::kWindow) continue;
    reach = std::min(reach, std::max(o.x - center, center - o.endX()) - besideWindow(plan, o.shutters));
  }
  return reach;
}

void planEntrance(Plan& plan, double doorWidth, bool balcony) {
  Facade& f = plan.front;
  Entrance& e = plan.entrance;
  const int bay = f.bays / 2;
  e.center = f.axisOf(bay);
  e.doorWidth = doorWidth;
  e.doorHeight = doorHead(plan);
  insertDoor(f, {Opening::Kind::kDoor, 0, bay, e.center - doorWidth * 0.5, 0, doorWidth, e.doorHeight});

  const double balconyDoorWidth = std::clamp(plan.windowWidth, 0.9, 1.6);
  e.balconyDepth = kBalconyReach;
  e.balconyWidth = 2 * balconyHalfWidth(plan, f, e.center, doorWidth, balconyDoorWidth);
  e.balcony = balcony && plan.floors >= 2;
  if (e.balcony) {
    insertDoor(f, {Opening::Kind::kBalconyDoor, 1, bay, e.center - balconyDoorWidth * 0.5, plan.floorHeight,
                   balconyDoorWidth, doorHead(plan)});
  }
  e.landingWidth = e.balcony ? e.balconyWidth + 0.1 : doorWidth + 1.1;
  e.landingDepth = e.balcony ? kBalconyReach + 0.1 : 1.1;
}

/// Windows in a gable, above the last floor and above that, where the slopes leave room.
void planAttic(const Plan& plan, Facade& f) {
  const double w = 0.8, h = 1.05, slope = std::tan(plan.pitchRad), middle = f.length * 0.5;
  for (double sill = 0.7;; sill += 2.5) {
    const double roomAside =
        (plan.kneeHeight + middle * slope - sill - h) / slope;  // beside the middle, at the windows' head
    if (roomAside < 0.85) return;
    const Opening attic{Opening::Kind::kAttic, plan.floors, -1, middle - w * 0.5, plan.wallHeight + sill, w, h};
    for (const double aside : roomAside >= 1.9 ? std::vector{-0.75, 0.75} : std::vector{0.0}) {
      f.openings.push_back(attic);
      f.openings.back().x += aside;
    }
  }
}

}  // namespace

Ring wallTop(const Plan& plan, const Facade& facade, double fromX, double toX) {
  const double bury = 0.03;  // into the roof's slab, so that no gap shows
  const double base = plan.wallHeight + plan.kneeHeight, slope = std::tan(plan.pitchRad), d = facade.length;
  const bool side = facade.face == Face::kRight || facade.face == Face::kLeft;
  if (plan.roof == RoofType::kGable && side) {
    return {{toX, base + (d - toX) * slope + bury},
            {d * 0.5, base + d * 0.5 * slope + bury},
            {fromX, base + fromX * slope + bury}};
  }
  if (plan.roof == RoofType::kShed && side) {
    // Seen from the right the front is to the left.
    const double run = d * kShedSplit;
    Ring top{{d - fromX, base + fromX * slope + bury},
             {run, base + (d - run) * slope + bury},
             {run, base + run * slope + bury},
             {fromX, base + fromX * slope + bury}};
    if (facade.face == Face::kLeft) {
      std::reverse(top.begin(), top.end());
      for (Vec2& p : top) p.x = d - p.x;
    }
    return top;
  }
  return {{toX, base + bury}, {fromX, base + bury}};
}

Plan planHouse(const Values& values) {
  Plan plan;
  plan.width = values.at(kWidth);
  plan.depth = values.at(kDepth);
  plan.floors = static_cast<int>(values.at(kFloors));
  plan.floorHeight = values.at(kFloorHeight);
  plan.roof = static_cast<RoofType>(static_cast<int>(values.at(kRoofType)));
  plan.pitchRad = values.at(kRoofPitch) * kPi / 180;
  plan.overhang = values.at(kRoofOverhang);
  plan.chimneyHeight = values.at(kChimneyHeight);
  plan.windowWidth = values.at(kWindowWidth);
  plan.windowHeight = values.at(kWindowHeight);
  plan.sillHeight = values.at(kSillHeight);
  plan.wallHeight = plan.floors * plan.floorHeight;
  plan.kneeHeight = plan.roof == RoofType::kFlat ? 0 : plan.overhang * std::tan(plan.pitchRad);

  const double spacing = values.at(kWindowSpacing);
  plan.front = makeFacade(plan, Face::kFront, plan.width, spacing);
  plan.back = makeFacade(plan, Face::kBack, plan.width, spacing);
  plan.right = makeFacade(plan, Face::kRight, plan.depth, spacing);
  plan.left = makeFacade(plan, Face::kLeft, plan.depth, spacing);
  // All sides have shutters or none: two open leaves must fit between any two windows.
  const double narrowest = std::min(plan.front.bayWidth, plan.right.bayWidth);
  const bool shutters = narrowest >= 2 * plan.windowWidth + 2 * kSurround + 0.1;
  for (Facade* f : {&plan.front, &plan.right, &plan.back, &plan.left}) f->shutters = shutters;
  planEntrance(plan, values.at(kDoorWidth), values.at(kBalcony) != 0);

  const int bay = (plan.back.bays - 1) / 2;
  const double terraceDoor = std::clamp(plan.back.bayWidth * 0.8, 1.4, 2.2);
  insertDoor(plan.back, {Opening::Kind::kTerraceDoor, 0, bay, plan.back.axisOf(bay) - terraceDoor * 0.5, 0, terraceDoor,
                         doorHead(plan)});
  if (plan.roof == RoofType::kGable) {
    planAttic(plan, plan.right);
    planAttic(plan, plan.left);
  }
  for (Facade* f : {&plan.front, &plan.right, &plan.back, &plan.left}) planShutters(plan, *f);
  // Lamps hang 0.37 m beside the door's opening and are 0.16 m wide.
  Entrance& e = plan.entrance;
  const double reach = wallBesideDoor(plan);
  e.lamps = reach > e.doorWidth * 0.5 + 0.5;
  e.canopyWidth = 2 * std::clamp(reach - 0.02, e.doorWidth * 0.5 + 0.22, e.doorWidth * 0.5 + 0.6);
  return plan;
}

}  // namespace dimline::house
