#include <cassert>

#include "app/cover_cost.h"
#include "app/editor_state.h"
#include "editing/arc_projection.h"
#include "editing/value_text.h"

// What values are to people: texts that they type and read, what a drag has led to, what follows from the values.

namespace dimline {

namespace {

/// px. How far outside a label's box a pointer is still on the label.
constexpr double kLabelReachPx = 4.0;

}  // namespace

void Editor::setDecimalMark(char mark) {
  State& s = *state_;
  assert(mark == '.' || mark == ',');
  if (s.decimalMark == mark) return;
  s.finishEdits();
  s.decimalMark = mark;
  if (!s.loaded) return;
  s.takeModel(std::move(s.model));
  s.placeAnew();
}

Result<double> Editor::parseValue(std::size_t parameter, std::string_view text) const {
  return readValueText(state_->model.parameters()[parameter], text);
}

std::string Editor::inputText(std::size_t parameter) const {
  return dimline::inputText(state_->model.parameters()[parameter], state_->values.at(parameter));
}

void Editor::resetParameter(std::size_t parameter) {
  const std::pair<std::size_t, double> change{parameter, state_->model.parameters()[parameter].defaultValue};
  setValues(std::span(&change, 1));
}

std::vector<Editor::MeasureReading> Editor::measures() const {
  const State& s = *state_;
  std::vector<MeasureReading> readings;
  for (std::size_t i = 0; i < s.model.definition.measures.size(); ++i) {
    const Parameter& shown = s.model.definition.measures[i].shown;
    const double value = measuredValue(s.model, i, s.values, s.scene);
    readings.push_back({&shown, value, formatValue(shown, value)});
  }
  return readings;
}

void Editor::setMeasuresShown(bool shown) {
  State& s = *state_;
  if (s.measuresShown == shown) return;
  s.finishEdits();
  s.measuresShown = shown;
  s.sceneStale = s.loaded;  // measures may have a scope of their own
}
bool Editor::measuresShown() const { return state_->measuresShown; }
const Model& Editor::placedModel() const { return state_->placedModel(); }

/// Lines of the same scene have to be placed again, since what they say or which there are has changed.
void Editor::State::placeAnew() {
  if (sceneStale) return;  // it is about to be rebuilt
  if (measuresShown) valuesWithMeasures = withMeasures(model, values, scene);
  placer.setScene(placedModel(), scene);
  viewStale = true;
}

std::vector<Editor::Gesture> Editor::gestures() const {
  std::vector<Gesture> all;
  if (!state_->handleGesture) return all;
  for (const HandleHold& hold : state_->handleGesture->holds) all.push_back(state_->describe(hold));
  return all;
}

Editor::Gesture Editor::State::describe(const HandleHold& hold) const {
  Gesture gesture;
  gesture.id = hold.pointer;
  gesture.parameter = hold.drag.parameter();
  gesture.arc = hold.drag.arc() != nullptr;
  gesture.value = values.at(gesture.parameter);
  const Parameter& parameter = model.parameters()[gesture.parameter];
  gesture.text = formatValue(parameter, gesture.value);
  gesture.difference = differenceText(parameter, hold.drag.startValue(), gesture.value);
  if (gesture.value == clampValue(parameter, parameter.max)) gesture.limit = Gesture::Limit::kMax;
  if (gesture.value == clampValue(parameter, parameter.min)) gesture.limit = Gesture::Limit::kMin;
  gesture.pointer = hold.kind;
  gesture.snap = static_cast<DragSnap>(hold.snap);
  for (const PlacedLine& line : drawn.lines) {
    if (!hold.drag.isOf(line)) continue;
    const bool atEnd = hold.drag.line()->atEnd();
    gesture.handle = atEnd ? line.lineScreen.end : line.lineScreen.start;
    const Vec2 outward = gesture.handle - (atEnd ? line.lineScreen.start : line.lineScreen.end);
    if (glm::length(outward) > 0) gesture.direction = glm::normalize(outward);
  }
  for (const PlacedHandle& handle : drawn.others) {
    if (!hold.drag.isOf(handle) || !handle.arc) continue;
    const Vec2 tip = drawn.view.toScreen(handle.arc->at(handle.arc->angleRad));
    const Vec2 onward = drawn.view.toScreen(handle.arc->at(handle.arc->angleRad + 0.01)) - tip;
    gesture.handle = tip;
    if (glm::length(onward) > 0) gesture.direction = glm::normalize(onward);
  }
  return gesture;
}

std::optional<std::size_t> Editor::parameterAt(const Vec2& screen, PointerKind kind) const {
  const State& s = *state_;
  if (!isFinite(screen)) return std::nullopt;
  if (const auto grip = s.gripAt({.kind = kind, .screen = screen})) return s.keyOf(*grip).parameter;
  for (const PlacedLine& line : s.drawn.lines) {
    if (line.label && line.parameter < s.model.parameters().size() && line.label->grown(kLabelReachPx).overlaps({screen, screen})) return line.parameter;
  }
  for (const PlacedHandle& handle : s.drawn.others) {
    if (handle.box.grown(kLabelReachPx).overlaps({screen, screen})) return handle.parameter;
  }
  return std::nullopt;
}

double Editor::coverCost(const Box2& box) const { return dimline::coverCost(box, state_->drawn, state_->fieldSource.fields()); }

void Editor::setHiddenShown(bool shown) {
  State& s = *state_;
  if (s.hiddenShown == shown) return;
  s.hiddenShown = shown;
  s.placer.showHidden(shown);
  s.viewStale = true;
}
bool Editor::hiddenShown() const { return state_->hiddenShown; }

}  // namespace dimline
