#include "placement/label_tidying.h"

#include <algorithm>

namespace dimline {

namespace {

using Side = LabelPlace::Side;
constexpr auto kSides = {Side::kOnLine, Side::kOutward, Side::kInward};

}  // namespace

void LabelTidying::tidy(std::span<PlacedLine> lines, const Vec2& textSize, const DistanceFields& model, const Box2& viewport, Landed& landed) {
  for (const PlacedLine& line : lines) {
    if (line.label) landed.removeLabel(*line.label);
  }
  putInOrder(lines);
  const Place among{lines, textSize, model, viewport, landed};
  const bool beside = lines.size() > 1 || carriesLabel(members_.front(), textSize);
  const bool found = (beside && labelOnOneSide(among)) || labelEvenly(among) || label(among, {}, false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    PlacedLine& line = lines[i];
    if (found) {
      line.label.reset();
      if (found_[i]) {
        line.label = found_[i]->box;
        line.labelPlace = found_[i]->place;
      }
    }
    if (line.label) landed.addLabel(*line.label);
  }
}

/// Along the chain, from the end where its lines are longer on screen: a bare one at the other end is missed less.
void LabelTidying::putInOrder(std::span<const PlacedLine> lines) {
  members_.clear();
  inOrder_.clear();
  const auto [shortest, longest] = std::ranges::minmax_element(lines, {}, [](const PlacedLine& line) { return line.lineScreen.length(); });
  const Vec2 along = shortest->lineScreen.middle() - longest->lineScreen.middle();
  for (const PlacedLine& line : lines) {
    inOrder_.push_back({glm::dot(line.lineScreen.middle(), along), static_cast<std::uint32_t>(members_.size())});
    members_.push_back(line.lineScreen);
  }
  sortKeys(inOrder_);
}

/// Looks for a label for those lines that the pattern names. Returns whether any has one; `all`: whether all have.
bool LabelTidying::label(const Place& among, const Pattern& pattern, bool all) {
  labels_.clear();
  found_.assign(among.lines.size(), std::nullopt);
  for (std::size_t i = pattern.start; i < inOrder_.size(); i += pattern.step) {
    const PlacedLine& line = among.lines[inOrder_[i].index];
    auto& found = found_[inOrder_[i].index];
    found = placeLabel({.line = line.lineScreen,
                        .textSize = among.textSize,
                        .outward = line.lineScreen.middle() - line.baseScreen.middle(),
                        .model = &among.model,
                        .parameter = static_cast<int>(line.parameter),
                        .side = pattern.side,
                        .centred = pattern.centred,
                        .fellows = members_,
                        .fellowLabels = labels_},
                       among.landed, among.viewport);
    if (found) labels_.push_back(found->box);
    else if (all) return false;
  }
  return !labels_.empty();
}

bool LabelTidying::labelOnOneSide(const Place& among) {
  return std::ranges::any_of(kSides, [&](Side side) { return label(among, {.side = side}, true); });
}

bool LabelTidying::labelEvenly(const Place& among) {
  const std::size_t count = among.lines.size();
  for (std::size_t step = 2; step < count; ++step) {
    // As many bare ones before the first as after the last, or nearly so.
    const std::size_t evenStart = (count - 1) % step / 2;
    for (std::size_t i = 0; i < step; ++i) {
      for (const Side side : kSides) {
        if (label(among, {.side = side, .centred = true, .start = (evenStart + i) % step, .step = step}, true)) return true;
      }
    }
  }
  return false;
}

}  // namespace dimline
