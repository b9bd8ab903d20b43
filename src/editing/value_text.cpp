#include "editing/value_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "core/text.h"
#include "math/types.h"

// A text is cut into tokens first (numbers, units, signs), so that 10' 6 1/2" can be recognised by looking a few tokens ahead; then read by recursive descent.
// Every quantity carries what it measures. A bare number measures nothing until it meets something that does, or the end: then it is in the parameter's unit.

namespace dimline {

namespace {

constexpr std::size_t kLongestText = 200;
constexpr int kDeepestNesting = 32;

/// Share by which a count may miss a whole number: 0.1 * 30 is 3.
constexpr double kWholeTolerance = 1e-9;

enum class Kind { kBare, kLength, kArea, kAngle };

std::string_view nameOf(Kind kind) {
  switch (kind) {
    case Kind::kLength:
      return "a length";
    case Kind::kArea:
      return "an area";
    case Kind::kAngle:
      return "an angle";
    case Kind::kBare:
      break;
  }
  return "a number";
}

Kind kindOf(const Parameter& parameter) {
  switch (parameter.unit) {
    case Unit::kMetre:
      return Kind::kLength;
    case Unit::kSquareMetre:
      return Kind::kArea;
    case Unit::kDegree:
      return Kind::kAngle;
    case Unit::kNone:
      break;
  }
  return Kind::kBare;
}

struct UnitWord {
  std::string_view word;
  Kind kind;
  double size;   ///< in m, m² or degrees
};

constexpr double kFootM = 0.3048;
constexpr double kInchM = 0.0254;

constexpr std::array kUnitWords{
    UnitWord{"m", Kind::kLength, 1},         UnitWord{"metre", Kind::kLength, 1},       UnitWord{"metres", Kind::kLength, 1},
    UnitWord{"meter", Kind::kLength, 1},     UnitWord{"meters", Kind::kLength, 1},      UnitWord{"km", Kind::kLength, 1000},
    UnitWord{"dm", Kind::kLength, 0.1},      UnitWord{"cm", Kind::kLength, 0.01},       UnitWord{"mm", Kind::kLength, 0.001},
    UnitWord{"ft", Kind::kLength, kFootM},   UnitWord{"foot", Kind::kLength, kFootM},   UnitWord{"feet", Kind::kLength, kFootM},
    UnitWord{"in", Kind::kLength, kInchM},   UnitWord{"inch", Kind::kLength, kInchM},   UnitWord{"inches", Kind::kLength, kInchM},
    UnitWord{"yd", Kind::kLength, 0.9144},   UnitWord{"deg", Kind::kAngle, 1},          UnitWord{"degree", Kind::kAngle, 1},
    UnitWord{"degrees", Kind::kAngle, 1},    UnitWord{"\xC2\xB0", Kind::kAngle, 1},     UnitWord{"rad", Kind::kAngle, kDegPerRad},
    UnitWord{"m2", Kind::kArea, 1},          UnitWord{"m\xC2\xB2", Kind::kArea, 1},     UnitWord{"sqm", Kind::kArea, 1},
    UnitWord{"cm2", Kind::kArea, 1e-4},      UnitWord{"cm\xC2\xB2", Kind::kArea, 1e-4}, UnitWord{"ha", Kind::kArea, 1e4},
    UnitWord{"ft2", Kind::kArea, kFootM * kFootM}, UnitWord{"ft\xC2\xB2", Kind::kArea, kFootM * kFootM}, UnitWord{"sqft", Kind::kArea, kFootM * kFootM},
};

/// Signs of more than one byte that people type or paste, as the ones that are read.
struct Spelling {
  std::string_view written, read;
};
constexpr std::array kSpellings{
    Spelling{"\xC3\x97", "*"},      Spelling{"\xC3\xB7", "/"},      Spelling{"\xE2\x88\x92", "-"},  Spelling{"\xE2\x80\x93", "-"},   // × ÷ − –
    Spelling{"\xC2\xB7", "*"},      Spelling{"\xE2\x80\xB2", "'"},  Spelling{"\xE2\x80\x98", "'"},  Spelling{"\xE2\x80\x99", "'"},   // · ′ ‘ ’
    Spelling{"\xE2\x80\xB3", "\""}, Spelling{"\xE2\x80\x9C", "\""}, Spelling{"\xE2\x80\x9D", "\""}, Spelling{"''", "\""},            // ″ “ ”
    Spelling{"\xC2\xBD", " 1/2"},   Spelling{"\xC2\xBC", " 1/4"},   Spelling{"\xC2\xBE", " 3/4"},                                    // ½ ¼ ¾
    Spelling{"m^2", "m2"},          Spelling{"ft^2", "ft2"},        Spelling{"sq m", "sqm"},        Spelling{"sq ft", "sqft"},
};

/// Spaces with which numbers are grouped: no-break, narrow no-break, thin.
constexpr std::array<std::string_view, 3> kGroupSpaces{"\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Letters of ASCII, and every byte of other characters: a word of any language is one token.
bool isWordByte(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (static_cast<unsigned char>(c) & 0x80U) != 0; }

struct Token {
  enum class Type { kNumber, kUnit, kSign, kEnd } type = Type::kEnd;
  double number = 0;
  bool whole = false;        ///< of a number: written with digits alone
  std::size_t digits = 0;    ///< of a number: how many it has before its mark
  const UnitWord* unit = nullptr;
  char sign = 0;
  std::string_view text;
};

struct Quantity {
  double value = 0;               ///< a bare number as it is, a length in m, an area in m², an angle in degrees
  Kind kind = Kind::kBare;
  double literalUnit = 0;         ///< size of the unit when it is a number with a unit and nothing else; 0 otherwise
};

/// Examples for the end of a sentence: ways to write the default, so that who follows them meets no limit.
std::string examples(const Parameter& parameter) {
  const double value = parameter.defaultValue;
  std::array<char, 96> text{};
  switch (kindOf(parameter)) {
    case Kind::kLength: {
      const auto inches = static_cast<int>(std::lround(value / kInchM));
      std::snprintf(text.data(), text.size(), "%.2f, %.0f cm or %d'%d\"", value, value * 100, inches / 12, inches % 12);
      break;
    }
    case Kind::kArea:
      std::snprintf(text.data(), text.size(), "%.0f, %.0f m\xC2\xB2 or 10 m * %.1f m", value, value, value / 10);
      break;
    case Kind::kAngle:
      std::snprintf(text.data(), text.size(), "%.0f, %.0f\xC2\xB0 or %.2f rad", value, value, value / kDegPerRad);
      break;
    case Kind::kBare:
      std::snprintf(text.data(), text.size(), "%g or %g + 1", value, value - 1);
      break;
  }
  std::ranges::replace(text, '.', parameter.decimalMark);
  return text.data();
}

class Reader {
 public:
  Reader(const Parameter& parameter, std::string_view text) : parameter_(parameter), whole_(trim(text)), normal_(normalised(trim(text))) {}

  Result<double> read() {
    const std::string wanted(nameOf(kindOf(parameter_)));
    if (whole_.empty()) return Error{"Type " + wanted + ", such as " + examples(parameter_) + "."};
    if (whole_.size() > kLongestText) return Error{"This is too long to be " + wanted + ". Try " + examples(parameter_) + "."};
    if (!cut()) return error();
    if (peek().type == Token::Type::kSign && peek().sign == '=') ++at_;
    const auto result = sum(0);
    if (result && peek().type != Token::Type::kEnd) unexpected(peek());
    if (!error_.empty() || !result) return error();
    if (result->kind != Kind::kBare && result->kind != kindOf(parameter_)) {
      fail("is " + std::string(nameOf(result->kind)) + ", and " + titleOf() + " takes " + wanted);
      return error();
    }
    if (!std::isfinite(result->value)) {
      fail("is too large a number");
      return error();
    }
    return finished(*result);
  }

 private:
  static std::string normalised(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      const auto group = std::ranges::find_if(kGroupSpaces, [&](std::string_view s) { return text.substr(i).starts_with(s); });
      if (group != kGroupSpaces.end()) {
        const std::string_view rest = text.substr(i + group->size());
        const bool between = !result.empty() && isDigit(result.back()) && !rest.empty() && isDigit(rest.front());
        if (!between) result += ' ';
        // What stands between groups is kept as a sign of its own, so that groups are counted.
        if (between) result += '_';
        i += group->size();
        continue;
      }
      const auto spelling = std::ranges::find_if(kSpellings, [&](const Spelling& s) { return text.substr(i).starts_with(s.written); });
      if (spelling != kSpellings.end()) {
        result += spelling->read;
        i += spelling->written.size();
      } else {
        result += text[i++];
      }
    }
    return result;
  }

  [[nodiscard]] std::string titleOf() const { return parameter_.title.empty() ? parameter_.name : parameter_.title; }

  /// Notes what is wrong with the whole text; the first that is found is what is said.
  bool fail(const std::string& what) {
    if (error_.empty()) error_ = inQuotes(whole_) + " " + what + ". Try " + examples(parameter_) + ".";
    return false;
  }
  [[nodiscard]] Error error() const { return Error{error_}; }

  bool unexpected(const Token& token) {
    if (token.type == Token::Type::kEnd) return fail("ends too early: a number is missing");
    if (token.type == Token::Type::kSign && token.sign == ')') return fail("has a closing bracket too many");
    if (token.type == Token::Type::kNumber) return fail("has two numbers side by side: write + between them, or a unit after the first");
    if (token.type == Token::Type::kUnit) return fail("has the unit " + inQuotes(token.text) + " where a number should be");
    return fail("has " + inQuotes(token.text) + " where a number should be");
  }

  // --- Tokens ---

  bool cut() {
    const std::string_view text = normal_;
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        ++i;
      } else if (isDigit(c) || ((c == '.' || c == ',') && i + 1 < text.size() && isDigit(text[i + 1]))) {
        if (!cutNumber(text, i)) return false;
      } else if (isWordByte(c) || c == '\'' || c == '"') {
        if (!cutUnit(text, i)) return false;
      } else if (std::string_view("+-*/()=").find(c) != std::string_view::npos) {
        tokens_.push_back({.type = Token::Type::kSign, .sign = c, .text = text.substr(i, 1)});
        ++i;
      } else {
        return fail(inQuotes(whole_) == inQuotes(text.substr(i, 1)) ? "is not " + std::string(nameOf(kindOf(parameter_)))
                                                                    : "has " + inQuotes(text.substr(i, 1)) + " in it, which means nothing here");
      }
    }
    tokens_.push_back({});
    return true;
  }

