#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/json_writer.h"
#include "core/result.h"
#include "math/camera.h"
#include "model/model.h"
#include "placement/layout.h"

/// JSON: what the command line writes and reads, and what crosses to JavaScript.
/// Reading gives an Error that names the field and says what should stand there. Angles are in degrees in JSON.
namespace dimline {

// --- Parameters
// -------------------------------------------------------------------------------------------------------

/// A value as its type has it: true or false, the name of a choice, or a number.
void writeValue(JsonWriter& json, const Parameter& parameter, double value);

/// The objects of getParameters(): [{name, title, help, type, value, default, min, max, step, unit, choices, group,
/// annotation}…]. Minimum, maximum and step of a switch or a choice are null, choices of anything else [].
void writeParameters(JsonWriter& json, std::span<const Parameter> parameters, const Values& values);

/// {name: value, …}
void writeValues(JsonWriter& json, std::span<const Parameter> parameters, const Values& values);

/// A value out of JSON text, clamped to the range: a number for a float, count or angle, true or false for a switch, a
/// name for a choice.
Result<double> readValue(const Parameter& parameter, std::string_view json);

/// {name: value, …}, each as readValue: indices and values, in the order of the text. An error, and nothing else, when
/// any of it is wrong.
Result<std::vector<std::pair<std::size_t, double>>> readValues(std::span<const Parameter> parameters,
                                                               std::string_view json);

// --- Cameras
// ----------------------------------------------------------------------------------------------------------

/// {"eye":[3],"target":[3],"up":[3],"fovDeg":…} or "orthoHeight" in place of "fovDeg".
void writeCamera(JsonWriter& json, const Camera& camera);

/// One such object. `eye` and `target` are required; `up` is [0, 1, 0] and the field of view the page's when they are
/// missing. The camera is valid (see validate()).
Result<Camera> readCamera(std::string_view json);

/// An array of them (CAMS.json); the error says which one.
Result<std::vector<Camera>> readCameras(std::string_view json);

// --- Layouts
// ----------------------------------------------------------------------------------------------------------

/// The FRAME of section 6. For a model with measures (withMeasures()) it has an array "measures" too, of objects as in "lines", which nobody can drag.
void writeFrame(JsonWriter& json, const Model& model, const Scene& scene, const Layout& layout);

}  // namespace dimline
