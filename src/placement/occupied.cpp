#include "placement/occupied.h"

#include <algorithm>
#include <utility>

namespace dimline {

void Occupied::begin(const DistanceFields& model) { pad(model, kHandleSpacingPx, paddedModel_); }

void Occupied::clear() {
  padded_ = paddedModel_;
  landed_.clear();
  guides_.clear();
}

void Occupied::swapLanded(Occupied& other) {
  std::swap(padded_, other.padded_);
  std::swap(landed_, other.landed_);
  std::swap(guides_, other.guides_);
}

void Occupied::add(const PlacedLine& line, int guide) {
  const Landed::Mark before = landed_.mark();
  landed_.add(line, guide);
  if (guide < 0) return;
  for (const Landed::Extension& landed : landed_.extensionsSince(before)) pullIn(padded_, landed.segment, kExtensionClearancePx);
  Guide& carrier = guides_[static_cast<std::size_t>(guide)];
  const auto [from, to] = std::minmax({carrier.metresAt(line.line.start), carrier.metresAt(line.line.end)});
  carrier.taken.add(from, to);
  pullIn(padded_, line.lineScreen, kHandleSpacingPx);
  if (line.label) pullIn(padded_, *line.label, kLabelClearancePx);
}

void Occupied::add(const PlacedHandle& handle, const View& view) {
  landed_.add(handle, view);
  pullIn(padded_, handle.box, kLabelClearancePx);
}

}  // namespace dimline
