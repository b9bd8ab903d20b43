#include "model/annotation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <catch2/catch.hpp>

namespace dimline {
namespace {

/// The annotation of a text that must be without fault.
Annotation clean(std::string_view text) {
  INFO(text);
  auto parsed = parseAnnotation(text);
  if (!parsed.ok()) FAIL(parsed.error().message);
  for (const std::string& warning : parsed->warnings) FAIL(warning);
  return parsed->annotation;
}

/// The annotation of a text that must give exactly one warning, which must hold these words.
Annotation warned(std::string_view text, std::string_view words) {
  INFO(text);
  auto parsed = parseAnnotation(text);
  if (!parsed.ok()) FAIL(parsed.error().message);
  REQUIRE(parsed->warnings.size() == 1);
  INFO(parsed->warnings[0]);
  CHECK(parsed->warnings[0].find(words) != std::string::npos);
  return parsed->annotation;
}

std::string errorOf(std::string_view text) {
  auto parsed = parseAnnotation(text);
  return parsed.ok() ? "(no error)" : parsed.error().message;
}

bool isValidUtf8(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = byte < 0x80 ? 1 : byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC2 ? 2 : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

TEST_CASE("an annotation with nothing but a scope has the documented defaults") {
  const Annotation a = clean("@Handle(scope=Window)");
  CHECK(a.scope == "Window");
  CHECK(a.type == HandleType::kLinearContour);
  CHECK(a.orient == Orient::kUp);
  CHECK(a.slip == Slip::kScope);
  CHECK(a.align == Align::kNone);
  CHECK_FALSE(a.chained);
  CHECK_FALSE(a.indirect);
  CHECK(a.ends == HandleEnds::kEnd);
  CHECK(a.minLengthPx == 0);
  CHECK(a.occlusion);
  CHECK(a.skin == HandleSkin::kArrow);
  CHECK_FALSE(a.color.has_value());
  CHECK(a.translate == Vec3(0.0));
}

TEST_CASE("the example of the design reads as it says") {
  const Annotation a = clean("@Handle(scope=Window, type=linear-contour, orient=up, slip=object, align=left, chained)");
  CHECK(a.scope == "Window");
  CHECK(a.type == HandleType::kLinearContour);
  CHECK(a.orient == Orient::kUp);
  CHECK(a.slip == Slip::kObject);
  CHECK(a.align == Align::kLeft);
  CHECK(a.chained);
}

TEST_CASE("every type, orientation, slip and alignment reads back under its own name") {
  for (int i = 0; i <= static_cast<int>(HandleType::kRange); ++i) {
    const auto type = static_cast<HandleType>(i);
    CHECK(clean("@Handle(scope=S, type=" + std::string(name(type)) + ")").type == type);
  }
  for (int i = 0; i <= static_cast<int>(Orient::kVertical); ++i) {
    const auto orient = static_cast<Orient>(i);
    const std::string type = orient >= Orient::kHorizontal ? "spherical-radial" : "linear-center";
    CHECK(clean("@Handle(scope=S, type=" + type + ", orient=" + std::string(name(orient)) + ")").orient == orient);
  }
  for (int i = 0; i <= static_cast<int>(Slip::kNone); ++i) {
    const auto slip = static_cast<Slip>(i);
    CHECK(clean("@Handle(scope=S, slip=" + std::string(name(slip)) + ")").slip == slip);
  }
  for (int i = 0; i <= static_cast<int>(Align::kBottomRight); ++i) {
    const auto align = static_cast<Align>(i);
    CHECK(clean("@Handle(scope=S, align=" + std::string(name(align)) + ")").align == align);
  }
}

TEST_CASE("the remaining properties read their values") {
  const Annotation a = clean(
      "@Handle(scope=S, indirect, ends=both, min-length=24.5, occlusion=false, skin=sphere, color=#12aBfF, "
      "translate={0.5, -1,1e-1})");
  CHECK(a.indirect);
  CHECK(a.ends == HandleEnds::kBoth);
  CHECK(a.minLengthPx == 24.5);
  CHECK_FALSE(a.occlusion);
  CHECK(a.skin == HandleSkin::kSphere);
  REQUIRE(a.color.has_value());
  CHECK(*a.color == std::array<std::uint8_t, 3>{0x12, 0xab, 0xff});
  CHECK(a.translate == Vec3(0.5, -1, 0.1));
}

TEST_CASE("the spellings that authors know from elsewhere are read") {
  CHECK(clean("@Handle(shape=Window)").scope == "Window");
  CHECK(clean("@Handle(scope=Window^2)").scope == "Window");
  CHECK(clean("@Handle(scope=\"Front door\")").scope == "Front door");
  CHECK(clean("@Handle(scope=\"x^2\")").scope == "x^2");

  CHECK(clean("@Handle(scope=S, type=linear)").type == HandleType::kLinearContour);
  CHECK(clean("@Handle(scope=S, type=linear, reference=edges)").type == HandleType::kLinearContour);
  CHECK(clean("@Handle(scope=S, type=linear, reference=center)").type == HandleType::kLinearCenter);
  CHECK(clean("@Handle(scope=S, reference=radial, type=linear)").type == HandleType::kRadial);
  CHECK(clean("@Handle(scope=S, reference=center)").type == HandleType::kLinearCenter);
  CHECK(clean("@Handle(scope=S, type=toggle)").type == HandleType::kBoolean);
  CHECK(clean("@Handle(scope=S, type=selector)").type == HandleType::kRange);

  CHECK(clean("@Handle(scope=S, axis=x)").orient == Orient::kRight);
  CHECK(clean("@Handle(scope=S, axis=y)").orient == Orient::kUp);
  CHECK(clean("@Handle(scope=S, axis=z)").orient == Orient::kFront);

  CHECK(clean("@Handle(scope=S, slip=screen)").slip == Slip::kBillboard);
  CHECK(clean("@Handle(scope=S, slip=inside)").slip == Slip::kNone);

  CHECK(clean("@Handle(scope=S, align=topLeft)").align == Align::kTopLeft);
  CHECK(clean("@Handle(scope=S, align=bottomRight)").align == Align::kBottomRight);
  CHECK(clean("@Handle(scope=S, align=default)").align == Align::kNone);

  CHECK(clean("@Handle(scope=S, repeat=chain)").chained);
  CHECK_FALSE(clean("@Handle(scope=S, repeat=none)").chained);
  CHECK(clean("@Handle(scope=S, skin=diameterArrow)").ends == HandleEnds::kBoth);
  CHECK(clean("@Handle(scope=S, skin=diameterArrow)").skin == HandleSkin::kArrow);
  CHECK(clean("@Handle(scope=S, ends=end, skin=diameterArrow)").ends == HandleEnds::kEnd);
  CHECK(clean("@Handle(scope=S, minPixels=12)").minLengthPx == 12);
  CHECK(clean("@Handle(scope=S, min-length=12px)").minLengthPx == 12);
  CHECK(clean("@Handle(scope=S, color=\"#ff0000\")").color == std::array<std::uint8_t, 3>{255, 0, 0});
}

TEST_CASE("case, space, line ends and a last comma make no difference; the case of a scope's name does") {
  const std::string spread =
      "\n  @handle (\r\n\tScope = Window ,\n    TYPE=LinearCenter,\n  Orient\n=\nDOWN, min_length = 3,\n  "
      "Chained,\n)\n";
  const Annotation a = clean(spread);
  CHECK(a.scope == "Window");
  CHECK(a.type == HandleType::kLinearCenter);
  CHECK(a.orient == Orient::kDown);
  CHECK(a.minLengthPx == 3);
  CHECK(a.chained);
  CHECK(clean("@Handle(scope=window)").scope == "window");
  CHECK(clean("@Handle(scope=W\xC3\xA4nde)").scope == "W\xC3\xA4nde");
}

TEST_CASE("a flag may be written out") {
  CHECK(clean("@Handle(scope=S, chained=true)").chained);
  CHECK(clean("@Handle(scope=S, indirect=on)").indirect);
  CHECK_FALSE(clean("@Handle(scope=S, chained=off)").chained);
  CHECK_FALSE(clean("@Handle(scope=S, occlusion=FALSE)").occlusion);
  CHECK(clean("@Handle(scope=S, occlusion)").occlusion);
}

TEST_CASE("the spherical types lie horizontal unless told, the others point up") {
  CHECK(clean("@Handle(scope=S, type=spherical-diametric)").orient == Orient::kHorizontal);
  CHECK(clean("@Handle(scope=S, orient=vertical, type=spherical-radial)").orient == Orient::kVertical);
  CHECK(warned("@Handle(scope=S, type=spherical-radial, orient=left)", "horizontal or vertical").orient ==
        Orient::kHorizontal);
  CHECK(warned("@Handle(scope=S, orient=vertical)", "up, down, left").orient == Orient::kUp);
}

TEST_CASE("what is unknown is left out with a warning that names the place and what there is") {
  const Annotation a =
      warned("@Handle(scope=S,\n  colour=#ff0000, orient=left)", "line 2, column 3: \"colour\" is no property");
  CHECK_FALSE(a.color.has_value());
  CHECK(a.orient == Orient::kLeft);

  CHECK(warned("@Handle(scope=S, type=move, orient=down)", "linear-contour, linear-center").orient == Orient::kDown);
  CHECK(warned("@Handle(scope=S, slip=around)", "column 23: slip cannot be \"around\"").slip == Slip::kScope);
  CHECK(warned("@Handle(scope=S, align)", "align has no value").align == Align::kNone);
  CHECK(warned("@Handle(scope=S, min-length=-3)", "0 or more").minLengthPx == 0);
  CHECK(warned("@Handle(scope=S, min-length=nan)", "0 or more").minLengthPx == 0);
  CHECK(warned("@Handle(scope=S, min-length=1e999)", "0 or more").minLengthPx == 0);
  CHECK_FALSE(warned("@Handle(scope=S, color=red)", "#ff8800").color.has_value());
  CHECK_FALSE(warned("@Handle(scope=S, color=#ff880)", "#ff8800").color.has_value());
  CHECK_FALSE(warned("@Handle(scope=S, color=#ff88g0)", "#ff8800").color.has_value());
  CHECK(warned("@Handle(scope=S, translate=3)", "three numbers").translate == Vec3(0.0));
  CHECK(warned("@Handle(scope=S, translate={1,2})", "three numbers").translate == Vec3(0.0));
  CHECK(warned("@Handle(scope=S, translate={1,2,3,4})", "three numbers").translate == Vec3(0.0));
  CHECK(warned("@Handle(scope=S, translate={1,,3})", "three numbers").translate == Vec3(0.0));
  CHECK(warned("@Handle(scope=S, translate={})", "three numbers").translate == Vec3(0.0));
  CHECK(warned("@Handle(scope=S, orient={up})", "orient cannot be \"{up}\"").orient == Orient::kUp);
  CHECK(warned("@Handle(scope=S, axis=-x)", "axis cannot be \"-x\"").orient == Orient::kUp);
  CHECK(warned("@Handle(scope=S, chained=maybe)", "true or false").chained == false);
  CHECK(warned("@Handle(scope=S, repeat=grid)", "chain or none").chained == false);
  CHECK(warned("@Handle(scope=S, type=radial, reference=center)", "type=linear only").type == HandleType::kRadial);
}

TEST_CASE("of what is said twice the first counts") {
  CHECK(warned("@Handle(scope=S, orient=left, axis=y)", "axis says again").orient == Orient::kLeft);
  CHECK(warned("@Handle(scope=S, shape=T)", "shape says again").scope == "S");
  CHECK_FALSE(warned("@Handle(scope=S, repeat=none, chained)", "chained says again").chained);
}

TEST_CASE("an error counts lines and characters") {
  CHECK(errorOf("@Handle(scope=W\xC3\xA4nde) x").find("line 1, column 22: nothing may follow") == 0);
  CHECK(errorOf("\r\n\r\n  Handle(scope=S)").find("line 3, column 3: an annotation starts with @Handle(") == 0);
  CHECK(errorOf("@Handle(\r  scope=S").find("line 2, column 10: ") == 0);
}

// Each file in tests/data/annotations: the annotation, a line of three hyphens, and the message that it must give,
// whole: the error, or the only warning after the word "warning: ".
TEST_CASE("the corpus of broken annotations gives the messages that it says") {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(DIMLINE_TEST_DATA_DIR "/annotations")) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 10);
  for (const auto& path : files) {
    INFO(path.filename());
    std::ifstream stream(path, std::ios::binary);
    std::stringstream content;
    content << stream.rdbuf();
    const std::string text = content.str();
    const std::size_t rule = text.rfind("\n---\n");
    REQUIRE(rule != std::string::npos);
    std::string expected = text.substr(rule + 5);
    while (expected.ends_with('\n')) expected.pop_back();

    auto parsed = parseAnnotation(std::string_view(text).substr(0, rule));
    if (expected.starts_with("warning: ")) {
      REQUIRE(parsed.ok());
      REQUIRE(parsed->warnings.size() == 1);
      CHECK(parsed->warnings[0] == expected.substr(9));
    } else {
      REQUIRE_FALSE(parsed.ok());
      CHECK(parsed.error().message == expected);
    }
  }
}

// Any text gives either an annotation that means something or one readable sentence.
TEST_CASE("random damage never gives anything but a value or a readable error") {
  const std::string seeds[] = {
      "@Handle(scope=Window, type=linear-contour, orient=up, slip=object, align=left, chained)",
      "@Handle(shape=Wall^2, type=linear, reference=center, axis=x, skin=diameterArrow, repeat=chain, minPixels=20)",
      "@Handle(\n  scope = \"Front door\",\n  color=#ff8800,\n  translate={0.5, 0, -1e-3},\n  occlusion=false\n)",
      "@Handle(scope=Dome, type=spherical-radial, orient=horizontal, ends=both, min-length=12, indirect)"};
  const std::string_view fragments[] = {"@",     "(",    ")",    "{",        "}",    "=",       ",",
                                        "\"",    "\n",   "^",    "^9",       "1e9",  "-",       "nan",
                                        "scope", "type", "#fff", "\xC3\xA4", "\xFF", "\xE2\x82"};
  std::mt19937 random(20150817);  // std::mt19937 gives the same numbers everywhere; distributions do not
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };

