#include "editing/value_text.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "support/random.h"

using namespace dimline;
using namespace dimline::test;

namespace {

Parameter length(char decimalMark = '.') {
  return {.name = "Width", .title = "Width", .unit = Unit::kMetre, .defaultValue = 8, .min = 0.5, .max = 20, .step = 0.1, .decimalMark = decimalMark};
}
Parameter angle() {
  return {.name = "Pitch", .title = "Roof pitch", .type = ParameterType::kAngle, .unit = Unit::kDegree, .defaultValue = 35, .min = 0, .max = 60, .step = 1};
}
Parameter area() { return {.name = "Area", .title = "Floor area", .unit = Unit::kSquareMetre, .defaultValue = 500, .min = 10, .max = 9000, .step = 10}; }
Parameter count() {
  return {.name = "Floors", .title = "Floors", .type = ParameterType::kInt, .defaultValue = 2, .min = 1, .max = 9, .step = 1, .noun = "floor"};
}

double read(const Parameter& parameter, std::string_view text) {
  const auto value = readValueText(parameter, text);
  INFO(text << ": " << (value ? "" : value.error().message));
  REQUIRE(value);
  return *value;
}
std::string refusal(const Parameter& parameter, std::string_view text) {
  const auto value = readValueText(parameter, text);
  INFO(text);
  REQUIRE_FALSE(value);
  return value.error().message;
}

std::string bracketed(std::size_t times) {
  std::string text(2 * times + 1, '(');
  text[times] = '1';
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(times) + 1, text.end(), ')');
  return text;
}

}  // namespace

TEST_CASE("a bare number is in the parameter's own unit") {
  REQUIRE(read(length(), "3.2") == 3.2);
  REQUIRE(read(length(), "  .5 ") == 0.5);
  REQUIRE(read(length(), "3.") == 3);
  REQUIRE(read(length(), "-3 cm") == -0.03);
  REQUIRE(read(length(), "2e-1") == 0.2);
  REQUIRE(read(angle(), "35") == 35);
  REQUIRE(read(area(), "120") == 120);
  REQUIRE(read(count(), "3") == 3);
  REQUIRE(read(length(), "1.2345678901234567") == 1.2345678901234567);
}

TEST_CASE("lengths are read in the units that people use") {
  const auto [text, metres] = GENERATE(table<const char*, double>({
      {"3.2 m", 3.2}, {"3.2m", 3.2}, {"320 cm", 3.2}, {"3200 MM", 3.2}, {"32 dm", 3.2}, {"0.0032 km", 3.2}, {"10 ft", 3.048}, {"10 feet", 3.048},
      {"1 foot", 0.3048}, {"10'", 3.048}, {"10'6\"", 3.2004}, {"10' 6\"", 3.2004}, {"10 ft 6 in", 3.2004}, {"10'6", 3.2004}, {"6\"", 0.1524},
      {"10\xE2\x80\xB2 6\xE2\x80\xB3", 3.2004}, {"10\xE2\x80\x99 6\xE2\x80\x9D", 3.2004}, {"10'6''", 3.2004}, {"1/2 in", 0.0127}, {"6 1/2 in", 0.1651},
      {"10'-6\"", 3.2004}, {"10' - 6\"", 2.8956}, {"10' -6\"", 2.8956}, {"10'- 6\"", 2.8956}, {"-10'-6\"", -3.2004},
      {"10' 6 1/2\"", 3.2131}, {"10' 1/2\"", 3.0607}, {"6\xC2\xBD in", 0.1651}, {"\xC2\xBE\"", 0.01905}, {"1 yd", 0.9144}, {"-10'6\"", -3.2004},
      {"3 m 20", 3.2}, {"3 m 20 cm", 3.2}, {"3m20cm5mm", 3.205}, {"2 metres", 2}}));
  INFO(text);
  REQUIRE(read(length(), text) == Approx(metres).epsilon(1e-13));
}

