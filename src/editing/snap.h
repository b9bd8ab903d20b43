#pragma once

#include <cstdint>

#include "model/parameter.h"

namespace dimline {

/// What a drag's values keep to: the parameter's steps, tenths of them, or nothing but what can be told apart on screen. A count is always whole.
enum class Snap : std::uint8_t { kStep, kFine, kNone };

/// The parameter as a drag with this snapping sees it.
inline Parameter snappedBy(Parameter parameter, Snap snap) {
  if (snap == Snap::kStep) return parameter;
  if (parameter.type == ParameterType::kFloat || parameter.type == ParameterType::kAngle) {
    parameter.step = snap == Snap::kFine ? parameter.step / 10 : 0;
  } else {
    parameter.step = 1;
  }
  return parameter;
}

}  // namespace dimline
