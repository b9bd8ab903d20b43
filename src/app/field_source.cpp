#include "app/field_source.h"

#include <algorithm>
#include <utility>

#include "app/stopwatch.h"

namespace dimline {

namespace {

/// ms. The CPU answers within the frame, the GPU some frames later; so as long as the CPU takes no more than this of a
/// frame's 16 ms, it is the better one whatever the GPU could do. Only models dearer than that are measured on both.
constexpr double kCpuBudgetMs = 3.0;

/// The first measurement of a scene pays for memory, so that the best of a few counts.
constexpr int kCpuSamples = 3;

/// The first answer of a context pays for its shaders, so that it does not count.
constexpr int kGpuWarmUp = 1;

}  // namespace

Editor::FieldsFrom FieldSource::active(const Renderer* renderer) const {
  using From = Editor::FieldsFrom;
  if (renderer == nullptr || renderer->fieldsRefused() || from_ == From::kCpu) return From::kCpu;
  if (from_ == From::kGpu) return From::kGpu;
  // A software rasterizer draws the mask with the same cores, and is slower at it than the CPU's own way.
  if (renderer->context().software() || cpuSamples_ < kCpuSamples || cpuMs_ <= kCpuBudgetMs) return From::kCpu;
  return gpuMs_ < cpuMs_ ? From::kGpu : From::kCpu;
}

void FieldSource::setScene(const Scene& scene) {
  cpu_.setScene(scene);
  current_ = false;
  for (Flight& flight : flights_) flight.newest = false;
}

void FieldSource::forgetTimes() {
  cpuSamples_ = 0;
  gpuMs_ = 0;
}

void FieldSource::rendererGone() {
  flights_.clear();
  gpuMs_ = 0;
  gpuSamples_ = 0;
}

bool FieldSource::update(const View& view, bool stale, double devicePixelRatio, Renderer* renderer) {
  if (stale) {
    current_ = false;
    for (Flight& flight : flights_) flight.newest = false;
  }
  if (active(renderer) == Editor::FieldsFrom::kCpu) {
    flights_.clear();
    return !current_ && measureOnCpu(view);
  }
  const bool arrived = poll(*renderer);
  const bool onTheWay = std::ranges::any_of(flights_, &Flight::newest);
  if (!current_ && !onTheWay) request(view, devicePixelRatio, *renderer);
  return arrived;
}

bool FieldSource::measureOnCpu(const View& view) {
  const Stopwatch watch;
  cpu_.produce(view, fields_);
  measuredMs_ = watch.ms();
  cpuMs_ = cpuSamples_ == 0 ? measuredMs_ : std::min(cpuMs_, measuredMs_);
  ++cpuSamples_;
  view_ = view;
  current_ = true;
  return true;
}

bool FieldSource::poll(Renderer& renderer) {
  const Stopwatch watch;
  GpuFields* const fields = flights_.empty() ? nullptr : renderer.fields();
  const auto number = fields != nullptr ? fields->poll(arrived_) : std::nullopt;
  if (!number) return false;
  bool known = false;
  while (!flights_.empty() && flights_.front().number <= *number) {
    const Flight& flight = flights_.front();
    if (flight.number == *number) {
      view_ = flight.view;
      current_ = flight.newest;
      measuredMs_ = flight.requestMs + watch.ms();
      gpuMs_ = gpuSamples_++ < kGpuWarmUp ? 0.0 : measuredMs_;
      std::swap(fields_, arrived_);
      known = true;
    }
    flights_.pop_front();
  }
  return known;
}

void FieldSource::request(const View& view, double devicePixelRatio, Renderer& renderer) {
  const Stopwatch watch;
  GpuFields* const fields = renderer.fields();
  const std::uint64_t number = fields != nullptr ? fields->request(renderer.scene(), view, devicePixelRatio) : 0;
  if (number == 0) return;
  flights_.push_back({number, view, true, watch.ms()});
}

std::optional<DistanceFields> FieldSource::measure(const View& view, Editor::FieldsFrom from, double devicePixelRatio,
                                                   Renderer* renderer) {
  DistanceFields fields;
  if (from == Editor::FieldsFrom::kGpu) {
    GpuFields* const gpu = renderer != nullptr ? renderer->fields() : nullptr;
    if (gpu == nullptr) return std::nullopt;
    // Answers under way would come in the way of this one; their frames ask again.
    while (gpu->finish(fields)) {
    }
    flights_.clear();
    current_ = false;
    if (gpu->request(renderer->scene(), view, devicePixelRatio) == 0 || !gpu->finish(fields)) return std::nullopt;
  } else {
    cpu_.produce(view, fields);
  }
  return fields;
}

}  // namespace dimline
