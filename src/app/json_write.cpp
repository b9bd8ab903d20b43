#include "app/json.h"

namespace dimline {

namespace {

bool isNumber(ParameterType type) { return type != ParameterType::kBool && type != ParameterType::kChoice; }

void writePlane(JsonWriter& json, const PlacedLine& line) {
  const bool none = line.planeKind == PlaneKind::kNone;
  json.key("plane").beginObject();
  json.key("kind").value(name(line.planeKind));
  json.key("point").value(none ? line.base.start : line.plane.point);
  json.key("normal").value(none ? Vec3(0.0) : line.plane.normal);
  json.key("facing").value(name(line.facing));
  json.endObject();
}

void writePolyline(JsonWriter& json, std::span<const Vec2> points) {
  json.beginArray();
  for (const Vec2& p : points) json.value(p);
  json.endArray();
}

void writeHandles(JsonWriter& json, std::span<const Handle> handles) {
  json.key("handles").beginArray();
  for (const Handle& handle : handles) {
    json.beginObject().key("end").value(handle.atEnd ? "end" : "start").key("screen").value(handle.screen).endObject();
  }
  json.endArray();
}

void writeLine(JsonWriter& json, const Model& model, const Scene& scene, const PlacedLine& line) {
  const Parameter& parameter = model.parameters()[line.parameter];
  const Annotation& annotation = *model.annotations[line.parameter];
  json.beginObject();
  json.key("parameter").value(parameter.name);
  json.key("scope").value(annotation.scope);
  json.key("scopeIndex")
      .value(line.scope < scene.scopes.size() ? static_cast<int>(scene.scopes[line.scope].index)
                                              : line.identity.scopeIndex);
  json.key("type").value(name(annotation.type));
  json.key("slip").value(name(annotation.slip));
  json.key("value");
  writeValue(json, parameter, line.value);
  json.key("text").value(line.text);
  json.key("indirect").value(line.indirect);
  json.key("chain");
  line.chain >= 0 ? json.value(line.chain) : json.null();
  json.key("placement").value(name(line.placement));
  writePlane(json, line);
  json.key("base").beginObject().key("world").value(line.base).key("screen").value(line.baseScreen).endObject();
  json.key("line").beginObject().key("world").value(line.line).key("screen").value(line.lineScreen).endObject();
  json.key("extensions").beginArray();
  writePolyline(json, line.extensionStart);
  writePolyline(json, line.extensionEnd);
  json.endArray();
  json.key("label");
  if (line.label) {
    json.beginObject().key("box").value(*line.label).endObject();
  } else {
    json.null();
  }
  writeHandles(json, line.handles);
  json.key("identity").value(identityText(line.identity, model.parameters()));
  json.endObject();
}

void writeOther(JsonWriter& json, const Model& model, const Scene& scene, const PlacedHandle& handle) {
  const Parameter& parameter = model.parameters()[handle.parameter];
  json.beginObject();
  json.key("parameter").value(parameter.name);
  json.key("scope").value(model.annotations[handle.parameter]->scope);
  json.key("scopeIndex")
      .value(handle.scope < scene.scopes.size() ? static_cast<int>(scene.scopes[handle.scope].index)
                                                : handle.identity.scopeIndex);
  json.key("type").value(name(handle.type));
  json.key("value");
  writeValue(json, parameter, handle.value);
  json.key("text").value(handle.text);
  json.key("placement").value(name(handle.placement));
  json.key("anchor").value(handle.anchor);
  json.key("box").value(handle.box);
  writeHandles(json, handle.handles);
  if (handle.type == HandleType::kRange) {
    json.key("options").beginArray();
    for (const RangeOption& option : handle.options) {
      json.beginObject().key("value");
      writeValue(json, parameter, option.value);
      json.key("box").value(option.box).endObject();
    }
    json.endArray();
  }
  json.key("identity").value(identityText(handle.identity, model.parameters()));
  json.endObject();
}

}  // namespace

void writeValue(JsonWriter& json, const Parameter& parameter, double value) {
  if (parameter.type == ParameterType::kBool) {
    json.value(value >= 0.5);
  } else if (parameter.type == ParameterType::kChoice) {
    json.value(parameter.choices[static_cast<std::size_t>(clampValue(parameter, value))]);
  } else {
    json.value(value);
  }
}

void writeParameters(JsonWriter& json, std::span<const Parameter> parameters, const Values& values) {
  json.beginArray();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    json.beginObject();
    json.key("name").value(parameter.name);
    json.key("title").value(parameter.title);
    json.key("help").value(parameter.help);
    json.key("type").value(name(parameter.type));
    json.key("value");
    writeValue(json, parameter, values.at(i));
    json.key("default");
    writeValue(json, parameter, parameter.defaultValue);
    for (const auto& [key, number] :
         {std::pair{"min", parameter.min}, std::pair{"max", parameter.max}, std::pair{"step", parameter.step}}) {
      json.key(key);
      isNumber(parameter.type) ? json.value(number) : json.null();
    }
    json.key("unit").value(name(parameter.unit));
    json.key("choices").beginArray();
    for (const std::string& choice : parameter.choices) json.value(choice);
    json.endArray();
    json.key("group").value(parameter.group);
    json.key("annotation").value(parameter.annotation);
    json.endObject();
  }
  json.endArray();
}

