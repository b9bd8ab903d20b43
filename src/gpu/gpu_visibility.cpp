#include "gpu/gpu_visibility.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <glm/gtc/type_ptr.hpp>

#include "core/constants.h"
#include "shaders.h"
#include "silhouette/depth_buffer.h"

namespace dimline {

namespace {

/// Texels a scope in the first pass, side by side, as visibility.frag has it: a large box is counted by that many fragments at a time.
constexpr int kColumns = 16;
static_assert(SeenEdges::kCount <= kColumns, "each edge has a texel of its own");
/// Scopes over each other at most; more stand in further columns. No driver's textures are smaller.
constexpr int kMostRows = 1024;
/// Texels of the boxes' texture in a row, and those of one box.
constexpr int kBoxesWidth = 1024;
constexpr int kTexelsPerBox = 4;

}  // namespace

Result<GpuVisibility> GpuVisibility::make(const GlContext& context) {
  GpuVisibility visibility(context);
  for (Program* program : {&visibility.depthProgram_, &visibility.countProgram_, &visibility.sumProgram_}) {
    if (Status status = program->status(); !status) return status.error();
  }
  visibility.depthMatrix_ = visibility.depthProgram_.uniform("worldToClip");
  const Program& count = visibility.countProgram_;
  visibility.countMatrix_ = count.uniform("worldToClip");
  visibility.eye_ = count.uniform("eye");
  visibility.forward_ = count.uniform("forward");
  visibility.skin_ = count.uniform("skin");
  visibility.scopes_ = count.uniform("scopes");
  count.bindSampler("modelDepth", 0);
  count.bindSampler("boxes", 1);
  visibility.sumProgram_.bindSampler("parts", 0);
  return visibility;
}

GpuVisibility::GpuVisibility(const GlContext& context)
    : context_(&context),
      depthProgram_(context, {.label = "depth of scopes", .vertex = {shaders::instance_glsl, shaders::mask_vert}, .fragment = {shaders::depth_frag}}),
      countProgram_(context, {.label = "visibility", .vertex = {shaders::fullscreen_vert}, .fragment = {shaders::visibility_frag}}),
      sumProgram_(context, {.label = "sums of visibility", .vertex = {shaders::fullscreen_vert}, .fragment = {shaders::visibility_sum_frag}}),
      noVertices_(context),
      flights_(context) {}

void GpuVisibility::setScene(const Scene& scene) {
  drop();
  skinM_ = kScopeSkinShare * scene.bounds.diagonal();
  scopeCount_ = static_cast<int>(scene.scopes.size());
  if (scopeCount_ == 0) return;
  const int texels = scopeCount_ * kTexelsPerBox;
  const int height = (texels + kBoxesWidth - 1) / kBoxesWidth;
  std::vector<glm::vec4> boxes(static_cast<std::size_t>(kBoxesWidth) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < scene.scopes.size(); ++i) {
    const Obb& box = scene.scopes[i].box;
    glm::vec4* texel = &boxes[i * kTexelsPerBox];
    texel[0] = glm::vec4(box.origin, 0);
    for (int axis = 0; axis < 3; ++axis) texel[axis + 1] = glm::vec4(box.axes[static_cast<std::size_t>(axis)] * box.size[axis], 0);
  }
  boxes_ = makeTexture2D(*context_, GL_RGBA32F, kBoxesWidth, height, Sampling::kNearest);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kBoxesWidth, height, GL_RGBA, GL_FLOAT, boxes.data());

