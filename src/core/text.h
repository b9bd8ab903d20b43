#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Small helpers for text that people wrote or will read. ASCII rules only: no locale changes what they do.
namespace dimline {

/// Without the spaces, tabs and line ends at both ends.
std::string_view trim(std::string_view text);

/// Whether two texts are equal when the case of A to Z is ignored.
bool equalIgnoringCase(std::string_view a, std::string_view b);
/// Whether there is something before that ending.
bool endsIgnoringCase(std::string_view text, std::string_view ending);

/// The finite decimal number that the whole text spells ("-1.5", "2e3", ".5"); nothing for anything else: blanks,
/// "nan", "0x1".
std::optional<double> parseDouble(std::string_view text);

/// The number with so many decimals, `.` as the decimal sign, and never "-0.00".
std::string formatFixed(double value, int decimals);

/// Bytes of the well-formed UTF-8 character that a text, which is not empty, starts with; 0 when it starts with none.
std::size_t utf8Length(std::string_view text);

/// How many characters of a text a message shows: enough to recognise a word by, and a path in full, which is of no use in part.
inline constexpr std::size_t kRecognisable = 40;
inline constexpr std::size_t kWholePath = 4096;

/// The text fit to be shown or written: valid UTF-8, control characters and broken bytes replaced, cut after so many characters.
std::string readable(std::string_view text, std::size_t mostCharacters = std::string_view::npos);

/// The text in double quotes, fit for a message (see readable).
std::string inQuotes(std::string_view text, std::size_t mostCharacters = kRecognisable);

/// "a, b and c"; empty for none.
std::string joined(std::span<const std::string_view> words, std::string_view lastJoint = "and");

}  // namespace dimline
