#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "model/model.h"
#include "placement/chains.h"

namespace dimline {

/// An annotated parameter, and what it measures in a scene. Made at model change.
struct Measured {
  std::size_t parameter = 0;         ///< index into the model's parameters
  Annotation annotation;
  std::vector<std::size_t> scopes;   ///< indices into the scene's scopes
  std::vector<Cluster> clusters;     ///< of a chained parameter
  double meanLengthM = 0;            ///< of its base lines, in the world
  std::string text;                  ///< its label
  Vec2 textSize{0.0};                ///< px
  double textValue = std::numeric_limits<double>::quiet_NaN();   ///< what the label was made of; NaN, which equals nothing, before the first one
};

/// The model's annotated parameters, in the order of their definition. `modelSizeM` scales the tolerance for equal planes.
std::vector<Measured> measure(const Model& model, std::span<const Scope> scopes, double modelSizeM);

/// The base lines that are the same for all views, from which the object planes are made (paper 4.4).
std::vector<Segment> fixedBaseLines(std::span<const Measured> measured, std::span<const Scope> scopes);

/// Makes the label for a value, when it is not the last one's.
void label(Measured& measured, const Parameter& definition, double value);

}  // namespace dimline
