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

}  // namespace dimline
