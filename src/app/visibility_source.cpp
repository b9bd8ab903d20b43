#include "app/visibility_source.h"

#include <algorithm>
#include <utility>

#include "app/stopwatch.h"

namespace dimline {

Editor::FieldsFrom VisibilitySource::active(const Renderer* renderer) const {
  using From = Editor::FieldsFrom;
  if (renderer == nullptr || from_ == From::kCpu) return From::kCpu;
  if (from_ == From::kGpu) return From::kGpu;
  // A software rasterizer draws the depths with the same cores, and is slower at it.
  return !renderer->context().software() && times_.gpuIsBetter() ? From::kGpu : From::kCpu;
}

void VisibilitySource::viewChanged() {
  for (Flight& flight : flights_) flight.newest = false;
}

void VisibilitySource::rendererGone() {
  flights_.clear();
  times_.forgetGpu();
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
  // Nobody waits for what is under way any more; nor may the GPU hold a place for it.
  if (renderer != nullptr && !flights_.empty()) renderer->dropVisibility();
  flights_.clear();
  measuredMs_ = watch.ms();
  times_.cpuTook(measuredMs_);
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
      times_.gpuTook(measuredMs_);
      std::swap(seen_, arrived_);
    }
    flights_.pop_front();
  }
  return arrival;
}

}  // namespace dimline
