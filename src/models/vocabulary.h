#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>

#include "model/builder.h"
#include "model/model.h"

// Short ways to write down what every built-in model has: parameters with their words, and materials. Inner header of
// the models.

namespace dimline {

struct ParameterRange {
  double value, min, max, step;
};

/// What people read about a parameter, and how its handle behaves.
struct ParameterWords {
  std::string_view group, help, annotation;
};

Parameter lengthParameter(std::string_view name, std::string_view title, const ParameterRange& range, const ParameterWords& words);
/// Degrees.
Parameter angleParameter(std::string_view name, std::string_view title, const ParameterRange& range, const ParameterWords& words);
/// `noun`: what is counted, in the singular.
Parameter countParameter(std::string_view name, std::string_view title, const ParameterRange& range, std::string_view noun, const ParameterWords& words);
Parameter switchParameter(std::string_view name, std::string_view title, bool value, const ParameterWords& words);
Parameter choiceParameter(std::string_view name, std::string_view title, int value, std::initializer_list<std::string_view> choices,
                          const ParameterWords& words);

/// Lengths that follow from the parameters, and areas, which have no line of their own.
Measure lengthMeasure(std::string_view name, std::string_view title, std::string_view help, std::string_view annotation);
Measure areaMeasure(std::string_view name, std::string_view title, std::string_view help, std::function<double(const Values&, const Scene&)> value);

/// A material in the colour 0xRRGGBB.
MaterialId paint(Builder& b, std::uint32_t srgb, float roughness, Material::Pattern pattern = Material::Pattern::kPlain);

/// Names a box between two corners of the current scope (m from its origin).
void nameBox(Builder& b, std::string_view name, const Vec3& minM, const Vec3& maxM);

}  // namespace dimline
