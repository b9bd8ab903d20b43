#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include "placement/arcs.h"
#include "placement/pills.h"
#include "silhouette/cpu_fields.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

Annotation annotated(HandleType type, Orient orient, Slip slip) {
  Annotation a;
  a.scope = "Box";
  a.type = type;
  a.orient = orient;
  a.slip = slip;
  return a;
}

/// A box 8 by 5 by 6 seen orthographically from the front at 50 px a metre: it covers x 300..700, y 375..625.
struct FrontOfBox {
  Scene scene;
  View view;
  DistanceFields fields, padded;
  Landed landed;
  std::vector<std::size_t> scopes{0};
  History none{0};

  FrontOfBox() {
    const Obb box = boxAt({-4, 0, -3}, {8, 5, 6});
    addBox(scene, box);
    scene.scopes.push_back({"Box", 0, box});
    finish(scene);
    Camera camera;
    camera.eye = {0, 2.5, 30};
    camera.target = {0, 2.5, 0};
    camera.orthoHeightM = 20;
    view = View(camera, 1000, 1000, scene.bounds);
    CpuFields producer;
    producer.setScene(scene);
    producer.produce(view, fields);
    pad(fields, kHandleSpacingPx, padded);
  }
  [[nodiscard]] OtherHandleContext context() const { return {view, padded, padded, landed, scene.scopes}; }
};

/// A switch on the box's roof over frames that know of each other.
struct AtticSwitch {
  FrontOfBox stage;
  Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  Annotation outside = annotated(HandleType::kBoolean, Orient::kUp, Slip::kBillboard);
  Annotation inside = annotated(HandleType::kBoolean, Orient::kUp, Slip::kNone);
  History history{0};
  PlacedHandle placed;
  bool moves = false;   ///< the view has, since the last frame
  bool settles = false;

  std::optional<HiddenReason> place(const Annotation& annotation, bool firm, bool nearing = false) {
    const auto missing = placePill({0, parameter, annotation, stage.scopes, 1, history, firm, nearing, false, moves, settles}, stage.context(), placed);
    const Vec2 awayPx = placed.box.center() - placed.anchor;
    missing ? history.choseNone(true) : history.choose(placed.identity, -1, {awayPx, awayPx});
    moves = false;
    return missing;
  }
  /// The same in a frame of a camera that moves, which finds a place.
  PlacementKind placeMoving(const Annotation& annotation, bool firm, bool nearing = false) {
    history.age();
    moves = true;
    REQUIRE_FALSE(place(annotation, firm, nearing));
    return placed.placement;
  }
};

}  // namespace

TEST_CASE("the least shift of a box out of the model, worked out by hand") {
  const FrontOfBox stage;
  const Box2 box{{480, 380}, {520, 400}};   // 20 px high, its lower side 25 px under the model's top at 375
  CHECK(leastShiftPx(stage.fields, box, {0, -1}) == Approx(25.0).margin(0.01));
  CHECK(leastShiftPx(stage.padded, box, {0, -1}) == Approx(55.0).margin(0.01));
  CHECK(leastShiftPx(stage.fields, box, {1, 0}) == Approx(220.0).margin(0.01));
  // Aslant the way out is longer by the diagonal.
  CHECK(leastShiftPx(stage.fields, box, Vec2(1, -1) * std::sqrt(0.5)) == Approx(25.0 * std::sqrt(2.0)).margin(0.01));
  CHECK(leastShiftPx(stage.fields, {{100, 100}, {140, 120}}, {0, -1}) == 0.0);
}

TEST_CASE("a box finds its way along a model that has no end for a long stretch") {
  DistanceFields fields;
  fields.reset(4000, 400);
  for (std::size_t i = 0; i < 3000; ++i) fields[ViewportEdge::kTop].edit()[i] = 100;
  for (const ViewportEdge edge : {ViewportEdge::kLeft, ViewportEdge::kRight, ViewportEdge::kBottom}) {
    for (float& value : fields[edge].edit()) value = 0;   // no way out there but out of the viewport
  }
  fields.buildTrees();
  const Box2 box{{10, 150}, {50, 170}};
  CHECK(leastShiftPx(fields, box, {1, 0}) == Approx(2990).margin(4));   // beside its end, by whole steps
  CHECK(leastShiftPx(fields, box, {0, -1}) == Approx(70));
  CHECK(leastShiftPx(fields, box, {0, 1}) == Approx(250));   // out of the viewport, below
  CHECK(leastShiftPx(fields, box, {-1, 0}) == Approx(50));
}

