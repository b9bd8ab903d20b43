#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace dimline {

/// Annotations whose scope the model never builds, most often since the name is misspelled: a sentence each, which lists the names there are. Builds the model
/// at its defaults, and only where that leaves a name unknown also with each parameter alone at its limits or other choices.
std::vector<std::string> findUnknownScopes(const Model& model);

}  // namespace dimline
