#pragma once

#include <string_view>

#include "core/result.h"

namespace dimline {

struct PictureSize {
  int widthPx = 0;
  int heightPx = 0;
};

/// The value of --size, "1000x800": whole numbers of pixels from 1 to `mostPx`. The error's exit status is kBadArguments.
Result<PictureSize> parseSize(std::string_view text, int mostPx);

}  // namespace dimline
