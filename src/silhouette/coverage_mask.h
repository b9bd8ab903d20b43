#pragma once

#include <cstdint>
#include <vector>

#include "math/camera.h"
#include "model/scene.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Which pixels the model covers. One byte a pixel, row by row from the top: 255 covered, 0 not.
struct CoverageMask {
  int widthPx = 0;
  int heightPx = 0;
  std::vector<std::uint8_t> pixels;
  [[nodiscard]] bool covered(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(widthPx) + static_cast<std::size_t>(x)] != 0;
  }
};

/// Fills every triangle that `view` shows, tested at pixel centres, cut at the near plane. Slow and plainly right:
/// the command line writes it as masks, and tests measure the field producers against it, so it shares no code with
/// them.
CoverageMask coverageMask(const Scene& scene, const View& view);

/// The fields that a mask's pixels give: from each edge to the outer side of the first covered pixel.
void fieldsFromMask(const CoverageMask& mask, DistanceFields& fields);

}  // namespace dimline
