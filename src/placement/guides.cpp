#include "placement/guides.h"

#include <cmath>
#include <utility>

namespace dimline {

namespace {

/// A guide's memory goes from one line to another as frames pass: so many stretches, as of a long chain, are taken without asking for more.
constexpr std::size_t kReservedStretches = 64;

}  // namespace

Guides& Guides::operator=(const Guides& other) {
  if (this == &other) return *this;
  count_ = 0;
  for (std::size_t i = 0; i < other.count_; ++i) next() = other.guides_[i];
  return *this;
}

void Guides::makeRoomLike(const Guides& other) {
  const std::size_t count = std::exchange(count_, 0);
  for (const Guide& guide : other.guides_) next().taken.makeRoomLike(guide.taken);
  count_ = count;
}

/// One more, with the memory that it had.
Guide& Guides::next() {
  if (count_ == guides_.size()) guides_.emplace_back().taken.reserve(kReservedStretches);
  return guides_[count_++];
}

int Guides::add(const Plane& plane, const Segment& line) {
  Guide& guide = next();
  guide.plane = plane;
  guide.point = line.start;
  // Of a line that was dragged to no length the direction is unknown: nothing lies along its guide.
  guide.along = unitOrZero(line.end - line.start);
  guide.taken.clear();
  return static_cast<int>(count_) - 1;
}

int Guides::through(const Segment& line, const Plane& plane, double toleranceM) const {
  const Vec3 along = unitOrZero(line.end - line.start);
  if (along == Vec3(0.0)) return -1;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!liesOn(guides_[i], plane, along, toleranceM)) continue;
    const Vec3 aside = line.start - guides_[i].point - guides_[i].along * guides_[i].metresAt(line.start);
    if (glm::length(aside) <= toleranceM) return static_cast<int>(i);
  }
  return -1;
}

bool liesOn(const Guide& guide, const Plane& plane, const Vec3& alongUnit, double toleranceM) {
  // For unit vectors the cross product's length is the sine of the angle, whichever way round they run.
  if (guide.along == Vec3(0.0) || glm::length(glm::cross(guide.along, alongUnit)) > kSamePlaneAngleRad) return false;
  if (glm::length(glm::cross(guide.plane.normal, plane.normal)) > kSamePlaneAngleRad) return false;
  return std::abs(glm::dot(guide.point - plane.point, plane.normal)) <= toleranceM;
}

}  // namespace dimline
