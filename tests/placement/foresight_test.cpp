#include <catch2/catch.hpp>

#include <cmath>

#include "placement/foresight.h"

using namespace dimline;

namespace {

/// A box 4 wide (x), 3 high and 2 deep (z) around the origin on the ground.
Bounds boxBounds() {
  Bounds bounds;
  bounds.add({-2, 0, -1});
  bounds.add({2, 3, 1});
  return bounds;
}

/// Its upright edge at the front right, with the planes of the two faces that meet there: number 0 is the front's, 1 the right side's.
BaseLine edge() {
  BaseLine line;
  line.segment = {{2, 0, 1}, {2, 3, 1}};
  line.scopePlanes.push_back({.across = {1, 0, 0}, .normal = {0, 0, 1}});
  line.scopePlanes.push_back({.across = {0, 0, 1}, .normal = {1, 0, 0}});
  return line;
}

/// From the front, turned to the right by an angle, level and orthographic.
View turnedBy(double deg) {
  Camera camera;
  camera.eye = {30 * std::sin(deg * kRadPerDeg), 1.5, 30 * std::cos(deg * kRadPerDeg)};
  camera.target = {0, 1.5, 0};
  camera.orthoHeightM = 10;
  return {camera, 1000, 1000, boxBounds()};
}

/// From the front and level, from so far away; or orthographic, seeing that height.
View from(double distanceM) {
  Camera camera;
  camera.eye = {0, 1.5, distanceM};
  camera.target = {0, 1.5, 0};
  camera.fovRad = 0.2;
  return {camera, 1000, 1000, boxBounds()};
}
View seeing(double heightM) {
  Camera camera = from(30).camera();
  camera.orthoHeightM = heightM;
  return {camera, 1000, 1000, boxBounds()};
}

/// What lies that far to the right of the middle, and is 1 m high.
Segment rightBy(double metres) { return {{metres, 1, 0}, {metres, 2, 0}}; }

/// Whether a plane of the edge lasts for a line 1 m to the right of it, or in front of it, while the view turns from one angle to the other.
bool lasts(Slip slip, const std::vector<ObjectPlane>& objectPlanes, const Vec3& normal, const Vec3& towards, double fromDeg, double toDeg) {
  constexpr double kToleranceM = 1e-3;
  const View now = turnedBy(toDeg);
  Foresight foresight;
  foresight.begin(turnedBy(fromDeg), now, boxBounds(), objectPlanes, kToleranceM);
  std::vector<ObjectPlaneUse> uses;
  facePlanes(objectPlanes, now, uses);
  std::vector<SlipPlane> planes;
  slipPlanes(edge(), slip, now, {objectPlanes, uses, kToleranceM}, planes);
  for (const SlipPlane& plane : planes) {
    if (glm::dot(plane.plane.normal, normal) < 0.99) continue;
    const Segment& atItself = edge().segment;   // in view all the time
    return foresight.prospect({edge(), slip, plane, glm::dot(plane.across, towards) > 0 ? 1 : -1, 1.0, atItself}).price == 0;
  }
  FAIL("no such plane in this frame");
  return false;
}

/// A short line in the middle of the front.
BaseLine inTheMiddle() {
  BaseLine line;
  line.segment = {{-0.1, 1, 0}, {0.1, 1, 0}};
  return line;
}

/// What the movement from one view to the next does to a line outside the model, in the plane that faces the viewer.
Foresight::Prospect prospectOutside(const View& before, const View& now, const Segment& line, const BaseLine& feature = inTheMiddle(), double leastPx = 0, const Vec2& textSize = Vec2(0.0)) {
  Foresight foresight;
  foresight.begin(before, now, boxBounds(), {}, 1e-3);
  std::vector<SlipPlane> planes;
  slipPlanes(feature, Slip::kBillboard, now, {}, planes);
  REQUIRE(planes.size() == 1);
  return foresight.prospect({feature, Slip::kBillboard, planes[0], 1, 0.0, line, leastPx, textSize});
}
double priceInside(const Foresight& foresight, const Segment& base) { return foresight.prospectInside(base, 0).price; }
double priceOutside(const View& before, const View& now, const Segment& line, const BaseLine& feature = inTheMiddle()) {
  return prospectOutside(before, now, line, feature).price;
}

const Vec3 kFront{0, 0, 1};
const Vec3 kRight{1, 0, 0};

}  // namespace

