#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/html5.h>
#include <emscripten/val.h>

#include "app/editor.h"
#include "app/editor_words.h"
#include "app/json.h"
#include "app/json_overlay.h"
#include "bindings/byte_array.h"
#include "core/text.h"
#include "model/imported_scene.h"
#include "models/models.h"

// The Editor as JavaScript sees it. Text and numbers cross by value, lists as JSON text, files as copies of typed
// arrays; nothing that JavaScript holds points into this module's memory. A method that can fail gives a sentence,
// empty when all went well. Nothing throws.

namespace dimline {

namespace {

std::string sentence(const Status& status) { return status ? std::string() : status.error().message; }

/// A word out of a list, as an index; nothing for another word.
std::optional<std::size_t> indexOf(std::string_view word, std::span<const std::string_view> words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return i;
  }
  return std::nullopt;
}

std::string notOneOf(std::string_view what, std::string_view word, std::span<const std::string_view> words) {
  return std::string(what) + " is one of " + joined(words, "or") + ", not " + inQuotes(word) + ".";
}

Modifiers modifiersFrom(int bits) {
  return {.shift = (bits & 1) != 0, .ctrl = (bits & 2) != 0, .alt = (bits & 4) != 0, .meta = (bits & 8) != 0};
}

/// Anything but the middle and the secondary button counts as the primary one; any device but a finger or a pen as a
/// mouse.
PointerInput pointerFrom(int id, const std::string& kind, int button, double x, double y, int modifierBits) {
  PointerInput input;
  input.id = id;
  input.kind = static_cast<PointerKind>(indexOf(kind, kPointerKinds).value_or(0));
  input.button = button == 1   ? PointerButton::kMiddle
                 : button == 2 ? PointerButton::kSecondary
                               : PointerButton::kPrimary;
  input.modifiers = modifiersFrom(modifierBits);
  input.screen = {x, y};
  return input;
}

std::string modelsJson() {
  JsonWriter json;
  json.beginArray();
  for (const BuiltInModel& model : builtInModels()) {
    json.beginObject().key("name").value(model.name).key("title").value(model.define().title).endObject();
  }
  return json.endArray().take();
}

class EditorBinding {
public:
  // --- Document ---
  std::string setModel(const std::string& name) {
    auto model = findBuiltInModel(name);
    if (!model) return model.error().message;
    return sentence(editor_.setModel(std::move(model).value()));
  }

  /// What the module dimline_gltf made of a file.
  std::string setScene(const emscripten::val& bytes) {
    const auto content = bytesOf(bytes);
    if (!content) return "A scene is a Uint8Array, as the reader of glTF files gives it.";
    auto scene = importedSceneFrom(*content);
    if (!scene) return scene.error().message;
    auto model = stretchedModel(std::move(scene).value());
    if (!model) return model.error().message;
    return sentence(editor_.setModel(std::move(model).value()));
  }

  [[nodiscard]] std::string parametersJson() const {
    JsonWriter json;
    writeParameters(json, editor_.model().parameters(), editor_.values());
    return json.take();
  }

  std::string setParametersJson(const std::string& text) {
    const auto changes = readValues(editor_.model().parameters(), text);
    if (!changes) return changes.error().message;
    editor_.setValues(*changes);
    return {};
  }

  std::string beginWithJson(const std::string& text) {
    const auto changes = readValues(editor_.model().parameters(), text);
    if (!changes) return changes.error().message;
    editor_.beginWith(*changes);
    return {};
  }

  std::string setParameterContinuous(const std::string& name, const std::string& text) {
    const auto parameters = editor_.model().parameters();
    const auto index = findParameter(parameters, name);
    if (!index) return unknownParameter(name).message;
    const auto value = readValue(parameters[*index], text);
    if (!value) return value.error().message;
    editor_.setValueContinuous(*index, *value);
    return {};
  }

  void endContinuous() { editor_.endContinuous(); }