TEST_CASE("arithmetic follows the usual order, and a bare number beside a length is in metres") {
  const auto [text, metres] = GENERATE(table<const char*, double>({
      {"3*1.2m", 3.6}, {"3 * 1.2", 3.6}, {"2+3*4", 14}, {"(2+3)*4", 20}, {"10-2-3", 5}, {"12/2/3", 2}, {"-(1 - 3)", 2}, {"--3", 3}, {"3 + -1", 2},
      {"3 + 20 cm", 3.2}, {"20 cm + 3", 3.2}, {"1 m / 3 * 3", 1}, {"(1 + 2) cm", 0.03}, {"10'6\" + 2 cm", 3.2204}, {"6 m / 2", 3}, {"6 m / 2 m", 3},
      {"3/1.2m", 2.5}, {"1/2", 0.5}, {"3 1/2", 3.5}, {"= 2 * 4", 8}, {"3 \xC3\x97 2", 6}, {"6 \xC3\xB7 2", 3}, {"5 \xE2\x88\x92 2", 3}, {"12 m2 / 4 m", 3},
      {"((((2))))", 2}, {"10' 6\" * 2", 6.4008}}));
  INFO(text);
  REQUIRE(read(length(), text) == Approx(metres).epsilon(1e-13));
}

TEST_CASE("what is calculated is the number that a person would write") {
  REQUIRE(read(length(), "3*1.2m") == 3.6);
  REQUIRE(read(length(), "0.1 + 0.2") == 0.3);
  REQUIRE(read(length(), "320 cm") == 3.2);
  REQUIRE(read(count(), "0.1 * 30") == 3);
}

TEST_CASE("angles and areas have their own units") {
  REQUIRE(read(angle(), "35\xC2\xB0") == 35);
  REQUIRE(read(angle(), "35 deg") == 35);
  REQUIRE(read(angle(), "30\xC2\xB0 30'") == 30.5);
  REQUIRE(read(angle(), "30\xC2\xB0 30' 36\"") == Approx(30.51));
  REQUIRE(read(angle(), "0.5 rad") == Approx(28.6478897565).epsilon(1e-11));
  REQUIRE(read(angle(), "90/4") == 22.5);
  REQUIRE(read(area(), "10 m * 12 m") == 120);
  REQUIRE(read(area(), "120 m2") == 120);
  REQUIRE(read(area(), "120 m\xC2\xB2") == 120);
  REQUIRE(read(area(), "120 m^2 + 5") == 125);
  REQUIRE(read(area(), "0.1 ha") == 1000);
  REQUIRE(read(area(), "1000 sq ft") == Approx(92.90304));
  REQUIRE(read(count(), "3 floors") == 3);
  REQUIRE(read(count(), "1 Floor + 1") == 2);
}

TEST_CASE("a decimal comma is read as well as a point, whichever the visitor uses") {
  for (const char mark : {'.', ','}) {
    INFO(mark);
    REQUIRE(read(length(mark), "3,2") == 3.2);
    REQUIRE(read(length(mark), "3.2") == 3.2);
    REQUIRE(read(length(mark), "1.234,5") == 1234.5);
    REQUIRE(read(length(mark), "1,234.5") == 1234.5);
    REQUIRE(read(length(mark), "1.234.567") == 1234567);
    REQUIRE(read(length(mark), "1,234,567.25") == 1234567.25);
    REQUIRE(read(length(mark), "1\xE2\x80\xAF""234,5") == 1234.5);
    REQUIRE(read(length(mark), "12\xC2\xA0""345") == 12345);
    REQUIRE(read(length(mark), "0,125") == 0.125);
    REQUIRE(read(length(mark), "3,2 m + 1.5") == 4.7);
  }
  REQUIRE(read(length('.'), "1.234") == 1.234);
  REQUIRE(read(length(','), "1,234") == 1.234);
}

TEST_CASE("a number that can be read in two ways is not guessed") {
  REQUIRE(refusal(length('.'), "1,234") == "\"1,234\" can be read in two ways. Write 1.234 or 1234.");
  REQUIRE(refusal(length(','), "12.345 m") == "\"12.345\" can be read in two ways. Write 12,345 or 12345.");
}

