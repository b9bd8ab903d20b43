#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dimline {

/// What a JSON text says, as a tree. For the few short texts that come from outside; a library for all of JSON would be a thirtieth of what a page fetches.
struct JsonValue {
  enum class Kind : std::uint8_t { kNull, kBool, kNumber, kText, kList, kObject };
  Kind kind = Kind::kNull;
  bool flag = false;                ///< kBool
  double number = 0;                ///< kNumber: finite
  std::string text;                 ///< kText: its characters, well-formed UTF-8; kNull, kBool, kNumber: as it was spelled
  std::vector<JsonValue> elements;  ///< kList, kObject: in the order of the text
  std::vector<std::string> names;   ///< kObject: of each element; one may occur several times
};

/// Nothing when the text is not JSON (RFC 8259), when it is nested more than some dozens deep, or when a number of it is too large for a double.
std::optional<JsonValue> parseJson(std::string_view text);

}  // namespace dimline