TEST_CASE("a plane that turns edge-on does not last; one that turns towards the viewer does") {
  // The front's plane is left out from 84 to 96 degrees: 20 degrees after 71 it is seen edge-on. Turning back, it is at 51.
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 70, 71));
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 72, 71));
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 60, 61));
  // A quick movement is followed as far as a slow one, and at least for one frame.
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 66, 71));
  CHECK_FALSE(lasts(Slip::kScope, {}, kFront, kRight, 35, 60));
}

TEST_CASE("while the view does not turn, everything lasts, but what is turned away costs something") {
  CHECK(lasts(Slip::kScope, {}, kFront, kRight, 80, 80));
  Foresight foresight;
  foresight.begin(std::nullopt, turnedBy(80), boxBounds(), {}, 1e-3);
  SlipPlane none;
  none.number = 7;   // not one of the edge's
  CHECK(foresight.prospect({edge(), Slip::kScope, none, 1, 1.0, edge().segment}).price == 0);
  // From 80 degrees on the right the right side is in view, the left and the back are not.
  BaseLine withFaces = edge();
  withFaces.faces.push_back({0, 0, -1});
  withFaces.faces.push_back({1, 0, 0});
  CHECK(foresight.prospect({withFaces, Slip::kScope, none, 1, 1.0, edge().segment}).price == 0);
  withFaces.faces[1] = {-1, 0, 0};
  CHECK(foresight.prospect({withFaces, Slip::kScope, none, 1, 1.0, edge().segment}).price == Approx(kScoreSoonGone * kTurnedAwayShare));
}

TEST_CASE("the part of an object plane that a neighbour is about to cut off does not last") {
  std::vector<Segment> uprights;
  for (const double x : {-2.0, 2.0}) {
    for (const double z : {-1.0, 1.0}) uprights.push_back({{x, 0, z}, {x, 3, z}});
  }
  const auto planes = objectPlanes(uprights, boxBounds());
  // Seen straight from the front the right side is edge-on, and the front goes on past the corner; 20 degrees further right both are front planes, which clip each other.
  CHECK_FALSE(lasts(Slip::kObject, planes, kFront, kRight, -3, -2));
  // Turning left, the right side becomes a back plane, which does not.
  CHECK(lasts(Slip::kObject, planes, kFront, kRight, -1, -2));
  // To the left the front reaches 4 m, as far as its other corner, whatever the right side does.
  CHECK(lasts(Slip::kObject, planes, kFront, -kRight, -3, -2));
}

TEST_CASE("what the camera comes nearer to leaves the viewport") {
  // A height of 9 m after 10 m is one of 1.853 m fifteen frames on, when the picture has grown by about exp(kForesightZoom); half of that lies to the right of the middle.
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(0.91)) == 0);
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(0.92)) < 0);   // within the margin of 6 px
  CHECK(priceOutside(seeing(10), seeing(9), {{-20, 1, 0}, {20, 1, 0}}) < 0);
  // Going back, there is ever more room.
  CHECK(priceOutside(seeing(9), seeing(10), rightBy(4.9)) == 0);

  Foresight foresight;
  foresight.begin(seeing(10), seeing(9), boxBounds(), {}, 1e-3);
  CHECK(priceInside(foresight, rightBy(0.92)) == 0);
  CHECK(priceInside(foresight, rightBy(0.94)) < 0);
  CHECK(priceInside(foresight, {{-20, 1, 0}, {20, 1, 0}}) == 0);
}

TEST_CASE("a camera that comes nearer is told from one that goes away, turns or stands still") {
  const auto nears = [](const View& before, const View& now) {
    Foresight foresight;
    foresight.begin(before, now, boxBounds(), {}, 1e-3);
    return foresight.nears();
  };
  CHECK(nears(from(30), from(29)));
  CHECK_FALSE(nears(from(29), from(30)));
  CHECK(nears(seeing(10), seeing(9.8)));
  CHECK_FALSE(nears(seeing(9.8), seeing(10)));
  CHECK_FALSE(nears(turnedBy(0), turnedBy(2)));
  CHECK_FALSE(nears(from(30), from(30)));
}

