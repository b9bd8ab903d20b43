#include "placement/label_memory.h"

#include <algorithm>

#include "core/constants.h"

namespace dimline {

const LabelMemory::Label* LabelMemory::find(const Identity& line, std::size_t nth) const {
  const auto own = std::ranges::find(labels_, line.parameter, [](const Label& label) { return label.line.parameter; });
  const auto left = static_cast<std::size_t>(labels_.end() - own);
  if (nth < left && own[static_cast<std::ptrdiff_t>(nth)].line == line) return &own[static_cast<std::ptrdiff_t>(nth)];
  const auto found = std::find_if(own, labels_.end(), [&](const Label& label) { return label.line == line; });
  return found != labels_.end() ? &*found : nullptr;
}

std::optional<LastLabelPlace> LabelMemory::last(const Identity& line, std::size_t nth, bool viewMoved) const {
  const Label* label = find(line, nth);
  if (label == nullptr) return std::nullopt;
  return LastLabelPlace{label->place, viewMoved && label->framesHeld >= kReturnFrames};
}

void LabelMemory::note(std::span<const PlacedLine> lines, bool viewMoved) {
  before_.clear();
  before_.reserve(labels_.capacity());   // they change places: what one has room for the other needs as well
  std::size_t nth = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PlacedLine& line = lines[i];
    nth = i > 0 && lines[i - 1].parameter == line.parameter ? nth + 1 : 0;
    const auto place = line.label ? std::optional(line.labelPlace) : std::nullopt;
    const Label* label = find(line.identity, nth);
    const bool stayed = label != nullptr && label->place == place;
    before_.push_back({line.identity, place, stayed ? std::min(label->framesHeld + (viewMoved ? 1 : 0), kReturnFrames) : 0});
  }
  labels_.swap(before_);
}

}  // namespace dimline
