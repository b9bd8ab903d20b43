#pragma once

#include <vector>

#include "model/builder.h"
#include "model/model.h"

// The family house in numbers, before anything is drawn: where walls, floors and openings are. Inner header of the
// house model.
//
// The house stands over the origin, its front towards +z, the ground at y = 0. A facade's coordinates are x from its
// left end seen from outside and y from the ground floor's level.

namespace dimline::house {

/// The parameters, in the order of their definition.
enum Parameter : std::size_t {
  kWidth,
  kDepth,
  kFloors,
  kFloorHeight,
  kRoofType,
  kRoofPitch,
  kRoofOverhang,
  kChimneyHeight,
  kWindowWidth,
  kWindowHeight,
  kSillHeight,
  kWindowSpacing,
  kDoorWidth,
  kBalcony,
  kParameterCount
};

enum class RoofType { kGable, kHip, kShed, kFlat };

// Fixed sizes that more than one part of the house depends on (m).
inline constexpr double kPlinth = 0.45;  ///< ground floor above the ground: three steps
inline constexpr double kWallThickness = 0.36;
inline constexpr double kCornerMargin = 0.5;  ///< wall at each end of a facade that no bay reaches into
inline constexpr double kMinPier = 0.35;      ///< least wall between two windows
inline constexpr double kReveal = 0.12;       ///< how far windows and doors lie behind the wall's face
inline constexpr double kSurround = 0.09;     ///< width of the trim around windows
inline constexpr double kDoorSurround = 0.2;  ///< and around the front door, with its cornice

struct Opening {
  enum class Kind { kWindow, kDoor, kBalconyDoor, kTerraceDoor, kAttic };
  Kind kind = Kind::kWindow;
  int floor = 0;
  int bay = 0;
  double x = 0, y = 0, width = 0, height = 0;
  bool shutters = false;
  [[nodiscard]] double endX() const { return x + width; }
};

/// How far behind the front wall the two slopes of a shed roof part, as a share of the depth.
inline constexpr double kShedSplit = 0.42;

/// One side of the house: bays of equal width, one window in the middle of each.
struct Facade {
  Face face = Face::kFront;
  double length = 0;
  int bays = 1;
  double bayWidth = 0;            ///< distance of two window axes
  bool shutters = false;          ///< whether two open leaves fit between two windows
  std::vector<Opening> openings;  ///< apart from each other and from the wall's ends

  [[nodiscard]] double axisOf(int bay) const { return kCornerMargin + (bay + 0.5) * bayWidth; }
};

/// What is in front of the entrance: a landing with steps, and over it a balcony or a canopy.
struct Entrance {
  double center = 0;  ///< facade x
  double doorWidth = 0, doorHeight = 0;
  bool lamps = false;  ///< on both sides of the door, where its neighbours leave room
  double canopyWidth = 0;
  double landingWidth = 0, landingDepth = 0;
  bool balcony = false;
  double balconyWidth = 0, balconyDepth = 0;  ///< also where a balcony would be
};

struct Plan {
  double width = 0, depth = 0;
  int floors = 1;
  double floorHeight = 0;
  RoofType roof = RoofType::kGable;
  double pitchRad = 0, overhang = 0, chimneyHeight = 0;
  double windowWidth = 0, windowHeight = 0, sillHeight = 0;
  double wallHeight = 0;  ///< of all storeys
  /// Wall between the last storey and a pitched roof's underside, at the wall's face: what the eave hangs down.
  double kneeHeight = 0;
  Facade front, right, back, left;
  Entrance entrance;
};

Plan planHouse(const Values& values);

/// The upper edge of a facade's wall between two places, from right to left: the roof's underside there.
Ring wallTop(const Plan& plan, const Facade& facade, double fromX, double toX);

}  // namespace dimline::house