TEST_CASE("what is lost sooner costs more") {
  // Looked at are the next four frames, the eighth and the fifteenth: to the right of the middle 4.05 m are seen in the first, then 3.645, 3.28, 2.95, 1.94 and 0.93 m.
  const double worst = kScoreSoonGone * kSoonGoneZooming;
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(4.2)) == worst);
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(3.8)) == Approx(5.0 / 6 * worst));
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(3.1)) == Approx(3.0 / 6 * worst));
  CHECK(priceOutside(seeing(10), seeing(9), rightBy(1.5)) == Approx(1.0 / 6 * worst));
  // A slow movement is looked at kLooksAheadZooming times on its way.
  Foresight foresight;
  foresight.begin(seeing(9.01), seeing(9), boxBounds(), {}, 1e-3);
  double last = worst;
  int steps = 0;
  for (double x = 4.6; x > 3; x -= 0.01) {
    const double price = priceInside(foresight, rightBy(x));
    CHECK(price >= last);
    if (price > last) ++steps;
    last = price;
  }
  CHECK(last == 0);
  CHECK(steps == kLooksAheadZooming);
}

TEST_CASE("what is lost within a turn of kForesightRad, or a zoom of kBriefZoom, is brief") {
  // Four frames on the picture has grown by exp(0.42), eight frames on by exp(0.84).
  CHECK(prospectOutside(seeing(10), seeing(9), rightBy(3.1)).brief);
  CHECK_FALSE(prospectOutside(seeing(10), seeing(9), rightBy(2.5)).brief);
  CHECK_FALSE(prospectOutside(seeing(10), seeing(9), rightBy(0.5)).brief);
  CHECK_FALSE(prospectOutside(seeing(9), seeing(9), rightBy(4.2)).brief);
  // Twenty degrees round, what lies so far behind the middle is 5 m, or 4.9 m, to the side.
  CHECK(prospectOutside(turnedBy(0), turnedBy(1), {{0, 1, -14.6}, {0, 2, -14.6}}).brief);
  CHECK_FALSE(prospectOutside(turnedBy(0), turnedBy(1), {{0, 1, -14.3}, {0, 2, -14.3}}).brief);
}

TEST_CASE("while the view turns, what is lost at the first look ahead only passes through the picture") {
  // The first look is 6 degrees ahead: then what lies so far behind the middle is at the picture's edge.
  const double edgeM = 5 / std::sin(6 * kRadPerDeg);
  const auto passing = [&](double share) { return prospectOutside(turnedBy(-1), turnedBy(0), {{0, 1, -share * edgeM}, {0, 2, -share * edgeM}}).passing; };
  CHECK(passing(1.05));
  CHECK_FALSE(passing(0.95));
  CHECK_FALSE(prospectOutside(seeing(10), seeing(9), rightBy(4.06)).passing);
}

TEST_CASE("outside the model, what is lost at the next look is in its last moments, while the camera comes nearer") {
  // To the right of the middle 4.05 m are seen at the first look, then 3.645 m.
  CHECK(prospectOutside(seeing(10), seeing(9), rightBy(4.06)).lastMoments);
  CHECK_FALSE(prospectOutside(seeing(10), seeing(9), rightBy(3.9)).lastMoments);
  CHECK_FALSE(prospectOutside(seeing(9), seeing(9), rightBy(4.06)).lastMoments);
  CHECK_FALSE(prospectOutside(turnedBy(0), turnedBy(1), {{0, 1, -29}, {0, 2, -29}}).lastMoments);
}

TEST_CASE("a line inside the model comes out in vain where it has no room any more at one of the first looks, or soon in a turn") {
  // To the right of the middle 4.05 m are seen at the first look, then 3.645, 3.28 and 2.95 m.
  CHECK(prospectOutside(seeing(10), seeing(9), rightBy(3.29)).outInVain);
  CHECK_FALSE(prospectOutside(seeing(10), seeing(9), rightBy(3.1)).outInVain);
  CHECK_FALSE(prospectOutside(seeing(9), seeing(9), rightBy(4.06)).outInVain);
  CHECK(prospectOutside(turnedBy(0), turnedBy(1), {{0, 1, -14.6}, {0, 2, -14.6}}).outInVain);
  CHECK_FALSE(prospectOutside(turnedBy(0), turnedBy(1), {{0, 1, -14.3}, {0, 2, -14.3}}).outInVain);
}

