#include "placement/placing_order.h"

#include <catch2/catch.hpp>

using namespace dimline;

namespace {

/// Lines of these parameters, the shortest first.
std::vector<Measured> lines(std::initializer_list<std::size_t> parameters) {
  std::vector<Measured> all;
  for (const std::size_t parameter : parameters) all.emplace_back().parameter = parameter;
  return all;
}

std::vector<std::uint32_t> ranks(const PlacingOrder& order) { return {order.ranks().begin(), order.ranks().end()}; }

using Ranks = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("the shortest line is placed first") {
  PlacingOrder order;
  order.arrange(lines({7, 3, 5}));
  CHECK(ranks(order) == Ranks{0, 1, 2});
  CHECK(order.isShortestFirst());
}

TEST_CASE("a line is placed just before the one that it was put before, and the others stay in their order") {
  PlacingOrder order;
  order.arrange(lines({7, 3, 5, 4}));
  order.put(3, 1);
  CHECK(ranks(order) == Ranks{0, 3, 1, 2});
  CHECK_FALSE(order.isShortestFirst());
  SECTION("one that comes before it anyhow stays where it is") {
    order.put(0, 2);
    CHECK(ranks(order) == Ranks{0, 3, 1, 2});
  }
  SECTION("of what it was put before it is the last that counts") {
    order.put(3, 2);
    CHECK(ranks(order) == Ranks{0, 1, 3, 2});
  }
  SECTION("another may be put before it in turn") {
    order.put(2, 3);
    CHECK(ranks(order) == Ranks{0, 2, 3, 1});
  }
  SECTION("until all is forgotten") {
    order.forget();
    CHECK(ranks(order) == Ranks{0, 1, 2, 3});
    CHECK(order.isShortestFirst());
  }
}

TEST_CASE("two that were put before each other end in one order, and none is lost") {
  PlacingOrder order;
  order.arrange(lines({0, 1}));
  order.put(1, 0);
  CHECK(ranks(order) == Ranks{1, 0});
  order.put(0, 1);
  CHECK(ranks(order) == Ranks{0, 1});
}

TEST_CASE("what was put before another stays so when lengths, and with them ranks, have changed") {
  PlacingOrder order;
  order.arrange(lines({7, 3, 5}));
  order.put(2, 0);   // 5 before 7
  order.arrange(lines({3, 7, 5}));
  CHECK(ranks(order) == Ranks{0, 2, 1});
  SECTION("and while the other is not there it has no effect") {
    order.arrange(lines({3, 5}));
    CHECK(ranks(order) == Ranks{0, 1});
    order.arrange(lines({3, 7, 5, 9}));
    CHECK(ranks(order) == Ranks{0, 2, 1, 3});
  }
}

TEST_CASE("a model without lines has an empty order") {
  PlacingOrder order;
  order.arrange({});
  CHECK(order.ranks().empty());
  CHECK(order.isShortestFirst());
  order.forget();
  CHECK(order.ranks().empty());
}
