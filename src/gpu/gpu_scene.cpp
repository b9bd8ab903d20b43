#include "gpu/gpu_scene.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "gpu/packing.h"

namespace dimline {

namespace {

/// A mesh whose instances have at most this many triangles together is laid out in world space: draw calls cost more than the memory, and
/// software rasterizers treat every instance as one.
constexpr std::size_t kInstancingTriangles = 20000;

constexpr std::size_t kMaterialsPerRow = 256;

/// The image, or every second, third … pixel of it if it is larger than the driver takes; one white pixel if it has none.
Image fitting(const Image& image, std::uint32_t limit) {
  const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
  if (pixels == 0 || image.rgba.size() < pixels * 4) return {1, 1, {255, 255, 255, 255}};
  const std::uint32_t step = (std::max(image.width, image.height) + limit - 1) / limit;
  if (step <= 1) return image;
  Image smaller{image.width / step, image.height / step, {}};
  smaller.width = std::max(smaller.width, 1U);
  smaller.height = std::max(smaller.height, 1U);
  for (std::uint32_t y = 0; y < smaller.height; ++y) {
    for (std::uint32_t x = 0; x < smaller.width; ++x) {
      const std::size_t from = (static_cast<std::size_t>(y * step) * image.width + x * step) * 4;
      smaller.rgba.insert(smaller.rgba.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(from),
                          image.rgba.begin() + static_cast<std::ptrdiff_t>(from + 4));
    }
  }
  return smaller;
}

/// How many vertices are looked back over for one that can be used again.
constexpr std::size_t kVertexWindow = 8;

/// How normals go through an affine map with positive scales: by the inverse transpose.
struct NormalMap {
  glm::mat3 matrix{1.0F};
  explicit NormalMap(const glm::mat4& transform) {
    for (int c = 0; c < 3; ++c) {
      const glm::vec3 column(transform[c]);
      const float squared = glm::dot(column, column);
      matrix[c] = squared > 0.0F ? column / squared : column;
    }
  }
  [[nodiscard]] glm::vec3 operator()(const glm::vec3& n) const {
    const glm::vec3 mapped = matrix * n;
    const float length = glm::length(mapped);
    return length > 0.0F ? mapped / length : glm::vec3(0, 1, 0);
  }
};

/// Metres along a face for meshes that bring no uv: across horizontally, up along the slope.
glm::vec2 uvOnFace(const glm::vec3& p, const glm::vec3& n) {
  glm::vec3 across(n.z, 0.0F, -n.x);
  const float length = glm::length(across);
  across = length > 0.05F ? across / length : glm::vec3(1, 0, 0);
  return {glm::dot(p, across), glm::dot(p, glm::cross(n, across))};
}

}  // namespace

GpuScene::GpuScene(const GlContext& context)
    : context_(&context),
      positionBuffer_(context),
      indexBuffer_(context),
      vertexBuffer_(context),
      vertexIndexBuffer_(context),
      instanceBuffer_(context) {}

void GpuScene::upload(const Scene& scene) {
  bounds_ = scene.bounds;
  batches_.clear();
  positions_.clear();
  indices_.clear();
  vertices_.clear();
  vertexIndices_.clear();
  instanceRows_.clear();
  findGroups(scene);

  std::vector<std::size_t> uses(scene.meshes.size(), 0);
  for (const Instance& instance : scene.instances) ++uses[instance.mesh];
  const auto rare = [&](std::size_t mesh) {
    return uses[mesh] == 1 || uses[mesh] * scene.meshes[mesh].triangles.size() <= kInstancingTriangles;
  };
  std::vector<Part> parts;
  for (const Instance& instance : scene.instances) {
    if (rare(instance.mesh)) parts.push_back({&scene.meshes[instance.mesh], instance.transform});
  }
  const glm::mat4 identity(1.0F);
  if (!parts.empty()) addBatch(parts, {&identity, 1});
  std::vector<glm::mat4> transforms;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (uses[mesh] == 0 || rare(mesh)) continue;
    transforms.clear();
    for (const Instance& instance : scene.instances) {
      if (instance.mesh == mesh) transforms.push_back(instance.transform);
    }
    const Part part{&scene.meshes[mesh], identity};
    addBatch({&part, 1}, transforms);
  }

