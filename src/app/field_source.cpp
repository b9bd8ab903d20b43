#include "app/field_source.h"

#include <algorithm>
#include <utility>

#include "app/stopwatch.h"

namespace dimline {

Editor::FieldsFrom FieldSource::active(const Renderer* renderer) const {
  using From = Editor::FieldsFrom;
  if (renderer == nullptr || renderer->fieldsRefused() || from_ == From::kCpu) return From::kCpu;
  if (from_ == From::kGpu) return From::kGpu;
  // A software rasterizer draws the mask with the same cores, and is slower at it than the CPU's own way.
  return !renderer->context().software() && times_.gpuIsBetter() ? From::kGpu : From::kCpu;
}

void FieldSource::setScene(const Scene& scene) {
  cpu_.setScene(scene);
  current_ = false;
  for (Flight& flight : flights_) flight.newest = false;
}

void FieldSource::rendererGone() {
  flights_.clear();
  times_.forgetGpu();
}

/// Nobody waits for what is under way any more; nor may the GPU hold a place for it.
void FieldSource::dropFlights(Renderer* renderer) {
  if (renderer != nullptr && !flights_.empty()) renderer->dropFields();
  flights_.clear();
}

bool FieldSource::update(const View& view, bool stale, double devicePixelRatio, Renderer* renderer) {
  if (stale) {
    current_ = false;
    for (Flight& flight : flights_) flight.newest = false;
  }
  if (active(renderer) == Editor::FieldsFrom::kCpu) {
    dropFlights(renderer);
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
  times_.cpuTook(measuredMs_);
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
      times_.gpuTook(measuredMs_);
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
    dropFlights(renderer);   // their frames ask again
    current_ = false;
    if (gpu->request(renderer->scene(), view, devicePixelRatio) == 0 || !gpu->finish(fields)) return std::nullopt;
  } else {
    cpu_.produce(view, fields);
  }
  return fields;
}

}  // namespace dimline
