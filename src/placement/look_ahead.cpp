#include "placement/look_ahead.h"

namespace dimline {

void LookAhead::begin(std::span<const Measured> order, const View& view, bool changed) {
  if (changed) std::swap(past_, present_);
  present_.clear();
  ahead_.clear();
  marks_.resize(order.size());
  const auto inFront = [&](const Segment& s) { return view.inFrontOfNear(s.start) && view.inFrontOfNear(s.end); };
  for (std::size_t rank = order.size(); rank-- > 0;) {
    marks_[rank] = ahead_.mark();
    for (const Line& l : past_) {
      if (l.parameter != order[rank].parameter || !inFront(l.base) || !inFront(l.foot) || !inFront(l.line)) continue;
      ahead_.add(view.toScreen(l.base), view.toScreen(l.foot), view.toScreen(l.line));
    }
  }
}

void LookAhead::forget() {
  past_.clear();
  present_.clear();
}

}  // namespace dimline
