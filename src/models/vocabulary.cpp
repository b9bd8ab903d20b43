#include "models/vocabulary.h"

namespace dimline {

namespace {

Parameter parameter(ParameterType type, Unit unit, std::string_view name, std::string_view title, const ParameterRange& range,
                    const ParameterWords& words) {
  Parameter p;
  p.name = name;
  p.title = title;
  p.type = type;
  p.unit = unit;
  p.defaultValue = range.value;
  p.min = range.min;
  p.max = range.max;
  p.step = range.step;
  p.group = words.group;
  p.help = words.help;
  p.annotation = words.annotation;
  return p;
}

Measure measure(Unit unit, std::string_view name, std::string_view title, std::string_view help) {
  Measure m;
  m.shown.name = name;
  m.shown.title = title;
  m.shown.help = help;
  m.shown.unit = unit;
  return m;
}

}  // namespace

Parameter lengthParameter(std::string_view name, std::string_view title, const ParameterRange& range, const ParameterWords& words) {
  return parameter(ParameterType::kFloat, Unit::kMetre, name, title, range, words);
}

Parameter angleParameter(std::string_view name, std::string_view title, const ParameterRange& range, const ParameterWords& words) {
  return parameter(ParameterType::kAngle, Unit::kDegree, name, title, range, words);
}

Parameter countParameter(std::string_view name, std::string_view title, const ParameterRange& range, std::string_view noun, const ParameterWords& words) {
  Parameter p = parameter(ParameterType::kInt, Unit::kNone, name, title, range, words);
  p.noun = noun;
  return p;
}

Measure lengthMeasure(std::string_view name, std::string_view title, std::string_view help, std::string_view annotation) {
  Measure m = measure(Unit::kMetre, name, title, help);
  m.shown.annotation = annotation;
  return m;
}

Measure areaMeasure(std::string_view name, std::string_view title, std::string_view help, std::function<double(const Values&, const Scene&)> value) {
  Measure m = measure(Unit::kSquareMetre, name, title, help);
  m.value = std::move(value);
  return m;
}

Parameter switchParameter(std::string_view name, std::string_view title, bool value, const ParameterWords& words) {
  return parameter(ParameterType::kBool, Unit::kNone, name, title, {value ? 1.0 : 0.0, 0, 1, 1}, words);
}

Parameter choiceParameter(std::string_view name, std::string_view title, int value, std::initializer_list<std::string_view> choices,
                          const ParameterWords& words) {
  const ParameterRange range{static_cast<double>(value), 0, static_cast<double>(choices.size()) - 1, 1};
  Parameter p = parameter(ParameterType::kChoice, Unit::kNone, name, title, range, words);
  p.choices.assign(choices.begin(), choices.end());
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
