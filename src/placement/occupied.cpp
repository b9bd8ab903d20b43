#include "placement/occupied.h"

#include <algorithm>

namespace dimline {

void Occupied::begin(const DistanceFields& model) { pad(model, kHandleSpacingPx, paddedModel_); }

void Occupied::clear() {
  contents_->padded = paddedModel_;
  contents_->landed.clear();
  contents_->guides.clear();
}

void Occupied::Contents::makeRoomLike(const Contents& other) {
  if (padded.widthPx != other.padded.widthPx || padded.heightPx != other.padded.heightPx) padded = other.padded;
  landed.makeRoomLike(other.landed);
  guides.makeRoomLike(other.guides);
}

void Occupied::add(const PlacedLine& line, int guide) {
  auto& [padded, landed, guides] = *contents_;
  const Landed::Mark before = landed.mark();
  landed.add(line, guide);
  if (guide < 0) return;
  for (const Landed::Extension& extension : landed.extensionsSince(before)) pullIn(padded, extension.segment, kExtensionClearancePx);
  Guide& carrier = guides[static_cast<std::size_t>(guide)];
  const auto [from, to] = std::minmax({carrier.metresAt(line.line.start), carrier.metresAt(line.line.end)});
  carrier.taken.add(from, to);
  pullIn(padded, line.lineScreen, kHandleSpacingPx);
  if (line.label) pullIn(padded, *line.label, labelClearancePx_);
}

void Occupied::add(const PlacedHandle& handle, const View& view) {
  contents_->landed.add(handle, view);
  pullIn(contents_->padded, handle.box, kLabelClearancePx);
}

}  // namespace dimline
