#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/geometry.h"

namespace dimline {

/// Writes JSON text, piece by piece, in the order in which it is told; commas and quotes are its business.
///
///     JsonWriter json;
///     json.beginObject().key("name").value("house").key("size").value(Vec2(3, 4)).endObject();
///     json.text()   // {"name":"house","size":[3,4]}
///
/// Numbers are written so that the same double is read back, with 15 digits where they do; one that is not finite
/// becomes null, which is all JSON has for it. Text must be UTF-8; broken bytes become U+FFFD.
class JsonWriter {
public:
  JsonWriter& beginObject();
  JsonWriter& endObject();
  JsonWriter& beginArray();
  JsonWriter& endArray();
  JsonWriter& key(std::string_view name);

  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  JsonWriter& value(bool flag);
  JsonWriter& value(double number);
  JsonWriter& value(int number) { return value(static_cast<double>(number)); }
  JsonWriter& value(std::size_t number) { return value(static_cast<double>(number)); }
  JsonWriter& value(const Vec2& v);
  JsonWriter& value(const Vec3& v);
  JsonWriter& value(const Mat4& m);      ///< 16 numbers, column by column
  JsonWriter& value(const Segment& s);   ///< [[3],[3]]
  JsonWriter& value(const Segment2& s);  ///< [[2],[2]]
  JsonWriter& value(const Box2& b);      ///< [x0,y0,x1,y1]
  JsonWriter& null();
  /// Text that is JSON already.
  JsonWriter& raw(std::string_view json);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string take() { return std::move(text_); }

private:
  void separate();
  void quote(std::string_view text);

  std::string text_;
  bool needsComma_ = false;
};

}  // namespace dimline
