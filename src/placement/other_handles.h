#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "model/model.h"
#include "placement/history.h"
#include "placement/landed.h"
#include "placement/layout.h"

namespace dimline {

/// What the other handles of one frame are placed against.
struct OtherHandleContext {
  const View& view;
  const DistanceFields& paddedModel;   ///< the model alone, with handleSpacing
  const DistanceFields& padded;        ///< model and landed things, with handleSpacing
  const Landed& landed;
  std::span<const Scope> scopes;
};

/// A parameter whose handle is no line, and the scopes in view that it may stand at.
struct OtherHandle {
  std::size_t parameter = 0;
  const Parameter& definition;
  const Annotation& annotation;
  std::span<const std::size_t> scopes;
  double value = 0;
  History& history;
  bool firm = false;         ///< no better kind of place is taken at once
  bool nearing = false;      ///< the camera comes nearer, so that places outside do not last
  bool showAll = false;      ///< one that is seen nearly edge-on is shown too
  bool viewMoved = false;    ///< since the last frame
  bool settles = false;      ///< a movement ends with this frame: a change costs little
};

/// The identity of a handle at a scope. `way`: by what number its kind counts the ways in which it may be moved out; -1 when it was not.
inline Identity identityOf(const OtherHandle& handle, const Scope& scope, int way) {
  return {.parameter = static_cast<std::int32_t>(handle.parameter),
          .scopeIndex = static_cast<std::int32_t>(scope.index),
          .baseLine = 0,
          .plane = static_cast<std::int16_t>(way),
          .direction = 0};
}

}  // namespace dimline
