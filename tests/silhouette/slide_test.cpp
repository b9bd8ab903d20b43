#include "silhouette/slide.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "silhouette/gap.h"
#include "support/random.h"

namespace dimline {
namespace {

using test::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

View orthographicView(double heightM, double widthPx, double heightPx) {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = heightM;
  Bounds bounds;
  bounds.add({-5, -5, -5});
  bounds.add({5, 5, 5});
  return {camera, widthPx, heightPx, bounds};
}

Vec2 across2(const Slide& slide, const View& view, double u, double tM) {
  const Segment line = slide.at(tM);
  return view.toScreen(line.start + (line.end - line.start) * u);
}

// --- By hand
// ----------------------------------------------------------------------------------------------------------

// 10 m over 100 px, seen from the front: 10 px a metre, the origin in the middle at (50, 50). The base line runs from
// (40, 50) to (60, 50) and slides up the screen.
struct FrontView {
  View view = orthographicView(10, 100, 100);
  Segment base{{-1, 0, 0}, {1, 0, 0}};
  Slide up = *Slide::make(view, base, {0, 1, 0});
  DistanceFields fields;
  FrontView() { fields.reset(100, 100); }
  void build() { fields.buildTrees(); }
};

TEST_CASE("the forms of a slide undo its projection, by hand") {
  const FrontView f;
  const Vec3 q(55, 30, 1);  // 0.5 m to the right, 2 m up
  const double w = glm::dot(f.up.wForm(), q);
  REQUIRE(w == Approx(1));
  REQUIRE(glm::dot(f.up.uForm(), q) / w == Approx(0.75));
  REQUIRE(glm::dot(f.up.tForm(), q) / w == Approx(2));
  const Vec3 back = f.up.originPixel() + f.up.pixelPerU() * 0.75 + f.up.pixelPerT() * 2.0;
  REQUIRE(back.x / back.z == Approx(55));
  REQUIRE(back.y / back.z == Approx(30));
}

TEST_CASE("an empty field is clear at once") {
  FrontView f;
  f.build();
  for (const ViewportEdge edge : kViewportEdges)
    REQUIRE(leastClearingOffset(f.fields[edge], edge, f.fields, f.up) == 0);
  REQUIRE(leastClearingOffset(f.fields, f.up) == 0);
}

TEST_CASE("from the top, a block above the line decides, and only between the extension lines") {
  FrontView f;
  DistanceField& top = f.fields[ViewportEdge::kTop];
  top.edit()[50] = 20;  // 30 px above the line
  top.edit()[70] = 5;   // beside the wedge
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == Approx(3));
  top.edit()[60] = 10;  // begins where the wedge ends: they touch
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == Approx(4));
  top.edit()[60] = kNoSilhouette;
  top.edit()[61] = 10;
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == Approx(3));
}

TEST_CASE("from the side, the far side of the last strip that reaches into the wedge decides") {
  FrontView f;
  DistanceField& left = f.fields[ViewportEdge::kLeft];
  for (std::size_t row = 25; row < 80; ++row) left.edit()[row] = 55;
  left.edit()[20] = 60.5F;  // right of the wedge
  f.build();
  REQUIRE(leastClearingOffset(left, ViewportEdge::kLeft, f.fields, f.up) == Approx(2.5));  // row 25 ends at y = 25
  DistanceField& right = f.fields[ViewportEdge::kRight];
  right.edit()[10] = 59;  // blocked up to x = 41
  f.build();
  REQUIRE(leastClearingOffset(right, ViewportEdge::kRight, f.fields, f.up) == Approx(4));
  right.edit()[10] = 60.5F;  // blocked up to x = 39.5
  f.build();
  REQUIRE(leastClearingOffset(right, ViewportEdge::kRight, f.fields, f.up) == 0);
}

TEST_CASE("the least over the four fields counts") {
  FrontView f;
  f.fields[ViewportEdge::kTop].edit()[50] = 20;     // 3 m
  f.fields[ViewportEdge::kLeft].edit()[30] = 45;    // row 30 ends at y = 30: 2 m
  f.fields[ViewportEdge::kRight].edit()[5] = 20;    // 4.5 m
  f.fields[ViewportEdge::kBottom].edit()[45] = 10;  // blocks all above y = 90: 5 m
  f.build();
  REQUIRE(leastClearingOffset(f.fields, f.up) == Approx(2));
  f.fields[ViewportEdge::kLeft].edit()[30] = 0;  // touches the left edge, beside the wedge
  f.build();
  REQUIRE(leastClearingOffset(f.fields, f.up) == Approx(2));
}

