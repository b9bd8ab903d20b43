#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace dimline {

/// A colour as designers write it: sRGB and opacity, each 0 to 1.
constexpr glm::vec4 srgb(unsigned rgb, float opacity = 1.0F) {
  return {static_cast<float>((rgb >> 16U) & 255U) / 255.0F, static_cast<float>((rgb >> 8U) & 255U) / 255.0F,
          static_cast<float>(rgb & 255U) / 255.0F, opacity};
}

/// Colours of what is drawn, apart from the model's own. The default is dark ink and orange handles on paper white.
struct Theme {
  glm::vec4 backgroundTop = srgb(0xEDF1F4);
  glm::vec4 backgroundBottom = srgb(0xFBFAF8);
  glm::vec4 line = srgb(0x3A4149);             ///< dimension lines, and the ends of them that cannot be dragged
  glm::vec4 lineHovered = srgb(0x14181C);
  glm::vec4 extension = srgb(0x3A4149, 0.55F);
  glm::vec4 handle = srgb(0xF0780A);           ///< ends that can be dragged
  glm::vec4 handleHovered = srgb(0xE05F00);
  glm::vec4 halo = srgb(0xFFFFFF, 0.6F);       ///< round lines, so that they read over the model too
  bool operator==(const Theme&) const = default;
};

}  // namespace dimline