  glBindVertexArray(0);
  dimline::upload(positionBuffer_, GL_ARRAY_BUFFER, std::span<const glm::vec3>(positions_), GL_DYNAMIC_DRAW);
  dimline::upload(indexBuffer_, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(indices_), GL_DYNAMIC_DRAW);
  dimline::upload(vertexBuffer_, GL_ARRAY_BUFFER, std::span<const Vertex>(vertices_), GL_DYNAMIC_DRAW);
  dimline::upload(vertexIndexBuffer_, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(vertexIndices_), GL_DYNAMIC_DRAW);
  dimline::upload(instanceBuffer_, GL_ARRAY_BUFFER, std::span<const InstanceRows>(instanceRows_), GL_DYNAMIC_DRAW);
  for (Batch& batch : batches_) setUpVertexArrays(batch);
  glBindVertexArray(0);
  uploadMaterials(scene);
  uploadImages(scene);
}

void GpuScene::findGroups(const Scene& scene) {
  groups_.clear();
  groupOfMaterial_.clear();
  for (const Material& material : scene.materials) {
    const auto same = [&](const Group& g) { return g.pattern == material.pattern && g.image == material.image; };
    const auto found = std::find_if(groups_.begin(), groups_.end(), same);
    groupOfMaterial_.push_back(static_cast<std::uint16_t>(found - groups_.begin()));
    if (found == groups_.end()) groups_.push_back({material.pattern, material.image});
  }
}

void GpuScene::addBatch(std::span<const Part> parts, std::span<const glm::mat4> instances) {
  Batch batch;
  batch.baseVertex = positions_.size();
  batch.firstIndex = indices_.size();
  batch.firstVertex = vertices_.size();
  batch.firstInstance = instanceRows_.size();
  batch.instances = static_cast<GLsizei>(instances.size());
  for (const glm::mat4& m : instances) {
    instanceRows_.push_back({{m[0].x, m[1].x, m[2].x, m[3].x}, {m[0].y, m[1].y, m[2].y, m[3].y}, {m[0].z, m[1].z, m[2].z, m[3].z}});
  }

  // Corners are sorted by group as they are written: count, then give each group its place.
  std::vector<std::size_t> counts(groups_.size(), 0);
  for (const Part& part : parts) {
    appendPositions(part, batch.baseVertex);
    for (const std::uint16_t material : part.mesh->materials) counts[groupOfMaterial_[material]] += 3;
  }
  batch.indexCount = static_cast<GLsizei>(indices_.size() - batch.firstIndex);
  std::vector<std::size_t> next(groups_.size());
  std::size_t index = vertexIndices_.size();
  for (std::size_t group = 0; group < groups_.size(); ++group) {
    next[group] = index;
    if (counts[group] == 0) continue;
    batch.ranges.push_back({group, index, static_cast<GLsizei>(counts[group])});
    index += counts[group];
  }
  vertexIndices_.resize(index);
  for (const Part& part : parts) writeCorners(part, batch.firstVertex, next);
  batches_.push_back(std::move(batch));
}

void GpuScene::appendPositions(const Part& part, std::size_t baseVertex) {
  const auto offset = static_cast<std::uint32_t>(positions_.size() - baseVertex);
  for (const glm::vec3& p : part.mesh->positions) positions_.emplace_back(part.transform * glm::vec4(p, 1.0F));
  for (const std::array<std::uint32_t, 3>& triangle : part.mesh->triangles) {
    for (const std::uint32_t index : triangle) indices_.push_back(index + offset);
  }
}

void GpuScene::writeCorners(const Part& part, std::size_t firstVertex, std::vector<std::size_t>& nextIndex) {
  const Mesh& mesh = *part.mesh;
  const NormalMap mapNormal(part.transform);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint16_t material = mesh.materials[t];
    std::size_t& next = nextIndex[groupOfMaterial_[material]];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 p(part.transform * glm::vec4(mesh.positions[mesh.triangles[t][k]], 1.0F));
      const glm::vec3 n = mapNormal(mesh.normals[t][k]);
      const Vertex vertex{p, packNormal(n), mesh.uvs.empty() ? uvOnFace(p, n) : mesh.uvs[t][k], material};
      // Corners that fall together come soon after each other: in the two halves of a quadrilateral, in fans and in strips.
      std::size_t found = vertices_.size();
      const std::size_t oldest = std::max(firstVertex, found - std::min(found, kVertexWindow));
      while (found > oldest && !(vertices_[found - 1] == vertex)) --found;
      if (found == oldest) {
        vertices_.push_back(vertex);
        found = vertices_.size();
      }
      vertexIndices_[next++] = static_cast<std::uint32_t>(found - 1 - firstVertex);
    }
  }
}

