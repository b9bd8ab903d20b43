#include <catch2/catch.hpp>

#include <random>
#include <vector>

#include "core/sort_keys.h"

using namespace dimline;

TEST_CASE("keys come in ascending order, and equal ones in that of their indices") {
  std::vector<SortKey> keys{{2, 0}, {-1, 1}, {2, 5}, {0, 2}, {2, 3}, {-1, 0}};
  sortKeys(keys);
  CHECK(keys == std::vector<SortKey>{{-1, 0}, {-1, 1}, {0, 2}, {2, 0}, {2, 3}, {2, 5}});
}

TEST_CASE("long lists of many equal keys are sorted as a stable sort does it") {
  std::mt19937 random(3);
  for (const std::uint32_t size : {0U, 1U, 7U, 100U, 5000U}) {
    std::vector<SortKey> keys;
    for (std::uint32_t i = 0; i < size; ++i) keys.push_back({static_cast<double>(random() % 50), i});
    std::vector<SortKey> expected = keys;
    std::ranges::stable_sort(expected, {}, &SortKey::value);
    sortKeys(keys);
    CHECK(keys == expected);
  }
}
