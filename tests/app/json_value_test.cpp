#include "app/json_value.h"

#include <random>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

namespace dimline {
namespace {

using Kind = JsonValue::Kind;

/// Whether a library reads the same tree. Of several elements of one name it keeps the last.
bool same(const JsonValue& ours, const nlohmann::json& theirs) {
  switch (ours.kind) {
    case Kind::kNull: return theirs.is_null() && ours.text == "null";
    case Kind::kBool: return theirs.is_boolean() && theirs.get<bool>() == ours.flag;
    case Kind::kNumber: return theirs.is_number() && theirs.get<double>() == ours.number;
    case Kind::kText: return theirs.is_string() && theirs.get<std::string>() == ours.text;
    case Kind::kList: break;
    case Kind::kObject: {
      if (!theirs.is_object() || ours.names.size() != ours.elements.size()) return false;
      std::map<std::string, const JsonValue*> last;
      for (std::size_t i = 0; i < ours.elements.size(); ++i) last[ours.names[i]] = &ours.elements[i];
      if (last.size() != theirs.size()) return false;
      return std::ranges::all_of(last, [&](const auto& entry) { return theirs.contains(entry.first) && same(*entry.second, theirs[entry.first]); });
    }
  }
  if (!theirs.is_array() || theirs.size() != ours.elements.size()) return false;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    if (!same(ours.elements[i], theirs[i])) return false;
  }
  return true;
}

/// Both read the text, and the same, or neither does.
bool agree(const std::string& text) {
  const auto ours = parseJson(text);
  const auto theirs = nlohmann::json::parse(text, nullptr, false);
  return ours ? !theirs.is_discarded() && same(*ours, theirs) : theirs.is_discarded();
}

TEST_CASE("a JSON text becomes a tree in its own order") {
  const auto value = parseJson(" {\"b\" : [1.50, true, null, \"x\\n\\u00e9\"],\n\t\"a\": {}, \"b\": -0} ");
  REQUIRE(value.has_value());
  REQUIRE(value->kind == Kind::kObject);
  REQUIRE(value->names == std::vector<std::string>{"b", "a", "b"});
  const JsonValue& list = value->elements[0];
  REQUIRE(list.kind == Kind::kList);
  REQUIRE(list.elements.size() == 4);
  CHECK(list.elements[0].number == 1.5);
  CHECK(list.elements[0].text == "1.50");
  CHECK(list.elements[1].flag);
  CHECK(list.elements[2].kind == Kind::kNull);
  CHECK(list.elements[3].text == "x\n\xC3\xA9");
  CHECK(value->elements[1].kind == Kind::kObject);
  CHECK(value->elements[1].elements.empty());
  CHECK(value->elements[2].number == 0);
}

TEST_CASE("texts at the edge of JSON are read or refused as a library does") {
  for (const char* text :
       {"", " ", "0", "-0", "00", "01", "-", "+1", ".5", "5.", "5.e1", "-.5", "1e5", "1E+5", "1e-400", "1e400", "1e", "1e+", "0x1", "1 2", "NaN", "Infinity",
        "true", "truer", "True", "nul", "null", "\"\"", "\"", "\"a", "\"\\\"", "\"\\\\\"", "\"\\/\\b\\f\\n\\r\\t\"", "\"\\x\"", "\"\\u00\"", "\"\\u00e9\"",
        "\"\\u00Eg\"", "\"\\ud83d\\ude00\"", "\"\\ud83d\"", "\"\\ude00\"", "\"\\ud83dx\"", "\"\\ud83d\\n\"", "\"\\u0800\\uffff\"", "\"\\u0000\"", "\"\t\"",
        "\"\xC3\xA9\"", "\"\xC3\"", "\"\xED\xA0\x80\"", "\"\xF0\x9F\x98\x80\"", "\"\x7F\"", "[]", "[ ]", "[1,]", "[,1]", "[1 2]", "[1", "]", "[1]]", "{}", "{ }",
        "{\"a\"}", "{\"a\":}", "{\"a\":1,}", "{a:1}", "{1:1}", "{\"a\":1 \"b\":2}", "{\"a\":1}x", "[1}", "{\"a\":1]", "\xEF\xBB\xBF[1]", "[1]\f", "[tru e]"}) {
    CAPTURE(text);
    CHECK(agree(text));
  }
}

TEST_CASE("random damage to a JSON text is read or refused as a library does") {
  const std::string whole =
      R"({"eye": [10.5, -8e-3, 14], "target": [0, 3, 0], "fovDeg": 35, "on": true, "off": false, "no": null, "na\u00e9\ud83d\ude00me": "a\\b\"c", "in": {"x": [[], {}]}})";
  REQUIRE(parseJson(whole).has_value());
  const std::string_view pieces = "{}[]\",:\\ \n0123456789.-+eEtrufalsn\xC3\xA9";
  std::mt19937 random(7);
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole;
    for (unsigned edits = 1 + random() % 3; edits > 0; --edits) {
      const std::size_t at = random() % text.size();
      const char piece = pieces[random() % pieces.size()];
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 4);
      } else if (random() % 2 == 0) {
        text[at] = piece;
      } else {
        text.insert(at, 1, piece);
      }
    }
    CAPTURE(text);
    REQUIRE(agree(text));
    if (parseJson(text)) ++read;
  }
  CHECK(read > 500);
}

TEST_CASE("a text that is nested without end is refused") {
  CHECK(parseJson(std::string(40, '[') + std::string(40, ']')).has_value());
  CHECK_FALSE(parseJson(std::string(1000000, '[')).has_value());
}

}  // namespace
}  // namespace dimline