TEST_CASE("a switch stands 30 px above the middle of the face its orientation names") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  const Annotation annotation = annotated(HandleType::kBoolean, Orient::kUp, Slip::kScope);
  PlacedHandle placed;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), placed));
  CHECK(placed.placement == PlacementKind::kOutside);
  CHECK(placed.anchor.x == Approx(500));
  CHECK(placed.anchor.y == Approx(375));
  CHECK(placed.box.center().x == Approx(500));
  CHECK(placed.box.max.y == Approx(345).margin(0.01));
  CHECK(placed.handles.size() == 1);
  CHECK(placed.options.empty());
}

TEST_CASE("an alignment moves a pill to the wanted side") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  Annotation annotation = annotated(HandleType::kBoolean, Orient::kUp, Slip::kScope);
  annotation.align = Align::kTopRight;
  PlacedHandle placed;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), placed));
  CHECK(placed.box.center().x > 520);
  CHECK(placed.box.max.y <= 345.01);
}

TEST_CASE("with slip none a pill stays at its anchor") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  const Annotation annotation = annotated(HandleType::kBoolean, Orient::kUp, Slip::kNone);
  PlacedHandle placed;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), placed));
  CHECK(placed.placement == PlacementKind::kInside);
  CHECK(placed.box.center() == placed.anchor);
}

TEST_CASE("a range offers its choices in a column, one for each") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Roof", .title = "Roof", .type = ParameterType::kChoice, .max = 2, .choices = {"gable", "hip", "flat"}};
  const Annotation annotation = annotated(HandleType::kRange, Orient::kUp, Slip::kScope);
  PlacedHandle placed;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), placed));
  CHECK(placed.text == "hip");
  // Outside, on the side that its orientation names, and handleSpacing from the model.
  CHECK(placed.placement == PlacementKind::kOutside);
  CHECK(placed.anchor == Vec2(500, 375));
  CHECK(placed.box.center().x == Approx(500));
  CHECK(placed.box.max.y == Approx(375 - kHandleSpacingPx).margin(0.5));
  REQUIRE(placed.options.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(placed.options[i].value == static_cast<double>(i));
    CHECK_FALSE(placed.options[i].box.overlaps(placed.box));
    CHECK(placed.options[i].box.center().x == placed.box.center().x);
  }
}

TEST_CASE("pills keep clear of what has landed") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  const Annotation annotation = annotated(HandleType::kBoolean, Orient::kUp, Slip::kScope);
  PlacedHandle first;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), first));
  stage.landed.add(first, stage.view);
  pullIn(stage.padded, first.box, kLabelClearancePx);
  PlacedHandle second;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none}, stage.context(), second));
  CHECK_FALSE(second.box.grown(kLabelClearancePx - 0.01).overlaps(first.box));
}

TEST_CASE("a pill stands between the model and a line far out, and beyond one that leaves it no room") {
  const auto standsAt = [](double lineY) {
    AtticSwitch attic;
    attic.stage.landed.add({{300, 375}, {700, 375}}, {{300, 375}, {700, 375}}, {{300, lineY}, {700, lineY}});
    pullIn(attic.stage.padded, Segment2{{300, lineY}, {700, lineY}}, kHandleSpacingPx);
    REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
    return attic.placed.box;
  };
  CHECK(standsAt(200).max.y == Approx(345).margin(0.13));   // handleSpacing above the roof at 375
  CHECK(standsAt(300).max.y < 300 - kLabelClearancePx);
}

TEST_CASE("a pill goes where its thread runs across no number, and takes a longer way to run across no line") {
  AtticSwitch free;
  REQUIRE(free.placeMoving(free.outside, true) == PlacementKind::kOutside);
  CHECK(free.placed.box.center().x == Approx(500));
  // A number just above the roof, and then a line on end: either would be under the thread of a pill straight above.
  AtticSwitch number;
  number.stage.landed.addLabel({{480, 355}, {520, 370}});
  REQUIRE(number.placeMoving(number.outside, true) == PlacementKind::kOutside);
  CHECK(number.stage.landed.across({number.placed.anchor, number.placed.box.center()}).labels == 0);
  CHECK(std::abs(number.placed.box.center().x - 500) > 20);
  AtticSwitch line;
  line.stage.landed.add({{485, 360}, {515, 360}}, {{485, 360}, {515, 360}}, {{485, 360}, {515, 360}});
  REQUIRE(line.placeMoving(line.outside, true) == PlacementKind::kOutside);
  CHECK(line.stage.landed.across({line.placed.anchor, line.placed.box.center()}).lines == 0);
}

