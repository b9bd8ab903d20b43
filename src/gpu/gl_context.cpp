#include "gpu/gl_context.h"

#include <algorithm>
#include <string_view>

#include "gpu/platform.h"

namespace dimline {

namespace {

std::string textOf(const GLubyte* text) {
  std::string result;
  for (; text != nullptr && *text != 0; ++text) result.push_back(static_cast<char>(*text));
  return result;
}

}  // namespace

GlContext::GlContext() {
  rendererName_ = driverName();
  std::string lower = rendererName_;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const std::string_view name : {"llvmpipe", "softpipe", "swiftshader", "software", "basic render"}) {
    software_ = software_ || lower.find(name) != std::string::npos;
  }
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maxTextureSize_);
  glGetIntegerv(GL_MAX_SAMPLES, &maxSamples_);

  GLint extensions = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions; ++i) {
    const std::string name = textOf(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    rendersHalfFloat_ = rendersHalfFloat_ || name == "GL_EXT_color_buffer_float" || name == "GL_EXT_color_buffer_half_float";
  }
}

}  // namespace dimline
