#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "math/camera.h"
#include "model/model.h"
#include "placement/layout.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Something that a host wants to hear of, in the order in which it happened.
enum class EditorEvent : std::uint8_t { kInput, kChange, kCameraChange, kLoad };

enum class PointerKind : std::uint8_t { kMouse, kTouch, kPen };
enum class PointerButton : std::uint8_t { kPrimary, kMiddle, kSecondary };

struct Modifiers {
  bool shift = false, ctrl = false, alt = false, meta = false;
};

/// One pointer's position, as the browser reports it (CSS px from the canvas's top left).
struct PointerInput {
  int id = 0;
  PointerKind kind = PointerKind::kMouse;
  PointerButton button = PointerButton::kPrimary;
  Modifiers modifiers{};
  Vec2 screen{0.0};
};

/// What a pointer is doing, for the host's cursor.
enum class PointerTarget : std::uint8_t { kNothing, kHandle, kCamera };

/// How a drag's values are chosen: on the parameter's steps; with shift on tenths of them; with alt anywhere.
enum class DragSnap : std::uint8_t { kStep, kFine, kNone };

enum class StandardView : std::uint8_t { kThreeQuarter, kFront, kBack, kLeft, kRight, kTop };

/// One document, one camera, one frame loop. The host (a page, a test, a script) feeds input and time; the editor decides
/// everything else. Works without GL: then fields are measured on the CPU and nothing is drawn.
///
/// Order of a frame: bring values under the pointers that drag handles; rebuild the model if values changed; measure fields; place lines; animate; draw.
/// Angles in degrees and values in the parameter's own unit at this boundary.
class Editor {
 public:
  Editor();
  ~Editor();

  // --- Document ---
  /// Replaces the document. Camera and undo history start anew; lines appear without animation. On an error the document stays as it was.
  Status setModel(Model model);
  /// The document begins anew, with these values in place of its defaults (saved ones, say): as after setModel(), but it tells of kInput and kChange, unless
  /// the model's kLoad is still to be taken. Clamps to the range; unknown index is an assert.
  void beginWith(std::span<const std::pair<std::size_t, double>> changes);
  [[nodiscard]] const Model& model() const;
  [[nodiscard]] const Values& values() const;
  [[nodiscard]] const Scene& scene() const;
  /// Clamps to the range. One undo step for all values together; none when nothing changed. Unknown index is an assert.
  void setValues(std::span<const std::pair<std::size_t, double>> changes);
  /// As setValues, but continuing: repeated calls (a slider in motion) are one undo step until endContinuous(); kInput while it lasts, kChange at its end.
  void setValueContinuous(std::size_t parameter, double value);
  void endContinuous();
  void undo();
  void redo();
  [[nodiscard]] bool canUndo() const;
  [[nodiscard]] bool canRedo() const;

  // --- Values as people write them ---
  /// '.' or ',': in labels, value texts and inputText() from now on, over all documents.
  void setDecimalMark(char mark);
  /// See readValueText() and inputText() in editing/value_text.h.
  [[nodiscard]] Result<double> parseValue(std::size_t parameter, std::string_view text) const;
  [[nodiscard]] std::string inputText(std::size_t parameter) const;
  /// The default value again, as one undo step.
  void resetParameter(std::size_t parameter);

  // --- Measures: values that follow from others ---
  struct MeasureReading {
    const Parameter* shown = nullptr;   ///< until the next setModel() or setDecimalMark()
    double value = 0;
    std::string text;
  };
  /// Of the scene of the last frame.
  [[nodiscard]] std::vector<MeasureReading> measures() const;
  /// Whether their lines are placed, after all others. At the start they are not.
  void setMeasuresShown(bool shown);
  [[nodiscard]] bool measuresShown() const;
  /// The parameters to which layout()'s indices refer: the model's, and behind them its measures while they are shown.
  [[nodiscard]] const Model& placedModel() const;

  // --- Viewport and camera ---
  /// CSS pixels (fractions allowed) and device pixels per CSS pixel. A viewport of no size draws and places nothing, and loses nothing.
  void resize(double widthPx, double heightPx, double devicePixelRatio);
  [[nodiscard]] const Camera& camera() const;
  [[nodiscard]] bool orthographic() const { return camera().orthographic(); }
  Status setCamera(const Camera& camera);
  /// Moves the camera along its view until the model fills the viewport, and with the next frame across it until all that is shown stands in the middle: the model,
  /// its lines and other handles (app/composition.h). The view in which a model opens is found likewise.
  void fitToView();
  void setStandardView(StandardView view);  ///< looks from there and fits
  /// Changes the projection and keeps what is seen at the target the same size.
  void setOrthographic(bool orthographic);

