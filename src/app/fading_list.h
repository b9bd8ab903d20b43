#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "app/motion.h"

namespace dimline {

/// On its way out: no longer part of the layout, drawn for some frames more.
template <typename Placed>
struct Fading {
  Placed placed;
  double opacity = 1;
  double startMs = 0;
  double startOpacity = 1;
};

/// Things of a layout that fade, and the memory of those that are gone, from which the next ones are made: so that frames in which lines come and go
/// allocate nothing.
template <typename Placed>
class FadingList {
public:
  [[nodiscard]] std::span<const Fading<Placed>> items() const { return fading_; }
  void clear() { fading_.clear(); }

  /// Of a thing there may be the one that is drawn and a few that fade, and all may be put aside at once.
  void reserve(std::size_t things, std::size_t drawn) {
    spares_.reserve(std::max(spares_.size() + fading_.size() + drawn, 4 * things));
    fading_.reserve(4 * things);
  }

  /// Takes what has just gone out of `drawn`, of which it is about to be written anew.
  void add(Placed& drawn, double opacity, double nowMs) { fading_.push_back({std::exchange(drawn, takeSpare()), opacity, nowMs, opacity}); }

  /// Lets all fade on. `show(placed)`: brings one up to date with the view; false when it cannot be seen there.
  template <typename Show>
  void update(double nowMs, Show show) {
    std::erase_if(fading_, [&](Fading<Placed>& f) {
      f.opacity = f.startOpacity * (1.0 - std::clamp((nowMs - f.startMs) / kFadeMs, 0.0, 1.0));
      if (f.opacity > 0.0 && show(f.placed)) return false;
      spares_.push_back(std::move(f.placed));
      return true;
    });
  }

  /// As vector::resize, but what the things hold is kept for later.
  void resize(std::vector<Placed>& things, std::size_t size) {
    while (things.size() > size) {
      spares_.push_back(std::move(things.back()));
      things.pop_back();
    }
    while (things.size() < size) things.push_back(takeSpare());
  }

private:
  Placed takeSpare() {
    if (spares_.empty()) return {};
    Placed placed = std::move(spares_.back());
    spares_.pop_back();
    return placed;
  }

  std::vector<Fading<Placed>> fading_;
  std::vector<Placed> spares_;  ///< not needed now, for the memory they hold
};

/// How far a thing has appeared by now that began to at `startMs`.
inline double appearedBy(double nowMs, double startMs, double startOpacity) {
  return startOpacity + (1.0 - startOpacity) * std::clamp((nowMs - startMs) / kFadeMs, 0.0, 1.0);
}

}  // namespace dimline
