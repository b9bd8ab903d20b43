#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/result.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "render/sun_shadow.h"

namespace dimline {

/// How finely light that depends only on the model is worked out.
enum class LightDetail : std::uint8_t {
  kStretched,   ///< sky light of the model before, stretched to this one's box, for one that changes from frame to frame on a slow machine
  kRough,       ///< for a moment, where a slow machine has nothing to stretch
  kCoarse,
  kFine
};

/// Light that comes in from all around, worked out when the model changes and only looked up in a frame. The model is seen from directions spread
/// over the sky, as depth maps in one atlas; from these, a grid of points through the model's box keeps how much sky each sees, and from
/// where (spherical harmonics up to the first order). That is soft, free of noise, the same from every camera, and one texture
/// look-up a pixel. The ground's share of sun, with a penumbra that widens with the distance to what casts it, and of sky lie in a
/// texture of their own.
class SkyLight {
 public:
  explicit SkyLight(const GlContext& context);
  Status prepare();

  /// Works out the light, and gives how finely: roughly where it should be stretched and the two models are too different. `shadow` must have been rendered
  /// for this scene and sun.
  LightDetail bake(const GpuScene& scene, const SunShadow& shadow, const Vec3& towardsSun, LightDetail detail);

  /// RGBA8: a point's visible sky. rgb: 0.5 + 2/3 of the first-order coefficients (x, y, z); a: twice the constant one.
  [[nodiscard]] GLuint volumeTexture() const { return volume_.id(); }
  /// World to the volume's coordinates: (world - origin) * scale. `voxelM`: the spacing of its points.
  [[nodiscard]] const glm::vec3& volumeOrigin() const { return volumeOrigin_; }
  [[nodiscard]] const glm::vec3& volumeScale() const { return volumeScale_; }
  [[nodiscard]] float voxelM() const { return voxelM_; }

  /// RG8: shares of sun and sky that the ground sees, in a square of the ground about (x, z) of that half size (m), at that height.
  [[nodiscard]] GLuint groundTexture() const { return ground_.id(); }
  [[nodiscard]] const glm::vec4& groundSquare() const { return groundSquare_; }

 private:
  static constexpr std::size_t kMostDirections = 32;

  /// The uniform block of shaders/sky_maps.glsl (std140).
  struct Maps {
    std::array<glm::vec4, kMostDirections> u, v, depth;   ///< world to a tile's unit cube, one row each
    std::array<glm::vec4, kMostDirections> direction;     ///< towards the sky; 0
    glm::ivec4 count;                                     ///< directions in use
  };

  void drawAtlas(const GpuScene& scene, LightDetail detail);
  void bakeVolume(const Bounds& bounds, LightDetail detail);
  void bakeGroundSky(LightDetail detail);
  void bakeGround(const SunShadow& shadow, LightDetail detail);
  void placeVolume(const Bounds& bounds);
  void placeGround(const Bounds& bounds, const Vec3& towardsSun);

  const GlContext* context_;
  Program depthProgram_, volumeProgram_, groundSkyProgram_, groundProgram_;
  GLint depthMatrix_ = -1, volumeOriginUniform_ = -1, volumeSlice_ = -1, groundSkySquare_ = -1, groundSquareUniform_ = -1,
        groundToShadow_ = -1, groundSun_ = -1, groundSharpest_ = -1;
  Buffer mapsBuffer_;
  VertexArray noVertices_;
  Sampler plainDepths_;   ///< reads a shadow map's depths without comparing
  Texture atlas_;
  Framebuffer atlasFramebuffer_;
  Maps maps_;
  Texture volume_, groundSky_, ground_;
  glm::ivec3 volumeSize_{0};
  int groundSkySize_ = 0, groundSize_ = 0;
  glm::vec3 volumeOrigin_{0.0F}, volumeScale_{1.0F};
  glm::vec4 groundSquare_{0.0F, 0.0F, 1.0F, 0.0F};   ///< and its height
  Vec3 skyOf_{0.0};   ///< size of the box that atlas, volume and the ground's sky were worked out for
  float voxelM_ = 1.0F;
};

}  // namespace dimline
