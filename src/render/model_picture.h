#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "math/camera.h"
#include "model/scene.h"

namespace dimline {

/// What a drawing of the model needs to know of a view: at each sample of a regular grid which triangle is seen, and how near. Worked out on the
/// CPU, so that drawings come out alike on every machine.
struct ModelPicture {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  /// What is drawn of a triangle, in the order of instances and their triangles.
  struct Surface {
    std::uint32_t rgb = 0;   ///< 0xRRGGBB, the tone it is filled with
    std::uint32_t part = 0;  ///< triangles that hang together by shared corners are one part
    glm::vec3 normal{0.0F};  ///< towards the viewer, unit length
  };

  int width = 0, height = 0;  ///< samples
  double samplesPerPx = 1;
  std::vector<std::uint32_t> seen;  ///< index into surfaces, or kNothing; row by row from the top
  std::vector<float> nearness;      ///< see nearnessOf; meaningless where nothing is seen
  std::vector<Surface> surfaces;

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Grows towards the viewer and is linear on screen: the inverse depth, or the negative depth when orthographic.
double nearnessOf(const View& view, double depthM);
double depthOf(const View& view, double nearness);

/// Draws the scene with `samplesPerPx` samples a pixel, fewer when that would be more than 4096 a side.
ModelPicture drawModelPicture(const Scene& scene, const View& view, double samplesPerPx);

}  // namespace dimline
