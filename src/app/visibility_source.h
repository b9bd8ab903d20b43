#pragma once

#include "app/editor.h"
#include "app/producer_times.h"
#include "core/fixed_vector.h"
#include "gpu/flights.h"
#include "render/renderer.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

/// How much of each scope is seen, for an editor's frames, from whichever producer is at hand and does better; as FieldSource has the fields.
class VisibilitySource {
public:
  void setFrom(Editor::FieldsFrom from) { from_ = from; }
  /// The producer that measures at present; never kAuto. The CPU where there is no renderer.
  [[nodiscard]] Editor::FieldsFrom active(const Renderer* renderer) const;

  /// What is under way is of another scene.
  void sceneChanged() { flights_.clear(); }
  /// What is under way is of an earlier view; it is still good enough for frames on the way.
  void viewChanged();
  /// Another model: what is known of the producers' times does not hold for it.
  void forgetTimes() { times_.forget(); }
  /// Requests under way are lost with their context.
  void rendererGone();

  /// Measures within the frame on the CPU: true, and seen() is of this view. Or asks the GPU, if it does better and `atOnce` does not
  /// forbid it: false, and seen() stays as it is until poll() brings the answer. `present`: `view` is the present one, not one that fields are late for.
  bool measure(const Scene& scene, const View& view, Renderer* renderer, bool atOnce, bool present);

  enum class Arrival : std::uint8_t { kNone, kOlder, kPresent };
  /// Call once a frame. What the GPU sent: nothing, seen() of an earlier view, or seen() of the view of the last measure() with nothing changed since.
  Arrival poll(Renderer* renderer);

  /// Whether an answer for the present view is still to come.
  [[nodiscard]] bool awaiting() const { return !flights_.empty() && flights_.back().newest; }
  [[nodiscard]] const ScopeVisibility& seen() const { return seen_; }
  /// Main thread's time for the last answer (ms).
  [[nodiscard]] double measuredMs() const { return measuredMs_; }

private:
  struct Flight {
    std::uint64_t number = 0;
    bool newest = false;
    double requestMs = 0;
  };

  Editor::FieldsFrom from_ = Editor::FieldsFrom::kAuto;
  CpuVisibility cpu_;
  ScopeVisibility seen_;
  ScopeVisibility arrived_;  ///< what the GPU sends lands here, in case that nobody waits for it any more
  double measuredMs_ = 0;
  /// What kAuto knows. As long as the CPU takes no more than 1 ms of a frame, an answer within the frame is worth more than a free one some frames later.
  ProducerTimes times_{1.0};
  FixedVector<Flight, kInFlight> flights_;
};

}  // namespace dimline