TEST_CASE("groups of digits have three each, the first one to three, and one sort of mark between them") {
  const std::string text = GENERATE(as<std::string>{}, "1,2345.6", "1,23,456", "1234,567.8", "1,234,56", ",123,456", "1.234,567.8", "1,234 567.8", "1 23");
  // Those with a space, as people paste them.
  std::string typed = text;
  if (const auto space = text.find(' '); space != std::string::npos) typed.replace(space, 1, "\xC2\xA0");
  REQUIRE(refusal(length(), typed).find("the number \"" + text + "\", of which it is not clear where its decimals begin") != std::string::npos);
}

TEST_CASE("a refusal says what is wrong and what would do") {
  REQUIRE(refusal(length(), "") == "Type a length, such as 8.00, 800 cm or 26'3\".");
  REQUIRE(refusal(length(','), "   ") == "Type a length, such as 8,00, 800 cm or 26'3\".");
  REQUIRE(refusal(length(), "3 apples") == "\"3 apples\" is not a length: \"apples\" is no unit. Try 8.00, 800 cm or 26'3\".");
  REQUIRE(refusal(length(), "tall") == "\"tall\" is not a length. Try 8.00, 800 cm or 26'3\".");
  REQUIRE(refusal(length(), "?") == "\"?\" is not a length. Try 8.00, 800 cm or 26'3\".");
  REQUIRE(refusal(angle(), "3 m") == "\"3 m\" is a length, and Roof pitch takes an angle. Try 35, 35\xC2\xB0 or 0.61 rad.");
  REQUIRE(refusal(area(), "3 m") == "\"3 m\" is a length, and Floor area takes an area. Try 500, 500 m\xC2\xB2 or 10 m * 50.0 m.");
  REQUIRE(refusal(count(), "2.5") == "Floors takes whole numbers, and \"2.5\" is not one. Try 3.");
  REQUIRE(refusal(length(), "3 *").find("ends too early") != std::string::npos);
  REQUIRE(refusal(length(), "(3 + 2").find("bracket that is not closed") != std::string::npos);
  REQUIRE(refusal(length(), "3 + 2)").find("closing bracket too many") != std::string::npos);
  REQUIRE(refusal(length(), "3 20").find("two numbers side by side") != std::string::npos);
  REQUIRE(refusal(length(), "20 cm 3 m").find("from the greater unit to the lesser") != std::string::npos);
  REQUIRE(refusal(length(), "3 cm 20").find("without a unit") != std::string::npos);
  REQUIRE(refusal(length(), "3 / 0").find("divides by zero") != std::string::npos);
  REQUIRE(refusal(length(), "3 m * 2 m").find("is an area, and Width takes a length") != std::string::npos);
  REQUIRE(refusal(length(), "3 m + 2 m2").find("adds a length and an area") != std::string::npos);
  REQUIRE(refusal(length(), "3 m + 2 deg").find("adds a length and an angle") != std::string::npos);
  REQUIRE(refusal(length(), "m").find("where a number should be") != std::string::npos);
  REQUIRE(refusal(length(), "3 $ 4").find("\"$\" in it") != std::string::npos);
  REQUIRE(refusal(length(), "1.2.3").find("where its decimals begin") != std::string::npos);
  REQUIRE(refusal(length(), "1,2,3").find("where its decimals begin") != std::string::npos);
}

TEST_CASE("what a refusal suggests is taken, and is the default within what its digits say") {
  const double chimneyM = 0.2;
  Parameter thin = length();
  thin.defaultValue = chimneyM;
  for (const Parameter& parameter : {length(), length(','), thin, angle(), area(), count()}) {
    std::string said = refusal(parameter, "?");
    said = said.substr(said.find("Try ") + 4);
    said.pop_back();   // the full stop
    std::vector<std::string> examples;
    for (const std::string_view between : {", ", " or "}) {
      const std::size_t at = said.find(between);
      if (at == std::string::npos) continue;
      examples.push_back(said.substr(0, at));
      said.erase(0, at + between.size());
    }
    examples.push_back(said);
    CHECK(examples.size() >= 2);
    for (const std::string& example : examples) CHECK(read(parameter, example) == Approx(parameter.defaultValue).epsilon(0.02));
  }
}

