#include "app/handle_gesture.h"

namespace dimline {

namespace {

/// Handles that move each other's lines are brought under their pointers in turn so often. The second time the first ones follow what the last ones did; more
/// helps only where each moves the other.
constexpr int kMostRounds = 4;

}  // namespace

bool ValueDrag::regrip(const Layout& layout, const Vec2& pointer, const View& view) {
  const auto isMine = [&](const auto& placed) { return isOf(placed); };
  if (HandleDrag* drag = line()) {
    const auto found = std::ranges::find_if(layout.lines, isMine);
    if (found == layout.lines.end()) return false;
    drag->regrip(*found, pointer, view);
  } else {
    const auto found = std::ranges::find_if(layout.others, isMine);
    if (found == layout.others.end()) return false;
    std::get<ArcDrag>(drag_).regrip(*found, pointer, view);
  }
  return true;
}

Values HandleGesture::valuesUnder(const Values& present, const View& view) {
  Values values = present;
  for (const HandleHold& hold : holds) values.set(hold.drag.parameter(), hold.drag.startValue());
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (HandleHold& hold : holds) {
      const std::size_t parameter = hold.drag.parameter();
      const double value = hold.drag.valueAmong(values, hold.at, view, hold.snap);
      changed |= value != values.at(parameter);
      values.set(parameter, value);
    }
    if (!changed || holds.size() == 1) break;
  }
  return values;
}

}  // namespace dimline
