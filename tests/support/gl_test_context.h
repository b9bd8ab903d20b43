#pragma once

#include <memory>

#include <catch2/catch.hpp>

#include "gpu/gl_context.h"
#include "gpu/native_context.h"

namespace dimline::test {

/// A GL context of its own for one test case. Without a driver the case fails.
struct GlTestContext {
  std::unique_ptr<NativeContext> native;
  std::unique_ptr<GlContext> gl;

  GlTestContext() {
    Result<std::unique_ptr<NativeContext>> made = NativeContext::make();
    if (!made) FAIL(made.error().message);
    native = std::move(made).value();
    gl = std::make_unique<GlContext>();
  }
};

}  // namespace dimline::test
