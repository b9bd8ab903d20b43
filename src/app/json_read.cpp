#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

#include "app/json.h"
#include "core/text.h"

// nlohmann::json parses here without exceptions, and every access checks the type first.

namespace dimline {

namespace {

using nlohmann::json;

/// Goes through a text and tells how far it was read.
struct Reader {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  pointer at;
  pointer* read;

  char operator*() const { return *at; }
  Reader& operator++() {
    *read = ++at;
    return *this;
  }
  bool operator==(const Reader& other) const { return at == other.at; }
};

Result<json> parse(std::string_view text, std::string_view what) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const char* read = begin;
  json parsed = json::parse(Reader{begin, &read}, Reader{end, &read}, nullptr, false);
  if (!parsed.is_discarded()) return parsed;
  const std::string isNot = std::string(what) + " is not valid JSON";
  if (read == begin) return Error{isNot + ": there is no text."};
  const char* const wrong = read - 1;   // nothing could be made of what was read last
  const auto line = 1 + std::count(begin, wrong, '\n');
  const auto lineBegin = std::find(std::reverse_iterator(wrong), std::reverse_iterator(begin), '\n').base();
  const std::string_view untilThere(lineBegin, read);
  const auto shown = untilThere.substr(untilThere.size() - std::min(untilThere.size(), kRecognisable));
  return Error{isNot + " at line " + std::to_string(line) + ", column " + std::to_string(untilThere.size()) + ", the end of " + inQuotes(shown) + "."};
}

/// The value as a person would have written it, for messages.
std::string shown(const json& value) {
  if (value.is_string()) return inQuotes(value.get_ref<const std::string&>());
  if (value.is_structured()) return value.is_array() ? "a list" : "an object";
  return value.dump();
}

Result<double> valueFrom(const Parameter& parameter, const json& value) {
  switch (parameter.type) {
    case ParameterType::kBool:
      if (value.is_boolean()) return value.get<bool>() ? 1.0 : 0.0;
      return Error{parameter.name + " is a switch: it takes true or false, not " + shown(value) + "."};
    case ParameterType::kChoice:
      if (value.is_string()) return parseValue(parameter, value.get_ref<const std::string&>());
      return Error{parameter.name + " is a choice: it takes one of its names as a text, not " + shown(value) + "."};
    case ParameterType::kFloat:
    case ParameterType::kInt:
    case ParameterType::kAngle:
      break;
  }
  if (!value.is_number()) return Error{parameter.name + " takes a number, not " + shown(value) + "."};
  const double number = value.get<double>();
  if (!std::isfinite(number)) return Error{parameter.name + " takes a finite number."};
  return clampValue(parameter, number);
}

Result<double> readNumber(const json& value, std::string_view field) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    return Error{std::string(field) + " must be a finite number, not " + shown(value) + "."};
  }
  return value.get<double>();
}

Result<Vec3> readVec3(const json& value, std::string_view field) {
  const std::string wanted = std::string(field) + " must be a list of three finite numbers, as in [1, 2, 3]";
  if (!value.is_array()) return Error{wanted + ", not " + shown(value) + "."};
  if (value.size() != 3) return Error{wanted + "."};
  Vec3 v{0.0};
  for (int i = 0; i < 3; ++i) {
    const json& part = value[static_cast<std::size_t>(i)];
    if (!part.is_number() || !std::isfinite(part.get<double>())) return Error{wanted + "."};
    v[i] = part.get<double>();
  }
  return v;
}

Result<Camera> cameraFrom(const json& value) {
  if (!value.is_object()) {
    return Error{"A camera is an object such as {\"eye\": [10, 8, 14], \"target\": [0, 3, 0], \"fovDeg\": 35}, not " +
                 shown(value) + "."};
  }
  Camera camera;
  bool hasEye = false;
  bool hasTarget = false;
  for (const auto& [key, field] : value.items()) {
    const std::string name = "The camera's " + key;
    if (key == "eye" || key == "target" || key == "up") {
      const auto v = readVec3(field, name);
      if (!v) return v.error();
      (key == "eye" ? camera.eye : key == "target" ? camera.target : camera.up) = *v;
      hasEye = hasEye || key == "eye";
      hasTarget = hasTarget || key == "target";
    } else if (key == "fovDeg" || key == "orthoHeight") {
      const auto number = readNumber(field, name);
      if (!number) return number.error();
      if (key == "fovDeg") {
        camera.fovRad = *number * kRadPerDeg;
      } else {
        camera.orthoHeightM = *number;
      }
    } else {
      return Error{"A camera has eye, target, up, and fovDeg or orthoHeight; " + inQuotes(key) + " is none of these."};
    }
  }
  if (!hasEye || !hasTarget) return Error{std::string("The camera's ") + (hasEye ? "target" : "eye") + " is missing."};
  if (value.contains("fovDeg") && value.contains("orthoHeight")) {
    return Error{"A camera has fovDeg (perspective) or orthoHeight (orthographic), not both."};
  }
  if (Status status = validate(camera); !status) return status.error();
  return camera;
}

}  // namespace

Result<double> readValue(const Parameter& parameter, std::string_view text) {
  const auto parsed = parse(text, "The value of " + parameter.name);
  if (!parsed) return parsed.error();
  return valueFrom(parameter, *parsed);
}

Result<std::vector<std::pair<std::size_t, double>>> readValues(std::span<const Parameter> parameters,
                                                               std::string_view text) {
  const auto parsed = parse(text, "The list of parameters");
  if (!parsed) return parsed.error();
  if (!parsed->is_object())
    return Error{"Parameters are set by an object such as {\"Width\": 9}, not by " + shown(*parsed) + "."};
  std::vector<std::pair<std::size_t, double>> changes;
  for (const auto& [name, value] : parsed->items()) {
    const auto index = findParameter(parameters, name);
    if (!index) {
      const std::string instead = parameters.empty() ? "no model is shown yet" : "this model has " + namesOf(parameters);
      return Error{"There is no parameter " + inQuotes(name) + "; " + instead + "."};
    }
    const auto number = valueFrom(parameters[*index], value);
    if (!number) return number.error();
    changes.emplace_back(*index, *number);
  }
  return changes;
}

Result<Camera> readCamera(std::string_view text) {
  const auto parsed = parse(text, "The camera");
  if (!parsed) return parsed.error();
  return cameraFrom(*parsed);
}

Result<std::vector<Camera>> readCameras(std::string_view text) {
  const auto parsed = parse(text, "The list of cameras");
  if (!parsed) return parsed.error();
  if (!parsed->is_array()) return Error{"Cameras come as a list, [{\"eye\": …}, …], not as " + shown(*parsed) + "."};
  std::vector<Camera> cameras;
  for (const json& entry : *parsed) {
    const auto camera = cameraFrom(entry);
    if (!camera)
      return Error{"Camera " + std::to_string(cameras.size()) + " (counted from 0): " + camera.error().message};
    cameras.push_back(*camera);
  }
  return cameras;
}

}  // namespace dimline
