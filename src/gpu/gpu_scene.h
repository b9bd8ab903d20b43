#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/gl_objects.h"
#include "model/scene.h"

namespace dimline {

/// Vertex attribute locations, for every shader that draws a GpuScene. `kInstanceRow` and the two after it are the rows of the affine
/// map from mesh to world: world = vec3(dot(row0, p), dot(row1, p), dot(row2, p)) with p = vec4(position, 1).
struct SceneAttribute {
  static constexpr GLuint kPosition = 0;
  static constexpr GLuint kNormal = 1;
  static constexpr GLuint kUv = 2;
  static constexpr GLuint kMaterial = 3;
  static constexpr GLuint kInstanceRow = 4;
};

/// A Scene's triangles on the GPU, in two forms, both indexed: positions alone (for masks, shadows and depth), and full vertices, sorted by
/// what shader they want. Meshes that are used rarely are laid out in world space in one batch, the others are instanced.
class GpuScene {
 public:
  /// Triangles that one shader with one texture draws.
  struct Group {
    Material::Pattern pattern = Material::Pattern::kPlain;
    int image = -1;   ///< index into Scene::images, or -1
  };

  explicit GpuScene(const GlContext& context);

  /// Replaces the contents. Keeps what memory it has, so that models of about the same size can follow each other at frame rate.
  void upload(const Scene& scene);

  [[nodiscard]] bool empty() const { return batches_.empty(); }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  /// Every triangle once, with kPosition and kInstanceRow.
  void drawPositions() const;

  [[nodiscard]] std::span<const Group> groups() const { return groups_; }
  /// One group's triangles, with all attributes.
  void drawGroup(std::size_t group) const;

  /// RGBA32F, one texel a material: linear base colour and roughness. Rows of 256, as surface.vert has it.
  [[nodiscard]] GLuint materialTexture() const { return materialTexture_.id(); }
  /// A texture of Scene::images, sRGB with mipmaps, repeating; its top row is at v = 0. What the driver cannot hold is coarser; what has no
  /// pixels is white.
  [[nodiscard]] GLuint imageTexture(int image) const { return images_[static_cast<std::size_t>(image)].id(); }

 private:
  struct Vertex {
    glm::vec3 position;
    std::uint32_t normal;     ///< signed, 10 bits an axis
    glm::vec2 uv;
    std::uint32_t material;
    bool operator==(const Vertex&) const = default;
  };
  struct InstanceRows {
    glm::vec4 x, y, z;
  };
  struct Range {
    std::size_t group = 0;
    std::size_t firstIndex = 0;
    GLsizei count = 0;
  };
  /// Triangles drawn together: many meshes once, already in world space, or one mesh many times.
  struct Batch {
    VertexArray positions;
    VertexArray surface;
    std::size_t baseVertex = 0;      ///< of the position stream
    std::size_t firstIndex = 0;
    GLsizei indexCount = 0;
    std::size_t firstVertex = 0;     ///< of the full vertices
    std::size_t firstInstance = 0;
    GLsizei instances = 0;
    std::vector<Range> ranges;
  };
  /// A mesh as it goes into a batch: where from, and by which map.
  struct Part {
    const Mesh* mesh = nullptr;
    glm::mat4 transform{1.0F};
  };

  void findGroups(const Scene& scene);
  void addBatch(std::span<const Part> parts, std::span<const glm::mat4> instances);
  void appendPositions(const Part& part, std::size_t baseVertex);
  void writeCorners(const Part& part, std::size_t firstVertex, std::vector<std::size_t>& nextIndex);
  void setUpVertexArrays(Batch& batch);
  void uploadMaterials(const Scene& scene);
  void uploadImages(const Scene& scene);

  const GlContext* context_;
  Buffer positionBuffer_, indexBuffer_, vertexBuffer_, vertexIndexBuffer_, instanceBuffer_;
  Texture materialTexture_;
  std::vector<Texture> images_;
  std::vector<SharedImage> sentImages_;   ///< what images_ holds, so that the same image is not sent again
  std::vector<Batch> batches_;
  std::vector<Group> groups_;
  std::vector<std::uint16_t> groupOfMaterial_;
  Bounds bounds_;

  // What is sent to the buffers; kept for its memory.
  std::vector<glm::vec3> positions_;
  std::vector<std::uint32_t> indices_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> vertexIndices_;
  std::vector<InstanceRows> instanceRows_;
};

}  // namespace dimline
