#pragma once

#include <memory>

#include "core/result.h"

namespace dimline {

/// An OpenGL ES 3 context without a window or a display, for the command line and for tests: Mesa's surfaceless platform where there is
/// one, otherwise the first EGL device. There is no default framebuffer to draw to. In WebAssembly make() is an error.
class NativeContext {
 public:
  /// Makes a context and makes it current on this thread. The error says what is missing.
  static Result<std::unique_ptr<NativeContext>> make();
  NativeContext(const NativeContext&) = delete;
  NativeContext& operator=(const NativeContext&) = delete;
  ~NativeContext();

  void makeCurrent() const;

 private:
  NativeContext() = default;

  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace dimline
