#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/editor.h"
#include "app/field_source.h"
#include "app/handle_animator.h"
#include "app/handle_gesture.h"
#include "app/line_animator.h"
#include "app/orbit_controls.h"
#include "app/place_memory.h"
#include "app/quality_governor.h"
#include "app/scope_marks.h"
#include "app/visibility_source.h"
#include "editing/handle_hit.h"
#include "editing/undo_history.h"
#include "placement/placer.h"
#include "render/renderer.h"

// What an Editor is made of; private to the editor's own files. editor.cpp keeps the document, its viewport and its
// camera, editor_values.cpp says what values are to people, editor_input.cpp turns pointers into gestures, editor_frame.cpp
// makes frames, editor_draw.cpp draws them.

namespace dimline {

/// ms. What is under the pointer is shown as such, and is so no more, in this time.
inline constexpr double kHoverMs = 100.0;

/// Which handle, by what stays the same when lines are placed anew.
struct HandleKey {
  std::size_t parameter = 0;
  std::uint32_t scopeIndex = 0;
  bool atEnd = true;
  bool operator==(const HandleKey&) const = default;
};

/// What a pointer takes hold of, in the layout as drawn: a line's handle, or the end of an arc (an index into others).
using GripRef = std::variant<HandleRef, std::size_t>;

/// A camera being moved by one pointer, or two fingers.
struct CameraGesture {
  enum class Kind : std::uint8_t { kOrbit, kPan, kZoom, kTwoFingers } kind = Kind::kOrbit;
  struct Pointer {
    int id = 0;
    Vec2 start{0.0};
    Vec2 now{0.0};
  };
  PointerKind pointerKind = PointerKind::kMouse;
  Camera restore;   ///< what cancelling restores, and whether that one was chosen and for which viewport
  bool untouchedBefore = false, compositionDueBefore = false;
  Vec2 viewportBefore{0.0};
  Camera start;     ///< what the pointers' travel is counted from
  Vec3 pivot{0.0};  ///< of a zoom
  Pointer first, second;
};

struct Editor::State {
  // --- Document ---
  bool loaded = false;
  Model model;
  Model modelWithMeasures;  ///< the same, and its measures as further parameters
  bool measuresShown = false;
  Values valuesWithMeasures;  ///< of the scene
  char decimalMark = '.';
  Values values;
  Scene scene;
  bool sceneStale = false;  ///< values changed since `scene` was built
  UndoHistory history;
  PlaceMemory places;  ///< of values before edits, and of those that were undone
  std::optional<Values> continuing;  ///< values before a continuous edit that has not ended
  std::vector<EditorEvent> events;

  // --- Viewport and camera ---
  double widthPx = 0, heightPx = 0, devicePixelRatio = 1;
  Camera camera;
  bool cameraUntouched = true;  ///< nobody chose it: it is fitted anew when the viewport gets its size
  bool compositionDue = false;  ///< it was fitted to the model alone; the lines come into it with the next frame
  std::optional<Vec3> fittedAlong;  ///< where it looked before its picture was centred, in its own right, up and forward; nothing of one that a host set
  bool settlesAtOnce = false;   ///< the lines came into the picture with it, and are to find their places there without delay
  bool viewStale = true;        ///< camera, viewport or scene changed since fields were asked for

  // --- Gestures ---
  std::optional<HandleGesture> handleGesture;
  std::optional<Placer::Memory> recall;  ///< to be put back before lines are placed again
  std::optional<CameraGesture> cameraGesture;
  std::optional<PointerInput> hoverAt;
  std::optional<HandleKey> hovered, hoveredBefore;  ///< a line by its end, wherever on it the pointer is
  double hoverChangedMs = 0;

  // --- Frames ---
  double nowMs = 0;
  FieldSource fieldSource;
  VisibilitySource visibilitySource;
  bool visibilityStale = true;  ///< what it has seen is of an earlier view or scene
  double visibilityAskedMs = 0;
  double visibilityStaleMs = 0;  ///< since when there was no answer, not even of an earlier view
  bool restedLastFrame = true;
  Placer placer;
  double settleMs = 0;  ///< when the lines are to settle, unless the camera moves on
  bool inHand = false;  ///< in the last frame a pointer held a handle or the camera
  Layout placed;  ///< as the placer gave it, with the dragged lines held
  std::vector<PlacedLine> heldLines;
  Layout drawn;
  LineAnimator animator;
  HandleAnimator handleAnimator;
  std::vector<LineState> lineStates, otherStates;
  std::vector<float> handleScales, otherScales;  ///< parallel to lineStates and otherStates
  bool linesShown = true;
  bool hiddenShown = false;
  bool placedOnce = false;
  bool placedInScene = false;  ///< `placed` is of `scene`, not of the one before it
  Timings timings;

