#include "app/json.h"
#include "app/json_value.h"
#include "core/text.h"

namespace dimline {

namespace {

using Kind = JsonValue::Kind;

Result<JsonValue> parse(std::string_view text, std::string_view what) {
  auto parsed = parseJson(text);
  if (!parsed) return Error{std::string(what) + " is not valid JSON: " + inQuotes(text) + "."};
  return std::move(*parsed);
}

/// The value as a person would have written it, for messages.
std::string shown(const JsonValue& value) {
  if (value.kind == Kind::kText) return inQuotes(value.text);
  if (value.kind == Kind::kList) return "a list";
  return value.kind == Kind::kObject ? "an object" : value.text.substr(0, kRecognisable);
}

Result<double> valueFrom(const Parameter& parameter, const JsonValue& value) {
  switch (parameter.type) {
    case ParameterType::kBool:
      if (value.kind == Kind::kBool) return value.flag ? 1.0 : 0.0;
      return Error{parameter.name + " is a switch: it takes true or false, not " + shown(value) + "."};
    case ParameterType::kChoice:
      if (value.kind == Kind::kText) return parseValue(parameter, value.text);
      return Error{parameter.name + " is a choice: it takes one of its names as a text, not " + shown(value) + "."};
    case ParameterType::kFloat:
    case ParameterType::kInt:
    case ParameterType::kAngle:
      break;
  }
  if (value.kind != Kind::kNumber) return Error{parameter.name + " takes a number, not " + shown(value) + "."};
  return clampValue(parameter, value.number);
}

Result<double> readNumber(const JsonValue& value, std::string_view field) {
  if (value.kind != Kind::kNumber) return Error{std::string(field) + " must be a finite number, not " + shown(value) + "."};
  return value.number;
}

Result<Vec3> readVec3(const JsonValue& value, std::string_view field) {
  const std::string wanted = std::string(field) + " must be a list of three finite numbers, as in [1, 2, 3]";
  if (value.kind != Kind::kList || value.elements.size() != 3) return Error{wanted + ", not " + shown(value) + "."};
  Vec3 v{0.0};
  for (int i = 0; i < 3; ++i) {
    const JsonValue& part = value.elements[static_cast<std::size_t>(i)];
    if (part.kind != Kind::kNumber) return Error{wanted + "."};
    v[i] = part.number;
  }
  return v;
}

Result<Camera> cameraFrom(const JsonValue& value) {
  if (value.kind != Kind::kObject) {
    return Error{"A camera is an object such as {\"eye\": [10, 8, 14], \"target\": [0, 3, 0], \"fovDeg\": 35}, not " +
                 shown(value) + "."};
  }
  Camera camera;
  bool hasEye = false;
  bool hasTarget = false;
  bool hasFov = false;
  bool hasHeight = false;
  for (std::size_t i = 0; i < value.elements.size(); ++i) {
    const std::string& key = value.names[i];
    const JsonValue& field = value.elements[i];
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
        hasFov = true;
      } else {
        camera.orthoHeightM = *number;
        hasHeight = true;
      }
    } else {
      return Error{"A camera has eye, target, up, and fovDeg or orthoHeight; " + inQuotes(key) + " is none of these."};
    }
  }
  if (!hasEye || !hasTarget) return Error{std::string("The camera's ") + (hasEye ? "target" : "eye") + " is missing."};
  if (hasFov && hasHeight) {
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
  if (parsed->kind != Kind::kObject)
    return Error{"Parameters are set by an object such as {\"Width\": 9}, not by " + shown(*parsed) + "."};
  std::vector<std::pair<std::size_t, double>> changes;
  for (std::size_t i = 0; i < parsed->elements.size(); ++i) {
    const std::string& name = parsed->names[i];
    const auto index = findParameter(parameters, name);
    if (!index) {
      std::vector<std::string_view> names;
      for (const Parameter& parameter : parameters) names.push_back(parameter.name);
      return Error{"There is no parameter " + inQuotes(name) + "; this model has " + joined(names) + "."};
    }
    const auto number = valueFrom(parameters[*index], parsed->elements[i]);
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
  if (parsed->kind != Kind::kList) return Error{"Cameras come as a list, [{\"eye\": …}, …], not as " + shown(*parsed) + "."};
  std::vector<Camera> cameras;
  for (const JsonValue& entry : parsed->elements) {
    const auto camera = cameraFrom(entry);
    if (!camera)
      return Error{"Camera " + std::to_string(cameras.size()) + " (counted from 0): " + camera.error().message};
    cameras.push_back(*camera);
  }
  return cameras;
}

}  // namespace dimline