  /// {"value": …}, or {"error": a sentence}.
  [[nodiscard]] std::string parseValueJson(const std::string& name, const std::string& text) const {
    const auto parameters = editor_.model().parameters();
    const auto index = findParameter(parameters, name);
    const Result<double> value = index ? editor_.parseValue(*index, text) : unknownParameter(name);
    JsonWriter json;
    json.beginObject();
    if (value) {
      json.key("value");
      writeValue(json, parameters[*index], *value);
    } else {
      json.key("error").value(value.error().message);
    }
    return json.endObject().take();
  }
  [[nodiscard]] std::string inputText(const std::string& name) const {
    const auto index = findParameter(editor_.model().parameters(), name);
    return index ? editor_.inputText(*index) : std::string();
  }
  std::string resetParameter(const std::string& name) {
    const auto index = findParameter(editor_.model().parameters(), name);
    if (!index) return unknownParameter(name).message;
    editor_.resetParameter(*index);
    return {};
  }
  std::string setDecimalMark(const std::string& mark) {
    if (mark != "." && mark != ",") return "The decimal mark is \".\" or \",\", not " + inQuotes(mark) + ".";
    editor_.setDecimalMark(mark[0]);
    return {};
  }

  [[nodiscard]] std::string measuresJson() const { return written(writeMeasures); }
  void setMeasuresShown(bool shown) { editor_.setMeasuresShown(shown); }
  [[nodiscard]] bool measuresShown() const { return editor_.measuresShown(); }

  void undo() { editor_.undo(); }
  void redo() { editor_.redo(); }
  [[nodiscard]] bool canUndo() const { return editor_.canUndo(); }
  [[nodiscard]] bool canRedo() const { return editor_.canRedo(); }

  // --- Viewport and camera ---
  void resize(double width, double height, double ratio) { editor_.resize(width, height, ratio); }

  [[nodiscard]] std::string cameraJson() const {
    JsonWriter json;
    writeCamera(json, editor_.camera());
    return json.take();
  }

  std::string setCameraJson(const std::string& text) {
    const auto camera = readCamera(text);
    if (!camera) return camera.error().message;
    return sentence(editor_.setCamera(*camera));
  }

  void fitToView() { editor_.fitToView(); }

  std::string setStandardView(const std::string& name) {
    const auto view = indexOf(name, kStandardViews);
    if (!view) return notOneOf("A standard view", name, kStandardViews);
    editor_.setStandardView(static_cast<StandardView>(*view));
    return {};
  }

  void setOrthographic(bool orthographic) { editor_.setOrthographic(orthographic); }
  [[nodiscard]] bool isOrthographic() const { return editor_.orthographic(); }

  // --- Input ---
  std::string pointerDown(int id, const std::string& kind, int button, double x, double y, int modifierBits) {
    return std::string(wordFor(kPointerTargets, editor_.pointerDown(pointerFrom(id, kind, button, x, y, modifierBits))));
  }
  std::string pointerMove(int id, const std::string& kind, int button, double x, double y, int modifierBits) {
    return std::string(wordFor(kPointerTargets, editor_.pointerMove(pointerFrom(id, kind, button, x, y, modifierBits))));
  }
  void pointerUp(int id, const std::string& kind, int button, double x, double y, int modifierBits) {
    editor_.pointerUp(pointerFrom(id, kind, button, x, y, modifierBits));
  }
  std::string hover(int id, const std::string& kind, int button, double x, double y, int modifierBits) {
    return std::string(wordFor(kPointerTargets, editor_.hover(pointerFrom(id, kind, button, x, y, modifierBits))));
  }
  void endHover() { editor_.endHover(); }
  void cancelGesture() { editor_.cancelGesture(); }
  void cancelPointer(int id) { editor_.cancelPointer(id); }
  [[nodiscard]] std::string gesturesJson() const { return written(writeGestures); }
  /// Empty when nothing is there.
  [[nodiscard]] std::string handleAt(double x, double y, const std::string& kind) const {
    const auto at = editor_.parameterAt({x, y}, static_cast<PointerKind>(indexOf(kind, kPointerKinds).value_or(0)));
    return at ? editor_.model().parameters()[*at].name : std::string();
  }
  [[nodiscard]] double coverCost(double x0, double y0, double x1, double y1) const { return editor_.coverCost({{x0, y0}, {x1, y1}}); }
  void wheel(double x, double y, double deltaPx, int modifierBits) {
    editor_.wheel({x, y}, deltaPx, modifiersFrom(modifierBits));
  }