TEST_CASE("what would not end or fit is refused") {
  REQUIRE(refusal(length(), "1e999").find("too large") != std::string::npos);
  REQUIRE(refusal(length(), "1e300 * 1e300").find("too large") != std::string::npos);
  REQUIRE(refusal(length(), bracketed(40)).find("too many brackets") != std::string::npos);
  REQUIRE(read(length(), bracketed(30)) == 1);
  REQUIRE(refusal(length(), std::string(5000, '1')).find("too long") != std::string::npos);
  REQUIRE(read(length(), std::string(100, '-').append("1")) == 1);
}

TEST_CASE("no text breaks the reader, and whatever it reads is finite") {
  static constexpr std::string_view kPieces[] = {"3", "1.5", "2,5", "1,234", " ", "m", "cm", "'", "\"", "''", "/", "*", "+", "-", "(", ")", "\xC2\xBD", "\xC2\xB0",
                                                 "e5", "=", "ft", "\xFF", "\xC2", "m2", "x", "_", ".", ",", "\xC2\xA0", "0", "in", "rad"};
  Random random(4);
  int readable = 0;
  for (int i = 0; i < 40000; ++i) {
    std::string text;
    for (int n = random.whole(0, 9); n > 0; --n) text += kPieces[static_cast<std::size_t>(random.whole(0, std::size(kPieces) - 1))];
    const auto value = readValueText(i % 3 == 0 ? angle() : i % 3 == 1 ? length() : count(), text);
    if (value) {
      ++readable;
      INFO(text);
      REQUIRE(std::isfinite(*value));
    } else if (value.error().message.empty() || value.error().message.back() != '.') {
      FAIL(text);
    }
  }
  REQUIRE(readable > 500);
}

TEST_CASE("switches and choices are read by their names") {
  const Parameter roof{.name = "Roof", .title = "Roof", .type = ParameterType::kChoice, .min = 0, .max = 1, .choices = {"gable", "hip"}};
  REQUIRE(read(roof, "Hip") == 1);
  REQUIRE(read({.name = "Porch", .type = ParameterType::kBool}, "yes") == 1);
  REQUIRE(inputText(roof, 1) == "hip");
}

TEST_CASE("an edit field starts with the label's text where that is exact, and with all digits elsewhere") {
  REQUIRE(inputText(length(), 2.4) == "2.40 m");
  REQUIRE(inputText(length(','), 2.4) == "2,40 m");
  REQUIRE(inputText(length(','), 2.4375) == "2,4375 m");
  REQUIRE(inputText(angle(), 35) == "35\xC2\xB0");
  REQUIRE(inputText(angle(), 35.25) == "35.25\xC2\xB0");
  REQUIRE(inputText(area(), 1250) == "1250 m\xC2\xB2");
  REQUIRE(inputText(count(), 3) == "3");
}

TEST_CASE("what an edit field starts with is read as the very same value") {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const Parameter& parameter = i % 2 == 0 ? length(',') : angle();
    const double value = random.chance(0.5) ? snapValue(parameter, random.real(0, 20)) : random.real(0.5, 20);
    INFO(inputText(parameter, value));
    REQUIRE(read(parameter, inputText(parameter, value)) == value);
  }
}

TEST_CASE("a difference has a sign, and none when nobody could see it") {
  REQUIRE(differenceText(length(), 2.0, 2.4) == "+0.40 m");
  REQUIRE(differenceText(length(','), 2.4, 2.0) == "\xE2\x88\x92" "0,40 m");
  REQUIRE(differenceText(count(), 2, 4) == "+2");
  REQUIRE(differenceText(angle(), 35, 30) == "\xE2\x88\x92" "5\xC2\xB0");
  REQUIRE(differenceText(length(), 2.0, 2.0) == "");
  REQUIRE(differenceText(length(), 2.0, 2.0001) == "");
}