TEST_CASE("a field that touches its edge inside the wedge gives no place") {
  FrontView f;
  DistanceField& top = f.fields[ViewportEdge::kTop];
  top.edit()[50] = 0;
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == kInfinity);
  top.edit()[50] = -3;
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == kInfinity);
  top.edit()[50] = 0.5F;
  f.build();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, f.fields, f.up) == Approx(4.95));
}

TEST_CASE("a plane that is blocked as far as its horizon gives no place") {
  Camera camera;
  camera.eye = {0, 2, 0};
  camera.target = {0, 2, -10};
  camera.fovRad = 1.5707963267948966;
  Bounds bounds;
  bounds.add({-5, 0, -20});
  bounds.add({5, 3, -2});
  const View view(camera, 100, 100, bounds);
  // On the ground, sliding away from the viewer: the horizon is at y = 50.
  const Slide away = *Slide::make(view, {{-1, 0, -4}, {1, 0, -4}}, {0, 0, -1});
  DistanceFields fields;
  fields.reset(100, 100);
  DistanceField& top = fields[ViewportEdge::kTop];
  std::fill(top.edit().begin(), top.edit().end(), 60.0F);
  top.buildTree();
  // y = 60: 0.2 below the view axis at depth 1, so 10 m away, where the base line is 4 m away.
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, fields, away) == Approx(6));
  std::fill(top.edit().begin(), top.edit().end(), 50.0F);
  top.buildTree();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, fields, away) == kInfinity);
  std::fill(top.edit().begin(), top.edit().end(), 40.0F);
  top.buildTree();
  REQUIRE(leastClearingOffset(top, ViewportEdge::kTop, fields, away) == kInfinity);
}

TEST_CASE("between two blocks a line has a gap, seen from one of the viewport edges beside its way") {
  FrontView f;
  const auto block = [&](ViewportEdge edge, std::size_t first, std::size_t end, float value) {
    for (std::size_t row = first; row < end; ++row) f.fields[edge].edit()[row] = value;
  };
  // Blocked from both sides from the upper viewport edge to y = 11, and from y = 25 on.
  for (const ViewportEdge edge : {ViewportEdge::kLeft, ViewportEdge::kRight}) {
    block(edge, 0, 11, 30);
    block(edge, 25, 80, 30);
  }
  f.build();
  const auto gap = nearestGap(f.fields, f.up, 0, 5);
  REQUIRE(gap);
  CHECK(gap->fromM == Approx(2.5).margin(0.01));
  CHECK(gap->toM <= 3.9);
  CHECK(gap->toM > 3.5);
  SECTION("it begins at the same offset for who may not go so far") {
    const auto nearer = nearestGap(f.fields, f.up, 0, 3.7);
    REQUIRE(nearer);
    CHECK(nearer->fromM == gap->fromM);
    CHECK(nearer->toM <= 3.7);
    CHECK_FALSE(nearestGap(f.fields, f.up, 0, 2.7));
  }
  SECTION("or at the least offset that is asked for") {
    const auto further = nearestGap(f.fields, f.up, 2.75, 5);
    REQUIRE(further);
    CHECK(further->fromM == 2.75);
    CHECK_FALSE(nearestGap(f.fields, f.up, 3.8, 5));
  }
  SECTION("one edge is enough, the two that the line comes from and goes to are not asked") {
    block(ViewportEdge::kLeft, 0, 80, 30);
    f.build();
    const auto fromTheRight = nearestGap(f.fields, f.up, 0, 5);
    REQUIRE(fromTheRight);
    CHECK(fromTheRight->fromM == gap->fromM);
    block(ViewportEdge::kRight, 0, 80, 30);
    f.build();
    CHECK_FALSE(nearestGap(f.fields, f.up, 0, 5));
  }
  SECTION("narrow ones are passed by") {
    for (const ViewportEdge edge : {ViewportEdge::kLeft, ViewportEdge::kRight}) block(edge, 18, 25, 30);
    f.build();
    CHECK_FALSE(nearestGap(f.fields, f.up, 0, 5));
  }
  SECTION("what may go on without end is looked for nowhere") { CHECK_FALSE(nearestGap(f.fields, f.up, 0, kInfinity)); }
}

