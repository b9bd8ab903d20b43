#pragma once

#include <cstddef>

#include "model/model.h"

namespace dimline {

/// How large a model is.
struct ModelStatistics {
  std::size_t triangles = 0;
  std::size_t baseLines = 0;           ///< of all parameters with a dimension line, seen or not
  std::size_t clusteredBaseLines = 0;  ///< those of them that belong to a cluster
  std::size_t clusters = 0;
};
ModelStatistics statisticsOf(const Model& model, const Scene& scene);

}  // namespace dimline