  // --- Input ---
  /// Orbit, pan and zoom in the manner of three.js's OrbitControls: primary drag orbits, secondary (or primary with ctrl/meta/shift) pans, middle drag and
  /// wheel zoom; one finger orbits, two pan and zoom. A handle under the pointer is dragged instead; while one is, further pointers drag the handles that they
  /// are on, each of another parameter, or do nothing. All that is from the first one down to the last one up is one undo step. The values follow the handles'
  /// pointers once a frame, and when a pointer goes down or up.
  PointerTarget pointerDown(const PointerInput& input);
  PointerTarget pointerMove(const PointerInput& input);
  void pointerUp(const PointerInput& input);
  /// The browser took the pointer away, or Esc: the gesture is undone exactly.
  void cancelGesture();
  /// The same for one pointer: other handles are dragged on. Of two fingers that move the camera either takes back what both did.
  void cancelPointer(int id);
  void wheel(const Vec2& screen, double deltaPx, const Modifiers& modifiers);
  /// What is being dragged, and what that has led to.
  struct Gesture {
    enum class Limit : std::uint8_t { kNone, kMin, kMax };
    int id = 0;                   ///< of the pointer that drags it
    std::size_t parameter = 0;
    bool arc = false;             ///< an angle's arc, or else a line
    double value = 0;
    std::string text;             ///< the value as the label has it
    std::string difference;       ///< to the start of the drag: "+0.40 m"; empty where there is none
    Limit limit = Limit::kNone;
    Vec2 handle{0.0};             ///< px, the arrowhead's tip as the last frame drew it
    Vec2 direction{1.0, 0.0};     ///< on screen, the way in which the handle moves when the value grows; unit length
    PointerKind pointer = PointerKind::kMouse;
    DragSnap snap = DragSnap::kStep;
  };
  /// Of all handles that are being dragged, in the order in which they were taken hold of.
  [[nodiscard]] std::vector<Gesture> gestures() const;
  /// The parameter whose handle or label is at a place on screen: the nearest handle within the pointer's reach, or else the label there.
  [[nodiscard]] std::optional<std::size_t> parameterAt(const Vec2& screen, PointerKind kind) const;
  /// How much of the last frame a box over the picture would hide (px): see app/cover_cost.h.
  [[nodiscard]] double coverCost(const Box2& box) const;
  /// Where a pointer that is not down hovers, until endHover(). What it points at is marked: a handle or, anywhere else on it, a line or its label. Says whether it would take hold of a handle.
  PointerTarget hover(const PointerInput& input);
  void endHover();

  // --- Frames ---
  /// A GL context is current and shall be drawn into; see render/renderer.h.
  void attachRenderer();
  void detachRenderer();        ///< the context is about to be destroyed by the host
  /// Why the picture cannot be drawn as it should, for a message; empty when all is well.
  [[nodiscard]] const std::string& problem() const;
  void abandonRenderer();       ///< the context was lost; attachRenderer() again after it is restored
  /// Advances to `nowMs` (any steady clock) and draws. True when another frame is wanted (animation, fields under way, damping).
  bool frame(double nowMs);
  /// Fields, placement and animation have come to rest, and so has the camera: the lines have settled (Placer::settle()), which they do when a pointer lets go of it, or a third of a second after it was moved
  /// otherwise.
  [[nodiscard]] bool atRest() const;
  /// The layout as drawn by the last frame, mid-animation too.
  [[nodiscard]] const Layout& layout() const;
  /// Opacity, hover and drag state of layout().lines, in the same order.
  struct LineState {
    double opacity = 1;
    bool hovered = false;
    bool dragged = false;
  };
  [[nodiscard]] std::span<const LineState> lineStates() const;
  /// The same of layout().others. A switch or a choice is the host's to show and to point at, so that it is never hovered or dragged here.
  [[nodiscard]] std::span<const LineState> otherStates() const;
  /// A line that has gone from layout() and is still fading, with the rest of its opacity; for hosts that draw labels themselves.
  struct FadingLine {
    PlacedLine line;
    double opacity = 0;
  };
  [[nodiscard]] std::vector<FadingLine> fadingLines() const;
  struct FadingHandle {
    PlacedHandle handle;
    double opacity = 0;
  };
  [[nodiscard]] std::vector<FadingHandle> fadingHandles() const;
  /// Whether lines and other handles are drawn at all; without them there is only the picture. At the start they are.
  void setLinesShown(bool shown);
  [[nodiscard]] bool linesShown() const;
  /// Whether parameters are shown as well that are hidden as occluded, too short, foreshortened or crowded (paper 5: a modifier key shows all handles).
  /// When it ends, every line is where it was before.
  void setHiddenShown(bool shown);
  [[nodiscard]] bool hiddenShown() const;
  /// For people who asked their system for less motion: lines change place at once.
  void setReducedMotion(bool reduced);
  /// What happened since the last call.
  std::vector<EditorEvent> takeEvents();

  enum class FieldsFrom : std::uint8_t { kAuto, kCpu, kGpu };
  /// Which producer measures the fields, and which scopes are seen; kAuto measures both on this machine and takes the faster, for either.
  void setFieldsFrom(FieldsFrom from);
  [[nodiscard]] FieldsFrom fieldsFrom() const;
  /// For tests and diagnosis: the present view's fields, measured by one producer while the caller waits. Nothing without a model or a size, or when it is the
  /// GPU's turn and no renderer is attached.
  [[nodiscard]] std::optional<DistanceFields> measureFields(FieldsFrom from);
  /// The producer that measures at present: kCpu or kGpu.
  [[nodiscard]] FieldsFrom fieldsMeasuredBy() const;
  struct Timings {
    double rebuildMs = 0, fieldsMs = 0, visibilityMs = 0, placeMs = 0, drawMs = 0;
  };
  [[nodiscard]] const Timings& timings() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dimline
