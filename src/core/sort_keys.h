#pragma once

#include <cstdint>
#include <span>

namespace dimline {

/// What an element of a list is sorted by, and where in the list it stands.
struct SortKey {
  double value = 0;
  std::uint32_t index = 0;
  bool operator==(const SortKey&) const = default;
};

/// Ascending by value; keys of equal value by index, so that what is equal keeps its order. No value may be NaN.
///
/// Lists are sorted by way of their keys, not themselves: every further instantiation of the library's sort is one to ten kB that a page has to fetch.
void sortKeys(std::span<SortKey> keys);

}  // namespace dimline
