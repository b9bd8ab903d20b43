#include <catch2/catch.hpp>

#include "placement/label_text.h"

using namespace dimline;

TEST_CASE("a label says the value with its unit") {
  const Parameter width{.name = "Width", .title = "Width", .unit = Unit::kMetre, .min = 0, .max = 10, .step = 0.01};
  CHECK(labelText(width, 2.4) == "2.40 m");
}

TEST_CASE("a count says what it counts, or else names its parameter") {
  Parameter floors{.name = "Floors", .title = "Number of floors", .type = ParameterType::kInt, .min = 1, .max = 9, .step = 1};
  CHECK(labelText(floors, 2) == "Number of floors 2");
  floors.noun = "floor";
  CHECK(labelText(floors, 2) == "2 floors");
  CHECK(labelText(floors, 1) == "1 floor");
  floors.noun = "shelf";
  floors.plural = "shelves";
  CHECK(labelText(floors, 2) == "2 shelves");
  CHECK(labelText(floors, 1) == "1 shelf");
}
