#include <catch2/catch.hpp>

#include "placement/candidates.h"
#include "placement/chains.h"
#include "placement/guides.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

Annotation widthOf(const char* scope) {
  Annotation a;
  a.scope = scope;
  a.type = HandleType::kLinearContour;
  a.orient = Orient::kRight;
  a.chained = true;
  return a;
}

/// Windows 1 by 1.5 in the plane z = 0, 0.2 deep: three columns at x = 0, 2, 5 and two rows at y = 1 and 4.
std::vector<Scope> facade() {
  std::vector<Scope> scopes;
  for (const double y : {1.0, 4.0}) {
    for (const double x : {0.0, 2.0, 5.0}) {
      scopes.push_back({"Window", static_cast<std::uint32_t>(scopes.size()), boxAt({x, y, -0.2}, {1, 1.5, 0.2})});
    }
  }
  return scopes;
}

const Cluster* findByNormal(const std::vector<Cluster>& clusters, const Vec3& normal, double offset) {
  for (const Cluster& cluster : clusters) {
    if (glm::length(cluster.plane.normal - normal) < 1e-9 &&
        std::abs(glm::dot(cluster.members[0].segment.start, normal) - offset) < 1e-9) {
      return &cluster;
    }
  }
  return nullptr;
}

}  // namespace

TEST_CASE("base lines are clustered by direction and plane") {
  const std::vector<Scope> scopes = facade();
  const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5};
  const auto clusters = clusterBaseLines(widthOf("Window"), scopes, all, 10);
  // The front and the back face of the wall, and the sills' and heads' planes of the two rows.
  CHECK(clusters.size() == 2 + 4);
  const Cluster* front = findByNormal(clusters, {0, 0, 1}, 0);
  REQUIRE(front != nullptr);
  CHECK(front->members.size() == 12);
  CHECK(front->along == Vec3(1, 0, 0));
  const Cluster* sill = findByNormal(clusters, {0, -1, 0}, -1);
  REQUIRE(sill != nullptr);
  CHECK(sill->members.size() == 6);
}

TEST_CASE("a cluster's sides are the sides of its rectangle, and its members are ordered from each") {
  const std::vector<Scope> scopes = facade();
  const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5};
  const auto clusters = clusterBaseLines(widthOf("Window"), scopes, all, 10);
  const Cluster* front = findByNormal(clusters, {0, 0, 1}, 0);
  REQUIRE(front != nullptr);
  // across is +y or -y; whichever, one side is the lowest sill (y = 1), the other the highest head (y = 5.5).
  const std::size_t low = front->plane.across.y > 0 ? 0 : 1;
  CHECK(front->sides[low].start == Vec3(0, 1, 0));
  CHECK(front->sides[low].end == Vec3(6, 1, 0));
  CHECK(front->sides[1 - low].start == Vec3(0, 5.5, 0));
  double last = 0;
  for (const std::uint32_t i : front->nearestFirst[low]) {
    const double y = front->members[i].segment.start.y;
    CHECK(y >= last);
    last = y;
  }
  for (const ChainMember& m : front->members) {
    CHECK(m.toM - m.fromM == Approx(1.0));
    CHECK(m.fromM == Approx(m.segment.start.x));
  }
}

TEST_CASE("a chain's base lines know how many of its members are hidden") {
  const std::vector<Scope> scopes = facade();
  const auto clusters = clusterBaseLines(widthOf("Window"), scopes, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, 10);
  const Cluster* front = findByNormal(clusters, {0, 0, 1}, 0);
  REQUIRE(front != nullptr);
  Camera camera;
  camera.eye = {0, 2, 30};
  camera.target = {0, 2, 0};
  const View view(camera, 1000, 1000, Bounds{{-10, 0, -10}, {10, 10, 10}});
  std::vector<char> usable(scopes.size(), 1);
  std::vector<UsableBaseLine> lines;
  gatherChainBaseLines(*front, 0, view, usable, lines);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].hiddenShare == 0);
  usable[front->members[0].scope] = 0;
  lines.clear();
  gatherChainBaseLines(*front, 0, view, usable, lines);
  const auto hidden = std::ranges::count(front->members, front->members[0].scope, &ChainMember::scope);
  CHECK(lines[1].hiddenShare == Approx(static_cast<double>(hidden) / static_cast<double>(front->members.size())));
  CHECK(lines[1].hiddenShare > 0);
}

