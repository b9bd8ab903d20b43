#pragma once

#include <string>

#include "model/parameter.h"

namespace dimline {

/// What a dimension line's label says: the value with its unit. A bare number beside a building would be read as metres, so a count says what it counts
/// ("2 floors"), or else names its parameter ("Twist 2").
std::string labelText(const Parameter& parameter, double value);

}  // namespace dimline