void GpuScene::setUpVertexArrays(Batch& batch) {
  const auto instanceAttributes = [&] {
    glBindBuffer(GL_ARRAY_BUFFER, instanceBuffer_.id());
    for (GLuint row = 0; row < 3; ++row) {
      const GLuint attribute = SceneAttribute::kInstanceRow + row;
      glEnableVertexAttribArray(attribute);
      glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, sizeof(InstanceRows),
                            bufferOffset(batch.firstInstance * sizeof(InstanceRows) + row * sizeof(glm::vec4)));
      glVertexAttribDivisor(attribute, 1);
    }
  };
  batch.positions = VertexArray(*context_);
  glBindVertexArray(batch.positions.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer_.id());
  glBindBuffer(GL_ARRAY_BUFFER, positionBuffer_.id());
  glEnableVertexAttribArray(SceneAttribute::kPosition);
  glVertexAttribPointer(SceneAttribute::kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3),
                        bufferOffset(batch.baseVertex * sizeof(glm::vec3)));
  instanceAttributes();

  batch.surface = VertexArray(*context_);
  glBindVertexArray(batch.surface.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, vertexIndexBuffer_.id());
  const std::size_t base = batch.firstVertex * sizeof(Vertex);
  glEnableVertexAttribArray(SceneAttribute::kPosition);
  glVertexAttribPointer(SceneAttribute::kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), bufferOffset(base + offsetof(Vertex, position)));
  glEnableVertexAttribArray(SceneAttribute::kNormal);
  glVertexAttribPointer(SceneAttribute::kNormal, 4, GL_INT_2_10_10_10_REV, GL_TRUE, sizeof(Vertex),
                        bufferOffset(base + offsetof(Vertex, normal)));
  glEnableVertexAttribArray(SceneAttribute::kUv);
  glVertexAttribPointer(SceneAttribute::kUv, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), bufferOffset(base + offsetof(Vertex, uv)));
  glEnableVertexAttribArray(SceneAttribute::kMaterial);
  glVertexAttribIPointer(SceneAttribute::kMaterial, 1, GL_UNSIGNED_INT, sizeof(Vertex), bufferOffset(base + offsetof(Vertex, material)));
  instanceAttributes();
}

void GpuScene::uploadMaterials(const Scene& scene) {
  std::vector<glm::vec4> texels;
  texels.reserve(scene.materials.size());
  for (const Material& material : scene.materials) texels.emplace_back(material.color, material.roughness);
  const std::size_t rows = std::max<std::size_t>(1, (texels.size() + kMaterialsPerRow - 1) / kMaterialsPerRow);
  texels.resize(rows * kMaterialsPerRow, glm::vec4(0.8F));
  materialTexture_ = Texture(*context_);
  glBindTexture(GL_TEXTURE_2D, materialTexture_.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, kMaterialsPerRow, static_cast<GLsizei>(rows));
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kMaterialsPerRow, static_cast<GLsizei>(rows), GL_RGBA, GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GpuScene::uploadImages(const Scene& scene) {
  images_.resize(scene.images.size());
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    if (images_[i] && i < sentImages_.size() && sentImages_[i] == scene.images[i]) continue;
    const Image image = fitting(*scene.images[i], static_cast<std::uint32_t>(context_->maxTextureSize()));
    const auto width = static_cast<GLsizei>(image.width);
    const auto height = static_cast<GLsizei>(image.height);
    int levels = 1;
    for (std::uint32_t size = std::max(image.width, image.height); size > 1; size /= 2) ++levels;
    images_[i] = Texture(*context_);
    glBindTexture(GL_TEXTURE_2D, images_[i].id());
    glTexStorage2D(GL_TEXTURE_2D, levels, GL_SRGB8_ALPHA8, width, height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  sentImages_ = scene.images;
}

void GpuScene::drawPositions() const {
  for (const Batch& batch : batches_) {
    glBindVertexArray(batch.positions.id());
    glDrawElementsInstanced(GL_TRIANGLES, batch.indexCount, GL_UNSIGNED_INT, bufferOffset(batch.firstIndex * sizeof(std::uint32_t)),
                            batch.instances);
  }
  glBindVertexArray(0);
}

void GpuScene::drawGroup(std::size_t group) const {
  for (const Batch& batch : batches_) {
    for (const Range& range : batch.ranges) {
      if (range.group != group) continue;
      glBindVertexArray(batch.surface.id());
      glDrawElementsInstanced(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, bufferOffset(range.firstIndex * sizeof(std::uint32_t)),
                              batch.instances);
    }
  }
  glBindVertexArray(0);
}

}  // namespace dimline
