#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace dimline {

/// An option that a command takes.
struct OptionRule {
  enum class Kind { kFlag, kValue, kRepeatable };
  std::string_view name;  ///< "--size", or "-o"
  Kind kind = Kind::kValue;
  std::string_view valueName;  ///< "WxH", for messages
};

/// A command's arguments, sorted into options and the rest. `--size=3x4` and `--size 3x4` are the same.
class Arguments {
public:
  /// An error for an unknown option, one without its value, one given twice that may be there once. The views must outlive the result.
  static Result<Arguments> parse(std::span<const std::string_view> arguments, std::span<const OptionRule> rules);

  [[nodiscard]] std::span<const std::string_view> positional() const { return positional_; }
  [[nodiscard]] bool has(std::string_view option) const { return values_.contains(option); }
  /// The option's value, or nothing when it is not there.
  [[nodiscard]] std::optional<std::string_view> value(std::string_view option) const;
  /// All values of a repeatable option, in order.
  [[nodiscard]] std::span<const std::string_view> values(std::string_view option) const;

private:
  std::vector<std::string_view> positional_;
  std::map<std::string_view, std::vector<std::string_view>> values_;
};

}  // namespace dimline
