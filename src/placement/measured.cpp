#include "placement/measured.h"

#include "placement/label_text.h"
#include "placement/text_metrics.h"

namespace dimline {

std::vector<Measured> measure(const Model& model, std::span<const Scope> scopes, double modelSizeM) {
  std::vector<Measured> all;
  for (std::size_t i = 0; i < model.parameters().size(); ++i) {
    const auto& annotation = model.annotations[i];
    if (!annotation) continue;
    Measured& measured = all.emplace_back();
    measured.parameter = i;
    measured.annotation = *annotation;
    for (std::size_t scope = 0; scope < scopes.size(); ++scope) {
      if (scopes[scope].name != annotation->scope) continue;
      measured.scopes.push_back(scope);
      measured.meanLengthM += meanBaseLengthM(*annotation, scopes[scope].box);
    }
    if (!measured.scopes.empty()) measured.meanLengthM /= static_cast<double>(measured.scopes.size());
    if (annotation->chained) measured.clusters = clusterBaseLines(*annotation, scopes, measured.scopes, modelSizeM);
  }
  return all;
}

std::vector<Segment> fixedBaseLines(std::span<const Measured> measured, std::span<const Scope> scopes) {
  std::vector<Segment> all;
  for (const Measured& m : measured) {
    if (!isLinear(m.annotation.type)) continue;
    for (const std::size_t scope : m.scopes) {
      for (const Segment& segment : baseSegments(m.annotation, scopes[scope].box, View())) all.push_back(segment);
    }
  }
  return all;
}

void label(Measured& measured, const Parameter& definition, double value) {
  if (measured.textValue == value) return;
  measured.text = labelText(definition, value);
  measured.textSize = labelSizePx(measured.text);
  measured.textValue = value;
}

}  // namespace dimline
