#pragma once

#include <string>

#include "gpu/gl.h"

namespace dimline {

/// What is known of the GL context that objects live in, and whether it still lives. It neither makes nor owns the context: natively
/// NativeContext does, in a page the host.
///
/// A WebGL context can be lost at any time. Then the host calls markLost(), destroys everything that was made in it (no GL call is
/// made for that any more), and makes everything anew in the next context. Must outlive the objects made with it; does not move.
class GlContext {
 public:
  /// Asks the current context for its properties.
  GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// From here on destructors leave GL alone.
  void markLost() { lost_ = true; }
  [[nodiscard]] bool lost() const { return lost_; }

  /// The driver's name for what draws, for people and logs; some browsers hide it.
  [[nodiscard]] const std::string& rendererName() const { return rendererName_; }
  /// Whether that name is of a rasterizer that runs on the CPU. False also when the name is hidden.
  [[nodiscard]] bool software() const { return software_; }
  [[nodiscard]] int maxTextureSize() const { return maxTextureSize_; }
  [[nodiscard]] int maxSamples() const { return maxSamples_; }

 private:
  bool lost_ = false;
  bool software_ = false;
  int maxTextureSize_ = 2048;
  int maxSamples_ = 1;
  std::string rendererName_;
};

}  // namespace dimline
