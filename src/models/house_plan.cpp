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

/// Half the balcony's width: enough for the door below, and such that its ends meet the wall between two windows.
double balconyHalfWidth(const Plan& plan, const Facade& f, double center, double doorWidth, double balconyDoorWidth) {
  const double need = std::max(doorWidth * 0.5 + 0.55, 1.2);
  const double room = std::min(center, f.length - center) - 0.3;
  for (int bay = 0; bay < f.bays; ++bay) {
    const double low = bay == 0 ? balconyDoorWidth * 0.5 + 0.3 : bay * f.bayWidth + plan.windowWidth * 0.5 + 0.15;
    const double high = (bay + 1) * f.bayWidth - plan.windowWidth * 0.5 - 0.15;
    if (high >= need) return std::min(std::max(low, need), room);
  }
  return std::min(need, room);
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

}  // namespace

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
  planEntrance(plan, values.at(kDoorWidth), values.at(kBalcony) != 0);

  const int bay = (plan.back.bays - 1) / 2;
  const double terraceDoor = std::clamp(plan.back.bayWidth * 0.8, 1.4, 2.2);
  insertDoor(plan.back, {Opening::Kind::kTerraceDoor, 0, bay, plan.back.axisOf(bay) - terraceDoor * 0.5, 0, terraceDoor,
                         doorHead(plan)});
  return plan;
}

}  // namespace dimline::house
