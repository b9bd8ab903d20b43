#include "app/json_writer.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/text.h"

namespace dimline {

void JsonWriter::separate() {
  if (needsComma_) text_ += ',';
  needsComma_ = true;
}

JsonWriter& JsonWriter::beginObject() {
  separate();
  text_ += '{';
  needsComma_ = false;
  return *this;
}

JsonWriter& JsonWriter::endObject() {
  text_ += '}';
  needsComma_ = true;
  return *this;
}

JsonWriter& JsonWriter::beginArray() {
  separate();
  text_ += '[';
  needsComma_ = false;
  return *this;
}

JsonWriter& JsonWriter::endArray() {
  text_ += ']';
  needsComma_ = true;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  quote(name);
  text_ += ':';
  needsComma_ = false;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  separate();
  quote(text);
  return *this;
}

JsonWriter& JsonWriter::value(bool flag) { return raw(flag ? "true" : "false"); }
JsonWriter& JsonWriter::null() { return raw("null"); }

JsonWriter& JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  if (number == 0.0) return raw("0");  // never "-0"
  char buffer[32];
  int length = 0;
  for (const int digits : {15, 17}) {
    length = std::snprintf(buffer, sizeof buffer, "%.*g", digits, number);
    if (std::strtod(buffer, nullptr) == number) break;
  }
  return raw({buffer, static_cast<std::size_t>(length)});
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::value(const Vec2& v) { return beginArray().value(v.x).value(v.y).endArray(); }
JsonWriter& JsonWriter::value(const Vec3& v) { return beginArray().value(v.x).value(v.y).value(v.z).endArray(); }
JsonWriter& JsonWriter::value(const Segment& s) { return beginArray().value(s.start).value(s.end).endArray(); }
JsonWriter& JsonWriter::value(const Segment2& s) { return beginArray().value(s.start).value(s.end).endArray(); }
JsonWriter& JsonWriter::value(const Box2& b) {
  return beginArray().value(b.min.x).value(b.min.y).value(b.max.x).value(b.max.y).endArray();
}

JsonWriter& JsonWriter::value(const Mat4& m) {
  beginArray();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) value(m[column][row]);
  }
  return endArray();
}

void JsonWriter::quote(std::string_view text) {
  text_ += '"';
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = utf8Length(text);
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (static_cast<std::uint8_t>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      text_ += escape;
    } else if (length == 0) {
      text_ += "\xEF\xBF\xBD";
    } else {
      text_ += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  text_ += '"';
}

}  // namespace dimline