TEST_CASE("where lines settle a pill takes a longer way to run across no other's thread, which it does not in a movement") {
  for (const bool settles : {false, true}) {
    AtticSwitch attic;
    attic.settles = settles;
    PlacedHandle other;   // its thread leads close over the roof
    other.anchor = {485, 360};
    other.box = Box2::around({620, 360}, {40, 6});
    attic.stage.landed.add(other, attic.stage.view);
    REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
    const int threads = attic.stage.landed.across({attic.placed.anchor, attic.placed.box.center()}).threads;
    CHECK(threads == (settles ? 0 : 1));
    CHECK((std::abs(attic.placed.box.center().x - 500) > 20) == settles);
  }
}

TEST_CASE("where lines settle a pill goes to a better place, unless that is better by little") {
  // In its way until then: a label above the roof, so wide that it has to stand so much further out.
  for (const double outPx : {0.5 * -kScoreChangeSettling, 2.0 * -kScoreChangeSettling}) {
    AtticSwitch attic;
    const double nearestY = 345;
    attic.stage.landed.addLabel({{0, nearestY - outPx}, {1000, 374}});
    attic.stage.landed.addLabel({{0, 0}, {299, 1000}});
    attic.stage.landed.addLabel({{701, 0}, {1000, 1000}});
    attic.stage.landed.addLabel({{0, 626}, {1000, 1000}});
    REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
    const double before = attic.placed.box.max.y;
    REQUIRE(before < nearestY - outPx);
    attic.stage.landed.clear();
    attic.settles = true;
    REQUIRE_FALSE(attic.place(attic.outside, false));
    CHECK((attic.placed.box.max.y == Approx(before).margin(0.13)) == (outPx < -kScoreChangeSettling));
    CHECK((attic.placed.box.max.y == Approx(nearestY).margin(0.13)) == (outPx > -kScoreChangeSettling));
  }
}

TEST_CASE("what a pill is worth, worked out by hand") {
  Landed landed;
  PlacedHandle pill;
  pill.anchor = {500, 400};
  pill.box = Box2::around({500, 300}, {100, kPillHeightPx});
  pill.placement = PlacementKind::kOutside;
  Annotation annotation;
  CHECK(pillWorth(pill, annotation, landed) == Approx(-100));
  annotation.align = Align::kTop;
  CHECK(pillWorth(pill, annotation, landed) == Approx(-100 + kScoreAlign));
  annotation.align = Align::kNone;
  landed.addLabel({{490, 340}, {510, 350}});
  CHECK(pillWorth(pill, annotation, landed) == Approx(-100 + kScoreThreadOverLabel));
  pill.placement = PlacementKind::kInside;
  pill.anchor = {500, 300};
  CHECK(pillWorth(pill, annotation, landed) == Approx(kScoreInside));
}

TEST_CASE("a pill goes inside rather than so far away that its thread leads across half the picture") {
  // All around the box is taken, and below it down to a height; the anchor is at 375.
  const auto placedBelow = [](double takenToY) {
    AtticSwitch attic;
    for (const Box2& taken : {Box2{{0, 0}, {1000, 374}}, Box2{{0, 374}, {299, takenToY}}, Box2{{701, 374}, {1000, takenToY}}, Box2{{299, 626}, {701, takenToY}}}) {
      attic.stage.landed.addLabel(taken);
    }
    return attic.placeMoving(attic.outside, true);
  };
  CHECK(placedBelow(375 + kLongestThreadShare * 1000 - kPillHeightPx) == PlacementKind::kOutside);
  CHECK(placedBelow(375 + kLongestThreadShare * 1000) == PlacementKind::kInside);
}