TEST_CASE("a gap on a floor that runs away from the viewer lies where it is clear") {
  Camera camera;
  camera.eye = {0, 2, 0};
  camera.target = {0, 1, -10};
  Bounds bounds;
  bounds.add({-50, 0, -100});
  bounds.add({50, 5, -1});
  const View view(camera, 400, 400, bounds);
  const auto away = Slide::make(view, {{-1, 0, -6}, {1, 0, -6}}, {0, 0, -1});
  REQUIRE(away);
  DistanceFields fields;
  fields.reset(400, 400);
  for (const ViewportEdge edge : {ViewportEdge::kLeft, ViewportEdge::kRight}) {
    for (std::size_t row = 0; row < 400; ++row) fields[edge].edit()[row] = row >= 190 && row < 210 ? kNoSilhouette : 50;
  }
  fields.buildTrees();
  REQUIRE(view.toScreen({0, 0, -6}).y > 210);
  REQUIRE(view.toScreen({0, 0, -90}).y < 190);
  const auto gap = nearestGap(fields, *away, 0, 84);
  REQUIRE(gap);
  CHECK(view.toScreen(away->at(gap->fromM).middle()).y == Approx(210).margin(0.2));
  const double endY = view.toScreen(away->at(gap->toM).middle()).y;
  CHECK(endY >= 190);
  CHECK(endY < 194);
  // Towards the viewer it never gets past him, however far it may go.
  const auto nearer = Slide::make(view, {{-1, 0, -6}, {1, 0, -6}}, {0, 0, 1});
  REQUIRE(nearer);
  CHECK_FALSE(nearestGap(fields, *nearer, 0, 1000));
}

TEST_CASE("what cannot slide is none") {
  const View view = orthographicView(10, 100, 100);
  const Segment base{{-1, 0, 0}, {1, 0, 0}};
  REQUIRE(Slide::make(view, base, {0, 1, 0}));
  REQUIRE_FALSE(Slide::make(view, base, {1, 0, 0}));  // parallel
  REQUIRE_FALSE(Slide::make(view, base, {0, 0, 1}));  // edge-on
  REQUIRE_FALSE(
      Slide::make(view, {{0, 0, 0}, {0, 0, 1}}, {1, 0, 0}));  // edge-on as well: the line points at the viewer
  REQUIRE_FALSE(Slide::make(view, {{1, 0, 0}, {1, 0, 0}}, {0, 1, 0}));  // no length
  Camera camera;
  camera.eye = {0, 0, 3};
  camera.target = {0, 0, 0};
  Bounds bounds;
  bounds.add({-1, -1, -1});
  bounds.add({1, 1, 5});
  const View inside(camera, 100, 100, bounds);
  REQUIRE(Slide::make(inside, base, {0, 1, 0}));
  REQUIRE_FALSE(Slide::make(inside, {{-1, 0, 0}, {1, 0, 3.5}}, {0, 1, 0}));  // one end behind the viewer
}

// --- Against brute force
// ----------------------------------------------------------------------------------------------

/// A plain polygon on screen, cut by lines, one at a time.
std::vector<Vec2> cutByForm(const std::vector<Vec2>& polygon, const Vec3& form) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const double atA = glm::dot(form, Vec3(a, 1));
    const double atB = glm::dot(form, Vec3(b, 1));
    if (atA >= 0) kept.push_back(a);
    if ((atA < 0) != (atB < 0)) kept.push_back(a + (b - a) * (atA / (atA - atB)));
  }
  return kept;
}

struct Case {
  View view;
  Slide slide;
  DistanceFields fields;
};

/// The corners of what strip i of a field blocks.
std::vector<Vec2> blockedBox(const DistanceFields& fields, ViewportEdge edge, std::size_t strip) {
  const double value = std::max(0.0F, fields[edge].at(strip));
  const double low = static_cast<double>(strip);
  const double w = fields.widthPx;
  const double h = fields.heightPx;
  switch (edge) {
    case ViewportEdge::kLeft:
      return {{value, low}, {w, low}, {w, low + 1}, {value, low + 1}};
    case ViewportEdge::kRight:
      return {{0, low}, {w - value, low}, {w - value, low + 1}, {0, low + 1}};
    case ViewportEdge::kTop:
      return {{low, value}, {low + 1, value}, {low + 1, h}, {low, h}};
    case ViewportEdge::kBottom:
      return {{low, 0}, {low + 1, 0}, {low + 1, h - value}, {low, h - value}};
  }
  return {};
}

