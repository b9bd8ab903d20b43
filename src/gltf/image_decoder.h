#pragma once

#include <cstddef>
#include <span>

#include "core/result.h"
#include "model/scene.h"

namespace dimline {

/// A PNG or JPEG, halved until neither side has more than `maxSidePx`. Errors are half sentences: "it is …".
Result<Image> decodeImage(std::span<const std::byte> bytes, std::uint32_t maxSidePx);

}  // namespace dimline
