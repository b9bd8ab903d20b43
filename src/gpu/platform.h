#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "gpu/gl.h"

// The few things that WebGL 2 and native OpenGL ES 3 do differently. Emscripten's headers are included by platform.cpp, and nowhere else in
// this folder.

namespace dimline {

/// Copies bytes out of the buffer that is bound to `target`, waiting for the GPU where it must.
void readBuffer(GLenum target, std::size_t offset, std::span<std::uint8_t> bytes);

/// The driver's name for what draws in the current context. Browsers tell it only when asked in a way of their own, and some never.
std::string driverName();

}  // namespace dimline