TEST_CASE("a pill stays where it was when nearer room appears, comes nearer little by little while the camera moves, and stands still to the last bit before a still one") {
  AtticSwitch attic;
  const Box2 above{{0, 300}, {1000, 374}};
  attic.stage.landed.addLabel(above);
  attic.stage.landed.addLabel({{0, 0}, {299, 1000}});
  attic.stage.landed.addLabel({{701, 0}, {1000, 1000}});
  attic.stage.landed.addLabel({{0, 626}, {1000, 1000}});
  REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
  const Box2 far = attic.placed.box;
  REQUIRE(far.max.y <= above.min.y - kLabelClearancePx);
  attic.stage.landed.clear();
  const double nearestY = 345;
  REQUIRE(nearestY - far.max.y > kLeapPx);   // it would be a leap
  REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
  CHECK(attic.placed.box.max.y - far.max.y == Approx(kRelaxPx).margin(0.13));
  CHECK(attic.placed.box.center().x == Approx(far.center().x).margin(0.13));
  for (int frame = 0; frame < 40; ++frame) {
    const Box2 last = attic.placed.box;
    REQUIRE_FALSE(attic.place(attic.outside, true));   // before a still camera
    REQUIRE(attic.placed.box.min == last.min);
    REQUIRE(attic.placed.box.max == last.max);
    attic.placeMoving(attic.outside, true);
    REQUIRE(glm::length(attic.placed.box.center() - last.center()) < kLeapPx);
  }
  CHECK(attic.placed.box.max.y == Approx(nearestY).margin(0.13));
}

TEST_CASE("a pill that had no room comes inside when a place outside comes and goes") {
  AtticSwitch attic;
  attic.history.choseNone(true);
  const Box2 outside[] = {{{0, 0}, {1000, 374}}, {{0, 0}, {299, 1000}}, {{701, 0}, {1000, 1000}}, {{0, 626}, {1000, 1000}}};
  for (int frame = 0; frame < kPatienceFrames; ++frame) {
    attic.stage.landed.clear();
    for (const Box2& box : outside) {
      if (frame % 2 == 0) attic.stage.landed.addLabel(box);
    }
    attic.history.age();
    REQUIRE(attic.place(attic.outside, true) == HiddenReason::kCrowded);
  }
  for (const Box2& box : outside) attic.stage.landed.addLabel(box);
  CHECK(attic.placeMoving(attic.outside, true) == PlacementKind::kInside);
}

TEST_CASE("inside the model a pill finds the one place near its anchor that is left free") {
  for (const double turnDeg : {22.5, 157.5, 270.0}) {
    AtticSwitch attic;
    REQUIRE_FALSE(attic.place(attic.inside, true));
    const double rad = turnDeg * kRadPerDeg;
    const Vec2 by = Vec2(std::cos(rad), std::sin(rad)) * 5.0 * kPillHeightPx;
    const Box2 free = Box2{attic.placed.box.min + by, attic.placed.box.max + by}.grown(kLabelClearancePx + 0.5);
    // Labels all around it.
    const double side = 1000;
    for (const Box2& label : {Box2{{0, 0}, {side, free.min.y}}, Box2{{0, free.max.y}, {side, side}}, Box2{{0, free.min.y}, {free.min.x, free.max.y}},
                              Box2{{free.max.x, free.min.y}, {side, free.max.y}}}) {
      attic.stage.landed.addLabel(label);
    }
    AtticSwitch other;
    other.stage.landed = attic.stage.landed;
    INFO(turnDeg);
    REQUIRE_FALSE(other.place(other.inside, true));
    CHECK(glm::length(other.placed.box.min - attic.placed.box.min - by) < 1e-6);
  }
}

TEST_CASE("a pill that had no room or was inside waits until a better kind of place has been there for a while") {
  AtticSwitch attic;
  attic.history.choseNone(true);
  for (int frame = 0; frame < kPatienceFrames; ++frame) {
    attic.history.age();
    REQUIRE(attic.place(attic.outside, true) == HiddenReason::kCrowded);
  }
  CHECK(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);

  attic.history.choseNone();                    // its feature was out of sight
  CHECK(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);

  attic.history = History(0);
  REQUIRE_FALSE(attic.place(attic.inside, true));
  CHECK(attic.placeMoving(attic.outside, true) == PlacementKind::kInside);
  REQUIRE_FALSE(attic.place(attic.outside, false));   // after an edit nothing waits
  CHECK(attic.placed.placement == PlacementKind::kOutside);
}