  // --- Frames ---
  std::string attachContext(int handle) {
    if (handle <= 0 || emscripten_webgl_make_context_current(handle) != EMSCRIPTEN_RESULT_SUCCESS) {
      return "This is no WebGL 2 context of this module, or it is lost.";
    }
    context_ = handle;
    editor_.attachRenderer();
    return {};
  }
  void detachContext() {
    makeCurrent();
    editor_.detachRenderer();
    context_ = 0;
  }
  void contextLost() {
    editor_.abandonRenderer();
    context_ = 0;
  }
  bool frame(double nowMs) {
    makeCurrent();
    return editor_.frame(nowMs);
  }
  [[nodiscard]] bool atRest() const { return editor_.atRest(); }
  [[nodiscard]] std::string problem() const { return editor_.problem(); }
  void setReducedMotion(bool reduced) { editor_.setReducedMotion(reduced); }
  void setLinesShown(bool shown) { editor_.setLinesShown(shown); }
  [[nodiscard]] bool linesShown() const { return editor_.linesShown(); }
  void setHiddenShown(bool shown) { editor_.setHiddenShown(shown); }
  [[nodiscard]] bool hiddenShown() const { return editor_.hiddenShown(); }

  [[nodiscard]] std::string layoutJson() const {
    JsonWriter json;
    writeFrame(json, editor_.placedModel(), editor_.scene(), editor_.layout());
    return json.take();
  }

  [[nodiscard]] std::string labelsJson() const { return written(writeLabels); }
  [[nodiscard]] std::string pillsJson() const { return written(writePills); }

  std::string eventsJson() {
    JsonWriter json;
    json.beginArray();
    for (const EditorEvent event : editor_.takeEvents()) json.value(wordFor(kEvents, event));
    return json.endArray().take();
  }

  // --- For tests and measurements ---
  std::string setFieldsFrom(const std::string& name) {
    const auto from = indexOf(name, kFieldsFrom);
    if (!from) return notOneOf("The fields' producer", name, kFieldsFrom);
    editor_.setFieldsFrom(static_cast<Editor::FieldsFrom>(*from));
    return {};
  }
  [[nodiscard]] std::string fieldsFrom() const { return std::string(wordFor(kFieldsFrom, editor_.fieldsFrom())); }

  std::string fieldsJson(const std::string& name) {
    const auto from = indexOf(name, kFieldsFrom);
    makeCurrent();
    const auto fields = from ? editor_.measureFields(static_cast<Editor::FieldsFrom>(*from)) : std::nullopt;
    if (!fields) return "null";
    JsonWriter json;
    json.beginObject().key("width").value(fields->widthPx).key("height").value(fields->heightPx);
    for (const auto& [key, edge] : {std::pair{"left", ViewportEdge::kLeft}, std::pair{"right", ViewportEdge::kRight},
                                    std::pair{"top", ViewportEdge::kTop}, std::pair{"bottom", ViewportEdge::kBottom}}) {
      json.key(key).beginArray();
      for (const float value : (*fields)[edge].values()) json.value(static_cast<double>(value));  // no silhouette: null
      json.endArray();
    }
    return json.endObject().take();
  }

  [[nodiscard]] std::string timingsJson() const {
    const Editor::Timings& timings = editor_.timings();
    JsonWriter json;
    json.beginObject();
    json.key("rebuildMs").value(timings.rebuildMs).key("fieldsMs").value(timings.fieldsMs);
    json.key("visibilityMs").value(timings.visibilityMs);
    json.key("placeMs").value(timings.placeMs).key("drawMs").value(timings.drawMs);
    json.key("fieldsFrom").value(wordFor(kFieldsFrom, editor_.fieldsMeasuredBy()));
    return json.endObject().take();
  }

private:
  [[nodiscard]] std::string written(void (*write)(JsonWriter&, const Editor&)) const {
    JsonWriter json;
    write(json, editor_);
    return json.take();
  }

