#pragma once

#include <span>
#include <utility>
#include <vector>

#include "placement/chains.h"
#include "placement/layout.h"

namespace dimline {

/// A final line's carrier on its plane, to which later lines may snap (paper 4, G_snap and figure 8).
struct Guide {
  Plane plane;
  Vec3 point{0.0};          ///< where metres along the guide are counted from
  Vec3 along{0.0};          ///< unit length
  TakenStretches taken;

  [[nodiscard]] double metresAt(const Vec3& p) const { return glm::dot(p - point, along); }
};

/// The guides of one frame. Keeps its memory from frame to frame.
class Guides {
 public:
  Guides() = default;
  Guides(const Guides& other) { *this = other; }
  Guides(Guides&& other) noexcept : guides_(std::move(other.guides_)), count_(std::exchange(other.count_, 0)) {}
  Guides& operator=(const Guides& other);
  Guides& operator=(Guides&& other) noexcept {
    guides_.swap(other.guides_);
    std::swap(count_, other.count_);
    return *this;
  }
  ~Guides() = default;

  void clear() { count_ = 0; }
  /// Room for as much as another one has room for.
  void makeRoomLike(const Guides& other);
  /// A new guide through a line on a plane, with nothing on it; returns its number.
  int add(const Plane& plane, const Segment& line);
  /// The number of the guide that a line on a plane lies on, -1 when there is none.
  [[nodiscard]] int through(const Segment& line, const Plane& plane, double toleranceM) const;
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] Guide& operator[](std::size_t i) { return guides_[i]; }
  [[nodiscard]] const Guide& operator[](std::size_t i) const { return guides_[i]; }

 private:
  Guide& next();

  std::vector<Guide> guides_;
  std::size_t count_ = 0;
};

/// Whether a guide lies on a plane and runs along a direction, either way round, within kSamePlaneAngleRad
/// and `toleranceM` (m), which is kSamePlaneDistance of the model's size.
bool liesOn(const Guide& guide, const Plane& plane, const Vec3& alongUnit, double toleranceM);

}  // namespace dimline