TEST_CASE("while the camera comes nearer a pill stays inside, however long there is a place outside") {
  AtticSwitch attic;
  attic.placeMoving(attic.inside, true);
  for (int frame = 0; frame < 3 * kPatienceFrames; ++frame) REQUIRE(attic.placeMoving(attic.outside, true, true) == PlacementKind::kInside);
  // Then it waits as ever.
  for (int frame = 0; frame < kPatienceFrames; ++frame) REQUIRE(attic.placeMoving(attic.outside, true) == PlacementKind::kInside);
  CHECK(attic.placeMoving(attic.outside, true) == PlacementKind::kOutside);
  // One that is outside stays there, and after an edit nothing waits.
  CHECK(attic.placeMoving(attic.outside, true, true) == PlacementKind::kOutside);
  attic.placeMoving(attic.inside, true);
  for (int frame = 0; frame < kReturnFrames; ++frame) attic.placeMoving(attic.inside, true);
  CHECK(attic.placeMoving(attic.outside, false, true) == PlacementKind::kOutside);
}

TEST_CASE("while the camera comes nearer a pill that loses its place outside goes inside rather than to one that will leave the viewport") {
  const auto whenTaken = [](bool nearing, std::initializer_list<Box2> taken) {
    AtticSwitch attic;
    REQUIRE(attic.placeMoving(attic.outside, true, nearing) == PlacementKind::kOutside);
    REQUIRE(attic.placed.box.max.y < 375);   // above
    for (const Box2& box : taken) attic.stage.landed.addLabel(box);
    return attic.placeMoving(attic.outside, true, nearing);
  };
  const Box2 above{{0, 0}, {1000, 340}};
  const Box2 below{{0, 626}, {1000, 1000}};
  // Beside the box it stands about 270 px from the middle, and is outside when the picture has grown twice; below it 170 px.
  CHECK(whenTaken(true, {above, below}) == PlacementKind::kInside);
  CHECK(whenTaken(false, {above, below}) == PlacementKind::kOutside);
  CHECK(whenTaken(true, {above}) == PlacementKind::kOutside);
  CHECK(whenTaken(true, {above, below, {{201, 345}, {799, 624}}}) == PlacementKind::kOutside);   // there is none inside
}

TEST_CASE("a pill does not go back to a place outside that it has just left, as long as there is one inside") {
  AtticSwitch attic;
  const auto place = [&](std::initializer_list<Box2> taken) {
    attic.stage.landed.clear();
    for (const Box2& box : taken) attic.stage.landed.addLabel(box);
    attic.placeMoving(attic.outside, true);
    return attic.placed.identity;
  };
  const auto onlyAbove = [&] { return place({{{0, 0}, {445, 374}}, {{555, 0}, {1000, 374}}, {{0, 380}, {295, 1000}}, {{705, 380}, {1000, 1000}}, {{0, 630}, {1000, 1000}}}); };
  const Identity above = place({});
  REQUIRE(attic.placed.box.max.y < 375);
  const Identity elsewhere = place({{{0, 0}, {1000, 374}}});
  REQUIRE(attic.placed.placement == PlacementKind::kOutside);
  REQUIRE(elsewhere != above);
  for (int frame = 0; frame < kReturnFrames; ++frame) {
    onlyAbove();
    INFO("frame " << frame);
    REQUIRE(attic.placed.placement == PlacementKind::kInside);
  }
  for (int frame = 0; frame < kPatienceFrames; ++frame) onlyAbove();
  CHECK(onlyAbove() == above);
}

TEST_CASE("inside the model a pill stays with its scope, though another one's is nearer to where it wants to be") {
  FrontOfBox stage;
  stage.scene.scopes.push_back({"Box", 1, boxAt({-4, -3, -3}, {8, 5, 6})});
  stage.scopes = {0, 1};
  const Parameter parameter{.name = "Attic", .title = "Attic", .type = ParameterType::kBool};
  const Annotation annotation = annotated(HandleType::kBoolean, Orient::kUp, Slip::kNone);
  History history{0};
  PlacedHandle placed;
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, history, true}, stage.context(), placed));
  CHECK(placed.scope == 0);
  history.choose(placed.identity, -1);
  // Something lands on its anchor, so there is room only beside it.
  stage.landed.addLabel(Box2{placed.anchor, placed.anchor}.grown(8));
  history.age();
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, history, true}, stage.context(), placed));
  CHECK(placed.scope == 0);
  CHECK(placed.box.center() != placed.anchor);
  REQUIRE_FALSE(placePill({0, parameter, annotation, stage.scopes, 1, stage.none, true}, stage.context(), placed));
  CHECK(placed.scope == 1);
}