  /// Several editors can live in one module, each with a context of its own.
  void makeCurrent() const {
    if (context_ != 0) emscripten_webgl_make_context_current(context_);
  }

  static Error unknownParameter(std::string_view name) { return Error{"There is no parameter " + inQuotes(name) + "."}; }

  Editor editor_;
  int context_ = 0;
};

}  // namespace

EMSCRIPTEN_BINDINGS(dimline) {
  using emscripten::function;

  emscripten::function("modelsJson", &modelsJson);
  emscripten::class_<EditorBinding>("Editor")
      .constructor<>()
      .function("setModel", &EditorBinding::setModel)
      .function("setScene", &EditorBinding::setScene)
      .function("parametersJson", &EditorBinding::parametersJson)
      .function("setParametersJson", &EditorBinding::setParametersJson)
      .function("beginWithJson", &EditorBinding::beginWithJson)
      .function("setParameterContinuous", &EditorBinding::setParameterContinuous)
      .function("endContinuous", &EditorBinding::endContinuous)
      .function("parseValueJson", &EditorBinding::parseValueJson)
      .function("inputText", &EditorBinding::inputText)
      .function("resetParameter", &EditorBinding::resetParameter)
      .function("setDecimalMark", &EditorBinding::setDecimalMark)
      .function("measuresJson", &EditorBinding::measuresJson)
      .function("setMeasuresShown", &EditorBinding::setMeasuresShown)
      .function("measuresShown", &EditorBinding::measuresShown)
      .function("undo", &EditorBinding::undo)
      .function("redo", &EditorBinding::redo)
      .function("canUndo", &EditorBinding::canUndo)
      .function("canRedo", &EditorBinding::canRedo)
      .function("resize", &EditorBinding::resize)
      .function("cameraJson", &EditorBinding::cameraJson)
      .function("setCameraJson", &EditorBinding::setCameraJson)
      .function("fitToView", &EditorBinding::fitToView)
      .function("setStandardView", &EditorBinding::setStandardView)
      .function("setOrthographic", &EditorBinding::setOrthographic)
      .function("isOrthographic", &EditorBinding::isOrthographic)
      .function("pointerDown", &EditorBinding::pointerDown)
      .function("pointerMove", &EditorBinding::pointerMove)
      .function("pointerUp", &EditorBinding::pointerUp)
      .function("gesturesJson", &EditorBinding::gesturesJson)
      .function("handleAt", &EditorBinding::handleAt)
      .function("coverCost", &EditorBinding::coverCost)
      .function("hover", &EditorBinding::hover)
      .function("endHover", &EditorBinding::endHover)
      .function("cancelGesture", &EditorBinding::cancelGesture)
      .function("cancelPointer", &EditorBinding::cancelPointer)
      .function("wheel", &EditorBinding::wheel)
      .function("attachContext", &EditorBinding::attachContext)
      .function("detachContext", &EditorBinding::detachContext)
      .function("contextLost", &EditorBinding::contextLost)
      .function("frame", &EditorBinding::frame)
      .function("atRest", &EditorBinding::atRest)
      .function("problem", &EditorBinding::problem)
      .function("setReducedMotion", &EditorBinding::setReducedMotion)
      .function("setLinesShown", &EditorBinding::setLinesShown)
      .function("linesShown", &EditorBinding::linesShown)
      .function("setHiddenShown", &EditorBinding::setHiddenShown)
      .function("hiddenShown", &EditorBinding::hiddenShown)
      .function("layoutJson", &EditorBinding::layoutJson)
      .function("labelsJson", &EditorBinding::labelsJson)
      .function("pillsJson", &EditorBinding::pillsJson)
      .function("eventsJson", &EditorBinding::eventsJson)
      .function("setFieldsFrom", &EditorBinding::setFieldsFrom)
      .function("fieldsFrom", &EditorBinding::fieldsFrom)
      .function("fieldsJson", &EditorBinding::fieldsJson)
      .function("timingsJson", &EditorBinding::timingsJson);
}

}  // namespace dimline
