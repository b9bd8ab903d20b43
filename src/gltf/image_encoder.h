#pragma once

#include <vector>

#include "model/scene.h"

namespace dimline {

/// An image as PNG. Empty when there is no memory for it.
std::vector<unsigned char> encodePng(const Image& image);

}  // namespace dimline