TEST_CASE("an arc begins on the axis after its own and turns towards the next, about the scope's origin") {
  const Arc arc = arcAt(annotated(HandleType::kAngular, Orient::kFront, Slip::kNone), boxAt({1, 2, 3}, {4, 5, 6}), 0.5, 0.1, 100);
  CHECK(arc.center == Vec3(1, 2, 3));
  CHECK(arc.from == Vec3(1, 0, 0));
  CHECK(arc.axis == Vec3(0, 0, 1));
  CHECK(arc.radiusM == Approx(kArcRadiusShare * 4));
  const Vec3 end = arc.at(0.5) - arc.center;
  CHECK(end.x == Approx(arc.radiusM * std::cos(0.5)));
  CHECK(end.y == Approx(arc.radiusM * std::sin(0.5)));
}

TEST_CASE("an angular handle with slip none stays in its scope's frame, another moves outside") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  PlacedHandle placed;
  const Annotation still = annotated(HandleType::kAngular, Orient::kFront, Slip::kNone);
  REQUIRE_FALSE(placeArc({0, parameter, still, stage.scopes, 30, stage.none}, stage.context(), placed));
  CHECK(placed.placement == PlacementKind::kInside);
  REQUIRE(placed.arc);
  CHECK(placed.arc->center == Vec3(-4, 0, -3));
  CHECK(glm::length(placed.handles[0].screen - stage.view.toScreen(placed.arc->at(30 * 3.14159265358979 / 180))) < 1e-6);

  const Annotation moving = annotated(HandleType::kAngular, Orient::kFront, Slip::kScope);
  REQUIRE_FALSE(placeArc({0, parameter, moving, stage.scopes, 30, stage.none}, stage.context(), placed));
  CHECK(placed.placement == PlacementKind::kOutside);
  CHECK(clears(stage.padded, Box2{placed.handles[0].screen, placed.handles[0].screen}));
  CHECK(clears(stage.padded, placed.box));
}

TEST_CASE("an arc is shown as long as its centre and its end, which is dragged, are in the picture, and its text moves to stay in it") {
  FrontOfBox stage;
  const Parameter pitch{.name = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .defaultValue = 40, .min = 0, .max = 90};
  History history(0);
  const auto placedAt = [&](double targetX) {
    Camera camera;
    camera.eye = {targetX, 2.5, 30};
    camera.target = {targetX, 2.5, 0};
    camera.orthoHeightM = 20;
    stage.view = View(camera, 1000, 1000, stage.scene.bounds);
    PlacedHandle placed;
    const OtherHandle handle{0, pitch, annotated(HandleType::kAngular, Orient::kFront, Slip::kNone), stage.scopes, 40, history};
    return placeArc(handle, stage.context(), placed) ? std::nullopt : std::optional(placed);
  };
  int shown = 0;
  std::vector<View> without;
  Arc arc;   // the same one from everywhere
  std::set<double> offsets;
  // The arc's centre is the box's lower left corner, at x 300 when the picture's middle is at 0; so it leaves to the left, then its arm comes in from the right.
  for (double targetX = -15; targetX < 7; targetX += 0.1) {
    const auto placed = placedAt(targetX);
    if (!placed) {
      without.push_back(stage.view);
      continue;
    }
    ++shown;
    arc = *placed->arc;
    const Box2 picture = stage.view.viewport();
    CHECK(picture.contains(placed->box));
    CHECK(picture.contains(placed->handles.front().screen));
    const Vec2 usual = stage.view.toScreen(placed->arc->at(placed->arc->angleRad * 0.5)) - placed->box.center();
    offsets.insert(std::round(usual.x));
  }
  CHECK(shown > 150);
  CHECK(without.size() > 10);
  for (const View& view : without) CHECK_FALSE((view.viewport().contains(view.toScreen(arc.center)) && view.viewport().contains(view.toScreen(arc.at(arc.angleRad)))));
  CHECK(offsets.size() > 1);   // of the text from the arc's middle
}

