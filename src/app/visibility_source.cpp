#include "app/visibility_source.h"

#include <algorithm>
#include <utility>

#include "app/stopwatch.h"

namespace dimline {

namespace {

/// ms. As long as the CPU takes no more than this of a frame, an answer within the frame is worth more than a free one some frames later.
constexpr double kCpuBudgetMs = 1.0;

/// The first measurement of a scene pays for memory, so that the best of a few counts.
constexpr int kCpuSamples = 3;

/// The first answer of a context pays for its shaders, so that it does not count.
constexpr int kGpuWarmUp = 1;

}  // namespace

Editor::FieldsFrom VisibilitySource::active(const Renderer* renderer) const {
  using From = Editor::FieldsFrom;
  if (renderer == nullptr || from_ == From::kCpu) return From::kCpu;
  if (from_ == From::kGpu) return From::kGpu;
  // A software rasterizer draws the depths with the same cores, and is slower at it.
  if (renderer->context().software() || cpuSamples_ < kCpuSamples || cpuMs_ <= kCpuBudgetMs) return From::kCpu;
  return gpuMs_ < cpuMs_ ? From::kGpu : From::kCpu;
}

void VisibilitySource::viewChanged() {
  for (Flight& flight : flights_) flight.newest = false;
}

void VisibilitySource::forgetTimes() {
  cpuSamples_ = 0;
  gpuMs_ = 0;
}

void VisibilitySource::rendererGone() {
  flights_.clear();
  gpuMs_ = 0;
  gpuSamples_ = 0;
}

bool VisibilitySource::measure(const Scene& scene, const View& view, Renderer* renderer, bool atOnce,
                               bool present) {
  const Stopwatch watch;
  if (!atOnce && active(renderer) == Editor::FieldsFrom::kGpu) {
    if (awaiting()) return false;
    if (const std::uint64_t number = renderer->requestVisibility(scene, view); number != 0) {
      flights_.push_back({number, present, watch.ms()});
      return false;
    }
    // As many as can be are under way already: the next one is asked for when one of them has arrived.
    if (!flights_.empty()) return false;
  }
  cpu_.measure(scene, view, seen_);
  flights_.clear();
  measuredMs_ = watch.ms();
  cpuMs_ = cpuSamples_ == 0 ? measuredMs_ : std::min(cpuMs_, measuredMs_);
  ++cpuSamples_;
  return true;
}

VisibilitySource::Arrival VisibilitySource::poll(Renderer* renderer) {
  if (renderer == nullptr || flights_.empty()) return Arrival::kNone;
  const Stopwatch watch;
  const auto number = renderer->pollVisibility(arrived_);
  if (!number) return Arrival::kNone;
  Arrival arrival = Arrival::kNone;
  while (!flights_.empty() && flights_.front().number <= *number) {
    const Flight& flight = flights_.front();
    if (flight.number == *number) {
      arrival = flight.newest ? Arrival::kPresent : Arrival::kOlder;
      measuredMs_ = flight.requestMs + watch.ms();
      gpuMs_ = gpuSamples_++ < kGpuWarmUp ? 0.0 : measuredMs_;
      std::swap(seen_, arrived_);
    }
    flights_.pop_front();
  }
  return arrival;
}

}  // namespace dimline
