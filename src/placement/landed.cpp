#include "placement/landed.h"

namespace dimline {

void Landed::clear() {
  segments_.clear();
  labels_.clear();
}

void Landed::add(const PlacedLine& line) {
  segments_.push_back(line.lineScreen);
  for (const auto* extension : {&line.extensionStart, &line.extensionEnd}) {
    for (std::size_t i = 1; i < extension->size(); ++i) segments_.push_back({(*extension)[i - 1], (*extension)[i]});
  }
  if (line.label) labels_.push_back(*line.label);
}

bool Landed::crosses(const Segment2& base, const Segment2& line) const {
  const std::array<Segment2, 3> parts{line, Segment2{base.start, line.start}, Segment2{base.end, line.end}};
  for (const Segment2& part : parts) {
    for (const Segment2& segment : segments_) {
      if (segmentsCross(part, segment)) return true;
    }
    for (const Box2& label : labels_) {
      if (meets(part, label)) return true;
    }
  }
  return false;
}

bool Landed::hasRoom(const Box2& label) const {
  const Box2 grown = label.grown(kLabelClearancePx);
  for (const Segment2& segment : segments_) {
    if (meets(segment, grown)) return false;
  }
  for (const Box2& other : labels_) {
    if (grown.overlaps(other)) return false;
  }
  return true;
}

}  // namespace dimline
