#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "editing/value_search.h"
#include "support/random.h"

using namespace dimline;
using dimline::test::Random;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

Parameter lengthParameter(double min, double max, double step) {
  return {.name = "L", .unit = Unit::kMetre, .defaultValue = min, .min = min, .max = max, .step = step};
}

Parameter countParameter(int min, int max) {
  return {.name = "N",
          .type = ParameterType::kInt,
          .defaultValue = static_cast<double>(min),
          .min = static_cast<double>(min),
          .max = static_cast<double>(max),
          .step = 1};
}

/// A rule without gaps, zero at the start.
Reach reachOf(const std::function<double(double)>& end, double start) {
  return [=](double value) { return std::optional(end(value) - end(start)); };
}

/// How near the nearest value on a step comes, by trying them all.
double leastMiss(const Parameter& parameter, double start, double target, const std::function<double(double)>& end) {
  double least = std::abs(target);
  const double steps = std::ceil((parameter.max - parameter.min) / parameter.step);
  for (double i = 0; i <= steps; ++i) {
    const double value = snapValue(parameter, parameter.min + i * parameter.step);
    least = std::min(least, std::abs(end(value) - end(start) - target));
  }
  return least;
}

}  // namespace

TEST_CASE("an end that moves with the value: the value follows, on its steps") {
  const Parameter parameter = lengthParameter(1, 20, 0.1);
  ValueSearch search(parameter, 8, 1, 0.001);
  const Reach reach = reachOf([](double v) { return v; }, 8);
  REQUIRE(search.find(0.5, reach) == 8.5);
  REQUIRE(search.find(-2.0, reach) == 6.0);
  REQUIRE(search.find(0.34, reach) == 8.3);
  REQUIRE(search.find(0.36, reach) == 8.4);
}

TEST_CASE("a model that grows on both sides moves the end by half") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 8, 1, 0.001);
  REQUIRE(search.find(0.5, reachOf([](double v) { return v / 2; }, 8)) == 9.0);
}

TEST_CASE("the line's other end moves against the value") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 8, -1, 0.001);
  REQUIRE(search.find(-0.5, reachOf([](double v) { return -v; }, 8)) == 8.5);
}

TEST_CASE("a count changes when the pointer is nearer to the next one's end") {
  const auto height = [](double floors) { return 3 * floors + 0.5; };
  ValueSearch search(countParameter(1, 6), 2, 3.25, 0.01);
  const Reach reach = reachOf(height, 2);
  REQUIRE(search.find(1.4, reach) == 2);
  REQUIRE(search.find(1.6, reach) == 3);
  REQUIRE(search.find(7.0, reach) == 4);
  REQUIRE(search.find(-1.6, reach) == 1);
}

TEST_CASE("the limits are reached, and not passed, however far the pointer goes") {
  // 0.3 is no whole number of steps below 1.25.
  ValueSearch search(lengthParameter(0.3, 1.25, 0.1), 0.6, 1, 0.001);
  const Reach reach = reachOf([](double v) { return v; }, 0.6);
  for (const double far : {0.65, 5.0, 1e12, kInfinity}) {
    REQUIRE(search.find(far, reach) == 1.25);
    REQUIRE(search.find(-far, reach) == 0.3);
  }
}

TEST_CASE("a target that is not a number leaves the value alone") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 8, 1, 0.001);
  REQUIRE(search.find(kNotANumber, reachOf([](double v) { return v; }, 8)) == 8);
  REQUIRE(search.evaluations() == 0);
}

TEST_CASE("a start off the steps is kept as long as the pointer is nearer to it than to a step") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 8.03, 1, 0.001);
  const Reach reach = reachOf([](double v) { return v; }, 8.03);
  REQUIRE(search.find(0.0, reach) == 8.03);
  REQUIRE(search.find(0.02, reach) == 8.03);
  REQUIRE(search.find(0.05, reach) == 8.1);
  REQUIRE(search.find(-0.02, reach) == 8.0);
}

TEST_CASE("without steps the value has no more digits than a quarter pixel needs") {
  ValueSearch search(lengthParameter(1, 20, 0), 8, 1, 0.004);  // a quarter pixel is 4 mm: values in millimetres
  REQUIRE(search.find(0.12345, reachOf([](double v) { return v; }, 8)) == 8.123);
}

