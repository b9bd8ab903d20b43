#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gpu/pixel_readback.h"

namespace dimline {

/// Requests of one measurer at a time.
inline constexpr std::size_t kInFlight = 3;

/// A measurer's requests whose answers are on their way back from the GPU, kInFlight at most. Of those that have arrived the newest counts. `What`: what it takes to read an answer.
template <typename What>
class Flights {
 public:
  struct Flight {
    PixelReadback readback;
    std::uint64_t number = 0;   ///< 1 and up; 0: none is under way
    What what{};
  };

  explicit Flights(const GlContext& context) {
    for (Flight& flight : flights_) flight.readback = PixelReadback(context);
  }

  /// The next one, whose reading is to be begun; null when kInFlight are under way.
  Flight* begin() {
    for (Flight& flight : flights_) {
      if (flight.number != 0) continue;
      flight.number = ++lastNumber_;
      return &flight;
    }
    return nullptr;
  }

  /// The newest of which the answer is there. Never waits. Null when there is none.
  Flight* newestArrived() {
    return newest([](Flight& flight) { return flight.readback.ready(); });
  }

  /// The newest of all; to read its answer is to wait for it. Null when there is none.
  Flight* newest() {
    return newest([](const Flight&) { return true; });
  }

  /// Ends one whose answer has been read, and those before it, which are of no use any more.
  void end(const Flight& landed) {
    const std::uint64_t last = landed.number;
    for (Flight& flight : flights_) {
      if (flight.number <= last) drop(flight);
    }
  }

  /// Ends all of them unread.
  void dropAll() {
    for (Flight& flight : flights_) drop(flight);
  }

 private:
  template <typename Wanted>
  Flight* newest(Wanted wanted) {
    Flight* found = nullptr;
    for (Flight& flight : flights_) {
      if (flight.number != 0 && (found == nullptr || flight.number > found->number) && wanted(flight)) found = &flight;
    }
    return found;
  }

  static void drop(Flight& flight) {
    flight.readback.finish();
    flight.number = 0;
  }

  std::array<Flight, kInFlight> flights_;
  std::uint64_t lastNumber_ = 0;
};

}  // namespace dimline
