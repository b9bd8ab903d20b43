#pragma once

#include <cstddef>
#include <vector>

namespace dimline {

/// An empty vector with room for so many: for what is kept from frame to frame, so that a frame that needs a little more than any before it need not allocate.
template <typename T>
std::vector<T> withRoomFor(std::size_t count) {
  std::vector<T> vector;
  vector.reserve(count);
  return vector;
}

/// Room for as much as another one has room for: the two change places, or one is copied to the other, from frame to frame.
template <typename T>
void makeRoomLike(const std::vector<T>& other, std::vector<T>& vector) {
  vector.reserve(other.capacity());
}

}  // namespace dimline
