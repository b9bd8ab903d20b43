#include "gpu/platform.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/html5_webgl.h>
#include <webgl/webgl2.h>
#else
#include <cstring>
#endif

namespace dimline {

namespace {

std::string textOf(GLenum name) {
  std::string result;
  const GLubyte* text = glGetString(name);
  for (; text != nullptr && *text != 0; ++text) result.push_back(static_cast<char>(*text));
  return result;
}

}  // namespace

#ifdef __EMSCRIPTEN__

void readBuffer(GLenum target, std::size_t offset, std::span<std::uint8_t> bytes) {
  // WebGL cannot map a buffer.
  glGetBufferSubData(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

std::string driverName() {
  constexpr GLenum kUnmaskedRenderer = 0x9246;
  if (emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), "WEBGL_debug_renderer_info")) {
    std::string name = textOf(kUnmaskedRenderer);
    if (!name.empty()) return name;
  }
  return textOf(GL_RENDERER);
}

#else

void readBuffer(GLenum target, std::size_t offset, std::span<std::uint8_t> bytes) {
  const void* const mapped =
      glMapBufferRange(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), GL_MAP_READ_BIT);
  if (mapped != nullptr) std::memcpy(bytes.data(), mapped, bytes.size());
  glUnmapBuffer(target);
}

std::string driverName() { return textOf(GL_RENDERER); }

#endif

}  // namespace dimline
