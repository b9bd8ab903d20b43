#include "cli/audit_odds.h"

#include <algorithm>

#include "cli/audit_geometry.h"

namespace dimline {

Odds::Sort Odds::sortIn(std::size_t frame, std::size_t parameter) const {
  const Layout& layout = layouts_[frame];
  Sort sort = Sort::kHidden;
  for (const PlacedLine& line : layout.lines) {
    if (line.parameter != parameter) continue;
    if (!isOutside(line)) return Sort::kInside;
    sort = Sort::kOutside;
  }
  const auto other = std::ranges::find(layout.others, parameter, &PlacedHandle::parameter);
  if (other == layout.others.end()) return sort;
  return other->placement == PlacementKind::kInside ? Sort::kInside : Sort::kOutside;
}

bool Odds::isLineOf(std::size_t parameter) const {
  return model_.annotations[parameter] && isLine(model_.annotations[parameter]->type);
}

AuditedFrame Odds::at(std::size_t frame) {
  if (drawn_ != frame) {
    depth_.draw(scene_, layouts_[frame].view);
    mask_.read(depth_.mask());
    drawn_ = frame;
  }
  return {&model_, &scene_, &layouts_[frame], &mask_, &depth_};
}

bool Odds::hasRoom(std::size_t frame, std::size_t parameter, PlacesWanted wanted) {
  const Sort sort = sortIn(frame, parameter);
  if (sort != Sort::kInside) return sort == Sort::kOutside;
  const std::vector<PlacedLine>& lines = layouts_[frame].lines;
  const AuditedFrame audited = at(frame);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].parameter == parameter && !isOutside(lines[i]) && outsidePlace(audited, i, wanted)) return true;
  }
  return false;
}

bool Odds::isInPlainView(std::size_t frame, std::size_t parameter) {
  return scopeInPlainView(at(frame), parameter).has_value();
}

bool Odds::cannotBeShown(std::size_t frame, std::size_t parameter) {
  const std::vector<HiddenParameter>& all = layouts_[frame].hidden;
  const auto hidden = std::ranges::find(all, parameter, &HiddenParameter::parameter);
  return hidden != all.end() && hidden->reason != HiddenReason::kCrowded && !isInPlainView(frame, parameter);
}

template <typename Holds>
bool Odds::isBrief(std::size_t parameter, std::size_t frame, Holds holds) const {
  std::size_t first = frame, end = frame + 1;
  while (end - first <= kTakenBackFrames && first > 0 && holds(first - 1)) --first;
  while (end - first <= kTakenBackFrames && end < layouts_.size() && holds(end)) ++end;
  if (end - first > kTakenBackFrames || first == 0 || end == layouts_.size()) return false;
  return names_[first - 1].leg == names_[end].leg && sortIn(first - 1, parameter) == sortIn(end, parameter);
}

bool Odds::lacksLastingRoom(std::size_t parameter, std::size_t frame) {
  const auto hasClearRoom = [&](std::size_t i) { return hasRoom(i, parameter, PlacesWanted::kClear); };
  return !hasClearRoom(frame) || isBrief(parameter, frame, hasClearRoom);
}

bool Odds::isBrieflyInView(std::size_t parameter, std::size_t frame) {
  return isBrief(parameter, frame, [&](std::size_t i) {
    return sortIn(i, parameter) != Sort::kHidden || isInPlainView(i, parameter);
  });
}

bool Odds::hadToGoBack(std::size_t parameter, std::size_t changed, std::size_t back) {
  const Sort before = sortIn(changed - 1, parameter);
  const Sort after = sortIn(changed, parameter);
  const auto anyInPlainView = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, layouts_.size()); ++i) {
      if (isInPlainView(i, parameter)) return true;
    }
    return false;
  };
  if (before == Sort::kHidden) return cannotBeShown(back, parameter) && anyInPlainView(changed, back);
  if (after == Sort::kHidden) {
    return cannotBeShown(changed, parameter) && anyInPlainView(back, changed + kTakenBackFrames + 1);
  }
  if (before == after || !isLineOf(parameter)) return false;
  return !hasRoom(before == Sort::kInside ? back : changed, parameter, PlacesWanted::kAll);
}

}  // namespace dimline