TEST_CASE("inside the model, what leaves the picture at one of the first looks is in its last moments, and not shown anew when still sooner") {
  Foresight foresight;
  foresight.begin(seeing(10), seeing(9), boxBounds(), {}, 1e-3);
  // To the right of the middle 4.05 m are seen at the first look, then 3.645, 3.28, 2.95, 1.94 and 0.93 m.
  CHECK(foresight.prospectInside(rightBy(2.96), 0).lastMoments);
  CHECK_FALSE(foresight.prospectInside(rightBy(2.94), 0).lastMoments);
  CHECK(foresight.prospectInside(rightBy(3.29), 0).goneSoon);
  CHECK_FALSE(foresight.prospectInside(rightBy(3.27), 0).goneSoon);
  // So quick a zoom is looked ahead of once, where 0.9 m are seen.
  foresight.begin(seeing(20), seeing(6), boxBounds(), {}, 1e-3);
  REQUIRE(foresight.lookCount() == 1);
  CHECK_FALSE(foresight.prospectInside(rightBy(0.8), 0).lastMoments);
  CHECK(foresight.prospectInside(rightBy(1.0), 0).lastMoments);
  CHECK(foresight.prospectInside(rightBy(1.0), 0).goneSoon);
  // Not while the camera turns.
  foresight.begin(turnedBy(0), turnedBy(1), boxBounds(), {}, 1e-3);
  CHECK_FALSE(foresight.prospectInside(rightBy(5.1), 0).lastMoments);
  CHECK_FALSE(foresight.prospectInside(rightBy(5.1), 0).goneSoon);
}

TEST_CASE("as the camera goes away, what will be too short to be measured is lost, sooner or later") {
  // A height of 10 m after 9 m: 1 m is 100 px long now, 90 at the first look, 81, 72.9, 65.6, 43.0 and 20.6 at the last.
  const double worst = kScoreSoonGone * kSoonGoneZooming;
  Foresight foresight;
  foresight.begin(seeing(9), seeing(10), boxBounds(), {}, 1e-3);
  const auto inside = [&](double leastPx) { return foresight.prospectInside(rightBy(1), leastPx); };
  BaseLine upright;
  upright.segment = rightBy(1);
  const auto outside = [&](double leastPx) { return prospectOutside(seeing(9), seeing(10), rightBy(1.5), upright, leastPx); };
  CHECK(inside(20).price == 0);
  CHECK(outside(20).price == 0);
  CHECK(inside(21).price == Approx(worst / 6));
  CHECK(outside(21).price == Approx(worst / 6));
  CHECK(inside(91).price == worst);
  CHECK(outside(91).price == worst);
  // It is begun all the same: its feature is not better served elsewhere.
  CHECK_FALSE(inside(91).lastMoments);
  CHECK_FALSE(outside(91).lastMoments);
  CHECK_FALSE(outside(91).brief);
  // But it is not shown anew when it is too short at the third look.
  CHECK(inside(73).goneSoon);
  CHECK(outside(73).goneSoon);
  CHECK_FALSE(inside(72).goneSoon);
  CHECK_FALSE(outside(72).goneSoon);
  CHECK(prospectOutside(seeing(10), seeing(9), rightBy(1.5), upright, 1000).goneSoon);
  CHECK_FALSE(prospectOutside(seeing(10), seeing(10), rightBy(1.5), upright, 1000).goneSoon);
}

TEST_CASE("a place is lost as well when the viewport has no room for its label any more") {
  // At the last look 1 m is 539.7 px long, and the viewport's edge 500 px to the right of the middle. A label of 60 px on the upright line needs 30 px beside it, and there is a margin of 6 px: 464 px are 0.8598 m.
  const auto price = [](double x, const Vec2& textSize) { return prospectOutside(seeing(10), seeing(9), rightBy(x), inTheMiddle(), 0, textSize).price; };
  CHECK(price(0.855, {60, 14}) == 0);
  CHECK(price(0.865, {60, 14}) < 0);
  CHECK(price(0.865, Vec2(0.0)) == 0);
}

