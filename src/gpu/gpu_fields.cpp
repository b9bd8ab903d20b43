#include "gpu/gpu_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/gtc/type_ptr.hpp>

#include "shaders.h"

namespace dimline {

namespace {

/// Texels that one step of the reduction takes together. Eight makes four steps of any mask up to 4096 wide.
constexpr int kTexelsPerStep = 8;

int stepped(int size) { return (size + kTexelsPerStep - 1) / kTexelsPerStep; }

}  // namespace

Result<GpuFields> GpuFields::make(const GlContext& context) {
  GpuFields fields(context);
  for (Program* program : {&fields.maskProgram_, &fields.firstStepProgram_, &fields.stepProgram_}) {
    if (Status status = program->status(); !status) return status.error();
  }
  fields.maskMatrix_ = fields.maskProgram_.uniform("worldToClip");
  fields.firstAxis_ = fields.firstStepProgram_.uniform("axis");
  fields.stepAxis_ = fields.stepProgram_.uniform("axis");
  fields.firstStepProgram_.bindSampler("mask", 0);
  fields.stepProgram_.bindSampler("extremes", 0);
  return fields;
}

GpuFields::GpuFields(const GlContext& context)
    : context_(&context),
      reduction_(context.software() ? FieldReduction::kOnCpu : FieldReduction::kOnGpu),
      maskProgram_(context, {.label = "mask", .vertex = {shaders::instance_glsl, shaders::mask_vert}, .fragment = {shaders::mask_frag}}),
      firstStepProgram_(context, {.label = "extremes of the mask",
                                  .vertex = {shaders::fullscreen_vert},
                                  .fragment = {shaders::extremes_frag},
                                  .defines = "#define FIRST_STEP 1\n"}),
      stepProgram_(context, {.label = "extremes", .vertex = {shaders::fullscreen_vert}, .fragment = {shaders::extremes_frag}}),
      noVertices_(context),
      flights_(context) {}

void GpuFields::resize(int width, int height) {
  if (mask_.width == width && mask_.height == height) return;
  // All of these are drawable in every OpenGL ES 3.0 and WebGL 2. What is read back lies there as it is read: where a driver has to convert it, it waits for the GPU.
  const auto formatOf = [](int left) { return left == 1 ? GL_RGBA32UI : GL_RG16UI; };
  mask_ = makeDrawnTexture(*context_, GL_R8, width, height);
  rowSteps_.clear();
  columnSteps_.clear();
  for (int w = stepped(width);; w = stepped(w)) {
    rowSteps_.push_back(makeDrawnTexture(*context_, formatOf(w), w, height));
    if (w == 1) break;
  }
  for (int h = stepped(height);; h = stepped(h)) {
    columnSteps_.push_back(makeDrawnTexture(*context_, formatOf(h), width, h));
    if (h == 1) break;
  }
}

std::uint64_t GpuFields::request(const GpuScene& scene, const View& view, double devicePixelRatio) {
  auto* const flight = flights_.begin();
  if (flight == nullptr) return 0;
  const int limit = std::min(context_->maxTextureSize(), static_cast<int>(MaskExtremes::kNothing) - 1);
  const double ratio = std::min(devicePixelRatio, limit / std::max(view.widthPx(), view.heightPx()));
  MaskSent& sent = flight->what;
  sent.reduction = reduction_;
  sent.widthPx = view.widthPx();
  sent.heightPx = view.heightPx();
  sent.width = std::clamp(static_cast<int>(std::lround(view.widthPx() * ratio)), 1, limit);
  sent.height = std::clamp(static_cast<int>(std::lround(view.heightPx() * ratio)), 1, limit);
  resize(sent.width, sent.height);
  drawMask(scene, view);

  const auto width = static_cast<std::size_t>(sent.width);
  const auto height = static_cast<std::size_t>(sent.height);
  if (reduction_ == FieldReduction::kOnGpu) {
    flight->readback.begin((width + height) * kIntegerPixelBytes);
    reduce(true);
    flight->readback.read(0, 0, 1, sent.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 0);
    reduce(false);
    flight->readback.read(0, 0, sent.width, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, height * kIntegerPixelBytes);
  } else {
    GLint format = 0;
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT, &format);
    sent.bytesPerPixel = format == GL_RED ? 1 : 4;
    flight->readback.begin(width * height * static_cast<std::size_t>(sent.bytesPerPixel));
    flight->readback.read(0, 0, sent.width, sent.height, format == GL_RED ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE, 0);
  }
  flight->readback.end();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return flight->number;
}

