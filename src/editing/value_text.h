#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "model/parameter.h"

/// Values as visitors type and read them: arithmetic, units of every sort, and their own decimal mark (Parameter::decimalMark).
namespace dimline {

/// The value that a text means, in the parameter's own unit; neither clamped nor snapped. Or an error with a sentence for whoever typed it, which says what is
/// wrong and what would do.
///
/// - Arithmetic: + - * / and brackets, and what people type for them (×, ÷, −). A leading = is passed over, as in a spreadsheet.
/// - Units: km m dm cm mm, ft ' in ", deg ° rad (beside ° also ' and " for minutes and seconds of arc), m2 m² cm2 ft2 ha; a count also takes its noun. A bare
///   number is in the parameter's unit. Quantities side by side add up, from the greater unit to the lesser: 10' 6 1/2", 10'-6", 3 m 20 cm, and 3 m 20 for the same.
/// - Decimal point and decimal comma, and groups of three digits between the other mark or thin spaces: 1.234,5 and 1,234.5. What could be either (1,234 where
///   people write a point) is an error and not a guess.
/// - A switch and a choice take what parseValue() takes.
Result<double> readValueText(const Parameter& parameter, std::string_view text);

/// The text with which an edit field starts: the value to the last digit, with its unit. readValueText() gives the same value back.
std::string inputText(const Parameter& parameter, double value);

/// How far a value is from another, with its sign: "+0.40 m", "−2"; empty when they are equal to the last shown digit.
std::string differenceText(const Parameter& parameter, double from, double to);

}  // namespace dimline