/// The wedge on screen is cut out of each strip's blocked box; the greatest offset over what is left is read off the
/// intersection of the vertex's ray with the plane, in the world: no homography.
double bruteForce(const Case& c, ViewportEdge edge) {
  const Segment& base = c.slide.base();
  const Vec3 normal = glm::normalize(glm::cross(base.end - base.start, c.slide.across()));
  const Vec3 horizontal = glm::normalize(base.end - base.start);
  const double slant = glm::dot(c.slide.across(), horizontal);
  const Vec3 uphill = glm::normalize(c.slide.across() - horizontal * slant);
  const double rise = glm::dot(c.slide.across(), uphill);
  double greatest = 0;
  for (std::size_t strip = 0; strip < c.fields[edge].size(); ++strip) {
    const double value = c.fields[edge].at(strip);
    if (!(value < c.fields.extentPx(edge))) continue;
    std::vector<Vec2> polygon = blockedBox(c.fields, edge, strip);
    for (const Vec3& form : {c.slide.uForm(), c.slide.wForm() - c.slide.uForm(), c.slide.tForm()})
      polygon = cutByForm(polygon, form);
    for (const Vec2& p : polygon) {
      const bool onEdge =
          (edge == ViewportEdge::kLeft && p.x <= 0) || (edge == ViewportEdge::kRight && p.x >= c.fields.widthPx) ||
          (edge == ViewportEdge::kTop && p.y <= 0) || (edge == ViewportEdge::kBottom && p.y >= c.fields.heightPx);
      if (onEdge && value <= 0) return kInfinity;
      const View::Ray ray = c.view.rayThrough(p);
      const double towards = glm::dot(ray.direction, normal);
      const double along = glm::dot(base.start - ray.origin, normal) / towards;
      if (!(std::isfinite(along)) || (along < 0 && !c.view.orthographic())) return kInfinity;
      const Vec3 hit = ray.origin + ray.direction * along;
      greatest = std::max(greatest, glm::dot(hit - base.start, uphill) / rise);
    }
  }
  return greatest;
}

void fillRandom(DistanceField& field, double extentPx, Random& random) {
  const std::span<float> values = field.edit();
  const double level = random.real(0.02, 0.45) * extentPx;
  const auto first = static_cast<std::size_t>(random.real(0, 0.4) * static_cast<double>(values.size()));
  const auto last = static_cast<std::size_t>(random.real(0.6, 1) * static_cast<double>(values.size()));
  double value = level;
  const double roughness = random.scaled(0.05, 20);
  for (std::size_t i = first; i < last; ++i) {
    if (random.chance(0.01)) value = level * random.real(0.3, 1.7);
    value =
        std::clamp(value + random.real(-roughness, roughness), random.chance(0.001) ? 0.0 : 0.01 * extentPx, extentPx);
    values[i] = random.chance(0.01) ? kNoSilhouette : static_cast<float>(value);
  }
}

/// A random camera, plane, base line near the middle of the picture and fields around it; nothing where these make no
/// slide.
std::optional<Case> randomCase(Random& random) {
  Camera camera;
  const double sizeM = random.scaled(0.1, 1000);
  camera.target = random.point(Vec3(-sizeM), Vec3(sizeM));
  camera.fovRad = random.scaled(0.2, 100) * 0.017453292519943295;
  const bool orthographic = random.chance(0.25);
  const double distance =
      orthographic ? sizeM * random.real(1, 10) : sizeM / std::tan(camera.fovRad / 2) * random.real(0.6, 3);
  camera.eye = camera.target + random.direction() * distance;
  if (orthographic) camera.orthoHeightM = sizeM * random.real(1, 4);
  Bounds bounds;
  bounds.add(camera.target - sizeM);
  bounds.add(camera.target + sizeM);
  const int width = random.whole(300, random.chance(0.1) ? 3840 : 1200);
  const int height = random.whole(200, random.chance(0.1) ? 2160 : 1000);
  const View view(camera, width, height, bounds);
  const Vec3 start = camera.target + random.direction() * (sizeM * random.real(0, 0.5));
  const Segment base{start, start + random.direction() * (sizeM * random.scaled(0.02, 0.8))};
  Vec3 across = random.direction();
  if (random.chance(0.7)) {
    across = across - (base.end - base.start) * (glm::dot(across, base.end - base.start) /
                                                 glm::dot(base.end - base.start, base.end - base.start));
    across = glm::normalize(across);
  }
  const Vec3 normal = glm::cross(base.end - base.start, across);
  if (std::abs(glm::dot(normal, view.directionTo(base.middle()))) < 0.03 * glm::length(normal)) return std::nullopt;
  const std::optional<Slide> slide = Slide::make(view, base, across);
  if (!slide) return std::nullopt;
  Case made{view, *slide, {}};
  made.fields.reset(width, height);
  for (const ViewportEdge edge : kViewportEdges) fillRandom(made.fields[edge], made.fields.extentPx(edge), random);
  made.fields.buildTrees();
  return made;
}