void GpuFields::drawMask(const GpuScene& scene, const View& view) {
  glBindFramebuffer(GL_FRAMEBUFFER, mask_.framebuffer.id());
  glViewport(0, 0, mask_.width, mask_.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  if (scene.empty()) return;
  maskProgram_.use();
  // Upside down, so that the texture's first row is the screen's top one.
  glm::dmat4 flip(1.0);
  flip[1][1] = -1.0;
  const glm::mat4 matrix(flip * view.viewProjection());
  glUniformMatrix4fv(maskMatrix_, 1, GL_FALSE, glm::value_ptr(matrix));
  scene.drawPositions();
}

const DrawnTexture& GpuFields::reduce(bool alongRows) {
  const std::vector<DrawnTexture>& steps = alongRows ? rowSteps_ : columnSteps_;
  glBindVertexArray(noVertices_.id());
  glActiveTexture(GL_TEXTURE0);
  const DrawnTexture* from = &mask_;
  for (const DrawnTexture& to : steps) {
    const bool first = from == &mask_;
    (first ? firstStepProgram_ : stepProgram_).use();
    glUniform2i(first ? firstAxis_ : stepAxis_, alongRows ? 1 : 0, alongRows ? 0 : 1);
    glBindTexture(GL_TEXTURE_2D, from->texture.id());
    glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer.id());
    glViewport(0, 0, to.width, to.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    from = &to;
  }
  glBindVertexArray(0);
  return *from;
}

std::optional<std::uint64_t> GpuFields::poll(DistanceFields& fields) { return land(flights_.newestArrived(), fields); }

std::optional<std::uint64_t> GpuFields::finish(DistanceFields& fields) { return land(flights_.newest(), fields); }

/// Reads an answer, if there is one.
std::optional<std::uint64_t> GpuFields::land(Flights<MaskSent>::Flight* flight, DistanceFields& fields) {
  if (flight == nullptr) return std::nullopt;
  const MaskSent& sent = flight->what;
  const auto width = static_cast<std::size_t>(sent.width);
  const auto height = static_cast<std::size_t>(sent.height);
  if (sent.reduction == FieldReduction::kOnGpu) {
    bytes_.resize((width + height) * kIntegerPixelBytes);
    flight->readback.copy(0, bytes_);
    extremes_.rows.resize(height);
    extremes_.columns.resize(width);
    const auto range = [&](std::size_t pixel) {
      std::array<std::uint32_t, 2> values{};
      std::memcpy(values.data(), bytes_.data() + pixel * kIntegerPixelBytes, sizeof(values));
      return MaskExtremes::Range{static_cast<std::uint16_t>(values[0]), static_cast<std::uint16_t>(values[1])};
    };
    for (std::size_t i = 0; i < height; ++i) extremes_.rows[i] = range(i);
    for (std::size_t i = 0; i < width; ++i) extremes_.columns[i] = range(height + i);
  } else {
    const auto stride = static_cast<std::size_t>(sent.bytesPerPixel);
    bytes_.resize(width * height * stride);
    flight->readback.copy(0, bytes_);
    if (stride != 1) {
      gray_.resize(width * height);
      for (std::size_t i = 0; i < gray_.size(); ++i) gray_[i] = bytes_[i * stride];
    }
    scanMask(stride == 1 ? bytes_ : gray_, sent.width, sent.height, extremes_);
  }
  fieldsFromExtremes(extremes_, sent.widthPx, sent.heightPx, fields);
  const std::uint64_t number = flight->number;
  flights_.end(*flight);
  return number;
}

}  // namespace dimline