  bool cutNumber(std::string_view text, std::size_t& i) {
    const std::size_t first = i;
    std::vector<std::pair<char, std::size_t>> marks;   // what they are, and how many digits are before them
    std::string digits;
    for (; i < text.size(); ++i) {
      const char c = text[i];
      const bool mark = (c == '.' || c == ',' || c == '_') && (c != '_' || !digits.empty()) && i + 1 < text.size() && (isDigit(text[i + 1]));
      if (mark) {
        marks.emplace_back(c, digits.size());
      } else if (isDigit(c)) {
        digits += c;
      } else if ((c == '.' || c == ',') && !digits.empty()) {
        marks.emplace_back(c, digits.size());   // "3." is 3
      } else {
        break;
      }
    }
    std::string exponent;
    if (i + 1 < text.size() && (text[i] == 'e' || text[i] == 'E')) {
      std::size_t j = i + 1;
      if (text[j] == '+' || text[j] == '-') ++j;
      if (j < text.size() && isDigit(text[j])) {
        while (j < text.size() && isDigit(text[j])) ++j;
        exponent = std::string(text.substr(i, j - i));
        i = j;
      }
    }
    const std::string_view written = text.substr(first, i - first);
    const auto decimalAt = decimalPlace(marks, digits.size(), written);
    if (!decimalAt) return false;
    Token token{.type = Token::Type::kNumber, .text = written};
    token.whole = *decimalAt >= digits.size() && exponent.empty();
    token.digits = std::min(*decimalAt, digits.size());
    if (*decimalAt < digits.size()) digits.insert(*decimalAt, ".");
    token.number = std::strtod((digits + exponent).c_str(), nullptr);
    if (!std::isfinite(token.number)) return fail("is too large a number");
    tokens_.push_back(token);
    return true;
  }

