#include <catch2/catch.hpp>

#include "editing/undo_history.h"

using namespace dimline;

namespace {

Values valuesOf(double value) {
  const Parameter parameter{.name = "A", .defaultValue = value, .min = -1e9, .max = 1e9};
  return Values(std::span(&parameter, 1));
}

}  // namespace

TEST_CASE("a new history has nothing to undo or to redo") {
  UndoHistory history;
  REQUIRE_FALSE(history.canUndo());
  REQUIRE_FALSE(history.canRedo());
  REQUIRE_FALSE(history.undo(valuesOf(1)));
  REQUIRE_FALSE(history.redo(valuesOf(1)));
}

TEST_CASE("undo goes back step by step, redo forward again") {
  UndoHistory history;
  history.record(valuesOf(1));  // 1 -> 2
  history.record(valuesOf(2));  // 2 -> 3
  Values present = valuesOf(3);

  present = history.undo(present).value();
  REQUIRE(present == valuesOf(2));
  present = history.undo(present).value();
  REQUIRE(present == valuesOf(1));
  REQUIRE_FALSE(history.canUndo());

  present = history.redo(present).value();
  REQUIRE(present == valuesOf(2));
  present = history.redo(present).value();
  REQUIRE(present == valuesOf(3));
  REQUIRE_FALSE(history.canRedo());
}

TEST_CASE("a new gesture takes away what could be redone") {
  UndoHistory history;
  history.record(valuesOf(1));
  const Values present = history.undo(valuesOf(2)).value();
  history.record(present);  // 1 -> 5 instead
  REQUIRE_FALSE(history.canRedo());
  REQUIRE(history.undo(valuesOf(5)).value() == valuesOf(1));
}

TEST_CASE("a full history forgets its oldest step") {
  UndoHistory history(3);
  for (int i = 0; i < 5; ++i) history.record(valuesOf(i));  // 0 -> 1 -> 2 -> 3 -> 4 -> 5
  Values present = valuesOf(5);
  for (const int expected : {4, 3, 2}) {
    present = history.undo(present).value();
    REQUIRE(present == valuesOf(expected));
  }
  REQUIRE_FALSE(history.canUndo());
}

TEST_CASE("a cleared history has forgotten both ways") {
  UndoHistory history;
  history.record(valuesOf(1));
  history.record(valuesOf(2));
  (void)history.undo(valuesOf(3));
  history.clear();
  REQUIRE_FALSE(history.canUndo());
  REQUIRE_FALSE(history.canRedo());
}
