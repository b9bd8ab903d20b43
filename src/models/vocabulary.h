#pragma once

#include <string>

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
  std::string group, help, annotation;
};

Parameter lengthParameter(std::string name, std::string title, const ParameterRange& range, ParameterWords words);
/// Degrees.
Parameter angleParameter(std::string name, std::string title, const ParameterRange& range, ParameterWords words);
/// `noun`: what is counted, in the singular.
Parameter countParameter(std::string name, std::string title, const ParameterRange& range, std::string noun, ParameterWords words);
Parameter switchParameter(std::string name, std::string title, bool value, ParameterWords words);
Parameter choiceParameter(std::string name, std::string title, int value, std::vector<std::string> choices, ParameterWords words);

/// Lengths that follow from the parameters, and areas, which have no line of their own.
Measure lengthMeasure(std::string name, std::string title, std::string help, std::string annotation);
Measure areaMeasure(std::string name, std::string title, std::string help, std::function<double(const Values&, const Scene&)> value);

/// A material in the colour 0xRRGGBB.
MaterialId paint(Builder& b, std::uint32_t srgb, float roughness, Material::Pattern pattern = Material::Pattern::kPlain);

/// Names a box between two corners of the current scope (m from its origin).
void nameBox(Builder& b, std::string_view name, const Vec3& minM, const Vec3& maxM);

}  // namespace dimline