/// How far apart two offsets are on screen: the line's ends at both.
double apartPx(const Case& c, double tA, double tB) {
  if (tA == tB) return 0;
  if (std::isinf(tA) || std::isinf(tB)) return kInfinity;
  double apart = 0;
  for (const double u : {0.0, 1.0})
    apart = std::max(apart, glm::length(across2(c.slide, c.view, u, tA) - across2(c.slide, c.view, u, tB)));
  return apart;
}

bool nearlyUnreachable(const Case& c, double tM) {
  // So far off that a hair on screen is a world away: infinite for one method and huge for another.
  if (std::isinf(tM)) return true;
  const Segment line = c.slide.at(tM);
  for (const Vec3& p : {line.start, line.end}) {
    const double depth = c.view.depth(p);
    if (!c.view.orthographic() && (depth <= 0 || depth > 1e5 * c.view.depth(c.slide.base().start))) return true;
    const Vec2 q = c.view.toScreen(p);
    if (!(glm::length(q) < 1e6)) return true;
  }
  return false;
}

TEST_CASE("the tree query equals a scan over all strips, to within 0.1 px on screen") {
  Random random(11);
  int cases = 0;
  int finite = 0;
  int infinite = 0;
  while (cases < 2500) {
    const std::optional<Case> c = randomCase(random);
    if (!c) continue;
    ++cases;
    double least = kInfinity;
    for (const ViewportEdge edge : kViewportEdges) {
      const double expected = bruteForce(*c, edge);
      const double got = leastClearingOffset(c->fields[edge], edge, c->fields, c->slide);
      least = std::min(least, got);
      INFO("case " << cases << " edge " << static_cast<int>(edge) << " expected " << expected << " got " << got);
      if (!(nearlyUnreachable(*c, expected) && nearlyUnreachable(*c, got))) REQUIRE(apartPx(*c, expected, got) < 0.1);
      finite += std::isfinite(got) && got > 0 ? 1 : 0;
      infinite += std::isinf(got) ? 1 : 0;
    }
    const double all = leastClearingOffset(c->fields, c->slide);
    REQUIRE((all == least || (std::isfinite(all) && all == Approx(least).epsilon(1e-9))));
  }
  REQUIRE(finite > 2500);
  REQUIRE(infinite > 50);
}

TEST_CASE("a bound on useful offsets changes no useful answer") {
  Random random(12);
  int useless = 0;
  for (int round = 0; round < 1500; ++round) {
    const std::optional<Case> c = randomCase(random);
    if (!c) continue;
    for (const ViewportEdge edge : kViewportEdges) {
      const double truth = leastClearingOffset(c->fields[edge], edge, c->fields, c->slide);
      const double bound = std::isinf(truth) ? 1.0 : truth * random.real(0.5, 1.5);
      const double bounded = leastClearingOffset(c->fields[edge], edge, c->fields, c->slide, bound);
      if (truth <= bound) {
        REQUIRE(bounded == truth);
      } else {
        REQUIRE(bounded > bound);
        ++useless;
      }
    }
  }
  REQUIRE(useless > 500);
}

