#include <catch2/catch.hpp>

#include <random>

#include "math/hull.h"

using namespace dimline;

TEST_CASE("the hull of a square with points inside and on its sides is the square, counter-clockwise from its least corner") {
  const std::vector<Vec2> points{{2, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {0, 0}, {0, 1}};
  CHECK(convexHull(points, 1e-9) == std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST_CASE("a point that is none does not keep the hull from coming to an end") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(convexHull(std::vector<Vec2>{{nan, 0}, {0, nan}, {1, 1}, {nan, nan}}, 1e-9).size() <= 8);
}

TEST_CASE("points on a line have no area, and no points no hull") {
  CHECK(convexHull(std::vector<Vec2>{{0, 0}, {1, 1}, {3, 3}}, 1e-9).size() == 2);
  CHECK(convexHull(std::vector<Vec2>{{1, 2}, {1, 2}}, 1e-9) == std::vector<Vec2>{{1, 2}});
  CHECK(convexHull({}, 1e-9).empty());
}

TEST_CASE("a corner that stands out by less than the tolerance is left out") {
  const std::vector<Vec2> points{{0, 0}, {5, -0.001}, {10, 0}, {10, 10}, {0, 10}};
  CHECK(convexHull(points, 0.01).size() == 4);
  CHECK(convexHull(points, 0.0001).size() == 5);
}

TEST_CASE("every point lies inside the hull, and the hull turns left at each corner") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) points.emplace_back(coordinate(random), coordinate(random));
    const std::vector<Vec2> hull = convexHull(points, 1e-9);
    REQUIRE(hull.size() >= 3);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 a = hull[i];
      const Vec2 d = hull[(i + 1) % hull.size()] - a;
      for (const Vec2& p : points) CHECK(d.x * (p.y - a.y) - d.y * (p.x - a.x) >= -1e-6);
    }
  }
}