  /// How many digits stand before the decimal mark. Nothing, and an error, when the marks of a number cannot be read, or in two ways.
  std::optional<std::size_t> decimalPlace(const std::vector<std::pair<char, std::size_t>>& marks, std::size_t digitCount, std::string_view written) {
    if (marks.empty()) return digitCount;
    const char last = marks.back().first;
    const auto lastCount = std::ranges::count(marks, last, &std::pair<char, std::size_t>::first);
    const std::size_t after = digitCount - marks.back().second;
    const bool onlyOneSort = lastCount == static_cast<std::ptrdiff_t>(marks.size());
    const bool groups = last == '_' || (onlyOneSort && marks.size() > 1);
    if (onlyOneSort && marks.size() == 1 && last != '_' && last != parameter_.decimalMark && after == 3 && marks[0].second >= 1 && marks[0].second <= 3 &&
        !written.starts_with('0')) {
      std::string asDecimal(written);
      asDecimal[asDecimal.find(last)] = parameter_.decimalMark;
      std::string asGroups(written);
      asGroups.erase(asGroups.find(last), 1);
      error_ = inQuotes(written) + " can be read in two ways. Write " + asDecimal + " or " + asGroups + ".";
      return std::nullopt;
    }
    // Groups have three digits, the first one to three, and one sort of mark.
    const std::size_t groupMarks = groups ? marks.size() : marks.size() - 1;
    for (std::size_t m = 0; m < groupMarks; ++m) {
      const std::size_t until = m + 1 < marks.size() ? marks[m + 1].second : digitCount;
      if (until - marks[m].second != 3 || marks[0].second < 1 || marks[0].second > 3 || marks[m].first != marks[0].first ||
          (!groups && marks[m].first == last)) {
        fail("has the number " + inQuotes(readable(written)) + ", of which it is not clear where its decimals begin");
        return std::nullopt;
      }
    }
    return groups ? digitCount : marks.back().second;
  }

