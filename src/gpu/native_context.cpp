#include "gpu/native_context.h"

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace dimline {

namespace {

template <typename Function>
Function extensionFunction(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// A display that needs no window system, or EGL_NO_DISPLAY.
EGLDisplay openDisplay() {
  const auto getPlatformDisplay = extensionFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (getPlatformDisplay == nullptr) return EGL_NO_DISPLAY;
  const char* const list = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string_view extensions = list != nullptr ? list : "";
  if (extensions.find("EGL_MESA_platform_surfaceless") != std::string_view::npos) {
    const EGLDisplay display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  }
  const auto queryDevices = extensionFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (queryDevices != nullptr && queryDevices(1, &device, &count) == EGL_TRUE && count > 0) {
    const EGLDisplay display = getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  }
  return EGL_NO_DISPLAY;
}

std::string eglErrorCode() {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%x", static_cast<unsigned>(eglGetError()));
  return text.data();
}

}  // namespace

Result<std::unique_ptr<NativeContext>> NativeContext::make() {
  std::unique_ptr<NativeContext> result(new NativeContext);
  result->display_ = openDisplay();
  if (result->display_ == EGL_NO_DISPLAY) {
    return Error{"There is no EGL display without a window system (error " + eglErrorCode() +
                 "): install a driver for EGL, on Debian libegl1 and libgl1-mesa-dri."};
  }
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 5> configWish{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (eglChooseConfig(result->display_, configWish.data(), &config, 1, &configs) != EGL_TRUE || configs == 0) {
    return Error{"The EGL driver offers no OpenGL ES 3 configuration (error " + eglErrorCode() + ")."};
  }
  const std::array<EGLint, 5> contextWish{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  result->context_ = eglCreateContext(result->display_, config, EGL_NO_CONTEXT, contextWish.data());
  if (result->context_ == EGL_NO_CONTEXT) {
    return Error{"The EGL driver gives no OpenGL ES 3 context (error " + eglErrorCode() + ")."};
  }
  if (eglMakeCurrent(result->display_, EGL_NO_SURFACE, EGL_NO_SURFACE, result->context_) != EGL_TRUE) {
    return Error{"The EGL driver cannot use a context without a surface (error " + eglErrorCode() + ")."};
  }
  return result;
}

NativeContext::~NativeContext() {
  if (display_ == nullptr) return;
  // The display is the process's: another context may still live on it.
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
}

void NativeContext::makeCurrent() const { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }

}  // namespace dimline
