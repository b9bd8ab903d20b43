#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/given_values.h"
#include "cli/program.h"
#include "math/camera.h"

namespace dimline {

/// What `dimline layout` was asked for, as far as the command line alone tells. Nothing has been read yet.
struct LayoutOptions {
  std::string_view model;
  Assignments values;
  std::optional<std::string> camerasPath;
  std::optional<Camera> camera;  ///< valid; --eye and the others
  int widthPx = 1000;
  int heightPx = 1000;
  bool gpuFields = false;
  std::optional<std::string> masksFolder;
  std::optional<std::string> svgFolder;
  std::string outputPath;  ///< "-": standard output
};

/// The error's exit status is kBadArguments.
Result<LayoutOptions> parseLayoutOptions(std::span<const std::string_view> arguments);

/// px. Nothing larger can be asked for: 16,384 squared is what graphics hardware can draw at once.
inline constexpr int kMaxSidePx = 16384;

}  // namespace dimline