  int values = 0, errors = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = seeds[below(4)];
    for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
      const std::size_t place = below(text.size());
      switch (below(5)) {
        case 0:
          text.erase(place, 1 + below(5));
          break;
        case 1:
          text[place] = static_cast<char>(below(256));
          break;
        case 2:
          text.insert(place, fragments[below(20)]);
          break;
        case 3:
          text.insert(place, text.substr(below(text.size()), below(12)));
          break;
        default:
          text.resize(place);
          break;
      }
    }
    INFO(text);
    auto parsed = parseAnnotation(text);
    if (parsed.ok()) {
      ++values;
      const Annotation& a = parsed->annotation;
      bool good = !a.scope.empty() && std::isfinite(a.minLengthPx) && a.minLengthPx >= 0 &&
                  std::isfinite(a.translate.x + a.translate.y + a.translate.z);
      for (const std::string& warning : parsed->warnings) {
        good = good && warning.starts_with("line ") && warning.ends_with('.') && isValidUtf8(warning);
      }
      if (!good) FAIL("an annotation that means nothing");
    } else {
      ++errors;
      const std::string& message = parsed.error().message;
      INFO(message);
      if (!message.starts_with("line ") || !message.ends_with('.') || message.size() > 300 || !isValidUtf8(message)) {
        FAIL("an error that nobody can read");
      }
    }
  }
  // Both ends must have been reached, or the damage was of one kind only.
  CHECK(values > 2000);
  CHECK(errors > 2000);
}

}  // namespace
}  // namespace dimline