  // --- Drawing ---
  std::unique_ptr<Renderer> renderer;
  bool rendererSceneStale = true;
  bool pictureStale = true;  ///< what was drawn last is not what should be seen now
  RenderQuality drawnQuality = RenderQuality::kFull;
  QualityGovernor quality;
  std::string problem;
  std::vector<OverlayLine> overlayLines;
  std::vector<OverlayArc> overlayArcs;
  std::vector<OverlayThread> overlayThreads;
  std::vector<std::vector<Vec2>> arcPoints;  ///< what overlayArcs point to
  std::vector<DragMark> dragMarks;
  bool marksToLearn = false;  ///< some ticks of a drag are still to be found out
  bool marksLearned = false;  ///< some were that are not shown yet
  double marksShownMs = 0;
  std::vector<OverlayEdge> overlayEdges;

  // editor.cpp
  [[nodiscard]] bool hasSize() const { return widthPx >= 1 && heightPx >= 1; }
  [[nodiscard]] bool handHolds() const { return handleGesture || cameraGesture; }
  [[nodiscard]] bool editsOpenly() const { return (continuing && *continuing != values) || (handleGesture && handleGesture->before != values); }
  [[nodiscard]] View currentView() const { return {camera, widthPx, heightPx, scene.bounds}; }
  void notify(EditorEvent event);
  void begin(const Values& first);
  [[nodiscard]] Values changed(Values from, std::span<const std::pair<std::size_t, double>> changes) const;
  bool assign(const Values& next);
  void step(const std::optional<Values>& to);
  [[nodiscard]] PlaceMemory::Picture picture() const;
  Placer::Memory rememberPlaces();
  void finishEdits();
  void moveCamera(const Camera& next);
  void openingCamera();
  void fitted();
  void compose();
  void takeModel(Model next);
  void placeAnew();

  // editor_values.cpp
  [[nodiscard]] const Model& placedModel() const { return measuresShown ? modelWithMeasures : model; }
  [[nodiscard]] const Values& placedValues() const { return measuresShown ? valuesWithMeasures : values; }

  [[nodiscard]] Gesture describe(const HandleHold& hold) const;

  // editor_input.cpp
  [[nodiscard]] std::optional<GripRef> gripAt(const PointerInput& input) const;
  [[nodiscard]] std::optional<HandleKey> pointedAt(const PointerInput& input) const;
  [[nodiscard]] HandleKey keyOf(const PlacedLine& line, bool atEnd) const;
  [[nodiscard]] HandleKey keyOf(const PlacedHandle& handle) const;
  [[nodiscard]] HandleKey keyOf(const GripRef& grip) const;
  [[nodiscard]] const PlacedLine* placedLineOf(const HandleKey& key) const;
  [[nodiscard]] const PlacedHandle* placedHandleOf(const HandleKey& key) const;
  void catchUp();
  bool takeHandle(const PointerInput& input);
  std::optional<ValueDrag> takeHold(const HandleKey& key, const Vec2& grabOffset, const View& view) const;
  void beginCameraGesture(const PointerInput& input);
  void addFinger(const PointerInput& input);
  void moveHold(HandleHold& hold, const PointerInput& input);
  void followPointers();
  void moveCameraGesture();
  void resumeCameraGesture();
  void cancelCameraGesture();
  bool regripHandles();
  void releaseHandle(int pointer);
  void withdrawHandle(int pointer);
  void endHandleGesture();
  void cancelHandleGesture();
  void endCameraPointer(int id);
  void dropGestures();
  void updateHover();
  [[nodiscard]] Vec3 pivotUnder(const Vec2& screen) const;

  // editor_frame.cpp
  void rebuild();
  void measureAndPlace(const View& view);
  [[nodiscard]] bool unsettled() const { return !placer.settled() && !handHolds(); }
  void settleLines(bool moved);
  void measureVisibility(const View& view, bool moving);
  void placeOn(const View& view, bool moving);
  void holdMember(const PlacedLine& held);
  void holdArc(const PlacedHandle& held);
  void animate(const View& view);
  void updateStates();
  void clearLines();
  [[nodiscard]] bool hoverAnimating() const;

  // editor_draw.cpp
  void draw(const View& view);
  void buildOverlayLines();
  void buildOverlayHandles();
  void buildOverlayMarks();
  void addDragMarks();
  void learnMarks();
  void markScopes(std::size_t parameter, const View& view, double share);
  void uploadScene();
  [[nodiscard]] bool wantsBetterPicture() const { return renderer && drawnQuality != RenderQuality::kFull; }
};

}  // namespace dimline