TEST_CASE("a chain slips away from its members on either side") {
  const std::vector<Scope> scopes = facade();
  const auto clusters = clusterBaseLines(widthOf("Window"), scopes, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, 10);
  const Cluster* front = findByNormal(clusters, {0, 0, 1}, 0);
  REQUIRE(front != nullptr);
  for (const int side : {0, 1}) {
    const BaseLine line = chainBaseLine(*front, side);
    const Vec3 middle = (front->sides[0].middle() + front->sides[1].middle()) * 0.5;
    REQUIRE(line.scopePlanes.size() == 1);
    // Of the members on that side, though it slips along one of them only: the sills look down, the heads up.
    const Vec3 outward{0, line.segment.middle().y < middle.y ? -1 : 1, 0};
    REQUIRE(line.faces.size() == 2);
    CHECK(std::ranges::count(line.faces, outward) == 1);
    CHECK(std::ranges::count(line.faces, Vec3(0, 0, 1)) == 1);
    CHECK(glm::dot(line.scopePlanes[0].across, line.segment.middle() - middle) > 0);
  }
}

TEST_CASE("planes that differ by more than the tolerance are different clusters") {
  std::vector<Scope> scopes = facade();
  scopes[5].box.origin.z += 0.01;   // 1 cm of 10 m is ten times the tolerance
  const auto clusters = clusterBaseLines(widthOf("Window"), scopes, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, 10);
  const Cluster* front = findByNormal(clusters, {0, 0, 1}, 0);
  REQUIRE(front != nullptr);
  CHECK(front->members.size() == 10);
}

TEST_CASE("a cluster is found again in an edited model, whatever its number is there") {
  const std::vector<Scope> scopes = facade();
  const auto before = clusterBaseLines(widthOf("Window"), scopes, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, 10);
  // A row more, listed first, and all of it a little nearer.
  std::vector<Scope> edited;
  for (const double x : {0.0, 2.0, 5.0}) edited.push_back({"Window", static_cast<std::uint32_t>(edited.size()), boxAt({x, 7, 0}, {1, 1.5, 0.2})});
  for (Scope scope : scopes) {
    scope.box.origin.z += 0.2;
    edited.push_back(scope);
  }
  const auto after = clusterBaseLines(widthOf("Window"), edited, std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}, 10);
  REQUIRE(after.size() == before.size() + 2);
  for (const Cluster& was : before) {
    const std::int32_t number = successor(was, after);
    REQUIRE(number >= 0);
    const Cluster& is = after[static_cast<std::size_t>(number)];
    CHECK(is.plane.normal == was.plane.normal);
    // The heads and sills of a row stay those of that row; front and back have a row more.
    if (was.plane.normal.y != 0) CHECK(is.members[0].segment.start.y == was.members[0].segment.start.y);
    if (was.plane.normal.z != 0) CHECK(is.members[0].segment.start.z == Approx(was.members[0].segment.start.z + 0.2));
  }
  // Nothing is left of what runs across.
  Annotation heights = widthOf("Window");
  heights.orient = Orient::kUp;
  const auto upright = clusterBaseLines(heights, scopes, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, 10);
  CHECK(successor(upright[0], after) == -1);
  CHECK(successor(upright[0], {}) == -1);
}

TEST_CASE("stretches that touch are free, stretches that overlap are not") {
  TakenStretches taken;
  taken.add(0, 1);
  CHECK(taken.free(1, 2, 1e-6));
  taken.add(1, 2);
  CHECK_FALSE(taken.free(1.5, 3, 1e-6));
  CHECK_FALSE(taken.free(-1, 5, 1e-6));
  CHECK(taken.free(2, 3, 1e-6));
}

TEST_CASE("along the guide of a line without a length lies nothing") {
  const Plane front{{0, 0, 0}, {0, 0, 1}};
  Guides guides;
  guides.add(front, {{1, 1, 0}, {1, 1, 0}});
  CHECK_FALSE(liesOn(guides[0], front, {1, 0, 0}, 0.01));
  CHECK_FALSE(liesOn(guides[0], front, {0, 1, 0}, 0.01));
  CHECK(guides.through({{1, 1, 0}, {1, 1, 0}}, front, 0.01) == -1);
}

TEST_CASE("a guide lies on its plane and every plane through it, within the tolerance, whichever way round it runs") {
  Guides guides;
  const int number = guides.add({{0, 0, 1}, {0, 0, 1}}, {{0, 2, 1}, {3, 2, 1}});
  const Guide& guide = guides[static_cast<std::size_t>(number)];
  CHECK(liesOn(guide, {{5, 5, 1}, {0, 0, 1}}, {1, 0, 0}, 1e-3));
  CHECK(liesOn(guide, {{5, 5, 1}, {0, 0, -1}}, {-1, 0, 0}, 1e-3));
  CHECK_FALSE(liesOn(guide, {{5, 5, 1.01}, {0, 0, 1}}, {1, 0, 0}, 1e-3));
  CHECK_FALSE(liesOn(guide, {{5, 5, 1}, {0, 0, 1}}, {0, 1, 0}, 1e-3));
  CHECK_FALSE(liesOn(guide, {{5, 5, 1}, {0, 1, 0}}, {1, 0, 0}, 1e-3));
  CHECK(guide.metresAt({2, 7, 1}) == Approx(2.0));
}
