#include "cli/size_text.h"

#include <optional>
#include <string>

#include "core/text.h"

namespace dimline {

namespace {

std::optional<int> parseSide(std::string_view text, int mostPx) {
  if (text.empty() || text.size() > 5 || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  int side = 0;
  for (const char c : text) side = side * 10 + (c - '0');
  if (side < 1 || side > mostPx) return std::nullopt;
  return side;
}

}  // namespace

Result<PictureSize> parseSize(std::string_view text, int mostPx) {
  const std::size_t by = text.find_first_of("xX");
  const auto width = parseSide(text.substr(0, by), mostPx);
  const auto height = by == std::string_view::npos ? std::nullopt : parseSide(text.substr(by + 1), mostPx);
  if (width && height) return PictureSize{*width, *height};
  return Error{"--size takes width and height in pixels, each from 1 to " + std::to_string(mostPx) + ", such as 1000x800, not " + inQuotes(text) + "."};
}

}  // namespace dimline
