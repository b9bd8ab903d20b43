#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "core/power.h"

using namespace dimline;

TEST_CASE("powers of 0, powers of 1, and the power 0") {
  CHECK(power(0, 2.5) == 0);
  CHECK(power(0, 0) == 1);
  CHECK(power(7.25, 0) == 1);
  CHECK(power(1, 123.4) == 1);
}

TEST_CASE("a power is the library's to 14 digits") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> logarithm(-7, 7), exponent(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const double base = std::exp(logarithm(random)), e = exponent(random);
    const double expected = std::pow(base, e);
    CAPTURE(base, e);
    REQUIRE(std::abs(power(base, e) - expected) <= 1e-14 * expected);
  }
}

TEST_CASE("powers of bases beside 1 keep what little they differ by") {
  for (const double base : {1 - 1e-12, 1 + 1e-12, 1 + 1e-9}) CHECK(power(base, 2.4) == Approx(std::pow(base, 2.4)).epsilon(1e-15));
}

TEST_CASE("the power of ten within a value is exact, at the power itself and on either side of it") {
  for (const double power : {1e-12, 1e-9, 1e-4, 1e-3, 0.01, 0.1, 1.0, 10.0, 100.0, 1e6, 1e12}) {
    CHECK(powerOfTenWithin(power) == power);
    CHECK(powerOfTenWithin(power * 9.99) == power);
    CHECK(powerOfTenWithin(std::nextafter(power, 0.0)) < power);
  }
  CHECK(powerOfTenWithin(0) == 0);
  CHECK(std::isinf(powerOfTenWithin(std::numeric_limits<double>::infinity())));
}
