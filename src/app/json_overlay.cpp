#include "app/json_overlay.h"

#include <cmath>

#include "app/editor_words.h"
#include "app/json.h"

namespace dimline {

namespace {

/// A hundredth of a pixel: what the DOM can use, in few digits.
double roundedPx(double px) { return std::round(px * 100.0) / 100.0; }
Vec2 roundedPx(const Vec2& px) { return {roundedPx(px.x), roundedPx(px.y)}; }
Box2 roundedPx(const Box2& box) { return {roundedPx(box.min), roundedPx(box.max)}; }
double roundedShare(double share) { return std::round(share * 1000.0) / 1000.0; }

template <typename Placed>
void writeLabel(JsonWriter& json, std::span<const Parameter> parameters, const Placed& placed, const Box2* box, const Editor::LineState& state, bool fading) {
  if (placed.parameter >= parameters.size()) return;  // a measure that fades since measures are shown no more
  json.beginObject();
  json.key("id").value(identityText(placed.identity, parameters) + (fading ? "~" : ""));
  json.key("parameter").value(placed.parameter);
  json.key("name").value(parameters[placed.parameter].name);
  json.key("text").value(placed.text);
  json.key("box");
  box != nullptr ? json.value(roundedPx(*box)) : json.null();
  json.key("inside").value(placed.placement == PlacementKind::kInside);
  json.key("opacity").value(roundedShare(state.opacity));
  json.key("hovered").value(state.hovered);
  json.key("dragged").value(state.dragged);
  json.key("measure").value(parameters[placed.parameter].measure);
  json.key("handles").beginArray();
  for (const Handle& handle : placed.handles) {
    if (fading) break;
    json.beginObject().key("end").value(handle.atEnd ? "end" : "start").key("screen").value(roundedPx(handle.screen)).endObject();
  }
  json.endArray();
  json.endObject();
}

const Box2* boxOf(const PlacedLine& line) { return line.label ? &*line.label : nullptr; }

void writePill(JsonWriter& json, const Parameter& parameter, const PlacedHandle& handle, double opacity, bool fading) {
  json.beginObject();
  json.key("parameter").value(handle.parameter);
  json.key("name").value(parameter.name);
  json.key("fading").value(fading);
  json.key("value");
  writeValue(json, parameter, handle.value);
  json.key("box").value(roundedPx(handle.box));
  json.key("opacity").value(roundedShare(opacity));
  json.key("options").beginArray();
  for (const RangeOption& option : handle.options) {
    json.beginObject().key("value");
    writeValue(json, parameter, option.value);
    json.key("box").value(roundedPx(option.box)).endObject();
  }
  json.endArray();
  json.endObject();
}

}  // namespace

void writeLabels(JsonWriter& json, const Editor& editor) {
  const auto parameters = editor.placedModel().parameters();
  const Layout& layout = editor.layout();
  json.beginArray();
  for (std::size_t i = 0; i < layout.lines.size(); ++i) {
    writeLabel(json, parameters, layout.lines[i], boxOf(layout.lines[i]), editor.lineStates()[i], false);
  }
  for (std::size_t i = 0; i < layout.others.size(); ++i) {
    const PlacedHandle& handle = layout.others[i];
    if (handle.arc) writeLabel(json, parameters, handle, &handle.box, editor.otherStates()[i], false);
  }
  for (const Editor::FadingLine& fading : editor.fadingLines()) {
    writeLabel(json, parameters, fading.line, boxOf(fading.line), {fading.opacity}, true);
  }
  for (const Editor::FadingHandle& fading : editor.fadingHandles()) {
    if (fading.handle.arc) writeLabel(json, parameters, fading.handle, &fading.handle.box, {fading.opacity}, true);
  }
  json.endArray();
}

void writePills(JsonWriter& json, const Editor& editor) {
  const auto parameters = editor.model().parameters();
  const Layout& layout = editor.layout();
  json.beginArray();
  for (std::size_t i = 0; i < layout.others.size(); ++i) {
    const PlacedHandle& handle = layout.others[i];
    if (!handle.arc) writePill(json, parameters[handle.parameter], handle, editor.otherStates()[i].opacity, false);
  }
  for (const Editor::FadingHandle& fading : editor.fadingHandles()) {
    if (!fading.handle.arc) writePill(json, parameters[fading.handle.parameter], fading.handle, fading.opacity, true);
  }
  json.endArray();
}

void writeGestures(JsonWriter& json, const Editor& editor) {
  json.beginArray();
  for (const Editor::Gesture& gesture : editor.gestures()) {
    const Parameter& parameter = editor.model().parameters()[gesture.parameter];
    json.beginObject();
    json.key("id").value(gesture.id).key("parameter").value(parameter.name).key("kind").value(gesture.arc ? "arc" : "line");
    json.key("value");
    writeValue(json, parameter, gesture.value);
    json.key("text").value(gesture.text).key("difference").value(gesture.difference);
    json.key("limit");
    gesture.limit == Editor::Gesture::Limit::kNone ? json.null() : json.value(wordFor(kLimits, gesture.limit));
    json.key("handle").value(roundedPx(gesture.handle)).key("direction").value(gesture.direction);
    json.key("pointer").value(wordFor(kPointerKinds, gesture.pointer)).key("snap").value(wordFor(kSnaps, gesture.snap));
    json.endObject();
  }
  json.endArray();
}

void writeMeasures(JsonWriter& json, const Editor& editor) {
  json.beginArray();
  for (const Editor::MeasureReading& measure : editor.measures()) {
    json.beginObject();
    json.key("name").value(measure.shown->name).key("title").value(measure.shown->title).key("help").value(measure.shown->help);
    json.key("unit").value(name(measure.shown->unit)).key("value").value(measure.value).key("text").value(measure.text);
    json.endObject();
  }
  json.endArray();
}

}  // namespace dimline
