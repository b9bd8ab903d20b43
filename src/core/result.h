#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace dimline {

/// Why something could not be done: one sentence for a person, saying what is wrong, where, and how to mend it.
struct Error {
  std::string message;
};

/// Either a value or the Error that stands in its way. Used for bad data (a file, an annotation, a parameter's value);
/// a programmer's mistake is an assert instead, and nothing here throws.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value. Asserts that there is one.
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&content_));
  }
  const T* operator->() const { return &value(); }
  const T& operator*() const& { return value(); }

  /// The error. Asserts that there is one.
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *std::get_if<1>(&content_);
  }

 private:
  std::variant<T, Error> content_;
};

/// The result of something that gives nothing back.
using Status = Result<std::monostate>;
inline Status okStatus() { return std::monostate{}; }

}  // namespace dimline