TEST_CASE("a repeat that rounds gives a value of the right count") {
  // Spacing s in 10 m: round(10 / s) parts; the end of the first is at 10 / parts.
  const auto end = [](double s) { return 10.0 / std::round(10.0 / s); };
  ValueSearch search(lengthParameter(1, 5, 0.1), 2.5, 1, 0.001);
  const Reach reach = reachOf(end, 2.5);
  const double three = search.find(0.7, reach);  // 3.2: three parts of 3.33 rather than four of 2.5
  REQUIRE(end(three) == Approx(10.0 / 3));
  const double five = search.find(-0.45, reach);  // 2.05: five of 2
  REQUIRE(end(five) == Approx(2.0));
}

TEST_CASE("values at which the model has no such line are not taken") {
  const Reach reach = [](double v) { return v < 6 ? std::optional<double>(v - 4) : std::nullopt; };
  ValueSearch search(lengthParameter(1, 20, 0.1), 4, 1, 0.001);
  REQUIRE(search.find(1.0, reach) == 5.0);
  REQUIRE(search.find(10.0, reach) < 6.0);
  REQUIRE(search.find(10.0, reach) > 4.0);
  REQUIRE(search.find(-10.0, reach) == 1.0);
}

TEST_CASE("a rule that never gives a line leaves the value alone") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 4, 1, 0.001);
  REQUIRE(search.find(3.0, [](double) { return std::optional<double>(); }) == 4);
}

TEST_CASE("a rule that gives no numbers leaves the value alone") {
  ValueSearch search(lengthParameter(1, 20, 0.1), 4, 1, 0.001);
  REQUIRE(search.find(3.0, [](double) { return std::optional(kNotANumber); }) == 4);
}

TEST_CASE("a range of one value has nothing to search") {
  ValueSearch search(lengthParameter(4, 4, 0.1), 4, 1, 0.001);
  REQUIRE(search.find(3.0, reachOf([](double v) { return v; }, 4)) == 4);
}

TEST_CASE("the nearest step is found for random rules that rise or fall, as by trying them all") {
  Random random(7);
  for (int round = 0; round < 400; ++round) {
    Parameter parameter = lengthParameter(random.real(-5, 2), 0, random.scaled(0.01, 1));
    parameter.max = parameter.min + random.scaled(0.5, 30);
    const double start = clampValue(parameter, random.real(parameter.min, parameter.max));
    const double sign = random.chance(0.5) ? 1 : -1;
    const double slope = random.scaled(0.05, 20);
    const double bend = random.real(0, 0.5);
    const double stair = random.chance(0.5) ? random.scaled(0.05, 3) : 0;
    const auto end = [=](double v) {
      const double x = v + bend * std::sin(v);  // steep and flat in turns, always rising
      return sign * slope * (stair > 0 ? stair * std::floor(x / stair) : x);
    };
    const double tolerance = 1e-4 * slope;
    ValueSearch search(parameter, start, sign, tolerance);
    for (int i = 0; i < 6; ++i) {
      const double target = random.real(-1.2, 1.2) * slope * (parameter.max - parameter.min);
      const double value = search.find(target, reachOf(end, start));
      const double miss = std::abs(end(value) - end(start) - target);
      INFO("round " << round << ", target " << target << ", value " << value);
      REQUIRE(miss <= leastMiss(parameter, start, target, end) + 1.02 * tolerance);
      REQUIRE(value == clampValue(parameter, value));
    }
  }
}

TEST_CASE("the value depends on the target alone, not on the way there") {
  Random random(11);
  // Falls at times: the answer may not be the best one, but it is always the same one.
  const auto end = [](double v) { return v + 2.0 * std::sin(3.0 * v); };
  const Parameter parameter = lengthParameter(0, 10, 0.05);
  const Reach reach = reachOf(end, 5);
  ValueSearch wandering(parameter, 5, 1, 0.001);
  for (int i = 0; i < 300; ++i) {
    const double target = random.real(-6, 6);
    ValueSearch direct(parameter, 5, 1, 0.001);
    REQUIRE(wandering.find(target, reach) == direct.find(target, reach));
  }
  REQUIRE(wandering.find(0.0, reach) == 5);
}

TEST_CASE("few tries are enough") {
  ValueSearch straight(lengthParameter(1, 20, 0.05), 8, 1, 0.002);
  const Reach half = reachOf([](double v) { return v / 2; }, 8);
  const int moves = 50;
  for (int i = 1; i <= moves; ++i) (void)straight.find(0.037 * i, half);
  // One for the slope, then the value and its neighbour; many of them known from the move before.
  REQUIRE(straight.evaluations() <= 1 + 2 * moves);

  ValueSearch curved(lengthParameter(1, 400, 1), 100, 0.05, 0.002);
  const Reach root = reachOf([](double v) { return std::sqrt(v); }, 100);
  (void)curved.find(6.0, root);
  REQUIRE(curved.evaluations() <= 8);
}