TEST_CASE("a line comes nearer to the model by what handleSpacing is less when the camera has come nearer") {
  BaseLine upright;
  upright.segment = {{0, 1, 0}, {0, 2, 0}};
  const View now = seeing(9);
  Foresight foresight;
  foresight.begin(seeing(10), now, boxBounds(), {}, 1e-3);
  std::vector<SlipPlane> planes;
  slipPlanes(upright, Slip::kBillboard, now, {}, planes);
  REQUIRE(planes.size() == 1);
  const int right = planes[0].across.x > 0 ? 1 : -1;
  const auto priceAt = [&](double x, double offsetM) { return foresight.prospect({upright, Slip::kBillboard, planes[0], right, offsetM, rightBy(x)}).price; };
  // A pixel is 9 mm now and 1.853 mm at the last look: 30 of them are 0.2144 m less. What is seen then ends 0.915 m to the right of the middle.
  CHECK(priceAt(1.12, 1) == 0);
  CHECK(priceAt(1.14, 1) < 0);
  // Not nearer than its base line.
  CHECK(priceAt(1.00, 0.1) == 0);
  CHECK(priceAt(1.03, 0.1) < 0);
}

TEST_CASE("a feature whose faces turn away costs a share, and one that no faces meet in none") {
  BaseLine frontEdge = edge();
  frontEdge.faces.push_back({0, 0, 1});
  frontEdge.faces.push_back({1, 0, 0});
  const Segment middle = inTheMiddle().segment;
  // Of its two faces the front turns away after 90 degrees, the right side stays in view.
  CHECK(priceOutside(turnedBy(78), turnedBy(79), middle, frontEdge) == 0);
  BaseLine front = edge();
  front.faces.push_back({0, 0, 1});
  CHECK(priceOutside(turnedBy(60), turnedBy(61), middle, front) == 0);
  // It counts as turned away from 95.7 degrees on. Three looks, the last 19 frames ahead: at 85, 92 and 98 degrees; and at 97 and further on.
  CHECK(priceOutside(turnedBy(78), turnedBy(79), middle, front) == Approx(kTurnedAwayShare * kScoreSoonGone / 3));
  CHECK(priceOutside(turnedBy(90), turnedBy(91), middle, front) == kTurnedAwayShare * kScoreSoonGone);
  CHECK(priceOutside(turnedBy(88), turnedBy(89), middle, edge()) == 0);
}

TEST_CASE("a camera that flies towards its target is followed, not through it") {
  // From 30 m at 27 m: at 5.56 m fifteen frames on, where half the viewport is 0.558 m wide.
  CHECK(priceOutside(from(30), from(27), rightBy(0.54)) == 0);
  CHECK(priceOutside(from(30), from(27), rightBy(0.56)) < 0);
  // By nearly as much as that in one frame: two frames on it is at 1.25 m.
  Foresight foresight;
  foresight.begin(from(10), from(5), boxBounds(), {}, 1e-3);
  CHECK(priceInside(foresight, rightBy(0.12)) == 0);
  CHECK(priceInside(foresight, rightBy(0.13)) < 0);
}

TEST_CASE("before a still camera the movement is thought to go on as it did; after a scene's edit it is not") {
  Foresight turning;
  const auto isBrief = [&] {
    std::vector<SlipPlane> planes;
    slipPlanes(edge(), Slip::kScope, turnedBy(75), {}, planes);
    const BaseLine feature = edge();
    return turning.prospect({feature, Slip::kScope, planes.front(), 1, 1.0, feature.segment}).brief;
  };
  turning.begin(turnedBy(65), turnedBy(75), boxBounds(), {}, 1e-3);
  REQUIRE(isBrief());
  turning.begin(turnedBy(75), turnedBy(75), boxBounds(), {}, 1e-3);
  REQUIRE(isBrief());
  turning.begin(std::nullopt, turnedBy(75), boxBounds(), {}, 1e-3);
  CHECK_FALSE(isBrief());
  Foresight foresight;
  foresight.begin(seeing(10), seeing(9), boxBounds(), {}, 1e-3);
  foresight.begin(seeing(9), seeing(9), boxBounds(), {}, 1e-3);
  CHECK(priceInside(foresight, rightBy(3.7)) < 0);
  foresight.begin(std::nullopt, seeing(9), boxBounds(), {}, 1e-3);
  CHECK(priceInside(foresight, rightBy(3.7)) == 0);
}