TEST_CASE("where the default angle is small an arc has a greater radius, as long as it does not dwarf the model") {
  FrontOfBox stage;
  Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  const Annotation annotation = annotated(HandleType::kAngular, Orient::kFront, Slip::kNone);
  // Of a scope so small that its size does not count.
  stage.scene.scopes[0].box.size = Vec3(1e-3);
  const auto radiusPx = [&](double deg) {
    PlacedHandle placed;
    parameter.defaultValue = deg;
    REQUIRE_FALSE(placeArc({0, parameter, annotation, stage.scopes, 45, stage.none}, stage.context(), placed));
    return placed.arc->radiusM / stage.view.metresPerPixelAt(stage.scene.scopes[0].box.origin);
  };
  CHECK(radiusPx(90) == Approx(kArcMinRadiusPx));
  CHECK(radiusPx(20) * 20 * 3.14159265358979 / 180 == Approx(kArcMinLengthPx));
  CHECK(radiusPx(5) == Approx(kArcMaxRadiusPx));
  CHECK(radiusPx(0) == Approx(kArcMaxRadiusPx));
}

TEST_CASE("an arc seen nearly edge-on is shown on demand") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  const Annotation annotation = annotated(HandleType::kAngular, Orient::kRight, Slip::kNone);
  Obb& box = stage.scene.scopes[0].box;
  for (Vec3& axis : box.axes) axis = glm::rotate(glm::dmat4(1.0), 0.5 * kForeshortenedAngleRad, glm::dvec3(0, 1, 0)) * glm::dvec4(axis, 0);
  PlacedHandle placed;
  OtherHandle handle{0, parameter, annotation, stage.scopes, 30, stage.none};
  CHECK(placeArc(handle, stage.context(), placed) == HiddenReason::kForeshortened);
  handle.showAll = true;
  CHECK_FALSE(placeArc(handle, stage.context(), placed));
}

TEST_CASE("an arc moves out to the side that its annotation prefers") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  Annotation annotation = annotated(HandleType::kAngular, Orient::kFront, Slip::kScope);
  const auto outwardFor = [&](Align align) {
    annotation.align = align;
    PlacedHandle placed;
    REQUIRE_FALSE(placeArc({0, parameter, annotation, stage.scopes, 90, stage.none}, stage.context(), placed));
    REQUIRE(placed.placement == PlacementKind::kOutside);
    return stage.view.toScreen(placed.arc->center) - placed.anchor;
  };
  // Its centre is the box's lower left corner, and it opens as far to the right as upwards.
  CHECK(outwardFor(Align::kLeft).x < -1);
  CHECK(outwardFor(Align::kBottom).y > 1);
}

TEST_CASE("an arc is hidden before it looks like a straight line") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  const Annotation annotation = annotated(HandleType::kAngular, Orient::kRight, Slip::kNone);
  const auto axes = stage.scene.scopes[0].box.axes;
  const auto hiddenAt = [&](double fromEdgeRad, History& history) {
    Obb& box = stage.scene.scopes[0].box;
    for (std::size_t i = 0; i < 3; ++i) box.axes[i] = glm::rotate(glm::dmat4(1.0), fromEdgeRad, glm::dvec3(0, 1, 0)) * glm::dvec4(axes[i], 0);
    PlacedHandle placed;
    return placeArc({0, parameter, annotation, stage.scopes, 30, history}, stage.context(), placed) == HiddenReason::kForeshortened;
  };
  CHECK(hiddenAt(0.95 * kArcForeshortenedAngleRad, stage.none));
  CHECK_FALSE(hiddenAt(1.05 * kArcForeshortenedAngleRad, stage.none));

  // One that was hidden comes back a little further on, but no later: an angle that can be read has its arc.
  History hidden = stage.none;
  hidden.choseNone();
  CHECK(hiddenAt(kArcForeshortenedAngleRad + 0.01, hidden));
  CHECK_FALSE(hiddenAt(kArcForeshortenedAngleRad + 0.03, hidden));
}

TEST_CASE("an arc seen edge-on is not shown") {
  FrontOfBox stage;
  const Parameter parameter{.name = "Pitch", .title = "Pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .max = 90};
  const Annotation edgeOn = annotated(HandleType::kAngular, Orient::kRight, Slip::kNone);
  PlacedHandle placed;
  CHECK(placeArc({0, parameter, edgeOn, stage.scopes, 30, stage.none}, stage.context(), placed) == HiddenReason::kForeshortened);
}
