#include "app/json_value.h"

#include <algorithm>

#include "core/text.h"

namespace dimline {

namespace {

/// Cameras and values need three; each costs some stack.
constexpr int kMaxNesting = 50;

/// Takes the text from its front, piece by piece. Each function says whether what it is about was there.
class Parser {
public:
  explicit Parser(std::string_view text) : rest_(text) {}

  bool whole(JsonValue& value) {
    return element(value) && rest_.empty();
  }

private:
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void skipSpace() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n\r"), rest_.size())); }

  bool element(JsonValue& value) {
    skipSpace();
    const bool good = take('{')   ? list(value, JsonValue::Kind::kObject, '}')
                      : take('[') ? list(value, JsonValue::Kind::kList, ']')
                      : take('"') ? string(value.text) && of(value, JsonValue::Kind::kText)
                                  : bare(value);
    skipSpace();
    return good;
  }

  static bool of(JsonValue& value, JsonValue::Kind kind) {
    value.kind = kind;
    return true;
  }

  bool list(JsonValue& value, JsonValue::Kind kind, char end) {
    value.kind = kind;
    if (++nesting_ > kMaxNesting) return false;
    skipSpace();
    if (!take(end)) {
      do {
        if (kind == JsonValue::Kind::kObject && !name(value.names.emplace_back())) return false;
        if (!element(value.elements.emplace_back())) return false;
      } while (take(','));
      if (!take(end)) return false;
    }
    --nesting_;
    return true;
  }

  bool name(std::string& name) {
    skipSpace();
    if (!take('"') || !string(name)) return false;
    skipSpace();
    return take(':');
  }

  /// A number, or one of the three words.
  bool bare(JsonValue& value) {
    const std::size_t length = std::min(rest_.find_first_of(" \t\n\r,]}"), rest_.size());
    value.text = rest_.substr(0, length);
    rest_.remove_prefix(length);
    if (value.text == "null") return true;
    value.flag = value.text == "true";
    if (value.flag || value.text == "false") return of(value, JsonValue::Kind::kBool);
    const auto number = isNumber(value.text) ? parseDouble(value.text) : std::nullopt;
    value.number = number.value_or(0);
    return number && of(value, JsonValue::Kind::kNumber);
  }

  /// What JSON forbids of what parseDouble() reads: a plus in front, zeros in front, a point without a digit on either side.
  static bool isNumber(std::string_view text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (text.starts_with('-')) text.remove_prefix(1);
    if (text.empty() || !isDigit(text[0])) return false;
    if (text[0] == '0' && text.size() > 1 && isDigit(text[1])) return false;
    const std::size_t point = text.find('.');
    return point == std::string_view::npos || (point + 1 < text.size() && isDigit(text[point + 1]));
  }

  /// Behind its opening quote.
  bool string(std::string& text) {
    while (!rest_.empty()) {
      const std::size_t length = utf8Length(rest_);
      if (length == 0 || (length == 1 && static_cast<unsigned char>(rest_[0]) < 0x20)) return false;
      if (take('"')) return true;
      if (take('\\')) {
        if (!escape(text)) return false;
        continue;
      }
      text += rest_.substr(0, length);
      rest_.remove_prefix(length);
    }
    return false;
  }

  /// Behind its backslash.
  bool escape(std::string& text) {
    if (rest_.empty()) return false;
    const char c = rest_[0];
    rest_.remove_prefix(1);
    if (c == 'u') return unicodeEscape(text);
    constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
    const std::size_t at = kLetters.find(c);
    if (at == std::string_view::npos) return false;
    text += kMeanings[at];
    return true;
  }

  /// Behind \u: one unit, or two that stand for a character past 0xFFFF.
  bool unicodeEscape(std::string& text) {
    auto code = hexUnit();
    if (!code) return false;
    if (*code >= 0xD800 && *code < 0xE000) {
      if (*code >= 0xDC00 || !take('\\') || !take('u')) return false;
      const auto low = hexUnit();
      if (!low || *low < 0xDC00 || *low >= 0xE000) return false;
      code = 0x10000U + ((*code - 0xD800U) << 10U) + (*low - 0xDC00U);
    }
    const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80U | ((*code >> shift) & 0x3FU)); };
    if (*code < 0x80) {
      text += static_cast<char>(*code);
      return true;
    }
    if (*code < 0x800) {
      text += static_cast<char>(0xC0U | (*code >> 6U));
    } else {
      if (*code < 0x10000) {
        text += static_cast<char>(0xE0U | (*code >> 12U));
      } else {
        text += static_cast<char>(0xF0U | (*code >> 18U));
        tail(12);
      }
      tail(6);
    }
    tail(0);
    return true;
  }

  std::optional<std::uint32_t> hexUnit() {
    if (rest_.size() < 4) return std::nullopt;
    std::uint32_t unit = 0;
    for (const char c : rest_.substr(0, 4)) {
      const std::size_t digit = std::string_view("0123456789abcdefABCDEF").find(c);
      if (digit == std::string_view::npos) return std::nullopt;
      unit = unit * 16 + static_cast<std::uint32_t>(digit < 16 ? digit : digit - 6);
    }
    rest_.remove_prefix(4);
    return unit;
  }

  std::string_view rest_;
  int nesting_ = 0;
};

}  // namespace

std::optional<JsonValue> parseJson(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors put one in front of a file
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  JsonValue value;
  if (!Parser(text).whole(value)) return std::nullopt;
  return value;
}

}  // namespace dimline
