#include "core/fixed_vector.h"

#include <catch2/catch.hpp>

using dimline::FixedVector;

TEST_CASE("what is behind the first of a fixed vector moves up when that one goes") {
  FixedVector<int, 3> queue{1, 2, 3};
  queue.pop_front();
  CHECK(queue == FixedVector<int, 3>{2, 3});
  queue.push_back(4);
  CHECK(queue == FixedVector<int, 3>{2, 3, 4});
  for (int i = 0; i < 3; ++i) queue.pop_front();
  CHECK(queue.empty());
}
