#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace dimline {

/// A vector of at most N elements that lives where it stands: for small results of per-frame code, which allocates nothing.
template <typename T, std::size_t N>
class FixedVector {
 public:
  void push_back(const T& value) {
    assert(size_ < N);
    items_[size_++] = value;
  }
  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T& operator[](std::size_t i) { return items_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return items_[i]; }
  [[nodiscard]] auto begin() { return items_.begin(); }
  [[nodiscard]] auto end() { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }
  [[nodiscard]] auto begin() const { return items_.begin(); }
  [[nodiscard]] auto end() const { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  std::array<T, N> items_{};
  std::size_t size_ = 0;
};

}  // namespace dimline
