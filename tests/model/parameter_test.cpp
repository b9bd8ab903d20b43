#include "model/parameter.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace dimline {
namespace {

Parameter width() {
  Parameter p;
  p.name = "Width";
  p.unit = Unit::kMetre;
  p.defaultValue = 2.4;
  p.min = 0.6;
  p.max = 4.97;
  p.step = 0.05;
  return p;
}

Parameter pitch() {
  Parameter p;
  p.name = "Pitch";
  p.type = ParameterType::kAngle;
  p.unit = Unit::kDegree;
  p.defaultValue = 35;
  p.min = 15;
  p.max = 60;
  p.step = 1;
  return p;
}

Parameter floors() {
  Parameter p;
  p.name = "Floors";
  p.type = ParameterType::kInt;
  p.defaultValue = 2;
  p.min = 1;
  p.max = 5;
  p.step = 1;
  return p;
}

Parameter balcony() {
  Parameter p;
  p.name = "Balcony";
  p.type = ParameterType::kBool;
  p.defaultValue = 1;
  return p;
}

Parameter roof() {
  Parameter p;
  p.name = "Roof";
  p.type = ParameterType::kChoice;
  p.max = 3;
  p.choices = {"gable", "hip", "shed", "flat"};
  return p;
}

double parsed(const Parameter& p, std::string_view text) {
  INFO(text);
  auto value = parseValue(p, text);
  if (!value.ok()) FAIL(value.error().message);
  return *value;
}

std::string errorOf(const Parameter& p, std::string_view text) {
  auto value = parseValue(p, text);
  return value.ok() ? "(no error)" : value.error().message;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_CASE("values start at the defaults, in order") {
  const std::vector<Parameter> parameters = {width(), floors(), roof()};
  const Values values(parameters);
  REQUIRE(values.size() == 3);
  CHECK(values.at(0) == 2.4);
  CHECK(values.at(1) == 2);
  CHECK(values.at(2) == 0);
  CHECK(findParameter(parameters, "Floors") == std::size_t{1});
  CHECK_FALSE(findParameter(parameters, "floors").has_value());
}

TEST_CASE("clamping keeps to the range and to whole numbers, and knows no NaN") {
  CHECK(clampValue(width(), 2.413) == 2.413);
  CHECK(clampValue(width(), 0) == 0.6);
  CHECK(clampValue(width(), kInfinity) == 4.97);
  CHECK(clampValue(width(), -kInfinity) == 0.6);
  CHECK(clampValue(width(), kNaN) == 2.4);
  CHECK(clampValue(floors(), 2.6) == 3);
  CHECK(clampValue(floors(), 9) == 5);
  CHECK(clampValue(balcony(), 0.7) == 1);
  CHECK(clampValue(balcony(), -4) == 0);
  CHECK(clampValue(roof(), 99) == 3);
  CHECK(clampValue(roof(), kNaN) == 0);
}

TEST_CASE("snapping counts steps from the least value, without noise") {
  CHECK(snapValue(width(), 0.961) == 0.95);  // 0.6 + 7 * 0.05 is 0.9500000000000001 in doubles
  CHECK(snapValue(width(), 0.60) == 0.6);
  CHECK(snapValue(width(), 2.374) == 2.35);
  CHECK(snapValue(width(), 2.376) == 2.4);
  CHECK(snapValue(pitch(), 35.4) == 35);
  CHECK(snapValue(floors(), 3.5) == 4);
}

TEST_CASE("both limits are reachable though the last step is a short one") {
  // Steps end at 4.95; the range at 4.97.
  CHECK(snapValue(width(), 4.97) == 4.97);
  CHECK(snapValue(width(), 4.965) == 4.97);
  CHECK(snapValue(width(), 4.955) == 4.95);
  CHECK(snapValue(width(), 100) == 4.97);
  CHECK(snapValue(width(), -100) == 0.6);
}

TEST_CASE("a snapped value stays where it is, everywhere in the range") {
  for (int i = 0; i <= 1000; ++i) {
    const Parameter p = width();
    const double v = p.min + (p.max - p.min) * i / 1000;
    const double snapped = snapValue(p, v);
    CHECK(snapValue(p, snapped) == snapped);
    CHECK(std::abs(snapped - v) <= p.step / 2 + 1e-9);
    CHECK(clampValue(p, snapped) == snapped);
  }
}

TEST_CASE("without a step any value stays") {
  Parameter p = width();
  p.step = 0;
  CHECK(snapValue(p, 1.23456) == 1.23456);
}

TEST_CASE("values are read in the parameter's own unit") {
  CHECK(parsed(width(), "3.5") == 3.5);
  CHECK(parsed(width(), " 3.51 m ") == 3.51);  // off-step is allowed
  CHECK(parsed(width(), "0.6") == 0.6);
  CHECK(parsed(pitch(), "40") == 40);
  CHECK(parsed(pitch(), "40\xC2\xB0") == 40);
  CHECK(parsed(pitch(), "40 deg") == 40);
  CHECK(parsed(floors(), "3") == 3);
  CHECK(parsed(balcony(), "true") == 1);
  CHECK(parsed(balcony(), "Off") == 0);
  CHECK(parsed(balcony(), "0") == 0);
  CHECK(parsed(roof(), "shed") == 2);
  CHECK(parsed(roof(), "Hip") == 1);
}

TEST_CASE("a value that cannot be is an error that says what can") {
  CHECK(errorOf(width(), "5") == "Width must lie between 0.60 m and 4.97 m, so it cannot be \"5\".");
  CHECK(errorOf(width(), "wide") == "Width takes a number, such as 2.40 m, not \"wide\".");
  CHECK(errorOf(width(), "") == "Width takes a number, such as 2.40 m, not \"\".");
  CHECK(errorOf(width(), "nan") == "Width takes a number, such as 2.40 m, not \"nan\".");
  CHECK(errorOf(width(), "inf") == "Width takes a number, such as 2.40 m, not \"inf\".");
  CHECK(errorOf(width(), "1e999") == "Width takes a number, such as 2.40 m, not \"1e999\".");
  CHECK(errorOf(width(), "0x2") == "Width takes a number, such as 2.40 m, not \"0x2\".");
  CHECK(errorOf(width(), "3,5") == "Width takes a number, such as 2.40 m, not \"3,5\".");
  CHECK(errorOf(width(), "3 deg") == "Width takes a number, such as 2.40 m, not \"3 deg\".");
  CHECK(errorOf(floors(), "2.5") == "Floors takes a whole number, not \"2.5\".");
  CHECK(errorOf(floors(), "6") == "Floors must lie between 1 and 5, so it cannot be \"6\".");
  CHECK(errorOf(balcony(), "maybe") == "Balcony is a switch: it takes true or false, not \"maybe\".");
  CHECK(errorOf(roof(), "onion") == "Roof takes gable, hip, shed or flat, not \"onion\".");
  CHECK(errorOf(roof(), "1") == "Roof takes gable, hip, shed or flat, not \"1\".");
}

TEST_CASE("values are written as people read them") {
  CHECK(formatValue(width(), 2.4) == "2.40 m");
  CHECK(formatValue(width(), -0.001) == "0.00 m");
  CHECK(formatValue(pitch(), 35) == "35\xC2\xB0");
  CHECK(formatValue(pitch(), 35.3) == "35.3\xC2\xB0");
  CHECK(formatValue(floors(), 3) == "3");
  CHECK(formatValue(balcony(), 1) == "on");
  CHECK(formatValue(balcony(), 0) == "off");
  CHECK(formatValue(roof(), 1) == "hip");

  Parameter area = width();
  area.unit = Unit::kSquareMetre;
  area.step = 1;
  CHECK(formatValue(area, 120) == "120 m\xC2\xB2");

  Parameter tiny = width();  // a model of a few centimetres needs more than centimetres
  tiny.min = 0.01;
  tiny.max = 0.1;
  tiny.step = 0.0002;
  CHECK(formatValue(tiny, 0.0238) == "0.0238 m");
}

}  // namespace
}  // namespace dimline
