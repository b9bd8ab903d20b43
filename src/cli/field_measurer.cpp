#include "cli/field_measurer.h"

#include <optional>
#include <string>

#include "gpu/gl_context.h"
#include "gpu/gpu_fields.h"
#include "gpu/gpu_scene.h"
#include "gpu/native_context.h"
#include "silhouette/cpu_fields.h"

namespace dimline {

namespace {

class CpuMeasurer : public FieldMeasurer {
public:
  explicit CpuMeasurer(const Scene& scene) { fields_.setScene(scene); }
  Status measure(const View& view, DistanceFields& fields) override {
    fields_.produce(view, fields);
    return okStatus();
  }

private:
  CpuFields fields_;
};

class GpuMeasurer : public FieldMeasurer {
public:
  explicit GpuMeasurer(std::unique_ptr<NativeContext> native) : native_(std::move(native)) {}

  Status prepare(const Scene& scene) {
    auto fields = GpuFields::make(gl_);
    if (!fields) return fields.error();
    fields_.emplace(std::move(fields).value());
    scene_.upload(scene);
    return okStatus();
  }
  Status measure(const View& view, DistanceFields& fields) override {
    if (fields_->request(scene_, view, 1.0) == 0 || !fields_->finish(fields)) {
      return Error{"The graphics driver gave no answer."};
    }
    return okStatus();
  }

private:
  // In this order: what lives in the context goes before it does.
  std::unique_ptr<NativeContext> native_;
  GlContext gl_;
  GpuScene scene_{gl_};
  std::optional<GpuFields> fields_;
};

}  // namespace

std::unique_ptr<FieldMeasurer> FieldMeasurer::onCpu(const Scene& scene) { return std::make_unique<CpuMeasurer>(scene); }

Result<std::unique_ptr<FieldMeasurer>> FieldMeasurer::onGpu(const Scene& scene) {
  auto native = NativeContext::make();
  if (!native) return native.error();
  auto measurer = std::make_unique<GpuMeasurer>(std::move(native).value());
  if (Status status = measurer->prepare(scene); !status) return status.error();
  return std::unique_ptr<FieldMeasurer>(std::move(measurer));
}

}  // namespace dimline
