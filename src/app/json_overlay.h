#pragma once

#include "app/editor.h"
#include "app/json_writer.h"

/// The JSON of what a host shows over the picture by itself, as the editor's last frame has it; web/core.js says of each what its fields mean. Positions are in
/// hundredths of a pixel.
namespace dimline {

/// Of every line and every arc, those that fade away too: [{id, parameter, name, text, box, inside, opacity, hovered, dragged, measure, handles}…]. `box` is null
/// where there is no room for the text; the `id` of one that fades ends in "~", so that it is not taken for one that comes in its place.
void writeLabels(JsonWriter& json, const Editor& editor);

/// Of every switch and every choice: [{parameter, name, fading, value, box, opacity, options: [{value, box}…]}…].
void writePills(JsonWriter& json, const Editor& editor);

/// Of every handle that is being dragged: [{id, parameter, kind, value, text, difference, limit, handle, direction, pointer, snap}…].
void writeGestures(JsonWriter& json, const Editor& editor);

/// Of every measure: [{name, title, help, unit, value, text}…].
void writeMeasures(JsonWriter& json, const Editor& editor);

}  // namespace dimline