  static std::string readable(std::string_view written) {
    std::string text(written);
    std::ranges::replace(text, '_', ' ');
    return text;
  }

  bool cutUnit(std::string_view text, std::size_t& i) {
    const std::size_t first = i;
    if (text[i] == '\'' || text[i] == '"') {
      ++i;
    } else {
      while (i < text.size() && isWordByte(text[i])) ++i;
      if (i < text.size() && text[i] == '2' && (i + 1 == text.size() || !isDigit(text[i + 1]))) ++i;   // m2
    }
    const std::string_view word = text.substr(first, i - first);
    const UnitWord* unit = unitOf(word);
    if (unit == nullptr) {
      const std::string wanted(nameOf(kindOf(parameter_)));
      return fail(tokens_.empty() && i == text.size() ? "is not " + wanted : "is not " + wanted + ": " + inQuotes(word) + " is no unit");
    }
    tokens_.push_back({.type = Token::Type::kUnit, .unit = unit, .text = word});
    return true;
  }

  [[nodiscard]] const UnitWord* unitOf(std::string_view word) const {
    static constexpr UnitWord kFoot{"'", Kind::kLength, kFootM}, kInch{"\"", Kind::kLength, kInchM};
    static constexpr UnitWord kMinute{"'", Kind::kAngle, 1.0 / 60}, kSecond{"\"", Kind::kAngle, 1.0 / 3600};
    static constexpr UnitWord kNoun{"", Kind::kBare, 1};
    const bool angle = kindOf(parameter_) == Kind::kAngle;
    if (word == "'") return angle ? &kMinute : &kFoot;
    if (word == "\"") return angle ? &kSecond : &kInch;
    if (!parameter_.noun.empty() && (equalIgnoringCase(word, parameter_.noun) || equalIgnoringCase(word, pluralNoun(parameter_)))) return &kNoun;
    const auto found = std::ranges::find_if(kUnitWords, [&](const UnitWord& u) { return equalIgnoringCase(u.word, word); });
    return found != kUnitWords.end() ? &*found : nullptr;
  }

  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  [[nodiscard]] bool isSign(char sign, std::size_t ahead = 0) const { return peek(ahead).type == Token::Type::kSign && peek(ahead).sign == sign; }

  // --- Grammar: sum > product > signed > primary ---

  std::optional<Quantity> sum(int depth) {
    auto left = product(depth);
    while (left && (isSign('+') || isSign('-'))) {
      const double sense = tokens_[at_++].sign == '+' ? 1.0 : -1.0;
      const auto right = product(depth);
      if (!right) return std::nullopt;
      left = added(*left, *right, sense);
    }
    return left;
  }

  /// A bare number beside a quantity is in the parameter's unit, if that is of the quantity's kind.
  std::optional<Quantity> added(const Quantity& a, const Quantity& b, double sense) {
    const Kind own = kindOf(parameter_);
    const auto fits = [&](const Quantity& bare, const Quantity& other) { return bare.kind == Kind::kBare && other.kind == own; };
    if (a.kind != b.kind && !fits(a, b) && !fits(b, a)) {
      fail("adds " + std::string(nameOf(a.kind)) + " and " + std::string(nameOf(b.kind)) + ", which are not the same sort of thing");
      return std::nullopt;
    }
    return Quantity{a.value + sense * b.value, a.kind == Kind::kBare ? b.kind : a.kind, 0};
  }

