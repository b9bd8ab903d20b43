#pragma once

#include <cstdint>
#include <optional>

#include "app/editor.h"
#include "app/producer_times.h"
#include "core/fixed_vector.h"
#include "gpu/flights.h"
#include "render/renderer.h"
#include "silhouette/cpu_fields.h"

namespace dimline {

/// The distance fields for an editor's frames, from whichever producer is at hand and does better.
///
/// The CPU answers within the frame. The GPU answers some frames later; until then the newest answer stands, together
/// with the view it is of.
class FieldSource {
public:
  void setFrom(Editor::FieldsFrom from) { from_ = from; }
  [[nodiscard]] Editor::FieldsFrom from() const { return from_; }
  /// The producer that measures at present; never kAuto. The CPU where there is no renderer.
  [[nodiscard]] Editor::FieldsFrom active(const Renderer* renderer) const;

  void setScene(const Scene& scene);
  /// Another model: what is known of the producers' times does not hold for it.
  void forgetTimes() { times_.forget(); }
  /// Requests under way are lost with their context.
  void rendererGone();

  /// Call once a frame with the view to measure. True when fields() and view() are new. `stale`: fields() are not of
  /// this view and scene.
  bool update(const View& view, bool stale, double devicePixelRatio, Renderer* renderer);

  /// Whether an answer of the GPU is still to come.
  [[nodiscard]] bool pending() const { return !flights_.empty(); }
  /// Whether fields() and view() hold the present scene as the last update() saw it.
  [[nodiscard]] bool current() const { return current_; }
  [[nodiscard]] const DistanceFields& fields() const { return fields_; }
  [[nodiscard]] const View& view() const { return view_; }
  /// Main thread's time for the last fields (ms).
  [[nodiscard]] double measuredMs() const { return measuredMs_; }

  /// Measures now, with the given producer, and waits for it. Nothing when it is the GPU's turn and there is no
  /// renderer.
  std::optional<DistanceFields> measure(const View& view, Editor::FieldsFrom from, double devicePixelRatio,
                                        Renderer* renderer);

private:
  struct Flight {
    std::uint64_t number = 0;
    View view;
    bool newest = false;  ///< nothing has changed since it was requested
    double requestMs = 0;
  };

  bool measureOnCpu(const View& view);
  bool poll(Renderer& renderer);
  void request(const View& view, double devicePixelRatio, Renderer& renderer);
  void dropFlights(Renderer* renderer);

  Editor::FieldsFrom from_ = Editor::FieldsFrom::kAuto;
  CpuFields cpu_;
  DistanceFields fields_;
  DistanceFields arrived_;  ///< what the GPU sends lands here, in case that nobody waits for it any more
  View view_;
  bool current_ = false;
  double measuredMs_ = 0;
  /// What kAuto knows. Only models dearer than 3 of a frame's 16 ms are measured on both.
  ProducerTimes times_{3.0};
  FixedVector<Flight, kInFlight> flights_;
};

}  // namespace dimline
