#include "core/power.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace dimline {

namespace {

// Of the bits of a double.
constexpr int kExponentShift = 52;
constexpr std::int64_t kExponentBias = 1023;

/// Even and odd powers apart, because two short chains of multiplications take less time than a long one.
template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x) {
  double even = 0, odd = 0;
  for (std::size_t i = N; i-- > 0;) {
    double& sum = i % 2 == 0 ? even : odd;
    sum = sum * (x * x) + coefficients[i];
  }
  return even + x * odd;
}

/// ln x = e ln 2 + 2 artanh s, where x = m 2^e with m between the root of a half and that of two, and s = (m - 1) / (m + 1) is at most 0.172.
double logarithm(double x) {
  constexpr std::array kOddReciprocals{1.0, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t exponent = (bits - std::bit_cast<std::int64_t>(std::numbers::sqrt2 / 2)) >> kExponentShift;
  const auto m = std::bit_cast<double>(bits - (exponent << kExponentShift));
  const double s = (m - 1) / (m + 1);
  return static_cast<double>(exponent) * std::numbers::ln2 + 2 * s * polynomial(kOddReciprocals, s * s);
}

constexpr auto kReciprocalFactorials = [] {
  std::array<double, 14> reciprocals{1.0};
  double factorial = 1;
  for (std::size_t i = 1; i < reciprocals.size(); ++i) reciprocals[i] = 1 / (factorial *= static_cast<double>(i));
  return reciprocals;
}();

/// e^x = 2^n e^r with r within half of ln 2; ln 2 in two parts, of which n times the first is exact.
double exponential(double x) {
  constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
  if (!(std::abs(x) < 700)) return x > 0 ? std::numeric_limits<double>::infinity() : 0;
  const auto n = static_cast<std::int64_t>(x / std::numbers::ln2 + (x < 0 ? -0.5 : 0.5));
  const double r = (x - static_cast<double>(n) * kLn2High) - static_cast<double>(n) * kLn2Low;
  return polynomial(kReciprocalFactorials, r) * std::bit_cast<double>((n + kExponentBias) << kExponentShift);
}

}  // namespace

double power(double base, double exponent) {
  assert(base >= 0);
  if (exponent == 0 || base == 1) return 1;
  return base > 0 ? exponential(exponent * logarithm(base)) : 0;
}

double powerOfTenWithin(double value) {
  assert(value >= 0);
  if (value == 0 || std::isinf(value)) return value;
  // Powers up to 10^22 are exact, and 1 by one of them is the nearest number to the negative power.
  double power = 1;
  if (value >= 1) {
    while (power * 10 <= value) power *= 10;
    return power;
  }
  while (1 / power > value) power *= 10;
  return 1 / power;
}

}  // namespace dimline
