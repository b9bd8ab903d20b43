#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "math/camera.h"

namespace dimline {

/// The most shadow look-ups a pixel.
inline constexpr int kShadowLookUps = 9;

/// What every shader of the picture knows of a frame: the uniform block of shaders/frame.glsl (std140, same order).
struct FrameBlock {
  glm::mat4 worldToClip{1.0F};
  glm::mat4 worldToShadow{1.0F};     ///< to the unit cube that the shadow map covers
  glm::mat4 clipToWorld{1.0F};
  glm::vec4 eye{0.0F};               ///< position and 1; orthographic: the direction to the viewer and 0
  glm::vec4 sun{0.0F};               ///< unit direction to the sun; size of a shadow map texel (m)
  glm::vec4 viewport{1.0F};          ///< width and height in device px; device px per CSS px; device px per metre where clip w is 1
  glm::vec4 ground{0.0F};            ///< middle (x, z), height, and the radius (m) at which the ground has faded away
  glm::vec4 groundFade{0.0F};        ///< opacity of the ground as a whole; of the line that stands for it when it is seen edge-on; 0; 0
  glm::vec4 groundAcross{0.0F};      ///< half of that line, from the ground's middle to the right (m)
  glm::vec4 groundSquare{0.0F};      ///< what the ground's texture covers: middle (x, z), half size (m)
  glm::vec4 skyOrigin{0.0F};         ///< corner of the sky volume, and the spacing of its points (m)
  glm::vec4 skyScale{1.0F};          ///< from metres to its coordinates
  glm::vec4 backgroundTop{1.0F};     ///< sRGB
  glm::vec4 backgroundBottom{1.0F};
  glm::ivec4 detail{0};              ///< shadow look-ups a pixel; layers of fine noise on surfaces; 0; 0
  std::array<glm::vec4, kShadowLookUps> shadowDisc{};   ///< where they are, in texels (x, y), evenly over a disc; the others 0
};

/// Binding point of the block, in every program that has it: the one at which all blocks are until told otherwise, and no program is.
inline constexpr unsigned kFrameBlockBinding = 0;

/// Towards the viewer, as FrameBlock::eye has it.
glm::vec4 eyeOf(const View& view);

}  // namespace dimline