  const int rows = std::min(scopeCount_, kMostRows);
  const int columns = (scopeCount_ + rows - 1) / rows;
  if (rows == rows_ && columns == sums_.width) return;
  rows_ = rows;
  // Both are drawable in every OpenGL ES 3.0 and WebGL 2. A part has at most the depth buffer's samples in its columns, which fit into 16 bits, as a box's edges do.
  counts_ = makeDrawnTexture(*context_, GL_RGBA16UI, columns * kColumns, rows);
  sums_ = makeDrawnTexture(*context_, GL_RGBA32UI, columns, rows);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::uint64_t GpuVisibility::request(const GpuScene& scene, const View& view) {
  if (scopeCount_ == 0 || !resizeDepth(view)) return 0;
  auto* const flight = flights_.begin();
  if (flight == nullptr) return 0;
  drawDepth(scene, view);
  countSamples(view);
  flight->what.viewportSamples = static_cast<std::size_t>(depth_.width) * static_cast<std::size_t>(depth_.height);
  flight->readback.begin(static_cast<std::size_t>(sums_.width) * static_cast<std::size_t>(sums_.height) * kIntegerPixelBytes);
  flight->readback.read(0, 0, sums_.width, sums_.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 0);
  flight->readback.end();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return flight->number;
}

Status GpuVisibility::resizeDepth(const View& view) {
  const auto [width, height] = DepthBuffer::sizeFor(view, kVisibilitySamples);
  if (depth_.width == width && depth_.height == height) return okStatus();
  DrawnTexture made;
  made.width = width;
  made.height = height;
  made.texture = makeTexture2D(*context_, GL_DEPTH_COMPONENT24, width, height, Sampling::kNearest);
  Result<Framebuffer> framebuffer = makeFramebuffer(*context_, "visibility", 0, made.texture.id());
  if (!framebuffer) return framebuffer.error();
  made.framebuffer = std::move(framebuffer).value();
  depth_ = std::move(made);
  return okStatus();
}

void GpuVisibility::drawDepth(const GpuScene& scene, const View& view) {
  glBindFramebuffer(GL_FRAMEBUFFER, depth_.framebuffer.id());
  glViewport(0, 0, depth_.width, depth_.height);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearDepthf(1.0F);
  glClear(GL_DEPTH_BUFFER_BIT);
  if (!scene.empty()) {
    depthProgram_.use();
    glUniformMatrix4fv(depthMatrix_, 1, GL_FALSE, glm::value_ptr(glm::mat4(view.viewProjection())));
    scene.drawPositions();
  }
  glDisable(GL_DEPTH_TEST);
}

void GpuVisibility::countSamples(const View& view) {
  glBindVertexArray(noVertices_.id());
  countProgram_.use();
  glUniformMatrix4fv(countMatrix_, 1, GL_FALSE, glm::value_ptr(glm::mat4(view.viewProjection())));
  glUniform4fv(eye_, 1, glm::value_ptr(glm::vec4(view.camera().eye, view.nearM())));
  glUniform4fv(forward_, 1, glm::value_ptr(glm::vec4(view.forward(), view.orthographic() ? 1.0 : 0.0)));
  glUniform1f(skin_, static_cast<float>(skinM_));
  glUniform2i(scopes_, scopeCount_, rows_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, boxes_.id());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depth_.texture.id());
  glBindFramebuffer(GL_FRAMEBUFFER, counts_.framebuffer.id());
  glViewport(0, 0, counts_.width, counts_.height);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  sumProgram_.use();
  glBindTexture(GL_TEXTURE_2D, counts_.texture.id());
  glBindFramebuffer(GL_FRAMEBUFFER, sums_.framebuffer.id());
  glViewport(0, 0, sums_.width, sums_.height);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

std::optional<std::uint64_t> GpuVisibility::poll(ScopeVisibility& visibility) { return land(flights_.newestArrived(), visibility); }

std::optional<std::uint64_t> GpuVisibility::finish(ScopeVisibility& visibility) { return land(flights_.newest(), visibility); }

/// Reads an answer, if there is one.
std::optional<std::uint64_t> GpuVisibility::land(Flights<Counted>::Flight* flight, ScopeVisibility& visibility) {
  if (flight == nullptr) return std::nullopt;
  bytes_.resize(static_cast<std::size_t>(sums_.width) * static_cast<std::size_t>(sums_.height) * kIntegerPixelBytes);
  flight->readback.copy(0, bytes_);
  visibility.seenShare.clear();
  visibility.seenEdges.clear();
  for (int i = 0; i < scopeCount_; ++i) {
    // Column by column, as visibility.frag counts them.
    const int pixel = i % rows_ * sums_.width + i / rows_;
    std::array<std::uint32_t, 4> counts{};
    std::memcpy(counts.data(), bytes_.data() + static_cast<std::size_t>(pixel) * kIntegerPixelBytes, sizeof(counts));
    visibility.seenShare.push_back(seenShareOf({counts[0], counts[1], counts[2] != 0}, flight->what.viewportSamples));
    visibility.seenEdges.emplace_back(counts[3]);
  }
  const std::uint64_t number = flight->number;
  flights_.end(*flight);
  return number;
}

}  // namespace dimline
