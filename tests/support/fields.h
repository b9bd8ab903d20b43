#pragma once

#include "silhouette/distance_fields.h"

namespace dimline::test {

/// The fields of a model that fills a box of the viewport. All in whole px.
inline DistanceFields fieldsCovering(const Box2& box, int widthPx = 1000, int heightPx = 1000) {
  DistanceFields fields;
  fields.reset(widthPx, heightPx);
  for (auto row = static_cast<std::size_t>(box.min.y); row < static_cast<std::size_t>(box.max.y); ++row) {
    fields[ViewportEdge::kLeft].edit()[row] = static_cast<float>(box.min.x);
    fields[ViewportEdge::kRight].edit()[row] = static_cast<float>(widthPx - box.max.x);
  }
  for (auto column = static_cast<std::size_t>(box.min.x); column < static_cast<std::size_t>(box.max.x); ++column) {
    fields[ViewportEdge::kTop].edit()[column] = static_cast<float>(box.min.y);
    fields[ViewportEdge::kBottom].edit()[column] = static_cast<float>(heightPx - box.max.y);
  }
  fields.buildTrees();
  return fields;
}

}  // namespace dimline::test
