#include "core/sort_keys.h"

#include <algorithm>

namespace dimline {

void sortKeys(std::span<SortKey> keys) {
  std::ranges::sort(keys, [](const SortKey& a, const SortKey& b) { return a.value != b.value ? a.value < b.value : a.index < b.index; });
}

}  // namespace dimline
