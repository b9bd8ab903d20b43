#include "cli/arguments.h"

#include <algorithm>

#include "core/text.h"

namespace dimline {

namespace {

bool looksLikeOption(std::string_view argument) {
  // "-1,2,3" is a value, and a lone "-" names standard output.
  if (argument.size() < 2 || argument[0] != '-') return false;
  const char second = argument[1];
  return second == '-' || (second >= 'a' && second <= 'z') || (second >= 'A' && second <= 'Z');
}

std::string listOf(std::span<const OptionRule> rules) {
  std::vector<std::string_view> names;
  for (const OptionRule& rule : rules) names.push_back(rule.name);
  return joined(names);
}

}  // namespace

Result<Arguments> Arguments::parse(std::span<const std::string_view> arguments, std::span<const OptionRule> rules) {
  Arguments parsed;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if (!looksLikeOption(argument)) {
      parsed.positional_.push_back(argument);
      continue;
    }
    const std::size_t equals = argument.starts_with("--") ? argument.find('=') : std::string_view::npos;
    const std::string_view name = argument.substr(0, equals);
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const OptionRule& r) { return r.name == name; });
    if (rule == rules.end()) {
      return Error{"There is no option " + inQuotes(name) + "; this command has " + listOf(rules) + "."};
    }

    std::vector<std::string_view>& values = parsed.values_[rule->name];
    if (!values.empty() && rule->kind != OptionRule::Kind::kRepeatable) {
      return Error{std::string(name) + " is given twice."};
    }
    if (rule->kind == OptionRule::Kind::kFlag) {
      if (equals != std::string_view::npos) return Error{std::string(name) + " takes no value."};
      values.emplace_back();
    } else if (equals != std::string_view::npos) {
      values.push_back(argument.substr(equals + 1));
    } else if (i + 1 < arguments.size() && !looksLikeOption(arguments[i + 1])) {
      values.push_back(arguments[++i]);
    } else {
      return Error{std::string(name) + " needs a value: " + std::string(name) + " " + std::string(rule->valueName) +
                   "."};
    }
  }
  return parsed;
}

std::optional<std::string_view> Arguments::value(std::string_view option) const {
  const auto found = values_.find(option);
  if (found == values_.end()) return std::nullopt;
  return found->second.front();
}

std::span<const std::string_view> Arguments::values(std::string_view option) const {
  const auto found = values_.find(option);
  if (found == values_.end()) return {};
  return found->second;
}

}  // namespace dimline