void writeValues(JsonWriter& json, std::span<const Parameter> parameters, const Values& values) {
  json.beginObject();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    json.key(parameters[i].name);
    writeValue(json, parameters[i], values.at(i));
  }
  json.endObject();
}

void writeCamera(JsonWriter& json, const Camera& camera) {
  json.beginObject();
  json.key("eye").value(camera.eye).key("target").value(camera.target).key("up").value(camera.up);
  if (camera.orthoHeightM) {
    json.key("orthoHeight").value(*camera.orthoHeightM);
  } else {
    json.key("fovDeg").value(camera.fovRad * kDegPerRad);
  }
  json.endObject();
}

void writeFrame(JsonWriter& json, const Model& model, const Scene& scene, const Layout& layout) {
  json.beginObject();
  json.key("size").value(Vec2(layout.view.widthPx(), layout.view.heightPx()));
  json.key("view").value(layout.view.viewMatrix());
  json.key("projection").value(layout.view.projectionMatrix());
  // Measures stand last. While they are being put away, the frame drawn last still has some that the model no longer has.
  const auto isMeasure = [&](std::size_t parameter) { return parameter >= model.parameters().size() || model.parameters()[parameter].measure; };
  json.key("lines").beginArray();
  for (const PlacedLine& line : layout.lines) {
    if (!isMeasure(line.parameter)) writeLine(json, model, scene, line);
  }
  json.endArray();
  if (!model.parameters().empty() && isMeasure(model.parameters().size() - 1)) {
    json.key("measures").beginArray();
    for (const PlacedLine& line : layout.lines) {
      if (isMeasure(line.parameter)) writeLine(json, model, scene, line);
    }
    json.endArray();
  }
  json.key("others").beginArray();
  for (const PlacedHandle& handle : layout.others) writeOther(json, model, scene, handle);
  json.endArray();
  json.key("hidden").beginArray();
  for (const HiddenParameter& hidden : layout.hidden) {
    if (isMeasure(hidden.parameter)) continue;
    json.beginObject();
    json.key("parameter").value(model.parameters()[hidden.parameter].name);
    json.key("reason").value(name(hidden.reason));
    json.endObject();
  }
  json.endArray();
  json.key("visible").beginArray();
  for (const std::size_t i : layout.visibleScopes) {
    if (i >= scene.scopes.size()) continue;   // of a scene before, whose successor has not been placed yet
    json.beginArray().value(scene.scopes[i].name).value(static_cast<std::size_t>(scene.scopes[i].index)).endArray();
  }
  json.endArray();
  json.endObject();
}

}  // namespace dimline