  std::optional<Quantity> product(int depth) {
    auto left = signedQuantity(depth);
    while (left && (isSign('*') || isSign('/'))) {
      const bool divides = tokens_[at_++].sign == '/';
      const auto right = signedQuantity(depth);
      if (!right) return std::nullopt;
      left = divides ? divided(*left, *right) : multiplied(*left, *right);
    }
    return left;
  }

  std::optional<Quantity> multiplied(const Quantity& a, const Quantity& b) {
    if (a.kind == Kind::kBare) return Quantity{a.value * b.value, b.kind, 0};
    if (b.kind == Kind::kBare) return Quantity{a.value * b.value, a.kind, 0};
    if (a.kind == Kind::kLength && b.kind == Kind::kLength) return Quantity{a.value * b.value, Kind::kArea, 0};
    fail("multiplies " + std::string(nameOf(a.kind)) + " by " + std::string(nameOf(b.kind)) + ", which gives nothing that can be used here");
    return std::nullopt;
  }

  std::optional<Quantity> divided(const Quantity& a, const Quantity& b) {
    if (b.value == 0) {
      fail("divides by zero");
      return std::nullopt;
    }
    if (b.kind == Kind::kBare) return Quantity{a.value / b.value, a.kind, 0};
    // 1/2 in is half an inch.
    if (a.kind == Kind::kBare && b.literalUnit > 0) return Quantity{a.value / (b.value / b.literalUnit) * b.literalUnit, b.kind, 0};
    if (a.kind == b.kind) return Quantity{a.value / b.value, Kind::kBare, 0};
    if (a.kind == Kind::kArea && b.kind == Kind::kLength) return Quantity{a.value / b.value, Kind::kLength, 0};
    fail("divides " + std::string(nameOf(a.kind)) + " by " + std::string(nameOf(b.kind)) + ", which gives nothing that can be used here");
    return std::nullopt;
  }

  std::optional<Quantity> signedQuantity(int depth) {
    double sense = 1;
    for (; isSign('-') || isSign('+'); ++at_) {
      if (isSign('-')) sense = -sense;
    }
    auto quantity = primary(depth);
    if (quantity) quantity->value *= sense;
    return quantity;
  }

  std::optional<Quantity> primary(int depth) {
    if (isSign('(')) {
      if (depth >= kDeepestNesting) {
        fail("has too many brackets inside each other");
        return std::nullopt;
      }
      ++at_;
      auto inner = sum(depth + 1);
      if (!inner) return std::nullopt;
      if (!isSign(')')) {
        if (peek().type == Token::Type::kEnd) {
          fail("has a bracket that is not closed");
        } else {
          unexpected(peek());
        }
        return std::nullopt;
      }
      ++at_;
      inner->literalUnit = 0;
      if (peek().type == Token::Type::kUnit && inner->kind == Kind::kBare) {   // (1 + 2) cm
        const UnitWord& unit = *tokens_[at_++].unit;
        return Quantity{inner->value * unit.size, unit.kind, 0};
      }
      return inner;
    }
    return compound();
  }

  /// A number with its unit, and what stands beside it without a sign between: 10' 6", 3 m 20.
  std::optional<Quantity> compound() {
    if (peek().type != Token::Type::kNumber) {
      unexpected(peek());
      return std::nullopt;
    }
    auto total = measure();
    double lastUnit = total.literalUnit;
    if (lastUnit == kFootM) skipDash();
    while (lastUnit > 0 && total.kind != Kind::kBare && peek().type == Token::Type::kNumber) {
      const Token number = peek();
      Quantity part = measure();
      if (part.kind == Kind::kBare) {
        const auto implied = impliedUnit(lastUnit, total.kind, number);
        if (!implied) {
          fail("ends in a number without a unit: write the unit after " + inQuotes(number.text));
          return std::nullopt;
        }
        part = {part.value * *implied, total.kind, *implied};
      }
      if (part.kind != total.kind || !(part.literalUnit < lastUnit)) {
        fail("has quantities side by side that do not go from the greater unit to the lesser: write + between them");
        return std::nullopt;
      }
      total.value += part.value;
      total.literalUnit = 0;
      lastUnit = part.literalUnit;
    }
    return total;
  }

