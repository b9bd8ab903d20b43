#include "gpu/gl_context.h"

#include <algorithm>
#include <string_view>

#include "gpu/platform.h"

namespace dimline {

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
}

}  // namespace dimline
