#include "models/vocabulary.h"

namespace dimline {

namespace {

Parameter parameter(ParameterType type, Unit unit, std::string name, std::string title, const ParameterRange& range,
                    ParameterWords words) {
  Parameter p;
  p.name = std::move(name);
  p.title = std::move(title);
  p.type = type;
  p.unit = unit;
  p.defaultValue = range.value;
  p.min = range.min;
  p.max = range.max;
  p.step = range.step;
  p.group = std::move(words.group);
  p.help = std::move(words.help);
  p.annotation = std::move(words.annotation);
  return p;
}

}  // namespace

Parameter lengthParameter(std::string name, std::string title, const ParameterRange& range, ParameterWords words) {
  return parameter(ParameterType::kFloat, Unit::kMetre, std::move(name), std::move(title), range, std::move(words));
}

Parameter angleParameter(std::string name, std::string title, const ParameterRange& range, ParameterWords words) {
  return parameter(ParameterType::kAngle, Unit::kDegree, std::move(name), std::move(title), range, std::move(words));
}

Parameter countParameter(std::string name, std::string title, const ParameterRange& range, std::string noun, ParameterWords words) {
  Parameter p = parameter(ParameterType::kInt, Unit::kNone, std::move(name), std::move(title), range, std::move(words));
  p.noun = std::move(noun);
  return p;
}

Measure lengthMeasure(std::string name, std::string title, std::string help, std::string annotation) {
  Measure measure;
  measure.shown = {.name = std::move(name), .title = std::move(title), .help = std::move(help), .unit = Unit::kMetre, .annotation = std::move(annotation)};
  return measure;
}

Measure areaMeasure(std::string name, std::string title, std::string help, std::function<double(const Values&, const Scene&)> value) {
  Measure measure;
  measure.shown = {.name = std::move(name), .title = std::move(title), .help = std::move(help), .unit = Unit::kSquareMetre};
  measure.value = std::move(value);
  return measure;
}

Parameter switchParameter(std::string name, std::string title, bool value, ParameterWords words) {
  return parameter(ParameterType::kBool, Unit::kNone, std::move(name), std::move(title), {value ? 1.0 : 0.0, 0, 1, 1}, std::move(words));
}

Parameter choiceParameter(std::string name, std::string title, int value, std::vector<std::string> choices, ParameterWords words) {
  const ParameterRange range{static_cast<double>(value), 0, static_cast<double>(choices.size()) - 1, 1};
  Parameter p = parameter(ParameterType::kChoice, Unit::kNone, std::move(name), std::move(title), range, std::move(words));
  p.choices = std::move(choices);
  return p;
}

MaterialId paint(Builder& b, std::uint32_t srgb, float roughness, Material::Pattern pattern) {
  Material m;
  m.color = linearFromSrgb(srgb);
  m.roughness = roughness;
  m.pattern = pattern;
  return b.addMaterial(m);
}

void nameBox(Builder& b, std::string_view name, const Vec3& minM, const Vec3& maxM) {
  b.push([&] {
    b.translate(minM);
    b.scale(maxM - minM);
    b.name(name);
  });
}

}  // namespace dimline