  /// The dash of drawings in 10'-6", which is no minus: it stands close to both.
  void skipDash() {
    const auto touches = [](const Token& a, const Token& b) { return a.text.data() + a.text.size() == b.text.data(); };
    if (isSign('-') && peek(1).type == Token::Type::kNumber && touches(tokens_[at_ - 1], peek()) && touches(peek(), peek(1))) ++at_;
  }

  /// The unit of a bare number after a quantity in another one: 3 m 20 is 3 m 20 cm, and 10' 6 is 10' 6".
  [[nodiscard]] static std::optional<double> impliedUnit(double lastUnit, Kind kind, const Token& number) {
    if (kind == Kind::kLength && lastUnit == 1 && number.whole && number.digits == 2) return 0.01;
    if (kind == Kind::kLength && lastUnit == kFootM) return kInchM;
    return std::nullopt;
  }

  /// One number, a whole one perhaps with a fraction behind it (6 1/2), and its unit.
  Quantity measure() {
    const Token first = tokens_[at_++];
    double value = first.number;
    const bool fraction = first.whole && peek().type == Token::Type::kNumber && peek().whole && isSign('/', 1) &&
                          peek(2).type == Token::Type::kNumber && peek(2).whole && peek(2).number > 0;
    if (fraction) {
      value += peek().number / peek(2).number;
      at_ += 3;
    } else if (first.whole && isSign('/') && peek(1).type == Token::Type::kNumber && peek(1).whole && peek(1).number > 0 &&
               peek(2).type == Token::Type::kUnit) {
      value /= peek(1).number;   // 1/2 in, also behind 10'
      at_ += 2;
    }
    if (peek().type != Token::Type::kUnit) return {value, Kind::kBare, 0};
    const UnitWord& unit = *tokens_[at_++].unit;
    return {value * unit.size, unit.kind, unit.kind == Kind::kBare ? 0 : unit.size};
  }

  [[nodiscard]] Result<double> finished(const Quantity& result) const {
    double value = result.value;
    if (parameter_.type == ParameterType::kInt) {
      const double whole = std::round(value);
      if (std::abs(value - whole) > kWholeTolerance * std::max(1.0, std::abs(whole))) {
        return Error{titleOf() + " takes whole numbers, and " + inQuotes(whole_) + " is not one. Try " + formatFixed(whole, 0) + "."};
      }
      return whole;
    }
    const bool typedAsIs = tokens_.size() == 2 || (tokens_.size() == 3 && tokens_[1].type == Token::Type::kUnit && tokens_[1].unit->size == 1);
    if (typedAsIs) return value;
    // The double nearest to its first 14 digits: 3 * 1.2 is 3.6 and not its neighbour.
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.14g", value);
    return std::strtod(buffer, nullptr);
  }

  const Parameter& parameter_;
  std::string_view whole_;
  std::string normal_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::string error_;
};

/// The fewest digits that give the same double back.
std::string shortest(double value) {
  char buffer[40];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    if (std::strtod(buffer, nullptr) == value) break;
  }
  return buffer;
}

bool isNumber(const Parameter& parameter) { return parameter.type != ParameterType::kBool && parameter.type != ParameterType::kChoice; }

}  // namespace

Result<double> readValueText(const Parameter& parameter, std::string_view text) {
  if (!isNumber(parameter)) return parseValue(parameter, text);
  return Reader(parameter, text).read();
}

std::string inputText(const Parameter& parameter, double value) {
  const std::string usual = formatValue(parameter, value);
  if (!isNumber(parameter)) return usual;
  if (const auto back = readValueText(parameter, usual); back && *back == value) return usual;
  std::string exact = shortest(value);
  std::ranges::replace(exact, '.', parameter.decimalMark);
  return exact + std::string(unitSuffix(parameter.unit));
}

std::string differenceText(const Parameter& parameter, double from, double to) {
  if (!isNumber(parameter)) return {};
  const std::string none = formatValue(parameter, 0.0);
  const double difference = to - from;
  // As much as the values themselves show: an off-step one has more digits than its difference to a whole one may need.
  const std::string amount = formatValue(parameter, std::abs(difference));
  if (amount == none) return {};
  return (difference > 0 ? "+" : "\xE2\x88\x92") + amount;
}

}  // namespace dimline
