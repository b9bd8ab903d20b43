#pragma once

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "app/editor.h"
#include "editing/arc_drag.h"
#include "editing/handle_drag.h"
#include "placement/placer.h"

namespace dimline {

/// A drag of a handle, of a line or of an arc.
class ValueDrag {
public:
  explicit ValueDrag(HandleDrag drag) : drag_(std::move(drag)) {}
  explicit ValueDrag(ArcDrag drag) : drag_(std::move(drag)) {}

  [[nodiscard]] std::size_t parameter() const {
    return std::visit([](const auto& drag) { return drag.parameter(); }, drag_);
  }
  /// Of its parameter, when it began.
  [[nodiscard]] double startValue() const {
    return std::visit([](const auto& drag) { return drag.startValues().at(drag.parameter()); }, drag_);
  }
  /// As HandleDrag::valueAmong(). An arc stays where it is, so that its angle is a matter of the pointer alone.
  double valueAmong(const Values& others, const Vec2& pointer, const View& view, Snap snap) {
    if (HandleDrag* drag = line()) return drag->valueAmong(others, pointer, view, snap);
    return std::get<ArcDrag>(drag_).valueAt(pointer, view, snap);
  }
  /// Whether this is what is dragged, of all that is placed.
  [[nodiscard]] bool isOf(const PlacedLine& placed) const {
    return line() != nullptr && placed.parameter == parameter() && (placed.chain < 0 || placed.identity == line()->startLine().identity);
  }
  [[nodiscard]] bool isOf(const PlacedHandle& placed) const { return arc() != nullptr && placed.parameter == parameter(); }
  /// As HandleDrag::regrip(), by the line or the arc that this drags. False, and all is as before, when it is not in `layout`.
  bool regrip(const Layout& layout, const Vec2& pointer, const View& view);
  /// Null when it is the other one.
  [[nodiscard]] HandleDrag* line() { return std::get_if<HandleDrag>(&drag_); }
  [[nodiscard]] const HandleDrag* line() const { return std::get_if<HandleDrag>(&drag_); }
  [[nodiscard]] const ArcDrag* arc() const { return std::get_if<ArcDrag>(&drag_); }

private:
  std::variant<HandleDrag, ArcDrag> drag_;
};

/// One pointer's hold of one handle.
struct HandleHold {
  int pointer = 0;
  PointerKind kind = PointerKind::kMouse;
  Snap snap = Snap::kStep;
  Vec2 at{0.0};   ///< px, where the pointer is
  ValueDrag drag;
};

/// Handles that are dragged, one by each pointer that is down and of a parameter each, from the first that goes down to the last that is lifted: one undo
/// step. Never without holds but at its end.
struct HandleGesture {
  Values before;                 ///< what cancelling restores, and the undo step
  Placer::Memory placedBefore;   ///< so that cancelling also puts every line back where it was
  std::vector<HandleHold> holds;   ///< in the order in which they were taken
  bool regrips = false;            ///< the viewport's size changed: where pointers are next is where they take hold anew
  bool moved = false;              ///< pointers are elsewhere than when the values were last brought under them

  [[nodiscard]] auto holdOf(int pointer) { return std::ranges::find(holds, pointer, &HandleHold::pointer); }
  [[nodiscard]] bool drags(std::size_t parameter) const {
    return std::ranges::any_of(holds, [&](const HandleHold& hold) { return hold.drag.parameter() == parameter; });
  }
  /// What drags a line or an arc that is placed; null when nothing does.
  template <typename Placed>
  [[nodiscard]] HandleHold* dragging(const Placed& placed) {
    const auto found = std::ranges::find_if(holds, [&](const HandleHold& hold) { return hold.drag.isOf(placed); });
    return found != holds.end() ? &*found : nullptr;
  }

  /// The values with which every held handle is under its pointer; of those that nobody holds, the `present` ones. The same pointers give the same values,
  /// however they came to where they are.
  [[nodiscard]] Values valuesUnder(const Values& present, const View& view);
};

}  // namespace dimline
