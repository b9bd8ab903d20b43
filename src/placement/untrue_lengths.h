#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace dimline {

/// Dimension lines that do not measure what they say: at the defaults, the mean length of a parameter's base lines differs from its value by more than 1 %, and its annotation does not
/// say `indirect`. A sentence each. Builds the model once.
std::vector<std::string> findUntrueLengths(const Model& model);

}  // namespace dimline
