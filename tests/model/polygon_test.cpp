#include "model/polygon.h"

#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace dimline {
namespace {

std::vector<Vec2> allPoints(const Polygon& polygon) {
  std::vector<Vec2> points = polygon.outer;
  for (const Ring& hole : polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
  return points;
}

/// Area of the triangles if they are all counter-clockwise and make up the region edge by edge; -1 if not.
double triangulatedArea(const Polygon& polygon) {
  const std::vector<Vec2> points = allPoints(polygon);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double area = 0;
  for (const auto& t : triangulate(polygon)) {
    const double one = signedArea(std::vector<Vec2>{points[t[0]], points[t[1]], points[t[2]]});
    if (!(one > 0)) return -1;
    area += one;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  // Every directed edge once; those without an opposite are exactly the rings' edges.
  std::size_t border = 0;
  for (const auto& [edge, count] : edges) {
    if (count != 1) return -1;
    if (!edges.contains({edge.second, edge.first})) ++border;
  }
  std::uint32_t first = 0;
  const auto isBorder = [&](const Ring& ring) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::pair<std::uint32_t, std::uint32_t> edge(first + i, first + (i + 1) % n);
      if (!edges.contains(edge) || edges.contains({edge.second, edge.first})) return false;
    }
    first += n;
    return true;
  };
  if (!isBorder(polygon.outer) || !std::all_of(polygon.holes.begin(), polygon.holes.end(), isBorder)) return -1;
  return border == first ? area : -1;
}

TEST_CASE("a ring's area has the sign of its sense") {
  const Ring square = rectangleRing({1, 1}, {3, 4});
  CHECK(signedArea(square) == 6.0);
  CHECK(signedArea(Ring(square.rbegin(), square.rend())) == -6.0);
  CHECK(signedArea(ellipseRing({5, 5}, {2, 1}, 4)) == Approx(4.0));  // a rhombus, diagonals 4 and 2
}

TEST_CASE("orient turns the outer ring counter-clockwise and holes clockwise") {
  Polygon p{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {rectangleRing({0.2, 0.2}, {0.4, 0.4})}};
  orient(p);
  CHECK(signedArea(p.outer) == Approx(1.0));
  CHECK(signedArea(p.holes[0]) == Approx(-0.04));
}

TEST_CASE("convex, concave and pierced polygons are cut into counter-clockwise triangles that fill them") {
  CHECK(triangulatedArea({rectangleRing({0, 0}, {2, 3}), {}}) == Approx(6.0));
  CHECK(triangulatedArea({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {}}) == Approx(5.0));  // an L
  // A comb: 5 by 2 without two teeth of 1 by 1.
  CHECK(triangulatedArea(
            {{{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}}) ==
        Approx(8.0));
  // A vertex in the middle of a straight edge belongs to a triangle too.
  CHECK(triangulatedArea({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {}}) == Approx(2.0));

  Polygon ring{ellipseRing({0, 0}, {2, 2}, 40), {ellipseRing({0, 0}, {1, 1}, 40)}};
  orient(ring);
  CHECK(triangulatedArea(ring) == Approx(20 * std::sin(0.15707963267948966) * 3));  // n/2 sin(2 pi/n) (4 - 1)
}

TEST_CASE("a facade's grid of windows, all in line, is triangulated without flat triangles") {
  Polygon wall{rectangleRing({0, 0}, {20, 12}), {}};
  for (int x = 0; x < 9; ++x) {
    for (int y = 0; y < 4; ++y) wall.holes.push_back(rectangleRing({1 + 2 * x, 1 + 3 * y}, {2 + 2 * x, 2.5 + 3 * y}));
  }
  orient(wall);
  CHECK(triangulatedArea(wall) == Approx(240 - 36 * 1.5));
  CHECK(triangulate(wall).size() == 4U + 36 * 4 + 2 * 36 - 2);  // points + 2 holes - 2
}

TEST_CASE("random stars with random holes are filled exactly") {
  test::Random random(7);
  for (int round = 0; round < 300; ++round) {
    Polygon p;
    const int sides = random.whole(3, 30);
    for (int i = 0; i < sides; ++i) {
      const double angle = 6.283185307179586 * i / sides, r = random.real(4, 9);
      p.outer.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    // Holes in the cells of a grid that lies inside the star's kernel: with three sides that is a circle of radius 2
    // at least.
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        if (!random.chance(0.6) || sides < 6) continue;
        p.holes.push_back(ellipseRing({x * 1.2, y * 1.2}, {random.real(0.1, 0.55), random.real(0.1, 0.55)},
                                      random.whole(3, 12), random.real(0, 6)));
      }
    }
    orient(p);
    double area = signedArea(p.outer);
    for (const Ring& hole : p.holes) area += signedArea(hole);
    CHECK(triangulatedArea(p) == Approx(area));
  }
}

TEST_CASE("offset moves edges outwards and inwards, with mitred corners") {
  const Ring out = offset(rectangleRing({0, 0}, {4, 2}), 0.5);
  REQUIRE(out.size() == 4);
  CHECK(out[0] == Vec2(-0.5, -0.5));
  CHECK(out[2] == Vec2(4.5, 2.5));
  CHECK(signedArea(offset(rectangleRing({0, 0}, {4, 2}), -0.5)) == Approx(3.0));

  // An L shrinks at its outer corners and grows at its inner one: 5 - perimeter 12 * 0.25 + 4 * 0.25^2 (5 outer less
  // 1 inner corner).
  const Ring l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  CHECK(signedArea(offset(l, -0.25)) == Approx(2.25));
  CHECK(signedArea(offset(l, 0.25)) == Approx(8.25));
}

TEST_CASE("offset does not mind which way round a ring runs") {
  Ring square = rectangleRing({0, 0}, {4, 2});
  std::reverse(square.begin(), square.end());
  CHECK(signedArea(offset(square, 0.5)) == Approx(15.0));
}

TEST_CASE("an offset drops edges that vanish, and is empty when nothing is left") {
  // A 6 by 6 square with a corner cut off by 1: the cut has length sqrt 2 and grows by 2 (tan 22.5 deg) less per
  // metre, so it stays; the trapezium's short top of 1 vanishes when both slopes have come in by 0.5 / tan(22.5 deg)
  // = 1.207.
  const Ring trapezium{{0, 0}, {7, 0}, {4, 3}, {3, 3}};
  CHECK(offset(trapezium, -1.0).size() == 4);
  const Ring triangle = offset(trapezium, -1.25);
  CHECK(triangle.size() == 3);
  // The triangle that its long edges make has base 7, height 3.5, inradius 24.5 / (7 + 2 * 4.9497) = 1.44975.
  const double share = 1 - 1.25 / (24.5 / (7 + 2 * std::sqrt(24.5)));
  CHECK(signedArea(triangle) == Approx(12.25 * share * share));
  CHECK(offset(trapezium, -1.5).empty());
  CHECK(offset(rectangleRing({0, 0}, {4, 2}), -1).empty());
}

TEST_CASE("an offset that would fall apart is empty") {
  // Two rooms of 4 by 4 with a passage 1 wide between them.
  const Ring rooms{{0, 0},  {4, 0}, {4, 1.5}, {8, 1.5}, {8, 0}, {12, 0},
                   {12, 4}, {8, 4}, {8, 2.5}, {4, 2.5}, {4, 4}, {0, 4}};
  CHECK(!offset(rooms, -0.4).empty());
  CHECK(offset(rooms, -0.7).empty());
}

}  // namespace
}  // namespace dimline
