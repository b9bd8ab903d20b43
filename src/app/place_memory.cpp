#include "app/place_memory.h"

#include <algorithm>

namespace dimline {

void PlaceMemory::remember(const Values& values, const Picture& picture, Placer::Memory places) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.values == values; });
  entries_.push_back({values, picture, std::move(places)});
  if (entries_.size() > kMost) entries_.erase(entries_.begin());
}

std::optional<Placer::Memory> PlaceMemory::placesOf(const Values& values, const Picture& picture) const {
  const auto entry = std::ranges::find(entries_, values, &Entry::values);
  if (entry == entries_.end() || entry->picture != picture) return std::nullopt;
  return entry->places;
}

}  // namespace dimline
