#include "editing/undo_history.h"

#include <utility>

namespace dimline {

void UndoHistory::clear() {
  past_.clear();
  future_.clear();
}

void UndoHistory::record(Values before) {
  future_.clear();
  past_.push_back(std::move(before));
  if (past_.size() > limit_) past_.pop_front();
}

std::optional<Values> UndoHistory::undo(const Values& present) {
  if (past_.empty()) return std::nullopt;
  Values values = std::move(past_.back());
  past_.pop_back();
  future_.push_back(present);
  return values;
}

std::optional<Values> UndoHistory::redo(const Values& present) {
  if (future_.empty()) return std::nullopt;
  Values values = std::move(future_.back());
  future_.pop_back();
  past_.push_back(present);
  return values;
}

}  // namespace dimline
