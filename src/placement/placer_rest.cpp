#include <algorithm>
#include <utility>

#include "placement/pills.h"
#include "placement/placer_state.h"

// What a picture in which lines settle gets once all of them are there: nothing else will move then, so labels and switches can be laid out as a whole.

namespace dimline {

/// The last that is done where lines settle, and all that is done after an edit.
void Placer::State::tidy(const FrameToPlace& frame, Layout& layout) {
  const bool settles = std::exchange(kind, {}).settles;
  beforeAttempts = past;
  tidyLabels(frame, layout.lines);
  past.labels.note(layout.lines, true);
  FrameToPlace still = frame;
  still.viewMoved = false;
  const auto keepFromLabels = [&](double px) {
    occupied.keepFromLabels(px);
    placeMended(still, false, true, layout);
  };
  if (settles) {
    keepFromLabels(kLabelClearanceSettledPx);
    for (std::size_t i = 0; i < past.histories.size(); ++i) {   // who has no room by the greater distance looks again by the lesser one
      if (past.histories[i].hiddenForWantOfRoom()) past.histories[i] = beforeAttempts.histories[i];
    }
  }
  // The last time is as before a still camera, so that nothing moves in the next frame: what found no room by the greater distance is where it would go then.
  keepFromLabels(kLabelClearancePx);
  if (!settles && !std::ranges::equal(past.histories, beforeAttempts.histories, {}, &History::last, &History::last)) {   // after an edit lines keep their places
    past = beforeAttempts;
    keepFromLabels(kLabelClearancePx);
  }
  kind.settles = true;
  placeInBestOrder(still, layout);
  labelInside(still, layout.lines);
  past.rest = Rest::kSettled;
}

void Placer::State::tidyLabels(const FrameToPlace& frame, std::span<PlacedLine> lines) {
  landedElsewhere = occupied.landed();
  for (std::size_t first = 0, last = 0; first < lines.size(); first = last) {
    while (last < lines.size() && lines[last].parameter == lines[first].parameter) ++last;
    if (lines[first].placement == PlacementKind::kInside) continue;
    const auto measured = std::ranges::find(order, lines[first].parameter, &Measured::parameter);
    labelTidying.tidy(lines.subspan(first, last - first), measured->textSize, frame.fields, frame.view.viewport(), landedElsewhere);
  }
}

/// What others beside the lines are worth together (px), as they stand.
double Placer::State::worthOfPills(std::span<const PlacedHandle> placed) const {
  double worth = 0;
  for (const std::size_t number : past.othersOrder) {
    const Measured& other = others[number];
    const auto pill = std::ranges::find(placed, other.parameter, &PlacedHandle::parameter);
    if (pill == placed.end()) worth += kScoreInside;
    else if (!pill->arc) worth += pillWorth(*pill, other.annotation, occupied.landed());
  }
  return worth;
}

/// One switch comes before another where all are better off: each further order that is better is kept, and stays when the camera moves on.
void Placer::State::placeInBestOrder(const FrameToPlace& frame, Layout& layout) {
  constexpr double kLeastGainPx = 1.0;
  const std::size_t placedBefore = layout.others.size(), hiddenBefore = layout.hidden.size();
  besideLines = occupied.contents();
  historiesBesideLines = past.histories;
  const auto place = [&] {
    occupied.goBackTo(besideLines);
    past.histories = historiesBesideLines;
    for (; layout.others.size() > placedBefore; layout.others.pop_back()) spareHandles.push_back(std::move(layout.others.back()));
    layout.hidden.resize(hiddenBefore);
    placeBesideLines(frame, layout);
    return worthOfPills(layout.others);
  };
  double best = place();
  if (!hasRoomForPills(frame.view)) return;
  auto& numbers = past.othersOrder;
  for (std::size_t later = 1; later < numbers.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      bestOthersOrder = numbers;
      for (std::size_t i = later; i > earlier; --i) std::swap(numbers[i], numbers[i - 1]);
      if (const double worth = place(); worth > best + kLeastGainPx) best = worth;
      else numbers = bestOthersOrder;
    }
  }
  place();
}

}  // namespace dimline
