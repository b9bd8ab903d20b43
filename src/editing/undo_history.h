#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "model/parameter.h"

namespace dimline {

/// The values a document had, one snapshot a gesture. The present values belong to the caller: recording gives the
/// history what they were before a change, undo and redo exchange them for a neighbour's.
class UndoHistory {
public:
  /// At most `limit` steps back are kept (>= 1); the oldest is forgotten first. A snapshot is some hundred bytes.
  explicit UndoHistory(std::size_t limit = 256) : limit_(limit) {}

  void clear();

  /// One gesture led from `before` to other values: a step back that undo() will take. What had been undone can be
  /// redone no more.
  void record(Values before);

  [[nodiscard]] bool canUndo() const { return !past_.empty(); }
  [[nodiscard]] bool canRedo() const { return !future_.empty(); }

  /// The values one step back, or forward again; nothing at the end of the history, which then stays as it is.
  std::optional<Values> undo(const Values& present);
  std::optional<Values> redo(const Values& present);

private:
  std::size_t limit_;
  std::deque<Values> past_;     ///< oldest first
  std::vector<Values> future_;  ///< farthest first
};

}  // namespace dimline