/// Whether a field blocks a point of the viewport by more than a margin (px).
bool blocks(const DistanceFields& fields, ViewportEdge edge, const Vec2& p, double marginPx) {
  if (p.x < 0 || p.y < 0 || p.x >= fields.widthPx || p.y >= fields.heightPx) return false;
  const bool rows = edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight;
  const double value = fields[edge].at(static_cast<std::size_t>(rows ? p.y : p.x)) + marginPx;
  switch (edge) {
    case ViewportEdge::kLeft:
      return p.x > value;
    case ViewportEdge::kRight:
      return p.x < fields.widthPx - value;
    case ViewportEdge::kTop:
      return p.y > value;
    case ViewportEdge::kBottom:
      return p.y < fields.heightPx - value;
  }
  return false;
}

TEST_CASE("from the offset on the line clears the field, and just before it does not") {
  Random random(13);
  int tested = 0;
  while (tested < 800) {
    const std::optional<Case> c = randomCase(random);
    if (!c) continue;
    for (const ViewportEdge edge : kViewportEdges) {
      const double offset = leastClearingOffset(c->fields[edge], edge, c->fields, c->slide);
      if (std::isinf(offset) || nearlyUnreachable(*c, offset)) continue;
      ++tested;
      const double metresPerPx = c->view.metresPerPixelAt(c->slide.at(offset).middle());
      INFO("case " << tested << " edge " << static_cast<int>(edge) << " offset " << offset);
      // From the offset on, out to as far as four viewports: no point of the line is blocked by more than rounding.
      bool clear = true;
      for (int step = 0; step <= 40; ++step) {
        const double t = offset + metresPerPx * c->view.heightPx() * 0.1 * step;
        const Segment line = c->slide.at(t);
        if (c->view.depth(line.start) <= c->view.nearM() || c->view.depth(line.end) <= c->view.nearM()) break;
        for (int i = 0; i <= 300; ++i) {
          const Vec2 q = across2(c->slide, c->view, i / 300.0, t);
          clear = clear && !(blocks(c->fields, edge, q, 1e-3) && blocks(c->fields, edge, q + 1e-3, 1e-3) &&
                             blocks(c->fields, edge, q - 1e-3, 1e-3));
        }
      }
      REQUIRE(clear);
      if (offset == 0) continue;
      // Just before: some point of the line is in a blocked strip.
      const double before = offset - std::min(offset, 1e-3 * metresPerPx);
      bool blocked = false;
      const double lengthPx =
          glm::length(across2(c->slide, c->view, 0, before) - across2(c->slide, c->view, 1, before));
      const int samples = 200 + static_cast<int>(std::min(lengthPx, 4000.0) * 50);
      for (int i = 0; i <= samples && !blocked; ++i) {
        const Vec2 q = across2(c->slide, c->view, static_cast<double>(i) / samples, before);
        for (const Vec2& shift : {Vec2(0.0), Vec2(0, 0.03), Vec2(0, -0.03), Vec2(0.03, 0), Vec2(-0.03, 0)}) {
          blocked = blocked || blocks(c->fields, edge, q + shift, -0.03);
        }
      }
      REQUIRE(blocked);
    }
  }
}

TEST_CASE("a base line the other way round has the same answer, and scaling everything scales it") {
  Random random(14);
  int tested = 0;
  for (int round = 0; round < 800; ++round) {
    const std::optional<Case> c = randomCase(random);
    if (!c) continue;
    const double truth = leastClearingOffset(c->fields, c->slide);
    if (nearlyUnreachable(*c, truth)) continue;
    ++tested;
    // The base line the other way round.
    const Segment& base = c->slide.base();
    const std::optional<Slide> turned = Slide::make(c->view, {base.end, base.start}, c->slide.across());
    REQUIRE(turned);
    REQUIRE(apartPx(*c, leastClearingOffset(c->fields, *turned), truth) < 0.01);
    // All of the world a thousand times as large.
    Camera camera = c->view.camera();
    camera.eye *= 1000.0;
    camera.target *= 1000.0;
    if (camera.orthoHeightM) *camera.orthoHeightM *= 1000.0;
    Bounds bounds;
    bounds.add(base.start * 1000.0);
    bounds.add(base.end * 1000.0);
    const View large(camera, c->view.widthPx(), c->view.heightPx(), bounds);
    const std::optional<Slide> scaled = Slide::make(large, {base.start * 1000.0, base.end * 1000.0}, c->slide.across());
    REQUIRE(scaled);
    REQUIRE(apartPx(*c, leastClearingOffset(c->fields, *scaled) / 1000, truth) < 0.01);
  }
  REQUIRE(tested > 200);
}

}  // namespace
}  // namespace dimline
