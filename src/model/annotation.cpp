#include "model/annotation.h"

#include <cmath>
#include <span>

#include "core/text.h"
#include "model/annotation_scanner.h"

// Reading an annotation takes two steps. The scanner knows the punctuation only and gives a list of entries, NAME or
// NAME=VALUE, each with its place; what it cannot read is an Error. `Interpreter` knows the properties; what it does
// not know is a warning. Some properties say half of something (type=linear with reference=center, in any order), so
// the halves are kept until all entries are read.
//
// Words are compared by a key without case, `-` and `_`: topLeft, top-left and TOP_LEFT are one word.

namespace dimline {

namespace {

template <typename T>
struct Named {
  std::string_view name;
  T value;
};

/// The names that messages list come first; `aliases` are read but not advertised.
template <typename T>
struct Vocabulary {
  std::span<const Named<T>> names;
  std::span<const Named<T>> aliases;
};

constexpr Named<HandleType> kTypes[] = {{"linear-contour", HandleType::kLinearContour},
                                        {"linear-center", HandleType::kLinearCenter},
                                        {"diametric", HandleType::kDiametric},
                                        {"radial", HandleType::kRadial},
                                        {"spherical-diametric", HandleType::kSphericalDiametric},
                                        {"spherical-radial", HandleType::kSphericalRadial},
                                        {"angular", HandleType::kAngular},
                                        {"boolean", HandleType::kBoolean},
                                        {"range", HandleType::kRange}};
constexpr Named<HandleType> kTypeAliases[] = {{"toggle", HandleType::kBoolean}, {"selector", HandleType::kRange}};

constexpr Named<HandleType> kReferences[] = {
    {"edges", HandleType::kLinearContour}, {"center", HandleType::kLinearCenter}, {"radial", HandleType::kRadial}};

constexpr Named<Orient> kOrients[] = {{"up", Orient::kUp},
                                      {"down", Orient::kDown},
                                      {"left", Orient::kLeft},
                                      {"right", Orient::kRight},
                                      {"front", Orient::kFront},
                                      {"back", Orient::kBack},
                                      {"horizontal", Orient::kHorizontal},
                                      {"vertical", Orient::kVertical}};
constexpr Named<Orient> kAxes[] = {{"x", Orient::kRight}, {"y", Orient::kUp}, {"z", Orient::kFront}};

constexpr Named<Slip> kSlips[] = {
    {"scope", Slip::kScope}, {"object", Slip::kObject}, {"billboard", Slip::kBillboard}, {"none", Slip::kNone}};
constexpr Named<Slip> kSlipAliases[] = {{"screen", Slip::kBillboard}, {"inside", Slip::kNone}};

constexpr Named<Align> kAligns[] = {{"none", Align::kNone},
                                    {"top", Align::kTop},
                                    {"bottom", Align::kBottom},
                                    {"left", Align::kLeft},
                                    {"right", Align::kRight},
                                    {"top-left", Align::kTopLeft},
                                    {"top-right", Align::kTopRight},
                                    {"bottom-left", Align::kBottomLeft},
                                    {"bottom-right", Align::kBottomRight}};
constexpr Named<Align> kAlignAliases[] = {{"default", Align::kNone}};

constexpr Named<HandleEnds> kEndWords[] = {{"end", HandleEnds::kEnd}, {"both", HandleEnds::kBoth}};

enum class SkinWord { kArrow, kSphere, kDiameterArrow };
constexpr Named<SkinWord> kSkins[] = {{"arrow", SkinWord::kArrow}, {"sphere", SkinWord::kSphere}};
constexpr Named<SkinWord> kSkinAliases[] = {{"diameterArrow", SkinWord::kDiameterArrow}};

constexpr Named<bool> kRepeats[] = {{"chain", true}, {"none", false}};

constexpr Named<bool> kFlags[] = {{"true", true}, {"false", false}};
constexpr Named<bool> kFlagAliases[] = {{"on", true}, {"off", false}, {"yes", true}, {"no", false}};

enum class Property {
  kScope,
  kType,
  kReference,
  kOrient,
  kSlip,
  kAlign,
  kChained,
  kRepeat,
  kIndirect,
  kEnds,
  kMinLength,
  kOcclusion,
  kSkin,
  kColor,
  kTranslate
};
constexpr Named<Property> kProperties[] = {
    {"scope", Property::kScope},         {"type", Property::kType},   {"orient", Property::kOrient},
    {"slip", Property::kSlip},           {"align", Property::kAlign}, {"chained", Property::kChained},
    {"indirect", Property::kIndirect},   {"ends", Property::kEnds},   {"min-length", Property::kMinLength},
    {"occlusion", Property::kOcclusion}, {"skin", Property::kSkin},   {"color", Property::kColor},
    {"translate", Property::kTranslate}};
constexpr Named<Property> kPropertyAliases[] = {{"shape", Property::kScope},
                                                {"reference", Property::kReference},
                                                {"axis", Property::kOrient},
                                                {"repeat", Property::kRepeat},
                                                {"minPixels", Property::kMinLength}};

constexpr Vocabulary<Property> kPropertyWords{kProperties, kPropertyAliases};

std::string keyOf(std::string_view word) {
  std::string key;
  for (const char c : word) {
    // Within a word only: in front it is a sign, and -x is not x.
    if ((c == '-' && !key.empty()) || c == '_') continue;
    key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return key;
}

template <typename T>
std::optional<T> find(const Vocabulary<T>& words, std::string_view word) {
  const std::string key = keyOf(word);
  for (const auto& list : {words.names, words.aliases}) {
    for (const Named<T>& named : list) {
      if (keyOf(named.name) == key) return named.value;
    }
  }
  return std::nullopt;
}

template <typename T>
std::string listed(std::span<const Named<T>> names) {
  std::vector<std::string_view> words;
  for (const Named<T>& named : names) words.push_back(named.name);
  return joined(words, "or");
}

template <typename T>
std::string_view nameIn(std::span<const Named<T>> names, T value) {
  for (const Named<T>& named : names) {
    if (named.value == value) return named.name;
  }
  return "";
}

using Entry = AnnotationEntry;
using Kind = AnnotationEntry::Kind;

class Interpreter {
public:
  Result<ParsedAnnotation> interpret(std::span<const Entry> entries) {
    for (const Entry& entry : entries) {
      const auto property = find(kPropertyWords, entry.name);
      if (!property) {
        warn(entry.namePlace,
             inQuotes(entry.name) + " is no property and is left out; there are " + joinedProperties() + ".");
        continue;
      }
      if (isRepeated(*property)) {
        warn(entry.namePlace, std::string(entry.name) + " says again what was said before, and is left out.");
        continue;
      }
      if (*property == Property::kScope) {
        if (Status status = readScope(entry); !status) return status.error();
      } else {
        read(*property, entry);
      }
    }
    if (out().scope.empty()) {
      // A word that was taken for a property may have been meant as the scope.
      const std::string leftOut = parsed_.warnings.empty() ? "" : " " + parsed_.warnings.front();
      return Error{messageStart({}) + "the annotation names no scope; add scope=NAME, the name of the boxes that it measures." + leftOut};
    }
    combineType();
    combineOrient();
    if (diameterArrow_ && !endsGiven_) out().ends = HandleEnds::kBoth;
    return std::move(parsed_);
  }

private:
  Annotation& out() { return parsed_.annotation; }
  void warn(const TextPlace& place, const std::string& message) {
    parsed_.warnings.push_back(messageStart(place) + message);
  }

  static std::string joinedProperties() {
    std::vector<std::string_view> words;
    for (const auto& named : kProperties) words.push_back(named.name);
    return joined(words);
  }

  /// Whether this property was there before; chained and repeat are two spellings of one.
  bool isRepeated(Property property) {
    if (property == Property::kRepeat) property = Property::kChained;
    bool& seen = seen_[static_cast<std::size_t>(property)];
    const bool before = seen;
    seen = true;
    return before;
  }

  Status readScope(const Entry& entry) {
    std::string_view scope = entry.value;
    if (entry.kind == Kind::kBraces) return Error{messageStart(entry.valuePlace) + "a scope's name has no braces."};
    if (entry.kind == Kind::kWord) {
      // NAME^2 counts shapes up the shape tree elsewhere; here every scope has one name.
      if (const std::size_t caret = scope.find('^'); caret != std::string_view::npos) {
        const std::string_view count = scope.substr(caret + 1);
        if (count.empty() || count.find_first_not_of("0123456789") != std::string_view::npos) {
          return Error{messageStart(entry.valuePlace) + "after the ^ of " + inQuotes(scope) +
                       " a whole number is expected."};
        }
        scope = scope.substr(0, caret);
      }
    }
    scope = trim(scope);
    if (scope.empty())
      return Error{messageStart(entry.valuePlace) + std::string(entry.name) + " needs a name, as in scope=Window."};
    out().scope = scope;
    return okStatus();
  }

  void read(Property property, const Entry& entry) {
    switch (property) {
      case Property::kScope:
        break;
      case Property::kType:
        readType(entry);
        break;
      case Property::kReference:
        reference_ = readWord<HandleType>(entry, {kReferences, {}});
        referencePlace_ = entry.namePlace;
        break;
      case Property::kOrient:
        orient_ = readWord<Orient>(entry, {kOrients, kAxes});
        orientEntry_ = entry;
        break;
      case Property::kSlip:
        assign(out().slip, readWord<Slip>(entry, {kSlips, kSlipAliases}));
        break;
      case Property::kAlign:
        assign(out().align, readWord<Align>(entry, {kAligns, kAlignAliases}));
        break;
      case Property::kChained:
        readFlag(entry, out().chained);
        break;
      case Property::kRepeat:
        assign(out().chained, readWord<bool>(entry, {kRepeats, {}}));
        break;
      case Property::kIndirect:
        readFlag(entry, out().indirect);
        break;
      case Property::kEnds:
        endsGiven_ = assign(out().ends, readWord<HandleEnds>(entry, {kEndWords, {}}));
        break;
      case Property::kMinLength:
        readMinLength(entry);
        break;
      case Property::kOcclusion:
        readFlag(entry, out().occlusion);
        break;
      case Property::kSkin:
        readSkin(entry);
        break;
      case Property::kColor:
        readColor(entry);
        break;
      case Property::kTranslate:
        readTranslate(entry);
        break;
    }
  }

  template <typename T>
  static bool assign(T& target, const std::optional<T>& value) {
    if (value) target = *value;
    return value.has_value();
  }

  void warnOfValue(const Entry& entry, const std::string& wanted) {
    const std::string name(entry.name);
    if (entry.kind == Kind::kNoValue) {
      warn(entry.namePlace, name + " has no value and is left out; it takes " + wanted + ".");
    } else {
      const std::string shown =
          entry.kind == Kind::kBraces ? inQuotes("{" + std::string(entry.value) + "}") : inQuotes(entry.value);
      warn(entry.valuePlace, name + " cannot be " + shown + " and is left out; it takes " + wanted + ".");
    }
  }

  template <typename T>
  std::optional<T> readWord(const Entry& entry, const Vocabulary<T>& words) {
    if (entry.kind == Kind::kWord || entry.kind == Kind::kString) {
      if (const auto value = find(words, trim(entry.value))) return value;
    }
    warnOfValue(entry, listed(words.names));
    return std::nullopt;
  }

  void readFlag(const Entry& entry, bool& flag) {
    if (entry.kind == Kind::kNoValue) {
      flag = true;
    } else {
      assign(flag, readWord<bool>(entry, {kFlags, kFlagAliases}));
    }
  }

  void readType(const Entry& entry) {
    // "linear" leaves the rest to the reference, whose default is the edges.
    if (entry.kind != Kind::kNoValue && entry.kind != Kind::kBraces && keyOf(trim(entry.value)) == "linear") return;
    type_ = readWord<HandleType>(entry, {kTypes, kTypeAliases});
  }

  void readSkin(const Entry& entry) {
    const auto skin = readWord<SkinWord>(entry, {kSkins, kSkinAliases});
    if (!skin) return;
    diameterArrow_ = *skin == SkinWord::kDiameterArrow;
    out().skin = *skin == SkinWord::kSphere ? HandleSkin::kSphere : HandleSkin::kArrow;
  }

  void readMinLength(const Entry& entry) {
    std::string_view text = trim(entry.value);
    if (text.ends_with("px")) text = trim(text.substr(0, text.size() - 2));
    const auto number = entry.kind == Kind::kBraces ? std::nullopt : parseDouble(text);
    if (number && *number >= 0) {
      out().minLengthPx = *number;
    } else {
      warnOfValue(entry, "a number of pixels, 0 or more");
    }
  }

  void readColor(const Entry& entry) {
    const std::string_view text = trim(entry.value);
    std::array<std::uint8_t, 3> color{};
    bool good = entry.kind != Kind::kBraces && text.size() == 7 && text[0] == '#';
    for (std::size_t i = 1; good && i < 7; ++i) {
      const char c = text[i];
      int digit = -1;
      if (c >= '0' && c <= '9') digit = c - '0';
      if (c >= 'a' && c <= 'f') digit = c - 'a' + 10;
      if (c >= 'A' && c <= 'F') digit = c - 'A' + 10;
      good = digit >= 0;
      color[(i - 1) / 2] = static_cast<std::uint8_t>(color[(i - 1) / 2] * 16 + digit);
    }
    if (good) {
      out().color = color;
    } else {
      warnOfValue(entry, "a colour such as #ff8800");
    }
  }

  void readTranslate(const Entry& entry) {
    Vec3 translate(0.0);
    int count = 0;
    bool good = entry.kind == Kind::kBraces;
    std::string_view rest = entry.value;
    while (good) {
      const std::size_t comma = rest.find(',');
      const auto number = parseDouble(trim(rest.substr(0, comma)));
      good = number.has_value() && count < 3;
      if (good) translate[count++] = *number;
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (good && count == 3) {
      out().translate = translate;
    } else {
      warnOfValue(entry, "three numbers in braces, such as {0,0.5,0}");
    }
  }

  void combineType() {
    if (type_ && reference_) {
      warn(referencePlace_, "reference goes with type=linear only and is left out.");
      reference_.reset();
    }
    out().type = type_.value_or(reference_.value_or(HandleType::kLinearContour));
  }

  void combineOrient() {
    const bool spherical = isSpherical(out().type);
    out().orient = spherical ? Orient::kHorizontal : Orient::kUp;
    if (!orient_) return;
    const bool onScreen = *orient_ == Orient::kHorizontal || *orient_ == Orient::kVertical;
    if (spherical == onScreen) {
      out().orient = *orient_;
    } else if (spherical) {
      warnOfValue(orientEntry_, "horizontal or vertical with a spherical type");
    } else {
      warnOfValue(orientEntry_, "up, down, left, right, front or back with this type");
    }
  }

  ParsedAnnotation parsed_;
  std::array<bool, static_cast<std::size_t>(Property::kTranslate) + 1> seen_{};
  std::optional<HandleType> type_, reference_;
  std::optional<Orient> orient_;
  Entry orientEntry_;
  TextPlace referencePlace_;
  bool diameterArrow_ = false;
  bool endsGiven_ = false;
};

}  // namespace

Result<ParsedAnnotation> parseAnnotation(std::string_view text) {
  const auto entries = scanAnnotation(text);
  if (!entries) return entries.error();
  return Interpreter().interpret(*entries);
}

std::string_view name(HandleType type) {
  return nameIn<HandleType>(kTypes, type);
}
std::string_view name(Orient orient) {
  return nameIn<Orient>(kOrients, orient);
}
std::string_view name(Slip slip) {
  return nameIn<Slip>(kSlips, slip);
}
std::string_view name(Align align) {
  return nameIn<Align>(kAligns, align);
}

bool isLine(HandleType type) {
  return type != HandleType::kAngular && type != HandleType::kBoolean && type != HandleType::kRange;
}

bool isLinear(HandleType type) { return type == HandleType::kLinearContour || type == HandleType::kLinearCenter; }

bool isSpherical(HandleType type) {
  return type == HandleType::kSphericalDiametric || type == HandleType::kSphericalRadial;
}

AxisSense axisOf(Orient orient) {
  switch (orient) {
    case Orient::kUp:
      return {1, 1.0};
    case Orient::kDown:
      return {1, -1.0};
    case Orient::kLeft:
      return {0, -1.0};
    case Orient::kRight:
      return {0, 1.0};
    case Orient::kFront:
      return {2, 1.0};
    case Orient::kBack:
      return {2, -1.0};
    case Orient::kHorizontal:
    case Orient::kVertical:
      break;
  }
  return {-1, 0.0};
}

}  // namespace dimline
