#pragma once

#include <cstddef>
#include <span>
#include <string_view>

/// The words by which JavaScript knows the editor's enumerations, in their order; web/core.js says what they mean.
namespace dimline {

inline constexpr std::string_view kPointerKinds[] = {"mouse", "touch", "pen"};
inline constexpr std::string_view kPointerTargets[] = {"", "handle", "camera"};
inline constexpr std::string_view kLimits[] = {"", "min", "max"};
inline constexpr std::string_view kSnaps[] = {"step", "fine", "none"};
inline constexpr std::string_view kStandardViews[] = {"three-quarter", "front", "back", "left", "right", "top"};
inline constexpr std::string_view kFieldsFrom[] = {"auto", "cpu", "gpu"};
inline constexpr std::string_view kEvents[] = {"input", "change", "camera-change", "load"};

template <typename Enum>
std::string_view wordFor(std::span<const std::string_view> words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

}  // namespace dimline
